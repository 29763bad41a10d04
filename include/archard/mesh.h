/* archard/mesh.h - finite element meshes of the two bodies.
 *
 * Frame (both bodies, plate at x = 0, just touching, no load): the origin is the first point of
 * contact, x along the plate's surface, y up. The cylinder (a half cylinder, flat top built in)
 * lies above, the plate below. Every mesh is an exact mirror image about x = 0.
 */
#ifndef ARCHARD_MESH_H
#define ARCHARD_MESH_H

#include "archard/body.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Formulation: CPE4 fully integrated bilinear; CPE4I with incompatible modes (bends freely, does
 * not lock where nu nears 1/2), triangles of one cell then share one dilatation; auto chooses for
 * each body by its nu, see arc_element_for. */
#define ARC_ELEMENT_LIST(X)                                                                        \
  X(ELEMENT_AUTO, "auto")                                                                          \
  X(CPE4, "CPE4")                                                                                  \
  X(CPE4I, "CPE4I")
typedef enum arc_element { ARC_ELEMENT_LIST(ARC_CHOICE_ENUM) } arc_element;
extern const char *const arc_element_names[];

/* What the section in x and y stands for. Of bodies of revolution about the vertical axis at x =
 * -axis; forces are those on all of the circumference. Where the axis is x = 0, both halves of the
 * section are the same ring, and each counts for half of it. Springs: no section, see
 * core/springs. */
#define ARC_SPACE_LIST(X)                                                                          \
  X(PLANE_STRAIN, "plane strain")                                                                  \
  X(PLANE_STRESS, "plane stress")                                                                  \
  X(AXISYMMETRIC, "axisymmetric")                                                                  \
  X(SPRINGS, "springs")                                                                            \
  X(SPATIAL, "3-D")
typedef enum arc_space { ARC_SPACE_LIST(ARC_CHOICE_ENUM) } arc_space;
extern const char *const arc_space_names[];

/* What to mesh. The plate is 2 radius wide and radius high. "auto" is 0 in the struct, and becomes
 * a number in arc_model_fit: a mesh is built of numbers alone. */
#define ARC_MESH_SETTINGS(NUMBER, WHOLE, CHOICE)                                                   \
  NUMBER(                                                                                          \
      size, "mm", 0, ABOVE(0), ARC_AUTOMATIC,                                                      \
      "Width of the elements at the contact. \"auto\": the unworn contact's half width over "      \
      "5.4 and fineness, as in the paper, whose case gets 0.020 mm; under the load of the "        \
      "contact or wear run that builds the model, of model{} alone under 100 N; layers count. Of " \
      "balls half of that; where rounded edges or kinks touch, the width over which the pressure " \
      "rises there takes the half width's place, as far as 320 elements go; at the most an "       \
      "eighth of the waves of a rough profile, but for waves that ripple the pressure by less "    \
      "than a thousandth; of wear runs in partial slip at the most a fifth of the rim that "       \
      "slips at either edge of the contact, as far as 320 elements go.")                           \
  NUMBER(fineness, "", 0, ABOVE(0), ARC_OPTIONAL,                                                  \
         "Divides the size that \"auto\" finds: 2 halves it. Left out: 1. A size that is given "   \
         "has none.")                                                                              \
  NUMBER(height, "mm", 0, ABOVE(0), ARC_AUTOMATIC,                                                 \
         "Height of the elements at the contact. \"auto\": 1.25 size, and less where soft layers " \
         "with nu above 0.4 need it for two rows.")                                                \
  NUMBER(far, "mm", 0, ABOVE(0), ARC_AUTOMATIC,                                                    \
         "Largest size of the elements far from the contact. \"auto\": a tenth of the radius.")    \
  WHOLE(rows, "", 3, WITHIN(1, 100), 0,                                                            \
        "Element rows of the wear box: its nodes move with the worn surface.")                     \
  CHOICE(                                                                                          \
      element, element, ARC_ELEMENT_AUTO, 0,                                                       \
      "Formulation: fully integrated bilinear (CPE4), or with incompatible modes (CPE4I), which "  \
      "bend freely and do not lock where nu nears 1/2. \"auto\": CPE4 for bodies with nu up to "   \
      "0.4, CPE4I for others.")

typedef struct arc_mesh_def {
  ARC_MESH_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE, ARC_MEMBER_CHOICE)
  double
      zone[ARC_BODIES]; /* [mm] full width of the fine candidate contact zone;
                           the cylinder's is the measure of the contact: depths and margins of the
                           two nested partitions scale with it, the plate's adds the stroke */
} arc_mesh_def;

extern const arc_setting arc_mesh_settings[];

/* The mesh of the paper's case, in numbers: 0.020 x 0.025 mm, far 1 mm, zones 1.0 and 1.2 mm. */
arc_mesh_def arc_mesh_default(void);

/* A mesh; read-only for its users, owned by arc_mesh_build's caller. Indices are 0-based.
 * Elements and their corners run counter-clockwise. */
typedef struct arc_mesh {
  arc_body body;
  arc_body_def solid; /* in numbers; its profile belongs to the model */
  double radius;      /* [mm] of the cylinder; of other bodies the dimension that limits the mesh */
  arc_mesh_def def;   /* as asked for; in a model, element is what the body has, never auto */
  arc_space space;    /* of the model; plane strain of a mesh alone */
  double axis;        /* [mm] of revolution, at x = -axis */
  int nodes;          /* number of nodes */
  double *xy;         /* [2 * nodes] x, y of each node [mm] */
  int elements;       /* number of elements = quads + triangles */
  int *element; /* [4 * elements] corners; a triangle has -1 as its fourth. Triangles that close
                   one cell start with the same corner, and stand two apart: between them are
                   their mirror images */
  int quads, triangles;
  int surface;       /* number of candidate contact nodes; odd, the middle one is at x = 0 */
  int *surface_node; /* [surface] by increasing x */
  int *layer;        /* [elements] layer of each, `layers of the body` for its own material */
  int rows;          /* rows of the wear box */
  int *box_node; /* [surface * (rows + 1)] nodes of the wear box, column by column in the order of
                    surface_node, each from the surface inwards */
  int box_elements;  /* the first box_elements elements are the wear box, column by column */
  int fixed;         /* number of nodes tied to the rigid base or built in */
  int *fixed_node;   /* [fixed] */
  int outline;       /* number of nodes of the boundary polygon */
  int *outline_node; /* [outline] counter-clockwise, not closed */
  int materials;     /* of a mesh from outside: its named materials */
  char (*material_name)[ARC_TEXT_SIZE]; /* [materials] */
  int *material; /* [elements] material of each, -1 for the body's own; NULL: that of all */
} arc_mesh;

/* Corners of an element: 3 or 4. */
int arc_mesh_corners(const arc_mesh *mesh, int element);

/* Meshes one body of the paper's pair. Errors: ARC_ARGUMENT (a size not positive, larger than the
 * body, fewer than 1 row), ARC_ZONE (zone too wide for the body or too narrow to hold contact),
 * ARC_GEOMETRY (an element came out inverted), ARC_MEMORY. On failure *mesh is NULL. */
arc_status arc_mesh_build(const arc_mesh_def *def, arc_body body, double radius, arc_mesh **mesh,
                          arc_error *error);
/* The same of any body in numbers (arc_body_resolve), whose profile outlives the mesh. */
arc_status arc_mesh_build_solid(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                                arc_mesh **mesh, arc_error *error);

/* Most named materials of one body in a mesh from outside: they are the layers of its body. */
enum { ARC_MESH_MATERIALS = ARC_MOST_LAYERS };

/* Reads both bodies, as they touch without load, from a Gmsh file: text, version 4.1 or 2.2, units
 * mm, in the plane z = 0, triangles and quadrilaterals of first order. Physical groups tell what is
 * what: surfaces "upper", and "upper.NAME" what is of another material; curves "upper.contact"
 * (from one end to the other x increases), "upper.fixed" (built in); and the same of "lower". The
 * rest of the file is ignored. Such a mesh has no wear box: rows and box_elements are 0, and it
 * serves frozen geometry alone. `radius` is that of the parabola which fits the unworn gap best
 * over its candidate contact zone, 1e6 mm where that is flat. def has the sizes found, and in zone
 * the widths of the contact curves.
 * Errors: ARC_IO; ARC_FORMAT (not such a file: line, what was expected, what came); ARC_GEOMETRY
 * (groups, nodes or elements that make no two bodies: which, and where), ARC_MEMORY. On failure
 * both meshes are NULL. */
arc_status arc_mesh_read_msh(const char *path, arc_mesh *mesh[ARC_BODIES], arc_error *error);
/* The same of a text of `length` bytes, which messages call by `name` in place of a path. */
arc_status arc_mesh_parse_msh(const char *name, const char *text, size_t length,
                              arc_mesh *mesh[ARC_BODIES], arc_error *error);

/* What its elements of 3 or 4 corners are called, "CPE4", "CPS4I", "CAX3". */
const char *arc_mesh_element(const arc_mesh *mesh, int corners);

/* Frees and nulls; NULL is fine. */
void arc_mesh_destroy(arc_mesh **mesh);

/* Shape quality over all elements. */
typedef struct arc_quality {
  double smallest_angle; /* [degree] */
  double largest_angle;  /* [degree] */
  double aspect;         /* longest edge / shortest edge of the worst element */
  double jacobian_ratio; /* smallest over largest corner Jacobian of the worst quad, 1 =
                            parallelogram */
  double
      smallest_jacobian; /* [mm2] smallest corner Jacobian (twice a corner triangle's area); > 0 */
} arc_quality;

/* Quality with the nodes at `xy` ([2 * nodes], NULL: the mesh's own). */
arc_quality arc_mesh_quality(const arc_mesh *mesh, const double *xy);
/* That of the wear box alone, whose elements wear deforms. */
arc_quality arc_mesh_box_quality(const arc_mesh *mesh, const double *xy);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

/* archard/mesh.h - finite element meshes of the two bodies.
 *
 * Coordinates refer to bodies that just touch without load, with the plate at x = 0. The origin is
 * the first point of contact. x is along the plate's surface, and y points upwards. The cylinder
 * (a half cylinder with a fixed flat top) lies above the plate. Generated meshes of symmetric
 * bodies are exactly symmetric about x = 0. */
#ifndef ARCHARD_MESH_H
#define ARCHARD_MESH_H

#include "archard/body.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Formulation of the elements. CPE4: fully integrated bilinear elements. CPE4I: bilinear elements
 * with incompatible modes, which do not lock in bending or for nu near 1/2; triangles of one cell
 * then have one common dilatation. Auto: CPE4 or CPE4I, chosen from Poisson's ratio nu of each body
 * (arc_element_for). */
#define ARC_ELEMENT_LIST(X)                                                                        \
  X(ELEMENT_AUTO, "auto")                                                                          \
  X(CPE4, "CPE4")                                                                                  \
  X(CPE4I, "CPE4I")
typedef enum arc_element { ARC_ELEMENT_LIST(ARC_CHOICE_ENUM) } arc_element;
extern const char *const arc_element_names[];

/* Geometry of a model, whose meshes are sections of the bodies in x and y. Axisymmetric: bodies of
 * revolution about the vertical axis at x = -axis, with forces on the whole circumference. If the
 * axis is at x = 0, the section shows both sides of each ring, and each side represents half the
 * circumference. Springs: layers of springs without meshes, see core/springs. 3-D: see
 * archard/space.h. */
#define ARC_SPACE_LIST(X)                                                                          \
  X(PLANE_STRAIN, "plane strain")                                                                  \
  X(PLANE_STRESS, "plane stress")                                                                  \
  X(AXISYMMETRIC, "axisymmetric")                                                                  \
  X(SPRINGS, "springs")                                                                            \
  X(SPATIAL, "3-D")
typedef enum arc_space { ARC_SPACE_LIST(ARC_CHOICE_ENUM) } arc_space;
extern const char *const arc_space_names[];

/* Settings of a mesh. "auto" is stored as 0, which arc_model_fit replaces by a number. */
#define ARC_MESH_SETTINGS(NUMBER, WHOLE, CHOICE)                                                   \
  NUMBER(                                                                                          \
      size, "mm", 0, ABOVE(0), ARC_AUTOMATIC,                                                      \
      "Element size at the contact: model = { mesh = { size = 0.01 } } makes elements 10 um wide " \
      "at the contact and larger ones outside. \"auto\": the half width of the unworn contact "    \
      "divided by 5.4 times the fineness, which is 0.020 mm in the paper's case. The half width "  \
      "includes the effect of layers and is computed for the load of the contact or wear run "     \
      "that builds the model (100 N for model{} alone). For balls the size is half as large. At "  \
      "rounded edges and kinks, the width over which the pressure rises replaces the half width. " \
      "For rough profiles the size is at most an eighth of the wavelength, but waves that change " \
      "the pressure by less than a thousandth are ignored. In wear runs with partial slip it is "  \
      "at most a fifth of the slip zone at either edge. A contact has at most 320 elements. A "    \
      "contact{} with friction in 3-D has 40 cells in the half width.")                            \
  NUMBER(fineness, "", 0, ABOVE(0), ARC_OPTIONAL,                                                  \
         "Factor by which the automatic size is divided; 2 halves the elements. Default: 1. Do "   \
         "not give it together with size.")                                                        \
  NUMBER(height, "mm", 0, ABOVE(0), ARC_AUTOMATIC,                                                 \
         "Height of the elements at the contact. \"auto\": 1.25 times the size, or less if soft "  \
         "layers with nu above 0.4 need two rows of elements.")                                    \
  NUMBER(far, "mm", 0, ABOVE(0), ARC_AUTOMATIC,                                                    \
         "Largest size of the elements far from the contact. \"auto\": a tenth of the radius.")    \
  WHOLE(rows, "", 3, WITHIN(1, 100), 0,                                                            \
        "Number of element rows in the wear box, the regular elements below the surface whose "    \
        "nodes move as it wears.")                                                                 \
  CHOICE(                                                                                          \
      element, element, ARC_ELEMENT_AUTO, 0,                                                       \
      "Formulation: fully integrated bilinear (CPE4), or with incompatible modes (CPE4I), which "  \
      "do not lock in bending or for nu near 1/2. \"auto\": CPE4 for bodies with nu up to "        \
      "0.4, CPE4I for bodies with larger nu.")

typedef struct arc_mesh_def {
  ARC_MESH_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE, ARC_MEMBER_CHOICE)
  double zone[ARC_BODIES]; /* [mm] full width of the candidate contact zone, where elements are
                              finest. The depth of the fine mesh is proportional to the cylinder's
                              zone. The plate's zone is wider than the cylinder's by the stroke */
} arc_mesh_def;

extern const arc_setting arc_mesh_settings[];

/* Returns the mesh for the case of the reference paper: elements of 0.020 x 0.025 mm at the contact
 * and up to 1 mm elsewhere, and zones of 1.0 and 1.2 mm. */
arc_mesh_def arc_mesh_default(void);

/* A mesh, which does not change and is owned by the caller of arc_mesh_build. Indices begin at 0.
 * Corners of elements are in counter-clockwise order. */
typedef struct arc_mesh {
  arc_body body;
  arc_body_def solid; /* shape of the body with all dimensions set; the model owns its profile */
  double
      radius; /* [mm] radius of a cylinder; for other bodies the dimension that limits the mesh */
  arc_mesh_def def; /* settings of the mesh; in a model, def.element is the formulation for this
                       body, never auto */
  arc_space space;  /* geometry of the model; plane strain for a mesh without a model */
  double axis;      /* [mm] distance of the axis of revolution, which is at x = -axis */
  int nodes;        /* number of nodes */
  double *xy;       /* [2 * nodes] coordinates x, y of each node [mm] */
  int elements;     /* number of elements = quads + triangles */
  int *element; /* [4 * elements] corner nodes of each element; the fourth of a triangle is -1. The
                   two triangles of a cell begin with the same corner; each is followed by its
                   mirror image */
  int quads, triangles;
  int surface; /* number of candidate contact nodes; it is odd, and the middle node is at x = 0 */
  int *surface_node; /* [surface] numbers of the candidate contact nodes by increasing x */
  int *layer;    /* [elements] index of the layer of each element; an index equal to the number of
                    layers means the body's own material */
  int rows;      /* number of element rows in the wear box */
  int *box_node; /* [surface * (rows + 1)] nodes of the wear box, column by column in the order of
                    surface_node; each column begins at the surface */
  int box_elements;  /* number of elements in the wear box, which are the first ones in the list,
                        column by column */
  int fixed;         /* number of nodes that are tied to the rigid base or fixed */
  int *fixed_node;   /* [fixed] numbers of the nodes that are tied to the rigid base or fixed */
  int outline;       /* number of nodes of the boundary polygon */
  int *outline_node; /* [outline] numbers of the boundary nodes, counter-clockwise; the first one is
                        not repeated */
  int materials;     /* number of named materials of an imported mesh */
  char (*material_name)[ARC_TEXT_SIZE]; /* [materials] names of the materials of an imported mesh */
  int *material; /* [elements] index of the material of each element, -1: the body's own material.
                    NULL: all elements have the body's own material */
} arc_mesh;

/* Returns the number of corners of an element, 3 or 4. */
int arc_mesh_corners(const arc_mesh *mesh, int element);

/* Builds the mesh of the cylinder or the plate. Errors: ARC_ARGUMENT (a size is not positive or is
 * larger than the body, or there are no rows), ARC_ZONE (the zone is too wide for the body or too
 * narrow for the contact), ARC_GEOMETRY (an inverted element), ARC_MEMORY. On failure *mesh is
 * NULL. */
arc_status arc_mesh_build(const arc_mesh_def *def, arc_body body, double radius, arc_mesh **mesh,
                          arc_error *error);
/* Builds the mesh of any resolved body (arc_body_resolve), whose profile must outlive the mesh.
 * Errors as for arc_mesh_build. */
arc_status arc_mesh_build_solid(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                                arc_mesh **mesh, arc_error *error);

/* Largest number of named materials of one body in an imported mesh. Each material counts as a
 * layer. */
enum { ARC_MESH_MATERIALS = ARC_MOST_LAYERS };

/* Reads both bodies, as they touch without load, from a Gmsh file. The file must be text of version
 * 4.1 or 2.2 in mm, with triangles and quadrilaterals of first order in the plane z = 0. Physical
 * groups of the upper body are the surfaces "upper", and "upper.NAME" for its part of material
 * NAME, and the curves "upper.contact" (x increases from one end to the other) and "upper.fixed";
 * the lower body has the same groups. The rest of the file is ignored. An imported mesh has no wear
 * box: rows and box_elements are 0, and only frozen geometry is possible. `radius` is the radius of
 * the parabola that best fits the unworn gap over the candidate contact zone, 1e6 mm if the gap is
 * flat. The member def of a mesh gets its element sizes and the widths of the contact curves as
 * zones. Errors: ARC_IO; ARC_FORMAT (the message has the line, the expected and the actual text);
 * ARC_GEOMETRY (groups, nodes or elements do not form two bodies); ARC_MEMORY. On failure both
 * meshes are NULL. */
arc_status arc_mesh_read_msh(const char *path, arc_mesh *mesh[ARC_BODIES], arc_error *error);
/* Reads both bodies from a text of `length` bytes instead of a file; `name` replaces the path in
 * messages. */
arc_status arc_mesh_parse_msh(const char *name, const char *text, size_t length,
                              arc_mesh *mesh[ARC_BODIES], arc_error *error);

/* Returns the name of the element type with 3 or 4 corners in a mesh, such as "CPE4", "CPS4I" or
 * "CAX3". */
const char *arc_mesh_element(const arc_mesh *mesh, int corners);

/* Frees the mesh and sets the pointer to NULL; NULL is allowed. */
void arc_mesh_destroy(arc_mesh **mesh);

/* Quality of the worst elements of a mesh. */
typedef struct arc_quality {
  double smallest_angle; /* [degree] smallest corner angle of all elements */
  double largest_angle;  /* [degree] largest corner angle of all elements */
  double aspect;         /* [-] longest edge / shortest edge of the worst element */
  double jacobian_ratio; /* smallest divided by largest corner Jacobian of the worst quadrilateral;
                            1 for a parallelogram */
  double
      smallest_jacobian; /* [mm2] smallest corner Jacobian (twice a corner triangle's area); > 0 */
} arc_quality;

/* Computes the quality of all elements with the nodes at `xy` [2 * nodes] (NULL: the nodes of the
 * mesh). */
arc_quality arc_mesh_quality(const arc_mesh *mesh, const double *xy);
/* Computes the quality of only the elements of the wear box, which wear deforms. */
arc_quality arc_mesh_box_quality(const arc_mesh *mesh, const double *xy);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

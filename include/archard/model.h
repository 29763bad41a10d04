/* archard/model.h - models: two elastic bodies, condensed to their wear boxes (the regular elements
 * below the contact surface). Several runs can share a model.
 *
 * For each body the stiffness is assembled from elements, and all unknowns outside the wear box are
 * eliminated with CHOLMOD. The result is the stiffness S_far, to which a worn shape only adds the
 * stiffness K_box of its wear box: S = S_far + K_box. The compliance F of the surface is the block
 * of S^-1 for the normal displacements of its nodes. */
#ifndef ARCHARD_MODEL_H
#define ARCHARD_MODEL_H

#include "archard/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#define ARC_MODEL_SETTINGS(NUMBER, CHOICE)                                                         \
  NUMBER(radius, "mm", 10, ABOVE(0), 0,                                                            \
         "Radius R of the cylinder; the plate is 2 R wide and R high.")                            \
  NUMBER(thickness, "mm", 1, ABOVE(0), 0,                                                          \
         "Thickness of both bodies; forces act on the whole thickness.")                           \
  CHOICE(geometry, space, ARC_PLANE_STRAIN, 0,                                                     \
         "\"plane strain\": long bodies; \"plane stress\": thin plates; \"axisymmetric\": bodies " \
         "of revolution about a vertical axis; a cylinder is then a ball and a block a disc, "     \
         "with loads and volumes of the whole circumference; \"springs\": a ball on a flat, each " \
         "with a layer of springs (Winkler) as deep as the field thickness, only for wear{}, for " \
         "teaching and tests; \"3-D\": half-spaces that touch in a small area and slide along x, " \
         "with wear depths as maps over x and z.")                                                 \
  NUMBER(axis, "mm", 0, FROM(0), 0,                                                                \
         "For geometry \"axisymmetric\": distance of x = 0 from the axis of revolution, which is " \
         "on the left. For a thrust ring it is the mean radius. 0: the bodies touch on the axis.") \
  CHOICE(periodic, switch, ARC_OFF, 0,                                                             \
         "true: each map of geometry \"3-D\" is one period of a periodic rough surface. The load " \
         "acts on one period, and the cells are the points of the map. In runs the lower body is " \
         "a body.block{}, which wears evenly along the motion.")

typedef struct arc_model_def {
  ARC_MODEL_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_CHOICE)
  arc_material material[ARC_BODIES]; /* materials of both bodies, indexed by arc_body (settings
                                        "cylinder" and "plate") */
  arc_body_def body[ARC_BODIES]; /* shapes of both bodies, indexed by arc_body (settings "upper" and
                                    "lower") */
  arc_mesh_def mesh;
} arc_model_def;

extern const arc_setting arc_model_settings[];

/* Returns the model of the reference paper, with the mesh of arc_mesh_default. */
arc_model_def arc_model_default(void);

/* Returns one body with all dimensions set (arc_body_resolve). */
arc_body_def arc_model_solid(const arc_model_def *def, arc_body body);

/* Returns the name of a body for users. It is the name in the definition, else the kind of the body
 * if the two kinds differ, else "upper" or "lower". The names of the default pair are "cylinder"
 * and "plate". */
const char *arc_model_body_name(const arc_model_def *def, arc_body body);
/* Returns the name of a body's role, "upper" or "lower". */
const char *arc_model_role_name(arc_body body);
/* Searches for the body whose name, role or kind is `word`. "cylinder" also means the upper and
 * "plate" the lower body. Returns 1 if the word matches one body, 0 if it matches none, and -1 if
 * it matches both. *body is always written. */
int arc_model_find_body(const arc_model_def *def, const char *word, arc_body *body);

/* Returns the contact modulus of a pair [MPa], which is 1 / (1/E*_c + 1/E*_p) with the plane-strain
 * moduli E* of cylinder and plate (arc_material_E_star). In plane stress Young's moduli replace
 * E*. */
double arc_contact_modulus(arc_space space, const arc_material material[ARC_BODIES]);

/* Returns the line load [N/mm] that causes about the same pressure as a load [N]. It is the load
 * divided by the thickness, by the circumference, or by the mean chord of a round contact. */
double arc_model_line(const arc_model_def *def, double load);

/* Returns the reference wear coefficient of a body [mm2/N], which is the largest coefficient of the
 * body and its layers, or 0 if there is none. Materials with a smaller coefficient wear in
 * proportion to it. */
double arc_model_wear_k(const arc_model_def *def, arc_body body);

/* Returns the relative radius of the surfaces [mm], 1 / (1/R_upper + 1/R_lower), with negative
 * radii for hollow surfaces. Returns INFINITY if the surfaces conform, are flat, or are not
 * arcs. */
double arc_model_relative_radius(const arc_model_def *def);

/* Returns true if Hertz' formulas apply: a solid cylinder or disc, or a ball, on a block, without
 * layers. */
int arc_model_is_hertzian(const arc_model_def *def);

/* Returns true if one body is hollow and the other one rotates inside it. */
int arc_model_is_hole(const arc_model_def *def);
/* Returns the sliding distance [mm] along the surfaces for a rotation by `degrees`; 0 without a
 * hole. */
double arc_model_arc_length(const arc_model_def *def, double degrees);
/* Returns true if the lower body slides along its own unworn surface. This is true for a block and
 * for a body that rotates in or around a hole. */
int arc_model_slides_along(const arc_model_def *def);

/* Returns the width [mm] of the lower body along its surface. A stroke of this length wears the
 * whole surface by the same depth. */
double arc_model_width(const arc_model_def *def);

/* Returns the half width [mm] of the unworn contact under a load [N]. It is computed by Hertz'
 * formula, by Persson's formula for a pin in a hole, and by an integral over the gap for other
 * shapes, such as punches. For bodies of revolution it is the radius of a round contact, or half
 * the width of a contact on a ring. */
double arc_model_half_width(const arc_model_def *def, double load);

/* Closed-form Hertz contact of a cylinder on a half-space, or of a ball, with the load L, the
 * radius R and the thickness t. */
typedef struct arc_hertz {
  double
      half_width; /* [mm] half width a = sqrt(4 L R / (pi t E*)); for a ball cbrt(3 L R / (4 E*)) */
  double p_max;   /* [MPa] largest pressure p_H = 2 L / (pi a t); for a ball 3 L / (2 pi a^2) */
  double E_star;  /* [MPa] contact modulus, see arc_contact_modulus */
  double approach; /* [mm] approach of a ball, a^2 / R; NaN for a cylinder, where it is unbounded */
  double half_width_z; /* [mm] half width across the motion, which differs from a if radius and
                          radius_z of a ball differ; NaN for a cylinder */
} arc_hertz;

#define ARC_HERTZ_SETTINGS(NUMBER, CHOICE)                                                         \
  NUMBER(radius, "mm", 10, ABOVE(0), 0, "Radius of the cylinder.")                                 \
  NUMBER(radius_z, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                \
         "Radius across the motion, with geometry \"3-D\". Default: radius (a ball).")             \
  NUMBER(load, "N", 100, ABOVE(0), 0, "Normal load L_N over the whole thickness.")                 \
  NUMBER(thickness, "mm", 1, ABOVE(0), 0, "Thickness of both bodies; unused for a ball.")          \
  CHOICE(geometry, space, ARC_PLANE_STRAIN, 0,                                                     \
         "\"plane strain\": a long cylinder; \"plane stress\": a thin one; \"axisymmetric\": a "   \
         "ball; "                                                                                  \
         "\"3-D\": a body with two radii, such as a crowned roller.")

typedef struct arc_hertz_def {
  ARC_HERTZ_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_CHOICE)
  arc_material material[ARC_BODIES]; /* materials of both bodies, indexed by arc_body (settings
                                        "cylinder" and "plate") */
} arc_hertz_def;

extern const arc_setting arc_hertz_settings[];

arc_hertz_def arc_hertz_default(void);

/* Solves the Hertz contact of a definition. ARC_ARGUMENT: a value is out of its range. */
arc_status arc_hertz_of(const arc_hertz_def *def, arc_hertz *hertz, arc_error *error);

/* Solves Hertz' line contact in plane strain. Errors: ARC_ARGUMENT unless load [N], radius and
 * thickness [mm] > 0. */
arc_status arc_hertz_solve(double radius, double thickness, double load,
                           const arc_material material[ARC_BODIES], arc_hertz *hertz,
                           arc_error *error);

/* Computes Hertz' contact of the bodies of a model, from their relative radius. The contact of a
 * ring is computed as a straight line contact of the same length. */
arc_hertz arc_model_hertz(const arc_model_def *def, double load);

/* A model. Opaque, reference counted, constant after arc_model_build. Two threads must not use the
 * same model at once, because stress fields share the workspace of the factorisation. */
typedef struct arc_model arc_model;

/* Builds a model: meshes, assembles, factorises and condenses both bodies. "auto" values are set as
 * by arc_model_fit_alone. Errors: those of arc_mesh_build, ARC_ARGUMENT, ARC_NUMERIC (a stiffness
 * is not positive definite), ARC_MEMORY. On failure *model is NULL. */
arc_status arc_model_build(const arc_model_def *def, arc_model **model, arc_error *error);
/* Checks a definition before arc_model_build. Errors: ARC_ARGUMENT (the message has the field, the
 * expected and the actual value), ARC_GEOMETRY. */
arc_status arc_model_check(const arc_model_def *def, arc_error *error);

/* Warns of Young's moduli that are probably in another unit: below 500 MPa (GPa meant) and above
 * that of diamond (Pa meant). */
void arc_model_warn_moduli(const arc_model_def *def, const arc_callbacks *callbacks);

/* Builds a model like arc_model_build, with callbacks that report its progress and can stop it
 * (ARC_STOPPED). */
arc_status arc_model_build_with_callbacks(const arc_model_def *def, const arc_callbacks *callbacks,
                                          arc_model **model, arc_error *error);

/* Builds a model like arc_model_build from the two existing meshes `given`, such as those of
 * arc_mesh_read_msh. The function becomes the owner of the meshes, also on failure, and sets the
 * pointers to NULL. def->radius is the radius for Hertz' formulas and determines the width of the
 * plate. Of def->mesh only the member `element` is used. ARC_ARGUMENT: def->body has a shape other
 * than the radii of a hole. Meshes without a wear box allow only frozen geometry (else
 * ARC_ARGUMENT in arc_shape_create). With CPE4I, triangles of such meshes do not share a
 * dilatation. A named material of a mesh is the layer of the body with the same name. The depth of
 * a layer follows from the mesh. */
arc_status arc_model_build_given(const arc_model_def *def, arc_mesh *given[ARC_BODIES],
                                 const arc_callbacks *callbacks, arc_model **model,
                                 arc_error *error);
/* Checks a definition and two meshes before arc_model_build_given. Errors: ARC_ARGUMENT. */
arc_status arc_model_check_given(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                                 arc_error *error);
/* Returns true if the model was built from meshes without a wear box. */
int arc_model_is_given(const arc_model *model);

arc_model *arc_model_retain(arc_model *model);
/* Drops one reference and sets the handle to NULL. The last reference frees the model. */
void arc_model_release(arc_model **model);

const arc_model_def *arc_model_definition(const arc_model *model);
/* Returns the kind of model: "plane" (meshes, in a plane or of revolution), "space" (3-D) or
 * "springs". */
const char *arc_model_kind_name(const arc_model *model);
/* Returns true if surfaces are maps over x and z (3-D). Each contact and run then chooses its own
 * cells. */
int arc_model_has_maps(const arc_model_def *def);
/* Returns the mesh of a body, or NULL if this kind of pair has no meshes. */
const arc_mesh *arc_model_mesh(const arc_model *model, arc_body body);
/* Returns the memory that the model uses [bytes]. A garbage collector needs this size. */
size_t arc_model_bytes(const arc_model *model);
/* Returns the computing time of arc_model_build [s]. */
double arc_model_seconds(const arc_model *model);

/* Sets size, height and far of the mesh if they are "auto" (0), for the unworn contact under `load`
 * [N], within the limits of the bodies. */
void arc_model_fit(arc_model_def *def, double load);
/* Sets sizes like arc_model_fit for a contact with friction, whose slip zones are narrower than the
 * contact. Automatic elements are a fifth as wide, which is 27 elements in the half width of an
 * unworn cylinder. They are wider if edges are sharp or if the user sets wide zones (at most 320
 * elements in all). */
void arc_model_fit_friction(arc_model_def *def, double load);
/* Sets "auto" zones to the needed widths [mm], rounded up to multiples of ten elements, within the
 * limits of the bodies. */
void arc_model_fit_zones(arc_model_def *def, const double needed[ARC_BODIES]);

/* Sets all "auto" values of a model that is built without a contact or run. Sizes are set for the
 * default load (100 N), and zones in proportion to the sizes. */
void arc_model_fit_alone(arc_model_def *def);

/* Computes the full widths [mm] of the candidate zones of both bodies. They cover a contact of the
 * half width `half_width` [mm], plus 30 %, at all positions |x| <= `reach` [mm] of the plate. They
 * are at least 50 (upper body) and 60 (lower body) elements of `size` [mm] wide, like the zones of
 * arc_mesh_default. */
void arc_zone_for(double reach, double half_width, double size, double zone[ARC_BODIES]);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

/* archard/model.h - the two elastic bodies, condensed to their wear boxes once and then shared.
 *
 * For each body: K assembled from elements, everything outside the wear box eliminated
 * with CHOLMOD, so that any worn shape needs only a small dense update (S = S_far + K_box, F =
 * normal block of S^-1).
 */
#ifndef ARCHARD_MODEL_H
#define ARCHARD_MODEL_H

#include "archard/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#define ARC_MODEL_SETTINGS(NUMBER, CHOICE)                                                         \
  NUMBER(radius, "mm", 10, ABOVE(0), 0,                                                            \
         "Radius R of the cylinder; it sets the size of the plate too.")                           \
  NUMBER(thickness, "mm", 1, ABOVE(0), 0,                                                          \
         "Thickness of both bodies; forces are those on the whole of it.")                         \
  CHOICE(                                                                                          \
      geometry, space, ARC_PLANE_STRAIN, 0,                                                        \
      "What the section in the plane stands for: long bodies, thin plates, or bodies of "          \
      "revolution about a vertical axis: a cylinder is a ball then, a block a disc, and loads "    \
      "and volumes are those of the whole circumference. \"springs\", to teach and to test: a "    \
      "ball on a flat, each under a layer of springs as thick as thickness, alone on its base "    \
      "(Winkler); for wear{} only. \"3-D\": half-spaces that touch in a spot and slide along x, "  \
      "worn as maps over x and z.")                                                                \
  NUMBER(axis, "mm", 0, FROM(0), 0,                                                                \
         "Of an axisymmetric model: how far left of x = 0 its axis is, as far as the mean radius " \
         "of a thrust ring. 0: the bodies touch on the axis.")

typedef struct arc_model_def {
  ARC_MODEL_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_CHOICE)
  arc_material material[ARC_BODIES]; /* by arc_body; settings "cylinder" and "plate" */
  arc_body_def body[ARC_BODIES];     /* their shapes; settings "upper" and "lower" */
  arc_mesh_def mesh;
} arc_model_def;

extern const arc_setting arc_model_settings[];

/* The paper's case: all in numbers, see arc_mesh_default. */
arc_model_def arc_model_default(void);

/* One body in numbers. */
arc_body_def arc_model_solid(const arc_model_def *def, arc_body body);

/* What a body is called: by its name; without one by its kind where that tells it from the other,
 * else "upper" or "lower"; the usual pair "cylinder" and "plate". */
const char *arc_model_body_name(const arc_model_def *def, arc_body body);
/* "upper" or "lower". */
const char *arc_model_role_name(arc_body body);
/* The body that a word means, its name, role or kind, "cylinder" for the upper one and "plate" for
 * the lower: 1; 0: none, -1: it could be either. *body is written to in any case. */
int arc_model_find_body(const arc_model_def *def, const char *word, arc_body *body);

/* Contact modulus of the couple [MPa], 1 / (1/E*_c + 1/E*_p); in plane stress E takes the place of
 * E*. */
double arc_contact_modulus(arc_space space, const arc_material material[ARC_BODIES]);

/* The load [N] per length of a line contact that presses about as much [N/mm]: over the thickness;
 * over the circumference; of a round contact over its mean chord. */
double arc_model_line(const arc_model_def *def, double load);

/* The wear coefficient that a body's pressures are taken with [mm2/N]: the largest of its layers
 * and its own; the others wear by their share of it. 0: none has one. */
double arc_model_wear_k(const arc_model_def *def, arc_body body);

/* Relative radius of the surfaces [mm]: 1 / (1/R_upper + 1/R_lower), hollow ones counted negative;
 * INFINITY where they fit, are flat, or are no arcs. */
double arc_model_relative_radius(const arc_model_def *def);

/* Whether Hertz' formulas hold: a solid cylinder or disc, or a ball, on a block without layers. */
int arc_model_is_hertzian(const arc_model_def *def);

/* Whether one of the bodies is hollow: the other turns in it. */
int arc_model_is_hole(const arc_model_def *def);
/* The way along the surfaces that a rotation by so many degrees is [mm]; 0 without a hole. */
double arc_model_way(const arc_model_def *def, double degrees);
/* Whether the lower body slides along its own unworn surface: a block, or what turns in or around a
 * hole. */
int arc_model_slides_along(const arc_model_def *def);

/* Width [mm] of the lower body along its surface: a stroke as long as that wears it evenly. */
double arc_model_width(const arc_model_def *def);

/* Half width [mm] of the unworn contact under a load [N], as far as a formula tells: Hertz', of
 * punches with rounded edges, or Persson's of a pin in a hole. Of bodies of revolution the radius
 * of a round contact, half the width of a ring. */
double arc_model_half_width(const arc_model_def *def, double load);

/* Closed-form Hertz contact of a cylinder on a half-space, or of a ball. */
typedef struct arc_hertz {
  double half_width;   /* [mm] a = sqrt(4 L R / (pi t E*)); of a ball cbrt(3 L R / (4 E*)) */
  double p_max;        /* [MPa] p_H = 2 L / (pi a t); of a ball 3 L / (2 pi a^2) */
  double E_star;       /* [MPa] the contact modulus, see arc_contact_modulus */
  double approach;     /* [mm] of a ball a^2 / R; NaN of a cylinder, for which it has no end */
  double half_width_z; /* [mm] across the motion: of a ball the same, unless its radii differ; NaN
                          of a cylinder */
} arc_hertz;

#define ARC_HERTZ_SETTINGS(NUMBER, CHOICE)                                                         \
  NUMBER(radius, "mm", 10, ABOVE(0), 0, "Radius of the cylinder.")                                 \
  NUMBER(radius_z, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                \
         "Radius across the motion, with geometry \"3-D\". Left out: radius, a ball.")             \
  NUMBER(load, "N", 100, ABOVE(0), 0, "Normal load L_N over the whole thickness.")                 \
  NUMBER(thickness, "mm", 1, ABOVE(0), 0,                                                          \
         "Thickness of both bodies; the load per thickness counts, but of a ball.")                \
  CHOICE(geometry, space, ARC_PLANE_STRAIN, 0,                                                     \
         "A long cylinder, a thin one, a ball: \"axisymmetric\", or two radii: \"3-D\".")

typedef struct arc_hertz_def {
  ARC_HERTZ_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_CHOICE)
  arc_material material[ARC_BODIES]; /* by arc_body; settings "cylinder" and "plate" */
} arc_hertz_def;

extern const arc_setting arc_hertz_settings[];

arc_hertz_def arc_hertz_default(void);

/* Values out of their ranges are ARC_ARGUMENT, named. */
arc_status arc_hertz_of(const arc_hertz_def *def, arc_hertz *hertz, arc_error *error);

/* That of plane strain: load [N] > 0, radius and thickness [mm] > 0, else ARC_ARGUMENT. */
arc_status arc_hertz_solve(double radius, double thickness, double load,
                           const arc_material material[ARC_BODIES], arc_hertz *hertz,
                           arc_error *error);

/* What they give for the relative radius of a model's pair; of rings, as of a straight line as
 * long. */
arc_hertz arc_model_hertz(const arc_model_def *def, double load);

/* Opaque, reference counted, unchanged after arc_model_build; not for two threads at once (stress
 * fields share the factor's workspace). */
typedef struct arc_model arc_model;

/* Meshes, assembles, factorises and condenses both bodies. What is "auto" is that of
 * arc_model_fit_alone. Errors: those of arc_mesh_build,
 * ARC_ARGUMENT, ARC_NUMERIC (not positive definite), ARC_MEMORY. On failure *model is NULL. */
arc_status arc_model_build(const arc_model_def *def, arc_model **model, arc_error *error);
/* Whether arc_model_build takes a definition, but for the memory: ARC_ARGUMENT with field,
 * expectation and value, ARC_GEOMETRY. */
arc_status arc_model_check(const arc_model_def *def, arc_error *error);

/* The same, and asks and tells on its way: it may be stopped (ARC_STOPPED), and shows how far it
 * is.
 */
arc_status arc_model_build_watched(const arc_model_def *def, const arc_callbacks *callbacks,
                                   arc_model **model, arc_error *error);

/* The same of two meshes that are given, by arc_body, as those of arc_mesh_read_msh. It takes them
 * over, on failure too, and nulls them. def->radius is that of the pair, for estimates by Hertz'
 * theory and the plate's width; of def->mesh only `element` counts, the rest becomes what the
 * meshes have. A shape in def->body is ARC_ARGUMENT, but for the radii of a hole. Meshes without a
 * wear box serve frozen geometry alone: moving it is ARC_ARGUMENT in arc_shape_create and what
 * leans on it. Triangles of such meshes stand alone in CPE4I. What a mesh has a named material for,
 * a layer of the body has under that name; depths of layers are those in the mesh. */
arc_status arc_model_build_given(const arc_model_def *def, arc_mesh *given[ARC_BODIES],
                                 const arc_callbacks *callbacks, arc_model **model,
                                 arc_error *error);
/* Whether it takes a definition and two meshes, but for the memory: ARC_ARGUMENT. */
arc_status arc_model_check_given(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                                 arc_error *error);
/* Whether it was built of meshes without a wear box. */
int arc_model_is_given(const arc_model *model);

arc_model *arc_model_retain(arc_model *model);
/* Gives up one reference and nulls the handle. */
void arc_model_release(arc_model **model);

const arc_model_def *arc_model_definition(const arc_model *model);
/* The kind of its pair of bodies: "plane" for meshes in a plane or of revolution. */
const char *arc_model_kind_name(const arc_model *model);
/* Whether surfaces are maps over x and z, whose cells and windows each contact and run finds. */
int arc_model_has_maps(const arc_model_def *def);
/* NULL: its kind has no meshes. */
const arc_mesh *arc_model_mesh(const arc_model *model, arc_body body);
/* Bytes held by the model, for a garbage collector. */
size_t arc_model_bytes(const arc_model *model);
/* Seconds arc_model_build took. */
double arc_model_seconds(const arc_model *model);

/* Sets what is still "auto" of a mesh (0 in the struct), but for the zones: size, height and far,
 * for the unworn contact under `load` [N]. Large elements keep within the bodies. */
void arc_model_fit(arc_model_def *def, double load);
/* Sets the zones that are still "auto" to those needed, in steps of ten elements, as far as there
 * is room for them. */
void arc_model_fit_zones(arc_model_def *def, const double needed[ARC_BODIES]);

/* All of it for a model that nobody asks for with a load of its own: the paper's load and zones in
 * proportion. */
void arc_model_fit_alone(arc_model_def *def);

/* Zones (full widths, by body) [mm] that hold contacts up to half_width [mm] wide on either side of
 * the cylinder's axis, over plate positions |x| <= reach [mm]. Never under 50 and 60 elements of
 * `size` [mm]: at the default size these are the default zones. */
void arc_zone_for(double reach, double half_width, double size, double zone[ARC_BODIES]);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

/* archard/contact.h - worn shapes, and contact solutions on them.
 *
 * Contact is hard: at each node f >= 0, gap >= 0 and f gap = 0, where f is the component of the
 * nodal force along the load. The sum of f is exactly the load. The surfaces are coupled by mortar
 * elements along x with a dual basis on the cylinder's side. The nodal forces are f on the
 * cylinder and B' f on the plate, with the coupling matrix B, so that they balance exactly, also
 * along x. Pressures act along the normals of the worn surface.
 *
 * With Coulomb friction the solution is computed in increments of load and motion, because it
 * depends on their history. |q| <= mu p; a point does not slip if |q| < mu p, else the slip ds is
 * along q. Here q is the shear traction on the cylinder along +x (on the plate along -x), mu the
 * coefficient of friction, p the pressure, and ds the slip of the plate's surface relative to the
 * cylinder's surface. Q is the force that drives the plate along x. q, ds and Q are positive for a
 * plate that moves to +x. In two dimensions the displacement under a force depends on the size of
 * the bodies, which have a rigid top and a rigid base. */
#ifndef ARCHARD_CONTACT_H
#define ARCHARD_CONTACT_H

#include "archard/array.h"
#include "archard/measure.h"
#include "archard/model.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Geometry of worn bodies. Moving: wear moves the nodes and so changes the stiffness of the wear
 * box (the elements at the surface). Frozen: wear changes only the gap. */
#define ARC_GEOMETRY_LIST(X)                                                                       \
  X(MOVING, "moving")                                                                              \
  X(FROZEN, "frozen")
typedef enum arc_geometry { ARC_GEOMETRY_LIST(ARC_CHOICE_ENUM) } arc_geometry;
extern const char *const arc_geometry_names[];

/* Corrections of the finite elements. All: added terms correct errors of the elements at short
 * wavelengths (theory.md, "Corrections"). None: the elements alone, to show the effect of these
 * terms. */
#define ARC_CORRECTIONS_LIST(X)                                                                    \
  X(CORRECTIONS_ALL, "all")                                                                        \
  X(CORRECTIONS_NONE, "none")
typedef enum arc_corrections { ARC_CORRECTIONS_LIST(ARC_CHOICE_ENUM) } arc_corrections;
extern const char *const arc_corrections_names[];

/* The worn surfaces of both bodies on one model. Opaque; retains its model. */
typedef struct arc_shape arc_shape;

/* Creates unworn surfaces. The stiffness of the wear box (the elements at the surface) is
 * condensed again when a surface node has moved too far since the last condensation. Across the
 * surface the limit is `refresh` [-] times the present height of the element, or times a fifth of
 * the layer's remaining thickness if that is less. Along x it is a hundredth of `refresh` times
 * the width of an element. For different materials the change of slope is limited too. With
 * refresh 0 the box is condensed after every motion. Between two condensations the compliance of a
 * body without layers is updated to first order. */
arc_status arc_shape_create(arc_model *model, arc_geometry geometry, double refresh,
                            arc_shape **shape, arc_error *error);
arc_status arc_shape_clone(const arc_shape *shape, arc_shape **copy, arc_error *error);
void arc_shape_destroy(arc_shape **shape);
arc_model *arc_shape_model(const arc_shape *shape);

/* Wears one body. `depth` [mm] has one value for each candidate contact node. The nodes move along
 * their present normals (Eq. 8 of the reference paper). The sum of the depths is also stored for
 * each node. The nodes of the wear box follow the surface smoothly. Errors: ARC_GEOMETRY (an
 * element of the wear box would collapse or, with frozen geometry, a depth would exceed 1e6 mm),
 * ARC_MEMORY, ARC_NUMERIC. On failure the shape is unchanged. */
arc_status arc_shape_wear(arc_shape *shape, arc_body body, const double *depth, arc_error *error);

/* Wears one body everywhere by the same depth [mm], as a plate is worn by a stroke over its whole
 * width. The surface keeps its shape. With moving geometry, layers in the wear box become thinner.
 * Errors: ARC_MEMORY, ARC_NUMERIC. On failure the shape is unchanged. */
arc_status arc_shape_wear_evenly(arc_shape *shape, arc_body body, double depth, arc_error *error);

/* Interpolates the worn surfaces of `from` to the unworn surfaces `to` on another model of the same
 * bodies. The splines are smooth inside a scar, keep the worn area and give no negative depths. If
 * both models have the same nodes, the depths are equal up to rounding. Wear outside the zones of
 * the other model is lost. Errors: those of arc_shape_wear. On failure `to` must be destroyed. */
arc_status arc_shape_remap(const arc_shape *from, arc_shape *to, arc_error *error);

/* Interpolates a measured depth profile of at least two points to the unworn nodes of a body, by
 * the splines of arc_shape_remap. The result is `depth` [mm] at each candidate contact node, 0
 * beyond the ends of the profile. If the points cover a whole scar (unworn at both ends, within
 * the nodes), the area of the polyline through them is kept. Depths of points at nodes are not
 * changed. Errors: ARC_MEMORY. */
arc_status arc_shape_sample(const arc_shape *shape, arc_body body, arc_depths measured,
                            double *depth, arc_error *error);

/* Profile of a body's candidate contact nodes. The arrays have `count` values, are owned by the
 * shape and are valid until the shape changes. */
typedef struct arc_profile {
  int count;
  const double *x;      /* [mm] unworn position of the nodes */
  const double *h;      /* [mm] wear depth, the sum of the depths along the normals (Eq. 6 of the
                           reference paper) */
  const double *y;      /* [mm] present height of the nodes */
  const double *worn_x; /* [mm] present position of the nodes */
  const double
      *way; /* [mm] length of the vector sum of the depths (Eq. 8 of the reference paper) */
} arc_profile;
arc_profile arc_shape_profile(const arc_shape *shape, arc_body body);

/* arc_shape_depth returns the largest wear depth [mm] as the sum of the depths along the normals
 * (Eq. 6 of the reference paper), arc_shape_vector_depth the largest length [mm] of their vector
 * sum (Eq. 8). */
double arc_shape_depth(const arc_shape *shape, arc_body body);
double arc_shape_vector_depth(const arc_shape *shape, arc_body body);
/* Writes the present positions of all nodes of a body, including the moved nodes of the wear box,
 * to `xy` [mm] as pairs x, y. */
void arc_shape_nodes(const arc_shape *shape, arc_body body, double *xy);

/* Returns the state of the worn surfaces for storage. The arrays of each body are: h [nodes, 1],
 * the wear depth including uniform wear [mm]; xy [nodes, 2], the present positions of the nodes
 * without uniform wear [mm]; settled [nodes, 2], these positions at the last condensation [mm];
 * even [1, 1], the uniform wear of arc_shape_wear_evenly [mm]; and condensed [1, 1], which is 1 if
 * the wear box was condensed after wear, else 0. The shape owns names and values. The members
 * update and distance of the arrays are 0. */
#define ARC_SHAPE_STATE 10
void arc_shape_state(const arc_shape *shape, arc_array state[ARC_SHAPE_STATE]);

/* Restores a shape bit for bit from its state. ARC_ARGUMENT: an array is missing, superfluous or of
 * a wrong size, or its values are impossible for a worn surface. Other errors: ARC_GEOMETRY,
 * ARC_MEMORY, ARC_NUMERIC. */
arc_status arc_shape_restore(arc_model *model, arc_geometry geometry, double refresh,
                             const arc_array *state, size_t count, arc_shape **shape,
                             arc_error *error);

/* Pressing of the bodies before the motion. Friction: friction acts while the bodies are pressed
 * together. Frictionless: friction acts only afterwards. */
#define ARC_PRESS_LIST(X)                                                                          \
  X(PRESS_FRICTION, "friction")                                                                    \
  X(PRESS_FRICTIONLESS, "frictionless")
typedef enum arc_press { ARC_PRESS_LIST(ARC_CHOICE_ENUM) } arc_press;
extern const char *const arc_press_names[];

/* Settings of one contact problem. */
#define ARC_CONTACT_SETTINGS(NUMBER, WHOLE, CHOICE, OTHER)                                         \
  NUMBER(load, "N", 100, ABOVE(0), 0, "Normal load L_N.")                                          \
  NUMBER(x, "mm", 0, ANY, 0,                                                                       \
         "Position of the plate. In a hole it is the arc length, radius times angle.")             \
  NUMBER(load_angle, "degrees", 0, BETWEEN(-90, 90), 0,                                            \
         "Direction of the load on a pin in a hole: angle between the load and the line from the " \
         "centre of the hole to the point of first contact, positive towards +x.")                 \
  NUMBER(average, "mm", 0.08, FROM(0), 0,                                                          \
         "Length over which p_average averages the pressure, at least four elements. 0: no "       \
         "averaging; p_average is then p_max.")                                                    \
  NUMBER(friction, "", 0, FROM(0), 0, "Coefficient of Coulomb friction; 0: no friction.")          \
  CHOICE(press, press, ARC_PRESS_FRICTION, 0,                                                      \
         "\"friction\": friction acts while the bodies are pressed together; \"frictionless\": "   \
         "friction acts only afterwards.")                                                         \
  WHOLE(increments, "", 0, WITHIN(1, 100000), ARC_AUTOMATIC,                                       \
        "With friction: number of increments of the load, while the plate does not move. "         \
        "\"auto\": four for each element that the edge of the contact crosses, but at least 20; "  \
        "in 3-D the number is chosen as in c:move.")                                               \
  CHOICE(corrections, corrections, ARC_CORRECTIONS_ALL, 0,                                         \
         "\"none\": the finite elements alone, without the terms that correct their errors at "    \
         "short wavelengths (edges of contact, shear from node to node, slip between nodes); use " \
         "it to see the effect of these terms. No effect in 3-D.")                                 \
  OTHER(model, "a model object or a table of its fields", "model", 0,                              \
        "The two bodies. Default: model{} with contact zones wide enough for the contact.")        \
  OTHER(worn, "a wear object or a table { cylinder=, plate= }", "wear", 0,                         \
        "Worn surfaces: a wear run, whose present surfaces are used, or for each body a "          \
        "function f(x) for the depth in mm or a measured profile { x={...}, h={...} }; in 3-D a "  \
        "function f(x, z) or a map of depths. Default: unworn.")

typedef struct arc_contact_def {
  ARC_CONTACT_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE, ARC_MEMBER_CHOICE, ARC_MEMBER_OTHER)
} arc_contact_def;

extern const arc_setting arc_contact_settings[];

arc_contact_def arc_contact_default(void);

/* Computes the full widths [mm] of the candidate zones of both bodies, which cover the unworn
 * contact and a margin (arc_zone_for). */
void arc_contact_zones(const arc_contact_def *def, const arc_model_def *model,
                       double zone[ARC_BODIES]);

/* A contact solution. Opaque. */
typedef struct arc_contact arc_contact;

/* Solves one contact problem. Later changes of the shape do not change the solution. Errors:
 * ARC_ARGUMENT (a setting out of its range), ARC_ZONE (the contact reaches the edge of a candidate
 * zone; the message has the zone needed), ARC_MEMORY, ARC_NUMERIC. Warns if the contact is less
 * than four elements wide, or if friction times Dundurs' beta exceeds 0.4, because the solution may
 * then not be unique. */
arc_status arc_contact_solve(const arc_shape *shape, const arc_contact_def *def,
                             const arc_callbacks *callbacks, arc_contact **contact,
                             arc_error *error);
void arc_contact_destroy(arc_contact **contact);
/* Returns the definition of a contact. The contact owns it. */
const arc_contact_def *arc_contact_definition(const arc_contact *contact);
/* Returns the memory that the contact uses [bytes]. A garbage collector needs this size. */
size_t arc_contact_bytes(const arc_contact *contact);

/* A motion that starts from a solved contact. Load and motion change linearly. */
#define ARC_MOTION_SETTINGS(NUMBER, WHOLE)                                                         \
  NUMBER(x, "mm", 0, ANY, ARC_OPTIONAL, "Final position of the plate's rigid base.")               \
  NUMBER(load, "N", 0, ABOVE(0), ARC_OPTIONAL, "Normal load at the end. Default: unchanged.")      \
  NUMBER(z, "mm", 0, ANY, ARC_OPTIONAL,                                                            \
         "Final position of the lower body along z, in 3-D. Default: unchanged.")                  \
  NUMBER(tangential, "N", 0, ANY, ARC_OPTIONAL,                                                    \
         "Final force that drives the plate along x, instead of x; it must be less than "          \
         "friction times the load.")                                                               \
  NUMBER(tangential_z, "N", 0, ANY, ARC_OPTIONAL,                                                  \
         "Final force that drives the lower body along z, in 3-D, instead of z.")                  \
  WHOLE(increments, "", 0, WITHIN(1, 100000), ARC_AUTOMATIC,                                       \
        "Number of equal increments. \"auto\": one in 2-D; set more if load and motion change "    \
        "together or the materials differ. In 3-D the increments are halved until this changes "   \
        "motion and force by less than 0.1 % of their values in full slip, and the energy by "     \
        "less than 1 %.")

typedef struct arc_motion_def {
  ARC_MOTION_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE)
  int by_force;   /* 1: the motion ends at the force `tangential`; 0: at the position `x` */
  int by_force_z; /* 1: the motion ends at the force `tangential_z`; 0: at the position `z` */
} arc_motion_def;

extern const arc_setting arc_motion_settings[];

/* Returns the default motion, which keeps the present x and load. */
arc_motion_def arc_contact_motion(const arc_contact *contact);

/* Computes the contact after a motion. Points that stick remain opposite to the same points of the
 * other body. If x is given, the plate may slide until the contact reaches the edge of a zone; each
 * node is then paired with the points that are opposite to it. Errors: those of arc_contact_solve;
 * ARC_ARGUMENT if a tangential force exceeds friction times load. */
arc_status arc_contact_move(const arc_contact *from, const arc_motion_def *motion,
                            const arc_callbacks *callbacks, arc_contact **contact,
                            arc_error *error);

typedef struct arc_contact_result {
  double area;         /* [mm2] contact area; 0 in 2-D */
  double half_width_z; /* [mm] half the width of the contact along z; 0 in 2-D */
  double p_center;     /* [MPa] pressure at the cylinder's node x = 0; in holes the pressure in the
                          direction of the load */
  double p_max;        /* [MPa] largest nodal pressure; mesh-dependent at scar edges */
  double p_average; /* [MPa] largest mean pressure over a length `average`; converges as the mesh is
                       refined */
  double half_width;   /* [mm] half the contact width */
  double left, right;  /* [mm] edges of the contact in the cylinder's frame, interpolated between
                          nodes; the error is 0.03 element widths on unworn and 0.07 on smooth worn
                          surfaces, and up to 0.6 (r.m.s. 0.2) at edges of scars */
  double normal_force; /* [N] integral of the pressure over the area, which equals the load; in
                          hollow surfaces it is up to 4/pi times the load */
  double approach;     /* [mm] approach of the plate's rigid base and the cylinder's fixed top */
  double tangential;   /* [N] force on the plate along x; without friction it is caused by slopes of
                          the surfaces */
  double energy; /* [N mm] energy dissipated by friction since first contact, including slip between
                    nodes */
  double z;      /* [mm] position of the lower body along z; 0 in 2-D */
  double tangential_z; /* [N] force on the lower body along z; 0 in 2-D */
  double energy_error; /* [N mm] difference of `energy` from the energy computed with half as many
                          increments */
  double stick;   /* [-] fraction of the contact area that stuck in the last increment; 0 in 2-D */
  int iterations; /* number of active-set iterations */
} arc_contact_result;
arc_contact_result arc_contact_get(const arc_contact *contact);

/* Pressures at a body's candidate contact nodes. The arrays have `count` values and are owned by
 * the contact. x is in the frame of the cylinder for both bodies: for nodes of the plate it is
 * their own x plus the position of the plate. */
typedef struct arc_pressure {
  int count;
  const double *x; /* [mm] */
  const double *p; /* [MPa] */
  const double
      *f; /* [N/mm] nodal force normal to the surface, per thickness: p times the width that belongs
             to the node; for bodies of revolution [N], the force on the ring of the node */
  const double *fx; /* [N/mm] nodal force on the body along x, caused by pressures on inclined parts
                       of the surface */
} arc_pressure;
arc_pressure arc_contact_pressure(const arc_contact *contact, arc_body body);

/* Shear tractions at a body's candidate contact nodes. The arrays have `count` values and are owned
 * by the contact. Without friction the tractions are zero. */
typedef struct arc_shear {
  int count;
  const double *x; /* [mm] position of the nodes */
  const double *q; /* [MPa] shear traction: on the cylinder along +x, on the plate along -x */
} arc_shear;
arc_shear arc_contact_shear(const arc_contact *contact, arc_body body);

/* Returns the slip [mm] of the plate's surface since first contact, relative to each of the *count
 * candidate contact nodes of the cylinder. Returns NULL without friction. */
const double *arc_contact_slip(const arc_contact *contact, int *count);

/* Writes the edges [mm] of one stick zone in the last increment, and returns 1; returns 0 if there
 * is no such zone. `index` counts the zones from left to right, from 0. Edges are interpolated
 * between nodes, with an error of 0.15 of an element, or 0.3 if fewer than six elements stick. */
int arc_contact_stick(const arc_contact *contact, int index, double edges[2]);

/* Checks a solution, for tests and for builds with ARC_CHECKS. The forces on both bodies must
 * balance the load, no force may be tensile, no gap may be negative, and no force may act across an
 * open gap. ARC_NUMERIC: the message has the violated condition and the amount of the violation. */
arc_status arc_contact_validate(const arc_contact *contact, arc_error *error);

/* Columns X(name, unit, text) of a stress field: positions of the nodes, displacements and
 * stresses. Files have the columns in this order.
 *
 * Stresses are of second order in the element size. On the boundary they agree with the pressure
 * and shear of the node and with the strain along the surface. Inside the body they are polynomials
 * fitted around each node. Near a smooth edge of contact the pressure follows the square-root law.
 * For elements of 20 um its error is 1 % of the largest pressure. The error of the stress along the
 * surface is 2 % (9 % with friction 0.6, where this stress has a cusp). At the edges of scars the
 * pressure of the node is used. */
#define ARC_FIELD_STRESSES(X)                                                                      \
  X(sxx, "MPa", "stress along the surface")                                                        \
  X(syy, "MPa", "stress normal to the surface")                                                    \
  X(szz, "MPa", "stress out of the plane; for bodies of revolution the hoop stress")               \
  X(sxy, "MPa", "shear stress")                                                                    \
  X(mises, "MPa", "von Mises stress")                                                              \
  X(principal, "MPa", "largest principal stress, tension positive")                                \
  X(shear, "MPa", "largest shear stress in the plane")
#define ARC_FIELD_COLUMNS(X)                                                                       \
  X(x, "mm", "position of the worn node along the surface")                                        \
  X(y, "mm", "position of the worn node normal to the surface")                                    \
  X(ux, "mm", "displacement along the surface")                                                    \
  X(uy, "mm", "displacement normal to the surface")                                                \
  ARC_FIELD_STRESSES(X)

/* Displacements and stresses of one body, computed by back-substitution. The arrays have `nodes`
 * values and are owned by the field. */
typedef struct arc_field {
  int nodes;
#define ARC_FIELD_MEMBER(name, unit, text) double *name;
  ARC_FIELD_COLUMNS(ARC_FIELD_MEMBER)
#undef ARC_FIELD_MEMBER
} arc_field;
arc_status arc_contact_field(const arc_contact *contact, arc_body body, arc_field **field,
                             arc_error *error);
void arc_field_destroy(arc_field **field);
/* Returns the pressures of the upper body, then of the lower body, as arrays: positions x and in
 * 3-D z [mm], and pressures p [MPa], each [sites, 1], in the frame of the upper body. In the
 * arrays of maps, z varies fastest. With friction in 3-D, arrays of the upper body follow: q, qz
 * and shear [MPa], the shear along x, along z and its magnitude; s, sz and slip [mm], the slip of
 * the lower surface relative to the upper one along x, along z and its magnitude. All arrays are
 * in one block, which the caller frees with free(). Errors: ARC_MEMORY. */
arc_status arc_contact_surfaces(const arc_contact *contact, arc_array **surfaces, size_t *count,
                                arc_error *error);
/* Returns the model of a contact. The caller must not release it. */
arc_model *arc_contact_model(const arc_contact *contact);
/* Returns the shape of a contact. The caller must not destroy it. */
const arc_shape *arc_contact_shape(const arc_contact *contact);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

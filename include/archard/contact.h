/* archard/contact.h - worn shapes, and contact solutions on them.
 *
 * Hard contact, mortar coupling in x with a dual basis on the cylinder's side: nodal
 * forces f of the cylinder and B'f of the plate balance identically, along x too. Pressures act
 * along the normals of the worn surface. Solved exactly for f >= 0, gap >= 0, f gap = 0, sum f =
 * load, where f are the components along the load.
 *
 * With Coulomb friction a solution follows from the one before it, over increments of load and
 * motion: |q| <= mu p, no slip where less, and slip ds never against q. q is the shear traction on
 * the cylinder along +x (on the plate along -x), ds the way of the plate's surface over the
 * cylinder's, Q the force that drives the plate along x: a plate that moves to +x has all of them
 * positive. In two dimensions the way under a force is that of these bodies: the cylinder's top and
 * the plate's base are rigid.
 */
#ifndef ARCHARD_CONTACT_H
#define ARCHARD_CONTACT_H

#include "archard/array.h"
#include "archard/measure.h"
#include "archard/model.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Whether wear moves the nodes (and so the stiffness of the wear box), or enters through the gap
 * alone. */
#define ARC_GEOMETRY_LIST(X)                                                                       \
  X(MOVING, "moving")                                                                              \
  X(FROZEN, "frozen")
typedef enum arc_geometry { ARC_GEOMETRY_LIST(ARC_CHOICE_ENUM) } arc_geometry;
extern const char *const arc_geometry_names[];

/* The worn surfaces of both bodies on one model. Opaque; keeps its model alive. */
typedef struct arc_shape arc_shape;

/* Unworn surfaces. `refresh`: the wear box is condensed again once a surface node has moved by more
 * than this share of an element's present height since the last time [-], by a fifth of it of what
 * is left of its layer, or along x by a hundredth of it in elements' widths; 0: whenever it moved.
 * In between, the compliance of a body without layers is followed to first order. */
arc_status arc_shape_create(arc_model *model, arc_geometry geometry, double refresh,
                            arc_shape **shape, arc_error *error);
arc_status arc_shape_clone(const arc_shape *shape, arc_shape **copy, arc_error *error);
void arc_shape_destroy(arc_shape **shape);
arc_model *arc_shape_model(const arc_shape *shape);

/* Wears one body by `depth` [surface] at the candidate nodes [mm]: nodes move along their current
 * normals (Eq. 8 of the paper), the scalar sums are kept beside them, the wear box is smoothed.
 * ARC_GEOMETRY (a wear-box element would collapse; frozen: more than 1e6 mm) or
 * ARC_MEMORY/ARC_NUMERIC: the shape is unchanged. */
arc_status arc_shape_wear(arc_shape *shape, arc_body body, const double *depth, arc_error *error);

/* Wears one body everywhere by the same depth [mm], as a plate under a stroke over its whole width:
 * the surface stays as it is, and the contact does not notice but what moving geometry has left of
 * layers in the wear box. ARC_MEMORY, ARC_NUMERIC: the shape is unchanged. */
arc_status arc_shape_wear_evenly(arc_shape *shape, arc_body body, double depth, arc_error *error);

/* Takes the worn surfaces of one shape over to an unworn one on another model of the same bodies,
 * whose nodes need not be the same: by splines without kinks inside a scar, with the same area lost
 * and no depth below zero. On like nodes they are the same to rounding. What lies
 * outside the other model's zones is left out. Errors of arc_shape_wear: `to` is then to be given
 * up. */
arc_status arc_shape_remap(const arc_shape *from, arc_shape *to, arc_error *error);

/* Depths [surface] at a body's unworn nodes by a measured profile of them over x, at least two
 * points, none beyond its ends: by the same splines, and with the area under the broken line
 * through the points where that is a whole scar, unworn at both ends and within the nodes' reach;
 * so that points at the nodes stay what they are. ARC_MEMORY. */
arc_status arc_shape_sample(const arc_shape *shape, arc_body body, arc_depths measured,
                            double *depth, arc_error *error);

/* A candidate-surface profile; arrays of `count` doubles owned by the shape, valid until it
 * changes. */
typedef struct arc_profile {
  int count;
  const double *x;      /* [mm] unworn position of the nodes */
  const double *h;      /* [mm] wear depth, scalar sum along the normals (Eq. 6) */
  const double *y;      /* [mm] present height of the nodes */
  const double *worn_x; /* [mm] present position of the nodes */
  const double *way;    /* [mm] length of the vector sum of the wear (Eq. 8) */
} arc_profile;
arc_profile arc_shape_profile(const arc_shape *shape, arc_body body);

/* Largest wear depth [mm], scalar sum; and the largest length of the vector sum (Eq. 8). */
double arc_shape_depth(const arc_shape *shape, arc_body body);
double arc_shape_vector_depth(const arc_shape *shape, arc_body body);
/* Present nodes of a body [2 * nodes] (wear box moved), written to xy. */
void arc_shape_nodes(const arc_shape *shape, arc_body body, double *xy);

/* All that makes the worn surfaces, to be stored: of each body the wear depth h [nodes, 1] (even
 * wear included), the present nodes xy and those at the last condensation, settled [nodes, 2] (even
 * wear left out), all in mm; the even wear that left the surface as it was, even [1, 1] [mm], and
 * whether the wear box has been condensed again since it was unworn, condensed [1, 1]. Names and
 * values are the shape's; update and distance are 0. */
#define ARC_SHAPE_STATE 10
void arc_shape_state(const arc_shape *shape, arc_array state[ARC_SHAPE_STATE]);

/* The shape with this state: the same bits as the one it came from. ARC_ARGUMENT (an array is
 * missing, too many or not of the model's size; depths, places, order that no worn surface has),
 * ARC_GEOMETRY, ARC_MEMORY, ARC_NUMERIC. */
arc_status arc_shape_restore(arc_model *model, arc_geometry geometry, double refresh,
                             const arc_array *state, size_t count, arc_shape **shape,
                             arc_error *error);

/* How a contact with friction comes about. */
#define ARC_PRESS_LIST(X)                                                                          \
  X(PRESS_FRICTION, "friction")                                                                    \
  X(PRESS_FRICTIONLESS, "frictionless")
typedef enum arc_press { ARC_PRESS_LIST(ARC_CHOICE_ENUM) } arc_press;
extern const char *const arc_press_names[];

/* One contact problem. */
#define ARC_CONTACT_SETTINGS(NUMBER, WHOLE, CHOICE, OTHER)                                         \
  NUMBER(load, "N", 100, ABOVE(0), 0, "Normal load L_N.")                                          \
  NUMBER(x, "mm", 0, ANY, 0,                                                                       \
         "Position of the plate; in holes along their surface: radius times the angle.")           \
  NUMBER(load_angle, "degrees", 0, BETWEEN(-90, 90), 0,                                            \
         "Direction of the load in a hole, along the surface from where the bodies first touch; "  \
         "positive towards +x.")                                                                   \
  NUMBER(average, "mm", 0.08, FROM(0), 0,                                                          \
         "Length over which p_average is taken; it should hold four elements or more. 0: p_max.")  \
  NUMBER(friction, "", 0, FROM(0), 0, "Coefficient of Coulomb friction; 0: without.")              \
  CHOICE(press, press, ARC_PRESS_FRICTION, 0,                                                      \
         "Whether friction acts while the bodies are pressed together, or only from then on.")     \
  WHOLE(increments, "", 0, WITHIN(1, 100000), ARC_AUTOMATIC,                                       \
        "Steps in which the load is put on with friction, the plate's base held. \"auto\": four "  \
        "while the contact's edge crosses an element, at least 20.")                               \
  OTHER(model, "a model object or a table of its fields", "model", 0,                              \
        "The bodies. One is built where none is given.")                                           \
  OTHER(worn, "a wear object or a table { cylinder=, plate= }", "wear", 0,                         \
        "Shape of the surfaces: that of a wear run; or for each body a function f(x) that gives "  \
        "the depth, or a measured profile { x={...}, h={...} }, in mm; in 3-D a function f(x, z) " \
        "or a map of depths. Left out: unworn.")

typedef struct arc_contact_def {
  ARC_CONTACT_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE, ARC_MEMBER_CHOICE, ARC_MEMBER_OTHER)
} arc_contact_def;

extern const arc_setting arc_contact_settings[];

arc_contact_def arc_contact_default(void);

/* Zones (full widths, by body) [mm] wide enough for a worn contact of twice the unworn width. */
void arc_contact_zones(const arc_contact_def *def, const arc_model_def *model,
                       double zone[ARC_BODIES]);

/* What a contact solution yields. */
typedef struct arc_contact arc_contact;

/* Solves one problem. The solution keeps what it needs and does not follow later changes of the
 * shape. Errors: ARC_ARGUMENT (a setting out of its range), ARC_ZONE (the contact reaches the edge
 * of a candidate zone, the message names the zone it needs), ARC_MEMORY, ARC_NUMERIC. Warns where
 * the contact has less than four elements, and where friction times Dundurs' beta is above 0.4:
 * there may be more than one solution. */
arc_status arc_contact_solve(const arc_shape *shape, const arc_contact_def *def,
                             const arc_callbacks *callbacks, arc_contact **contact,
                             arc_error *error);
void arc_contact_destroy(arc_contact **contact);
/* The problem it solves. */
const arc_contact_def *arc_contact_definition(const arc_contact *contact);
/* Bytes held by the contact, for a garbage collector. */
size_t arc_contact_bytes(const arc_contact *contact);

/* A motion that starts from a contact, which stays: linear in all that changes. */
#define ARC_MOTION_SETTINGS(NUMBER, WHOLE)                                                         \
  NUMBER(x, "mm", 0, ANY, ARC_OPTIONAL, "Position the plate's base goes to.")                      \
  NUMBER(load, "N", 0, ABOVE(0), ARC_OPTIONAL,                                                     \
         "Normal load at the end; as before where left out.")                                      \
  NUMBER(z, "mm", 0, ANY, ARC_OPTIONAL,                                                            \
         "Position the lower body goes to across x, in 3-D; as before where left out.")            \
  NUMBER(                                                                                          \
      tangential, "N", 0, ANY, ARC_OPTIONAL,                                                       \
      "Force that drives the plate along x, at the end; instead of x, less than friction times "   \
      "the load.")                                                                                 \
  NUMBER(tangential_z, "N", 0, ANY, ARC_OPTIONAL,                                                  \
         "Force that drives the lower body along z, at the end, in 3-D; instead of z.")            \
  WHOLE(increments, "", 1, WITHIN(1, 100000), 0,                                                   \
        "Steps of equal size; more where load and motion change together, or materials differ.")

typedef struct arc_motion_def {
  ARC_MOTION_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE)
  int by_force;   /* `tangential` counts, not `x` */
  int by_force_z; /* `tangential_z` counts, not `z` */
} arc_motion_def;

extern const arc_setting arc_motion_settings[];

/* The motion that goes nowhere: to the contact's own x and load in one step. */
arc_motion_def arc_contact_motion(const arc_contact *contact);

/* The contact after a motion. Points that stick stay together whatever they were; under x the
 * pairing of nodes follows the plate, so that it may slide as far as the zones reach. Errors as
 * arc_contact_solve, and ARC_ARGUMENT for a tangential force that friction does not carry. */
arc_status arc_contact_move(const arc_contact *from, const arc_motion_def *motion,
                            const arc_callbacks *callbacks, arc_contact **contact,
                            arc_error *error);

typedef struct arc_contact_result {
  double area;         /* [mm2] in contact; 0 in the plane */
  double half_width_z; /* [mm] half its width across the motion; 0 in the plane */
  double p_center;    /* [MPa] at the cylinder's lowest node, x = 0 of the cylinder; in holes at the
                         one the load points at */
  double p_max;       /* [MPa] largest nodal pressure; at scar edges it grows as the mesh shrinks */
  double p_average;   /* [MPa] largest pressure averaged over the length `average`: settles */
  double half_width;  /* [mm] half the contact width */
  double left, right; /* [mm] contact edges, cylinder frame, between nodes: to 0.03 of an element
                         unworn, to 0.07 where worn surfaces meet smoothly, to 0.6 (r.m.s. 0.2) at
                         the edges of scars */
  double normal_force; /* [N] integral of the pressure over the area: the load but in hollow
                          surfaces, where it is up to 4/pi times that */
  double approach;     /* [mm] rigid approach of the plate's base and the cylinder's built-in top */
  double tangential;   /* [N] drives the plate along x; without friction what slopes bear */
  double energy;       /* [N mm] dissipated by friction since the bodies came together, by the slip
                          between nodes too */
  double z;            /* [mm] position of the lower body across x; 0 in the plane */
  double tangential_z; /* [N] drives the lower body along z; 0 in the plane */
  double stick;        /* share of the area that stuck in the last increment [-]; 0 in the plane */
  int iterations;      /* active-set iterations; with friction in space: sets of cells */
} arc_contact_result;
arc_contact_result arc_contact_get(const arc_contact *contact);

/* Nodal pressure on a body's candidate nodes; arrays of `count`, owned by the contact.
 * x is in the frame of the cylinder for both bodies (plate nodes: own x + plate position). */
typedef struct arc_pressure {
  int count;
  const double *x;  /* [mm] */
  const double *p;  /* [MPa] */
  const double *f;  /* [N/mm] nodal force per thickness across the surface, p times tributary width;
                       of revolution [N], that of its ring */
  const double *fx; /* [N/mm] nodal force along x on the body: pressures act along normals */
} arc_pressure;
arc_pressure arc_contact_pressure(const arc_contact *contact, arc_body body);

/* Shear on a body's candidate nodes, arrays of `count` as arc_pressure; zero without friction. */
typedef struct arc_shear {
  int count;
  const double *x; /* [mm] */
  const double *q; /* [MPa] shear traction: on the cylinder along +x, on the plate along -x */
} arc_shear;
arc_shear arc_contact_shear(const arc_contact *contact, arc_body body);

/* Way of the plate's surface over the cylinder's nodes [mm] since the bodies came together, `count`
 * values at the cylinder's x; NULL without friction. */
const double *arc_contact_slip(const arc_contact *contact, int *count);

/* Zones that stuck in the last increment, from left to right: writes the edges [mm] of zone `index`
 * (from 0), or returns 0 where there are no more. Between nodes to 0.15 of an element, to 0.3 where
 * fewer than six stick. */
int arc_contact_stick(const arc_contact *contact, int index, double edges[2]);

/* Whether the solution is one, for tests and builds with checks: forces of both bodies balance the
 * load, nothing is pulled, no gap is negative, no force bridges a gap. ARC_NUMERIC says what failed
 * and by how much. */
arc_status arc_contact_validate(const arc_contact *contact, arc_error *error);

/* The columns of a field, in the order of files: first where the nodes are, then what is there.
 * Stresses are of second order in the element size. On the boundary they fulfil the tractions (the
 * pressure and the shear at the node) and follow along it the strain of the surface; inside they
 * are polynomials fitted around each node. The pressure of the last node in contact is what its
 * element gets; at a point beside the edge it follows the square-root law where the surfaces meet
 * smoothly: to 1 % of the largest at 20 um, the stress along the surface with it to 2 %, to 9 %
 * with friction 0.6, under which it has a cusp there; at the edges of scars the node's is taken.
 * X(name, unit, text). */
#define ARC_FIELD_STRESSES(X)                                                                      \
  X(sxx, "MPa", "stress along the surface")                                                        \
  X(syy, "MPa", "stress across the surface")                                                       \
  X(szz, "MPa", "stress out of the plane, of revolution around the axis")                          \
  X(sxy, "MPa", "shear stress")                                                                    \
  X(mises, "MPa", "von Mises stress")                                                              \
  X(principal, "MPa", "largest principal stress, tension positive")                                \
  X(shear, "MPa", "largest shear stress in the plane")
#define ARC_FIELD_COLUMNS(X)                                                                       \
  X(x, "mm", "node as worn")                                                                       \
  X(y, "mm", "node as worn")                                                                       \
  X(ux, "mm", "displacement along the surface")                                                    \
  X(uy, "mm", "displacement across the surface")                                                   \
  ARC_FIELD_STRESSES(X)

/* Displacements and stresses by back-substitution; arrays of `nodes`, owned by the field. */
typedef struct arc_field {
  int nodes;
#define ARC_FIELD_MEMBER(name, unit, text) double *name;
  ARC_FIELD_COLUMNS(ARC_FIELD_MEMBER)
#undef ARC_FIELD_MEMBER
} arc_field;
arc_status arc_contact_field(const arc_contact *contact, arc_body body, arc_field **field,
                             arc_error *error);
void arc_field_destroy(arc_field **field);
/* The pressures of both bodies as arrays, those of a body together: x, (in space z,) p [sites, 1],
 * in the frame of the upper body; of a map site by site along z, then x. With friction in space
 * also, of the upper body: shear on it along x and z and its size, q, qz, shear [MPa], and slip of
 * the lower body's surface over it, s, sz, slip [mm]. One block, to be freed
 * with free(). ARC_MEMORY. */
arc_status arc_contact_surfaces(const arc_contact *contact, arc_array **surfaces, size_t *count,
                                arc_error *error);
/* The model a contact was solved on (borrowed). */
arc_model *arc_contact_model(const arc_contact *contact);
/* The surfaces it was solved on (borrowed). */
const arc_shape *arc_contact_shape(const arc_contact *contact);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

/* archard/joint.h - contact and wear of a ball in a socket, as in artificial hips.
 *
 * Frame of the cup: x medial-lateral, the axis of flexion; y anterior; z along the nominal load
 * into the cup. Directions are n(theta, phi) = (cos theta, sin theta sin phi, sin theta cos phi).
 * R(t) maps coordinates of the head to those of the cup. Contact is frictionless and displacements
 * are small:
 *
 *   g(n) = clearance + h_cup(n) + creep(n) + h_head(R' n) - u . n + (C p)(n) >= 0,  p >= 0,
 *   p g = 0,
 *   integral p n dA = F
 *
 * with the wear depths h_cup and h_head, the load F, the head's displacement u and the radial
 * compliance C of complete concentric spheres and shells, which is exact for each degree of
 * spherical harmonics. With `second_order` the gap also has the term (|u|^2 - (u . n)^2) / (2
 * radius). The model does not include shear, the cup's rim, edge loading, microseparation or
 * lubrication.
 *
 * Maps are on a lattice of cells over the complete sphere, [rows][2 rows], phi fastest: theta = (i
 * + 1/2) d, phi = -pi + (j + 1/2) d, d = pi / rows. The map of each body is in the body's own
 * frame. */
#ifndef ARCHARD_JOINT_H
#define ARCHARD_JOINT_H

#include "archard/body.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Model of the compliance of the bodies. Elastic: the full compliance of layered spheres. Winkler:
 * independent springs for the cup's first layer, which are exact for a uniform pressure on a shell.
 * Column: independent springs with the stiffness of a laterally confined layer. */
#define ARC_FOUNDATION_LIST(X)                                                                     \
  X(FOUNDATION_ELASTIC, "elastic")                                                                 \
  X(FOUNDATION_WINKLER, "winkler")                                                                 \
  X(FOUNDATION_COLUMN, "column")
typedef enum arc_foundation { ARC_FOUNDATION_LIST(ARC_CHOICE_ENUM) } arc_foundation;
extern const char *const arc_foundation_names[];

typedef struct arc_joint_def {
  double radius;             /* [mm] radius of the head */
  double clearance;          /* [mm] radial clearance */
  double inclination, cover; /* [degree] angle of the cup's axis from the load; angle of the rim
                                from the axis (90: half a sphere) */
  arc_material core;         /* material of the head below its layers */
  arc_layer
      head[ARC_MOST_LAYERS]; /* layers from the surface inwards; a thickness of 0 ends the list */
  arc_layer cup[ARC_MOST_LAYERS]; /* layers from the inside outwards, at least one; the last one is
                                     fixed at its outside */
  arc_foundation foundation;
  double size;      /* [degree] width of a cell, which is rounded down so that 180 / size is an even
                       number */
  int second_order; /* 1: gaps include terms of second order in displacement / radius */
} arc_joint_def;

/* Returns a metal-on-metal joint: a CoCr head of 28 mm diameter, a clearance of 0.06 mm, a cup of 3
 * mm CoCr, 6 mm polyethylene and 2 mm titanium, and cells of 2 degrees. */
arc_joint_def arc_joint_default(void);

/* Checks a definition. ARC_ARGUMENT: the message has the field, the expected and the actual
 * value. */
arc_status arc_joint_check(const arc_joint_def *def, arc_error *error);

/* Returns the radial displacement [mm/MPa] of a body under a unit pressure that is distributed as a
 * spherical harmonic of the given degree; 0 for degree 1 of the head, which is a rigid motion. NaN
 * if the equations of the layers have no solution. */
double arc_joint_compliance(const arc_joint_def *def, arc_body body, int degree);

/* --- gaits ------------------------------------------------------------------------------------ */

/* Rotation and load in one of n equal time intervals of a cycle. */
typedef struct arc_gait_instant {
  double rotation[9]; /* rotation R in the middle of the interval, row by row */
  double omega[3];    /* [rad] rotation vector from the start to the end of the interval */
  double load[3];     /* [N] force on the cup, in the frame of the cup */
} arc_gait_instant;

/* Computes the n instants of a cycle. `rotation` [2n + 1][9] has the rotations at the times 0,
 * 1/(2n), 2/(2n), ..., 1; `load` [n][3] has the loads [N] in the middle of each interval.
 * ARC_ARGUMENT if the gait is not periodic; the message has the difference between start and end
 * in degrees. */
arc_status arc_gait_from_rotations(int n, const double *rotation, const double *load,
                                   arc_gait_instant *instant, arc_error *error);
/* Computes instants like arc_gait_from_rotations, from angles instead of rotations: `degrees` has
 * 2n + 1 rows of flexion, adduction and internal rotation. `order` is their order as letters for
 * the axes: "xyz" means R = Rx(flexion) Ry(adduction) Rz(rotation). */
arc_status arc_gait_from_angles(int n, const double *degrees, const double *load, const char *order,
                                arc_gait_instant *instant, arc_error *error);

/* Computes a built-in gait: "iso", "prosim", "flexion" or "rocking". "iso" is walking with the
 * ranges of motion of ISO 14242-1 and approximate curves. `angle` [degree] and `load` [N] apply to
 * "flexion" and "rocking". */
arc_status arc_gait_named(const char *name, int n, double angle, double load,
                          arc_gait_instant *instant, arc_error *error);

/* arc_gait_track returns the length [mm] of the path of the load over the surface of the head in a
 * cycle. arc_gait_work returns the friction work of a cycle divided by the coefficient of friction
 * [N mm]. */
double arc_gait_track(int n, const arc_gait_instant *instant, double radius);
double arc_gait_work(int n, const arc_gait_instant *instant, double radius);

/* --- contact and wear ------------------------------------------------------------------------- */

/* A joint with the worn maps of both bodies. Opaque; two threads must not use the same joint at
 * once. */
typedef struct arc_joint arc_joint;

/* Creates an unworn joint. Errors: ARC_ARGUMENT, ARC_NUMERIC (the compliance of the layers cannot
 * be computed), ARC_MEMORY. On failure *made is NULL. */
arc_status arc_joint_create(const arc_joint_def *def, arc_joint **made, arc_error *error);
void arc_joint_destroy(arc_joint **joint);
const arc_joint_def *arc_joint_definition(const arc_joint *joint);
int arc_joint_rows(const arc_joint *joint); /* number of rows of the lattice */
/* Returns the wear depths [rows][2 rows] [mm] of a body in its own frame. The joint owns the
 * array. */
const double *arc_joint_depth(const arc_joint *joint, arc_body body);
/* Sets the wear depths [rows][2 rows] [mm] of a body, for an initial shape. ARC_ARGUMENT: a depth
 * is not finite. */
arc_status arc_joint_set_depth(arc_joint *joint, arc_body body, const double *depth,
                               arc_error *error);
/* Returns the creep [mm] of each cell of the cup; 0 without creep. */
const double *arc_joint_creep(const arc_joint *joint);
/* Returns the pressures [MPa] of the last contact, in the frame of the cup; 0 before the first
 * contact. */
const double *arc_joint_pressure(const arc_joint *joint);
/* Writes the cross-shear ratio of each cell of the cup to share [rows][2 rows]. The ratio is the
 * fraction (0 to 0.5) of the friction work in the last cycle that was done across the principal
 * direction of sliding; 0 without sliding. */
void arc_joint_cross_shear(const arc_joint *joint, double *share);
double arc_joint_cell_area(const arc_joint *joint, int site); /* area of a cell [mm2] */

typedef struct arc_joint_contact {
  double p_max, p_center; /* [MPa] largest pressure; pressure in the direction of the load */
  double area,
      half_angle;      /* [mm2] contact area; [degree] half angle of a spherical cap of that area */
  double normal_force; /* [N] integral of the pressure over the area, which exceeds the load because
                          pressures are not parallel */
  double approach[3];  /* [mm] displacement u of the head */
  double rim_margin;   /* [degree] distance from the contact to the rim; negative if they overlap */
  int iterations;      /* number of iterations of conjugate gradients */
} arc_joint_contact;

/* Solves one contact under a load [N] in the frame of the cup, with the head at rotation R (row by
 * row; NULL: not rotated). Errors: ARC_ARGUMENT (the load points out of the cup), ARC_ZONE (the
 * contact extends around the head), ARC_NOT_CONVERGED, ARC_MEMORY, ARC_STOPPED. */
arc_status arc_joint_press(arc_joint *joint, const double rotation[9], const double load[3],
                           const arc_callbacks *callbacks, arc_joint_contact *contact,
                           arc_error *error);

/* Returns the wear coefficient [mm2/N] of a cell of the cup at the middle of an update, after
 * `cycles` cycles. cross_shear is the ratio of arc_joint_cross_shear, p_mean [MPa] the mean
 * pressure of a cycle. */
typedef double (*arc_joint_k_fn)(void *context, double cross_shear, double p_mean, double cycles);
/* Returns the head's share of the wear after `cycles` cycles. It is called for the middle of each
 * update. */
typedef double (*arc_joint_alpha_fn)(void *context, double cycles);
/* Returns the creep [mm] of a cell of the cup after `cycles` cycles; p_mean [MPa] > 0 is the mean
 * pressure since the first cycle. Creep increases the gap but does not count as wear volume. */
typedef double (*arc_joint_creep_fn)(void *context, double p_mean, double cycles);

typedef struct arc_joint_wear_def {
  int instants;
  const arc_gait_instant *instant; /* [instants] instants of the gait */
  double k, alpha;                 /* [mm2/N] wear coefficient; the head's share of the wear */
  arc_joint_k_fn k_function;       /* function for the wear coefficient; NULL: k is used */
  arc_joint_alpha_fn
      alpha_function;       /* function for the head's share of the wear; NULL: alpha is used */
  arc_joint_creep_fn creep; /* function for the creep of the cup; NULL: no creep */
  void *context;
  int explicit_scheme; /* 1: all instants of an update use the geometry at its start; 0: the contact
                          of each instant includes the wear of this instant */
} arc_joint_wear_def;

/* Results of a joint: sums over all updates, and values of the last cycle. */
typedef struct arc_joint_record {
  double cycles;
  int updates, solutions, iterations;
  double volume[ARC_BODIES]; /* [mm3] wear volume of each body */
  double p_peak;             /* [MPa] largest pressure of the last cycle */
  double area;               /* [mm2] largest contact area of the last cycle */
  double rim_margin; /* [degree] smallest distance from the contact to the rim in the last cycle */
  double
      penetration[3]; /* [mm] displacement of the head under the largest load of the last cycle */
  double work; /* [N mm] pressure times sliding distance, integrated over the contact area and the
                  last cycle */
  double loss; /* [mm3] wear volume of both bodies from k times pressure times sliding distance,
                  over all cycles */
} arc_joint_record;

/* Makes one update of `cycles` cycles. Solves the contact at each instant of a cycle, in the order
 * of time, or in reverse order in every second update. With explicit_scheme all contacts use the
 * geometry at the start of the update; otherwise each contact includes the wear of its instant and
 * of the instants solved before. On failure joint and record are unchanged. */
arc_status arc_joint_update(arc_joint *joint, const arc_joint_wear_def *def, double cycles,
                            const arc_callbacks *callbacks, arc_joint_record *record,
                            arc_error *error);
/* Makes a step of at most `most` cycles with error control. The depths after two updates of half
 * the length must differ from the depths after one update by at most a limit. This limit is
 * `tolerance` times the wear that all cycles so far would cause at the rate of this step. *step
 * [cycles] is the length of the first attempt; on return it is the length for the next step.
 * ARC_NOT_CONVERGED: the error exceeds the tolerance at every step length. On failure joint and
 * record are unchanged. */
arc_status arc_joint_advance(arc_joint *joint, const arc_joint_wear_def *def, double tolerance,
                             double most, double *step, const arc_callbacks *callbacks,
                             arc_joint_record *record, arc_error *error);

/* arc_joint_state writes the state of a joint to an array of arc_joint_state_count numbers, and
 * arc_joint_set_state restores it. A restored joint of the same definition gives the same results
 * to the bit. Errors of arc_joint_set_state: ARC_FORMAT (invalid numbers), ARC_MEMORY (initial
 * pressures may be lost). */
size_t arc_joint_state_count(const arc_joint *joint);
void arc_joint_state(const arc_joint *joint, double *state);
arc_status arc_joint_set_state(arc_joint *joint, const double *state, size_t count,
                               arc_error *error);
size_t arc_joint_bytes(const arc_joint *joint); /* approximate memory used by a joint [bytes] */

/* Returns the largest number of cycles of a stable explicit update. */
double arc_joint_explicit_limit(const arc_joint *joint, const arc_joint_wear_def *def);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

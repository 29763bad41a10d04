/* archard/joint.h - a ball in a socket, as in artificial hips: contact and wear of both.
 *
 * Frame of the cup: x medial-lateral, the axis of flexion; y anterior; z along the nominal load
 * into the cup. n(theta, phi) = (cos theta, sin theta sin phi, sin theta cos phi). R(t) takes the
 * head's coordinates to the cup's. Contact is frictionless, displacements are small:
 *
 *   g(n) = clearance + h_cup(n) + creep(n) + h_head(R' n) - u . n + (C p)(n) >= 0,  p >= 0,
 *   p g = 0,
 *   integral p n dA = F
 *
 * with the head's displacement u and the radial compliance C of complete concentric spheres and
 * shells, exact for each degree of spherical harmonics. `second_order` adds (|u|^2 - (u . n)^2) /
 * (2 radius). Shear, the cup's rim, edge loading, microseparation and lubrication are outside this
 * model.
 *
 * Maps are on a lattice of cells over the complete sphere, [rows][2 rows], phi fastest: theta = (i
 * + 1/2) d, phi = -pi + (j + 1/2) d, d = pi / rows. Each body's map is in its own frame.
 */
#ifndef ARCHARD_JOINT_H
#define ARCHARD_JOINT_H

#include "archard/body.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Elastic: full compliance. Winkler: independent springs of the cup's first layer, exact for a
 * uniform pressure on a shell, or of a column. */
#define ARC_FOUNDATION_LIST(X)                                                                     \
  X(FOUNDATION_ELASTIC, "elastic")                                                                 \
  X(FOUNDATION_WINKLER, "winkler")                                                                 \
  X(FOUNDATION_COLUMN, "column")
typedef enum arc_foundation { ARC_FOUNDATION_LIST(ARC_CHOICE_ENUM) } arc_foundation;
extern const char *const arc_foundation_names[];

typedef struct arc_joint_def {
  double radius;                   /* [mm] of the head */
  double clearance;                /* [mm] radial */
  double inclination, cover;       /* [degree] of the cup's axis from the load; from the axis to
                                      the rim: 90, half a sphere */
  arc_material core;               /* of the head, below its layers */
  arc_layer head[ARC_MOST_LAYERS]; /* from the surface inwards; thickness 0 ends them */
  arc_layer cup[ARC_MOST_LAYERS];  /* from the inside outwards, at least one; fixed outside */
  arc_foundation foundation;
  double size;      /* [degree] of a cell; 180 over an even number at the most */
  int second_order; /* gaps to second order in displacement over radius */
} arc_joint_def;

/* Metal on metal: 28 mm across, clearance 0.06 mm, CoCr on CoCr, 6 mm of polyethylene, 2 mm of
 * titanium, cells of 2 degrees. */
arc_joint_def arc_joint_default(void);

/* ARC_ARGUMENT: names field, expectation, value. */
arc_status arc_joint_check(const arc_joint_def *def, arc_error *error);

/* Radial displacement [mm/MPa] under a unit pressure of one degree of spherical harmonics. The
 * head's degree 1 moves it as a whole: 0. NaN where the layers have none. */
double arc_joint_compliance(const arc_joint_def *def, arc_body body, int degree);

/* --- gaits --------------------------------------------------------------------------------------
 */

/* One of n equal intervals of a cycle. */
typedef struct arc_gait_instant {
  double rotation[9]; /* R in its middle, row by row */
  double omega[3];    /* rotation vector from its start to its end [rad] */
  double load[3];     /* on the cup, in its frame [N] */
} arc_gait_instant;

/* Rotations at the instants 0, 1/2n, 2/2n, ... 1, [2n + 1][9], loads in the middle of each
 * interval, [n][3] -> instants [n]. ARC_ARGUMENT where the gait does not close, by how many
 * degrees. */
arc_status arc_gait_from_rotations(int n, const double *rotation, const double *load,
                                   arc_gait_instant *instant, arc_error *error);
/* The same of angles [2n + 1][3]: flexion, adduction, internal rotation [degree], applied in an
 * order given by three letters of x, y, z; "xyz": R = Rx(flexion) Ry(adduction) Rz(rotation). */
arc_status arc_gait_from_angles(int n, const double *degrees, const double *load, const char *order,
                                arc_gait_instant *instant, arc_error *error);

/* Gaits that are built in: "iso", like the standard's walk (its ranges; the shapes between are
 * approximate), "prosim", "flexion" and "rocking". `angle` [degree] and `load` [N] are those of the
 * last two. */
arc_status arc_gait_named(const char *name, int n, double angle, double load,
                          arc_gait_instant *instant, arc_error *error);

/* Track of the force over the head [mm] and work per coefficient of friction [N mm] of a cycle. */
double arc_gait_track(int n, const arc_gait_instant *instant, double radius);
double arc_gait_work(int n, const arc_gait_instant *instant, double radius);

/* --- contact and wear ---------------------------------------------------------------------------
 */

/* A joint with the worn maps of both bodies. Opaque; not for two threads at once. */
typedef struct arc_joint arc_joint;

/* ARC_ARGUMENT, ARC_NUMERIC (layers without a compliance), ARC_MEMORY; *made is NULL then. */
arc_status arc_joint_create(const arc_joint_def *def, arc_joint **made, arc_error *error);
void arc_joint_destroy(arc_joint **joint);
const arc_joint_def *arc_joint_definition(const arc_joint *joint);
int arc_joint_rows(const arc_joint *joint); /* of the lattice */
/* Depths of wear [mm] in the body's own frame, [rows][2 rows]; to be read only. */
const double *arc_joint_depth(const arc_joint *joint, arc_body body);
/* Sets a body's map, a shape to start from; ARC_ARGUMENT where a depth is not finite. */
arc_status arc_joint_set_depth(arc_joint *joint, arc_body body, const double *depth,
                               arc_error *error);
/* Creep [mm] of the cup; 0 without. */
const double *arc_joint_creep(const arc_joint *joint);
/* Pressures [MPa] of the last contact, in the cup's frame; 0 before the first. */
const double *arc_joint_pressure(const arc_joint *joint);
/* Of each of the cup's cells over the last cycle: the smaller share of work across the principal
 * direction of sliding, 0 .. 0.5, 0 where none slides; into share [rows][2 rows]. */
void arc_joint_cross_shear(const arc_joint *joint, double *share);
double arc_joint_cell_area(const arc_joint *joint, int site); /* [mm2] */

typedef struct arc_joint_contact {
  double p_max, p_center;  /* [MPa] largest; where the load points */
  double area, half_angle; /* [mm2]; [degree] of a cap of that area */
  double normal_force;     /* [N] integral of p: more than the load */
  double approach[3];      /* [mm] the head's displacement u */
  double rim_margin;       /* [degree] from the contact to the rim; negative: they overlap */
  int iterations;          /* of conjugate gradients */
} arc_joint_contact;

/* One contact with the head at rotation R (row by row; NULL: none) under a load [N] in the cup's
 * frame. ARC_ARGUMENT (the load points out of the cup), ARC_ZONE (the contact goes round the head),
 * ARC_NOT_CONVERGED, ARC_MEMORY, ARC_STOPPED. */
arc_status arc_joint_press(arc_joint *joint, const double rotation[9], const double load[3],
                           const arc_callbacks *callbacks, arc_joint_contact *contact,
                           arc_error *error);

/* Wear coefficient [mm2/N] of a cup's cell in the middle of an update, after so many cycles; p_mean
 * [MPa] is the mean of a cycle. */
typedef double (*arc_joint_k_fn)(void *context, double cross_shear, double p_mean, double cycles);
/* The head's share of wear in the middle of an update. */
typedef double (*arc_joint_alpha_fn)(void *context, double cycles);
/* Creep [mm] of a cell of the cup after so many cycles, whose mean pressure since the first is
 * p_mean [MPa] above 0. It opens the gap and removes no volume. */
typedef double (*arc_joint_creep_fn)(void *context, double p_mean, double cycles);

typedef struct arc_joint_wear_def {
  int instants;
  const arc_gait_instant *instant;   /* [instants] */
  double k, alpha;                   /* [mm2/N]; the head's share of wear */
  arc_joint_k_fn k_function;         /* in place of k; NULL: none */
  arc_joint_alpha_fn alpha_function; /* in place of alpha; NULL: none */
  arc_joint_creep_fn creep;          /* NULL: none */
  void *context;
  int explicit_scheme; /* all instants on one geometry; else the wear of each instant inside its
                          contact */
} arc_joint_wear_def;

/* What an update came to, added to by each. */
typedef struct arc_joint_record {
  double cycles;
  int updates, solutions, iterations;
  double volume[ARC_BODIES]; /* [mm3] */
  double p_peak;             /* [MPa] of the last cycle */
  double area;               /* [mm2] largest of the last cycle */
  double penetration[3];     /* [mm] of the head, under the largest load of the last cycle */
  double work;               /* [N mm] sum of p |s| dA over a cycle, the last one's */
  double loss;               /* [mm3] sum over updates of cycles k p |s| dA: both volumes */
} arc_joint_record;

/* One update of `cycles` cycles: explicit or sweeping over the instants, backwards in every second
 * update. On failure the joint is as it was, and the record too. */
arc_status arc_joint_update(arc_joint *joint, const arc_joint_wear_def *def, double cycles,
                            const arc_callbacks *callbacks, arc_joint_record *record,
                            arc_error *error);
/* A step whose error is held, of `most` cycles at the most: two updates of half its length against
 * one of the whole, whose depths differ by `tolerance`, at the most, of what all cycles so far
 * would take at this step's pace. *step [cycles]: what to try, then what to try next.
 * ARC_NOT_CONVERGED where no length does. On failure all is as it was. */
arc_status arc_joint_advance(arc_joint *joint, const arc_joint_wear_def *def, double tolerance,
                             double most, double *step, const arc_callbacks *callbacks,
                             arc_joint_record *record, arc_error *error);

/* All that a joint of the same definition needs to go on to the same bits: [count] numbers; and
 * back from what may be anybody's: ARC_FORMAT, ARC_MEMORY (pressures to start from may be lost). */
size_t arc_joint_state_count(const arc_joint *joint);
void arc_joint_state(const arc_joint *joint, double *state);
arc_status arc_joint_set_state(arc_joint *joint, const double *state, size_t count,
                               arc_error *error);
size_t arc_joint_bytes(const arc_joint *joint); /* about what it takes of memory */

/* Cycles that an explicit update may have at the most. */
double arc_joint_explicit_limit(const arc_joint *joint, const arc_joint_wear_def *def);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

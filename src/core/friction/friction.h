/* Coulomb friction in a contact problem: the tangential part of the contact matrix, the state
 * between increments of load and motion, and the solution of one increment.
 *
 * Shear forces t, like normal forces f, are given at the cylinder's nodes. On a surface with slope
 * m, t acts on the cylinder along the tangent (1, m), and -t acts on the plate. The shear traction
 * is q = t / w with the width w of the node. The slip ds is the motion of the plate's surface
 * relative to the cylinder's along +x. The subscripts n and t of the contact matrix A denote its
 * normal and tangential parts:
 *
 *   gap - approach + m (x - problem x) + A_nn f + A_nt t >= 0,  f >= 0,  f gap = 0
 *   ds = dx + m d(approach) - d(r),   r = A_tn f + A_tt t
 *   |t| <= mu f,   ds = 0 where |t| < mu f,   t ds >= 0
 *   sum (f + m t) = line,   sum (t - m f) = tangential, the force that drives the plate along x
 *
 * Therefore x, tangential, q and ds are all positive for a plate that is pushed along +x. d denotes
 * the change in the increment (backward Euler). r is the tangential displacement of the cylinder
 * relative to the plate; its value before the increment is computed for the pairs of surface points
 * that face each other at the end of the increment. */
#ifndef FRICTION_FRICTION_H
#define FRICTION_FRICTION_H

#include "core/contact/contact_problem.h"

/* The problem of the shear forces t at constant pressures: minimise t'A_tt t / 2 - drive't subject
 * to |t| <= bound. If by_force is set, sum t = total is a further constraint, and `shift` is its
 * Lagrange multiplier (shear.c). Arrays have one value for each of the n nodes in contact. */
typedef struct shear_problem {
  int n;
  const int *at;   /* [n] indices of the candidate nodes in contact */
  const double *a; /* matrix A_tt [ld x ld] of all candidate nodes */
  int ld;
  int by_force;
  double total; /* [N/mm] tangential force */
  double shift; /* [mm] displacement of the plate under `total`; 0 if the motion is given */
  double *bound, *drive;
  double *t, *slip;
  int *direction; /* warm start and result: 0 if a node sticks, 1 or -1 if it slips along or against
                     x */
  int *list, *pick; /* [stuck] nodes that stick: indices among the candidates, and in `at` */
  int stuck;
  int factored; /* 1: `factor` and `ones` are valid for `list` and `a` */
  double *factor, *ones, *target;
  double *held, *pulled; /* shear forces of the nodes that slip; product A_tt t at the candidates */
  int iterations;
} shear_problem;

/* Tangential part of the contact matrix. Candidates are the cylinder nodes that may be in
 * contact. */
typedef struct tangential_compliance {
  int nc, np, count;
  long version; /* version of the problem for which the matrices were computed; 0: none */
  double x;
  int flat;   /* 1: all slopes of the surfaces are zero */
  double *nt; /* [count x count] A_nt: gaps per shear force [mm2/N] */
  double *tn; /* [count x count] A_tn: the transpose of A_nt */
  double *tt; /* [count x count] A_tt: tangential displacements per shear force [mm2/N] */
} tangential_compliance;

/* Workspace for solving an increment, which also contains the solution of the last one. One
 * workspace can be used for all contact problems of a model. */
typedef struct friction_workspace {
  int nc, np;
  double *gap;     /* [nc] gaps without shear at the plate position of the increment [mm] */
  double *sheared; /* [nc] changes A_nt t of the gaps caused by shear [mm], by candidate */
  double
      *before; /* [nc] relative tangential displacement r before the increment [mm], by candidate */
  double *t;   /* [nc] solution: shear forces [N/mm], by candidate */
  double *slip;    /* [nc] solution: slip ds [mm] of all candidates; 0 where nodes stick */
  double *reserve; /* [nc] solution: additional shear force that would make a node slip in the
                      direction of the plate's motion [N/mm], by candidate; 0 where nodes slip */
  double *dragged; /* [nc] tangential displacement [mm], by candidate: A_tn f, caused by normal
                      forces, or r, caused by all forces */
  double *work;    /* [4 * (nc + np)] workspace for displacements */
  shear_problem shear;
  const tangential_compliance
      *compliance; /* matrices for which the factor of the shear problem was computed */
  long version;
  double x;
  double *coupled;          /* [(2 nc) x (2 nc + 3)] workspace of friction_newton.c */
  int *pivots;              /* [6 * nc] workspace of friction_newton.c */
  int sweeps_before_newton; /* number of sweeps before Newton's method (friction_newton.c) is tried:
                               4, more in tests */
  int by_force;   /* number of sweeps before friction_force_control.c is used: 50, but 0 in tests */
  int sweeps;     /* number of sweeps of the last increment */
  int iterations; /* number of active-set iterations in all sweeps */
  int newton;     /* 1: friction_newton.c solved the increment */
  int bracketed;  /* 1: friction_force_control.c was used */
} friction_workspace;

/* Terms of even order [mm] and odd order [N] of the error at one end of the sum in
 * slip_energy.c. */
typedef struct friction_terms {
  double even, odd;
} friction_terms;

/* A reversal of the plate's motion: the tangential force at the reversal [N/mm], and the energy
 * correction (slip_energy.c) of the motion before the reversal [N]. */
typedef struct friction_turn {
  double force, energy;
} friction_turn;

/* History of the plate's motion under a constant load; see friction_hysteresis.c. */
enum { ARC_FRICTION_TURNS = 64 };
typedef struct friction_memory {
  int sense; /* direction of the present motion: 1 along x, -1 against x, 0 if it is unknown or the
                load changes */
  int fresh; /* 1: the first motion began with no or little shear */
  int count; /* number of stored reversals; the force at each lies between the forces at the two
                before it */
  friction_turn turn[ARC_FRICTION_TURNS];
  double energy; /* [N] energy correction of the present motion */
} friction_memory;

/* State of a contact with friction between increments. The next solution depends on this state
 * only. */
typedef struct friction_state {
  int nc, np;
  double x;          /* [mm] position of the plate's base */
  double approach;   /* [mm] approach of the bodies */
  double line;       /* [N/mm] load per thickness */
  double tangential; /* [N/mm] tangential force per thickness */
  double energy;     /* [N] energy dissipated in all increments, per thickness */
  double between;    /* [N] part of `energy` dissipated by slip between the nodes: the energy
                        correction of slip_energy.c */
  friction_memory memory;
  double *f, *t;     /* [nc] normal and shear forces by cylinder node [N/mm] */
  double *slip;      /* [nc] slip ds of the last increment [mm] */
  double *slip_path; /* [nc] sum of ds over all increments [mm] */
  double
      *u[ARC_BODIES]; /* [2 * surface] displacements of the surfaces, first along x, then along y */
} friction_state;

/* Loads and position of the plate at the end of an increment. */
typedef struct friction_step {
  double mu;
  double line;       /* [N/mm] load per thickness; 0: the bodies are apart */
  int by_force;      /* 1: `tangential` is given; 0: x is given */
  double x;          /* [mm] position of the plate's base */
  double tangential; /* [N/mm] tangential force per thickness */
} friction_step;

/* Data of an increment during its solution. */
typedef struct friction_task {
  contact_problem *p;
  tangential_compliance *g;
  friction_workspace *w;
  const friction_step *step;
  const friction_state *from;
  double approach; /* [mm] approach before the increment; if the bodies were apart, the approach of
                      first contact */
  int by_force;    /* 1: the tangential force is given; 0: the motion is given */
  double
      dx; /* [mm] displacement of the plate, to which w->shear.shift is added under a given force */
  double change;      /* [-] relative change of the gaps in the last sweep */
  double shift, held; /* values for which the gaps were computed: displacement of the plate [mm],
                         and part of the load carried by shear on inclined surfaces [N/mm] */
  int over; /* 1: the given tangential force exceeds the limit of friction at the present pressures
             */
} friction_task;

/* --- shear.c ---------------------------------------------------------------------------------- */

/* Solves the shear problem. Returns 1 if solved, 0 if the iteration does not converge, -1 if A_tt
 * is not positive definite. */
int arc_shear_solve(shear_problem *s);
/* Lists the nodes that stick (direction = 0) in `list` and `pick`. Computes the Cholesky factor of
 * A_tt for these nodes, and `ones`, the forces of these nodes per unit displacement of the plate.
 * Returns non-zero if A_tt is not positive definite. */
int arc_shear_factorise(shear_problem *s);

/* --- tangential_compliance.c ------------------------------------------------------------------ */

arc_status arc_tangential_create(tangential_compliance *g, const arc_model *model);
void arc_tangential_free(tangential_compliance *g);
size_t arc_tangential_bytes(const tangential_compliance *g);
/* Updates the tangential matrices after an update of the contact problem. `work` [2 * (nc + np)] is
 * a workspace. */
void arc_tangential_update(tangential_compliance *g, const contact_problem *p, double *work);

/* Computes result [count] = A_nt t, the changes of the gaps caused by shear forces, by
 * candidate. */
void arc_tangential_gaps(const tangential_compliance *g, const double *t, double *result);
/* arc_tangential_drag computes r = A_tn f at the candidates first .. last - 1,
 * arc_tangential_drag_all r = A_tn f + A_tt t at all candidates. */
void arc_tangential_drag(const tangential_compliance *g, const double *f, int first, int last,
                         double *r);
void arc_tangential_drag_all(const tangential_compliance *g, const double *f, const double *t,
                             double *r);
/* Computes r, the tangential displacement of the cylinder relative to the plate, by candidate, from
 * the displacements u of both surfaces. `work` [np] is a workspace. */
void arc_tangential_relative(const contact_problem *p, double *const u[ARC_BODIES], double *work,
                             double *r);
/* Computes the displacements u of both surfaces under normal forces f and shear forces t, both [nc]
 * by cylinder node. If `flat` is true, displacements along y are not needed and not computed.
 * `work` [4 * (nc + np)] is a workspace. */
void arc_tangential_displace(const contact_problem *p, int flat, const double *f, const double *t,
                             double *const u[ARC_BODIES], double *work);

/* --- friction_workspace.c --------------------------------------------------------------------- */

arc_status arc_friction_workspace_create(friction_workspace *w, const arc_model *model);
void arc_friction_workspace_free(friction_workspace *w);
size_t arc_friction_workspace_bytes(const friction_workspace *w);

/* --- friction_state.c ------------------------------------------------------------------------- */

/* Creates an unloaded state with the plate's base at x [mm]. */
arc_status arc_friction_create(friction_state *s, const arc_model *model, double x);
void arc_friction_free(friction_state *s);
/* Resets a state to the unloaded state with the plate's base at x [mm]. */
void arc_friction_reset(friction_state *s, double x);
void arc_friction_copy(friction_state *to, const friction_state *from);
/* Returns the size [bytes] of all arrays of a state, which are one block that begins at f. */
size_t arc_friction_bytes(const friction_state *s);

/* Returns the default number of increments in which the load is applied: four for each element in
 * the half width of the contact, at least 20 and at most 400. */
int arc_friction_press_increments(const arc_model *model, double load);
/* Returns step i of the n steps in which the load of `to` is applied. The width of the contact
 * grows in equal increments. */
friction_step arc_friction_pressing(const friction_step *to, int i, int n);

/* --- friction.c ------------------------------------------------------------------------------- */

/* Solves one increment from the state `s` to `step` and updates the state. Before the call, the
 * problem must be updated for the plate position step->x, or for a position near it if the plate
 * moves little, as under a given force. The position of this update determines which points of both
 * surfaces face each other. The solution is written to p->f, p->approach, w->t and w->slip; p->gap
 * then includes the displacements caused by shear. On ARC_ARGUMENT (friction does not carry the
 * tangential force), ARC_ZONE and ARC_NUMERIC the state is unchanged. */
arc_status arc_friction_solve(contact_problem *p, tangential_compliance *g, friction_workspace *w,
                              const friction_step *step, friction_state *s, arc_error *error);

/* Writes the normal and shear forces of the solution on a body's surface [N/mm] in the order of
 * arc_contact_problem_forces_on. */
void arc_friction_forces_on(const contact_problem *p, friction_workspace *w, arc_body body,
                            double *force);

/* Solves for pressures and shear alternately, under a given force or motion, in at most `limit`
 * sweeps. Returns 1 if solved, 0 if not, -1 if one of the two solvers fails. */
int arc_friction_sweeps(friction_task *k, int limit);

/* Returns the slip ds of a candidate [mm] for the relative tangential displacement w->dragged. */
double arc_friction_slip(const friction_task *k, int candidate);

/* --- friction_force_control.c ----------------------------------------------------------------- */

/* Solves for the motion of the plate that causes a given tangential force. It is used if the sweeps
 * do not converge. Returns 1 if solved, else 0. */
int arc_friction_bracket(friction_task *k);

/* --- friction_hysteresis.c -------------------------------------------------------------------- */

/* Records a reversal of the motion if there is one. Must be called before the forces of the
 * increment are stored in the state. */
void arc_friction_turn(const friction_task *k, friction_state *s);
/* Removes the hysteresis loops that the present motion has closed, and adds the part of their
 * energy correction that has not been added yet. */
void arc_friction_close_loops(friction_state *s);
/* Returns the rise of the tangential force [N/mm] for which a first motion, on surfaces without
 * shear, is equivalent to the present motion up to `force` [N/mm]: half of the change of force
 * after a reversal. */
double arc_friction_rise(const friction_memory *m, double force);

/* --- slip_energy.c ---------------------------------------------------------------------------- */

/* Adds the energy correction of an increment to the state, and computes w->reserve. */
void arc_friction_between(friction_task *k, friction_state *s);

/* --- friction_newton.c ------------------------------------------------------------------------ */

/* Solves for pressures and shear together by semismooth Newton, beginning with the sets of the last
 * sweep (friction_newton.c). Returns 1 if solved. Otherwise returns 0 and restores the shear, the
 * slip, the active set and the motion of the last sweep. */
int arc_friction_newton(friction_task *k);

#endif

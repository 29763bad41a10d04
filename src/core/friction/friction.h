/* Coulomb friction on a problem: what it adds to the contact matrix, what it remembers, and one
 * increment of load and motion.
 *
 * Shear forces t belong to the cylinder's nodes as f do. t acts on the cylinder along (1, m), the
 * tangent in +x of the surface with slope m, and the opposite on the plate; q = t / w is the shear
 * traction. Slip ds is the motion of the plate's surface over the cylinder's along +x:
 *
 *   gap - approach + m (x - problem x) + A_nn f + A_nt t >= 0,  f >= 0,  f gap = 0
 *   ds = dx + m d(approach) - d(r),   r = A_tn f + A_tt t
 *   |t| <= mu f,   ds = 0 where |t| < mu f,   t ds >= 0
 *   sum (f + m t) = line,   sum (t - m f) = tangential, the force that drives the plate along x
 *
 * so that x, tangential, q and ds all have the sign of a plate that is pushed. d is the change over
 * the increment (backward Euler); r before it is made from the displacements that the points of
 * both surfaces had, whichever points face each other now.
 */
#ifndef FRICTION_FRICTION_H
#define FRICTION_FRICTION_H

#include "core/contact/contact_problem.h"

/* The shear problem with pressures held: min t'A t / 2 - drive't over |t| <= bound, where by_force
 * also sum t = total, with `shift` its multiplier (shear.c). Arrays of n, by node in contact. */
typedef struct shear_problem {
  int n;
  const int *at;   /* candidates */
  const double *a; /* A_tt [ld x ld] */
  int ld;
  int by_force;
  double total; /* [N/mm] */
  double shift; /* [mm] motion of the plate for `total`; 0 for a given motion */
  double *bound, *drive;
  double *t, *slip;
  int *direction;   /* 0 sticks, 1 and -1 slip along and against x; warm start and result */
  int *list, *pick; /* stuck nodes: candidates, positions */
  int stuck;
  int factored; /* 1 if factor and ones are valid for list and a */
  double *factor, *ones, *target;
  double *held, *pulled; /* forces of the nodes that slip; by candidate A_tt t */
  int iterations;
} shear_problem;

/* Solves the problem. Returns 1 if solved, 0 if not, -1 on breakdown. */
int arc_shear_solve(shear_problem *s);
/* Determines the nodes that stick from `direction`, and the forces that resist a unit of motion:
 * stuck, list, pick, factor, ones. Non-zero: broke down. */
int arc_shear_factorise(shear_problem *s);

/* Tangential part of the contact matrix of a problem. */
typedef struct tangential_compliance {
  int nc, np, count;
  long version; /* version of its problem; 0: none */
  double x;
  int flat;   /* 1 if there are no slopes */
  double *nt; /* [count x count] gaps under shear forces */
  double *tn; /* [count x count] its transpose */
  double *tt; /* [count x count] */
} tangential_compliance;

arc_status arc_tangential_create(tangential_compliance *g, const arc_model *model);
void arc_tangential_free(tangential_compliance *g);
size_t arc_tangential_bytes(const tangential_compliance *g);
/* Updates the matrices for an updated problem; work [2 * (nc + np)]. */
void arc_tangential_update(tangential_compliance *g, const contact_problem *p, double *work);

/* Workspace of an increment, with its solution until the next one; usable for all problems. */
typedef struct friction_workspace {
  int nc, np;
  double *gap;     /* [nc] gaps with the plate at the increment's x, without shear */
  double *sheared; /* [nc] A_nt t */
  double *before;  /* [nc] r before the increment, by candidate */
  double *t;       /* [nc] solution: shear forces [N/mm], by candidate */
  double *slip;    /* [nc] solution: ds [mm], by candidate, 0 where it sticks; open ones too */
  double *reserve; /* [nc] solution: shear until a node slips in the direction of the plate's motion
                      [N/mm], by candidate; 0 where it slips */
  double *dragged; /* [nc] A_tn f, or r of all forces; by candidate */
  double *work;    /* [4 * (nc + np)] */
  shear_problem shear;
  const tangential_compliance *compliance; /* problem of the shear problem's factor */
  long version;
  double x;
  double *coupled;          /* [(2 nc) x (2 nc + 3)] for friction_newton.c */
  int *pivots;              /* [6 * nc] for the same */
  int sweeps_before_newton; /* sweeps before the coupled iteration: 4, more in tests */
  int by_force;             /* sweeps before a given force is bracketed: 50, none in tests */
  int sweeps;               /* of the last increment */
  int iterations;           /* active sets of all sweeps */
  int newton;               /* 1 if solved by the coupled iteration */
  int bracketed;            /* 1 if the motion was bracketed for a given force */
} friction_workspace;

arc_status arc_friction_workspace_create(friction_workspace *w, const arc_model *model);
void arc_friction_workspace_free(friction_workspace *w);
size_t arc_friction_workspace_bytes(const friction_workspace *w);

/* Errors of a sum over nodes from its ends [mm, N], by order; see slip_energy.c. */
typedef struct friction_terms {
  double even, odd;
} friction_terms;

/* A reversal: its force [N/mm], and the energy between the nodes of the motion before it [N]. */
typedef struct friction_turn {
  double force, energy;
} friction_turn;

/* History of the plate's motion under one load; see friction_hysteresis.c. */
enum { ARC_FRICTION_TURNS = 64 };
typedef struct friction_memory {
  int sense; /* direction of the present motion: 1 along x, -1 against it; 0: load and motion change
                together */
  int fresh; /* 1 if the first motion started without shear */
  int count; /* turning points, each between the two previous ones */
  friction_turn turn[ARC_FRICTION_TURNS];
  double energy; /* [N] of the present motion */
} friction_memory;

/* State between increments; the next solution depends on nothing else. */
typedef struct friction_state {
  int nc, np;
  double x;          /* [mm] position of the plate's base */
  double approach;   /* [mm] */
  double line;       /* [N/mm] */
  double tangential; /* [N/mm] */
  double energy;     /* [N] dissipated per thickness, all increments */
  double between;    /* [N] part of it between the nodes (slip_energy.c) */
  friction_memory memory;
  double *f, *t;         /* [nc] forces by cylinder node [N/mm] */
  double *slip;          /* [nc] ds of the last increment [mm] */
  double *slip_path;     /* [nc] sum of ds [mm] */
  double *u[ARC_BODIES]; /* [2 * surface] displacements of the surfaces, along x, then along y */
} friction_state;

/* Creates an unloaded state with the plate's base at x [mm]. */
arc_status arc_friction_create(friction_state *s, const arc_model *model, double x);
void arc_friction_free(friction_state *s);
/* Resets to the unloaded state. */
void arc_friction_reset(friction_state *s, double x);
void arc_friction_copy(friction_state *to, const friction_state *from);
/* Size of its arrays, one block from f on [bytes]. */
size_t arc_friction_bytes(const friction_state *s);

/* Loads and position at the end of an increment. */
typedef struct friction_step {
  double mu;
  double line;       /* [N/mm]; 0: lifted off */
  int by_force;      /* `tangential` is given, else x */
  double x;          /* [mm] position of the plate's base */
  double tangential; /* [N/mm] */
} friction_step;

/* Increment i of n of pressing up to a step: the width of the contact grows in equal steps. */
/* Automatic number of these increments: four while the edge of contact crosses an element, at least
 * 20. */
int arc_friction_press_increments(const arc_model *model, double load);
friction_step arc_friction_pressing(const friction_step *to, int i, int n);

/* Goes one increment on from `s`, on a problem just brought up to date and measured at the position
 * where points face each other: step->x, or where the plate's motion is small (as under forces) any
 * near it. p->f, p->approach, w->t and w->slip hold the solution, p->gap the gaps with what shear
 * does to them. ARC_ARGUMENT (friction does not carry the tangential force), ARC_ZONE,
 * ARC_NUMERIC: the state is unchanged. */
arc_status arc_friction_solve(contact_problem *p, tangential_compliance *g, friction_workspace *w,
                              const friction_step *step, friction_state *s, arc_error *error);

/* Warns if friction and the difference of the materials are so large that the solution may not be
 * unique. */
void arc_friction_warn(const arc_model *model, double mu, const char *who,
                       const arc_callbacks *callbacks);

/* Forces of the solution on a body's surface [N/mm], as arc_contact_problem_forces_on. */
void arc_friction_forces_on(const contact_problem *p, friction_workspace *w, arc_body body,
                            double *force);

/* --- internal */

/* An increment being solved. */
typedef struct friction_task {
  contact_problem *p;
  tangential_compliance *g;
  friction_workspace *w;
  const friction_step *step;
  const friction_state *from;
  double approach; /* [mm] before the increment; from no contact, the position of first contact */
  int by_force;    /* 1 if the tangential force is given, 0 for the motion */
  double dx;       /* [mm] the plate's displacement; with a given force plus w->shear.shift */
  double change;   /* of the last sweep, see friction.c */
  double shift, held; /* motion [mm] and load carried by shear [N/mm], as used in the gaps */
  int over;           /* 1 if the last force exceeded friction */
} friction_task;

/* Solves for pressures and shear alternately, for a given force or motion. Returns 1 if solved, 0
 * if not, -1 on breakdown. */
int arc_friction_sweeps(friction_task *k, int limit);
/* Solves for a given force by its motion (friction_force_control.c), if the sweeps do not converge.
 */
int arc_friction_bracket(friction_task *k);

/* Records turning points, before the forces of the increment are stored. */
void arc_friction_turn(const friction_task *k, friction_state *s);
/* Removes loops that the present motion has closed, and adds the rest of their energy. */
void arc_friction_close_loops(friction_state *s);
/* Progress of the present motion as the equivalent force on surfaces without shear [N/mm]. */
double arc_friction_rise(const friction_memory *m, double force);

/* Adds the energy dissipated between the nodes, and computes their reserves. */
void arc_friction_between(friction_task *k, friction_state *s);

/* ds of a candidate [mm] under the forces of w->dragged. */
double arc_friction_slip(const friction_task *k, int candidate);

/* Solves for pressures and shear together by semismooth Newton, from the sets of the last sweep
 * (friction_newton.c). Returns 1 if solved, else 0; then only p's set and w's directions have
 * changed. */
int arc_friction_newton(friction_task *k);

/* result [count] := A_nt t, by candidate. */
void arc_tangential_gaps(const tangential_compliance *g, const double *t, double *result);
/* r := A_tn f at candidates first .. last - 1; A_tn f + A_tt t at all of them. */
void arc_tangential_drag(const tangential_compliance *g, const double *f, int first, int last,
                         double *r);
void arc_tangential_drag_all(const tangential_compliance *g, const double *f, const double *t,
                             double *r);
/* r of displacements u on a problem, by candidate; work [np]. */
void arc_tangential_relative(const contact_problem *p, double *const u[ARC_BODIES], double *work,
                             double *r);
/* Displacements of both surfaces under forces f, t [nc] by cylinder node; work [4 * (nc + np)]. */
void arc_tangential_displace(const contact_problem *p, int flat, const double *f, const double *t,
                             double *const u[ARC_BODIES], double *work);

#endif

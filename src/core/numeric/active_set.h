/* Contact as a convex problem with rigid unknowns: g = A p + gap - N delta >= 0, p >= 0, p g = 0,
 * sum over cells of area N p = load for several blocks at once (positions of a stroke), each of the
 * same cells, with `modes` rigid unknowns delta and its own loads. A may couple the blocks; it is
 * self-adjoint and positive in <p, q> = sum over blocks of weight, over cells of area p q. The
 * method is a primal-dual active set with conjugate gradients; projections conserve the loads. If
 * sets repeat, steps of Polonsky and Keer's method, which decrease the energy, replace it. */
#ifndef NUMERIC_ACTIVE_SET_H
#define NUMERIC_ACTIVE_SET_H

#include "core/base/team.h"

enum { ARC_MOST_MODES = 3 };

/* to := A from, all blocks [blocks * cells]. Returns ARC_OK or the error that ends the solution. */
typedef arc_status (*operator_fn)(void *context, const double *from, double *to);

typedef struct active_problem {
  int blocks, cells, modes;
  const double *gap;    /* [blocks][cells] */
  const double *area;   /* [cells]; NULL: 1 */
  const double *mode;   /* N [modes][cells]; NULL: one mode, 1 everywhere */
  const double *load;   /* [blocks][modes] */
  const double *weight; /* [blocks]; NULL: 1 */
  operator_fn apply;
  operator_fn precondition; /* approximate inverse of A, positive definite; NULL: none */
  void *context;            /* of both */
  double tolerance;         /* of gaps, relative to the largest displacement A p */
  work_team *team;          /* threads for the blocks; NULL: none */
} active_problem;

/* Cost of a solution. */
typedef struct active_count {
  int iterations;   /* steps of conjugate gradients */
  int applications; /* of A */
  int sets;         /* active sets */
  int guarded;      /* steps of Polonsky and Keer's method */
} active_count;

typedef struct active_work active_work;

/* A workspace for problems up to this size. NULL: no memory. */
active_work *arc_active_work_create(int blocks, int cells, int modes, int preconditioned);
void arc_active_work_destroy(active_work **work);

/* Solves with the initial p [blocks][cells], which is positive in some cell of every block and
 * determines the first active set. p and delta [blocks][modes] are the solution; the gaps are in
 * the workspace. ARC_NOT_CONVERGED, ARC_NUMERIC, or the error of `apply`: p is undefined then. Adds
 * to *count. */
arc_status arc_active_set_solve(const active_problem *problem, active_work *work, double *p,
                                double *delta, active_count *count, arc_error *error);

/* Gaps of the last solution [blocks][cells]. */
const double *arc_active_set_gaps(const active_work *work);

/* On the active set {p > 0} of a solution: dp [blocks][cells] with A dp + gap - N delta = 0 there,
 * 0 elsewhere, and no loads; problem->tolerance is relative to `gap`, problem->load unused. */
arc_status arc_active_set_tangent(const active_problem *problem, active_work *work, const double *p,
                                  double *dp, active_count *count, arc_error *error);

#endif

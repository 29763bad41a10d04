/* Contact as a convex problem with rigid unknowns:
 *
 *   g = A p + gap - N delta >= 0,  p >= 0,  p g = 0,  sum over cells of area N p = load
 *
 * for several blocks at once (positions of a stroke), each of the same cells, with `modes` rigid
 * unknowns delta and loads of its own. A may couple the blocks; it is self-adjoint and positive in
 * <p, q> = sum over blocks of weight, over cells of area p q.
 *
 * A primal-dual active set with conjugate gradients inside; the loads are held by projection.
 * Should sets come back, steps of Polonsky and Keer's method take over, which lower the energy.
 */
#ifndef NUMERIC_ACTIVE_SET_H
#define NUMERIC_ACTIVE_SET_H

#include "core/base/team.h"

enum { ARC_MOST_MODES = 3 };

/* to := A from, all blocks [blocks * cells]. ARC_OK or the reason to stop. */
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
  work_team *team;          /* shares the work on blocks; NULL: none */
} active_problem;

/* Work of a solution. */
typedef struct active_count {
  int iterations;   /* steps of conjugate gradients */
  int applications; /* of A */
  int sets;         /* active sets */
  int guarded;      /* steps of the method that takes over */
} active_count;

typedef struct active_work active_work;

/* A workspace for problems up to this size. NULL: no memory. */
active_work *arc_active_work_create(int blocks, int cells, int modes, int preconditioned);
void arc_active_work_destroy(active_work **work);

/* Solves from p [blocks][cells], which in every block is positive somewhere and sets the first
 * active set. p and delta [blocks][modes] are the solution; the gaps g stay in the workspace.
 * ARC_NOT_CONVERGED, ARC_NUMERIC, or what `apply` returns: p is spoilt then. *count is added to. */
arc_status arc_active_set_solve(const active_problem *problem, active_work *work, double *p,
                                double *delta, active_count *count, arc_error *error);

/* Gaps of the last solution [blocks][cells]. */
const double *arc_active_set_gaps(const active_work *work);

/* On the active set {p > 0} of a solution: dp [blocks][cells] with A dp + gap - N delta = 0 there,
 * 0 elsewhere, and no loads; problem->tolerance is relative to `gap`, problem->load unused. */
arc_status arc_active_set_tangent(const active_problem *problem, active_work *work, const double *p,
                                  double *dp, active_count *count, arc_error *error);

#endif

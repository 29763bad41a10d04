/* Solves contact problems for the pressures p and the rigid unknowns delta, such as the approach.
 * The conditions are g = A p + gap - N delta >= 0, p >= 0 and p g = 0 in each cell, and the sum of
 * area N p over the cells equals the load. A is the compliance, and N the displacement of each cell
 * by a rigid unknown. Several blocks (positions of a stroke) of the same cells are solved at once.
 * Each block has `modes` rigid unknowns and its own loads. A may couple the blocks. A must be
 * self-adjoint and positive definite for the inner product of p and q, the sum of weight area p q
 * over all blocks and cells.
 *
 * The method is a primal-dual active set method with conjugate gradients, whose search directions
 * do not change the loads. If active sets repeat, it continues with Polonsky and Keer's method, in
 * which every step decreases the energy. */
#ifndef NUMERIC_ACTIVE_SET_H
#define NUMERIC_ACTIVE_SET_H

#include "core/base/team.h"

enum { ARC_MOST_MODES = 3 };

/* Computes `to` = A `from` for all blocks; both arrays are [blocks * cells]. Returns ARC_OK, or an
 * error that ends the solution. */
typedef arc_status (*operator_fn)(void *context, const double *from, double *to);

typedef struct active_problem {
  int blocks, cells, modes;
  const double *gap;    /* [blocks][cells] gaps at zero pressure */
  const double *area;   /* [cells] areas; NULL: all areas are 1 */
  const double *mode;   /* [modes][cells] values of N; NULL: one mode, which is 1 in all cells */
  const double *load;   /* [blocks][modes] loads */
  const double *weight; /* [blocks] weights of the inner product; NULL: all weights are 1 */
  operator_fn apply;
  operator_fn
      precondition; /* approximate inverse of A, positive definite; NULL: no preconditioner */
  void *context;    /* first argument of `apply` and `precondition` */
  double tolerance; /* tolerance of gaps, relative to the largest displacement A p */
  work_team *team;  /* threads for the blocks; NULL: only the calling thread */
} active_problem;

/* Numbers of iterations and operations of a solution. */
typedef struct active_count {
  int iterations;   /* number of steps of conjugate gradients */
  int applications; /* number of applications of A */
  int sets;         /* number of active sets */
  int guarded;      /* number of steps by Polonsky and Keer's method */
} active_count;

typedef struct active_work active_work;

/* --- active_steps.c --------------------------------------------------------------------------- */

/* Creates a workspace for problems up to the given size. Returns NULL if out of memory. */
active_work *arc_active_work_create(int blocks, int cells, int modes, int preconditioned);
void arc_active_work_destroy(active_work **work);

/* Returns the gaps of the last solution [blocks][cells]. */
const double *arc_active_set_gaps(const active_work *work);

/* --- active_set.c ----------------------------------------------------------------------------- */

/* Solves a problem. The initial p [blocks][cells] determines the first active set and must be
 * positive in some cell of every block. The solution is p and delta [blocks][modes]; the gaps are
 * in the workspace. On ARC_NOT_CONVERGED, ARC_NUMERIC, or an error of `apply`, p is undefined. Adds
 * the numbers of this solution to *count. */
arc_status arc_active_set_solve(const active_problem *problem, active_work *work, double *p,
                                double *delta, active_count *count, arc_error *error);

/* Computes the change dp [blocks][cells] of the pressures of a solution if its gaps change by
 * `gap`. On the active set {p > 0} of the solution, A dp + gap - N delta = 0. In other cells dp =
 * 0, and the loads do not change. problem->tolerance is relative to `gap`, and problem->load is not
 * used. */
arc_status arc_active_set_tangent(const active_problem *problem, active_work *work, const double *p,
                                  double *dp, active_count *count, arc_error *error);

#endif

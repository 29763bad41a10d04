/* Declares the workspace of the active set method, and the operations that it shares with Polonsky
 * and Keer's method. */
#ifndef NUMERIC_ACTIVE_WORK_H
#define NUMERIC_ACTIVE_WORK_H

#include "core/numeric/active_set.h"
#include "core/numeric/cells.h"

#include <stddef.h>

struct active_work {
  int blocks, cells, modes; /* size of the largest problem */
  double *g;                /* during a solution A p + gap, after it the gaps g */
  double *r;                /* residual on the active set */
  double *d;                /* search direction */
  double *q;                /* A d */
  double *area;             /* areas of the cells in the active set; 0 in other cells */
  double *z; /* preconditioned residual; without a preconditioner the same array as r */
  double *y; /* [blocks][modes][cells] preconditioned modes N; NULL without a preconditioner */
  double *mode, *whole;   /* default modes N and default areas, which are 1 in all cells */
  double *gram, *oblique; /* [blocks][modes][modes] inverses of N' N and N' y on the active set */
  double *delta;          /* [blocks][modes] rigid unknowns */
  double *sum;            /* [blocks] partial sums of a pass over the blocks */
  double *largest;        /* [blocks] largest displacement or overlap */
  int *changes;           /* [blocks] number of cells that enter or leave the active set */
  int *singular; /* [blocks] true if the active set does not determine the rigid unknowns */
  unsigned long long *hash; /* [blocks] hash of the active set */
};

/* Arguments of the tasks on blocks. */
typedef struct pass {
  const active_problem *problem;
  active_work *w;
  double *p;
  double factor; /* step length, or factor of the previous search direction */
  double limit;  /* tolerance of gaps */
} pass;

static inline size_t active_at(const pass *s, int block) {
  return (size_t)block * (size_t)s->problem->cells;
}

/* --- active_steps.c --------------------------------------------------------------------------- */

void arc_active_run(const pass *s, team_task task);
/* arc_active_mode returns mode j of N [cells], arc_active_areas the areas of the cells [cells]. */
const double *arc_active_mode(const pass *s, int j);
const double *arc_active_areas(const pass *s);
double arc_active_weight(const active_problem *p, int block);
/* arc_active_total returns the weighted sum of w->sum over the blocks, in a fixed order;
 * arc_active_changes returns the sum of w->changes. */
double arc_active_total(const pass *s);
int arc_active_changes(const pass *s);
/* Returns the gap of a cell during a solution: A p + gap - N delta. */
double arc_active_gap(const pass *s, int block, int cell);

/* Task for arc_active_run: multiplies p by 1 + N x, with x such that p carries the loads of the
 * block. */
void arc_active_restore_load(void *context, int block, int worker);
/* Tasks for arc_active_run. arc_active_mark sets the active set to {p > 0}. arc_active_factor
 * computes the inverses of the Gram matrices (`gram`, `oblique`) on the set. arc_active_residual
 * computes the residual on the set, and stores the sum of its squares in w->sum.
 * arc_active_curvature stores the product d A d in w->sum. */
void arc_active_mark(void *context, int block, int worker);
void arc_active_factor(void *context, int block, int worker);
void arc_active_residual(void *context, int block, int worker);
void arc_active_curvature(void *context, int block, int worker);

/* Subtracts a combination of the modes from x [cells], so that N' x is zero on the active set of a
 * block. Sets x to zero outside the set. */
void arc_active_project(const pass *s, int block, double *x);
/* Returns ARC_NUMERIC if the active set of a block does not determine the rigid unknowns. */
arc_status arc_active_check(const pass *s, arc_error *error);
arc_status arc_active_apply(const pass *s, const double *from, double *to, active_count *count);
/* Restores the loads, computes g = A p + gap and sets *limit to the tolerance of gaps. */
arc_status arc_active_gaps(const pass *s, double *limit, active_count *count, arc_error *error);
/* Prepares conjugate gradients on a changed active set: computes its preconditioned modes, its Gram
 * matrices and the residual. Errors: ARC_NUMERIC, errors of the preconditioner. */
arc_status arc_active_begin(const pass *s, arc_error *error);
/* Returns the root mean square of the residual on the active sets, from the sums of squares in
 * w->sum. */
double arc_active_rms(const pass *s);
/* Makes steps of conjugate gradients on the active set until the residual is at most `wanted`.
 * *product is the product of the residual and the preconditioned residual. The caller passes it on
 * unchanged in the next call on the same set, and sets it to 0 for a new set. */
arc_status arc_active_relax(pass *s, double wanted, double *product, active_count *count,
                            arc_error *error);

/* --- polonsky_keer.c -------------------------------------------------------------------------- */

/* Computes the solution by Polonsky and Keer's method, starting from p. Errors: ARC_NOT_CONVERGED,
 * ARC_NUMERIC, errors of `apply`. */
arc_status arc_active_guard(pass *s, active_count *count, arc_error *error);

#endif

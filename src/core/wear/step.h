/* Declares the plan and the outcome of a step of a run, and the functions that make the step. */
#ifndef WEAR_STEP_H
#define WEAR_STEP_H

#include "core/wear/run.h"

/* Plan of a step. */
typedef struct wear_plan {
  const wear_block *block;
  double cycles; /* number of cycles; the update may be shortened */
  double
      times;   /* factor on the wear of the window: number of cycles, or fraction of an increment */
  double end;  /* distance at the end of the step [mm] */
  double most; /* the step ends early if the integral of k over the distance reaches this value
                  [mm3/N] */
  int first;   /* index of the increment in a loading that does not repeat, otherwise 0 */
  int explicit;                     /* 1 for an explicit step of an implicit run */
  int staged;                       /* 1 for an explicit step in stages, with an error estimate */
  const arc_wear_record *end_state; /* final state of an earlier attempt at this step; NULL: none */
} wear_plan;

/* Coefficients of wear and friction, which may change during a run. */
typedef struct wear_coefficients {
  double k[ARC_BODIES]; /* wear coefficients [mm2/N] */
  double friction;      /* friction coefficient [-] */
} wear_coefficients;

/* Outcome of a step. */
typedef struct wear_outcome {
  arc_shape *shape;
  arc_wear_record record;
  wear_coefficients
      predicted; /* coefficients predicted for the end of the step; NaN: no prediction */
} wear_outcome;

/* Number of cycles of an update, and its coefficients of wear and friction. */
typedef struct update_coefficients {
  double cycles;
  wear_coefficients mean;
  wear_coefficients last; /* coefficients predicted for the end of the update; NaN: no prediction */
  double friction_at_start; /* friction coefficient at the start of the update; the value after the
                               jump if it jumps there */
  const wear_plan
      *plan; /* plan of an update in which friction changes; NULL: friction is constant */
} update_coefficients;

/* --- step_length.c ---------------------------------------------------------------------------- */
/* Returns true if the run has neither reached the distance `limit` [mm] nor the end of its loading.
 */
int arc_wear_can_move(const arc_wear *w, double limit);
/* Plans the next step towards the distance `limit` [mm]. Sets *moved to arc_wear_can_move(w,
 * limit). */
arc_status arc_wear_plan_step(arc_wear *w, double limit, const arc_callbacks *callbacks,
                              wear_plan *plan, int *moved, arc_error *error);
/* Returns true if the law jumps, so that the run chooses the length of its explicit updates, and a
 * fixed jump is only their upper limit. */
int arc_wear_has_own_steps(const arc_wear *w);
/* Shortens a plan to the given number of cycles. */
void arc_wear_plan_shorten(const arc_wear *w, wear_plan *plan, double cycles);
/* Returns true if the wear of the plan is negligible compared with the wear of an automatic
 * update. */
int arc_wear_plan_is_short(const arc_wear *w, const wear_plan *plan);

/* --- predictor.c ------------------------------------------------------------------------------ */
/* Computes the depths that a wear rate causes in an update. */
void arc_wear_depths_of_rate(const arc_wear *w, const wear_rate *rate,
                             const update_coefficients *coefficients, wear_depths *depth);
/* Returns true if functions of the state are evaluated with intermediate pressures and widths
 * (updates of second order), false if they are evaluated with the values at the start. */
int arc_wear_follows(const arc_wear *w, const wear_plan *plan);
/* Returns the predicted state at the fraction `share` (0 to 1) of an update. If `rate` is not NULL,
 * the state includes the wear that this rate causes with the given coefficients. */
arc_wear_record arc_wear_state_within(arc_wear *w, const wear_plan *plan, double share,
                                      const wear_rate *rate,
                                      const update_coefficients *coefficients);
/* Computes the friction coefficient at the fraction `share` (0 to 1) of an update. If the
 * coefficient is constant, *mu is unchanged. */
arc_status arc_wear_friction_within(arc_wear *w, const update_coefficients *coefficients,
                                    double share, double *mu, arc_error *error);

/* --- coefficient_integral.c ------------------------------------------------------------------- */
/* Integrates the coefficients over a planned update: tables exactly, and functions along the
 * path that `rate` predicts (NULL: only distance and cycles change). Shortens the plan at a jump
 * of a coefficient, or where the integral of k reaches plan->most. */
arc_status arc_wear_integrate_coefficients(arc_wear *w, wear_plan *plan, const wear_rate *rate,
                                           update_coefficients *coefficients, arc_error *error);

/* --- stages.c --------------------------------------------------------------------------------- */
/* Accepted estimated error of an update in stages, relative to the largest depth. */
#define ARC_STAGED_TOLERANCE 3e-3
/* Returns the longest stable update in stages [cycles] for an eigenvalue [1/cycle]. */
double arc_wear_longest_staged(const arc_wear *w, double eigenvalue);
/* Computes the depths of an explicit update in stages, with an error estimate. The eigenvalue
 * [1/cycle] determines the number of stages. `rate` is the rate at the start; its contents are
 * overwritten. */
arc_status arc_wear_stages(arc_wear *w, const wear_window *window,
                           const update_coefficients *coefficients, double eigenvalue,
                           wear_progress *progress, wear_rate *rate, wear_depths *depth,
                           arc_error *error);

/* --- implicit.c ------------------------------------------------------------------------------- */
/* Computes the depths of an implicit update over a window, with an error estimate if the definition
 * has a tolerance. Errors: ARC_NOT_CONVERGED if the update must be shorter; errors of a contact
 * solution. */
arc_status arc_wear_implicit(arc_wear *w, const wear_window *window,
                             const update_coefficients *coefficients, wear_progress *progress,
                             wear_depths *depth, arc_error *error);

/* --- update.c --------------------------------------------------------------------------------- */
/* Makes the planned update on the shape of an outcome, which is a copy of the run's shape. The plan
 * may be shortened. Initially the record of the outcome is the last record of the run. It receives
 * the number of the update, the volumes, the coefficients and the error. */
arc_status arc_wear_update(arc_wear *w, wear_plan *plan, wear_progress *progress, wear_outcome *out,
                           arc_error *error);

/* Solves a cycle on the surfaces after an explicit update, and stores its largest pressure in the
 * record. The next update starts from this solution. */
arc_status arc_wear_solve_next_cycle(arc_wear *w, const wear_plan *plan, wear_outcome *out,
                                     const arc_callbacks *callbacks, arc_error *error);

/* --- stability.c ------------------------------------------------------------------------------ */
/* Warns about a definition before the run continues. Each definition is checked once. */
void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks);
/* Returns ARC_NOT_CONVERGED if a step was longer than the stability limit and the pressures at
 * neighbouring nodes differ by more than half of their mean. */
arc_status arc_wear_refuse_ripples(arc_wear *w, const wear_plan *plan, const wear_outcome *out,
                                   const arc_callbacks *callbacks, arc_error *error);
/* Warns once per definition if the last update was longer than the stability limit. Computes the
 * limit again if the wear coefficients or the block of loading have changed. */
void arc_wear_warn_of_ripples(arc_wear *w, const wear_block *block, const arc_callbacks *callbacks);

#endif

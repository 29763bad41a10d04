/* A step of a run: plan and outcome. */
#ifndef WEAR_STEP_H
#define WEAR_STEP_H

#include "core/wear/run.h"

/* Plan of a step. */
typedef struct wear_plan {
  const wear_block *block;
  double cycles; /* cycles of the step; the update may use fewer */
  double times;  /* factor on the wear of the window: cycles, or share of an increment */
  double end;    /* distance at the end of the step [mm] */
  double most;   /* the step ends at this integral of k over the distance [mm3/N] */
  int first;     /* generic history: the increment */
  int explicit;  /* explicit step of an implicit run */
  int staged;    /* explicit, in stages, with an estimate of its error */
  const arc_wear_record *end_state; /* the state at the end, by an attempt; NULL: none yet */
} wear_plan;

/* Coefficients that may change during a run. */
typedef struct wear_coefficients {
  double k[ARC_BODIES]; /* of wear [mm2/N] */
  double friction;      /* [-] */
} wear_coefficients;

/* Outcome of a step. */
typedef struct wear_outcome {
  arc_shape *shape;
  arc_wear_record record;
  wear_coefficients predicted; /* for the end of the step; NaN: unpredictable */
} wear_outcome;

/* Cycles and coefficients of an update. */
typedef struct update_coefficients {
  double cycles;
  wear_coefficients mean;
  wear_coefficients last;   /* predicted for the end of the update; NaN: unpredictable */
  double friction_at_start; /* after a jump there */
  const wear_plan *plan;    /* on which friction changes; NULL: it is constant */
} update_coefficients;

/* --- step_length.c ---------------------------------------------------------------------------- */
/* Plans the next step towards `limit` [mm] and enters its block. *moved: 1 unless the limit is
 * reached. */
arc_status arc_wear_plan_step(arc_wear *w, double limit, const arc_callbacks *callbacks,
                              wear_plan *plan, int *moved, arc_error *error);
/* Fewer cycles. */
void arc_wear_plan_shorten(const arc_wear *w, wear_plan *plan, double cycles);
/* True if the wear of the plan is negligible compared with automatic updates. */
int arc_wear_plan_is_short(const arc_wear *w, const wear_plan *plan);

/* --- predictor.c ------------------------------------------------------------------------------ */
/* Depths of a rate over an update. */
void arc_wear_depths_of_rate(const arc_wear *w, const wear_rate *rate,
                             const update_coefficients *coefficients, wear_depths *depth);
/* True if functions of the state are evaluated with intermediate pressures and widths (updates of
 * second order), not with those at the start. */
int arc_wear_follows(const arc_wear *w, const wear_plan *plan);
/* The state at a share of an update; with a rate, also the depths at these coefficients. */
arc_wear_record arc_wear_state_within(arc_wear *w, const wear_plan *plan, double share,
                                      const wear_rate *rate,
                                      const update_coefficients *coefficients);
/* The coefficient of friction at a share of an update; *mu is unchanged if it is constant. */
arc_status arc_wear_friction_within(arc_wear *w, const update_coefficients *coefficients,
                                    double share, double *mu, arc_error *error);

/* --- coefficient_integral.c ------------------------------------------------------------------- */
/* The coefficients over a planned update, integrated: tables exactly, functions along the path
 * predicted by `rate` (NULL: distance and cycles only). Shortens the plan at a jump of a
 * coefficient, or where `most` is reached. */
arc_status arc_wear_integrate_coefficients(arc_wear *w, wear_plan *plan, const wear_rate *rate,
                                           update_coefficients *coefficients, arc_error *error);

/* --- stages.c --------------------------------------------------------------------------------- */
/* Accepted estimated error of an update in stages, relative to the depth. */
#define ARC_STAGED_TOLERANCE 3e-3
/* The longest stable update in stages [cycles], at an eigenvalue [1/cycle]. */
double arc_wear_longest_staged(const arc_wear *w, double eigenvalue);
/* Depths of an explicit update in the number of stages given by the eigenvalue, with an error
 * estimate. `rate` is that at the start; it is overwritten. */
arc_status arc_wear_stages(arc_wear *w, const wear_window *window,
                           const update_coefficients *coefficients, double eigenvalue,
                           wear_progress *progress, wear_rate *rate, wear_depths *depth,
                           arc_error *error);

/* --- implicit.c ------------------------------------------------------------------------------- */
/* Depths of an implicit update over a window, with an error estimate if the definition has a
 * tolerance. ARC_NOT_CONVERGED: try fewer cycles. */
arc_status arc_wear_implicit(arc_wear *w, const wear_window *window,
                             const update_coefficients *coefficients, wear_progress *progress,
                             wear_depths *depth, arc_error *error);

/* --- update.c --------------------------------------------------------------------------------- */
/* Wears the shape of an outcome (a copy of the run's) by the plan, which may be shortened. Updates,
 * volumes, coefficients and error are added to its record (initially that of the run). */
arc_status arc_wear_update(arc_wear *w, wear_plan *plan, wear_progress *progress, wear_outcome *out,
                           arc_error *error);

/* Solves a cycle on the surfaces after an explicit update, with which the next one starts, and
 * records its largest pressure. */
arc_status arc_wear_solve_next_cycle(arc_wear *w, const wear_plan *plan, wear_outcome *out,
                                     const arc_callbacks *callbacks, arc_error *error);

/* --- stability.c ------------------------------------------------------------------------------ */
/* Gives the warnings about a definition, once, before the run continues. */
void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks);
/* Warns once per definition if the last update exceeded the stability limit; recomputes the limit
 * if coefficients or path have changed. */
/* Refuses an outcome whose pressures jump between neighbours by half of their mean, after a step
 * past the stability limit: ARC_NOT_CONVERGED. */
arc_status arc_wear_refuse_ripples(arc_wear *w, const wear_plan *plan, const wear_outcome *out,
                                   const arc_callbacks *callbacks, arc_error *error);
void arc_wear_warn_of_ripples(arc_wear *w, const wear_block *block, const arc_callbacks *callbacks);

#endif

/* A step of a run, from the plan to what it leads to. */
#ifndef WEAR_STEP_H
#define WEAR_STEP_H

#include "core/wear/run.h"

/* What a step is about to do. */
typedef struct wear_plan {
  const wear_block *block;
  double cycles; /* so many cycles go by; the update may take fewer */
  double times;  /* what the wear of the window counts: cycles, or the share of an increment */
  double end;    /* distance at which the step ends [mm] */
  double most;   /* the step ends where k has come to this integral over the distance [mm3/N] */
  int first;     /* generic history: the increment */
  int explicit;  /* although the scheme is implicit */
  int staged;    /* explicit, in stages, with an estimate of its error */
  const arc_wear_record *ahead; /* the state at the end, by an attempt; NULL: none yet */
} wear_plan;

/* What may change on the way: the wear coefficients of both bodies [mm2/N], that of friction. */
enum { WEAR_FRICTION = ARC_BODIES, WEAR_COEFFICIENTS };

/* What it leads to. */
typedef struct wear_outcome {
  arc_shape *shape;
  arc_wear_record record;
  double foreseen[WEAR_COEFFICIENTS]; /* those expected at the end */
} wear_outcome;

/* So many cycles at these wear coefficients [mm2/N]. */
typedef struct wear_dose {
  double cycles;
  double k[ARC_BODIES];
  double last[WEAR_COEFFICIENTS]; /* as foreseen for the end of an update; NaN: unforeseeable */
  const wear_plan *plan;          /* on which friction changes; NULL: it does not */
  double begin, friction;         /* coefficient it begins with, and its mean */
} wear_dose;

/* --- step_length.c --- */
/* The next step towards `limit` [mm]; enters its block. *moved: whether there is anything left to
 * do. */
arc_status arc_wear_plan_step(arc_wear *w, double limit, const arc_callbacks *callbacks,
                              wear_plan *plan, int *moved, arc_error *error);
/* Fewer cycles. */
void arc_wear_plan_shorten(const arc_wear *w, wear_plan *plan, double cycles);
/* Whether it is to wear next to nothing, beside what automatic updates do. */
int arc_wear_plan_is_short(const arc_wear *w, const wear_plan *plan);

/* --- predictor.c --- */
/* What a rate takes in a dose. */
void arc_wear_depths_of_rate(const arc_wear *w, const wear_rate *rate, const wear_dose *dose,
                             wear_depths *depth);
/* Whether functions of the state are asked with the pressures and widths of the way, rather than
 * those of its start: in updates of second order. */
int arc_wear_follows(const arc_wear *w, const wear_plan *plan);
/* The state a share of the way through an update; with a rate, also what it takes in a dose. */
arc_wear_record arc_wear_on_the_way(arc_wear *w, const wear_plan *plan, double share,
                                    const wear_rate *rate, const wear_dose *dose);
/* The coefficient of friction a share of the way through a dose, where it changes; else *mu stays.
 */
arc_status arc_wear_friction_on_the_way(arc_wear *w, const wear_dose *dose, double share,
                                        double *mu, arc_error *error);

/* --- coefficient_integral.c --- */
/* The coefficients over a planned update, integrated: tables exactly, functions along the way
 * that `rate` predicts (NULL: distance and cycles only). Shortens the plan to where a coefficient
 * jumps, or to where `most` is reached. */
arc_status arc_wear_dose(arc_wear *w, wear_plan *plan, const wear_rate *rate, wear_dose *dose,
                         arc_error *error);

/* --- stages.c --- */
/* Estimated error of an update in stages that is let pass, as a share of the depth. */
#define ARC_STAGED_TOLERANCE 3e-3
/* The longest update that stages can take [cycles], at an eigenvalue [1/cycle]. */
double arc_wear_longest_staged(const arc_wear *w, double eigenvalue);
/* Depths of an explicit update in as many stages as the eigenvalue asks for, with an estimate of
 * their error. `rate` is that of the start, and is overwritten. */
arc_status arc_wear_stages(arc_wear *w, const wear_window *window, const wear_dose *dose,
                           double eigenvalue, wear_watch *watch, wear_rate *rate,
                           wear_depths *depth, arc_error *error);

/* --- implicit.c --- */
/* Depths of an implicit update over a window, with an estimate of their error where the definition
 * has a tolerance. ARC_NOT_CONVERGED: try fewer cycles. */
arc_status arc_wear_implicit(arc_wear *w, const wear_window *window, const wear_dose *dose,
                             wear_watch *watch, wear_depths *depth, arc_error *error);

/* --- update.c --- */
/* Wears the shape of an outcome, a copy of the run's, as planned or less: the plan then tells how
 * far. Its record, that of the run at first, gains updates, volumes, coefficients and error. */
arc_status arc_wear_update(arc_wear *w, wear_plan *plan, wear_watch *watch, wear_outcome *out,
                           arc_error *error);

/* Solves a cycle on the surfaces an explicit update led to, which the next one begins with, and
 * notes its largest pressure. */
arc_status arc_wear_solve_next_cycle(arc_wear *w, const wear_plan *plan, wear_outcome *out,
                                     const arc_callbacks *callbacks, arc_error *error);

/* --- stability.c --- */
/* Tells, once for a definition, what speaks against this run before it goes on. */
void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks);
/* Tells, once for a definition, that the last update, of this block, was longer than is stable;
 * looks where its coefficients have grown, or the path changed, since the last look. */
/* Refuses an outcome whose pressures jump between neighbours by half of their mean, after a step
 * past the stability limit: ARC_NOT_CONVERGED. */
arc_status arc_wear_refuse_ripples(arc_wear *w, const wear_plan *plan, const wear_outcome *out,
                                   const arc_callbacks *callbacks, arc_error *error);
void arc_wear_watch_ripples(arc_wear *w, const wear_block *block, const arc_callbacks *callbacks);

#endif

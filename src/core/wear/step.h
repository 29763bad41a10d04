/* A step of a run, from the plan to what it leads to. */
#ifndef WEAR_STEP_H
#define WEAR_STEP_H

#include "core/wear/rate.h"

/* What a step is about to do. */
typedef struct wear_plan {
  const wear_block *block;
  double cycles; /* so many cycles go by; an implicit step may take fewer */
  double times;  /* what the wear of the window counts: cycles, or the share of an increment */
  double end;    /* distance at which the step ends [mm] */
  int first;     /* generic history: the increment */
  int explicit;  /* although the scheme is implicit */
} wear_plan;

/* What it leads to. */
typedef struct wear_outcome {
  arc_shape *shape;
  arc_wear_record record;
} wear_outcome;

/* So many cycles at these wear coefficients [mm2/N]. */
typedef struct wear_dose {
  double cycles;
  double k[ARC_BODIES];
} wear_dose;

/* --- plan.c --- */
/* The next step towards `limit` [mm]; enters its block. *moved: whether there is anything left to
 * do. */
arc_status arc_wear_plan_step(arc_wear *w, double limit, wear_plan *plan, int *moved,
                              arc_error *error);

/* --- implicit.c --- */
/* Depths of an implicit update over a window, with an estimate of their error where the definition
 * has a tolerance. ARC_NOT_CONVERGED: try fewer cycles. */
arc_status arc_wear_implicit(arc_wear *w, const wear_window *window, const wear_dose *dose,
                             wear_watch *watch, wear_depths *depth, arc_error *error);

/* --- update.c --- */
/* Wears the shape of an outcome, a copy of the run's, as planned. Its record, that of the run at
 * first, gains updates, volumes, coefficients and error. */
arc_status arc_wear_update(arc_wear *w, const wear_plan *plan, wear_watch *watch, wear_outcome *out,
                           arc_error *error);

/* --- stability.c --- */
/* Tells what speaks against this run before it goes on: once for a definition, and whenever the
 * limit of stability may have changed, since to find it costs a cycle of contact solutions. */
void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks);

#endif

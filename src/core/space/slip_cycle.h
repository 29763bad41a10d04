/* Data and functions for the slip in a cycle of a run with friction in three dimensions, used by
 * space_slip.c and, for fretting loops, by space_loop.c. */
#ifndef ARC_SLIP_CYCLE_H
#define ARC_SLIP_CYCLE_H

#include "core/space/cerruti.h"
#include "core/space/positions.h"
#include "core/space/space_kind.h"

typedef struct slip_cycle {
  arc_wear *w;
  const wear_window *v;
  const wear_block *block;
  arc_halfspace *h;
  const double *const *depth;
  space_path *path;
  double *pressure; /* [count][window] */
  wear_progress *progress;
  wear_rate *rate;
  int cells, unlike;
  double *slid, *lag, *strain,
      *total; /* [mm] in this order: slip in an increment [window], elastic displacement under full
                 friction [count][window], present elastic displacement [window], slip in the cycle
                 [window] */
  int whole;  /* 1 if the whole contact slips in at least one increment */
} slip_cycle;

/* Returns the data of a cycle of a run on the window `v` with the given depths. The arrays slid,
 * lag, strain and total are NULL. */
slip_cycle arc_slip_cycle(arc_wear *w, const wear_window *v, const double *const depth[ARC_BODIES],
                          space_path *path, double *pressure, wear_progress *progress,
                          wear_rate *rate);

/* Returns the position of the lower body [mm] at which the bodies are pressed together: the middle
 * of the stroke if the run has no loading history, otherwise the start of the cycle. */
double arc_slip_reference(const wear_block *b);

/* Returns load and motion (or force) at the fraction `share` (0 to 1) of the increment that ends at
 * point `at` of the cycle. */
arc_halfspace_increment arc_slip_conditions(const slip_cycle *c, int at, double share);

/* Presses the bodies together under the load at point 0 of the cycle. Errors: as for
 * arc_halfspace_slide. */
arc_status arc_slip_press(const slip_cycle *c, arc_halfspace_friction *state, arc_error *error);

/* Solves one increment and counts the solution. Errors: as for arc_halfspace_slide. */
arc_status arc_slip_solve(const slip_cycle *c, const arc_halfspace_increment *to,
                          arc_halfspace_friction *state, arc_error *error);

#endif

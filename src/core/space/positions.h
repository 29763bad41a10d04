/* Solves the contact of one position, or of all positions of a stroke at once. */
#ifndef SPACE_POSITIONS_H
#define SPACE_POSITIONS_H

#include "core/space/stroke.h"

/* The problem and its results. */
typedef struct positions {
  stroke s;
  double *load;     /* [count] in cells' pressures: load / cell area */
  double *pressure; /* [count][window] input if warm, output */
  double *approach; /* [count] */
  const double *const *depth;
  double tolerance;
  int warm;
  active_count used;
} positions;

/* Of `count` positions, or of the first half where all is symmetric in x and `mirror` is wished.
 * Errors: ARC_ZONE, ARC_ARGUMENT, ARC_MEMORY. */
arc_status arc_positions_create(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_wear *wear,
                                const arc_halfspace_position *position, int count, int mirror,
                                const arc_halfspace_options *options, const double *pressure,
                                positions *made, arc_error *error);
void arc_positions_free(positions *p);

/* Solves for pressures and approaches on the smallest box that contains the contacts, which becomes
 * s.box. */
arc_status arc_positions_solve(positions *p, arc_error *error);
/* The same without wear, with independent positions shared by workers. */
arc_status arc_positions_solve_each(positions *p, arc_error *error);

/* Sums of weight times pressure of the solution, by site of a body. */
void arc_positions_rate(positions *p, double *const rate[ARC_BODIES]);
/* The sum of one body. */
void arc_positions_sum(positions *p, arc_body body, double *sum);

/* True if both bodies' shapes with these depths are mirror images of themselves, to the bit: in x,
 * or in z (across). */
int arc_space_are_even(const arc_halfspace *h, const double *const depth[ARC_BODIES], int across);

/* The box of the whole window. */
space_box arc_space_window(const arc_halfspace *h);

#endif

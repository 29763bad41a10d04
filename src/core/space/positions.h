/* Contact solution for one position, or for all positions of a stroke at once. */
#ifndef SPACE_POSITIONS_H
#define SPACE_POSITIONS_H

#include "core/space/stroke.h"

/* The problem and its results. */
typedef struct positions {
  stroke s;
  double *load;     /* [count] load over cell area: the sum of the cells' pressures */
  double *pressure; /* [count][window] output; also input if warm */
  double *approach; /* [count] */
  const double *const *depth;
  double tolerance;
  int warm;
  active_count used;
} positions;

/* Creates the problem for `count` positions, or for the first half of them if `mirror` is 1 and
 * everything is symmetric in x. Errors: ARC_ZONE, ARC_ARGUMENT, ARC_MEMORY. */
arc_status arc_positions_create(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_wear *wear,
                                const arc_halfspace_position *position, int count, int mirror,
                                const arc_halfspace_options *options, const double *pressure,
                                positions *made, arc_error *error);
void arc_positions_free(positions *p);

/* Solves for pressures and approaches on the smallest box that contains the contacts; s.box becomes
 * this box. */
arc_status arc_positions_solve(positions *p, arc_error *error);
/* Solves for pressures and approaches without wear. The positions are independent, and the workers
 * share them. */
arc_status arc_positions_solve_each(positions *p, arc_error *error);

/* Computes the sum of weight times pressure over the positions for each site of both bodies. */
void arc_positions_rate(positions *p, double *const rate[ARC_BODIES]);
/* Computes the sum of weight times pressure for the sites of one body. */
void arc_positions_sum(positions *p, arc_body body, double *sum);

/* Returns true if the worn shape of each body equals its mirror image exactly (to the bit), in x
 * or, if `across` is 1, in z. */
int arc_space_are_even(const arc_halfspace *h, const double *const depth[ARC_BODIES], int across);

/* Returns the box that covers the whole window. */
space_box arc_space_window(const arc_halfspace *h);

#endif

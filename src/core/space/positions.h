/* Contact solution at one position, at several independent positions, or at all positions of a
 * stroke at once. */
#ifndef SPACE_POSITIONS_H
#define SPACE_POSITIONS_H

#include "core/space/stroke.h"

/* The contact problem at several positions of the lower body, and its results. */
typedef struct positions {
  stroke s;
  double *load; /* [count] sum of the cells' pressures [MPa], which is the load divided by the area
                   of a cell */
  double *pressure; /* [count][window] output; if `warm` is true, also the initial guess */
  double *approach; /* [count] approach of each position [mm] */
  const double *const *depth;
  double tolerance;
  int warm;
  active_count used;
} positions;

/* Creates the problem for `count` positions, or only for the first half of the positions if
 * `mirror` is 1 and bodies and loading are symmetric in x. Errors: ARC_ZONE, ARC_ARGUMENT,
 * ARC_MEMORY. */
arc_status arc_positions_create(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_wear *wear,
                                const arc_halfspace_position *position, int count, int mirror,
                                const arc_halfspace_options *options, const double *pressure,
                                positions *made, arc_error *error);
void arc_positions_free(positions *p);

/* Solves for pressures and approaches on the smallest box that contains the contacts, and stores
 * this box in s.box. */
arc_status arc_positions_solve(positions *p, arc_error *error);
/* Solves for pressures and approaches without wear. The positions are independent and are
 * distributed over the workers. */
arc_status arc_positions_solve_each(positions *p, arc_error *error);

/* Sets s.box to the smallest box that contains all cells with pressure, and s.kernel to the
 * convolution on it. */
arc_status arc_positions_fit_box(positions *p, arc_error *error);
/* Copies the pressures on the box to boxed [count][box]. */
void arc_positions_read_box(const positions *p, double *boxed);

/* Computes for each site of both bodies the sum of weight times pressure over the positions. */
void arc_positions_rate(positions *p, double *const rate[ARC_BODIES]);
/* Computes the sum of weight times pressure over the positions for the sites of one body. */
void arc_positions_sum(positions *p, arc_body body, double *sum);

/* Returns true if the worn shape of each body is symmetric in x or, if `across` is 1, in z. The
 * symmetry must be exact in all bits. */
int arc_space_are_even(const arc_halfspace *h, const double *const depth[ARC_BODIES], int across);

#endif

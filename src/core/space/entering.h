/* Sites that are in contact at one end of an increment alone. */
#ifndef SPACE_ENTERING_H
#define SPACE_ENTERING_H

#include "core/space/halfspace.h"

/* Pressure and shear of a contact [window]. */
typedef struct space_traction {
  const double *pressure, *q[2];
} space_traction;

/* Share of an increment's motion while sites were open that enter or leave the contact in it
 * [window], 0 for the others; *changes: 1 if any site enters or leaves. Gaps close in proportion to
 * the approach: exact while load and force grow in proportion and nothing slips. ARC_MEMORY; share
 * is spoilt then. */
arc_status arc_space_entering(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *at, const space_traction *before,
                              const space_traction *after, double *share, int *changes,
                              arc_error *error);

#endif

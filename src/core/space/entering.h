/* Sites that are in contact only at the beginning or only at the end of an increment. */
#ifndef SPACE_ENTERING_H
#define SPACE_ENTERING_H

#include "core/space/halfspace.h"

/* Pressure and shear of a contact [window]. */
typedef struct space_traction {
  const double *pressure, *q[2];
} space_traction;

/* Computes for each site that enters or leaves the contact in an increment the share of the motion
 * for which the site was open [window]; share is 0 for all other sites. Sets *changes to 1 if any
 * site enters or leaves. Gaps close in proportion to the approach; this is exact while load and
 * force grow in proportion and nothing slips. A site whose pressure is too large for that closes
 * in proportion to the displacement due to its own pressure, so that shares are continuous.
 * work: [window], overwritten. On failure (ARC_MEMORY) the contents of share are undefined. */
arc_status arc_space_entering(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *at, const space_traction *before,
                              const space_traction *after, double *work, double *share,
                              int *changes, arc_error *error);

#endif

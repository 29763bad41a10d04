/* Sites whose contact begins or ends within an increment. */
#ifndef SPACE_ENTERING_H
#define SPACE_ENTERING_H

#include "core/space/halfspace.h"

/* Pressure and shear of a contact [window]. */
typedef struct space_traction {
  const double *pressure, *q[2];
} space_traction;

/* Computes share [window]: for each site that enters or leaves the contact in an increment, the
 * fraction of the motion for which the site was not in contact. It is 0 for all other sites. Sets
 * *changes to 1 if any site enters or leaves. Gaps are assumed to change in proportion to the
 * approach. This assumption is exact while load and force grow in proportion and nothing slips. If
 * the pressure of a site is too large for this assumption, its gap changes in proportion to the
 * displacement due to this pressure, so that `share` is continuous. `work` [window] is a workspace.
 * On failure (ARC_ZONE: the track is too short) the contents of share are undefined. */
arc_status arc_space_entering(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *at, const space_traction *before,
                              const space_traction *after, double *work, double *share,
                              int *changes, arc_error *error);

#endif

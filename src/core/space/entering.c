/* Computes, for sites that enter or leave a contact within an increment, the fraction of the motion
 * for which they were not in contact (open). */
#include "core/space/entering.h"

#include "core/space/cerruti.h"

#include <math.h>

/* Computes the approach [mm] from pressures and from gaps that exclude the approach: the mean gap
 * over the contact, weighted by pressure. For separated bodies, returns the approach at first
 * contact. */
static double approach_of(int n, const double *pressure, const double *gap) {
  double sum = 0, product = 0, least = INFINITY;
  for (int k = 0; k < n; k++) {
    sum += pressure[k];
    product += pressure[k] * gap[k];
    least = fmin(least, gap[k]);
  }
  return sum > 0 ? product / sum : least;
}

static arc_status find_gaps(arc_halfspace *h, const double *const depth[ARC_BODIES],
                            const arc_halfspace_position *at, const space_traction *t, double *gap,
                            arc_error *error) {
  const arc_status status = arc_halfspace_gaps(h, depth, at, t->pressure, 0, gap, error);
  if (status == ARC_OK) arc_cerruti_add_gap(h, t->q, gap);
  return status;
}

static int same_sites(int n, const double *before, const double *after) {
  for (int k = 0; k < n; k++)
    if ((before[k] > 0) != (after[k] > 0)) return 0;
  return 1;
}

/* Computes the gaps [window] and the approach at one end of the increment. */
static arc_status find_end(arc_halfspace *h, const double *const depth[ARC_BODIES],
                           const arc_halfspace_position *at, const space_traction *t, double *gap,
                           double *approach, arc_error *error) {
  const arc_status status = find_gaps(h, depth, at, t, gap, error);
  if (status == ARC_OK) *approach = approach_of(h->cells, t->pressure, gap);
  return status;
}

/* Returns the fraction of an increment for which a site was open. The site is open with the gap
 * `open` [mm] at one end of the increment, and in contact with the pressure `shut` [MPa] at the
 * other end. From the open to the closed state all gaps decrease by `closure` [mm]. `self` is the
 * displacement of a site due to unit pressure on this site [mm/MPa]. If the closure is too small
 * for the pressure, the displacement due to this pressure is used instead, because the gaps between
 * unlike bodies also change by shear. */
static double open_share(double open, double shut, double closure, double self) {
  if (!(open > 0)) return 0;
  return open / (open + fmax(closure - open, self * shut));
}

arc_status arc_space_entering(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *at, const space_traction *before,
                              const space_traction *after, double *work, double *share,
                              int *changes, arc_error *error) {
  const int n = h->cells;
  double begin = 0, end = 0;
  for (int k = 0; k < n; k++) share[k] = 0;
  *changes = !same_sites(n, before->pressure, after->pressure);
  if (!*changes) return ARC_OK;
  arc_status status = find_end(h, depth, at, after, work, &end, error);
  if (status == ARC_OK) status = find_end(h, depth, at, before, share, &begin, error);
  if (status != ARC_OK) return status;
  for (int k = 0; k < n; k++) {
    const double p = before->pressure[k], q = after->pressure[k];
    if ((p > 0) == (q > 0))
      share[k] = 0;
    else if (q > 0)
      share[k] = open_share(share[k] - begin, q, end - begin, h->kernel[0]);
    else
      share[k] = open_share(work[k] - end, p, begin - end, h->kernel[0]);
  }
  return ARC_OK;
}

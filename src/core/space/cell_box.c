/* Chooses boxes: parts of the window that contain all loaded cells. Convolutions on a box are
 * faster than on the whole window. */
#include "core/space/halfspace.h"

void arc_space_box_sizes(int n, int periodic, int size[SPACE_LEVELS]) {
  static const double share[SPACE_LEVELS] = {1, 0.85, 0.75, 0.625, 0.5, 0.42, 0.33, 0.25};
  size[0] = n;
  for (int k = 1; k < SPACE_LEVELS; k++) {
    const int length = arc_transform_length((int)(share[k] * arc_transform_length(2 * n - 1)));
    int fits = (length + 1) / 2;
    fits -= (fits - n) % 2 != 0;
    size[k] = periodic || fits < 8 || fits > n ? n : fits;
  }
}

space_box arc_space_window(const arc_halfspace *h) {
  return (space_box){.nx = h->def.nx, .nz = h->def.nz};
}

void arc_space_extend(space_range *r, int k) {
  if (r->high < r->low) r->low = r->high = k;
  if (k < r->low) r->low = k;
  if (k > r->high) r->high = k;
}

void arc_space_find_range(const arc_halfspace *h, const double *value, space_range *x,
                          space_range *z) {
  const int nz = h->def.nz;
  for (int k = 0; k < h->cells; k++)
    if (value[k] > 0) {
      arc_space_extend(x, k / nz);
      arc_space_extend(z, k % nz);
    }
}

/* Returns the index of the smallest box size that contains the range and a margin [cells]. Sets
 * *from to the first row or column of the box. */
static int fit_level(const int level[SPACE_LEVELS], space_range r, int margin, int symmetric,
                     int *from) {
  const int n = level[0];
  if (symmetric && r.high < n - 1 - r.low) r.high = n - 1 - r.low;
  if (symmetric) r.low = n - 1 - r.high;
  const int low = r.low > margin ? r.low - margin : 0,
            high = r.high + margin < n ? r.high + margin : n - 1;
  int best = 0;
  for (int k = 1; k < SPACE_LEVELS; k++)
    if (level[k] >= high - low + 1 && level[k] < level[best]) best = k;
  /* A box that cannot be in the middle of the range is shifted to the middle of the window, so that
   * mirrored ranges have mirrored boxes. */
  const int twice = symmetric ? n - level[best] : low + high + 1 - level[best],
            first = (twice + (low + high < n - 1)) / 2;
  *from = first < 0 ? 0 : first + level[best] > n ? n - level[best] : first;
  return best;
}

space_box arc_space_box(const arc_halfspace *h, space_range x, space_range z, int margin,
                        int symmetric) {
  space_box box = arc_space_window(h);
  if (h->def.periodic) return box;
  box.level_x = fit_level(h->level_x, x, margin, symmetric, &box.x);
  box.level_z = fit_level(h->level_z, z, margin, 0, &box.z);
  box.nx = h->level_x[box.level_x];
  box.nz = h->level_z[box.level_z];
  return box;
}

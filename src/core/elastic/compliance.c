/* Compliances: allocation, references, response along the normals, and compliance under shear. */
#include "core/elastic/compliance.h"
#include "core/base/dense.h"

#include <stdlib.h>

enum { blocks = 5 };

/* Returns the number of doubles in the memory block of a compliance. The last double contains
 * the reference count. */
static size_t compliance_numbers(int n) {
  return blocks * (size_t)n * (size_t)n + 2 * (size_t)n + 1;
}

static double *sharers(const compliance *c) {
  return &c->yy[compliance_numbers(c->n) - 1];
}

size_t arc_compliance_bytes(int n) {
  return compliance_numbers(n) * sizeof(double);
}

/* Allocates all five matrices, the slopes and the levels as one block. On a flat surface `along`
 * is the matrix yy. */
arc_status arc_compliance_create(compliance *c, int n) {
  const size_t count = (size_t)n * (size_t)n;
  *c = (compliance){0};
  double *all = calloc(compliance_numbers(n), sizeof *all);
  if (!all) return ARC_MEMORY;
  *c = (compliance){.n = n,
                    .yy = all,
                    .xy = all + count,
                    .yx = all + 2 * count,
                    .xx = all + 3 * count,
                    .slope = all + blocks * count,
                    .along = all};
  *sharers(c) = 1;
  return ARC_OK;
}

void arc_compliance_free(compliance *c) {
  if (c->n > 0 && --*sharers(c) == 0) free(c->yy);
  *c = (compliance){0};
}

compliance arc_compliance_share(const compliance *c) {
  if (c->n > 0) ++*sharers(c);
  return *c;
}

void arc_compliance_incline(compliance *c) {
  const int n = c->n;
  const double *slope = c->slope;
  c->along = c->yy + 4 * (size_t)n * (size_t)n;
  for (int k = 0; k < n; k++) {
    const size_t at = dense_at(0, k, n);
    const double *yy = c->yy + at, *xy = c->xy + at, *yx = c->yx + at, *xx = c->xx + at;
    for (int r = 0; r < n; r++)
      c->along[at + (size_t)r] =
          yy[r] - slope[r] * xy[r] - slope[k] * yx[r] + slope[r] * slope[k] * xx[r];
  }
}

/* Returns the difference yy - xx between node k and the nodes `columns` columns to its left and
 * right. The result is the mean over the nodes that exist. */
static double difference_at(const compliance *c, int k, int columns) {
  double sum = 0;
  int sides = 0;
  for (int side = -1; side <= 1; side += 2) {
    const int r = k + side * columns;
    if (r < 0 || r >= c->n) continue;
    sum += c->yy[dense_at(r, k, c->n)] - c->xx[dense_at(r, k, c->n)];
    sides++;
  }
  return sum / sides;
}

/* Computes `level` by extrapolation of yy - xx from two distances between nodes. The
 * discretisation error decreases with the square of the distance. */
void arc_compliance_level(compliance *c) {
  if (c->n <= 2 * ARC_SHEAR_REACH) return;
  c->level = c->slope + c->n;
  for (int k = 0; k < c->n; k++)
    c->level[k] =
        (4 * difference_at(c, k, ARC_SHEAR_REACH) - difference_at(c, k, ARC_SHEAR_REACH / 2)) / 3;
}

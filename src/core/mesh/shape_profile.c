/* Measured profiles: surfaces through points over x. */
#include "core/mesh/body_shape.h"

#include <math.h>

static const char *const fields[] = {"width", "height", "y", "x", NULL};

static double height_at(const arc_series *y, double x) {
  int low = 0, high = y->count - 1;
  if (x <= y->distance[0]) return y->value[0];
  if (x >= y->distance[high]) return y->value[high];
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    if (y->distance[middle] <= x)
      low = middle;
    else
      high = middle;
  }
  const double share = (x - y->distance[low]) / (y->distance[high] - y->distance[low]);
  return y->value[low] + share * (y->value[high] - y->value[low]);
}

static double highest(const arc_series *y) {
  double most = y->value[0];
  for (int i = 1; i < y->count; i++) most = fmax(most, y->value[i]);
  return most;
}

static double crest(const arc_body_def *b) {
  return highest(&b->y_series);
}

static double inset(const arc_body_def *b, double crest_, double x) {
  return crest_ - height_at(&b->y_series, x);
}

static arc_status check(const arc_body_def *b, const char *path, arc_error *error) {
  const arc_series *y = &b->y_series;
  if (y->count < 2)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%sy': expected a function of x or heights at two or more positions, "
                    "got %d",
                    path, y->count);
  double least = y->value[0];
  for (int i = 0; i < y->count; i++) {
    if (!isfinite(y->value[i]) || !isfinite(y->distance[i]))
      return arc_fail(error, ARC_ARGUMENT, "field '%sy': expected finite numbers, got %g at x = %g",
                      path, y->value[i], y->distance[i]);
    if (i > 0 && !(y->distance[i] > y->distance[i - 1]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%sx': expected increasing numbers, got %g after %g", path,
                      y->distance[i], y->distance[i - 1]);
    least = fmin(least, y->value[i]);
  }
  if (highest(y) - least < 0.5 * b->height) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field '%sy': expected heights within half of the body's height %g mm, got a range "
      "of %g",
      path, b->height, highest(y) - least);
}

const body_shape arc_body_shape_profile = {
    fields, FORM_POINTS, 0,     NULL, NULL, arc_body_height, arc_body_limits_of_width,
    crest,  inset,       check, NULL};

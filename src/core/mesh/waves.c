/* Decomposes a profile into its form, which is a parabola, and its waves. */
#include "core/mesh/waves.h"
#include "core/mesh/body_shape.h"

#include <math.h>

/* Form of a profile: y = c[0] + c[1] t + c[2] (3 t^2 - 1) / 2, where t increases from -1 to 1
 * over the points. These three functions are nearly orthogonal. The coefficients are fitted in
 * turn, and repeated sweeps converge to the least-squares fit. */
typedef struct form {
  double middle, half, c[3];
} form;

static double term(const form *f, int k, double x) {
  const double t = (x - f->middle) / f->half;
  return k == 0 ? 1 : k == 1 ? t : (3 * t * t - 1) / 2;
}

static double form_at(const form *f, double x) {
  double sum = 0;
  for (int k = 0; k < 3; k++) sum += f->c[k] * term(f, k, x);
  return sum;
}

/* Returns the weight of point `i` in integrals over x [mm]. */
static double weight(const arc_series *y, int i) {
  const double from = y->distance[i > 0 ? i - 1 : 0],
               to = y->distance[i + 1 < y->count ? i + 1 : i];
  return (to - from) / 2;
}

static form form_of(const arc_series *y) {
  enum { sweeps = 20 };
  const double from = y->distance[0], to = y->distance[y->count - 1];
  form f = {.middle = (from + to) / 2, .half = (to - from) / 2};
  for (int sweep = 0; sweep < sweeps; sweep++)
    for (int k = 0; k < 3; k++) {
      double sum = 0, square = 0;
      for (int i = 0; i < y->count; i++) {
        const double x = y->distance[i], w = weight(y, i), at = term(&f, k, x);
        sum += w * at * (y->value[i] - form_at(&f, x));
        square += w * at * at;
      }
      f.c[k] += sum / square;
    }
  return f;
}

/* Returns the mean length of the waves [mm]. A change between a peak and a valley counts if it
 * is larger than a tenth of `height`, the total range of heights. */
static double length_of_waves(const arc_series *y, const form *f, double height) {
  static const double least = 0.1;
  enum { fewest = 4 };
  int turns = 0, sense = 0;
  /* from, to: positions of the first and the last extremum; at: position of the highest or
   * lowest point since the last extremum */
  double from = 0, to = 0, at = 0;
  double last = 0;
  for (int i = 0; i < y->count; i++) {
    const double x = y->distance[i], r = y->value[i] - form_at(f, x), step = r - last;
    const int further = i == 0 || sense * step > 0, turned = fabs(step) >= least * height;
    if (!further && !turned) continue;
    if (!further && sense != 0) {
      if (turns++ == 0) from = at;
      to = at;
    }
    if (!further) sense = step > 0 ? 1 : -1;
    last = r;
    at = x;
  }
  return turns < fewest ? INFINITY : 2 * (to - from) / (turns - 1);
}

body_waves arc_body_waves(const arc_body_def *b) {
  const arc_series *y = &b->y_series;
  if (!arc_body_has_points(b) || y->count < 3) return (body_waves){INFINITY, INFINITY, 0};
  const form f = form_of(y);
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < y->count; i++) {
    const double r = y->value[i] - form_at(&f, y->distance[i]);
    low = fmin(low, r);
    high = fmax(high, r);
  }
  return (body_waves){.form = f.c[2] != 0 ? -f.half * f.half / (3 * f.c[2]) : INFINITY,
                      .length = length_of_waves(y, &f, high - low),
                      .height = high - low};
}

/* Transfers worn surfaces to another mesh of the same bodies, and measured profiles to a mesh.
 * Pressures depend on curvature, so the displacements of the nodes are interpolated by cubic
 * splines with two continuous derivatives, one spline for each scar. At the edge of a scar, which
 * is a kink, the spline of the worn nodes is extrapolated to zero. The displacements are then
 * scaled so that the polygon of the new nodes has lost the same area. */
#include "core/contact/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHIFT_X, SHIFT_Y, DEPTH, QUANTITIES };

/* A surface to be interpolated. Node i has moved from x[i] by value[SHIFT_X][i] along x and
 * value[SHIFT_Y][i] along y. */
typedef struct track {
  int n;
  double *x;
  double *value[QUANTITIES];
  double *bend[QUANTITIES]; /* [n] second derivatives of the splines, one spline per scar */
  double *work;             /* [n] workspace */
} track;

static arc_status track_create(track *t, int n) {
  const size_t count = (size_t)n;
  *t = (track){.n = n, .x = calloc((2 + 2 * QUANTITIES) * count, sizeof(double))};
  if (!t->x) return ARC_MEMORY;
  t->work = t->x + count;
  for (int q = 0; q < QUANTITIES; q++) {
    t->value[q] = t->work + (1 + (size_t)q) * count;
    t->bend[q] = t->work + (1 + QUANTITIES + (size_t)q) * count;
  }
  return ARC_OK;
}

static void track_of(const shape_side *side, track *t) {
  for (int i = 0; i < side->n; i++) {
    const double *top = arc_body_top(side->body, i);
    t->x[i] = side->x0[i];
    t->value[SHIFT_X][i] = side->xy[2 * i] - top[0];
    t->value[SHIFT_Y][i] = side->xy[2 * i + 1] - top[1];
    t->value[DEPTH][i] = side->h[i] - side->even;
  }
}

/* --- splines ---------------------------------------------------------------------------------- */

/* Computes the second derivatives m of the spline through (x, y) [n], n >= 4, whose third
 * derivative is also continuous at the first and last inner points (not-a-knot). */
static void bend_spline(const double *x, const double *y, int n, double *diagonal, double *m) {
  const double first = (x[1] - x[0]) / (x[2] - x[1]);
  const double last = (x[n - 1] - x[n - 2]) / (x[n - 2] - x[n - 3]);
  double above = 0; /* coefficient right of the diagonal in the previous row */
  for (int i = 1; i + 1 < n; i++) {
    const double h = x[i] - x[i - 1], g = x[i + 1] - x[i];
    double below = h, right = g, centre = 2 * (h + g);
    if (i == 1) centre += h * (1 + first), right -= h * first, below = 0;
    if (i + 2 == n) centre += g * (1 + last), below -= g * last;
    const double share = i > 1 ? below / diagonal[i - 1] : 0;
    diagonal[i] = centre - share * above;
    m[i] = 6 * ((y[i + 1] - y[i]) / g - (y[i] - y[i - 1]) / h) - (i > 1 ? share * m[i - 1] : 0);
    above = right;
  }
  for (int i = n - 2; i >= 1; i--) {
    double right = x[i + 1] - x[i];
    if (i == 1) right -= (x[1] - x[0]) * first;
    m[i] = (m[i] - (i + 2 < n ? right * m[i + 1] : 0)) / diagonal[i];
  }
  m[0] = m[1] - first * (m[2] - m[1]);
  m[n - 1] = m[n - 2] + last * (m[n - 2] - m[n - 3]);
}

/* Returns quantity q at x = `at` from the cubic polynomial of the interval between points i and i +
 * 1, which also extrapolates. */
static double cubic(const track *t, int q, int i, double at) {
  const double h = t->x[i + 1] - t->x[i], b = (at - t->x[i]) / h, a = 1 - b;
  const double *y = t->value[q], *m = t->bend[q];
  return a * y[i] + b * y[i + 1] +
         ((a * a * a - a) * m[i] + (b * b * b - b) * m[i + 1]) * h * h / 6;
}

static int is_worn(const track *t, int i) {
  return i >= 0 && i < t->n && t->value[DEPTH][i] > 0;
}

/* Computes splines through each sequence of worn nodes. A sequence of fewer than four nodes is
 * interpolated linearly. */
static void bend(track *t) {
  for (int a = 0; a < t->n; a++) {
    if (!is_worn(t, a)) continue;
    int b = a;
    while (is_worn(t, b + 1)) b++;
    for (int q = 0; q < QUANTITIES && b - a >= 3; q++)
      bend_spline(&t->x[a], &t->value[q][a], b - a + 1, &t->work[a], &t->bend[q][a]);
    a = b;
  }
}

/* Returns the depth at x = `at`, between the worn node `edge` and its unworn neighbour `outside`,
 * divided by the depth of `edge`. The spline is extrapolated down to zero. If it does not reach
 * zero, a smooth function replaces it. */
static double share_beyond(const track *t, int edge, int outside, double at) {
  const int inside = 2 * edge - outside;
  const double depth = t->value[DEPTH][edge];
  const double b = (at - t->x[outside]) / (t->x[edge] - t->x[outside]);
  if (!is_worn(t, inside)) return b;
  const int i = edge < inside ? edge : inside;
  if (cubic(t, DEPTH, i, t->x[outside]) > 0) return b * b * (3 - 2 * b);
  return fmin(1, fmax(0, cubic(t, DEPTH, i, at) / depth));
}

/* Interpolates displacements and depth at x = `at`. They are 0 beyond the ends of the surface and
 * between unworn nodes. */
static void track_at(const track *t, double at, double value[QUANTITIES]) {
  memset(value, 0, QUANTITIES * sizeof *value);
  if (at < t->x[0] || at > t->x[t->n - 1]) return;
  int i = 0, high = t->n - 1; /* `at` lies between nodes i and i + 1 */
  while (high - i > 1) {
    const int middle = (i + high) / 2;
    if (t->x[middle] <= at)
      i = middle;
    else
      high = middle;
  }
  const int left = is_worn(t, i), right = is_worn(t, i + 1);
  if (left && right) {
    for (int q = 0; q < QUANTITIES; q++) value[q] = cubic(t, q, i, at);
    if (value[DEPTH] < 0) memset(value, 0, QUANTITIES * sizeof *value);
  } else if (left || right) {
    const int edge = left ? i : i + 1, outside = left ? i + 1 : i;
    const double share = share_beyond(t, edge, outside, at);
    for (int q = 0; q < QUANTITIES; q++) value[q] = share * t->value[q][edge];
  }
}

/* --- areas ------------------------------------------------------------------------------------ */

/* Returns the area [mm2] that the displacements of the nodes, multiplied by `scale`, remove from
 * the polygon of unworn nodes. */
static double area_under(const shape_side *side, const track *t, double scale) {
  double area = 0, before[4] = {0};
  for (int i = 0; i < t->n; i++) {
    const double *top = arc_body_top(side->body, i);
    const double x = top[0] + scale * t->value[SHIFT_X][i],
                 y = top[1] + scale * t->value[SHIFT_Y][i];
    if (i > 0)
      area += ((x - before[0]) * (y + before[1]) - (top[0] - before[2]) * (top[1] + before[3])) / 2;
    before[0] = x, before[1] = y, before[2] = top[0], before[3] = top[1];
  }
  return area;
}

/* Scales displacements and depths so that they remove a given area [mm2]. The area is nearly
 * proportional to the scale, so six iterations suffice. */
static void scale_to(const shape_side *side, track *t, double wanted) {
  enum { sweeps = 6 };
  const double forth = area_under(side, t, 1), back = area_under(side, t, -1);
  const double linear = (forth - back) / 2, square = (forth + back) / 2;
  double scale = 1;
  if (forth == wanted || linear == 0) return;
  for (int sweep = 0; sweep < sweeps; sweep++) scale = wanted / (linear + scale * square);
  for (int q = 0; q < QUANTITIES; q++)
    for (int i = 0; i < t->n; i++) t->value[q][i] *= scale;
}

/* --- transfer ------------------------------------------------------------------------------ */

/* Converts displacements of the nodes to heights at their unworn positions (frozen geometry). */
static void stand_upright(const shape_side *side, track *t) {
  memcpy(t->work, t->value[SHIFT_Y], (size_t)t->n * sizeof(double));
  for (int i = 1; i + 1 < t->n; i++) {
    const double *a = arc_body_top(side->body, i - 1);
    const double *b = arc_body_top(side->body, i + 1);
    const double dx = b[0] - a[0] + t->value[SHIFT_X][i + 1] - t->value[SHIFT_X][i - 1];
    const double dy = b[1] - a[1] + t->value[SHIFT_Y][i + 1] - t->value[SHIFT_Y][i - 1];
    t->work[i] -= t->value[SHIFT_X][i] * dy / dx;
  }
  memcpy(t->value[SHIFT_Y], t->work, (size_t)t->n * sizeof(double));
  memset(t->value[SHIFT_X], 0, (size_t)t->n * sizeof(double));
}

/* Sign of each quantity in the mirror image about x = 0. */
static const double in_mirror[QUANTITIES] = {[SHIFT_X] = -1, [SHIFT_Y] = 1, [DEPTH] = 1};

static int is_mirrored(const track *t) {
  for (int i = 0; 2 * i < t->n; i++) {
    const int image = t->n - 1 - i;
    if (t->x[i] != -t->x[image]) return 0;
    for (int q = 0; q < QUANTITIES; q++)
      if (t->value[q][i] != in_mirror[q] * t->value[q][image]) return 0;
  }
  return 1;
}

/* Replaces the right half of a surface by the mirror image of its left half. */
static void reflect(track *t) {
  for (int i = 0; 2 * i < t->n; i++) {
    const int image = t->n - 1 - i;
    for (int q = 0; q < QUANTITIES; q++)
      t->value[q][image] = i == image && in_mirror[q] < 0 ? 0 : in_mirror[q] * t->value[q][i];
  }
}

/* Interpolates the surface `from` at the nodes of a side. Symmetric surfaces remain exactly
 * symmetric. */
static void interpolate(const track *from, const shape_side *side, track *to) {
  memcpy(to->x, side->x0, (size_t)to->n * sizeof *to->x);
  const int mirrored = is_mirrored(from) && is_mirrored(to);
  for (int i = 0; i < to->n; i++) {
    double value[QUANTITIES];
    track_at(from, to->x[i], value);
    for (int q = 0; q < QUANTITIES; q++) to->value[q][i] = value[q];
  }
  if (mirrored) reflect(to);
}

/* Returns true if the nodes of the new mesh cover the whole scar. Otherwise the outer part of the
 * scar is lost. */
static int covers(const shape_side *side, const track *from) {
  for (int i = 0; i < from->n; i++)
    if (is_worn(from, i) && (from->x[i] < side->x0[0] || from->x[i] > side->x0[side->n - 1]))
      return 0;
  return 1;
}

static arc_status remap(const shape_side *source, track *from, arc_shape *to, arc_body body,
                        arc_error *error) {
  const shape_side *side = &to->side[body];
  track t = {0};
  track_of(source, from);
  if (track_create(&t, side->n) != ARC_OK)
    return arc_fail(error, ARC_MEMORY, "out of memory for a worn shape");
  bend(from);
  interpolate(from, side, &t);
  if (to->geometry == ARC_FROZEN) stand_upright(side, &t);
  if (covers(side, from)) scale_to(side, &t, area_under(source, from, 1));
  const arc_status status = arc_shape_put(to, body, t.value[SHIFT_X], t.value[SHIFT_Y],
                                          t.value[DEPTH], source->even, error);
  free(t.x);
  return status;
}

arc_status arc_shape_remap(const arc_shape *from, arc_shape *to, arc_error *error) {
  arc_status status = ARC_OK;
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) {
    track t;
    if (track_create(&t, from->side[b].n) != ARC_OK)
      return arc_fail(error, ARC_MEMORY, "out of memory for a worn shape");
    status = remap(&from->side[b], &t, to, (arc_body)b, error);
    free(t.x);
  }
  return status;
}

/* --- measured profiles ------------------------------------------------------------------------ */

/* Returns the area under the polyline through (x, h) [n] [mm2]. */
static double area_of(const double *x, const double *h, size_t n) {
  double area = 0;
  for (size_t i = 1; i < n; i++) area += (x[i] - x[i - 1]) * (h[i] + h[i - 1]) / 2;
  return area;
}

arc_status arc_shape_sample(const arc_shape *shape, arc_body body, arc_depths measured,
                            double *depth, arc_error *error) {
  const shape_side *side = &shape->side[body];
  const size_t n = (size_t)side->n;
  track t;
  if (track_create(&t, (int)measured.count) != ARC_OK)
    return arc_fail(error, ARC_MEMORY, "out of memory for a worn shape");
  memcpy(t.x, measured.x, measured.count * sizeof *t.x);
  memcpy(t.value[DEPTH], measured.h, measured.count * sizeof *t.x);
  bend(&t);
  for (size_t i = 0; i < n; i++) {
    double value[QUANTITIES];
    track_at(&t, side->x0[i], value);
    depth[i] = value[DEPTH];
  }
  const double wanted = area_of(t.x, t.value[DEPTH], measured.count);
  const double taken = area_of(side->x0, depth, n);
  const int whole = measured.h[0] == 0 && measured.h[measured.count - 1] == 0;
  if (taken > 0 && whole && covers(side, &t))
    for (size_t i = 0; i < n; i++) depth[i] *= wanted / taken;
  free(t.x);
  return ARC_OK;
}

/* Samples fields (polygons with values at their corners) on a grid, and computes contour lines. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plot/figure.h"

typedef struct corner {
  double x, y, value;
} corner;

static corner corner_of(const arc_plot_field *field, size_t polygon, int which) {
  size_t i = 4 * polygon + (size_t)which;
  return (corner){field->x[i], field->y[i], field->value[i]};
}

/* Returns true if the bounding box of a polygon overlaps `box`, whose ends may be reversed. */
static int touches(const arc_plot_field *field, size_t polygon, const arc_plot_box *box) {
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  for (int k = 0; k < 4; k++) {
    corner c = corner_of(field, polygon, k);
    x0 = fmin(x0, c.x), x1 = fmax(x1, c.x), y0 = fmin(y0, c.y), y1 = fmax(y1, c.y);
  }
  return x1 >= fmin(box->x0, box->x1) && x0 <= fmax(box->x0, box->x1) &&
         y1 >= fmin(box->y0, box->y1) && y0 <= fmax(box->y0, box->y1);
}

void arc_field_range(const arc_plot_panel *panel, const arc_plot_box *box, double range[2]) {
  const arc_plot_field *field = panel->field;
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < field->count; i++)
    for (int k = 0; k < 4 && touches(field, i, box); k++) {
      double value = corner_of(field, i, k).value;
      low = fmin(low, value), high = fmax(high, value);
    }
  if (low > high) low = high = 0; /* no part of the field is in the box */
  range[0] = isnan(panel->value.min) ? low : panel->value.min;
  range[1] = isnan(panel->value.max) ? high : panel->value.max;
  if (range[0] == range[1]) range[1] = range[0] + fmax(1e-12, fabs(range[0]) * 1e-3);
}

/* --- triangles -------------------------------------------------------------------------------- */

/* A polygon is divided into four triangles that share its middle point. The value at this point
 * is the mean of the corners. With only two triangles, contour lines would be jagged. If the
 * polygon is a triangle, one of the four triangles has no area, and the values stay linear. */
enum { TRIANGLES = 4 };

static void triangle_of(const arc_plot_field *field, size_t polygon, int which, corner t[3]) {
  corner c[4], middle = {0, 0, 0};
  for (int k = 0; k < 4; k++) c[k] = corner_of(field, polygon, k);
  int corners = c[2].x == c[3].x && c[2].y == c[3].y ? 3 : 4;
  for (int k = 0; k < corners; k++) {
    middle.x += c[k].x / corners;
    middle.y += c[k].y / corners;
    middle.value += c[k].value / corners;
  }
  t[0] = middle;
  t[1] = c[which];
  t[2] = c[(which + 1) % 4];
}

static double twice_area(const corner t[3]) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

/* Computes the point on the edge from a to b where the value is `level`. Returns 0 if there is no
 * such point. A corner exactly on the level is regarded as above the level. */
static int cut(corner a, corner b, double level, corner *point) {
  if ((a.value < level) == (b.value < level)) return 0;
  double share = (level - a.value) / (b.value - a.value);
  *point = (corner){a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), level};
  return 1;
}

/* At most MOST_NUMBERS contour lines have numbers. The number of a contour line is at the segment
 * that is farthest from the frame, from the numbers of lower levels and from the next contour line.
 * Distances are fractions of the box. */
enum { MOST_NUMBERS = 40 };

typedef struct numbers {
  const arc_plot_box *box;
  corner placed[MOST_NUMBERS];
  int count;
  double step;        /* difference between adjacent levels */
  double least;       /* minimum distance of a number to the frame, lines and other numbers */
  double row, column; /* height and width of a character */
  corner best;        /* best position for the number of the present level */
  double clearance;
} numbers;

/* Estimates the distance to the next contour line from the gradient in the triangle `t`. */
static double spacing_of(const numbers *n, const corner t[3]) {
  const double width = n->box->x1 - n->box->x0, height = n->box->y1 - n->box->y0;
  const double a = t[1].value - t[0].value, b = t[2].value - t[0].value;
  const double along_x = (a * (t[2].y - t[0].y) - b * (t[1].y - t[0].y)) / twice_area(t);
  const double along_y = (b * (t[1].x - t[0].x) - a * (t[2].x - t[0].x)) / twice_area(t);
  return n->step / hypot(along_x * width, along_y * height);
}

/* Returns the smallest distance of `p` to the frame and to other numbers. A distance to another
 * number is halved, because both numbers need half of the space. */
static double clearance_of(const numbers *n, corner p) {
  const double width = n->box->x1 - n->box->x0, height = n->box->y1 - n->box->y0;
  const double u = (p.x - n->box->x0) / width, v = (p.y - n->box->y0) / height;
  double least = fmin(fmin(u, 1 - u), fmin(v, 1 - v));
  for (int k = 0; k < n->count; k++)
    least = fmin(least, hypot((p.x - n->placed[k].x) / width, (p.y - n->placed[k].y) / height) / 2);
  return least;
}

/* Computes the ends of the contour line in a triangle. Returns 0 if the line does not cross it. */
static int segment_of(const corner t[3], double level, corner points[3]) {
  int count = 0;
  if (twice_area(t) == 0) return 0;
  for (int k = 0; k < 3; k++) count += cut(t[k], t[(k + 1) % 3], level, &points[count]);
  return count == 2;
}

/* Returns true if the contour line is not hidden by its number, the best position of which is
 * known: it extends beyond an area of 1.5 times the width and height of the number. */
static int is_larger_than_number(const arc_plot_field *field, double level, const numbers *n) {
  const double width = n->box->x1 - n->box->x0, height = n->box->y1 - n->box->y0;
  char text[32];
  const int length = snprintf(text, sizeof text, "%.6g", level);
  const double half_x = 0.75 * (length + 1) * n->column * width, half_y = n->row * height;
  for (size_t i = 0; i < field->count; i++)
    for (int part = 0; part < TRIANGLES && touches(field, i, n->box); part++) {
      corner t[3], p[3];
      int inside[3];
      triangle_of(field, i, part, t);
      if (!segment_of(t, level, p)) continue;
      p[2] = (corner){(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2, level};
      for (int k = 0; k < 3; k++)
        inside[k] = fabs(p[k].x - n->best.x) < half_x && fabs(p[k].y - n->best.y) < half_y;
      if ((inside[0] || inside[1] || inside[2]) && !(inside[0] && inside[1])) return 1;
    }
  return 0;
}

static size_t contour_triangle(const corner t[3], double level, numbers *n, arc_text *script) {
  corner points[3];
  if (!segment_of(t, level, points)) return 0;
  arc_text_format(script, "%.17g %.17g\n", points[0].x, points[0].y);
  arc_text_format(script, "%.17g %.17g\n\n", points[1].x, points[1].y);
  const corner middle = {(points[0].x + points[1].x) / 2, (points[0].y + points[1].y) / 2, level};
  const double clearance = fmin(clearance_of(n, middle), 2 * spacing_of(n, t));
  if (clearance > n->clearance) n->best = middle, n->clearance = clearance;
  return 1;
}

static size_t contour_level(const arc_plot_field *field, double level, numbers *n,
                            arc_text *script) {
  size_t segments = 0;
  n->clearance = n->least;
  for (size_t i = 0; i < field->count; i++)
    for (int part = 0; part < TRIANGLES && touches(field, i, n->box); part++) {
      corner t[3];
      triangle_of(field, i, part, t);
      segments += contour_triangle(t, level, n, script);
    }
  if (n->clearance > n->least && n->count < MOST_NUMBERS && is_larger_than_number(field, level, n))
    n->placed[n->count++] = n->best;
  return segments;
}

size_t arc_field_contours(const arc_plot_field *field, const arc_plot_box *box,
                          const double range[2], int levels, const double size[2], arc_text *lines,
                          arc_text *labels) {
  size_t segments = 0;
  double step = arc_field_step(range, levels);
  numbers n = {.box = box,
               .step = step,
               .least = fmax(0.04, 1.3 / size[0]),
               .row = 1 / size[0],
               .column = 1 / size[1]};
  double first = step * (floor(range[0] / step + 1e-9) + 1);
  int count = levels > 0 ? (int)ceil((range[1] - first) / step - 1e-9) : 0;
  for (int k = 0; k < count; k++) segments += contour_level(field, first + k * step, &n, lines);
  for (int k = 0; k < n.count; k++) {
    const double value = fabs(n.placed[k].value) < 1e-9 * step ? 0 : n.placed[k].value;
    arc_text_format(labels, "%.17g %.17g %.6g\n", n.placed[k].x, n.placed[k].y, value);
  }
  return segments;
}

/* --- samples ---------------------------------------------------------------------------------- */

typedef struct raster {
  double x0, dx, y0, dy; /* sample i of a row is at x = x0 + i dx */
  int columns, rows;
  double *values;
} raster;

/* Computes the indices of the first and last sample between the coordinates a and b. */
static void samples_between(double a, double b, double start, double step, int count, int *first,
                            int *last) {
  double u = (a - start) / step, v = (b - start) / step;
  *first = (int)fmin(count, fmax(0, ceil(fmin(u, v) - 1e-9)));
  *last = (int)fmax(-1, fmin(count - 1, floor(fmax(u, v) + 1e-9)));
}

static void raster_triangle(const corner t[3], raster *r) {
  double area = twice_area(t);
  int i0, i1, j0, j1;
  if (area == 0) return;
  samples_between(fmin(t[0].x, fmin(t[1].x, t[2].x)), fmax(t[0].x, fmax(t[1].x, t[2].x)), r->x0,
                  r->dx, r->columns, &i0, &i1);
  samples_between(fmin(t[0].y, fmin(t[1].y, t[2].y)), fmax(t[0].y, fmax(t[1].y, t[2].y)), r->y0,
                  r->dy, r->rows, &j0, &j1);
  for (int j = j0; j <= j1; j++)
    for (int i = i0; i <= i1; i++) {
      corner p = {r->x0 + i * r->dx, r->y0 + j * r->dy, 0};
      double b = twice_area((corner[]){t[0], p, t[2]}) / area;
      double c = twice_area((corner[]){t[0], t[1], p}) / area;
      if (b >= -1e-9 && c >= -1e-9 && b + c <= 1 + 1e-9)
        r->values[j * r->columns + i] =
            t[0].value + b * (t[1].value - t[0].value) + c * (t[2].value - t[0].value);
    }
}

void arc_field_raster(const arc_plot_field *field, const arc_plot_box *box, int columns, int rows,
                      double *values) {
  double dx = (box->x1 - box->x0) / columns, dy = (box->y1 - box->y0) / rows;
  raster r = {box->x0 + dx / 2, dx, box->y0 + dy / 2, dy, columns, rows, values};
  for (int i = 0; i < columns * rows; i++) values[i] = NAN;
  for (size_t i = 0; i < field->count; i++)
    for (int part = 0; part < TRIANGLES && touches(field, i, box); part++) {
      corner t[3];
      triangle_of(field, i, part, t);
      raster_triangle(t, &r);
    }
}

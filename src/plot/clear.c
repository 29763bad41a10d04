/* Extends axes so that curves do not coincide with the frame.
 *
 * Without an extension gnuplot draws only half of the width of a line at an end of the range, ends
 * a reversed axis at the last point, and extends logarithmic axes to the next decade. */
#include <math.h>
#include <string.h>

#include "plot/figure.h"

/* Extension of an axis as a fraction of its range: BEYOND where the user set the end of the range,
 * MARGIN where the end is automatic. */
static const double BEYOND = 0.025, MARGIN = 0.04;

/* Returns the reversed axis without the flag `reverse`: its first end is larger than its second. */
static arc_plot_axis turned_round(arc_plot_axis axis) {
  double low = fmin(axis.min, axis.max), high = fmax(axis.min, axis.max);
  axis.min = high, axis.max = low, axis.reverse = 0;
  return axis;
}

/* --- logarithmic axes ------------------------------------------------------------------------- */

/* Returns the largest number of the form 1, 2 or 5 times a power of ten that is not above the
 * value. */
static double step_below(double value) {
  double power = pow(10, floor(log10(value) + 1e-9)), share = value / power * (1 + 1e-9);
  return power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
}

static double step_above(double value) {
  double below = step_below(value), power = pow(10, floor(log10(below) + 1e-9));
  if (below >= value * (1 - 1e-9)) return below;
  return below / power < 1.5 ? 2 * power : below / power < 3 ? 5 * power : 10 * power;
}

/* Extends the range low..high so that it includes the positive values of the curves along x
 * (`along` 0) or along y (`along` 1). */
static void positive_reach(const arc_plot_panel *panel, int along, double *low, double *high) {
  for (size_t i = 0; i < panel->curve_count; i++)
    for (size_t j = 0; j < panel->curves[i].count; j++) {
      double value = along ? panel->curves[i].y[j] : panel->curves[i].x[j];
      if (!(value > 0) || !isfinite(value)) continue;
      *low = fmin(*low, value), *high = fmax(*high, value);
    }
}

/* Sets both ends of a logarithmic axis for values from `low` to `high`. An end that the user set is
 * not changed. */
static void set_log(arc_plot_axis *axis, double low, double high) {
  if (!(low <= high) || (!isnan(axis->min) && !isnan(axis->max))) return;
  double from = step_below(low), to = step_above(high);
  if (from == to) from = step_below(0.9 * low), to = step_above(1.1 * high);
  double bottom = axis->min,
         top = axis->max; /* the factors with 1e-9 ensure that ticks at the ends are drawn */
  if (isnan(bottom)) bottom = (isnan(top) || from < top ? from : top / 10) * (1 - 1e-9);
  if (isnan(top)) top = (to > bottom ? to : 10 * bottom) * (1 + 1e-9);
  axis->min = axis->reverse ? top : bottom;
  axis->max = axis->reverse ? bottom : top;
}

static void clear_log(const arc_plot_panel *panel, int along, arc_plot_axis *axis) {
  double low = INFINITY, high = 0;
  positive_reach(panel, along, &low, &high);
  set_log(axis, low, high);
}

/* --- linear axes ------------------------------------------------------------------------------ */

/* Returns true if any curve has two consecutive points at the y value `height`. */
static int runs_along(const arc_plot_panel *panel, double height, double span) {
  for (size_t i = 0; i < panel->curve_count; i++) {
    const arc_plot_curve *curve = &panel->curves[i];
    if (curve->style == ARC_PLOT_FILLED || curve->style == ARC_PLOT_POINTS) continue;
    for (size_t j = 1; j < curve->count; j++)
      if (fabs(curve->y[j] - height) <= 1e-3 * span &&
          fabs(curve->y[j - 1] - height) <= 1e-3 * span)
        return 1;
  }
  return 0;
}

static void clear_linear(const arc_plot_panel *panel, arc_plot_axis *y) {
  arc_plot_box box = arc_plot_extent(panel);
  double span = box.y1 - box.y0;
  if (!(fabs(span) > 0) || !isfinite(span)) return;
  if (!isnan(y->min) && runs_along(panel, y->min, fabs(span))) y->min -= BEYOND * span;
  if (!isnan(y->max) && runs_along(panel, y->max, fabs(span))) y->max += BEYOND * span;
  if (isnan(y->max) && runs_along(panel, box.y1, fabs(span))) y->max = box.y1 + MARGIN * span;
  if (isnan(y->min) && runs_along(panel, box.y0, fabs(span))) y->min = box.y0 - MARGIN * span;
  if (y->reverse && isnan(y->max)) y->max = box.y1 + MARGIN * span;
  if (y->reverse && isnan(y->min)) y->min = box.y0 - MARGIN * span;
  int turned = y->reverse && !isnan(y->min) && !isnan(y->max);
  if (turned) *y = turned_round(*y);
}

/* --- panels side by side ---------------------------------------------------------------------- */

static int same_end(double a, double b) {
  return a == b || (isnan(a) && isnan(b));
}

/* Returns true if the y axes of two panels have the same label and settings, and at least one
 * automatic end. */
static int are_alike(const arc_plot_panel *a, const arc_plot_panel *b) {
  const arc_plot_axis *p = &a->y, *q = &b->y;
  if (a->field || b->field || a->equal || b->equal || p->places || q->places) return 0;
  if (!p->label || !q->label || strcmp(p->label, q->label) != 0) return 0;
  return p->log == q->log && p->reverse == q->reverse && same_end(p->min, q->min) &&
         same_end(p->max, q->max) && (isnan(p->min) || isnan(p->max));
}

/* Sets the automatic ends of a linear axis that several panels share. An end at zero has no
 * margin. */
static void set_linear(arc_plot_axis *axis, double low, double high) {
  double margin = MARGIN * (high - low);
  if (!(high > low)) return;
  if (isnan(axis->min)) axis->min = low == 0 ? 0 : low - margin;
  if (isnan(axis->max)) axis->max = high == 0 ? 0 : high + margin;
  if (axis->reverse) *axis = turned_round(*axis);
}

void arc_plot_share(arc_plot_panel *panels, size_t count) {
  for (size_t i = 0; i < count; i++) {
    const arc_plot_panel first = panels[i];
    double low = INFINITY, high = first.y.log ? 0 : -INFINITY;
    size_t alike = 0;
    for (size_t j = i; j < count; j++) {
      if (!are_alike(&first, &panels[j])) continue;
      alike++;
      arc_plot_box box = arc_plot_extent(&panels[j]);
      if (first.y.log)
        positive_reach(&panels[j], 1, &low, &high);
      else
        low = fmin(low, box.y0), high = fmax(high, box.y1);
    }
    for (size_t j = i; j < count && alike > 1; j++) {
      if (!are_alike(&first, &panels[j])) continue;
      if (first.y.log)
        set_log(&panels[j].y, low, high);
      else
        set_linear(&panels[j].y, low, high);
    }
  }
}

void arc_plot_clear(const arc_canvas *canvas, arc_plot_panel *panel) {
  if (panel->field) return;
  if (panel->x.log) clear_log(panel, 0, &panel->x);
  if (panel->y.log)
    clear_log(panel, 1, &panel->y);
  else if (!canvas->text && !panel->equal && !panel->y.places)
    clear_linear(panel, &panel->y);
}

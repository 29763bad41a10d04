/* Default values of axes and panels, and the grid, extent and checks of a figure. */
#include "plot/figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

arc_plot_axis arc_plot_axis_default(void) {
  return (arc_plot_axis){.label = NULL, .min = NAN, .max = NAN, .log = 0, .reverse = 0};
}

arc_plot_panel arc_plot_panel_default(void) {
  arc_plot_axis axis = arc_plot_axis_default();
  return (arc_plot_panel){.x = axis, .y = axis, .value = axis, .key = ARC_PLOT_KEY_BELOW};
}

void arc_plot_grid(const arc_plot_figure *figure, int *rows, int *columns) {
  int count = (int)figure->panel_count;
  *rows = figure->rows;
  *columns = figure->columns;
  if (*rows <= 0 && *columns <= 0) *columns = (int)ceil(sqrt((double)count));
  if (*columns <= 0) *columns = (count + *rows - 1) / *rows;
  if (*rows <= 0) *rows = (count + *columns - 1) / *columns;
}

/* --- extent ----------------------------------------------------------------------------------- */

static void widen(double value, double *low, double *high) {
  if (!isfinite(value)) return;
  if (!(*low <= value)) *low = value;
  if (!(*high >= value)) *high = value;
}

static void take_range(const arc_plot_axis *axis, double *low, double *high) {
  if (!isnan(axis->min)) *low = axis->min;
  if (!isnan(axis->max)) *high = axis->max;
}

static int between(const arc_plot_axis *axis, double value) {
  double low = fmin(axis->min, axis->max), high = fmax(axis->min, axis->max);
  if (isnan(axis->min) || isnan(axis->max)) low = axis->min, high = axis->max;
  return !(value < low) && !(value > high);
}

static void widen_y(const arc_plot_curve *curve, size_t j, arc_plot_box *box) {
  double bar = curve->error && isfinite(curve->error[j]) ? curve->error[j] : 0;
  widen(curve->y[j] - bar, &box->y0, &box->y1);
  widen(curve->y[j] + bar, &box->y0, &box->y1);
}

/* Computes the extent of a panel's data. As in gnuplot, points outside the range of x do not
 * affect the range of y. */
arc_plot_box arc_plot_extent(const arc_plot_panel *panel) {
  arc_plot_box box = {NAN, NAN, NAN, NAN};
  for (size_t i = 0; i < panel->curve_count; i++)
    for (size_t j = 0; j < panel->curves[i].count; j++) {
      widen(panel->curves[i].x[j], &box.x0, &box.x1);
      if (between(&panel->x, panel->curves[i].x[j])) widen_y(&panel->curves[i], j, &box);
    }
  for (size_t j = 0; panel->field && j < 4 * panel->field->count; j++) {
    widen(panel->field->x[j], &box.x0, &box.x1);
    widen(panel->field->y[j], &box.y0, &box.y1);
  }
  take_range(&panel->x, &box.x0, &box.x1);
  take_range(&panel->y, &box.y0, &box.y1);
  return box;
}

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status check_axis(const arc_plot_axis *axis, const char *name, size_t panel,
                             arc_error *error) {
  if (isinf(axis->min) || isinf(axis->max))
    return arc_fail(error, ARC_ARGUMENT, "panel %zu: the %s range must be finite, got %g to %g",
                    panel, name, axis->min, axis->max);
  if (axis->min == axis->max)
    return arc_fail(error, ARC_ARGUMENT,
                    "panel %zu: the ends of the %s range must differ, got %g to %g", panel, name,
                    axis->min, axis->max);
  if (axis->log && (axis->min <= 0 || axis->max <= 0))
    return arc_fail(error, ARC_ARGUMENT,
                    "panel %zu: the %s range must be positive on a logarithmic axis, got %g to %g",
                    panel, name, axis->min, axis->max);
  return ARC_OK;
}

/* Returns true if a value is in the range of an axis. One or both ends of the range may be
 * automatic. */
static int inside(const arc_plot_axis *axis, double value) {
  double low = fmin(axis->min, axis->max), high = fmax(axis->min, axis->max);
  if (axis->log && !(value > 0)) return 0;
  if (isnan(axis->min) != isnan(axis->max)) /* only one end is set */
    return isnan(axis->min) ? value <= high : value >= low;
  return isfinite(value) && !(value < low) && !(value > high);
}

/* Returns, as a text, the reason why a curve cannot be drawn, or NULL if it can be drawn. */
static const char *no_points(const arc_plot_panel *panel, const arc_plot_curve *curve) {
  arc_plot_axis open_x = panel->x, open_y = panel->y;
  open_x.min = open_x.max = open_y.min = open_y.max = NAN;
  size_t finite = 0, drawable = 0;
  for (size_t i = 0; i < curve->count; i++) {
    finite += isfinite(curve->x[i]) && isfinite(curve->y[i]);
    drawable += inside(&open_x, curve->x[i]) && inside(&open_y, curve->y[i]);
  }
  if (curve->count == 0) return "has no points";
  if (finite == 0) return "has no point whose x and y are both finite numbers";
  return drawable == 0 ? "has no positive point for the logarithmic axis" : NULL;
}

/* Returns true if the colour is #rrggbb or in the list of colours. gnuplot itself would accept any
 * word as a colour and draw an unknown colour in black. */
static int is_colour(const char *colour) {
  static const char names[] = " " ARC_PLOT_COLOURS " ";
  char word[24];
  size_t length = strlen(colour);
  if (colour[0] == '#') return length == 7 && strspn(colour + 1, "0123456789abcdefABCDEF") == 6;
  if (length == 0 || length > 20 || strchr(colour, ' ')) return 0;
  snprintf(word, sizeof word, " %s ", colour);
  return strstr(names, word) != NULL;
}

static arc_status check_curve(const arc_plot_panel *panel, size_t number, size_t which,
                              arc_error *error) {
  const arc_plot_curve *curve = &panel->curves[which];
  char title[64] = "";
  if (curve->title) snprintf(title, sizeof title, " ('%.55s')", curve->title);
  const char *wrong = no_points(panel, curve);
  if (wrong)
    return arc_fail(error, ARC_ARGUMENT, "panel %zu: curve %zu%s %s", number, which + 1, title,
                    wrong);
  if (curve->colour && !is_colour(curve->colour))
    return arc_fail(error, ARC_ARGUMENT,
                    "panel %zu: curve %zu%s: colour must be \"#rrggbb\" or one of %s, got '%.60s'",
                    number, which + 1, title, ARC_PLOT_COLOURS, curve->colour);
  for (size_t j = 0; curve->error && j < curve->count; j++)
    if (!(curve->error[j] >= 0) || isinf(curve->error[j]))
      return arc_fail(error, ARC_ARGUMENT,
                      "panel %zu: curve %zu%s: error[%zu] must be a finite number >= 0, got %g",
                      number, which + 1, title, j + 1, curve->error[j]);
  if (curve->scaled && !isfinite(curve->value))
    return arc_fail(error, ARC_ARGUMENT, "panel %zu: curve %zu%s: value must be finite, got %g",
                    number, which + 1, title, curve->value);
  if ((int)curve->style < 0 || curve->style >= ARC_PLOT_STYLE_COUNT || curve->series < 0 ||
      curve->dash < 0 || !(curve->width >= 0) || isinf(curve->width))
    return arc_fail(error, ARC_ARGUMENT, "panel %zu: curve %zu%s has an invalid line style", number,
                    which + 1, title);
  return ARC_OK;
}

/* Fails if no curve has a point inside the ranges. gnuplot's own message in this case ("all points
 * y value undefined") does not name the cause. */
static arc_status check_visible(const arc_plot_panel *panel, size_t number, arc_error *error) {
  size_t seen = panel->field != NULL;
  for (size_t i = 0; i < panel->curve_count && !seen; i++)
    for (size_t j = 0; j < panel->curves[i].count && !seen; j++)
      seen = inside(&panel->x, panel->curves[i].x[j]) && isfinite(panel->curves[i].y[j]);
  if (seen) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "panel %zu: no point lies in the x range %g to %g", number,
                  panel->x.min, panel->x.max);
}

static arc_status check_field(const arc_plot_panel *panel, size_t number, arc_error *error) {
  const arc_plot_field *field = panel->field;
  size_t corners = field ? 4 * field->count : 0, finite = 0;
  for (size_t i = 0; i < corners; i++)
    finite += isfinite(field->x[i]) && isfinite(field->y[i]) && isfinite(field->value[i]);
  if (field && (field->count == 0 || finite < corners))
    return arc_fail(error, ARC_ARGUMENT,
                    "panel %zu: every corner of the field must have finite x, y and value; %zu of "
                    "%zu corners do",
                    number, finite, corners);
  if (field && (panel->x.log || panel->y.log))
    return arc_fail(error, ARC_ARGUMENT, "panel %zu: a field cannot be drawn on logarithmic axes",
                    number);
  return ARC_OK;
}

static arc_status check_panel(const arc_plot_panel *panel, size_t number, arc_error *error) {
  if (panel->curve_count == 0 && !panel->field)
    return arc_fail(error, ARC_ARGUMENT, "panel %zu: there is nothing to draw", number);
  arc_status status = check_axis(&panel->x, "x", number, error);
  if (status == ARC_OK) status = check_axis(&panel->y, "y", number, error);
  if (status == ARC_OK) status = check_axis(&panel->value, "value", number, error);
  if (status == ARC_OK) status = check_field(panel, number, error);
  for (size_t i = 0; i < panel->curve_count && status == ARC_OK; i++)
    status = check_curve(panel, number, i, error);
  return status == ARC_OK ? check_visible(panel, number, error) : status;
}

arc_status arc_plot_check(const arc_plot_figure *figure, arc_error *error) {
  int rows, columns;
  if (figure->panel_count == 0) return arc_fail(error, ARC_ARGUMENT, "there is nothing to draw");
  arc_plot_grid(figure, &rows, &columns);
  if ((size_t)rows * (size_t)columns < figure->panel_count)
    return arc_fail(error, ARC_ARGUMENT, "%zu panels do not fit a grid of %d rows and %d columns",
                    figure->panel_count, rows, columns);
  for (size_t i = 0; i < figure->panel_count; i++) {
    arc_status status = check_panel(&figure->panels[i], i + 1, error);
    if (status != ARC_OK) return status;
  }
  return ARC_OK;
}

/* Adds marks to lines of Braille dots, because these lines have no dashes that could distinguish
 * them without colours. */
#include <math.h>
#include <stdlib.h>

#include "plot/figure.h"

enum { MARKS = 5 }; /* number of marks on each curve */

static size_t titled(const arc_plot_panel *panel) {
  size_t count = 0;
  for (size_t i = 0; i < panel->curve_count; i++) count += panel->curves[i].title != NULL;
  return count;
}

int arc_dot_marked(const arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve) {
  if (!(w->canvas->fine || w->canvas->dots) || !curve->title) return 0;
  if (curve->style != ARC_PLOT_LINES && curve->style != ARC_PLOT_STEPS) return 0;
  for (size_t i = 0; i < curve->count; i++)
    if (!isfinite(curve->x[i]) || !isfinite(curve->y[i]))
      return 0; /* no marks on an interrupted curve, such as the edges of a mesh */
  return w->title_count > 1 || !panel || titled(panel) > 1;
}

/* Returns the position of a value on an axis as a fraction of the range of the axis. */
static double place(const arc_plot_axis *axis, double low, double high, double value) {
  return axis->log ? log(value / low) / log(high / low) : (value - low) / (high - low);
}

typedef struct point {
  double x, y, u, v; /* u, v: position as fractions of the frame */
} point;

static point point_at(const arc_plot_panel *panel, const arc_plot_curve *curve,
                      const arc_plot_box *box, size_t i) {
  return (point){curve->x[i], curve->y[i], place(&panel->x, box->x0, box->x1, curve->x[i]),
                 place(&panel->y, box->y0, box->y1, curve->y[i])};
}

/* Returns the distance between two points in fractions of the frame, or 0 if one of them is outside
 * the x range of the frame. */
static double length(point a, point b) {
  int seen = a.u >= -1e-9 && a.u <= 1 + 1e-9 && b.u >= -1e-9 && b.u <= 1 + 1e-9;
  double all = hypot(b.u - a.u, b.v - a.v);
  return seen && isfinite(all) ? all : 0;
}

/* Returns the position of a mark as a fraction of the length of the curve. The position depends on
 * the number of the series, so that the marks of coinciding curves do not overlap. */
static double share_of(int mark, int series) {
  return (mark + (series + 0.5) / ARC_DOT_MARKS) / MARKS;
}

static void write_marks(const arc_plot_panel *panel, const arc_plot_curve *curve,
                        const arc_plot_box *box, int series, arc_text *out) {
  double all = 0, gone = 0;
  int mark = 0;
  for (size_t i = 1; i < curve->count; i++)
    all += length(point_at(panel, curve, box, i - 1), point_at(panel, curve, box, i));
  for (size_t i = 1; i < curve->count && all > 0; i++) {
    point a = point_at(panel, curve, box, i - 1), b = point_at(panel, curve, box, i);
    double step = length(a, b);
    for (; mark < MARKS && step > 0 && share_of(mark, series) * all <= gone + step; mark++) {
      double share = (share_of(mark, series) * all - gone) / step;
      double y = curve->style == ARC_PLOT_STEPS ? a.y : a.y + share * (b.y - a.y);
      arc_text_format(out, "%.17g %.17g\n", a.x + share * (b.x - a.x), y);
    }
    gone += step;
  }
  /* One point is written in any case, because gnuplot 5.4 crashes on character marks without
   * points. */
  if (all == 0) arc_text_format(out, "%.17g %.17g\n", curve->x[0], curve->y[0]);
}

void arc_dot_marks_block(arc_writer *w, size_t number, const arc_plot_box *box) {
  const arc_plot_panel *panel = &w->figure->panels[number];
  for (size_t i = 0; w->canvas->dots && i < panel->curve_count; i++) {
    if (!arc_dot_marked(w, panel, &panel->curves[i])) continue;
    arc_text_format(w->out, "$m%zu_%zu << END\n", number, i);
    write_marks(panel, &panel->curves[i], box, arc_look_colour(w, &panel->curves[i], i) - 1,
                w->out);
    arc_text_word(w->out, "END\n");
  }
}

void arc_dot_marks_words(arc_writer *w, size_t number) {
  const arc_plot_panel *panel = &w->figure->panels[number];
  for (size_t i = 0; w->canvas->dots && i < panel->curve_count; i++) {
    if (!arc_dot_marked(w, panel, &panel->curves[i])) continue;
    int series = arc_look_colour(w, &panel->curves[i], i);
    arc_text_format(w->out, ", $m%zu_%zu using 1:2 with points linetype %d pointtype '%c' notitle",
                    number, i, series, ARC_DOT_MARK + series - 1);
  }
}

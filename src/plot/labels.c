/* Writes the titles of curves beside the frame, at the ends of the curves. */
#include <math.h>
#include <stdlib.h>

#include "plot/figure.h"

/* A curve with a title. `height` is the position of the title above the lower edge of the frame, as
 * a fraction of the frame's height. */
typedef struct label {
  size_t curve;
  double height;
} label;

double arc_labels_width(const arc_plot_panel *panel) {
  size_t longest = 0;
  for (size_t i = 0; i < panel->curve_count; i++) {
    const arc_plot_curve *curve = &panel->curves[i];
    size_t length = curve->labelled ? arc_text_characters(curve->title) : 0;
    longest = length > longest ? length : longest;
  }
  return longest ? 0.95 * (double)longest + 2.5 : 0;
}

static double share(const arc_plot_axis *axis, double low, double high, double value) {
  if (axis->log) low = log(low), high = log(high), value = log(value);
  double place = (value - low) / (high - low);
  return axis->reverse ? 1 - place : place;
}

/* Returns the height of the curve's last point inside the frame: above the frame's lower edge, as a
 * fraction of the frame's height. */
static double height_of(const arc_plot_panel *panel, const arc_plot_curve *curve,
                        const arc_plot_box *box) {
  double low = fmin(box->x0, box->x1), high = fmax(box->x0, box->x1), height = 0.5;
  for (size_t i = 0; i < curve->count; i++)
    if (curve->x[i] >= low && curve->x[i] <= high && isfinite(curve->y[i]))
      height = share(&panel->y, box->y0, box->y1, curve->y[i]);
  return isfinite(height) ? fmin(1, fmax(0, height)) : 0.5;
}

static int lower(const void *a, const void *b) {
  const label *p = a, *q = b;
  if (p->height != q->height) return p->height < q->height ? -1 : 1;
  return p->curve < q->curve ? -1 : 1;
}

/* Moves overlapping labels upwards. Then moves labels that are above the frame downwards, without
 * changing their order. */
static void spread(label *labels, size_t count, double gap) {
  for (size_t i = 1; i < count; i++)
    labels[i].height = fmax(labels[i].height, labels[i - 1].height + gap);
  double top = 1;
  for (size_t i = count; i-- > 0; top -= gap) labels[i].height = fmin(labels[i].height, top);
}

void arc_labels_write(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                      double rows) {
  label *labels = calloc(panel->curve_count + 1, sizeof *labels);
  size_t count = 0;
  if (!labels) w->out->failed = 1;
  for (size_t i = 0; labels && !w->canvas->text && i < panel->curve_count; i++)
    if (panel->curves[i].labelled && panel->curves[i].title)
      labels[count++] = (label){i, height_of(panel, &panel->curves[i], box)};
  if (count > 1) qsort(labels, count, sizeof *labels, lower);
  if (count > 0) spread(labels, count, fmin(1.1 / rows, 1.0 / (double)count));
  for (size_t i = 0; i < count; i++) {
    const arc_plot_curve *curve = &panel->curves[labels[i].curve];
    arc_text_format(w->out, "set label %zu ", i + 1);
    arc_writer_label(w, "", curve->title, "");
    arc_text_format(w->out, " at graph 1.015, graph %.6g left textcolor linetype %d\n",
                    labels[i].height, arc_look_colour(w, curve, labels[i].curve));
  }
  free(labels);
}

/* Writes one panel as gnuplot commands: settings, data, plot. */
#include <math.h>
#include <stdlib.h>

#include "plot/figure.h"

enum { LEVELS = 9 };

/* Characters for the levels of a field, denser for higher values. The characters of the frame are
 * not among them. */
static const char level_marks[LEVELS + 1] = ".,:;oxO#@";
static const char *const level_colours[LEVELS] = {"blue",  "blue",   "cyan",   "cyan", "green",
                                                  "green", "yellow", "yellow", "red"};

/* --- axes, heading, key ----------------------------------------------------------------------- */

static void end_of_range(arc_writer *w, double value, const char *after) {
  if (isnan(value))
    arc_text_word(w->out, "*");
  else
    arc_text_format(w->out, "%.17g", value);
  arc_text_word(w->out, after);
}

static void axis_words(arc_writer *w, const char *axis, const arc_plot_axis *a) {
  arc_text_format(w->out, "set %srange [", axis);
  end_of_range(w, a->min, ":");
  end_of_range(w, a->max, "]");
  arc_text_word(w->out,
                a->reverse && (isnan(a->min) || isnan(a->max)) ? " reverse\n" : " noreverse\n");
  arc_text_format(w->out, a->log ? "set logscale %s\n" : "unset logscale %s\n", axis);
  arc_text_format(w->out, "set %slabel ", axis);
  arc_writer_label(w, "", a->label ? a->label : "", "\n");
}

/* Writes the title and the y label. Characters cannot be rotated, so in a picture of characters
 * the y label is above its axis and the title is one line higher. */
static void heading(arc_writer *w, const arc_plot_panel *panel) {
  int above = w->canvas->text && panel->y.label;
  arc_writer_title(w, "set title ", panel->title ? panel->title : "", arc_panel_columns(w), "");
  arc_text_word(w->out, above ? " offset character 0,1\n" : " offset 0,0\n");
  arc_text_word(w->out, "unset label\n");
  if (!above) return;
  arc_writer_label(w, "set ylabel ''\nset label 99 ", panel->y.label,
                   " at graph 0, graph 1 left offset character -5,1\n");
}

static arc_plot_key place_of_key(const arc_writer *w, const arc_plot_panel *panel) {
  int levels = panel->field && w->canvas->text, titled = levels;
  for (size_t i = 0; i < panel->curve_count; i++) {
    const arc_plot_curve *curve = &panel->curves[i];
    titled |= curve->title && (w->canvas->text || !(curve->scaled || curve->labelled));
  }
  if (levels) return ARC_PLOT_KEY_RIGHT;
  return titled && !arc_look_one_key(w) ? panel->key : ARC_PLOT_KEY_NONE;
}

static void key_words(arc_writer *w, const arc_plot_panel *panel, const arc_plot_frame *frame,
                      int framed) {
  static const char *const places[] = {
      [ARC_PLOT_KEY_BELOW] = "below center horizontal Left reverse height 1",
      [ARC_PLOT_KEY_RIGHT] = "outside right top vertical Left reverse",
      [ARC_PLOT_KEY_TOP_LEFT] = "inside left top vertical Left reverse",
      [ARC_PLOT_KEY_TOP_RIGHT] = "inside right top vertical",
      [ARC_PLOT_KEY_BOTTOM_LEFT] = "inside left bottom vertical Left reverse",
      [ARC_PLOT_KEY_BOTTOM_RIGHT] = "inside right bottom vertical"};
  arc_plot_key place = place_of_key(w, panel);
  arc_text_word(w->out, "set key default\n");
  if (place == ARC_PLOT_KEY_NONE) {
    arc_text_word(w->out, "unset key\n");
    return;
  }
  arc_text_format(w->out, "set key on %s nobox%s\n", places[place],
                  w->canvas->text ? " width 1" : " samplen 2.5");
  if (place == ARC_PLOT_KEY_BELOW &&
      framed) /* without this command gnuplot draws the key at the edge of the canvas */
    arc_text_format(w->out, "set key at screen %.6g, screen %.6g center top horizontal height 0\n",
                    (frame->left + frame->right) / 2,
                    frame->bottom - (panel->x.label ? 3.2 : 2) / w->canvas->rows);
}

/* --- ranges ----------------------------------------------------------------------------------- */

static void grow(double *low, double *high, double share) {
  double more = share * (*high - *low) / 2;
  *low -= more;
  *high += more;
}

/* Returns true if the ranges of a panel with equal scales are extended to fill the frame: in
 * pictures of characters, and in figures with several panels, so that frames align. In pixels the
 * ranges of a field are not extended, because the frame would have empty margins. */
static int fills_frame(const arc_writer *w, const arc_plot_panel *panel) {
  return panel->equal && (w->canvas->text || (w->figure->panel_count > 1 && !panel->field));
}

static arc_plot_box shown_box(const arc_writer *w, const arc_plot_panel *panel,
                              const arc_plot_frame *frame) {
  arc_plot_box box = arc_plot_extent(panel);
  if (isnan(panel->x.min) && isnan(panel->x.max)) grow(&box.x0, &box.x1, 0.06);
  if (isnan(panel->y.min) && isnan(panel->y.max)) grow(&box.y0, &box.y1, 0.06);
  if (!fills_frame(w, panel)) return box;
  double wide =
      w->canvas->text ? 1 : (frame->right - frame->left) * w->canvas->width / frame->columns;
  double high =
      w->canvas->text ? 2 : (frame->top - frame->bottom) * w->canvas->height / frame->rows;
  double per_x = fabs(box.x1 - box.x0) / (wide * frame->columns);
  double per_y = fabs(box.y1 - box.y0) / (high * frame->rows);
  if (per_x > per_y && per_y > 0)
    grow(&box.y0, &box.y1, per_x / per_y - 1);
  else if (per_x > 0)
    grow(&box.x0, &box.x1, per_y / per_x - 1);
  return box;
}

static void box_words(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box) {
  arc_text_word(w->out, panel->equal && !fills_frame(w, panel) ? "set size ratio -1\n"
                                                               : "set size noratio\n");
  if (!panel->equal && !panel->field) return;
  if (box->x0 != box->x1) arc_text_format(w->out, "set xrange [%.17g:%.17g]\n", box->x0, box->x1);
  if (box->y0 != box->y1) arc_text_format(w->out, "set yrange [%.17g:%.17g]\n", box->y0, box->y1);
}

static void frame_words(arc_writer *w, const arc_plot_frame *frame) {
  arc_text_format(w->out, "set lmargin at screen %.6g\nset rmargin at screen %.6g\n", frame->left,
                  frame->right);
  arc_text_format(w->out, "set bmargin at screen %.6g\nset tmargin at screen %.6g\n", frame->bottom,
                  frame->top);
}

static double ticks_in_rows(const arc_writer *w, double rows) {
  return w->canvas->text ? rows / 2.2 : fmin(10, rows / 1.6);
}

static arc_ticks ticks_of_y(const arc_writer *w, const arc_plot_panel *panel,
                            const arc_plot_box *box, double rows) {
  return arc_ticks_up(&panel->y, box->y0, box->y1, ticks_in_rows(w, rows));
}

static arc_ticks ticks_of_x(const arc_writer *w, const arc_plot_panel *panel,
                            const arc_plot_box *box, double columns) {
  double most = w->canvas->text ? columns / 7 : fmin(10, columns / 6);
  return arc_ticks_across(&panel->x, box->x0, box->x1, most, columns);
}

size_t arc_panel_label(const arc_writer *w, const arc_plot_panel *panel, double rows) {
  arc_plot_box box = arc_plot_extent(panel);
  arc_ticks ticks = ticks_of_y(w, panel, &box, rows);
  size_t longest = ticks.longest + (ticks.powers && !w->canvas->text ? 2 : 0);
  for (size_t i = 0; panel->y.places && i < panel->y.place_count; i++)
    longest = i && longest > arc_text_characters(panel->y.words[i])
                  ? longest
                  : arc_text_characters(panel->y.words[i]);
  return longest;
}

/* Returns the width [characters] by which the last number of the x axis extends beyond the frame,
 * about half of the length of this number. */
static double half_number(const arc_writer *w, const arc_plot_panel *panel, double columns) {
  arc_plot_box box = arc_plot_extent(panel);
  arc_ticks ticks = ticks_of_x(w, panel, &box, columns);
  size_t last = panel->x.places && panel->x.place_count
                    ? arc_text_characters(panel->x.words[panel->x.place_count - 1])
                    : ticks.longest + (ticks.powers ? 2 : 0);
  return 0.55 * (double)last + 0.8;
}

/* Returns the width of a colour scale with its numbers and its label [columns]. gnuplot's default
 * margin has no space for the label beside long numbers. */
static double scale_width(const arc_plot_panel *panel, const double range[2]) {
  static const double bar = 6.5, label = 3;
  const arc_ticks ticks = arc_ticks_up(&panel->value, range[0], range[1], 10);
  return bar + (double)ticks.longest + (panel->value.label ? label : 0);
}

double arc_panel_right(const arc_writer *w, const arc_plot_panel *panel, double columns) {
  double range[2];
  if (w->canvas->text || panel->key == ARC_PLOT_KEY_RIGHT) return 0;
  if (panel->field) {
    const arc_plot_box box = arc_plot_extent(panel);
    arc_field_range(panel, &box, range);
  }
  if (panel->field || arc_look_scale(w, panel, range)) return scale_width(panel, range);
  return fmax(arc_labels_width(panel), half_number(w, panel, columns));
}

/* Sets border and grid lines. A panel with a field has no grid lines, because they would cover the
 * field. Pictures in characters do not use these settings. */
static void ground_words(arc_writer *w, const arc_plot_panel *panel) {
  if (w->canvas->text) return;
  arc_text_word(w->out, panel->field
                            ? "unset grid\nset border 15\nset xtics out\nset ytics out\n"
                            : "set border 3\nset xtics in\nset ytics in\n"
                              "set grid linecolor rgb '#e4e4e4' linewidth 0.7 linetype 1\n");
}

/* --- field ------------------------------------------------------------------------------------ */

static const double slim = 0.5; /* width of a character divided by the height of a row */

/* Returns the height of the drawn box [rows], which is lower than its frame if the axes have equal
 * scales. */
static double rows_of(const arc_plot_panel *panel, const arc_plot_box *box,
                      const arc_plot_frame *frame) {
  const double fitting = slim * frame->columns * (box->y1 - box->y0) / (box->x1 - box->x0);
  return panel->equal ? fmin(frame->rows, fitting) : frame->rows;
}

/* Returns the distance between the numbers of a colour scale as high as the box, without contour
 * lines. Returns 0 if gnuplot chooses the distance. */
static double scale_step(const arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                         const arc_plot_frame *frame, const double range[2]) {
  static const double enough = 14; /* [rows] from this height on gnuplot chooses the distance */
  const double rows = rows_of(panel, box, frame);
  return rows < enough ? arc_field_step(range, (int)fmax(0, ticks_in_rows(w, rows) - 2)) : 0;
}

/* Writes the colour palette: for fields of one sign, for fields of both signs (with white at zero,
 * except in greys), or for curves. */
static void colour_words(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                         const arc_plot_frame *frame, const double range[2]) {
  static const char *const palettes[][2] = {
      /* palettes for fields of one sign, for fields of both signs, and for curves (without light
       * colours, which would be hardly visible), each in colours and in greys */
      {"0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725'",
       "0 '#f7f7f7', 1 '#303030'"},
      {"0 '#2166ac', 1 '#92c5de', 2 '#f7f7f7', 3 '#f4a582', 4 '#b2182b'",
       "0 '#f7f7f7', 1 '#303030'"},
      {"0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#3fae5f', 4 '#c9a800'",
       "0 '#b0b0b0', 1 '#000000'"}};
  int which = !panel->field ? 2 : range[0] < 0 && range[1] > 0;
  arc_text_format(w->out, "set palette defined (%s)\n", palettes[which][w->canvas->grey]);
  arc_text_format(w->out, "set cbrange [%.17g:%.17g]\n", range[0], range[1]);
  /* contour lines are at the ticks of the colour scale */
  const int contours = panel->field && panel->levels;
  arc_ticks_of_scale(w, contours ? arc_field_step(range, panel->levels)
                                 : scale_step(w, panel, box, frame, range));
  arc_writer_label(w, "set cblabel ", panel->value.label ? panel->value.label : "",
                   " offset 1,0\n");
}

/* Samples of the field on a grid. The grid has as many cells as a reader can distinguish in the
 * picture. */
typedef struct grid {
  int columns, rows;
  double *values;
} grid;

static grid sample(arc_writer *w, const arc_plot_field *field, const arc_plot_box *box,
                   const arc_plot_frame *frame) {
  double wide = w->canvas->text ? 2 * frame->columns : fmin(8 * frame->columns, 640);
  double high = w->canvas->text ? 2 * frame->rows : fmin(18 * frame->rows, 640);
  grid g = {(int)wide, (int)high, NULL};
  g.values = malloc((size_t)g.columns * (size_t)g.rows * sizeof *g.values);
  if (g.values)
    arc_field_raster(field, box, g.columns, g.rows, g.values);
  else
    w->out->failed = 1;
  return g;
}

static int level_of(double value, const double range[2]) {
  double share = (value - range[0]) / (range[1] - range[0]);
  return isnan(share) ? -1 : (int)fmin(LEVELS - 1, fmax(0, floor(share * LEVELS)));
}

/* Writes one datablock of points for each level. Each block begins with a point outside the
 * frame, because gnuplot 5.4 crashes if a plot of character marks has no points. */
static void level_blocks(arc_writer *w, size_t number, const grid *g, const arc_plot_box *box,
                         const double range[2]) {
  double dx = (box->x1 - box->x0) / g->columns, dy = (box->y1 - box->y0) / g->rows;
  for (int k = 0; k < LEVELS; k++) {
    arc_text_format(w->out, "$l%zu_%d << END\n%.17g %.17g\n", number, k, 2 * box->x1 - box->x0,
                    2 * box->y1 - box->y0);
    for (int n = 0; n < g->columns * g->rows; n++)
      if (level_of(g->values[n], range) == k)
        arc_text_format(w->out, "%.17g %.17g\n", box->x0 + dx * (n % g->columns + 0.5),
                        box->y0 + dy * (n / g->columns + 0.5));
    arc_text_word(w->out, "END\n");
  }
}

/* Writes the samples as an image. The six digits of a sample are more exact than the resolution of
 * the colours. */
static void image_block(arc_writer *w, size_t number, const grid *g) {
  arc_text_format(w->out, "$f%zu << END\n", number);
  for (int n = 0; n < g->columns * g->rows; n++) {
    if (isnan(g->values[n]))
      arc_text_word(w->out, "NaN");
    else
      arc_text_format(w->out, "%.6g", g->values[n]);
    arc_text_word(w->out, (n + 1) % g->columns ? " " : "\n");
  }
  arc_text_word(w->out, "END\n");
}

static void image_words(arc_writer *w, size_t number, const grid *g, const arc_plot_box *box) {
  double dx = (box->x1 - box->x0) / g->columns, dy = (box->y1 - box->y0) / g->rows;
  arc_text_format(w->out, " $f%zu matrix using (%.17g+%.17g*$1):(%.17g+%.17g*$2):3", number,
                  box->x0 + dx / 2, dx, box->y0 + dy / 2, dy);
  arc_text_word(w->out, " with image notitle");
}

/* Writes the plot command of the levels. The highest level is written first, so that it is the
 * first in the key. */
static void text_levels(arc_writer *w, size_t number, const double range[2]) {
  double step = (range[1] - range[0]) / LEVELS;
  for (int k = LEVELS - 1; k >= 0; k--) {
    arc_text_format(w->out, "%s $l%zu_%d using 1:2 with points pointtype '%c'",
                    k == LEVELS - 1 ? "" : ",", number, k, level_marks[k]);
    if (w->canvas->colour) arc_text_format(w->out, " linecolor rgb '%s'", level_colours[k]);
    arc_text_format(w->out, " title '%.3g to %.3g'", range[0] + k * step,
                    range[0] + (k + 1) * step);
  }
}

/* --- data and plot ---------------------------------------------------------------------------- */

static void curve_blocks(arc_writer *w, size_t number) {
  const arc_plot_panel *panel = &w->figure->panels[number];
  for (size_t i = 0; i < panel->curve_count; i++) {
    arc_text_format(w->out, "$d%zu_%zu << END\n", number, i);
    arc_data_curve(panel, &panel->curves[i], w->out);
    arc_text_word(w->out, "END\n");
  }
}

/* Writes the contour lines and their numbers. Returns the number of segments, or 0 if there are
 * no contour lines. */
static size_t contour_block(arc_writer *w, size_t number, const arc_plot_box *box,
                            const arc_plot_frame *frame, const double range[2]) {
  const arc_plot_panel *panel = &w->figure->panels[number];
  if (!panel->field || w->canvas->text) return 0;
  arc_text labels = {0};
  const double rows = rows_of(panel, box, frame);
  const double across = rows / slim * (box->x1 - box->x0) / (box->y1 - box->y0);
  const double size[2] = {rows, panel->equal ? across : frame->columns};
  arc_text_format(w->out, "$k%zu << END\n", number);
  size_t count = arc_field_contours(panel->field, box, range, panel->levels, size, w->out, &labels);
  arc_text_format(w->out, "END\n$n%zu << END\n", number);
  if (labels.length > 0) arc_text_add(w->out, labels.data, labels.length);
  arc_text_word(w->out, "END\n");
  w->out->failed |= labels.failed;
  arc_text_free(&labels);
  return count;
}

/* Hides everything except the curves, for the picture of dots. Settings that affect the position
 * of the curves are kept. */
static void hide_words(arc_writer *w, const arc_plot_panel *panel) {
  arc_text_word(w->out, "set title ''\nset xlabel ''\nset ylabel ''\nunset label\nunset key\n"
                        "unset border\n");
  arc_text_word(w->out, panel->x.places ? "unset xtics\n" : "set format x ''\nset xtics scale 0\n");
  arc_text_word(w->out, panel->y.places ? "unset ytics\n" : "set format y ''\nset ytics scale 0\n");
  if (!panel->x.places && !panel->x.log) arc_text_word(w->out, "set xtics add ('' 0)\n");
  if (!panel->y.places && !panel->y.log) arc_text_word(w->out, "set ytics add ('' 0)\n");
}

static void plot_command(arc_writer *w, size_t number, const grid *g, const arc_plot_box *box,
                         const double range[2], size_t contours) {
  const arc_plot_panel *panel = &w->figure->panels[number];
  arc_text_word(w->out, "plot");
  int field = panel->field != NULL && !w->canvas->dots;
  if (field && w->canvas->text) text_levels(w, number, range);
  if (!field && panel->curve_count == 0) arc_text_word(w->out, " NaN notitle");
  if (field && !w->canvas->text) image_words(w, number, g, box);
  if (contours)
    arc_text_format(w->out, ", $k%zu using 1:2 with lines linecolor rgb '#a0000000' linewidth 0.6",
                    number);
  if (contours) {
    arc_text_word(w->out, " notitle");
    arc_text_format(w->out, ", $n%zu using 1:2:3 with labels boxed textcolor rgb '#303030' notitle",
                    number);
  }
  for (size_t i = 0; i < panel->curve_count; i++) {
    const int apart = arc_look_bars_apart(w, &panel->curves[i]);
    arc_text_word(w->out, i || field ? "," : "");
    if (apart) {
      arc_text_format(w->out, " $d%zu_%zu using 1:($2-$3):(0):(2*$3)", number, i);
      arc_look_bars(w, panel, i);
      arc_text_word(w->out, ",");
    }
    arc_text_format(w->out, " $d%zu_%zu using 1:2%s", number, i,
                    panel->curves[i].error && !apart ? ":3" : "");
    arc_look_curve(w, panel, i);
  }
  arc_dot_marks_words(w, number);
  arc_text_word(w->out, "\n");
}

/* Computes the range of the colours of a field. If the values have both signs, the range is
 * symmetric about zero. */
static void values_shown(const arc_plot_panel *panel, const arc_plot_box *box, double range[2]) {
  range[0] = range[1] = 0;
  if (!panel->field) return;
  arc_field_range(panel, box, range);
  int open = isnan(panel->value.min) && isnan(panel->value.max);
  if (open && range[0] < 0 && range[1] > 0) {
    range[1] = fmax(-range[0], range[1]);
    range[0] = -range[1];
  }
}

/* Returns the ranges that gnuplot shows, with automatic ends of the y axis extended to the next
 * tick. */
static arc_plot_box to_ticks(const arc_writer *w, const arc_plot_panel *panel, double rows) {
  arc_plot_box box = arc_plot_extent(panel);
  double step = ticks_of_y(w, panel, &box, rows).step;
  if (step > 0 && isnan(panel->y.min)) box.y0 = step * floor(box.y0 / step + 1e-9);
  if (step > 0 && isnan(panel->y.max)) box.y1 = step * ceil(box.y1 / step - 1e-9);
  return box;
}

static void settings(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                     const arc_plot_frame *frame, int framed, const double range[2]) {
  axis_words(w, "x", &panel->x);
  axis_words(w, "y", &panel->y);
  arc_plot_box data = panel->equal || panel->field ? *box : arc_plot_extent(panel);
  arc_ticks_write(w, "x", &panel->x, ticks_of_x(w, panel, &data, frame->columns));
  arc_ticks_write(w, "y", &panel->y, ticks_of_y(w, panel, &data, frame->rows));
  box_words(w, panel, box);
  ground_words(w, panel);
  heading(w, panel);
  key_words(w, panel, frame, framed);
  double scale[2];
  if (panel->field && !w->canvas->text) colour_words(w, panel, box, frame, range);
  if (!panel->field && arc_look_scale(w, panel, scale)) colour_words(w, panel, box, frame, scale);
  arc_plot_box seen = to_ticks(w, panel, frame->rows);
  arc_labels_write(w, panel, &seen, frame->rows);
}

static void margins(arc_writer *w, const arc_plot_panel *panel, const arc_plot_frame *frame,
                    int framed) {
  if (framed) {
    frame_words(w, frame);
    return;
  }
  if (w->canvas->text) {
    arc_text_format(w->out, "set tmargin %d\n",
                    1 + arc_title_lines(panel->title, arc_panel_columns(w)) +
                        (panel->y.label != NULL));
    return;
  }
  const double right = arc_panel_right(w, panel, frame->columns);
  if (right > 0) arc_text_format(w->out, "set rmargin %g\n", right);
}

void arc_panel_write(arc_writer *w, size_t number, const arc_plot_frame *frame, int framed) {
  const arc_plot_panel *panel = &w->figure->panels[number];
  arc_plot_box box = shown_box(w, panel, frame);
  double range[2];
  grid g = {0, 0, NULL};
  int dotted = w->canvas->fine || w->canvas->dots;
  framed = framed || dotted || (w->canvas->text && (panel->field || panel->equal));
  values_shown(panel, &box, range);
  if (panel->field) g = sample(w, panel->field, &box, frame);
  if (g.values && w->canvas->text) level_blocks(w, number, &g, &box, range);
  if (g.values && !w->canvas->text) image_block(w, number, &g);
  curve_blocks(w, number);
  size_t contours = contour_block(w, number, &box, frame, range);
  arc_plot_box seen = to_ticks(w, panel, frame->rows);
  arc_dot_marks_block(w, number, &seen);
  margins(w, panel, frame, framed);
  settings(w, panel, &box, frame, framed, range);
  if (w->canvas->dots) hide_words(w, panel);
  plot_command(w, number, &g, &box, range, contours);
  free(g.values);
}

/* Writes a figure as gnuplot commands. A single panel has gnuplot's margins. The margins of
 * several panels are computed in characters and written as fractions of the canvas, so that the
 * frames align for tick labels of any length. */
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"

/* Margins around the frame of a panel, in characters. */
typedef struct margins {
  double left, right, top, bottom;
} margins;

static double longest_title(const arc_plot_panel *panel) {
  size_t longest = 0;
  for (size_t i = 0; i < panel->curve_count; i++) {
    size_t length = arc_text_characters(panel->curves[i].title);
    longest = length > longest ? length : longest;
  }
  return (double)longest;
}

/* Computes margins that are sufficient for all panels. `columns` is the line width of a panel's
 * title, `wide` is the width of a panel with its margins. */
static margins margins_of(const arc_writer *w, double columns, double wide) {
  const arc_plot_figure *figure = w->figure;
  int text = w->canvas->text;
  margins r = {text ? 8 : 7.5, text ? 2 : 2.5, 0.7, 2};
  for (size_t i = 0; i < figure->panel_count; i++) {
    const arc_plot_panel *panel = &figure->panels[i];
    int labelled = panel->y.label != NULL;
    int titled = arc_title_lines(panel->title, columns);
    double range[2];
    if (panel->field) r.right = text ? 25 : 13;
    if (arc_look_scale(w, panel, range)) r.right = 13;
    r.right = fmax(r.right, arc_panel_right(w, panel, wide));
    if (panel->key == ARC_PLOT_KEY_RIGHT) r.right = fmax(r.right, longest_title(panel) + 9);
    if (panel->x.label) r.bottom = text ? 3 : 3.2;
    r.top = fmax(r.top, text ? titled + labelled + 1 : titled ? 1.5 + titled : 0.7);
    if (!text && labelled) r.left = 9.5;
  }
  return r;
}

/* Returns the number of rows that the keys below the panels need. */
static double own_keys(const arc_writer *w) {
  double lines = 0;
  for (size_t i = 0; i < w->figure->panel_count; i++)
    lines = fmax(lines, arc_look_own_key_rows(w, &w->figure->panels[i]));
  return lines > 0 ? lines + 0.2 : 0;
}

/* Returns the left margin, which is the same for all panels. It is computed from the longest tick
 * label of all panels, so that the frames align. */
static double left_of_frames(const arc_writer *w, double least, double rows) {
  int labelled = 0;
  size_t longest = 0;
  for (size_t i = 0; i < w->figure->panel_count; i++) {
    const arc_plot_panel *panel = &w->figure->panels[i];
    size_t length = arc_panel_label(w, panel, rows);
    longest = length > longest ? length : longest;
    labelled |= panel->y.label != NULL;
  }
  double numbers = (double)longest, wide = w->canvas->text ? numbers + 2 : 1.15 * numbers + 1.5;
  return fmax(least, wide + (labelled && !w->canvas->text ? 3.2 : 0));
}

static arc_plot_frame frame_of(const arc_writer *w, size_t number) {
  int rows, columns;
  arc_plot_grid(w->figure, &rows, &columns);
  double above = arc_title_lines(w->figure->title, w->canvas->columns);
  if (above > 0 && !w->canvas->text) above += 0.6;
  double below = arc_look_key_rows(w) + (arc_look_one_key(w) && !w->canvas->text ? 0.6 : 0);
  double wide = w->canvas->columns / columns;
  margins r = margins_of(w, arc_panel_columns(w), wide);
  double high = (w->canvas->rows - above - below) / rows;
  double left = wide * (double)(number % (size_t)columns);
  r.left = left_of_frames(w, r.left, high - r.top - r.bottom - own_keys(w));
  double top = w->canvas->rows - above - high * (double)(number / (size_t)columns);
  arc_plot_frame frame = {.left = left + r.left,
                          .right = fmax(left + wide - r.right, left + r.left + 2),
                          .top = top - r.top,
                          .bottom = fmin(top - high + r.bottom + own_keys(w), top - r.top - 1)};
  if (w->canvas->text) {
    frame.left = floor(frame.left), frame.right = floor(frame.right);
    frame.top = floor(frame.top), frame.bottom = floor(frame.bottom);
  }
  frame.columns = fmax(3, frame.right - frame.left);
  frame.rows = fmax(3, frame.top - frame.bottom);
  frame.left /= w->canvas->columns, frame.right /= w->canvas->columns;
  frame.top /= w->canvas->rows, frame.bottom /= w->canvas->rows;
  return frame;
}

static void common_settings(arc_writer *w) {
  arc_text_word(w->out, "set encoding utf8\nunset minussign\n");
  if (!w->canvas->text)
    arc_text_word(w->out,
                  "set minussign\nset xtics nomirror\nset ytics nomirror\n"
                  "set style textbox opaque fillcolor rgb '#ffffff' noborder margins 0.4,0.3\n");
  arc_look_series(w);
}

static void several_panels(arc_writer *w) {
  const char *title = w->figure->title && !w->canvas->dots ? w->figure->title : "";
  arc_writer_title(w, "set multiplot title ", title, w->canvas->columns, "\n");
  for (size_t i = 0; i < w->figure->panel_count; i++) {
    arc_plot_frame frame = frame_of(w, i);
    arc_panel_write(w, i, &frame, 1);
  }
  if (arc_look_one_key(w) && !w->canvas->dots) arc_look_draw_key(w);
  arc_text_word(w->out, "unset multiplot\n");
}

static void one_panel(arc_writer *w) {
  arc_plot_frame frame = frame_of(w, 0);
  arc_panel_write(w, 0, &frame, 0);
}

static void write_panels(const arc_plot_figure *figure, const arc_canvas *canvas,
                         arc_text *script) {
  arc_writer w = {figure, canvas, script, NULL, 0};
  arc_look_collect(&w);
  if (!script->failed) {
    common_settings(&w);
    if (figure->panel_count == 1)
      one_panel(&w);
    else
      several_panels(&w);
  }
  free(w.titles);
}

static void write_figure(const arc_plot_figure *figure, const arc_canvas *canvas,
                         arc_text *script) {
  arc_plot_figure shown = *figure;
  arc_plot_panel *panels = calloc(figure->panel_count, sizeof *panels);
  if (!panels) {
    script->failed = 1;
    return;
  }
  memcpy(panels, figure->panels, figure->panel_count * sizeof *panels);
  arc_plot_share(panels, figure->panel_count);
  for (size_t i = 0; i < figure->panel_count; i++) arc_plot_clear(canvas, &panels[i]);
  /* A single panel without a title has the title of the figure. */
  if (figure->panel_count == 1 && !panels->title) panels->title = figure->title;
  shown.panels = panels;
  write_panels(&shown, canvas, script);
  free(panels);
}

/* Writes the commands in the C locale, because gnuplot reads numbers with a decimal point. */
void arc_plot_commands(const arc_plot_figure *figure, const arc_canvas *canvas, arc_text *script) {
  locale_t c = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
  if (!c) {
    script->failed = 1;
    return;
  }
  locale_t before = uselocale(c);
  write_figure(figure, canvas, script);
  uselocale(before);
  freelocale(c);
}

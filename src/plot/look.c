/* How curves look, a user's words among the commands, and the key that several panels share. Leans
 * on text.c. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"

enum { SERIES = 8 };

/* Distinct also for eyes that see fewer colours; for characters the terminal's own six. */
static const char *const pixel_colours[SERIES] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
static const char *const text_colours[SERIES] = {"red",  "green",  "blue", "magenta",
                                                 "cyan", "yellow", "red",  "green"};

void arc_look_series(arc_writer *w) {
  for (int i = 0; i < SERIES; i++)
    if (w->canvas->text && w->canvas->colour)
      arc_text_format(w->out, "set linetype %d linecolor rgb '%s'\n", i + 1, text_colours[i]);
    else if (!w->canvas->text)
      arc_text_format(
          w->out, "set linetype %d linecolor rgb '%s' linewidth 1.6 pointtype %d pointsize 0.7\n",
          i + 1, pixel_colours[i], (int[]){7, 5, 9, 11, 13, 6, 4, 8}[i]);
}

void arc_writer_words(arc_writer *w, const char *before, const char *words, const char *after) {
  arc_text_word(w->out, before);
  arc_text_quoted(w->out, words, w->canvas->ascii);
  arc_text_word(w->out, after);
}

/* --- titles ----------------------------------------------------------------------------------- */

int arc_look_one_key(const arc_writer *w) {
  return w->figure->one_key && w->figure->panel_count > 1 && w->title_count > 0;
}

size_t arc_look_title(const arc_writer *w, const char *title) {
  size_t i = 0;
  while (i < w->title_count && strcmp(w->titles[i], title) != 0) i++;
  return i;
}

void arc_look_collect(arc_writer *w) {
  const arc_plot_figure *figure = w->figure;
  size_t room = 1;
  for (size_t p = 0; p < figure->panel_count; p++) room += figure->panels[p].curve_count;
  w->titles = calloc(room, sizeof *w->titles);
  if (!w->titles) {
    w->out->failed = 1;
    return;
  }
  for (size_t p = 0; p < figure->panel_count; p++)
    for (size_t c = 0; c < figure->panels[p].curve_count; c++) {
      const char *title = figure->panels[p].curves[c].title;
      if (title && arc_look_title(w, title) == w->title_count) w->titles[w->title_count++] = title;
    }
}

double arc_look_key_rows(const arc_writer *w) {
  size_t longest = 0;
  if (!arc_look_one_key(w)) return 0;
  for (size_t i = 0; i < w->title_count; i++) {
    size_t length = arc_text_characters(w->titles[i]);
    longest = length > longest ? length : longest;
  }
  double in_a_row = fmax(1, floor(w->canvas->columns / ((double)longest + 14)));
  return ceil((double)w->title_count / in_a_row);
}

/* --- curves ----------------------------------------------------------------------------------- */

/* Colour and dash of a curve, both from 1. When the colours are through they come again dashed;
 * characters have no dashes, and take another mark instead. */
typedef struct pen {
  int series, dash;
} pen;

static pen pen_of(const arc_writer *w, const arc_plot_curve *curve, size_t position) {
  if (arc_look_one_key(w) && curve->title) position = arc_look_title(w, curve->title);
  if (curve->series > 0) position = (size_t)curve->series - 1;
  pen p = {(int)(position % SERIES) + 1, (int)(position / SERIES % 5) + 1};
  if (curve->dash > 0) p.dash = (curve->dash - 1) % 5 + 1;
  if (w->canvas->text) p.series = (p.series - 1 + 3 * (p.dash - 1)) % SERIES + 1;
  return p;
}

static void style_words(arc_writer *w, const arc_plot_panel *panel, arc_plot_style style) {
  static const char *const with[ARC_PLOT_STYLE_COUNT] = {[ARC_PLOT_LINES] = "lines",
                                                         [ARC_PLOT_POINTS] = "points",
                                                         [ARC_PLOT_LINESPOINTS] = "linespoints",
                                                         [ARC_PLOT_STEPS] = "steps",
                                                         [ARC_PLOT_FILLED] = "filledcurves",
                                                         [ARC_PLOT_IMPULSES] = "impulses"};
  arc_text_format(w->out, " with %s", with[style]);
  if (style != ARC_PLOT_FILLED) return;
  arc_text_word(w->out, panel && panel->y.log ? " x1" : " y1=0");
  if (!w->canvas->text) arc_text_word(w->out, " fillstyle transparent solid 0.35 noborder");
}

static void look(arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve,
                 size_t position) {
  pen p = pen_of(w, curve, position);
  style_words(w, panel, curve->style);
  arc_text_format(w->out, " linetype %d", p.series);
  if (curve->colour) arc_writer_words(w, " linecolor rgb ", curve->colour, "");
  if (curve->width > 0) arc_text_format(w->out, " linewidth %g", 1.6 * curve->width);
  if (p.dash > 1) arc_text_format(w->out, " dashtype %d", p.dash);
}

/* In characters the sample of a line would touch its title. */
static void title_words(arc_writer *w, const char *title) {
  arc_text_word(w->out, w->canvas->text && *title ? " title ' '." : " title ");
  arc_writer_words(w, "", title, "");
}

void arc_look_curve(arc_writer *w, const arc_plot_panel *panel, size_t position) {
  const arc_plot_curve *curve = &panel->curves[position];
  look(w, panel, curve, position);
  title_words(w, curve->title ? curve->title : "");
}

/* --- the key of all panels -------------------------------------------------------------------- */

/* The first curve of a title shows how all of that title look. */
static const arc_plot_curve *first_of(const arc_writer *w, size_t title, size_t *position) {
  *position = 0;
  for (size_t p = 0; p < w->figure->panel_count; p++)
    for (size_t c = 0; c < w->figure->panels[p].curve_count; c++) {
      const arc_plot_curve *curve = &w->figure->panels[p].curves[c];
      *position = c;
      if (curve->title && arc_look_title(w, curve->title) == title) return curve;
    }
  return NULL;
}

void arc_look_draw_key(arc_writer *w) {
  double height = (arc_look_key_rows(w) + 0.6) / w->canvas->rows;
  arc_text_word(
      w->out, "unset border\nunset tics\nunset label\nunset logscale\nunset colorbox\n"
              "set size noratio\nset title ''\nset xlabel ''\nset ylabel ''\n"
              "set lmargin at screen 0\nset rmargin at screen 1\n"
              "set bmargin at screen 0\n"
              "set xrange [0:1]\nset yrange [0:1]\n"
              "set key on inside center center horizontal Left reverse width 2 noenhanced nobox\n");
  arc_text_format(w->out, "set tmargin at screen %.6g\nplot", height);
  for (size_t i = 0; i < w->title_count; i++) {
    size_t position;
    const arc_plot_curve *curve = first_of(w, i, &position);
    arc_text_word(w->out, i ? ", NaN" : " NaN");
    if (curve) look(w, NULL, curve, position);
    title_words(w, w->titles[i]);
  }
  arc_text_word(w->out, "\n");
}

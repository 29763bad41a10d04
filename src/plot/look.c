/* Writes the styles of curves, user texts in commands, and the common key. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"

enum { SERIES = 8, KEY_ENTRIES = 8 };

/* Colours of the curves in pictures of pixels, which colour-blind readers can distinguish. Pictures
 * in characters use six colours of the terminal instead. */
static const char *const pixel_colours[SERIES] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
static const char *const grey_colours[SERIES] = {"#000000", "#808080", "#484848", "#a0a0a0",
                                                 "#606060", "#b4b4b4", "#242424", "#909090"};
static const char *const area_greys[SERIES] = {"#404040", "#b0b0b0", "#000000", "#c8c8c8",
                                               "#606060", "#888888", "#202020", "#d8d8d8"};
static const char *const text_colours[SERIES] = {"blue",  "red",    "cyan", "magenta",
                                                 "green", "yellow", "blue", "red"};

/* Dash patterns, which can be distinguished without colours. The first pattern is a solid line. */
static const char *const dashes[SERIES] = {"solid",           "(14,6)",    "(20,6,4,6)",
                                           "(7,5)",           "(30,7)",    "(14,5,4,5,4,5)",
                                           "(10,5,10,5,4,5)", "(30,6,7,6)"};

/* Numbers of gnuplot's marks. Curves of points have open marks, which do not hide other points. */
static const int line_marks[SERIES] = {7, 5, 9, 11, 13, 15, 2, 1};
static const int open_marks[SERIES] = {6, 4, 8, 10, 12, 14, 2, 1};

void arc_look_series(arc_writer *w) {
  for (int i = 0; i < SERIES; i++)
    if (w->canvas->text && w->canvas->colour)
      arc_text_format(w->out, "set linetype %d linecolor rgb '%s'\n", i + 1, text_colours[i]);
    else if (!w->canvas->text)
      arc_text_format(
          w->out, "set linetype %d linecolor rgb '%s' linewidth 1.6 pointtype %d pointsize 0.7\n",
          i + 1, (w->canvas->grey ? grey_colours : pixel_colours)[i], line_marks[i]);
}

void arc_writer_words(arc_writer *w, const char *before, const char *words, const char *after) {
  arc_text_word(w->out, before);
  arc_text_quoted(w->out, words, w->canvas->ascii);
  arc_text_word(w->out, after);
}

/* Writes a label in double quotes; a long label is broken into lines. If `marked` is true, the
 * label has subscripts, superscripts or powers and is written as gnuplot's enhanced text. */
static void add_label(arc_writer *w, const char *words, double columns, int marked) {
  arc_text shown = {0};
  size_t count = arc_text_line(words, columns);
  char *line = strndup(words, count);
  if (line && marked)
    arc_text_enhanced(&shown, line);
  else if (line)
    arc_text_word(&shown, line);
  if (!line || shown.failed)
    w->out->failed = 1;
  else
    arc_text_quoted(w->out, shown.data ? shown.data : "", w->canvas->ascii);
  free(line);
  arc_text_free(&shown);
  while (words[count] == ' ') count++;
  if (!words[count] || count == 0) return;
  arc_text_word(w->out, ".\"\\n\".");
  add_label(w, words + count, columns, marked);
}

void arc_writer_title(arc_writer *w, const char *before, const char *words, double columns,
                      const char *after) {
  arc_text greek = {0};
  arc_text_greek(&greek, words);
  int marked = !w->canvas->text && greek.data && arc_text_marked(greek.data);
  arc_text_word(w->out, before);
  add_label(w, greek.data ? greek.data : "", columns, marked);
  arc_text_word(w->out, marked ? " enhanced" : " noenhanced");
  arc_text_word(w->out, after);
  w->out->failed |= greek.failed;
  arc_text_free(&greek);
}

void arc_writer_label(arc_writer *w, const char *before, const char *words, const char *after) {
  arc_writer_title(w, before, words, INFINITY, after);
}

int arc_title_lines(const char *words, double columns) {
  int lines = 0;
  if (!words) return 0;
  while (*words) {
    words += arc_text_line(words, columns);
    while (*words == ' ') words++;
    lines++;
  }
  return lines;
}

/* --- colour scale ----------------------------------------------------------------------------- */

static int is_scaled(const arc_writer *w, const arc_plot_curve *curve) {
  return curve->scaled && !w->canvas->text;
}

int arc_look_scale(const arc_writer *w, const arc_plot_panel *panel, double range[2]) {
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < panel->curve_count; i++)
    if (is_scaled(w, &panel->curves[i])) {
      low = fmin(low, panel->curves[i].value);
      high = fmax(high, panel->curves[i].value);
    }
  if (low > high) return 0;
  range[0] = isnan(panel->value.min) ? low : panel->value.min;
  range[1] = isnan(panel->value.max) ? high : panel->value.max;
  if (range[0] == range[1]) range[1] += fmax(1e-12, fabs(range[0]) * 1e-3);
  return 1;
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
  size_t capacity = 1;
  for (size_t p = 0; p < figure->panel_count; p++) capacity += figure->panels[p].curve_count;
  w->titles = calloc(capacity, sizeof *w->titles);
  if (!w->titles) {
    w->out->failed = 1;
    return;
  }
  for (size_t p = 0; p < figure->panel_count; p++)
    for (size_t c = 0; c < figure->panels[p].curve_count; c++) {
      const arc_plot_curve *curve = &figure->panels[p].curves[c];
      const char *title = curve->title;
      if (title && !is_scaled(w, curve) && !curve->labelled &&
          arc_look_title(w, title) == w->title_count)
        w->titles[w->title_count++] = title;
    }
}

/* Returns true if a curve has an entry in the key. If many curves are coloured by value, the key of
 * a picture in characters lists only the first, the last and some between them. */
static int in_key(const arc_writer *w, const arc_plot_panel *panel, size_t position) {
  const arc_plot_curve *curve = &panel->curves[position];
  size_t last = panel->curve_count - 1;
  if (!curve->title || is_scaled(w, curve) || (curve->labelled && !w->canvas->text)) return 0;
  if (!curve->scaled || last < KEY_ENTRIES) return 1;
  for (size_t k = 0; k < KEY_ENTRIES; k++)
    if (position == k * last / (KEY_ENTRIES - 1)) return 1;
  return 0;
}

/* Returns the number of lines of a key with entries side by side. An entry is a title with a sample
 * of the line. */
static double lines_of_key(size_t titles, size_t longest, double columns) {
  const double in_a_row = fmax(1, floor(columns / ((double)longest + 14)));
  return ceil((double)titles / in_a_row);
}

double arc_look_key_rows(const arc_writer *w) {
  size_t longest = 0;
  if (!arc_look_one_key(w)) return 0;
  for (size_t i = 0; i < w->title_count; i++) {
    size_t length = arc_text_characters(w->titles[i]);
    longest = length > longest ? length : longest;
  }
  return lines_of_key(w->title_count, longest, w->canvas->columns);
}

double arc_panel_columns(const arc_writer *w) {
  int rows, columns;
  arc_plot_grid(w->figure, &rows, &columns);
  return (w->canvas->text ? 0.95 : 0.82) * w->canvas->columns /
         columns; /* length of a line of a panel's title [characters] */
}

double arc_look_own_key_rows(const arc_writer *w, const arc_plot_panel *panel) {
  size_t longest = 0, count = 0;
  if (arc_look_one_key(w) || panel->key != ARC_PLOT_KEY_BELOW) return 0;
  for (size_t i = 0; i < panel->curve_count; i++) {
    if (!in_key(w, panel, i)) continue;
    size_t length = arc_text_characters(panel->curves[i].title);
    longest = length > longest ? length : longest;
    count++;
  }
  return lines_of_key(count, longest, arc_panel_columns(w));
}

/* --- curves ----------------------------------------------------------------------------------- */

/* Colour and dash pattern of a curve, as numbers from 1. Each of the first eight curves has its own
 * colour and pattern; further curves combine the colours with other patterns. Pictures of
 * characters have different marks instead of dash patterns. */
typedef struct pen {
  int series, dash;
} pen;

static pen pen_of(const arc_writer *w, const arc_plot_curve *curve, size_t position) {
  if (arc_look_one_key(w) && curve->title) position = arc_look_title(w, curve->title);
  if (curve->series > 0) position = (size_t)curve->series - 1;
  pen p = {(int)(position % SERIES) + 1, (int)((position + position / SERIES) % SERIES) + 1};
  int round = (int)(position / SERIES);
  if (curve->dash > 0) p.dash = (curve->dash - 1) % SERIES + 1;
  if (curve->dash > 0) round = p.dash - 1;
  if (w->canvas->text) p.series = (p.series - 1 + 3 * round) % SERIES + 1;
  return p;
}

int arc_look_colour(const arc_writer *w, const arc_plot_curve *curve, size_t position) {
  return pen_of(w, curve, position).series;
}

/* Returns true if a filled curve is closed, such as the outline of a band. The area of any other
 * filled curve extends down to zero. */
static int comes_back(const arc_plot_curve *curve) {
  int there = 0, back = 0;
  for (size_t i = 1; i < curve->count; i++) {
    there = there || curve->x[i] > curve->x[i - 1];
    back = back || curve->x[i] < curve->x[i - 1];
  }
  return there && back;
}

enum { MANY = 60 }; /* a curve with more points has small dots instead of marks */

int arc_look_bars_apart(const arc_writer *w, const arc_plot_curve *curve) {
  return curve->error && curve->style == ARC_PLOT_POINTS && curve->count > MANY && !w->canvas->text;
}

static void style_words(arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve) {
  static const char *const with[ARC_PLOT_STYLE_COUNT] = {[ARC_PLOT_LINES] = "lines",
                                                         [ARC_PLOT_POINTS] = "points",
                                                         [ARC_PLOT_LINESPOINTS] = "linespoints",
                                                         [ARC_PLOT_STEPS] = "steps",
                                                         [ARC_PLOT_FILLED] = "filledcurves",
                                                         [ARC_PLOT_IMPULSES] = "impulses"};
  if (curve->error && !arc_look_bars_apart(w, curve))
    arc_text_word(w->out,
                  curve->style == ARC_PLOT_POINTS ? " with yerrorbars" : " with yerrorlines");
  else
    arc_text_format(w->out, " with %s", with[curve->style]);
  if (curve->style != ARC_PLOT_FILLED || curve->error) return;
  const char *to = panel && panel->y.log ? " x1" : " y1=0";
  arc_text_word(w->out, comes_back(curve) ? " closed" : to);
  if (!w->canvas->text)
    arc_text_format(w->out, " fillstyle transparent solid %g noborder",
                    w->canvas->grey ? 0.5 : 0.35);
}

/* Returns red, green and blue of a colour given as a gnuplot name or as #rrggbb. */
static unsigned rgb_of(const char *colour) {
  static const struct {
    const char *name;
    unsigned rgb;
  } names[] = {{"red", 0xff0000},     {"green", 0x00ff00},  {"blue", 0x0000ff},
               {"magenta", 0xff00ff}, {"cyan", 0x00ffff},   {"yellow", 0xffff00},
               {"white", 0xffffff},   {"grey", 0xbebebe},   {"orange", 0xffa500},
               {"brown", 0xa52a2a},   {"purple", 0xc080ff}, {"violet", 0xee82ee},
               {"pink", 0xffc0c0},    {"navy", 0x000080},   {"gold", 0xffd700}};
  if (*colour == '#') return (unsigned)strtoul(colour + 1, NULL, 16);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    if (strcmp(names[i].name, colour) == 0) return names[i].rgb;
  return 0; /* black */
}

/* Writes a colour. For grey output, writes the grey with the same luminance (Rec. 601) instead. */
static void colour_words(arc_writer *w, const char *colour) {
  unsigned rgb = rgb_of(colour);
  unsigned y = (299 * (rgb >> 16) + 587 * (rgb >> 8 & 255) + 114 * (rgb & 255)) / 1000;
  if (w->canvas->grey)
    arc_text_format(w->out, " linecolor rgb '#%02x%02x%02x'", y, y, y);
  else
    arc_writer_words(w, " linecolor rgb ", colour, "");
}

static void mark_of_points(arc_writer *w, const arc_plot_curve *curve, int series) {
  int many = curve->count > MANY;
  arc_text_format(w->out, " pointtype %d pointsize %g", many ? 7 : open_marks[series - 1],
                  many ? 0.4 : 0.9);
}

static void look(arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve,
                 size_t position) {
  pen p = pen_of(w, curve, position);
  style_words(w, panel, curve);
  arc_text_format(w->out, " linetype %d", p.series);
  if (is_scaled(w, curve))
    arc_text_format(w->out, " linecolor palette cb %.17g", curve->value);
  else if (curve->colour)
    colour_words(w, curve->colour);
  else if (w->canvas->grey && curve->style == ARC_PLOT_FILLED)
    arc_text_format(w->out, " linecolor rgb '%s'", area_greys[p.series - 1]);
  if (curve->width > 0) arc_text_format(w->out, " linewidth %g", 1.6 * curve->width);
  if (curve->style == ARC_PLOT_POINTS && !w->canvas->text) mark_of_points(w, curve, p.series);
  int chosen = curve->colour && curve->dash == 0; /* the user set a colour, but no dash pattern */
  if (p.dash > 1 && !chosen && curve->style != ARC_PLOT_POINTS && !w->canvas->text &&
      !is_scaled(w, curve))
    arc_text_format(w->out, " dashtype %s", dashes[p.dash - 1]);
}

/* Writes the title of a curve. In pictures of characters a blank separates the title from the
 * sample of the line. */
static void title_words(arc_writer *w, const char *title) {
  arc_text_word(w->out, w->canvas->text && *title ? " title ' '." : " title ");
  arc_writer_label(w, "", title, "");
}

/* Writes the mark of a curve's points if curves are drawn as Braille dots, where each colour has
 * its own mark. */
static void mark_words(arc_writer *w, const arc_plot_curve *curve, size_t position) {
  int marked = curve->error || curve->style == ARC_PLOT_POINTS;
  if (w->canvas->text && (w->canvas->dots || w->canvas->fine) &&
      (marked || curve->style == ARC_PLOT_LINESPOINTS))
    arc_text_format(w->out, " pointtype '%c'",
                    ARC_DOT_MARK + pen_of(w, curve, position).series - 1);
}

/* Draws a curve in black at the cells that Braille dots will replace later. The curve's entry in
 * the key has the colour of the curve. */
static void place_holder(arc_writer *w, const arc_plot_panel *panel, size_t position) {
  arc_plot_curve sample = panel->curves[position];
  style_words(w, panel, &sample);
  arc_text_word(w->out, " linecolor rgb 'black' notitle");
  if (!in_key(w, panel, position)) return;
  if (sample.error) sample.style = ARC_PLOT_POINTS;
  if (arc_dot_marked(w, panel, &sample)) sample.style = ARC_PLOT_LINESPOINTS;
  sample.error = NULL;
  arc_text_word(w->out, ", NaN");
  look(w, panel, &sample, position);
  mark_words(w, &sample, position);
  title_words(w, sample.title);
}

void arc_look_bars(arc_writer *w, const arc_plot_panel *panel, size_t position) {
  const arc_plot_curve *curve = &panel->curves[position];
  arc_text_format(w->out, " with vectors nohead linetype %d", pen_of(w, curve, position).series);
  if (curve->colour) colour_words(w, curve->colour);
  arc_text_word(w->out, " linewidth 0.8 notitle");
}

void arc_look_curve(arc_writer *w, const arc_plot_panel *panel, size_t position) {
  const arc_plot_curve *curve = &panel->curves[position];
  if (w->canvas->fine) {
    place_holder(w, panel, position);
    return;
  }
  look(w, panel, curve, position);
  mark_words(w, curve, position);
  title_words(w, in_key(w, panel, position) ? curve->title : "");
}

/* --- the key of all panels -------------------------------------------------------------------- */

/* Returns the first curve with the title. The style of this curve is used for all curves with
 * the same title. */
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
  arc_text_word(w->out, "unset border\nunset tics\nunset label\nunset logscale\nunset colorbox\n"
                        "set size noratio\nset title ''\nset xlabel ''\nset ylabel ''\n"
                        "set lmargin at screen 0\nset rmargin at screen 1\n"
                        "set bmargin at screen 0\n"
                        "set xrange [0:1]\nset yrange [0:1]\n"
                        "set key on inside center center horizontal Left reverse width 2 nobox\n");
  arc_text_format(w->out, "set tmargin at screen %.6g\nplot", height);
  for (size_t i = 0; i < w->title_count; i++) {
    size_t position;
    const arc_plot_curve *curve = first_of(w, i, &position);
    arc_text_word(w->out, i ? ", NaN" : " NaN");
    arc_plot_curve sample = curve ? *curve : (arc_plot_curve){.title = NULL};
    sample.error = NULL; /* the key shows the sample without error bars */
    if (curve && curve->error) sample.style = ARC_PLOT_POINTS;
    if (curve && arc_dot_marked(w, NULL, curve)) sample.style = ARC_PLOT_LINESPOINTS;
    look(w, NULL, &sample, position);
    mark_words(w, &sample, position);
    title_words(w, w->titles[i]);
  }
  arc_text_word(w->out, "\n");
}

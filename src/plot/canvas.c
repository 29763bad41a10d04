/* Chooses gnuplot's terminal, the size and the fonts of an output. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "plot/figure.h"

/* A kind of canvas: a file format and the gnuplot terminal that produces files in this format.
 * `text` is true for pictures in characters, `vector` for vector formats. Font sizes are in the
 * unit of the terminal, for 100 pixels per inch. */
typedef struct kind {
  const char *ending, *terminal, *options, *family;
  double points, unit; /* default font size; size of one point [terminal units] */
  int text, vector;
  double cell; /* size of a character by which gnuplot lays out keys, relative to the font */
} kind;

/* All kinds of canvas. If two terminals produce the same file format, the better terminal is
 * first. */
static const kind kinds[] = {
    {"png", "pngcairo", "enhanced background '#ffffff'", "sans", 11, 1.042, 0, 0, 1},
    {"png", "png", "enhanced truecolor", "sans", 9, 1, 0, 0, 1},
    {"svg", "svg", "enhanced background '#ffffff'", "sans-serif", 13, 1.389, 0, 1, 1.2},
    {"pdf", "pdfcairo", "enhanced background '#ffffff'", "sans", 15.8, 1.5, 0, 1, 1},
    {"eps", "epscairo", "enhanced", "sans", 15.8, 1.5, 0, 1, 1},
    {"gif", "gif", "enhanced", "sans", 9, 1, 0, 0, 1},
    {"txt", "dumb", "noenhanced", NULL, 0, 0, 1, 0, 1},
    {"sixel", "sixelgd", "enhanced truecolor", "sans", 9, 1, 0, 0, 1},
    {"window", "qt", "enhanced persist", "sans", 11, 1, 0, 0, 1},
    {"window", "wxt", "enhanced persist", "sans", 11, 1, 0, 0, 1},
    {"window", "x11", "enhanced persist", NULL, 0, 0, 0, 0, 1},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static const char *ending_of(const char *file) {
  const char *dot = strrchr(file, '.'), *slash = strrchr(file, '/');
  return dot && (!slash || dot > slash) ? dot + 1 : "";
}

/* Returns the first available kind for files that end in `ending`. If `terminal` is not NULL, the
 * kind must have this terminal. */
static const kind *find_kind(const char *ending, const char *terminal, const arc_gnuplot *session) {
  for (int i = 0; i < KINDS; i++)
    if (strcasecmp(kinds[i].ending, ending) == 0 &&
        (!terminal || strcmp(kinds[i].terminal, terminal) == 0) &&
        (!session || arc_gnuplot_has_terminal(session, kinds[i].terminal)))
      return &kinds[i];
  return NULL;
}

static arc_status no_terminal(const arc_plot_output *output, const char *ending, arc_error *error) {
  if (output->medium == ARC_PLOT_WINDOW)
    return arc_fail(error, ARC_MISSING,
                    "this gnuplot cannot open a window of type %.40s. On Debian: apt-get install "
                    "gnuplot-qt (or gnuplot-x11)",
                    output->terminal ? output->terminal : "qt, wxt or x11");
  return arc_fail(error, ARC_MISSING,
                  "this gnuplot cannot draw %s. On Debian: apt-get install gnuplot-nox", ending);
}

/* Returns the file ending of the output: "" if only the commands are written, NULL if the ending is
 * unknown. */
static const char *output_ending(const arc_plot_output *output) {
  if (output->medium == ARC_PLOT_TEXT) return "txt";
  if (output->medium == ARC_PLOT_SIXEL) return "sixel";
  if (output->medium == ARC_PLOT_PNG) return "png";
  if (output->medium == ARC_PLOT_WINDOW) return "window";
  const char *ending = output->file ? ending_of(output->file) : "";
  if (strcasecmp(ending, "gp") == 0) return "";
  int inner = strcasecmp(ending, "sixel") == 0 || strcasecmp(ending, "window") == 0;
  return !inner && find_kind(ending, NULL, NULL) ? ending : NULL;
}

static int at_least(int value, int least) {
  return value > least ? value : least;
}

/* Sets the size of the canvas: the size that the user chose, or else the smallest size at which the
 * panels are legible. */
static void choose_size(const arc_plot_figure *figure, const arc_plot_output *output,
                        arc_canvas *canvas) {
  int rows, columns;
  arc_plot_grid(figure, &rows, &columns);
  int one = rows * columns == 1;
  int width = canvas->text ? at_least(80, 26 * columns) : columns == 1 ? 900 : 60 + 400 * columns;
  int height = canvas->text ? at_least(24, 12 * rows + 2) : one ? 600 : 60 + 300 * rows;
  canvas->width = output->width > 0 ? output->width : width;
  canvas->height = output->height > 0 ? output->height : height;
}

enum { USUAL_DPI = 100, USUAL_POINTS = 11 };
static const double PAPER_LINE = 1.44; /* line width of paper formats (0.72 pt) divided by the line
                                          width of pixel formats (0.5 pt) */

static int is_paper(const arc_canvas *canvas) {
  return strcmp(canvas->terminal, "pdfcairo") == 0 || strcmp(canvas->terminal, "epscairo") == 0;
}

/* Chooses the size of fonts, lines and marks, which grow with the number of pixels per inch. Sizes
 * of paper formats do not depend on this number, because paper is measured in inches. */
static void choose_letters(const arc_plot_output *output, const kind *found, arc_canvas *canvas) {
  double points = output->points > 0 ? output->points : USUAL_POINTS;
  double inches =
      found && is_paper(canvas) ? 1 : (output->dpi > 0 ? output->dpi : USUAL_DPI) / USUAL_DPI;
  canvas->inch = output->dpi > 0 ? output->dpi : USUAL_DPI;
  canvas->scale = inches * (output->lines > 0 ? output->lines : 1);
  if (found && is_paper(canvas)) canvas->scale *= PAPER_LINE;
  canvas->points = !found               ? 0
                   : output->points > 0 ? found->unit * inches * points
                                        : found->points * inches;
  canvas->family = output->family ? output->family : found ? found->family : NULL;
  double letter = points / USUAL_POINTS * canvas->inch / USUAL_DPI;
  if (found && output->points > 0) letter *= found->cell;
  canvas->columns = canvas->text ? canvas->width : canvas->width / (8 * letter);
  canvas->rows = canvas->text ? canvas->height : canvas->height / (18 * letter);
}

arc_status arc_canvas_choose(const arc_plot_figure *figure, const arc_plot_output *output,
                             const arc_gnuplot *session, arc_canvas *canvas, arc_error *error) {
  if (output->medium == ARC_PLOT_FILE && (!output->file || !*output->file))
    return arc_fail(error, ARC_ARGUMENT, "the file name of a picture is empty");
  const char *ending = output_ending(output);
  if (!ending)
    return arc_fail(error, ARC_ARGUMENT,
                    "'%.200s': the ending of a picture's file must be one of %s", output->file,
                    ARC_PLOT_FILE_ENDINGS);
  memset(canvas, 0, sizeof *canvas);
  const kind *found = NULL;
  if (*ending) {
    found = find_kind(ending, output->terminal, session);
    if (!found) return no_terminal(output, ending, error);
    canvas->terminal = found->terminal;
    canvas->text = found->text;
    canvas->vector = found->vector;
    canvas->window = output->medium == ARC_PLOT_WINDOW;
  }
  canvas->colour = output->medium == ARC_PLOT_TEXT && output->colour;
  int eight_bit = found && strcmp(found->terminal, "x11") == 0; /* X server fonts */
  canvas->ascii = (canvas->text && output->ascii) || eight_bit;
  canvas->grey = !canvas->text && output->grey;
  canvas->fine = canvas->colour && !canvas->ascii && output->fine;
  choose_size(figure, output, canvas);
  choose_letters(output, found, canvas);
  return ARC_OK;
}

/* Writes the size of the canvas. A canvas for Braille dots has twice as many columns and four times
 * as many rows as the picture, because one character shows eight dots. */
static void size_words(const arc_canvas *canvas, arc_text *script) {
  if (is_paper(canvas))
    arc_text_format(script, " size %gin,%gin", canvas->width / canvas->inch,
                    canvas->height / canvas->inch);
  else
    arc_text_format(script, " size %d,%d", canvas->width * (canvas->dots ? 2 : 1),
                    canvas->height * (canvas->dots ? 4 : 1));
}

static void letter_words(const arc_canvas *canvas, arc_text *script) {
  char size[16];
  snprintf(size, sizeof size, ",%.4g", canvas->points);
  arc_text word = {0};
  arc_text_word(&word, canvas->family);
  arc_text_word(&word, size);
  arc_text_word(script, " font ");
  arc_text_quoted(script, word.data ? word.data : "", 0);
  script->failed |= word.failed;
  arc_text_free(&word);
}

/* Writes the scale of lines and marks for each picture, because a terminal otherwise reuses its
 * last settings. Only cairo terminals have a scale of marks. */
static void scale_words(const arc_canvas *canvas, arc_text *script) {
  if (canvas->text) return;
  arc_text_format(script, " linewidth %.4g", canvas->scale);
  if (strstr(canvas->terminal, "cairo")) arc_text_format(script, " pointscale %.4g", canvas->scale);
}

void arc_canvas_command(const arc_canvas *canvas, const char *animation, arc_text *script) {
  if (!canvas->terminal) return;
  const kind *found = kinds;
  while (strcmp(found->terminal, canvas->terminal) != 0) found++;
  arc_text_format(script, "set terminal %s %s %s", found->terminal, animation, found->options);
  if (canvas->family) letter_words(canvas, script);
  if (canvas->text) arc_text_word(script, canvas->colour ? " ansi" : " mono");
  scale_words(canvas, script);
  size_words(canvas, script);
  arc_text_word(script, "\n");
}

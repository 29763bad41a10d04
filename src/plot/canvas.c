/* What a figure is drawn on: gnuplot's terminal for an output, its size and fonts. Leans on
 * gnuplot.c for the list of terminals.
 */
#include <string.h>
#include <strings.h>

#include "plot/figure.h"

/* Kinds of canvas, the better terminal of a kind first. */
typedef struct kind {
  const char *ending, *terminal, *options;
  int text, vector;
} kind;

static const kind kinds[] = {
    {"png", "pngcairo", "noenhanced font 'sans,11' background '#ffffff'", 0, 0},
    {"png", "png", "noenhanced truecolor font 'sans,9'", 0, 0},
    {"svg", "svg", "noenhanced font 'sans-serif,13' background '#ffffff'", 0, 1},
    {"pdf", "pdfcairo", "noenhanced font 'sans,11' background '#ffffff'", 0, 1},
    {"eps", "epscairo", "noenhanced font 'sans,11'", 0, 1},
    {"gif", "gif", "noenhanced font 'sans,9'", 0, 0},
    {"txt", "dumb", "noenhanced", 1, 0},
    {"sixel", "sixelgd", "noenhanced truecolor font 'sans,9'", 0, 0},
    {"window", "qt", "noenhanced persist font 'sans,11'", 0, 0},
    {"window", "wxt", "noenhanced persist font 'sans,11'", 0, 0},
    {"window", "x11", "noenhanced persist", 0, 0},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static const char *ending_of(const char *file) {
  const char *dot = strrchr(file, '.'), *slash = strrchr(file, '/');
  return dot && (!slash || dot > slash) ? dot + 1 : "";
}

/* The kind by its ending, and by the terminal's name where one is asked for. */
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
                    "this gnuplot opens no %.40s window. On Debian: apt-get install gnuplot-qt (or "
                    "gnuplot-x11)",
                    output->terminal ? output->terminal : "qt, wxt or x11");
  return arc_fail(error, ARC_MISSING,
                  "this gnuplot cannot draw %s. On Debian: apt-get install gnuplot-nox", ending);
}

/* The ending that stands for the output, "" for commands only; NULL when it is not known. */
static const char *output_ending(const arc_plot_output *output) {
  if (output->medium == ARC_PLOT_TEXT) return "txt";
  if (output->medium == ARC_PLOT_SIXEL) return "sixel";
  if (output->medium == ARC_PLOT_WINDOW) return "window";
  const char *ending = output->file ? ending_of(output->file) : "";
  if (strcasecmp(ending, "gp") == 0) return "";
  int inner = strcasecmp(ending, "sixel") == 0 || strcasecmp(ending, "window") == 0;
  return !inner && find_kind(ending, NULL, NULL) ? ending : NULL;
}

static int at_least(int value, int least) {
  return value > least ? value : least;
}

/* A panel needs about so much room to be read. */
static void choose_size(const arc_plot_figure *figure, const arc_plot_output *output,
                        arc_canvas *canvas) {
  int rows, columns;
  arc_plot_grid(figure, &rows, &columns);
  int one = rows * columns == 1;
  int width = canvas->text ? at_least(80, 26 * columns) : columns == 1 ? 900 : 60 + 400 * columns;
  int height = canvas->text ? at_least(24, 12 * rows + 2) : one ? 600 : 60 + 300 * rows;
  canvas->width = output->width > 0 ? output->width : width;
  canvas->height = output->height > 0 ? output->height : height;
  canvas->columns = canvas->text ? canvas->width : canvas->width / 8.0;
  canvas->rows = canvas->text ? canvas->height : canvas->height / 18.0;
}

arc_status arc_canvas_choose(const arc_plot_figure *figure, const arc_plot_output *output,
                             const arc_gnuplot *session, arc_canvas *canvas, arc_error *error) {
  if (output->medium == ARC_PLOT_FILE && (!output->file || !*output->file))
    return arc_fail(error, ARC_ARGUMENT, "a picture's file needs a name");
  const char *ending = output_ending(output);
  if (!ending)
    return arc_fail(error, ARC_ARGUMENT,
                    "'%.200s': the ending of a picture's file must be one of %s", output->file,
                    ARC_PLOT_FILE_ENDINGS);
  memset(canvas, 0, sizeof *canvas);
  if (*ending) {
    const kind *found = find_kind(ending, output->terminal, session);
    if (!found) return no_terminal(output, ending, error);
    canvas->terminal = found->terminal;
    canvas->text = found->text;
    canvas->vector = found->vector;
    canvas->window = output->medium == ARC_PLOT_WINDOW;
  }
  canvas->colour = output->medium == ARC_PLOT_TEXT && output->colour;
  canvas->ascii = canvas->text && output->ascii;
  choose_size(figure, output, canvas);
  return ARC_OK;
}

/* Paper is measured in inches: 100 pixels are one, so that all media look alike. */
static void size_words(const arc_canvas *canvas, arc_text *script) {
  if (strcmp(canvas->terminal, "pdfcairo") == 0 || strcmp(canvas->terminal, "epscairo") == 0)
    arc_text_format(script, " size %gin,%gin", canvas->width / 100.0, canvas->height / 100.0);
  else
    arc_text_format(script, " size %d,%d", canvas->width, canvas->height);
}

void arc_canvas_command(const arc_canvas *canvas, const char *animation, arc_text *script) {
  if (!canvas->terminal) return;
  const kind *found = kinds;
  while (strcmp(found->terminal, canvas->terminal) != 0) found++;
  arc_text_format(script, "set terminal %s %s %s", found->terminal, animation, found->options);
  if (canvas->text) arc_text_word(script, canvas->colour ? " ansi" : " mono");
  size_words(canvas, script);
  arc_text_word(script, "\n");
}

/* archard/plot.h - figures drawn by gnuplot.
 * Declares sessions with a gnuplot child process (arc_gnuplot), and figures made of arrays of
 * doubles (arc_plot_figure). The functions print nothing: a picture made of characters is returned
 * to the caller.
 *
 * Texts are UTF-8. They are shown unchanged, with these exceptions: \alpha and other names of Greek
 * letters become the letters. In all pictures that are not made of characters, the characters after
 * a single letter and _ (p_H, \alpha_c) become subscripts, digits after ^ (mm^2, 10^-8) become
 * superscripts, and 5e-08 becomes a power of ten. The arrays and texts of a figure belong to the
 * caller and are only read. */
#ifndef ARCHARD_PLOT_H
#define ARCHARD_PLOT_H

#include "archard/base.h"

/* --- gnuplot.c: the child process ------------------------------------------------------------- */

/* Oldest supported version of gnuplot. */
#define ARC_GNUPLOT_OLDEST 5.2

typedef struct arc_gnuplot arc_gnuplot;

typedef struct arc_gnuplot_def {
  const char *program;     /* name of a program in PATH, or a path; default "gnuplot" */
  double start_timeout;    /* [s] limit for the first reply; default 15 */
  double silence_timeout;  /* [s] longest time without output during a plot; default 60 */
  arc_stop_fn should_stop; /* called at least ten times a second while gnuplot works; may be NULL */
  void *stop_context;
} arc_gnuplot_def;

arc_gnuplot_def arc_gnuplot_default(void);

/* Creates a session. gnuplot starts at the first use, and again after it has ended. The program's
 * name is copied. Error: ARC_MEMORY. */
arc_status arc_gnuplot_open(const arc_gnuplot_def *def, arc_gnuplot **session, arc_error *error);

/* Ends gnuplot and frees the session; *session may be NULL. Open windows remain. */
void arc_gnuplot_close(arc_gnuplot **session);

/* Starts gnuplot unless it is running. An error does not change the session. Errors: ARC_MISSING if
 * gnuplot is not installed or is older than ARC_GNUPLOT_OLDEST; ARC_IO if it gave no answer in time
 * or ended at once; ARC_STOPPED. */
arc_status arc_gnuplot_start(arc_gnuplot *session, arc_error *error);

/* Return the version and the terminals of the running gnuplot; before the first start these are 0
 * and "". The names of the terminals are separated by blanks, with a blank before the first name
 * and after the last name. The text is valid until the next start or close.
 * arc_gnuplot_has_terminal returns true if `name` is among the terminals. */
double arc_gnuplot_version(const arc_gnuplot *session);
const char *arc_gnuplot_terminals(const arc_gnuplot *session);
int arc_gnuplot_has_terminal(const arc_gnuplot *session, const char *name);

/* Returns the process id of the running gnuplot, or 0. */
long arc_gnuplot_process(const arc_gnuplot *session);

/* Sends commands and waits until gnuplot has executed them. `reply` (may be NULL) receives
 * gnuplot's standard output, terminated by a zero byte; the caller frees the reply with free().
 * `length` (may be NULL) is its length without the zero byte. The commands are in gnuplot's
 * language, so texts of a user must be quoted by arc_plot_quote. Errors: those of
 * arc_gnuplot_start; ARC_ARGUMENT with gnuplot's message if gnuplot rejects a command; ARC_IO if
 * gnuplot ends or gives no output. After ARC_IO and ARC_STOPPED gnuplot is ended, and the next call
 * starts it again. */
arc_status arc_gnuplot_run(arc_gnuplot *session, const char *commands, size_t count, char **reply,
                           size_t *length, arc_error *error);

/* --- text.c: quoted texts --------------------------------------------------------------------- */

/* Returns a text as a gnuplot string in double quotes, which cannot execute commands. Double
 * quotes and backslashes are escaped, backquotes are written as codes, control characters as
 * blanks, invalid UTF-8 as '?'. If `ascii` is non-zero, characters that are not ASCII are
 * replaced by ASCII text (Greek letters by their names). The caller frees the result with
 * free(). Returns NULL if memory is exhausted. */
char *arc_plot_quote(const char *text, int ascii);

/* --- figure.c: a figure ----------------------------------------------------------------------- */

/* List of the curve styles: X(C name, name for the user). */
#define ARC_PLOT_STYLE_LIST(X)                                                                     \
  X(LINES, "lines")                                                                                \
  X(POINTS, "points")                                                                              \
  X(LINESPOINTS, "linespoints")                                                                    \
  X(STEPS, "steps")                                                                                \
  X(FILLED, "filled")                                                                              \
  X(IMPULSES, "impulses")

typedef enum arc_plot_style {
#define ARC_PLOT_STYLE_ENUM(name, text) ARC_PLOT_##name,
  ARC_PLOT_STYLE_LIST(ARC_PLOT_STYLE_ENUM)
#undef ARC_PLOT_STYLE_ENUM
      ARC_PLOT_STYLE_COUNT
} arc_plot_style;

/* Names of the colours, separated by blanks. */
#define ARC_PLOT_COLOURS                                                                           \
  "black red green blue magenta cyan yellow white grey orange brown purple violet pink navy gold"

/* One curve. The line is interrupted at a row with NaN or infinity, and on a logarithmic axis
 * also at a value that is not positive. */
typedef struct arc_plot_curve {
  const double *x, *y; /* [count] */
  size_t count;
  const char *title; /* title of the curve in the key; NULL: no entry */
  arc_plot_style style;
  const char *colour; /* "#rrggbb" or one of ARC_PLOT_COLOURS; NULL: colour number `series` */
  int series; /* number of the colour, mark and dash pattern, from 1; 0: next number in the panel */
  int dash; /* number of the dash pattern: 1 solid, 2 to 8 dashed; 0: pattern of `series`, or solid
               if `colour` is set */
  double width;        /* line width relative to the default; 0: default */
  const double *error; /* [count] half lengths of error bars in y; NULL: no bars */
  int scaled;          /* true: coloured by `value` on the panel's colour scale; not in the key */
  double value;
  int labelled; /* true: title beside the frame, at the curve's end; not in the key */
} arc_plot_curve;

/* Coloured polygons, each with four corners in circular order; a triangle repeats its last corner.
 * The values belong to the corners and are linear between them. */
typedef struct arc_plot_field {
  const double *x, *y, *value; /* [4 * count]; polygon i has the corners 4i to 4i + 3 */
  size_t count;
} arc_plot_field;

typedef struct arc_plot_axis {
  const char *label;        /* label of the axis; NULL: none */
  const double *places;     /* [place_count] positions of `words`; NULL: ticks have numbers */
  const char *const *words; /* [place_count] */
  size_t place_count;
  double min, max; /* ends of the range; NaN: end of the data; min > max: reversed axis */
  int log;         /* true: logarithmic axis, base 10 */
  int reverse;     /* true: values grow downwards or to the left; ignored if min and max are set */
} arc_plot_axis;

/* List of the positions of the key: X(C name, name for the user). The corner positions are inside
 * the frame. */
#define ARC_PLOT_KEY_LIST(X)                                                                       \
  X(BELOW, "below")                                                                                \
  X(RIGHT, "right")                                                                                \
  X(TOP_LEFT, "top left")                                                                          \
  X(TOP_RIGHT, "top right")                                                                        \
  X(BOTTOM_LEFT, "bottom left")                                                                    \
  X(BOTTOM_RIGHT, "bottom right")                                                                  \
  X(NONE, "none")

typedef enum arc_plot_key {
#define ARC_PLOT_KEY_ENUM(name, text) ARC_PLOT_KEY_##name,
  ARC_PLOT_KEY_LIST(ARC_PLOT_KEY_ENUM)
#undef ARC_PLOT_KEY_ENUM
} arc_plot_key;

typedef struct arc_plot_panel {
  const char *title; /* title above the panel; NULL: none */
  arc_plot_axis x, y;
  arc_plot_axis value; /* colour scale: only label and range are used */
  arc_plot_key key;
  int equal;  /* true: the same scale on both axes */
  int levels; /* number of contour lines of the field */
  const arc_plot_curve *curves;
  size_t curve_count;
  const arc_plot_field *field; /* field below the curves; NULL: none */
} arc_plot_panel;

typedef struct arc_plot_figure {
  const char *title; /* title above the figure; NULL: none */
  const arc_plot_panel *panels;
  size_t panel_count;
  int rows, columns; /* number of rows and columns of the grid, which panels fill row by row; 0:
                        automatic */
  int one_key; /* true: one key below all panels; curves with equal titles have equal colours */
} arc_plot_figure;

/* Return default values: an axis with automatic range and no label, and a panel without curves. */
arc_plot_axis arc_plot_axis_default(void);
arc_plot_panel arc_plot_panel_default(void);

/* Checks that a figure is not empty, that its ranges and the size of its grid are valid, and that
 * every curve has a point that can be drawn. Errors: ARC_ARGUMENT; the message names the panel and
 * the curve. */
arc_status arc_plot_check(const arc_plot_figure *figure, arc_error *error);

/* --- draw.c: output of a figure --------------------------------------------------------------- */

typedef enum arc_plot_medium {
  ARC_PLOT_TEXT,   /* a picture in characters, returned to the caller */
  ARC_PLOT_SIXEL,  /* escape sequences for a terminal that shows pictures (sixel), returned to the
                      caller */
  ARC_PLOT_PNG,    /* the bytes of a png picture, returned to the caller */
  ARC_PLOT_WINDOW, /* a window on the screen */
  ARC_PLOT_FILE    /* a file; its ending sets the format: png svg pdf eps gif txt gp */
} arc_plot_medium;

typedef struct arc_plot_output {
  arc_plot_medium medium;
  const char *file;     /* path of the output file */
  const char *terminal; /* gnuplot's terminal for a window; NULL: the first available terminal */
  int width, height;    /* size in characters (text) or pixels; 0: chosen to fit the figure */
  int colour;           /* for text: true if ANSI colours are written */
  int ascii;            /* for text: true if only ASCII characters are written */
  int grey;      /* for pixels: true if colours are converted to greys of the same luminance */
  int fine;      /* for coloured text: true if curves are drawn as Braille dots, eight dots in a
                    character */
  double dpi;    /* pixels per inch in files; 0: 100 */
  double points; /* font size [pt]; 0: default */
  double lines;  /* scale of line widths and marks; 0: 1 */
  const char *family; /* font family; NULL: default */
} arc_plot_output;

/* Command that adds gnuplot's error number to the variable archard_failed. It is written before
 * commands that clear the error number, such as `reset`, so that arc_gnuplot_run still detects the
 * error. */
#define ARC_GNUPLOT_NOTE_FAILURE "archard_failed = archard_failed + GPVAL_ERRNO\n"

/* File endings supported by arc_plot_draw, separated by blanks. */
#define ARC_PLOT_FILE_ENDINGS "png svg pdf eps gif txt gp"

/* Writes the gnuplot commands of a figure, as for a .gp file. The caller frees the commands with
 * free(). Errors: ARC_ARGUMENT, ARC_MEMORY. */
arc_status arc_plot_script(const arc_plot_figure *figure, const arc_plot_output *output,
                           char **commands, size_t *length, arc_error *error);

/* Draws a figure. A picture in characters, for a terminal or as png bytes is returned in `picture`
 * and `length` (may be NULL), and the caller frees it with free(). For windows and files they are
 * NULL and 0. A file is written completely; on failure no file is written. Errors: those of
 * arc_plot_check and arc_gnuplot_run; ARC_IO if the file cannot be written; ARC_MISSING if this
 * gnuplot has no suitable terminal. */
arc_status arc_plot_draw(arc_gnuplot *session, const arc_plot_figure *figure,
                         const arc_plot_output *output, char **picture, size_t *length,
                         arc_error *error);

/* Writes the figures as an animated gif that repeats without end. `delay` is the time between
 * pictures [s], above 0 and at most 60. Errors: those of arc_plot_draw; ARC_ARGUMENT if the delay
 * is invalid, the file name does not end in .gif, or there are no figures. */
arc_status arc_plot_animate(arc_gnuplot *session, const arc_plot_figure *frames, size_t count,
                            double delay, const arc_plot_output *output, arc_error *error);

#endif

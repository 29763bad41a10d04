/* archard/plot.h - figures drawn by gnuplot.
 *
 * The gnuplot child process (arc_gnuplot), and figures of columns of doubles (arc_plot_figure).
 * Nothing is printed: a picture in characters is returned to the caller.
 *
 * Texts are UTF-8 and no character in them has a meaning for gnuplot. They are shown as they stand
 * but for some forms of the field: \alpha is the Greek letter; what follows a single letter and _
 * (p_H, \alpha_c) is lowered, and digits after ^ (mm^2, 10^-8) are raised, where there are pixels;
 * there 5e-08 is written as a power of ten.
 * The arrays and texts of a figure stay the caller's and are only read.
 */
#ifndef ARCHARD_PLOT_H
#define ARCHARD_PLOT_H

#include "archard/base.h"

/* --- the child process ------------------------------------------------------------------------ */

/* Oldest supported version of gnuplot. */
#define ARC_GNUPLOT_OLDEST 5.2

typedef struct arc_gnuplot arc_gnuplot;

typedef struct arc_gnuplot_def {
  const char *program;     /* name to look for in PATH, or a path; "gnuplot" */
  double start_timeout;    /* [s] limit for the first reply; 15 */
  double silence_timeout;  /* [s] limit without output during a plot; 60 */
  arc_stop_fn should_stop; /* called ten times a second while waiting; NULL: none */
  void *stop_context;
} arc_gnuplot_def;

arc_gnuplot_def arc_gnuplot_default(void);

/* Creates a session. gnuplot starts at the first use, and again after it has ended. The program's
 * name is copied. ARC_MEMORY. */
arc_status arc_gnuplot_open(const arc_gnuplot_def *def, arc_gnuplot **session, arc_error *error);

/* Ends gnuplot and frees the session; a pointer to NULL is allowed. Open windows remain. */
void arc_gnuplot_close(arc_gnuplot **session);

/* Starts gnuplot unless it is running. Errors, after which the session is as before:
 * ARC_MISSING: not installed, or older than ARC_GNUPLOT_OLDEST; ARC_IO: no answer in time, or it
 * ended at once; ARC_STOPPED. */
arc_status arc_gnuplot_start(arc_gnuplot *session, arc_error *error);

/* Version and terminals of the running gnuplot; 0 and "" before the first start. The terminals are
 * separated by blanks, with one before the first and after the last; valid until the next start or
 * close. */
double arc_gnuplot_version(const arc_gnuplot *session);
const char *arc_gnuplot_terminals(const arc_gnuplot *session);
int arc_gnuplot_has_terminal(const arc_gnuplot *session, const char *name);

/* Process id of the running gnuplot, or 0. */
long arc_gnuplot_process(const arc_gnuplot *session);

/* Sends commands and waits for their end. `reply` (may be NULL) receives what gnuplot wrote to its
 * standard output, to be freed by the caller with free(), ended by a zero that `length` (may be
 * NULL) does not count. The commands are gnuplot's own language: texts of a user must have passed
 * arc_plot_quote. Errors: those of the start; ARC_ARGUMENT with gnuplot's words when it refuses a
 * command; ARC_IO when it dies or falls silent, and ARC_STOPPED: both end this gnuplot, the next
 * call starts another. */
arc_status arc_gnuplot_run(arc_gnuplot *session, const char *commands, size_t count, char **reply,
                           size_t *length, arc_error *error);

/* A text as a gnuplot string that runs nothing: in double quotes, those in it and backslashes
 * behind a backslash, backquotes by their number, control characters as blanks, bytes that are no
 * UTF-8 as '?'. With `ascii` non-zero other characters are written in ASCII (the Greek of this
 * field by name). To be freed with free(); NULL when memory is out. */
char *arc_plot_quote(const char *text, int ascii);

/* --- a figure --------------------------------------------------------------------------------- */

/* X(name, what a user types) */
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

/* One curve. A row with NaN or infinity (or not positive on a logarithmic axis) breaks the line. */
typedef struct arc_plot_curve {
  const double *x, *y; /* [count] */
  size_t count;
  const char *title; /* NULL: not in the key */
  arc_plot_style style;
  const char *colour;  /* "#rrggbb" or one of ARC_PLOT_COLOURS; NULL: by `series` */
  int series;          /* number of the colour and mark, 1 to 8; 0: the next one */
  int dash;            /* 1 full line, 2 to 5 dashed; 0: full */
  double width;        /* relative; 0: default */
  const double *error; /* [count] half lengths of bars in y; NULL: none */
  int scaled; /* non-zero: coloured by `value` on the panel's colour scale, not in the key */
  double value;
  int labelled; /* non-zero: its title is at its end beside the frame, not in the key */
} arc_plot_curve;

/* Coloured polygons of four corners in order around; a triangle repeats its last corner. The value
 * is given at the corners and is linear between them. */
typedef struct arc_plot_field {
  const double *x, *y, *value; /* [4 * count], corners of polygon i at 4i .. 4i+3 */
  size_t count;
} arc_plot_field;

typedef struct arc_plot_axis {
  const char *label;        /* NULL: none */
  const double *places;     /* [place_count] positions of words instead of numbers; NULL: numbers */
  const char *const *words; /* [place_count] */
  size_t place_count;
  double min, max; /* NaN: from the data; min > max: a reversed axis */
  int log;         /* base 10 */
  int reverse;     /* grows downwards or leftwards; not where both ends are given */
} arc_plot_axis;

/* X(name, option); positions in corners are inside the frame. */
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
  const char *title; /* NULL: none */
  arc_plot_axis x, y;
  arc_plot_axis value; /* the field's or the scaled curves' values: label and range only */
  arc_plot_key key;
  int equal;  /* non-zero: the same scale on both axes */
  int levels; /* contour lines of the field; 0: none */
  const arc_plot_curve *curves;
  size_t curve_count;
  const arc_plot_field *field; /* NULL: none */
} arc_plot_panel;

typedef struct arc_plot_figure {
  const char *title; /* NULL: none */
  const arc_plot_panel *panels;
  size_t panel_count;
  int rows, columns; /* of the grid of panels, filled row by row; 0: chosen */
  int one_key; /* several panels: one key for all, below; the same title has the same colour */
} arc_plot_figure;

/* Defaults: an automatic axis without a label, an empty panel, an empty figure. */
arc_plot_axis arc_plot_axis_default(void);
arc_plot_panel arc_plot_panel_default(void);

/* Checks a figure: not empty, ranges, a finite point in every curve, size of the grid.
 * ARC_ARGUMENT, with the panel and the curve. */
arc_status arc_plot_check(const arc_plot_figure *figure, arc_error *error);

/* --- where it is drawn ------------------------------------------------------------------------ */

typedef enum arc_plot_medium {
  ARC_PLOT_TEXT,   /* characters, returned */
  ARC_PLOT_SIXEL,  /* a picture in a terminal's escape codes, returned */
  ARC_PLOT_PNG,    /* the bytes of a png, returned */
  ARC_PLOT_WINDOW, /* a window on the screen */
  ARC_PLOT_FILE    /* format by the ending: png svg pdf eps gif txt gp */
} arc_plot_medium;

typedef struct arc_plot_output {
  arc_plot_medium medium;
  const char *file;     /* for a file: its path */
  const char *terminal; /* a window: gnuplot's terminal; NULL: the first available */
  int width, height;    /* characters for text, else pixels; 0: chosen by the figure */
  int colour;           /* text: non-zero writes ANSI colours */
  int ascii;            /* text: non-zero writes no character beyond ASCII */
  int grey;             /* pixels: non-zero converts colours to greys of the same luminance */
  int fine;             /* text with colour: curves in Braille dots, eight to a character */
  double dpi;           /* pixels per inch, for files; 0: 100 */
  double points;        /* font size [pt]; 0: default */
  double lines;         /* width of lines and size of marks, relative; 0: 1 */
  const char *family;   /* font; NULL: default */
} arc_plot_output;

/* Commands that clear errors (`reset`) come last, so that arc_gnuplot_run detects errors. */
#define ARC_GNUPLOT_NOTE_FAILURE "archard_failed = archard_failed + GPVAL_ERRNO\n"

/* File endings supported by arc_plot_draw, separated by blanks. */
#define ARC_PLOT_FILE_ENDINGS "png svg pdf eps gif txt gp"

/* The gnuplot commands of a figure, as written to .gp files. The caller frees them with free().
 * ARC_ARGUMENT, ARC_MEMORY. */
arc_status arc_plot_script(const arc_plot_figure *figure, const arc_plot_output *output,
                           char **commands, size_t *length, arc_error *error);

/* Draws. `picture` and `length` receive the characters of a text or sixel picture, to be freed with
 * free(), and NULL and 0 for the others. A file appears whole or not at all. Errors: those of
 * arc_plot_check and arc_gnuplot_run; ARC_IO: the file cannot be written; ARC_MISSING: this gnuplot
 * has no terminal of the kind. */
arc_status arc_plot_draw(arc_gnuplot *session, const arc_plot_figure *figure,
                         const arc_plot_output *output, char **picture, size_t *length,
                         arc_error *error);

/* Writes the figures as one animated gif, `delay` [s] apart, going round for ever. Errors as for
 * arc_plot_draw; ARC_ARGUMENT for a file that does not end in gif or for no frames. */
arc_status arc_plot_animate(arc_gnuplot *session, const arc_plot_figure *frames, size_t count,
                            double delay, const arc_plot_output *output, arc_error *error);

#endif

/* Types and functions shared by the files that write a figure as gnuplot commands. */
#ifndef PLOT_FIGURE_H
#define PLOT_FIGURE_H

#include "plot/plot.h"
#include "plot/text.h"

/* Properties of the output that affect the commands. */
typedef struct arc_canvas {
  const char *terminal; /* gnuplot's name; NULL: none is set (a script for the user) */
  int text;             /* non-zero: characters, else pixels */
  int ascii, colour;    /* of a text */
  int grey;             /* of pixels: no colours */
  int window;           /* an interactive window */
  int vector;           /* a vector format, in which polygons increase the file size */
  int width, height;    /* characters or pixels */
  double columns, rows; /* the same in characters of the font */
  int fine, dots;       /* text: curves are drawn as Braille dots; this is the canvas of the dots */
  double points;        /* font size in the unit of gnuplot's terminal */
  double scale;         /* of lines and marks */
  double inch;          /* pixels per inch */
  const char *family;   /* font */
} arc_canvas;

/* Characters of the eight marks in pictures of Braille dots; levels of a field have others. */
enum { ARC_DOT_MARK = 'A', ARC_DOT_MARKS = 8 };

/* Axis ranges of a panel; an end may be larger than the start (reversed axis). */
typedef struct arc_plot_box {
  double x0, x1, y0, y1;
} arc_plot_box;

/* Frame of a panel: fractions of the canvas from its lower left corner, and inner size in
 * characters. */
typedef struct arc_plot_frame {
  double left, right, bottom, top;
  double columns, rows;
} arc_plot_frame;

/* State of writing one figure. */
typedef struct arc_writer {
  const arc_plot_figure *figure;
  const arc_canvas *canvas;
  arc_text *out;
  const char **titles; /* the distinct titles, for one key of all panels */
  size_t title_count;
} arc_writer;

/* Tick labels of an axis. */
typedef struct arc_ticks {
  double step;      /* 0: gnuplot's choice */
  int digits;       /* significant ones a label shows */
  size_t longest;   /* characters of the longest label */
  int powers;       /* written as 7e-4 */
  int decimals;     /* of the 7 */
  int decades;      /* between labels of a logarithmic axis; 0: none, or gnuplot's choice */
  int first, last;  /* its decades, 10^first to 10^last */
  int parts;        /* labelled besides the powers: 1 all multiples, 3 twice and five times */
  int bare;         /* powers without the 7 */
  int exponent;     /* of the largest number of a linear axis with a step */
  double low, high; /* its numbers, from low to high in steps */
} arc_ticks;

/* Computes about `most` ticks for an axis from..to (in either order). `columns` > 0: the labels are
 * side by side in this many columns, at least two apart; otherwise above each other. */
arc_ticks arc_ticks_up(const arc_plot_axis *axis, double from, double to, double most);
arc_ticks arc_ticks_across(const arc_plot_axis *axis, double from, double to, double most,
                           double columns);

/* Width of a panel's title [characters]. */
double arc_panel_columns(const arc_writer *w);

/* Grid of the panels; by default about square. */
void arc_plot_grid(const arc_plot_figure *figure, int *rows, int *columns);

/* Sets the canvas of an output, with the terminals of `session` (NULL: all).
 * Errors: ARC_ARGUMENT, ARC_MISSING. */
arc_status arc_canvas_choose(const arc_plot_figure *figure, const arc_plot_output *output,
                             const arc_gnuplot *session, arc_canvas *canvas, arc_error *error);

/* The command that sets the terminal. `animation`: its additional options, or "". */
void arc_canvas_command(const arc_canvas *canvas, const char *animation, arc_text *script);

/* Writes the commands of a checked figure. */
void arc_plot_commands(const arc_plot_figure *figure, const arc_canvas *canvas, arc_text *script);

/* A command with quoted user text. The first function is for names, which are not changed; the
 * second for labels, with an option for gnuplot if the label has marks. */
void arc_writer_words(arc_writer *w, const char *before, const char *words, const char *after);
void arc_writer_label(arc_writer *w, const char *before, const char *words, const char *after);

/* Writes a title wrapped at `columns` characters; number of its lines. */
void arc_writer_title(arc_writer *w, const char *before, const char *words, double columns,
                      const char *after);
int arc_title_lines(const char *words, double columns);

/* Titles beside the frame at the ends of their curves: width in characters, and commands. */
double arc_labels_width(const arc_plot_panel *panel);
void arc_labels_write(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                      double rows);

/* Range of the values of coloured curves, or that of the panel's value axis. Returns 0 if there are
 * none, or if characters replace colours. */
int arc_look_scale(const arc_writer *w, const arc_plot_panel *panel, double range[2]);

/* Colour number (from 1) of a curve, the position-th of its panel. */
int arc_look_colour(const arc_writer *w, const arc_plot_curve *curve, size_t position);

/* True if a line of dots has marks (panel NULL: any line). Writes their data within the box, and
 * their part of the plot command. */
int arc_dot_marked(const arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve);
void arc_dot_marks_block(arc_writer *w, size_t number, const arc_plot_box *box);
void arc_dot_marks_words(arc_writer *w, size_t number);

/* Writes settings, data and plot command of one panel. `framed`: with a given frame, else with
 * gnuplot's margins. */
void arc_panel_write(arc_writer *w, size_t number, const arc_plot_frame *frame, int framed);

/* Length of the longest y label of a panel with a frame of `rows` rows [characters]. */
size_t arc_panel_label(const arc_writer *w, const arc_plot_panel *panel, double rows);

/* Width needed right of a frame of this width [characters]; 0: gnuplot's default. */
double arc_panel_right(const arc_writer *w, const arc_plot_panel *panel, double columns);

/* True if all panels share one key; position of a title in it; its height in rows. */
int arc_look_one_key(const arc_writer *w);
size_t arc_look_title(const arc_writer *w, const char *title);
double arc_look_key_rows(const arc_writer *w);
/* Height of a panel's own key below it [rows]. */
double arc_look_own_key_rows(const arc_writer *w, const arc_plot_panel *panel);

/* Collects the titles of the writer; sets the failed flag of its text if out of memory. */
void arc_look_collect(arc_writer *w);

/* Defines the numbered colours and marks. */
void arc_look_series(arc_writer *w);

/* Writes the style of a curve, the position-th of its panel, in a plot command. */
void arc_look_curve(arc_writer *w, const arc_plot_panel *panel, size_t position);

/* True if there are too many points for gnuplot's error bars, which are cut out around each point;
 * the second function writes the style of bars drawn before the points. */
int arc_look_bars_apart(const arc_writer *w, const arc_plot_curve *curve);
void arc_look_bars(arc_writer *w, const arc_plot_panel *panel, size_t position);

/* Writes the command of the shared key. */
void arc_look_draw_key(arc_writer *w);

/* Writes the rows of a curve as a datablock, with breaks at values that are not finite. */
void arc_data_curve(const arc_plot_panel *panel, const arc_plot_curve *curve, arc_text *script);

/* Extent of a panel's data; its given ranges have precedence. */
arc_plot_box arc_plot_extent(const arc_plot_panel *panel);

/* Extends the axes slightly if a curve runs along the frame, and open ends of logarithmic axes to
 * 1, 2 or 5 times a power of ten. */
void arc_plot_clear(const arc_canvas *canvas, arc_plot_panel *panel);

/* Gives panels with the same y label the same range, if it is not given. */
void arc_plot_share(arc_plot_panel *panels, size_t count);

/* Range of the field's values inside the box, or that of the panel's value axis. */
void arc_field_range(const arc_plot_panel *panel, const arc_plot_box *box, double range[2]);

/* Round step for about `lines` contour lines in a range; contours are at its multiples.
 */
double arc_field_step(const double range[2], int levels);

/* Writes contour lines as rows of segments, one line every step, and labels as rows x, y, value, at
 * most one for each line, none nearer than 1.3 of the frame's `rows` of text to the next line or
 * number. Returns the number of segments. */
size_t arc_field_contours(const arc_plot_field *field, const arc_plot_box *box,
                          const double range[2], int levels, double rows, arc_text *lines,
                          arc_text *labels);

/* Samples the field at the centres of columns x rows equal cells of the box, NaN outside the
 * polygons; the first row is at y0. */
void arc_field_raster(const arc_plot_field *field, const arc_plot_box *box, int columns, int rows,
                      double *values);

#endif

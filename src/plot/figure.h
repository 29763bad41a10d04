/* Types and functions shared by the files that write a figure as gnuplot commands. */
#ifndef PLOT_FIGURE_H
#define PLOT_FIGURE_H

#include "plot/plot.h"
#include "plot/text.h"

/* Properties of the output that affect gnuplot's commands. */
typedef struct arc_canvas {
  const char *terminal; /* name of gnuplot's terminal; NULL for a script that the user runs */
  int text;             /* true for a picture in characters, false for pixels */
  int ascii, colour; /* for pictures in characters; ascii: true if only ASCII characters are used;
                        colour: true if the picture is coloured */
  int grey;          /* for pixels: true if greys are used instead of colours */
  int window;        /* true for an interactive window */
  int vector;        /* true for a vector format, where polygons increase the file size */
  int width, height; /* size in characters or pixels */
  double columns, rows; /* size of the canvas in characters of the font */
  int fine, dots; /* fine: curves are drawn as Braille dots; dots: this canvas is only for the dots,
                     while another canvas is for axes and texts */
  double points;  /* font size in the unit of gnuplot's terminal */
  double scale;   /* scale of lines and marks */
  double inch;    /* pixels per inch */
  const char *family; /* font family */
} arc_canvas;

/* ARC_DOT_MARK is the first of eight letters that represent the marks of curves in pictures of
 * Braille dots. The levels of a field are drawn with other characters. */
enum { ARC_DOT_MARK = 'A', ARC_DOT_MARKS = 8 };

/* Axis ranges of a panel. On a reversed axis the first end is larger than the second. */
typedef struct arc_plot_box {
  double x0, x1, y0, y1;
} arc_plot_box;

/* Frame of a panel: its edges as fractions of the canvas, measured from the lower left corner of
 * the canvas, and its inner size in characters. */
typedef struct arc_plot_frame {
  double left, right, bottom, top;
  double columns, rows;
} arc_plot_frame;

/* A figure that is being written as commands, and the output text. */
typedef struct arc_writer {
  const arc_plot_figure *figure;
  const arc_canvas *canvas;
  arc_text *out;
  const char **titles; /* distinct titles of all curves, for a common key */
  size_t title_count;
} arc_writer;

/* Ticks of an axis and their labels. */
typedef struct arc_ticks {
  double step;     /* distance between ticks; 0: gnuplot chooses it */
  int digits;      /* significant digits of a label */
  size_t longest;  /* length of the longest label [characters] */
  int powers;      /* true: labels have the form 7e-4 */
  int decimals;    /* decimals of the mantissa, which is 7 in 7e-4 */
  int decades;     /* decades between labels of a logarithmic axis; 0: chosen by gnuplot */
  int first, last; /* range of a logarithmic axis: 10^first to 10^last */
  int parts;    /* labels between powers of ten: 0 none, 1 at all multiples of a power, 3 at 2 and 5
                   times a power */
  int bare;     /* true: labels are powers of ten without mantissa */
  int exponent; /* exponent of the largest number of a linear axis */
  double low, high; /* first and last tick of a linear axis, in units of `step` */
} arc_ticks;

/* --- ticks.c ---------------------------------------------------------------------------------- */

/* Returns the number of decimals of tick labels at multiples of `step`: 2 for the step 0.05, 0 for
 * steps from 1 on, and 0 for the step 0 (gnuplot chooses the ticks). */
int arc_ticks_fraction(double step);

/* Computes about `most` ticks for an axis from..to; `from` may be larger than `to`. arc_ticks_up is
 * for labels one above the other. arc_ticks_across is for labels side by side in `columns`
 * characters, with at least two characters between labels. */
arc_ticks arc_ticks_up(const arc_plot_axis *axis, double from, double to, double most);
arc_ticks arc_ticks_across(const arc_plot_axis *axis, double from, double to, double most,
                           double columns);

/* Returns a round step for about `levels` contour lines in a range. Contour lines are at multiples
 * of the step. */
double arc_field_step(const double range[2], int levels);

/* --- look.c ----------------------------------------------------------------------------------- */

/* Returns the largest length of a line in a panel's title [characters]. */
double arc_panel_columns(const arc_writer *w);

/* These functions write the command `before`, a quoted text of the user, and `after`.
 * arc_writer_words writes the user's text unchanged and is used for names. arc_writer_label shows
 * subscripts, superscripts and Greek letters. */
void arc_writer_words(arc_writer *w, const char *before, const char *words, const char *after);
void arc_writer_label(arc_writer *w, const char *before, const char *words, const char *after);

/* arc_writer_title writes a title that is wrapped at `columns` characters. arc_title_lines returns
 * the number of lines of such a title. */
void arc_writer_title(arc_writer *w, const char *before, const char *words, double columns,
                      const char *after);
int arc_title_lines(const char *words, double columns);

/* Computes the range of the colour scale of curves: their smallest and largest values. If the user
 * set an end of the panel's value axis, it replaces the corresponding value. Returns 0 if no curve
 * is coloured by its value, or for pictures in characters. */
int arc_look_scale(const arc_writer *w, const arc_plot_panel *panel, double range[2]);

/* Returns the colour number (from 1) of the curve at index `position` of its panel. */
int arc_look_colour(const arc_writer *w, const arc_plot_curve *curve, size_t position);

/* Returns true if all panels share one key. */
int arc_look_one_key(const arc_writer *w);
/* Returns the index of a title in the shared key. */
size_t arc_look_title(const arc_writer *w, const char *title);
/* Returns the height of the shared key [rows]. */
double arc_look_key_rows(const arc_writer *w);
/* Returns the height of the key below a panel [rows]. */
double arc_look_own_key_rows(const arc_writer *w, const arc_plot_panel *panel);

/* Collects the distinct titles of all curves. If memory is exhausted, sets the failed flag of
 * the output text. */
void arc_look_collect(arc_writer *w);

/* Writes commands that define the numbered colours and marks. */
void arc_look_series(arc_writer *w);

/* Writes the style of the curve at index `position` of its panel into a plot command. */
void arc_look_curve(arc_writer *w, const arc_plot_panel *panel, size_t position);

/* arc_look_bars_apart returns true if a curve has too many points for gnuplot's error bars, which
 * have a gap around each point. For such a curve, arc_look_bars writes the style of separate bars
 * that are drawn before the points. */
int arc_look_bars_apart(const arc_writer *w, const arc_plot_curve *curve);
void arc_look_bars(arc_writer *w, const arc_plot_panel *panel, size_t position);

/* Writes the command of the shared key. */
void arc_look_draw_key(arc_writer *w);

/* --- figure.c --------------------------------------------------------------------------------- */

/* Computes the number of rows and columns of the grid of panels. By default the grid is about
 * square. */
void arc_plot_grid(const arc_plot_figure *figure, int *rows, int *columns);

/* Returns the limits of a panel's data. Axis limits that the user set replace the limits of the
 * data. */
arc_plot_box arc_plot_extent(const arc_plot_panel *panel);

/* --- canvas.c --------------------------------------------------------------------------------- */

/* Chooses the canvas of an output from the terminals of the running gnuplot, or from all known
 * terminals if `session` is NULL. Errors: ARC_ARGUMENT for an invalid file name, ARC_MISSING if no
 * terminal is suitable. */
arc_status arc_canvas_choose(const arc_plot_figure *figure, const arc_plot_output *output,
                             const arc_gnuplot *session, arc_canvas *canvas, arc_error *error);

/* Writes the command that sets the terminal. `animation` has additional options of the terminal, or
 * is "". */
void arc_canvas_command(const arc_canvas *canvas, const char *animation, arc_text *script);

/* --- script.c --------------------------------------------------------------------------------- */

/* Writes the commands of a figure that has been checked. */
void arc_plot_commands(const arc_plot_figure *figure, const arc_canvas *canvas, arc_text *script);

/* --- tick_words.c ----------------------------------------------------------------------------- */

/* Writes the ticks of the axis `name` ("x" or "y") with the words of `axis`, or with numbers if
 * `axis` has no words (tick_words.c). */
void arc_ticks_write(arc_writer *w, const char *name, const arc_plot_axis *axis, arc_ticks ticks);

/* Writes the ticks of the colour scale at multiples of `step`. With the step 0 gnuplot chooses the
 * ticks. */
void arc_ticks_of_scale(arc_writer *w, double step);

/* --- labels.c --------------------------------------------------------------------------------- */

/* These functions are for titles that are written beside the frame, at the ends of the curves.
 * arc_labels_width returns the width of the titles [characters], arc_labels_write writes the
 * titles. */
double arc_labels_width(const arc_plot_panel *panel);
void arc_labels_write(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                      double rows);

/* --- dot_marks.c ------------------------------------------------------------------------------ */

/* Marks of curves in pictures of Braille dots. arc_dot_marked returns true if a curve has marks in
 * `panel` or, if `panel` is NULL, in any panel. arc_dot_marks_block writes the positions of the
 * marks that lie within the ranges of the axes, `box`. arc_dot_marks_words writes the part of the
 * plot command that draws the marks. */
int arc_dot_marked(const arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve);
void arc_dot_marks_block(arc_writer *w, size_t number, const arc_plot_box *box);
void arc_dot_marks_words(arc_writer *w, size_t number);

/* --- panel.c ---------------------------------------------------------------------------------- */

/* Writes settings, data and plot command of one panel. If `framed` is 1, the panel has the margins
 * of `frame`, otherwise gnuplot's default margins. */
void arc_panel_write(arc_writer *w, size_t number, const arc_plot_frame *frame, int framed);

/* Returns the length [characters] of the longest tick label of the y axis. `rows` is the height of
 * the frame in rows. */
size_t arc_panel_label(const arc_writer *w, const arc_plot_panel *panel, double rows);

/* Returns the width [characters] needed to the right of a frame that is `columns` characters
 * wide. 0 means gnuplot's default. */
double arc_panel_right(const arc_writer *w, const arc_plot_panel *panel, double columns);

/* --- data.c ----------------------------------------------------------------------------------- */

/* Writes the points of a curve as rows of a datablock. Values that are not finite interrupt the
 * curve. */
void arc_data_curve(const arc_plot_panel *panel, const arc_plot_curve *curve, arc_text *script);

/* --- clear.c ---------------------------------------------------------------------------------- */

/* Extends the axes slightly if a curve runs along the frame. Extends automatic ends of logarithmic
 * axes to 1, 2 or 5 times a power of ten. */
void arc_plot_clear(const arc_canvas *canvas, arc_plot_panel *panel);

/* Sets the same y range in all panels with the same y label. Limits that the user set are
 * not changed. */
void arc_plot_share(arc_plot_panel *panels, size_t count);

/* --- contours.c ------------------------------------------------------------------------------- */

/* Computes the range of the field's values inside the box. If the user set an end of the panel's
 * value axis, it replaces the end of this range. */
void arc_field_range(const arc_plot_panel *panel, const arc_plot_box *box, double range[2]);

/* Writes contour lines as rows of segments, and their numbers as rows x, y, value. Each contour
 * line has at most one number, and none if the number would hide the line. The distance of a number
 * from the frame and from the next contour line or number is at least 1.3 text rows; `size`
 * contains the height [text rows] and the width [characters] of the box. Returns the number of
 * segments. */
size_t arc_field_contours(const arc_plot_field *field, const arc_plot_box *box,
                          const double range[2], int levels, const double size[2], arc_text *lines,
                          arc_text *labels);

/* Samples the field at the centres of a grid of columns x rows equal cells in the box. The first
 * row is at y0. Samples outside the polygons are NaN. */
void arc_field_raster(const arc_plot_field *field, const arc_plot_box *box, int columns, int rows,
                      double *values);

#endif

/* What the files that turn a figure into gnuplot commands share. */
#ifndef PLOT_FIGURE_H
#define PLOT_FIGURE_H

#include "plot/plot.h"
#include "plot/text.h"

/* The surface a figure is drawn on, as far as its commands depend on it. */
typedef struct arc_canvas {
  const char *terminal; /* gnuplot's name; NULL: none is set (a script for the user) */
  int text;             /* non-zero: characters, else pixels */
  int ascii, colour;    /* of a text */
  int grey;             /* of pixels: no colours */
  int window;           /* the user can zoom in it */
  int vector;           /* every polygon costs bytes in the file */
  int width, height;    /* characters or pixels */
  double columns, rows; /* the same in characters of the font */
  int fine, dots;       /* text: curves come as dots; this is the surface of the dots */
  double points;        /* size of the letters, as gnuplot's terminal takes it */
  double scale;         /* of lines and marks */
  double inch;          /* pixels of an inch */
  const char *family;   /* of the letters */
} arc_canvas;

/* The characters of points among those of lines, on a surface of dots: one for each of the eight
 * marks; levels of a field have others. */
enum { ARC_DOT_MARK = 'A', ARC_DOT_MARKS = 8 };

/* What a panel shows of the plane; may be turned round. */
typedef struct arc_plot_box {
  double x0, x1, y0, y1;
} arc_plot_box;

/* Where a panel's frame stands: fractions of the canvas from its lower left corner, and its inner
 * size in characters. */
typedef struct arc_plot_frame {
  double left, right, bottom, top;
  double columns, rows;
} arc_plot_frame;

/* What is carried along while one figure is written. */
typedef struct arc_writer {
  const arc_plot_figure *figure;
  const arc_canvas *canvas;
  arc_text *out;
  const char **titles; /* the distinct titles, for one key of all panels */
  size_t title_count;
} arc_writer;

/* The numbers of an axis. */
typedef struct arc_ticks {
  double step;     /* 0: gnuplot's choice */
  int digits;      /* significant ones a label shows */
  size_t longest;  /* characters of the longest label */
  int powers;      /* written as 7e-4 */
  int decimals;    /* of the 7 */
  int decades;     /* between labels of a logarithmic axis; 0: none, or gnuplot's choice */
  int first, last; /* its decades, 10^first to 10^last */
  int parts;       /* labelled besides the powers: 1 all multiples, 3 twice and five times */
  int bare;        /* powers without the 7 */
} arc_ticks;

/* Ticks of an axis that shows from..to (in either order), at most about `most` of them; labels
 * stand above each other, or side by side in so many columns, with two between them. */
arc_ticks arc_ticks_up(const arc_plot_axis *axis, double from, double to, double most);
arc_ticks arc_ticks_across(const arc_plot_axis *axis, double from, double to, double most,
                           double columns);

/* Characters in a line of a panel's title. */
double arc_panel_columns(const arc_writer *w);

/* The grid of panels: as given, or about as wide as high. */
void arc_plot_grid(const arc_plot_figure *figure, int *rows, int *columns);

/* The canvas of an output. `session` tells which terminals there are; NULL: all.
 * Errors: ARC_ARGUMENT, ARC_MISSING. */
arc_status arc_canvas_choose(const arc_plot_figure *figure, const arc_plot_output *output,
                             const arc_gnuplot *session, arc_canvas *canvas, arc_error *error);

/* The command that sets the terminal. `animation`: more words for it, or "". */
void arc_canvas_command(const arc_canvas *canvas, const char *animation, arc_text *script);

/* The commands that draw a figure that has been checked. */
void arc_plot_commands(const arc_plot_figure *figure, const arc_canvas *canvas, arc_text *script);

/* A command with a user's words quoted in its middle. The first is for names, which stay as they
 * are; the second for what people read: with its own word whether gnuplot shall find marks in it.
 */
void arc_writer_words(arc_writer *w, const char *before, const char *words, const char *after);
void arc_writer_label(arc_writer *w, const char *before, const char *words, const char *after);

/* The same of a title that has so many characters in a line; and in how many lines it comes. */
void arc_writer_title(arc_writer *w, const char *before, const char *words, double columns,
                      const char *after);
int arc_title_lines(const char *words, double columns);

/* The titles that stand beside the frame at the ends of their curves: the room they take in
 * characters, and their commands. */
double arc_labels_room(const arc_plot_panel *panel);
void arc_labels_write(arc_writer *w, const arc_plot_panel *panel, const arc_plot_box *box,
                      double rows);

/* Smallest and largest value of the scaled curves, or as the panel's value axis says. Returns 0
 * where there is none, or where characters stand for colours. */
int arc_look_scale(const arc_writer *w, const arc_plot_panel *panel, double range[2]);

/* Colour (from 1) by which a curve, the position-th of its panel, is drawn. */
int arc_look_colour(const arc_writer *w, const arc_plot_curve *curve, size_t position);

/* Whether a line of dots has marks upon it; panel NULL: of any. Their data, within the box, and the
 * words of the plot command that draw them. */
int arc_dot_marked(const arc_writer *w, const arc_plot_panel *panel, const arc_plot_curve *curve);
void arc_dot_marks_block(arc_writer *w, size_t number, const arc_plot_box *box);
void arc_dot_marks_words(arc_writer *w, size_t number);

/* The settings, data and plot command of one panel. `framed`: the frame is imposed, else gnuplot
 * finds its own margins. */
void arc_panel_write(arc_writer *w, size_t number, const arc_plot_frame *frame, int framed);

/* Characters of the longest number beside a panel whose frame is so many rows high. */
size_t arc_panel_label(const arc_writer *w, const arc_plot_panel *panel, double rows);

/* Characters that stand beyond the right end of a frame so wide; 0: whatever gnuplot leaves. */
double arc_panel_right(const arc_writer *w, const arc_plot_panel *panel, double columns);

/* Whether one key stands for all panels; the number of a title in it; the rows it takes. */
int arc_look_one_key(const arc_writer *w);
size_t arc_look_title(const arc_writer *w, const char *title);
double arc_look_key_rows(const arc_writer *w);
/* The rows that a panel's own key takes below it. */
double arc_look_own_key_rows(const arc_writer *w, const arc_plot_panel *panel);

/* Fills the writer's titles; sets the failed flag of its text when memory is out. */
void arc_look_collect(arc_writer *w);

/* The colours and marks that curves are numbered by. */
void arc_look_series(arc_writer *w);

/* The words of a plot command that say how a curve, the position-th of its panel, is drawn. */
void arc_look_curve(arc_writer *w, const arc_plot_panel *panel, size_t position);

/* The command that draws the one key; everything else of the canvas is left alone. */
void arc_look_draw_key(arc_writer *w);

/* The rows of a curve for a datablock: finite ones, breaks elsewhere. */
void arc_data_curve(const arc_plot_panel *panel, const arc_plot_curve *curve, arc_text *script);

/* Smallest and largest of what a panel holds, its own ranges taking precedence. */
arc_plot_box arc_plot_extent(const arc_plot_panel *panel);

/* Moves ends of the axes so that curves are clear of the frame: a range's end along which a curve
 * runs lies a little beyond it, open ends of logarithmic axes at 1, 2 or 5 times a power of ten. */
void arc_plot_clear(const arc_canvas *canvas, arc_plot_panel *panel);

/* Panels of one figure that show the same quantity along y, by its label, get the same range where
 * it is open. */
void arc_plot_share(arc_plot_panel *panels, size_t count);

/* Smallest and largest value of the field inside the box, or as the panel's value axis says. */
void arc_field_range(const arc_plot_panel *panel, const arc_plot_box *box, double range[2]);

/* The round step between about so many contour lines in a range; theirs are its multiples within.
 */
double arc_field_step(const double range[2], int levels);

/* Writes contour lines as rows of segments, one line every step, and labels as rows x, y, value, at
 * most one for each line. Returns the number of segments. */
size_t arc_field_contours(const arc_plot_field *field, const arc_plot_box *box,
                          const double range[2], int levels, arc_text *lines, arc_text *labels);

/* The field in the middles of columns x rows equal cells of the box, NaN where no polygon is; the
 * first row is the one at y0. */
void arc_field_raster(const arc_plot_field *field, const arc_plot_box *box, int columns, int rows,
                      double *values);

#endif

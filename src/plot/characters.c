/* Converts pictures in characters: reads gnuplot's output into cells, adds the curves as Braille
 * dots, and writes the cells. For Braille dots gnuplot draws two pictures. The first picture has
 * axes and texts on the grid of characters. The second picture has only the curves, on a finer grid
 * where each character is one dot. Thus gnuplot itself clips the curves and draws steps and
 * logarithmic axes. The only escape sequences of gnuplot's character terminal are colours, ESC [
 * ... m. */
#include "plot/characters.h"

#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"

/* Marks of curves in UTF-8: circle, square, triangle and diamond, first filled, then open. */
static const char marks[ARC_DOT_MARKS][4] = {"\342\227\217", "\342\226\240", "\342\226\262",
                                             "\342\227\206", "\342\227\213", "\342\226\241",
                                             "\342\226\263", "\342\227\207"};
static const char dash[] = "\342\240\222"; /* Braille dots at half height: a line in the key */

enum { BLACK = 0, NO_COLOUR = -1, BYTES = 4 };

typedef struct cell {
  char bytes[BYTES]; /* one character in UTF-8 */
  int length;        /* number of bytes; 0 for a blank */
  int colour;        /* colour number 0 to 7, or NO_COLOUR */
} cell;

typedef struct screen {
  cell *cells;
  size_t columns, rows;
} screen;

/* --- reading a picture ------------------------------------------------------------------------ */

/* Returns the length of the escape sequence for a colour at `bytes`, or 0 if there is none. */
static size_t sequence(const char *bytes, size_t left, int *colour) {
  if (left < 3 || bytes[0] != '\033' || bytes[1] != '[') return 0;
  const char *end = memchr(bytes, 'm', left);
  if (!end) return 0;
  *colour = NO_COLOUR;
  for (const char *c = bytes + 2; c + 1 < end; c++)
    if (*c == '3' && (c[-1] == ';' || c[-1] == '[') && c[1] <= '7') *colour = c[1] - '0';
  return (size_t)(end - bytes) + 1;
}

static int utf8_length(unsigned char first) {
  return first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

static void set_cell(cell *c, const char *bytes, int length, int colour) {
  memcpy(c->bytes, bytes, (size_t)length);
  c->length = length;
  c->colour = colour;
}

/* Copies each character of the picture into its cell. If the screen has no cells yet, only
 * counts rows and columns. */
static void scan(const char *picture, size_t length, screen *s) {
  size_t row = 0, column = 0, rows = 0, columns = 0;
  int colour = NO_COLOUR;
  for (size_t i = 0; i < length;) {
    size_t skip = sequence(picture + i, length - i, &colour);
    int bytes = skip ? (int)skip : utf8_length((unsigned char)picture[i]);
    if (!skip && picture[i] == '\n') {
      row++, column = 0;
    } else if (!skip && picture[i] != '\f' && picture[i] != '\r') {
      if (s->cells && picture[i] != ' ' && row < s->rows && column < s->columns &&
          i + (size_t)bytes <= length)
        set_cell(&s->cells[row * s->columns + column], picture + i, bytes, colour);
      column++;
      columns = column > columns ? column : columns;
      rows = row + 1;
    }
    i += (size_t)bytes;
  }
  if (!s->cells) s->rows = rows, s->columns = columns;
}

static int read_screen(const char *picture, size_t length, screen *s) {
  *s = (screen){NULL, 0, 0};
  scan(picture, length, s);
  s->cells = calloc(s->rows * s->columns + 1, sizeof *s->cells);
  if (s->cells) scan(picture, length, s);
  return s->cells != NULL;
}

/* --- adding the dots of curves ---------------------------------------------------------------- */

static const cell *dot_at(const screen *s, size_t row, size_t column) {
  static const cell blank = {.colour = NO_COLOUR};
  return row < s->rows && column < s->columns ? &s->cells[row * s->columns + column] : &blank;
}

/* Returns the mark for the letter `c` in gnuplot's picture, or NULL if `c` is no such letter. */
static const char *mark_of(char c) {
  return c >= ARC_DOT_MARK && c < ARC_DOT_MARK + ARC_DOT_MARKS ? marks[c - ARC_DOT_MARK] : NULL;
}

/* Sets a cell to the Braille character of its eight dots, in the most frequent colour of the dots.
 * If one of the dots is a mark, the cell shows the mark instead. */
static void set_dots(const screen *dots, size_t row, size_t column, cell *to) {
  static const int bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
  const char *mark = NULL;
  int pattern = 0, count[9] = {0}, colour = NO_COLOUR;
  for (size_t r = 0; r < 4; r++)
    for (size_t c = 0; c < 2; c++) {
      const cell *dot = dot_at(dots, 4 * row + r, 2 * column + c);
      if (!dot->length) continue;
      pattern |= bits[r][c];
      const char *point = mark_of(*dot->bytes);
      int more = ++count[dot->colour + 1] > count[colour + 1];
      if ((more && !mark) || (point && !mark)) colour = dot->colour;
      if (point && !mark) mark = point;
    }
  const char braille[] = {(char)0xe2, (char)(0xa0 | pattern >> 6), (char)(0x80 | (pattern & 0x3f))};
  set_cell(to, mark ? mark : braille, pattern ? 3 : 0, colour);
}

/* Returns true if the cell is part of the frame and has a mark of a curve. A mark replaces the
 * frame in such a cell, but a line of a curve does not. */
static int is_point_on_frame(const screen *dots, const cell *c, size_t row, size_t column) {
  int found = 0;
  if (c->colour != NO_COLOUR || !strchr("|+-", *c->bytes)) return 0;
  for (size_t i = 0; i < 8; i++) {
    const cell *dot = dot_at(dots, 4 * row + i / 2, 2 * column + i % 2);
    found |= dot->length && mark_of(*dot->bytes) != NULL;
  }
  return found;
}

/* Replaces a cell of the picture by dots if it is blank or part of a curve. Curves are black in
 * the picture, so a coloured line or mark in the picture belongs to the key. */
static void lay_over(const screen *dots, size_t row, size_t column, cell *c) {
  if (!c->length || c->colour == BLACK || is_point_on_frame(dots, c, row, column))
    set_dots(dots, row, column, c);
  else if (c->colour != NO_COLOUR && mark_of(*c->bytes))
    set_cell(c, mark_of(*c->bytes), 3, c->colour);
  else if (c->colour != NO_COLOUR && strchr("+-", *c->bytes))
    set_cell(c, dash, 3, c->colour);
}

/* --- writing ---------------------------------------------------------------------------------- */

typedef struct writer {
  arc_text *out;
  int colour;    /* colour that was written last */
  size_t lines;  /* line breaks that are not written yet */
  int something; /* true once a line that is not empty was written */
} writer;

static void write_colour(writer *w, int colour) {
  if (w->colour == colour) return;
  if (colour == NO_COLOUR)
    arc_text_word(w->out, "\033[0m");
  else
    arc_text_format(w->out, "\033[1;3%dm", colour);
  w->colour = colour;
}

static void write_cell(writer *w, const cell *c) {
  static const char lines[] = "=*#&$%@="; /* characters for black, red, green, yellow, blue,
                                             magenta, cyan and white lines */
  write_colour(w, c->colour);
  if (c->colour != NO_COLOUR && strchr("+-|", *c->bytes))
    arc_text_add(w->out, &lines[c->colour], 1);
  else
    arc_text_add(w->out, c->bytes, (size_t)c->length);
}

static void write_row(writer *w, const cell *cells, size_t columns) {
  size_t blanks = 0;
  for (size_t i = 0; i < columns; i++) {
    if (!cells[i].length) {
      blanks++;
      continue;
    }
    for (; w->lines > 0; w->lines--) arc_text_word(w->out, "\n");
    for (; blanks > 0; blanks--) arc_text_word(w->out, " ");
    write_cell(w, &cells[i]);
    w->something = 1;
  }
  write_colour(w, NO_COLOUR);
  if (w->something) w->lines++;
}

void arc_characters(const char *picture, size_t length, const char *dots, size_t dots_length,
                    arc_text *out) {
  screen words, curves = {NULL, 0, 0};
  writer w = {.out = out, .colour = NO_COLOUR};
  if (!read_screen(picture, length, &words) || (dots && !read_screen(dots, dots_length, &curves)))
    out->failed = 1;
  for (size_t row = 0; !out->failed && row < words.rows; row++) {
    cell *cells = words.cells + row * words.columns;
    for (size_t column = 0; dots && column < words.columns; column++)
      lay_over(&curves, row, column, &cells[column]);
    write_row(&w, cells, words.columns);
  }
  if (w.something) arc_text_word(out, "\n");
  free(words.cells);
  free(curves.cells);
}

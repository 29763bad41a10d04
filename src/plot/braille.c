/* Curves as Braille dots, eight to a character. Leans on text.c.
 *
 * gnuplot draws twice: the axes and words on the surface of the characters, the curves alone on one
 * where each character is a dot. Clipping, steps, logarithms stay gnuplot's.
 */
#include "plot/braille.h"

#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"

static const char point[] = "\342\227\217"; /* a filled circle */
static const char dash[] = "\342\240\222";  /* two dots in the middle: a line in the key */

enum { BLACK = 0, NO_COLOUR = -1 };

typedef struct cell {
  const char *bytes; /* of one character of UTF-8; NULL: blank */
  int length, colour;
} cell;

typedef struct screen {
  cell *cells;
  size_t columns, rows;
} screen;

/* --- reading a picture ------------------------------------------------------------------------ */

/* Length of the colour sequence at `bytes`, 0 when there is none. */
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

/* Calls for each character its place; with no cells only counts rows and columns. */
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
        s->cells[row * s->columns + column] = (cell){picture + i, bytes, colour};
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

/* --- laying one over the other ---------------------------------------------------------------- */

static const cell *cell_at(const screen *s, size_t row, size_t column) {
  static const cell blank = {NULL, 0, NO_COLOUR};
  return row < s->rows && column < s->columns ? &s->cells[row * s->columns + column] : &blank;
}

static void put_colour(arc_text *out, int colour) {
  if (colour == NO_COLOUR)
    arc_text_word(out, "\033[0m");
  else
    arc_text_format(out, "\033[1;3%dm", colour);
}

/* The eight dots of a character, in the colour most of them have; a mark takes its place whole. */
static void put_dots(const screen *dots, size_t row, size_t column, arc_text *out) {
  static const int bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
  int pattern = 0, mark = 0, count[9] = {0}, colour = NO_COLOUR;
  for (size_t r = 0; r < 4; r++)
    for (size_t c = 0; c < 2; c++) {
      const cell *dot = cell_at(dots, 4 * row + r, 2 * column + c);
      if (!dot->bytes) continue;
      pattern |= bits[r][c];
      int is_mark = *dot->bytes == ARC_DOT_MARK;
      if (++count[dot->colour + 1] > count[colour + 1] || (is_mark && !mark)) colour = dot->colour;
      mark |= is_mark;
    }
  if (!pattern) {
    arc_text_word(out, " ");
    return;
  }
  put_colour(out, colour);
  if (mark)
    arc_text_word(out, point);
  else
    arc_text_add(
        out, (char[]){(char)0xe2, (char)(0xa0 | pattern >> 6), (char)(0x80 | (pattern & 0x3f))}, 3);
  put_colour(out, NO_COLOUR);
}

/* A point on the frame is seen; of a line there the frame itself. */
static int is_point_on_frame(const screen *dots, const cell *c, size_t row, size_t column) {
  int found = 0;
  if (c->colour != NO_COLOUR || !strchr("|+-", *c->bytes)) return 0;
  for (size_t i = 0; i < 8; i++) {
    const cell *dot = cell_at(dots, 4 * row + i / 2, 2 * column + i % 2);
    found |= dot->bytes && *dot->bytes == ARC_DOT_MARK;
  }
  return found;
}

/* Lines in colour are the samples of the key: the curves themselves are black here. */
static const char *drawn(const cell *c) {
  if (c->colour == NO_COLOUR) return NULL;
  return *c->bytes == ARC_DOT_MARK ? point : strchr("+-", *c->bytes) ? dash : NULL;
}

static void put_cell(const cell *c, arc_text *out) {
  if (c->colour != NO_COLOUR) put_colour(out, c->colour);
  if (drawn(c))
    arc_text_word(out, drawn(c));
  else
    arc_text_add(out, c->bytes, (size_t)c->length);
  if (c->colour != NO_COLOUR) put_colour(out, NO_COLOUR);
}

void arc_braille(const char *picture, size_t length, const char *dots, size_t dots_length,
                 arc_text *out) {
  screen words, curves = {NULL, 0, 0};
  if (!read_screen(picture, length, &words) || !read_screen(dots, dots_length, &curves))
    out->failed = 1;
  for (size_t row = 0; !out->failed && row < words.rows; row++) {
    for (size_t column = 0; column < words.columns; column++) {
      const cell *c = cell_at(&words, row, column);
      if (c->bytes && c->colour != BLACK && !is_point_on_frame(&curves, c, row, column))
        put_cell(c, out);
      else
        put_dots(&curves, row, column, out);
    }
    arc_text_word(out, "\n");
  }
  free(words.cells);
  free(curves.cells);
}

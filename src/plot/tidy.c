/* Tidies pictures in characters. Leans on text.c.
 *
 * The only escape sequences gnuplot's character terminal writes are colours, ESC [ ... m.
 */
#include "plot/tidy.h"

#include <string.h>

/* The number of the foreground colour in use (0 to 7), or none. */
enum { NO_COLOUR = -1 };

typedef struct tidier {
  arc_text *out;
  int wanted;    /* colour of what comes next */
  int current;   /* colour the output is in */
  size_t blanks; /* not yet written */
  size_t lines;  /* line breaks not yet written */
  int something; /* a line with something in it was written */
} tidier;

/* The colour of an escape sequence's numbers, such as 1;31 or 0;39. */
static int colour_of(const char *numbers, size_t length) {
  for (size_t i = 0; i + 1 < length; i++)
    if (numbers[i] == '3' && (i == 0 || numbers[i - 1] == ';'))
      return numbers[i + 1] <= '7' ? numbers[i + 1] - '0' : NO_COLOUR;
  return NO_COLOUR;
}

/* Returns the length of the escape sequence at `bytes`, 0 when there is none. */
static size_t escape(tidier *t, const char *bytes, size_t left) {
  if (left < 3 || bytes[0] != '\033' || bytes[1] != '[') return 0;
  const char *end = memchr(bytes, 'm', left);
  if (!end) return 0;
  t->wanted = colour_of(bytes + 2, (size_t)(end - bytes) - 2);
  return (size_t)(end - bytes) + 1;
}

static void set_colour(tidier *t, int colour) {
  if (t->current == colour) return;
  if (colour == NO_COLOUR)
    arc_text_word(t->out, "\033[0m");
  else
    arc_text_format(t->out, "\033[1;3%dm", colour);
  t->current = colour;
}

static void line_break(tidier *t) {
  set_colour(t, NO_COLOUR);
  t->blanks = 0;
  if (t->something) t->lines++;
}

static char mark_of(char c, int colour) {
  static const char marks[] =
      "=*#&$%@="; /* black, red, green, yellow, blue, magenta, cyan, white */
  return colour != NO_COLOUR && strchr("+-|", c) ? marks[colour] : c;
}

static void visible(tidier *t, char c) {
  for (; t->lines > 0; t->lines--) arc_text_word(t->out, "\n");
  for (; t->blanks > 0; t->blanks--) arc_text_word(t->out, " ");
  set_colour(t, t->wanted);
  c = mark_of(c, t->wanted);
  arc_text_add(t->out, &c, 1);
  t->something = 1;
}

void arc_tidy(const char *picture, size_t length, arc_text *out) {
  tidier t = {.out = out, .wanted = NO_COLOUR, .current = NO_COLOUR};
  for (size_t i = 0; i < length; i++) {
    size_t skip = escape(&t, picture + i, length - i);
    if (skip > 0)
      i += skip - 1;
    else if (picture[i] == '\n')
      line_break(&t);
    else if (picture[i] == ' ')
      t.blanks++;
    else if (picture[i] != '\f' && picture[i] != '\r')
      visible(&t, picture[i]);
  }
  set_colour(&t, NO_COLOUR);
  if (t.something) arc_text_word(out, "\n");
}

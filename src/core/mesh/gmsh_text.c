/* Text of a Gmsh file in memory, which is read line by line and number by number. */
#include "core/mesh/gmsh_text.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void begin(msh_text *t, size_t length) {
  t->next = t->at = t->data;
  t->end = t->data + length;
}

arc_status arc_msh_open(msh_text *t, const char *path, arc_error *error) {
  size_t length = 0;
  *t = (msh_text){.path = path};
  const arc_status status = arc_file_read(path, &t->data, &length, error);
  if (status == ARC_OK) begin(t, length);
  return status;
}

/* Copies the text, because the reader replaces the ends of lines by zero bytes. */
arc_status arc_msh_copy(msh_text *t, const char *name, const char *from, size_t length,
                        arc_error *error) {
  *t = (msh_text){.path = name, .data = malloc(length + 1)};
  if (!t->data) return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", name);
  memcpy(t->data, from, length);
  t->data[length] = '\0';
  begin(t, length);
  return ARC_OK;
}

void arc_msh_close(msh_text *t) {
  free(t->data);
  *t = (msh_text){0};
}

static int is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

static void skip_space(msh_text *t) {
  while (is_space(*t->at)) t->at++;
}

/* Removes white space at the end of a line. */
static void trim(const char *line, char *stop) {
  while (stop > line && is_space(stop[-1])) stop--;
  *stop = 0;
}

int arc_msh_line(msh_text *t) {
  while (t->next < t->end) {
    t->at = t->next;
    char *stop = memchr(t->at, '\n', (size_t)(t->end - t->at));
    t->next = stop ? stop + 1 : t->end;
    trim(t->at, stop ? stop : t->end);
    t->line++;
    skip_space(t);
    if (*t->at) return 1;
  }
  t->at = t->end;
  return 0;
}

/* Moves to `stop`, the end of a number in the line. Returns 0 if a character other than white
 * space follows. */
static int take(msh_text *t, char *stop) {
  if (stop == t->at || (*stop && !is_space(*stop))) return 0;
  t->at = stop;
  skip_space(t);
  return 1;
}

int arc_msh_real(msh_text *t, double *value) {
  char *stop;
  *value = strtod(t->at, &stop);
  return isfinite(*value) && take(t, stop);
}

int arc_msh_whole(msh_text *t, long long *value) {
  char *stop;
  errno = 0;
  *value = strtoll(t->at, &stop, 10);
  return errno == 0 && take(t, stop);
}

arc_status arc_msh_fail(const msh_text *t, arc_error *error, const char *format, ...) {
  char what[400];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(what, sizeof what, format, arguments);
  va_end(arguments);
  return arc_fail(error, ARC_FORMAT, "%s, line %ld: %s", t->path, t->line, what);
}

msh_shown arc_msh_show(const char *text) {
  msh_shown shown = {"nothing"};
  if (!*text) return shown;
  size_t n = 0;
  for (; n + 4 < sizeof shown.text && text[n]; n++)
    shown.text[n] = isprint((unsigned char)text[n]) ? text[n] : '?';
  memcpy(&shown.text[n], text[n] ? "..." : "", text[n] ? 4 : 1);
  return shown;
}

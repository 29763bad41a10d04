/* The text of a Gmsh file: whole in memory, cut into lines and numbers. */
#include "core/mesh/gmsh.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A million elements take a tenth of it. */
static const size_t largest_file = (size_t)1 << 30;

/* Reads on until the end; the room doubles. */
static arc_status read_all(msh_text *t, FILE *stream, arc_error *error) {
  size_t room = 1 << 16, length = 0;
  char *data = malloc(room);
  while (data) {
    length += fread(data + length, 1, room - 1 - length, stream);
    if (length + 1 < room) break;
    if (length > largest_file) {
      free(data);
      return arc_fail(error, ARC_FORMAT, "%s: expected at most 1 GiB, got more", t->path);
    }
    char *more = realloc(data, room *= 2);
    if (!more) free(data);
    data = more;
  }
  if (!data) return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", t->path);
  t->data = t->next = t->at = data;
  t->end = data + length;
  *t->end = 0;
  if (!ferror(stream)) return ARC_OK;
  return arc_fail(error, ARC_IO, "cannot read %s: %s", t->path, strerror(errno));
}

arc_status arc_msh_open(msh_text *t, const char *path, arc_error *error) {
  *t = (msh_text){.path = path};
  FILE *stream = fopen(path, "rb");
  if (!stream) return arc_fail(error, ARC_IO, "cannot read %s: %s", path, strerror(errno));
  const arc_status status = read_all(t, stream, error);
  fclose(stream);
  if (status != ARC_OK) arc_msh_close(t);
  return status;
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

/* Ends a line before the white space at its end. */
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

/* Takes what a conversion has read up to `stop`, if that is a whole word. */
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

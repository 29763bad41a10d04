/* Functions that return texts of Gmsh files by name. A text is the file
 * tests/files/msh/NAME.msh, or good-41.msh with the change that tests/files/msh/broken lists
 * under "* NAME". */
#ifndef TESTS_MESH_TEXT_H
#define TESTS_MESH_TEXT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MESH_TEXT_ROOM = 20000 };

/* Returns the content of a whole file, or NULL if the file does not exist. */
static char *mesh_file(const char *name, size_t *length) {
  char path[100];
  snprintf(path, sizeof path, "tests/files/msh/%s", name);
  FILE *file = fopen(path, "rb");
  if (!file) return NULL;
  char *text = calloc(1, MESH_TEXT_ROOM);
  assert_non_null(text);
  *length = fread(text, 1, MESH_TEXT_ROOM - 1, file);
  assert_true(feof(file));
  fclose(file);
  return text;
}

/* Returns the start of the line that follows the line at `at`. */
static const char *next_line(const char *at) {
  const char *end = strchr(at, '\n');
  return end ? end + 1 : at + strlen(at);
}

/* Appends the lines from `*from` up to but excluding line number `until` to `to`. */
static void copy_lines(char *to, const char **from, long *line, long until) {
  for (; *line < until && **from; (*line)++) {
    const char *next = next_line(*from);
    strncat(to, *from, (size_t)(next - *from));
    *from = next;
  }
}

/* Applies one change to the text `good` and writes the result to `to`: "4a5" inserts lines after
 * line 4, "4,6d3" deletes lines 4 to 6, "4c4" replaces line 4. */
static void apply_change(const char *change, const char *good, char *to) {
  for (long line = 0; *change && *change != '*';) {
    char *kind;
    const long first = strtol(change, &kind, 10);
    const long last = *kind == ',' ? strtol(kind + 1, &kind, 10) : first;
    copy_lines(to, &good, &line, *kind == 'a' ? last : first - 1);
    for (; line < last; line++) good = next_line(good);
    for (change = next_line(change); *change == '>'; change = next_line(change))
      strncat(to, change + 2, (size_t)(next_line(change) - change - 2));
    if (!*change || *change == '*') strcat(to, good);
  }
}

/* Returns the text of the mesh with this name; the caller frees the text. */
static char *mesh_text(const char *name, size_t *length) {
  char with_ending[60], entry[60];
  snprintf(with_ending, sizeof with_ending, "%s.msh", name);
  char *text = mesh_file(with_ending, length);
  if (text) return text;
  snprintf(entry, sizeof entry, "\n* %s\n", name);
  char *broken = mesh_file("broken", length), *good = mesh_file("good-41.msh", length);
  assert_true(broken && good && strstr(broken, entry));
  text = calloc(1, MESH_TEXT_ROOM);
  assert_non_null(text);
  apply_change(strstr(broken, entry) + strlen(entry), good, text);
  *length = strlen(text);
  free(broken);
  free(good);
  return text;
}

#endif

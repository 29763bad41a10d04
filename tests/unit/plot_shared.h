/* Common parts of the plot tests: a temporary folder, scripts that replace gnuplot, and one
 * curve. */
#ifndef TESTS_PLOT_SHARED_H
#define TESTS_PLOT_SHARED_H

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plot/plot.h"

static char folder[] = "/tmp/archard-plot-XXXXXX";

static const double line_x[] = {0, 1, 2, 3, 4}, line_y[] = {0, 1, 4, 9, 16};

static inline char *path_of(const char *name, char path[256]) {
  snprintf(path, 256, "%s/%s", folder, name);
  return path;
}

static inline int exists(const char *name) {
  char path[256];
  return access(path_of(name, path), F_OK) == 0;
}

/* Returns the content of a file in the test's folder. The next call overwrites the returned
 * text. */
static inline const char *content(const char *name) {
  static char text[20000];
  char path[256];
  FILE *file = fopen(path_of(name, path), "rb");
  size_t length = file ? fread(text, 1, sizeof text - 1, file) : 0;
  if (file) fclose(file);
  text[length] = '\0';
  return text;
}

/* Writes a shell script that the plot functions start instead of gnuplot. */
static inline char *fake(const char *name, const char *body, char path[256]) {
  FILE *file = fopen(path_of(name, path), "w");
  fprintf(file, "#!/bin/sh\n%s\n", body);
  fclose(file);
  chmod(path, 0755);
  return path;
}

static inline arc_gnuplot *open_session(const char *program) {
  arc_gnuplot_def def = arc_gnuplot_default();
  arc_gnuplot *session = NULL;
  def.program = program;
  def.start_timeout = 10;
  assert_int_equal(arc_gnuplot_open(&def, &session, NULL), ARC_OK);
  return session;
}

static inline arc_plot_curve curve(const char *title) {
  return (arc_plot_curve){.x = line_x, .y = line_y, .count = 5, .title = title};
}

static inline arc_plot_panel panel_of(const arc_plot_curve *curves, size_t count) {
  arc_plot_panel panel = arc_plot_panel_default();
  panel.curves = curves;
  panel.curve_count = count;
  return panel;
}

static const arc_plot_output as_text = {.medium = ARC_PLOT_TEXT, .width = 70, .height = 20};

/* Draws one curve with characters and returns the text, which the caller frees. */
__attribute__((noinline)) static char *draw_text(arc_gnuplot *session, const arc_plot_curve *c,
                                                 arc_error *error) {
  arc_plot_panel panel = panel_of(c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  char *picture = NULL;
  arc_plot_draw(session, &figure, &as_text, &picture, NULL, error);
  return picture;
}

static inline void assert_draws(arc_gnuplot *session) {
  arc_plot_curve c = curve("works");
  arc_error error = {.message = ""};
  char *picture = draw_text(session, &c, &error);
  assert_string_equal(error.message, "");
  assert_non_null(picture);
  assert_non_null(strstr(picture, "* works"));
  free(picture);
}

static inline int set_up(void **state) {
  *state = open_session("gnuplot");
  return mkdtemp(folder) ? 0 : -1;
}

static inline int tear_down(void **state) {
  arc_gnuplot *session = *state;
  char command[80];
  arc_gnuplot_close(&session);
  snprintf(command, sizeof command, "rm -rf %s", folder);
  return system(command);
}

#endif

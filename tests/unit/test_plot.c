/* Tests of figures: pictures in every output format, and refused input. */
#include "plot_shared.h"

#include <math.h>

/* --- pictures --------------------------------------------------------------------------------- */

static void test_text_picture(void **state) {
  arc_plot_curve c = curve("squares");
  arc_error error;
  char *picture = draw_text(*state, &c, &error);
  assert_non_null(picture);
  assert_non_null(strstr(picture, "* squares"));
  assert_null(strchr(picture, '\033'));
  assert_null(strchr(picture, '\f'));
  assert_null(strstr(picture, " \n"));
  assert_int_equal(picture[strlen(picture) - 1], '\n');
  for (const char *line = picture; line && *line; line = strchr(line, '\n') + 1)
    assert_true(strcspn(line, "\n") <= 70);
  free(picture);
}

static void test_text_colour(void **state) {
  arc_plot_curve c[2] = {curve("one"), curve("two")};
  arc_plot_panel panel = panel_of(c, 2);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = as_text;
  char *picture;
  output.colour = 1;
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
  assert_non_null(strstr(picture, "\033[1;31m*")); /* colour and mark of the second curve */
  for (char *line = picture; *line;
       line = strchr(line, '\n') + 1) { /* the colour is reset at the end of each line of the
                                         * picture */
    size_t length = strcspn(line, "\n");
    char *last = NULL;
    for (char *at = line; (at = strchr(at, '\033')) && at < line + length; at++) last = at;
    if (last) assert_memory_equal(last, "\033[0m", 4);
  }
  free(picture);
}

/* Tests that lines of dots are distinguishable without colours: each line has marks, which the
 * key shows. */
static void test_dot_marks(void **state) {
  arc_plot_curve c[2] = {curve("one"), curve("two")};
  arc_plot_panel panel = panel_of(c, 2);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = as_text;
  static const char *const marks[] = {"\342\227\217", "\342\226\240"}; /* marks: circle, square */
  char *picture;
  output.colour = output.fine = 1;
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
  for (int i = 0; i < 2; i++) {
    int count = 0;
    for (char *at = picture; (at = strstr(at, marks[i])); at++) count++;
    assert_in_range(count, 4, 6); /* about five marks on the curve and one in the key */
  }
  free(picture);
  figure.panels = &panel, panel.curve_count = 1;
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
  assert_null(strstr(picture, marks[0])); /* a single curve needs no marks */
  free(picture);
}

static void test_ascii(void **state) {
  arc_plot_curve c = curve("\316\261 = 0.5");
  arc_plot_panel panel = panel_of(&c, 1);
  panel.y.label = "h / \302\265m";
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = as_text;
  char *picture;
  output.ascii = 1;
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
  assert_non_null(strstr(picture, "alpha = 0.5"));
  assert_non_null(strstr(picture, "h / um"));
  for (const char *at = picture; *at; at++) assert_true((unsigned char)*at < 0x80);
  free(picture);
}

/* Tests that the file of each format starts with the signature of the format. */
static void test_files(void **state) {
  static const char *const kinds[][2] = {
      {"a.png", "\211PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}, {"a.eps", "%!PS"},
      {"a.gif", "GIF8"},    {"a.gp", "# Draw"}, {"a.txt", "   "},  {"a.PNG", "\211PNG"}};
  arc_plot_curve c[2] = {curve("one"), curve("two")};
  c[1].style = ARC_PLOT_FILLED;
  arc_plot_panel panel = panel_of(c, 2);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    char path[256], *picture;
    arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = path_of(kinds[i][0], path)};
    assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
    assert_null(picture);
    assert_memory_equal(content(kinds[i][0]), kinds[i][1], strlen(kinds[i][1]));
  }
}

static int stop_as_told(void *told) {
  return *(int *)told;
}

/* Tests that a file that cannot be written, or an incomplete picture, does not change the old
 * file. */
static void test_file_whole_or_not(void **state) {
  (void)state;
  int stop = 0;
  arc_gnuplot_def def = arc_gnuplot_default();
  arc_gnuplot *session = NULL;
  def.should_stop = stop_as_told;
  def.stop_context = &stop;
  assert_int_equal(arc_gnuplot_open(&def, &session, NULL), ARC_OK);
  arc_plot_curve c = curve("x");
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = "/nonexistent/a.png"};
  arc_error error;
  char path[256], command[300], *picture;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, &error), ARC_IO);
  assert_non_null(strstr(error.message, "No such file"));
  FILE *file = fopen(path_of("old.svg", path), "w");
  fputs("precious", file);
  fclose(file);
  output.file = path;
  stop = 1;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, &error), ARC_STOPPED);
  assert_string_equal(content("old.svg"), "precious");
  snprintf(command, sizeof command, "ls -a %s | grep -q part", folder);
  assert_int_not_equal(system(command), 0);
  stop = 0;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, &error), ARC_OK);
  assert_memory_equal(content("old.svg"), "<?xml", 5);
  output.file = "picture.bmp";
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "png svg pdf"));
  arc_gnuplot_close(&session);
}

/* Tests a full disk, which gnuplot does not detect: the old picture is unchanged and an error is
 * returned. */
static void test_full_disk(void **state) {
  (void)state;
  static const char *const names[] = {"full.png", "full.svg", "full.pdf", "full.eps", "full.gif"};
  char program[256], path[256], *picture;
  arc_gnuplot *session =
      open_session(fake("full", "trap '' XFSZ\nulimit -f 4\nexec gnuplot \"$@\"", program));
  arc_plot_curve c = curve("x");
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = path_of(names[i], path)};
    arc_error error;
    FILE *file = fopen(path, "w");
    fputs("precious", file);
    fclose(file);
    assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, &error), ARC_IO);
    assert_non_null(strstr(error.message, "incomplete picture"));
    assert_string_equal(content(names[i]), "precious");
  }
  arc_gnuplot_close(&session);
}

static void test_animation(void **state) {
  arc_plot_curve c = curve("x");
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure frames[3];
  for (int i = 0; i < 3; i++) frames[i] = (arc_plot_figure){.panels = &panel, .panel_count = 1};
  char path[256];
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = path_of("move.gif", path)};
  assert_int_equal(arc_plot_animate(*state, frames, 3, 0.1, &output, NULL), ARC_OK);
  assert_memory_equal(content("move.gif"), "GIF89a", 6);
  output.file = path_of("move.png", path);
  assert_int_equal(arc_plot_animate(*state, frames, 3, 0.1, &output, NULL), ARC_ARGUMENT);
  assert_int_equal(arc_plot_animate(*state, frames, 0, 0.1, &output, NULL), ARC_ARGUMENT);
}

/* Tests a figure of twelve panels: every title occurs once, one key is below the panels, and the
 * frames are aligned. */
static void test_panels(void **state) {
  arc_plot_curve c[2] = {curve("one"), curve("two")};
  arc_plot_panel panels[12];
  for (int i = 0; i < 12; i++) {
    panels[i] = panel_of(c, 2);
    panels[i].title = "panel";
  }
  arc_plot_figure figure = {.panels = panels, .panel_count = 12, .columns = 3, .one_key = 1};
  arc_plot_output output = {.medium = ARC_PLOT_TEXT, .width = 100};
  char *picture;
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
  int titles = 0, keys = 0;
  for (char *at = picture; (at = strstr(at, "panel")); at++) titles++;
  for (char *at = picture; (at = strstr(at, "two")); at++) keys++;
  assert_int_equal(titles, 12);
  assert_int_equal(keys, 1);
  free(picture);
}

/* Checks that the script contains contour lines of x + y with exactly these two values. */
static void assert_contours_at(const char *script, double one, double two) {
  const char *at = strstr(script, "$k0 << END\n");
  int found[2] = {0, 0};
  assert_non_null(at);
  for (at = strchr(at, '\n') + 1; strncmp(at, "END", 3) != 0; at = strchr(at, '\n') + 1) {
    double x, y;
    if (sscanf(at, "%lf %lf", &x, &y) != 2 || *at == '\n') continue;
    assert_true(fabs(x + y - one) < 1e-12 || fabs(x + y - two) < 1e-12);
    found[fabs(x + y - two) < 1e-12]++;
  }
  assert_true(found[0] >= 2 && found[1] >= 2);
}

/* Checks the numbers on the contour lines of x + y: one number for each line, at a point where x
 * + y has this value, and apart from each other. */
static void assert_numbers_on_lines(const char *script) {
  const char *at = strstr(script, "$n0 << END\n");
  double x[2], y[2], value[2];
  assert_non_null(at);
  at = strchr(at, '\n') + 1;
  for (int k = 0; k < 2; k++, at = strchr(at, '\n') + 1) {
    assert_int_equal(sscanf(at, "%lf %lf %lf", &x[k], &y[k], &value[k]), 3);
    assert_true(fabs(value[k] - (k + 1)) < 1e-12);
    assert_true(fabs(x[k] + y[k] - value[k]) < 1e-9);
  }
  assert_int_equal(strncmp(at, "END", 3), 0);
  assert_true(hypot((x[1] - x[0]) / 2, y[1] - y[0]) > 0.2);
}

/* Tests a field x + y on two squares: the samples are exact, and the contours and their numbers
 * are at the right positions. */
static void test_field(void **state) {
  const double x[8] = {0, 1, 1, 0, 1, 2, 2, 2}, y[8] = {0, 0, 1, 1, 0, 0, 1, 1};
  double value[8];
  for (int i = 0; i < 8; i++) value[i] = x[i] + y[i];
  arc_plot_field field = {x, y, value, 2};
  arc_plot_panel panel = arc_plot_panel_default();
  panel.field = &field;
  panel.levels = 2;
  panel.value.label = "sum";
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  char *picture, *script, path[256];
  assert_int_equal(arc_plot_draw(*state, &figure, &as_text, &picture, NULL, NULL), ARC_OK);
  assert_non_null(strstr(picture, "@  "));
  assert_non_null(strstr(picture, "2.67 to 3"));
  free(picture);
  arc_plot_output fine = as_text;
  fine.colour = fine.fine = 1;
  assert_int_equal(arc_plot_draw(*state, &figure, &fine, &picture, NULL, NULL), ARC_OK);
  assert_non_null(strchr(picture, 'O')); /* the marks of levels differ from the marks of curves */
  assert_null(strstr(picture, "\342\226\241"));
  free(picture);
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = path_of("field.gp", path)};
  assert_int_equal(arc_plot_script(&figure, &output, &script, NULL, NULL), ARC_OK);
  assert_contours_at(script, 1, 2); /* contours at the round numbers between 0 and 3 that the
                                     * colour scale shows */
  assert_non_null(strstr(script, "set cbtics 1\n"));
  assert_numbers_on_lines(script);
  free(script);
  output.file = path_of("field.png", path);
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
}

/* --- requirements on curves ------------------------------------------------------------------- */

static void assert_refused(arc_plot_panel panel, const char *words) {
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_error error = {.message = ""};
  assert_int_equal(arc_plot_check(&figure, &error), ARC_ARGUMENT);
  if (!strstr(error.message, words)) print_message("# '%s'\n", error.message);
  assert_non_null(strstr(error.message, words));
}

static void test_check(void **state) {
  (void)state;
  const double none[3] = {NAN, INFINITY, NAN}, below[3] = {-1, 0, -2};
  arc_plot_curve c = curve("it");
  arc_plot_panel panel = panel_of(&c, 1);
  assert_refused(panel_of(NULL, 0), "nothing to draw");
  c.count = 0;
  assert_refused(panel, "curve 1 ('it') has no points");
  c = (arc_plot_curve){.x = line_x, .y = none, .count = 3, .title = "it"};
  assert_refused(panel, "curve 1 ('it') has no point whose x and y");
  c.y = below;
  panel.y.log = 1;
  assert_refused(panel, "has no positive point for the logarithmic axis");
  panel.y.min = -1, panel.y.max = 1;
  assert_refused(panel, "y range must be positive");
  panel = panel_of(&c, 1);
  panel.x.min = panel.x.max = 2;
  assert_refused(panel, "ends of the x range must differ");
  panel.x.min = 5, panel.x.max = 6;
  assert_refused(panel, "no point lies in the x range 5 to 6");
  panel.x.min = NAN, panel.x.max = -1;
  assert_refused(panel, "no point lies in the x range");
  panel.x.max = INFINITY;
  assert_refused(panel, "must be finite");
}

/* Tests that NaN and infinite values interrupt the line of a curve, and on a logarithmic axis
 * also values <= 0. */
static void test_breaks(void **state) {
  (void)state;
  const double x[7] = {NAN, 1, 2, NAN, INFINITY, 3, 4}, y[7] = {1, 0, 10, 5, 5, -3, 1000};
  arc_plot_curve c = {.x = x, .y = y, .count = 7, .title = "x"};
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = "x.gp"};
  char *script;
  assert_int_equal(arc_plot_script(&figure, &output, &script, NULL, NULL), ARC_OK);
  assert_non_null(strstr(script, "END\n1 0\n2 10\n\n3 -3\n4 1000\nEND\n"));
  free(script);
  panel.y.log = 1;
  assert_int_equal(arc_plot_script(&figure, &output, &script, NULL, NULL), ARC_OK);
  assert_non_null(strstr(script, "END\n2 10\n\n4 1000\nEND\n"));
  free(script);
}

/* --- main ------------------------------------------------------------------------------------- */

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_text_picture), cmocka_unit_test(test_text_colour),
      cmocka_unit_test(test_dot_marks),    cmocka_unit_test(test_ascii),
      cmocka_unit_test(test_files),        cmocka_unit_test(test_file_whole_or_not),
      cmocka_unit_test(test_full_disk),    cmocka_unit_test(test_animation),
      cmocka_unit_test(test_panels),       cmocka_unit_test(test_field),
      cmocka_unit_test(test_check),        cmocka_unit_test(test_breaks),
  };
  return cmocka_run_group_tests_name("plot", tests, set_up, tear_down);
}

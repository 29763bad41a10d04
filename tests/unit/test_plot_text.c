/* Tests of texts in figures: quotes, marks, and texts that contain commands, which must not be
 * executed. */
#include "plot_shared.h"

static void assert_quoted(const char *text, int ascii, const char *expected) {
  char *quoted = arc_plot_quote(text, ascii);
  assert_string_equal(quoted, expected);
  free(quoted);
}

static void test_quote(void **state) {
  (void)state;
  assert_quoted("plain p_max", 0, "\"plain p_max\"");
  assert_quoted("it's `date` \"x\" \\", 0, "\"it's \\140date\\140 \\\"x\\\" \\\\\"");
  assert_quoted("a\nb\rc\033[31m\177", 0, "\"a b c [31m \"");
  assert_quoted("\302\233A", 0, "\" A\"");        /* a control character of two bytes */
  assert_quoted("\342\200\256A", 0, "\" A\"");    /* reverses the order of the following text */
  assert_quoted("\302\265m", 0, "\"\302\265m\""); /* the micro sign */
  assert_quoted("\302\265m \316\261", 1, "\"um alpha\"");
  assert_quoted("a\342\200\231\342\200\235", 1, "\"a'\\\"\""); /* ASCII quotes */
  assert_quoted("\377\302", 0, "\"??\"");                      /* not valid UTF-8 */
  assert_quoted("\300\247", 0, "\"??\"");                      /* a quote in an overlong encoding */
}

/* Tests that gnuplot reads the quoted text as one string, for random bytes in the text. */
static void test_quote_is_one_string(void **state) {
  (void)state;
  unsigned seed = 12345;
  for (int round = 0; round < 2000; round++) {
    char text[20] = "";
    for (int i = 0; i < 19; i++) {
      seed = seed * 1103515245u + 12345u;
      text[i] = (char)(1 + (seed >> 16) % 255);
    }
    char *quoted = arc_plot_quote(text, round % 2);
    size_t length = strlen(quoted);
    assert_true(length > 1 && quoted[0] == '"' && quoted[length - 1] == '"');
    for (size_t i = 1; i + 1 < length; i++) {
      assert_true((unsigned char)quoted[i] >= 0x20 && !strchr("\"`", quoted[i]));
      if (quoted[i] == '\\') i += strchr("\"\\", quoted[i + 1]) ? 1 : 3;
      assert_true(i + 1 < length);
    }
    free(quoted);
  }
}

/* Checks which parts of a label are formatted as subscripts, superscripts or plain text. */
static void assert_label(const char *label, const char *expected) {
  arc_plot_curve c = curve(NULL);
  arc_plot_panel panel = panel_of(&c, 1);
  panel.x.label = label;
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = "x.gp"};
  char *script;
  assert_int_equal(arc_plot_script(&figure, &output, &script, NULL, NULL), ARC_OK);
  char *found = strstr(script, "set xlabel ");
  assert_non_null(found);
  found[strcspn(found, "\n")] = '\0';
  assert_string_equal(found + strlen("set xlabel "), expected);
  free(script);
}

static void test_marks(void **state) {
  (void)state;
  assert_label("p / p_H", "\"p / p_{H}\" enhanced");
  assert_label("\\alpha_c in mm^2", "\"\316\261_{c} in mm^{2}\" enhanced");
  assert_label("10^-8 {x} a\\b @ & ~",
               "\"10^{-8} \\\\{x\\\\} a\\\\\\\\b \\\\@ \\\\& \\\\~\" enhanced");
  assert_label("file_name, p_max_of_all, _H, x_", "\"file_name, p_max_of_all, _H, x_\" noenhanced");
  assert_label("{/Symbol a} \\alphabet ^2", "\"{/Symbol a} \\\\alphabet ^2\" noenhanced");
  assert_label("it's p_H'", "\"it's p_{H}'\" enhanced");
}

/* Tests that quotes of every kind are shown in each kind of text of a figure. */
static void test_quotes_are_shown(void **state) {
  double at[2] = {1, 3};
  const char *words[2] = {"'low", "''high"};
  arc_plot_curve c = curve("''quoted'' \"and\" `more`");
  arc_plot_panel panel = panel_of(&c, 1);
  panel.x.label = "'p_H'";
  panel.x.places = at, panel.x.words = words, panel.x.place_count = 2;
  arc_plot_figure figure = {.title = "''tis'' not", .panels = &panel, .panel_count = 1};
  char *picture;
  assert_int_equal(arc_plot_draw(*state, &figure, &as_text, &picture, NULL, NULL), ARC_OK);
  static const char *const shown[] = {"''tis'' not", "''quoted'' \"and\" `more`", "'low", "''high",
                                      "'p_H'"};
  for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
    assert_non_null(strstr(picture, shown[i]));
  free(picture);
}

/* Tests that an error is reported although the following command resets gnuplot's error state. */
static void test_refusal_is_told(void **state) {
  static const char commands[] = "set title (\n" ARC_GNUPLOT_NOTE_FAILURE "reset\nset title 'fine'";
  arc_error error;
  assert_int_equal(arc_gnuplot_run(*state, commands, strlen(commands), NULL, NULL, &error),
                   ARC_ARGUMENT);
  assert_int_equal(arc_gnuplot_run(*state, "set title 'x'", 13, NULL, NULL, &error), ARC_OK);
}

/* Tests the dots of a diagonal line: each character cell on the line contains some dots. */
static void test_dots(void **state) {
  arc_gnuplot *session = *state;
  double x[2] = {0, 1}, y[2] = {0, 1};
  arc_plot_curve c = {.x = x, .y = y, .count = 2, .title = "line"};
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = {
      .medium = ARC_PLOT_TEXT, .width = 60, .height = 20, .colour = 1, .fine = 1};
  char *picture;
  size_t cells = 0;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, NULL), ARC_OK);
  for (char *at = picture; (at = strstr(at, "\342")) != NULL; at++)
    cells += (unsigned char)at[1] >= 0xa0 && (unsigned char)at[1] <= 0xa3;
  assert_in_range(cells, 40, 60);
  assert_non_null(strstr(picture, "line"));
  free(picture);
  output.ascii = 1;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, NULL), ARC_OK);
  assert_null(strstr(picture, "\342"));
  free(picture);
}

/* Tests titles, labels and file names that contain commands for gnuplot and the shell: no
 * command is executed. */
static void test_nothing_is_run(void **state) {
  arc_gnuplot *session = *state;
  char evil[600], path[256];
  snprintf(evil, sizeof evil,
           "`touch %s/ran` $(touch %s/ran)' \n!touch %s/ran\nsystem('touch %s/ran') \" \\", folder,
           folder, folder, folder);
  arc_plot_curve c = curve(evil);
  arc_plot_panel panel = panel_of(&c, 1);
  panel.title = panel.x.label = panel.y.label = evil;
  arc_plot_figure figure = {.title = evil, .panels = &panel, .panel_count = 1};
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = path_of("evil.png", path)};
  char *picture;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, NULL), ARC_OK);
  assert_int_equal(arc_plot_draw(session, &figure, &as_text, &picture, NULL, NULL), ARC_OK);
  assert_non_null(strstr(picture, "`touch"));
  free(picture);
  c.title = "x", c.colour = evil;
  assert_int_equal(arc_plot_draw(session, &figure, &as_text, &picture, NULL, NULL), ARC_ARGUMENT);
  c.colour = "reddish";
  assert_int_equal(arc_plot_draw(session, &figure, &as_text, &picture, NULL, NULL), ARC_ARGUMENT);
  c.colour = "red";
  assert_int_equal(arc_plot_draw(session, &figure, &as_text, &picture, NULL, NULL), ARC_OK);
  free(picture);
  assert_false(exists("ran"));
}

static void test_strange_file_names(void **state) {
  arc_gnuplot *session = *state;
  static const char *const names[] = {"|touch ran.png", "<x'y.png", "`touch ran`.png",
                                      "~a \" b.png", "-dash.svg"};
  char here[256];
  assert_non_null(getcwd(here, sizeof here));
  assert_int_equal(chdir(folder), 0);
  arc_plot_curve c = curve("x");
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = names[i]};
    char *picture;
    assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, NULL), ARC_OK);
    assert_true(exists(names[i]));
  }
  assert_int_equal(mkdir("caf\351", 0700), 0); /* Latin-1: a name need not be UTF-8 */
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = "caf\351/\351t\351.png"};
  char *picture;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, NULL), ARC_OK);
  assert_true(exists("caf\351/\351t\351.png"));
  assert_false(exists("ran") || exists("ran.png"));
  assert_int_equal(chdir(here), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_quote),
      cmocka_unit_test(test_marks),
      cmocka_unit_test(test_quotes_are_shown),
      cmocka_unit_test(test_refusal_is_told),
      cmocka_unit_test(test_dots),
      cmocka_unit_test(test_quote_is_one_string),
      cmocka_unit_test(test_nothing_is_run),
      cmocka_unit_test(test_strange_file_names),
  };
  return cmocka_run_group_tests_name("plot text", tests, set_up, tear_down);
}

/* The gnuplot session and the figures: with the real gnuplot, and with shell scripts that play a
 * missing, old, slow, silent or dying one.
 */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "archard/plot.h"

static char folder[] = "/tmp/archard-plot-XXXXXX";

static const double line_x[] = {0, 1, 2, 3, 4}, line_y[] = {0, 1, 4, 9, 16};

/* --- helpers ---------------------------------------------------------------------------------- */

static char *path_of(const char *name, char path[256]) {
  snprintf(path, 256, "%s/%s", folder, name);
  return path;
}

static int exists(const char *name) {
  char path[256];
  return access(path_of(name, path), F_OK) == 0;
}

/* The content of a file in the test's folder, in a buffer that the next call overwrites. */
static const char *content(const char *name) {
  static char text[20000];
  char path[256];
  FILE *file = fopen(path_of(name, path), "rb");
  size_t length = file ? fread(text, 1, sizeof text - 1, file) : 0;
  if (file) fclose(file);
  text[length] = '\0';
  return text;
}

/* A shell script as the program to be started. */
static char *fake(const char *name, const char *body, char path[256]) {
  FILE *file = fopen(path_of(name, path), "w");
  fprintf(file, "#!/bin/sh\n%s\n", body);
  fclose(file);
  chmod(path, 0755);
  return path;
}

static arc_gnuplot *open_session(const char *program) {
  arc_gnuplot_def def = arc_gnuplot_default();
  arc_gnuplot *session = NULL;
  def.program = program;
  def.start_timeout = 10;
  assert_int_equal(arc_gnuplot_open(&def, &session, NULL), ARC_OK);
  return session;
}

static arc_plot_curve curve(const char *title) {
  return (arc_plot_curve){.x = line_x, .y = line_y, .count = 5, .title = title};
}

static arc_plot_panel panel_of(const arc_plot_curve *curves, size_t count) {
  arc_plot_panel panel = arc_plot_panel_default();
  panel.curves = curves;
  panel.curve_count = count;
  return panel;
}

static const arc_plot_output as_text = {.medium = ARC_PLOT_TEXT, .width = 70, .height = 20};

/* Draws one curve as characters; the caller frees. */
static char *draw_text(arc_gnuplot *session, const arc_plot_curve *c, arc_error *error) {
  arc_plot_panel panel = panel_of(c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  char *picture = NULL;
  arc_plot_draw(session, &figure, &as_text, &picture, NULL, error);
  return picture;
}

static void assert_draws(arc_gnuplot *session) {
  arc_plot_curve c = curve("works");
  arc_error error = {.message = ""};
  char *picture = draw_text(session, &c, &error);
  assert_string_equal(error.message, "");
  assert_non_null(picture);
  assert_non_null(strstr(picture, "* works"));
  free(picture);
}

/* --- texts ------------------------------------------------------------------------------------ */

static void assert_quoted(const char *text, int ascii, const char *expected) {
  char *quoted = arc_plot_quote(text, ascii);
  assert_string_equal(quoted, expected);
  free(quoted);
}

static void test_quote(void **state) {
  (void)state;
  assert_quoted("plain p_max", 0, "'plain p_max'");
  assert_quoted("it's `date` \"x\" \\", 0, "'it''s `date` \"x\" \\'");
  assert_quoted("a\nb\rc\033[31m\177", 0, "'a b c [31m '");
  assert_quoted("\302\233A", 0, "' A'");        /* a control character of two bytes */
  assert_quoted("\302\265m", 0, "'\302\265m'"); /* micro */
  assert_quoted("\302\265m \316\261", 1, "'um alpha'");
  assert_quoted("\342\200\231", 1, "''''"); /* an apostrophe from ASCII's point of view */
  assert_quoted("\377\302", 0,
                "'?"
                "?'"); /* no UTF-8 */
  assert_quoted("\300\247", 0,
                "'?"
                "?'"); /* a quote in too many bytes */
}

/* Whatever bytes a text has, gnuplot must read the quoted text as one string. */
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
    assert_true(quoted[0] == '\'' && quoted[length - 1] == '\'');
    for (size_t i = 1; i + 1 < length; i++) {
      assert_true((unsigned char)quoted[i] >= 0x20);
      if (quoted[i] == '\'') assert_int_equal(quoted[++i], '\'');
      assert_true(i + 1 < length);
    }
    free(quoted);
  }
}

/* Titles, labels and file names full of what gnuplot or a shell would run. */
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
  assert_false(exists("ran") || exists("ran.png"));
  assert_int_equal(chdir(here), 0);
}

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
  assert_non_null(strstr(picture, "\033[1;32m#")); /* the second curve's colour and mark */
  for (char *line = picture; *line; line = strchr(line, '\n') + 1) { /* each line ends uncoloured */
    size_t length = strcspn(line, "\n");
    char *last = NULL;
    for (char *at = line; (at = strchr(at, '\033')) && at < line + length; at++) last = at;
    if (last) assert_memory_equal(last, "\033[0m", 4);
  }
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

/* A file of each kind begins with what that kind begins with. */
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

/* A file that cannot be written, or a picture that is not finished, leaves what there was. */
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

/* Twelve panels: every title once, one key below, frames in line. */
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

/* A field x + y on two squares: the samples are exact, and the contour is where it belongs. */
static void test_field(void **state) {
  const double x[8] = {0, 1, 1, 0, 1, 2, 2, 2}, y[8] = {0, 0, 1, 1, 0, 0, 1, 1};
  double value[8];
  for (int i = 0; i < 8; i++) value[i] = x[i] + y[i];
  arc_plot_field field = {x, y, value, 2};
  arc_plot_panel panel = arc_plot_panel_default();
  panel.field = &field;
  panel.levels = 1;
  panel.value.label = "sum";
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  char *picture, *script, path[256];
  assert_int_equal(arc_plot_draw(*state, &figure, &as_text, &picture, NULL, NULL), ARC_OK);
  assert_non_null(strstr(picture, "@  "));
  assert_non_null(strstr(picture, "2.67 to 3"));
  free(picture);
  arc_plot_output output = {.medium = ARC_PLOT_FILE, .file = path_of("field.gp", path)};
  assert_int_equal(arc_plot_script(&figure, &output, &script, NULL, NULL), ARC_OK);
  assert_non_null(strstr(script, "\n1.5 0\n1.25 0.25\n")); /* x + y = 1.5 in the triangle */
  assert_null(strstr(script, "\n1.25 0.25\n1.25 0.25\n"));
  free(script);
  output.file = path_of("field.png", path);
  assert_int_equal(arc_plot_draw(*state, &figure, &output, &picture, NULL, NULL), ARC_OK);
}

/* --- what a curve must be --------------------------------------------------------------------- */

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
  assert_refused(panel, "x range must have a width");
  panel.x.min = 5, panel.x.max = 6;
  assert_refused(panel, "no point lies in the x range 5 to 6");
  panel.x.min = NAN, panel.x.max = -1;
  assert_refused(panel, "no point lies in the x range");
  panel.x.max = INFINITY;
  assert_refused(panel, "must be finite");
}

/* NaN and infinite rows break the line; one that is not positive does so on a logarithmic axis. */
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

/* --- a gnuplot that is not well --------------------------------------------------------------- */

static void assert_start(const char *program, arc_status status, const char *words) {
  arc_gnuplot *session = open_session(program);
  arc_error error = {.message = ""};
  assert_int_equal(arc_gnuplot_start(session, &error), status);
  if (!strstr(error.message, words)) print_message("# '%s'\n", error.message);
  assert_non_null(strstr(error.message, words));
  assert_int_equal(arc_gnuplot_process(session), 0);
  arc_gnuplot_close(&session);
}

/* Plays gnuplot 4.6: answers a print of our last line with it. */
static const char old_gnuplot[] =
    "while read -r a b c; do\n"
    "  case \"$a $b\" in\n"
    "  'print GPVAL_VERSION') echo 4.6 ;;\n"
    "  'print sprintf(\\'*) n=${c%%:*}; echo \"<<archard $n:0>>\" ;;\n"
    "  \"print sprintf('<<archard\") echo \"<<archard ${c%%:*}:0>>\" ;;\n"
    "  esac\n"
    "done";

static void test_not_well(void **state) {
  (void)state;
  char path[256];
  assert_start("/nonexistent/gnuplot", ARC_MISSING, "apt-get install gnuplot-nox");
  assert_start("archard-no-such-gnuplot", ARC_MISSING, "no program 'archard-no-such-gnuplot'");
  assert_start(fake("dead", "echo libqt is missing >&2; exit 7", path), ARC_IO, "exit status 7");
  assert_start(path, ARC_IO, "libqt is missing");
  assert_start(fake("old", old_gnuplot, path), ARC_MISSING, "gnuplot 4.6");
  assert_start(path, ARC_MISSING, "5.2 or newer");
}

static void test_silent(void **state) {
  (void)state;
  char path[256];
  arc_gnuplot_def def = arc_gnuplot_default();
  arc_gnuplot *session = NULL;
  arc_error error;
  def.program = fake("silent", "exec sleep 1000", path);
  def.start_timeout = 0.3;
  assert_int_equal(arc_gnuplot_open(&def, &session, NULL), ARC_OK);
  assert_int_equal(arc_gnuplot_start(session, &error), ARC_IO);
  assert_non_null(strstr(error.message, "no answer for 0.3 s"));
  assert_int_equal(arc_gnuplot_process(session), 0);
  arc_gnuplot_close(&session);
}

/* One that needs a second to start is waited for. */
static void test_slow(void **state) {
  (void)state;
  char path[256];
  arc_gnuplot *session = open_session(fake("slow", "sleep 1; exec gnuplot \"$@\"", path));
  assert_draws(session);
  arc_gnuplot_close(&session);
}

/* Dies at the first plot that names it, then is started again as the real one. */
static void test_killed_in_mid_plot(void **state) {
  arc_gnuplot *session = *state;
  arc_error error;
  assert_draws(session);
  char command[80];
  snprintf(command, sizeof command, "system('kill -9 %ld')", arc_gnuplot_process(session));
  assert_int_equal(arc_gnuplot_run(session, command, strlen(command), NULL, NULL, &error), ARC_IO);
  assert_non_null(strstr(error.message, "in the middle of a plot (killed by signal 9"));
  assert_draws(session);
}

/* Killed while nobody looks: the next plot does not notice. */
static void test_killed_idle(void **state) {
  arc_gnuplot *session = *state;
  assert_draws(session);
  long before = arc_gnuplot_process(session);
  kill((pid_t)before, SIGKILL);
  usleep(50000);
  assert_draws(session);
  assert_int_not_equal(arc_gnuplot_process(session), before);
}

static int stop_now(void *context) {
  (void)context;
  return 1;
}

static void test_stop(void **state) {
  (void)state;
  arc_gnuplot_def def = arc_gnuplot_default();
  arc_gnuplot *session = NULL;
  char path[256];
  def.program = fake("forever", "exec sleep 1000", path);
  def.should_stop = stop_now;
  assert_int_equal(arc_gnuplot_open(&def, &session, NULL), ARC_OK);
  assert_int_equal(arc_gnuplot_start(session, NULL), ARC_STOPPED);
  arc_gnuplot_close(&session);
}

/* A Ctrl-C at the terminal goes to the foreground group: gnuplot must be in another. The signals a
 * caller ignores or blocks must not be ignored or blocked there, nor touched here. */
static void test_signals(void **state) {
  (void)state;
  struct sigaction ignore = {.sa_handler = SIG_IGN}, before, now;
  sigaction(SIGPIPE, NULL, &before);
  sigaction(SIGINT, &ignore, NULL);
  arc_gnuplot *session = open_session("gnuplot");
  assert_draws(session);
  pid_t pid = (pid_t)arc_gnuplot_process(session);
  assert_int_equal(getpgid(pid), pid);
  sigaction(SIGPIPE, NULL, &now);
  assert_true(now.sa_handler == before.sa_handler);
  sigaction(SIGINT, &(struct sigaction){.sa_handler = SIG_DFL}, NULL);
  kill(pid, SIGTERM);
  usleep(50000);
  assert_draws(session); /* SIGPIPE is at its default: writing to the dead one would end us */
  arc_gnuplot_close(&session);
}

/* More than a pipe holds in both directions at once must not lock up. */
static void test_much_both_ways(void **state) {
  arc_gnuplot *session = *state;
  enum { LINES = 20000 };
  static char commands[LINES * 64];
  size_t length = 0;
  for (int i = 0; i < LINES; i++)
    length += (size_t)snprintf(commands + length, sizeof commands - length,
                               "print '%06d ........................................'\n", i);
  char *reply;
  size_t got;
  assert_int_equal(arc_gnuplot_run(session, commands, length, &reply, &got, NULL), ARC_OK);
  assert_true(got > LINES * 40);
  assert_memory_equal(reply, "000000 ", 7);
  assert_non_null(strstr(reply, "019999 "));
  free(reply);
}

/* After an error in a command the session goes on with the same gnuplot. */
static void test_refused_command(void **state) {
  arc_gnuplot *session = *state;
  arc_error error;
  assert_draws(session);
  long before = arc_gnuplot_process(session);
  assert_int_equal(arc_gnuplot_run(session, "plot foo", 8, NULL, NULL, &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "undefined variable: foo"));
  assert_draws(session);
  assert_int_equal(arc_gnuplot_process(session), before);
}

static void test_terminals(void **state) {
  arc_gnuplot *session = *state;
  assert_draws(session);
  assert_true(arc_gnuplot_version(session) >= ARC_GNUPLOT_OLDEST);
  assert_true(arc_gnuplot_has_terminal(session, "dumb"));
  assert_false(arc_gnuplot_has_terminal(session, "dum"));
  arc_plot_curve c = curve("x");
  arc_plot_panel panel = panel_of(&c, 1);
  arc_plot_figure figure = {.panels = &panel, .panel_count = 1};
  arc_plot_output output = {.medium = ARC_PLOT_WINDOW, .terminal = "windows"};
  arc_error error;
  char *picture;
  assert_int_equal(arc_plot_draw(session, &figure, &output, &picture, NULL, &error), ARC_MISSING);
  assert_non_null(strstr(error.message, "opens no windows window"));
}

/* --- main ------------------------------------------------------------------------------------- */

static int set_up(void **state) {
  *state = open_session("gnuplot");
  return mkdtemp(folder) ? 0 : -1;
}

static int tear_down(void **state) {
  arc_gnuplot *session = *state;
  char command[80];
  arc_gnuplot_close(&session);
  snprintf(command, sizeof command, "rm -rf %s", folder);
  return system(command);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_quote),
      cmocka_unit_test(test_quote_is_one_string),
      cmocka_unit_test(test_nothing_is_run),
      cmocka_unit_test(test_strange_file_names),
      cmocka_unit_test(test_text_picture),
      cmocka_unit_test(test_text_colour),
      cmocka_unit_test(test_ascii),
      cmocka_unit_test(test_files),
      cmocka_unit_test(test_file_whole_or_not),
      cmocka_unit_test(test_animation),
      cmocka_unit_test(test_panels),
      cmocka_unit_test(test_field),
      cmocka_unit_test(test_check),
      cmocka_unit_test(test_breaks),
      cmocka_unit_test(test_not_well),
      cmocka_unit_test(test_silent),
      cmocka_unit_test(test_slow),
      cmocka_unit_test(test_killed_in_mid_plot),
      cmocka_unit_test(test_killed_idle),
      cmocka_unit_test(test_stop),
      cmocka_unit_test(test_signals),
      cmocka_unit_test(test_much_both_ways),
      cmocka_unit_test(test_refused_command),
      cmocka_unit_test(test_terminals),
  };
  return cmocka_run_group_tests_name("plot", tests, set_up, tear_down);
}

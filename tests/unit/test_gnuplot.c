/* Tests of the gnuplot session with the real gnuplot, and with shell scripts that imitate a
 * gnuplot that is missing, old, slow, silent or crashing. */
#include "plot_shared.h"

#include <signal.h>
#include <sys/wait.h>

/* --- a faulty gnuplot ------------------------------------------------------------------------- */

static void assert_start(const char *program, arc_status status, const char *words) {
  arc_gnuplot *session = open_session(program);
  arc_error error = {.message = ""};
  assert_int_equal(arc_gnuplot_start(session, &error), status);
  if (!strstr(error.message, words)) print_message("# '%s'\n", error.message);
  assert_non_null(strstr(error.message, words));
  assert_int_equal(arc_gnuplot_process(session), 0);
  arc_gnuplot_close(&session);
}

/* A script that acts like gnuplot 4.6 and executes the print command at the end of each request. */
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

/* Tests that the session waits for a gnuplot that needs a second to start. */
static void test_slow(void **state) {
  (void)state;
  char path[256];
  arc_gnuplot *session = open_session(fake("slow", "sleep 1; exec gnuplot \"$@\"", path));
  assert_draws(session);
  arc_gnuplot_close(&session);
}

/* Tests a fake gnuplot that ends at the first plot and is then replaced by the real one. */
static void test_killed_in_mid_plot(void **state) {
  arc_gnuplot *session = *state;
  arc_error error;
  assert_draws(session);
  char command[80];
  snprintf(command, sizeof command, "system('kill -9 %ld')", arc_gnuplot_process(session));
  assert_int_equal(arc_gnuplot_run(session, command, strlen(command), NULL, NULL, &error), ARC_IO);
  assert_non_null(strstr(error.message, "during a plot (killed by signal 9"));
  assert_draws(session);
}

/* Tests that the next plot starts a new gnuplot if the old one was killed between two plots. */
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

/* Tests two properties of signals. Ctrl-C is sent to the foreground process group, so gnuplot
 * must be in another group. Signals that the caller ignores or blocks must have their default
 * action in gnuplot and must not change in the caller. */
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
  assert_draws(session); /* SIGPIPE has its default action, so an unprotected write to the dead
                          * process would end this program */
  arc_gnuplot_close(&session);
}

/* Returns true if the process ends within a second. No waitpid() has been called for it. */
static int ends_soon(long pid) {
  char path[40], state = '?';
  snprintf(path, sizeof path, "/proc/%ld/stat", pid);
  for (int i = 0; i < 100; i++) {
    FILE *file = fopen(path, "r");
    if (!file) return 1;
    const int known = fscanf(file, "%*d (%*[^)]) %c", &state) == 1;
    fclose(file);
    if (known && state == 'Z') return 1;
    usleep(10000);
  }
  return 0;
}

/* Tests that gnuplot ends if the program is killed while gnuplot is busy and reads no input. */
static void test_killed_program(void **state) {
  (void)state;
  int told[2];
  long pid = 0;
  assert_int_equal(pipe(told), 0);
  pid_t program = fork();
  if (program == 0) {
    static const char busy[] = "do for [i=1:2000000000] { x = i }";
    arc_gnuplot *session = open_session("gnuplot");
    if (arc_gnuplot_start(session, NULL) != ARC_OK) _exit(1);
    pid = arc_gnuplot_process(session);
    if (write(told[1], &pid, sizeof pid) != sizeof pid) _exit(2);
    arc_gnuplot_run(session, busy, sizeof busy - 1, NULL, NULL, NULL);
    _exit(3);
  }
  close(told[1]);
  assert_int_equal(read(told[0], &pid, sizeof pid), sizeof pid);
  close(told[0]);
  usleep(100000);
  kill(program, SIGKILL);
  waitpid(program, NULL, 0);
  const int ended = ends_soon(pid);
  if (!ended) kill((pid_t)pid, SIGKILL);
  assert_true(ended);
}

/* Tests that more data than a pipe can buffer, sent in both directions at once, cause no
 * deadlock. */
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

/* Tests that the session continues with the same gnuplot process after an error in a command. */
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
  assert_non_null(strstr(error.message, "cannot open a window of type windows"));
}

/* --- main ------------------------------------------------------------------------------------- */

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_not_well),       cmocka_unit_test(test_silent),
      cmocka_unit_test(test_slow),           cmocka_unit_test(test_killed_in_mid_plot),
      cmocka_unit_test(test_killed_idle),    cmocka_unit_test(test_stop),
      cmocka_unit_test(test_signals),        cmocka_unit_test(test_killed_program),
      cmocka_unit_test(test_much_both_ways), cmocka_unit_test(test_refused_command),
      cmocka_unit_test(test_terminals),
  };
  return cmocka_run_group_tests_name("gnuplot", tests, set_up, tear_down);
}

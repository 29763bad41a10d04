/* Installs signal handlers. They request a stop by the functions of lua/base/interrupt.h. */
#include "cli/signals.h"

#include "lua/base/interrupt.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

static void say_how_to_end(void) {
  static const char text[] =
      "\nstopping as soon as the running step allows; Ctrl-\\ ends the program\n";
  ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);
  (void)written;
}

static void on_interrupt_stay(int signal_number) {
  (void)signal_number;
  int saved = errno;
  if (interrupt_request() > 0) say_how_to_end();
  errno = saved;
}

/* Handles the first Ctrl-C. SA_RESETHAND has already restored the default action, so the second
 * Ctrl-C ends the program. */
static void on_interrupt_once(int signal_number) {
  (void)signal_number;
  interrupt_request();
}

/* Installs a handler without SA_RESTART, so that a signal interrupts a waiting read and Lua's
 * hook can run. */
static void install(int signal_number, void (*handler)(int), int flags) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  sigemptyset(&action.sa_mask);
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal_number, &action, NULL);
}

void signals_install(int stay) {
  /* with SIGXFSZ ignored, write() fails at the size limit of a file */
  install(SIGXFSZ, SIG_IGN, 0);
  install(SIGINT, stay ? on_interrupt_stay : on_interrupt_once, stay ? 0 : (int)SA_RESETHAND);
}

/* --- in a sandbox ----------------------------------------------------------------------------- */

enum { GRACE = 100000, STATUS_ERROR = 1, STATUS_INTERRUPTED = 130 }; /* GRACE: grace time [us] */

/* Starts a timer. `seconds` is limited to a valid range, because a timer would never expire with
 * zero or with too large a time. */
static void set_alarm(int clock, double seconds) {
  static const double shortest = 1e-6, longest = 1e9;
  seconds = fmin(fmax(seconds, shortest), longest);
  const double whole = floor(seconds);
  const struct itimerval when = {
      .it_value = {(time_t)whole, (suseconds_t)(1e6 * (seconds - whole))}};
  setitimer(clock, &when, NULL);
}

static void say(const char *text) {
  const ssize_t written = write(STDERR_FILENO, text, strlen(text));
  (void)written;
}

static void on_grace_over(int signal_number) {
  const char *reached = interrupt_exceeded();
  (void)signal_number;
  say("archard: ");
  if (reached) say(reached);
  if (reached) say("; ");
  say("ended, because the script did not stop within the grace time\n");
  _exit(reached ? STATUS_ERROR : STATUS_INTERRUPTED);
}

static void begin_grace(void) {
  install(SIGALRM, on_grace_over, 0);
  set_alarm(ITIMER_REAL, GRACE / 1e6);
}

void signals_begin_working_grace(void) {
  install(SIGPROF, on_grace_over, 0);
  set_alarm(ITIMER_PROF, GRACE / 1e6);
}

static void on_time_over(int signal_number) {
  (void)signal_number;
  interrupt_exceed("more seconds than the sandbox allows");
  begin_grace();
}

static void on_interrupt_sandboxed(int signal_number) {
  (void)signal_number;
  interrupt_request();
  begin_grace();
}

void signals_limit(double seconds) {
  install(SIGINT, on_interrupt_sandboxed, (int)SA_RESETHAND);
  install(SIGALRM, on_time_over, 0);
  if (seconds > 0) set_alarm(ITIMER_REAL, seconds);
}

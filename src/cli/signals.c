/* The signal handler: it asks for a stop through lua/interrupt.h and does nothing else that could
 * disturb what it interrupts. */
#include "cli/signals.h"

#include "lua/base/interrupt.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
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

/* SA_RESETHAND has put the default action back: the next one kills. */
static void on_interrupt_once(int signal_number) {
  (void)signal_number;
  interrupt_request();
}

void signals_install(int stay) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  sigemptyset(&action.sa_mask);
  action.sa_handler = stay ? on_interrupt_stay : on_interrupt_once;
  /* No SA_RESTART: a read that waits must return, for the hook to be seen. */
  action.sa_flags = stay ? 0 : (int)SA_RESETHAND;
  sigaction(SIGINT, &action, NULL);
}

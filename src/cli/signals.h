/* cli/signals.h - Ctrl-C in sessions and scripts, and the clock of the sandbox. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

/* Ctrl-C requests a stop of the running computation. In a session (`stay` non-zero) the program
 * continues, and further Ctrl-C print how to end it; otherwise the second one ends it at once. */
void signals_install(int stay);

/* In a sandbox: requests a stop after `seconds` (0: never). A program that does not stop within the
 * grace time after this or Ctrl-C is ended. */
void signals_limit(double seconds);

/* From now on the program is ended after the grace time. */
void signals_begin_working_grace(void);

#endif

/* cli/signals.h - Ctrl-C in sessions and scripts, and the time limit of the sandbox. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

/* Ctrl-C requests a stop of the running computation. In a session (`stay` true) the program
 * continues, and further Ctrl-C print how to end it. Otherwise the second Ctrl-C ends the program
 * at once. */
void signals_install(int stay);

/* Requests a stop after `seconds` (0: never) in a sandbox. If the program does not stop within the
 * grace time after this request or Ctrl-C, it is ended. */
void signals_limit(double seconds);

/* Ends the program after the grace time, measured as processor time. */
void signals_begin_working_grace(void);

#endif

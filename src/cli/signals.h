/* cli/signals.h - Ctrl-C in sessions and scripts, and the time limit of the sandbox. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

/* Installs the handler of Ctrl-C, which requests a stop of the running computation. In a session
 * (`stay` true) the program continues; a further Ctrl-C prints how to end the program. In a
 * script (`stay` false) the second Ctrl-C ends the program at once. */
void signals_install(int stay);

/* Requests a stop after `seconds` (0: never) in a sandbox. If the program does not stop within
 * the grace time after this request or after Ctrl-C, it is ended by force. */
void signals_limit(double seconds);

/* Starts the grace time, measured as processor time. The program ends if it does not stop within
 * this time. */
void signals_begin_working_grace(void);

#endif

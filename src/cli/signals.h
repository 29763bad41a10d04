/* cli/signals.h - what Ctrl-C does, in a session and in a script. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

/* Ctrl-C asks the running work to stop. In a session (`stay` non-zero) the program goes on, and
 * further ones only say how to end it; otherwise the second one ends it at once. */
void signals_install(int stay);

/* In a sandbox: the clock asks for a stop after so many seconds (0: never), and what neither that
 * nor Ctrl-C stops within grace is ended: there is no session whose work could be lost. */
void signals_limit(double seconds);

/* From here on the program is ended when it has worked for longer than grace. */
void signals_begin_working_grace(void);

#endif

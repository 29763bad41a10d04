/* Questions to the terminal: what pictures it shows. */
#ifndef LUA_SYSTEM_TERM_ASK_H
#define LUA_SYSTEM_TERM_ASK_H

#include <stddef.h>

typedef struct term_answer {
  int kitty, sixel; /* it shows pictures in kitty's protocol; in sixels */
} term_answer;

/* Asks the terminal of standard input and output once, and remembers. Waits at most a second. All
 * no where the two are no terminal, we stand in the background, or a key was typed before the
 * question (then the next call asks). */
term_answer term_ask_pictures(void);

/* Keys typed while the terminal was asked, to be read before what comes next; hands each out once.
 * Returns -1 when there is none left. */
int term_ask_typed(void);

#endif

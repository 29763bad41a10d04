/* Queries the terminal for graphics support. */
#ifndef LUA_SYSTEM_TERM_ASK_H
#define LUA_SYSTEM_TERM_ASK_H

#include <stddef.h>

typedef struct term_answer {
  int kitty, sixel; /* supports kitty's graphics protocol; supports sixel */
} term_answer;

/* Queries the terminal of standard input and output once (at most one second) and caches the reply.
 * Both are 0 if there is no terminal, the process is in the background, or a key was typed before
 * the query (the next call tries again). */
term_answer term_ask_pictures(void);

/* Returns the next key typed during the query, or -1 if there are no more. Read these before
 * standard input. */
int term_ask_typed(void);

#endif

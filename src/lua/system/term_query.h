/* Queries the terminal for graphics support. */
#ifndef LUA_SYSTEM_TERM_QUERY_H
#define LUA_SYSTEM_TERM_QUERY_H

#include <stddef.h>

typedef struct term_answer {
  int kitty, sixel; /* supports kitty's graphics protocol; supports sixel */
} term_answer;

/* Queries the terminal of standard input and output once (at most one second) and caches the reply.
 * Both are 0 if there is no terminal, the process is in the background, or a key was typed before
 * the query (the next call tries again). */
term_answer term_query_graphics(void);

/* Returns the next key typed during the query, or -1 if there are no more. Read these before
 * standard input. */
int term_query_next_key(void);

#endif

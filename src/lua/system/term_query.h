/* Queries the terminal for graphics support. */
#ifndef LUA_SYSTEM_TERM_QUERY_H
#define LUA_SYSTEM_TERM_QUERY_H

#include <stddef.h>

typedef struct term_answer {
  int kitty, sixel; /* true if the terminal supports this graphics protocol */
} term_answer;

/* Queries the terminal of standard input and output (for at most one second) and stores the reply
 * for later calls. Both members are 0 if there is no terminal, if the process is in the background,
 * or if a key was typed before the query. In these cases the next call queries again. */
term_answer term_query_graphics(void);

/* Returns the next key typed during the query, or -1 if there are no more. These keys must be read
 * before standard input. */
int term_query_next_key(void);

#endif

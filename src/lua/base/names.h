/* lua/names.h - what things are called in messages: a value that came, and the known name nearest
 * to one that is not known. Lua scripts have the same as the module `archard.names`.
 */
#ifndef LUA_NAMES_H
#define LUA_NAMES_H

#include <lua.h>

/* A search for the known name that `name` means: the one of a symbol or a term of books (mu, R, Q),
 * else the nearest. */
typedef struct names_search {
  const char *name;
  const char *best; /* NULL where none is near; of those equally near the first by the alphabet */
  int limit;        /* letters that may differ */
} names_search;

names_search names_begin(const char *name);
void names_offer(names_search *search, const char *known);

/* Pushes a short description of the value at `index`: numbers and text as they are. */
const char *names_push_shown(lua_State *L, int index);

/* Pushes the text at `index`, the name of a field, with a zero byte as \0. */
const char *names_push_text(lua_State *L, int index);

#endif

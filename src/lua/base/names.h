/* lua/names.h - shows values in messages and finds the nearest known name. Lua scripts use it as
 * the module `archard.names`. */
#ifndef LUA_NAMES_H
#define LUA_NAMES_H

#include <lua.h>

/* A search for the known name nearest to `name`. Symbols and terms of textbooks (mu, R, Q) have
 * fixed meanings. */
typedef struct names_search {
  const char *name;
  const char *best; /* NULL if none is near; of equally near names the first in the alphabet */
  int limit;        /* greatest number of letters that may differ */
} names_search;

names_search names_begin(const char *name);
void names_offer(names_search *search, const char *known);

/* Pushes a short description of the value at `index`; numbers and texts are shown by value. */
const char *names_push_shown(lua_State *L, int index);

/* Pushes the text at `index`, e.g. the name of a field, with zero bytes shown as \0. */
const char *names_push_text(lua_State *L, int index);

#endif

/* lua/base/names.h - shows values in messages and searches for the most similar valid name. Lua
 * scripts use this file as the module `archard.names`. */
#ifndef LUA_NAMES_H
#define LUA_NAMES_H

#include <lua.h>

/* A search for the valid name that is most similar to `name`. Common symbols and terms of textbooks
 * (mu, R, Q) are replaced by the valid name of the quantity. */
typedef struct names_search {
  const char *name;
  const char *best; /* most similar name so far, alphabetically first if equal; NULL: none */
  int limit;        /* largest allowed number of different letters */
} names_search;

names_search names_begin(const char *name);
void names_offer(names_search *search, const char *known);
/* Returns how the best name is related to the searched one if their values differ, such as ", half
 * of the diameter", else "". `best` must not be NULL. */
const char *names_relation(const names_search *search);

/* Pushes a short description of the value at `index`. Numbers and texts are shown by value. */
const char *names_push_shown(lua_State *L, int index);

/* Pushes the text at `index`, such as the name of a field, with zero bytes shown as \0. */
const char *names_push_text(lua_State *L, int index);

#endif

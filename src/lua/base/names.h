/* lua/base/names.h - formats values for messages and searches for the most similar valid name. Lua
 * scripts use this file as the module `archard.names`. */
#ifndef LUA_NAMES_H
#define LUA_NAMES_H

#include <lua.h>

/* A search for the valid name that is most similar to `name`. Common symbols and terms of textbooks
 * (mu, R, Q) are replaced by the valid name of the quantity. */
typedef struct names_search {
  const char *name;
  const char *best; /* most similar name so far; of equally similar names, the first in the
                       alphabet; NULL: none */
  int limit;        /* largest edit distance that is still similar; -1 after an exact match */
} names_search;

/* names_begin begins a search; a name of one letter must match exactly. names_offer compares the
 * name with the valid name `known`. names_relation must be called only if `best` is not NULL. If
 * `best` is another quantity than the searched name, it returns a text such as ", half of the
 * diameter", otherwise "". */
names_search names_begin(const char *name);
void names_offer(names_search *search, const char *known);
const char *names_relation(const names_search *search);

/* Pushes and returns a short description of the value at `index`. Numbers, texts and booleans are
 * shown by value, other values by type. */
const char *names_push_shown(lua_State *L, int index);

/* Pushes and returns the text at `index`, such as the name of a field, with zero bytes written as
 * \0. */
const char *names_push_text(lua_State *L, int index);

#endif

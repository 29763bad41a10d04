/* lua/base/array_read.h - reads lists of numbers from Lua tables (indices from 1) into C arrays
 * (from 0). */
#ifndef LUA_ARRAY_READ_H
#define LUA_ARRAY_READ_H

#include "lua/base/args.h"
#include "lua/base/array.h"

/* Returns the number of items in the list on top of the stack; metamethods are not called. Raises
 * an error if the list has more than `most` items. Every list from a script must be checked by this
 * function. */
size_t array_length(lua_State *L, args_location location, const char *name, size_t most);

enum { ARRAY_MOST = 100000000 }; /* largest allowed length of a list */

/* Reads the list of finite numbers on top of the stack into a buffer, which is pushed above the
 * list. Errors name the field and the index. */
double *array_read(lua_State *L, args_location location, const char *name, size_t *count);

/* Reads a list as array_read does, but accepts NaN and infinity. */
double *array_read_any(lua_State *L, args_location location, const char *name, size_t *count);

#endif

/* lua/array_read.h - reads lists of numbers from Lua tables (indices from 1) into C arrays (from
 * 0). */
#ifndef LUA_ARRAY_READ_H
#define LUA_ARRAY_READ_H

#include "lua/base/args.h"
#include "lua/base/array.h"

/* Number of items in the list on top of the stack, without metamethods. Raises an error if there
 * are more than `most`. Every size that comes from a script is checked here. */
size_t array_length(lua_State *L, args_location location, const char *name, size_t most);

enum { ARRAY_MOST = 100000000 }; /* greatest length of a list */

/* Reads the table on top of the stack, a list of finite numbers, into a buffer that is pushed above
 * the table. Errors name the field and the index. */
double *array_read(lua_State *L, args_location location, const char *name, size_t *count);

/* As array_read, but accepts NaN and infinity. */
double *array_read_any(lua_State *L, args_location location, const char *name, size_t *count);

#endif

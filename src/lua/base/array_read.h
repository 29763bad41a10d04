/* lua/array_read.h - lists of numbers that users give, from Lua tables (from 1) to C (from 0). */
#ifndef LUA_ARRAY_READ_H
#define LUA_ARRAY_READ_H

#include "lua/base/args.h"
#include "lua/base/array.h"

/* The number of items in the list on top of the stack, as it stands: metamethods are not asked. A
 * list of more than `most` is refused. All sizes that scripts give come from here. */
size_t array_length(lua_State *L, args_place place, const char *name, size_t most);

enum { ARRAY_MOST = 100000000 }; /* numbers in a list */

/* Reads the table on top of the stack, a list of finite numbers, into a buffer pushed on the stack
 * (the table stays below). Errors name the field and the position. */
double *array_read(lua_State *L, args_place place, const char *name, size_t *count);

/* The same of any numbers, NaN and infinite ones too: values that are kept or written as they are.
 */
double *array_read_any(lua_State *L, args_place place, const char *name, size_t *count);

#endif

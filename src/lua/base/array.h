/* lua/base/array.h - arrays of doubles as Lua tables (indices from 1). */
#ifndef LUA_ARRAY_H
#define LUA_ARRAY_H

#include <lua.h>
#include <stddef.h>

/* Pushes a table of `count` numbers. */
void array_push(lua_State *L, const double *values, size_t count);

/* Sets field `name` of the table on top of the stack to a table of `count` numbers. */
void array_set(lua_State *L, const char *name, const double *values, size_t count);

/* Sets field `name` of the table on top of the stack to one number. */
void array_set_number(lua_State *L, const char *name, double value);

/* Pushes a userdata with `count` uninitialised doubles and returns its address. The garbage
 * collector frees the userdata. */
double *array_buffer(lua_State *L, size_t count);

#endif

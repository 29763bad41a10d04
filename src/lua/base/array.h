/* lua/array.h - arrays of numbers as Lua tables (from 1). */
#ifndef LUA_ARRAY_H
#define LUA_ARRAY_H

#include <lua.h>
#include <stddef.h>

/* Pushes a table of `count` numbers. */
void array_push(lua_State *L, const double *values, size_t count);

/* array_push as field `name` of the table on top of the stack. */
void array_set(lua_State *L, const char *name, const double *values, size_t count);

/* Sets field `name` of the table on top of the stack to one number. */
void array_set_number(lua_State *L, const char *name, double value);

/* Pushes a userdata that the collector frees, and returns its room for `count` doubles. */
double *array_buffer(lua_State *L, size_t count);

#endif

/* Converts arrays of doubles to Lua tables. */
#include "lua/base/array.h"
#include "lua/base/strict.h"

#include <lauxlib.h>

void array_push(lua_State *L, const double *values, size_t count) {
  lua_createtable(L, (int)count, 0);
  for (size_t i = 0; i < count; i++) {
    lua_pushnumber(L, values[i]);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
  strict_table(L, "list of numbers");
}

void array_set(lua_State *L, const char *name, const double *values, size_t count) {
  array_push(L, values, count);
  lua_setfield(L, -2, name);
}

void array_set_number(lua_State *L, const char *name, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

double *array_buffer(lua_State *L, size_t count) {
  return lua_newuserdatauv(L, (count ? count : 1) * sizeof(double), 0);
}

/* Reads Lua tables of numbers into arrays of doubles. */
#include "lua/base/array_read.h"
#include "lua/base/error.h"

#include <lauxlib.h>
#include <math.h>

/* A test for each item of a list, and the description of a valid item for the error message. */
typedef struct kind {
  int (*fits)(double value);
  const char *expected;
} kind;

static int is_finite(double value) {
  return isfinite(value);
}

static int is_any(double value) {
  (void)value;
  return 1;
}

size_t array_length(lua_State *L, args_location location, const char *name, size_t most) {
  const size_t length = lua_rawlen(L, -1);
  if (length <= most) return length;
  error_raise(L, ARC_ARGUMENT, location.where, "field '%s%s': expected at most %I items, got %I",
              location.prefix, name, (LUAI_UACINT)most, (LUAI_UACINT)length);
}

static double *read_kind(lua_State *L, args_location location, const char *name, size_t *count,
                         kind wanted) {
  if (!lua_istable(L, -1)) args_refuse(L, location, name, "an array of numbers");
  int table = lua_gettop(L);
  *count = array_length(L, location, name, ARRAY_MOST);
  double *values = array_buffer(L, *count);
  for (size_t i = 0; i < *count; i++) {
    lua_rawgeti(L, table, (lua_Integer)i + 1);
    values[i] = lua_tonumber(L, -1);
    if (lua_type(L, -1) != LUA_TNUMBER || !wanted.fits(values[i])) {
      const char *element = lua_pushfstring(L, "%s[%d]", name, (int)i + 1);
      lua_insert(L, -2);
      args_refuse(L, location, element, wanted.expected);
    }
    lua_pop(L, 1);
  }
  return values;
}

double *array_read(lua_State *L, args_location location, const char *name, size_t *count) {
  return read_kind(L, location, name, count, (kind){is_finite, "a finite number"});
}

double *array_read_any(lua_State *L, args_location location, const char *name, size_t *count) {
  return read_kind(L, location, name, count, (kind){is_any, "a number"});
}

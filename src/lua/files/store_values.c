/* Converts named values between Lua tables and run files. */
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/files/store_module.h"

#include <string.h>

/* --- writing named values --------------------------------------------------------------------- */

/* Reads the value on top of the stack. If the value is an array, its numbers stay on the stack
 * below the value. */
static arc_value read_value(lua_State *L, const char *name, const char *where) {
  arc_value value = {.kind = ARC_VALUE_NUMBER, .name = name};
  switch (lua_type(L, -1)) {
  case LUA_TNUMBER:
    value.number = lua_tonumber(L, -1);
    break;
  case LUA_TSTRING:
    value.kind = ARC_VALUE_TEXT;
    value.text = lua_tostring(L, -1);
    break;
  case LUA_TBOOLEAN:
    value.kind = ARC_VALUE_FLAG;
    value.number = lua_toboolean(L, -1);
    break;
  case LUA_TTABLE:
    value.kind = ARC_VALUE_ARRAY;
    value.array = array_read_any(L, (args_location){where, ""}, name, &value.count);
    lua_insert(L, -2);
    break;
  default:
    args_refuse(L, (args_location){where, ""}, name,
                "a number, a text, a boolean or an array of numbers");
  }
  return value;
}

static size_t count_fields(lua_State *L, int index) {
  size_t count = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) count++;
  return count;
}

void store_write_values(lua_State *L, arc_store *store, int id, arc_value_use use, int index,
                        const char *where) {
  arc_error error = {0};
  args_push_copy(L, index); /* a copy, which scripts cannot change after counting */
  index = lua_gettop(L);
  size_t capacity = count_fields(L, index), count = 0;
  arc_value *values = lua_newuserdatauv(L, (capacity + 1) * sizeof *values, 0);
  lua_newtable(L); /* table that keeps arrays alive */
  int anchors = lua_gettop(L);
  luaL_checkstack(L, 10, where);
  for (lua_pushnil(L); lua_next(L, index);) {
    if (lua_type(L, -2) != LUA_TSTRING)
      error_raise(L, ARC_ARGUMENT, where, "values are given by name; found [%s]",
                  luaL_tolstring(L, -2, NULL));
    values[count] = read_value(L, lua_tostring(L, -2), where);
    lua_pop(L, 1);
    if (values[count].kind == ARC_VALUE_ARRAY) lua_rawseti(L, anchors, (lua_Integer)count + 1);
    count++;
  }
  arc_status status = arc_store_set_values(store, id, use, values, count, &error);
  error_check(L, status, &error, where, -1);
  lua_settop(L, index - 1);
}

/* --- reading named values --------------------------------------------------------------------- */

static void push_value(lua_State *L, const arc_value *value) {
  switch (value->kind) {
  case ARC_VALUE_NUMBER:
    lua_pushnumber(L, value->number);
    break;
  case ARC_VALUE_FLAG:
    lua_pushboolean(L, value->number != 0);
    break;
  case ARC_VALUE_TEXT:
    lua_pushstring(L, value->text);
    break;
  case ARC_VALUE_ARRAY:
    array_push(L, value->array, value->count);
    break;
  }
}

/* Adds a value to a table. Lua arguments: the table, the address of the value. */
static int add_value(lua_State *L) {
  const arc_value *const *value = lua_touserdata(L, 2);
  push_value(L, *value);
  lua_setfield(L, 1, (*value)->name);
  return 0;
}

/* Adds a value to the table on top of the stack. The call is protected, because a Lua error must
 * not jump out of arc_store_values. */
static int see(void *context, const arc_value *value) {
  lua_State *L = context;
  lua_pushcfunction(L, add_value);
  lua_pushvalue(L, -2);
  lua_pushlightuserdata(L, &value);
  if (lua_pcall(L, 2, 0, 0) == LUA_OK) return 0;
  return 1; /* ends the loop; the error value is on top of the stack */
}

void store_push_values(lua_State *L, arc_store *store, int id, arc_value_use use,
                       const char *where) {
  arc_error error = {0};
  luaL_checkstack(L, 10, where);
  lua_newtable(L);
  int table = lua_gettop(L);
  arc_status status = arc_store_values(store, id, use, see, L, &error);
  if (lua_gettop(L) > table) lua_error(L);
  error_check(L, status, &error, where, -1);
}

/* Functions with which fuzz targets call Lua functions. A Lua function that fails must raise an
 * error object of archard. */
#ifndef TESTS_FUZZ_IN_LUA_H
#define TESTS_FUZZ_IN_LUA_H

#include "fuzz.h"

#include <lauxlib.h>
#include <lualib.h>

#include "lua/base/archard.h"

/* Lua text that defines `read(with)`, which returns a function (path, text). This function calls
 * with(path), ignores errors of archard and raises all other errors again. */
#define IN_LUA_READ                                                                                \
  "local function read(with) return function(path, text)\n"                                        \
  "  local fine, why = pcall(with, path)\n"                                                        \
  "  if not fine and not (type(why) == 'table' and why.code) then error(why, 0) end\n"             \
  "end end\n"

/* Returns a Lua state whose stack contains the list of functions that the script returns. */
static lua_State *in_lua_state(const char *script) {
  static lua_State *L;
  if (L) return L;
  L = luaL_newstate();
  luaL_openlibs(L);
  luaopen_archard(L);
  if (luaL_dostring(L, script) != LUA_OK) FOUND("%s", lua_tostring(L, -1));
  return L;
}

/* Calls one of `count` functions, selected by the first byte of the input. The arguments are the
 * path of a file that contains the other bytes, and these bytes. */
static void in_lua_call(lua_State *L, int count, const uint8_t *data, size_t size,
                        const char *ending) {
  if (size == 0 || size > 20000) return;
  const char *path = as_file(data + 1, size - 1, ending);
  const int top = lua_gettop(L);
  lua_rawgeti(L, top, 1 + data[0] % count);
  lua_pushstring(L, path);
  lua_pushlstring(L, (const char *)data + 1, size - 1);
  if (lua_pcall(L, 2, 0, 0) != LUA_OK) FOUND("%s", luaL_tolstring(L, -1, NULL));
  lua_settop(L, top);
}

#endif

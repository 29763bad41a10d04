/* Calls of Lua functions by fuzz targets: failures must be reported by archard's errors. */
#ifndef TESTS_FUZZ_IN_LUA_H
#define TESTS_FUZZ_IN_LUA_H

#include "fuzz.h"

#include <lauxlib.h>
#include <lualib.h>

#include "lua/base/archard.h"

/* Defines `read(with)`: a function of a path and its text that calls `with` on the path and raises
 * errors again unless they are errors of archard. */
#define IN_LUA_READ                                                                                \
  "local function read(with) return function(path, text)\n"                                        \
  "  local fine, why = pcall(with, path)\n"                                                        \
  "  if not fine and not (type(why) == 'table' and why.code) then error(why, 0) end\n"             \
  "end end\n"

/* Returns a Lua state with the list of functions that the script returns on its stack. */
static lua_State *in_lua_state(const char *script) {
  static lua_State *L;
  if (L) return L;
  L = luaL_newstate();
  luaL_openlibs(L);
  luaopen_archard(L);
  if (luaL_dostring(L, script) != LUA_OK) FOUND("%s", lua_tostring(L, -1));
  return L;
}

/* Calls one of `count` functions, selected by the first byte, with the path of a file that contains
 * the other bytes, and with these bytes. */
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

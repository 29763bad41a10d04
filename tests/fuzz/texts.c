/* Fuzz target for texts: tables and profiles in CSV files, chunks at the prompt and their
 * completion. Failures must be reported by archard's errors; chunks and completion never fail. */
#include "fuzz.h"

#include <lauxlib.h>
#include <lualib.h>

#include "lua/base/archard.h"

static const char script[] =
    "local csv, complete, prompt = require'archard.lib.csv', require'archard.session.complete',\n"
    "  require'archard.lib.prompt'\n"
    "local profile = require'archard.profile'\n"
    "local function read(with) return function(path, text)\n"
    "  local fine, why = pcall(with, path)\n"
    "  if not fine and not (type(why) == 'table' and why.code) then error(why, 0) end\n"
    "end end\n"
    "return { read(csv.read), read(function(path) return profile.read(path, { level = 'line' }) "
    "end),\n"
    "  function(_, text) complete.words(text) end,\n"
    "  function(_, text) prompt.compile(text, '=fuzz', 1) end }\n";

static lua_State *shared_state(void) {
  static lua_State *L;
  if (L) return L;
  L = luaL_newstate();
  luaL_openlibs(L);
  luaopen_archard(L);
  if (luaL_dostring(L, script) != LUA_OK) FOUND("%s", lua_tostring(L, -1));
  return L;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  lua_State *L = shared_state();
  if (size == 0 || size > 20000) return 0;
  const char *path = as_file(data + 1, size - 1, ".csv");
  const int top = lua_gettop(L);
  lua_rawgeti(L, top, 1 + data[0] % 4);
  lua_pushstring(L, path);
  lua_pushlstring(L, (const char *)data + 1, size - 1);
  if (lua_pcall(L, 2, 0, 0) != LUA_OK) FOUND("%s", luaL_tolstring(L, -1, NULL));
  lua_settop(L, top);
  return 0;
}

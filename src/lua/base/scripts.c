/* The Lua files inside the binary as modules "archard.NAME". Leans on the generated table of
 * lua/embedded.h. */
#include "lua/base/scripts.h"

#include "lua/base/embedded.h"

#include <lauxlib.h>
#include <string.h>

static void load_entry(lua_State *L, const embedded_script *script) {
  lua_pushfstring(L, "@%s", script->path);
  int status = luaL_loadbuffer(L, script->text, strlen(script->text), lua_tostring(L, -1));
  lua_remove(L, -2);
  if (status != LUA_OK) lua_error(L);
}

/* Called by require with the module's name; the script sees that name as its argument. */
static int open_script(lua_State *L) {
  load_entry(L, lua_touserdata(L, lua_upvalueindex(1)));
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  return 1;
}

void script_preload(lua_State *L) {
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_PRELOAD_TABLE);
  for (const embedded_script *script = embedded_scripts; script->name; script++) {
    lua_pushfstring(L, "archard.%s", script->name);
    lua_pushlightuserdata(L, (void *)script);
    lua_pushcclosure(L, open_script, 1);
    lua_settable(L, -3);
  }
  lua_pop(L, 1);
}

/* lua/scripts.h - finds the Lua files that live inside the binary. */
#ifndef LUA_SCRIPTS_H
#define LUA_SCRIPTS_H

#include <lua.h>

/* Makes every script a module: require "archard.plot.draw" runs scripts/plot/draw.lua once, and
 * require "archard.plot" scripts/plot/init.lua. */
void script_preload(lua_State *L);

#endif

/* lua/scripts.h - finds the Lua files that live inside the binary. */
#ifndef LUA_SCRIPTS_H
#define LUA_SCRIPTS_H

#include <lua.h>

/* Pushes the compiled chunk of scripts/NAME.lua without running it. Raises a Lua error where there
 * is no such script or it does not compile. */
void script_load(lua_State *L, const char *name);

/* Makes every script a module: require "archard.NAME" runs scripts/NAME.lua once. */
void script_preload(lua_State *L);

#endif

/* lua/base/scripts.h - loads the Lua scripts embedded in the binary and the modules in C.
 *
 * Built-in scripts have separate globals: copies of Lua's libraries and of the classes, made at the
 * start. If the user redefines require, string.gsub, package.loaded or wear, built-in scripts are
 * not affected. Their pairs, ipairs and getmetatable ignore metamethods. */
#ifndef LUA_SCRIPTS_H
#define LUA_SCRIPTS_H

#include <lauxlib.h>
#include <lua.h>

/* Registers all scripts and all `modules` (a list that ends with NULL) as Lua modules. require
 * "archard.plot.draw" runs scripts/plot/draw.lua once, require "archard.plot" runs
 * scripts/plot/init.lua. Lua's libraries must be open. */
void script_preload(lua_State *L, const luaL_Reg *modules);

/* Pushes the value that a built-in module returns. Raises the errors of the module's script. */
void script_require(lua_State *L, const char *name);

/* Calls the function that a module returns, with the arguments on top of the stack. Returns the
 * status of lua_pcall. If the module or the function fails, the error value is on top of the
 * stack. */
int script_pcall(lua_State *L, const char *name, int arguments, int results);

/* Pops a value and registers it as module `name` for built-in scripts. */
void script_set_module(lua_State *L, const char *name);

/* Pops a value and sets it as global `name` of the built-in scripts. */
void script_set_global(lua_State *L, const char *name);

#endif

/* lua/scripts.h - the Lua files that live inside the binary, and the modules in C beside them.
 *
 * Scripts see globals of their own: copies of Lua's libraries and of our classes as they were at
 * the start. Whatever the user makes of require, string.gsub, package.loaded or wear changes what
 * the user's text does, and nothing of what the program itself needs. Their pairs, ipairs and
 * getmetatable go by what a table is, not by what its metatable says. */
#ifndef LUA_SCRIPTS_H
#define LUA_SCRIPTS_H

#include <lauxlib.h>
#include <lua.h>

/* Makes every script, and every one of `modules` (ends with NULL), a module: require
 * "archard.plot.draw" runs scripts/plot/draw.lua once, and require "archard.plot"
 * scripts/plot/init.lua. Lua's libraries must be open. */
void script_preload(lua_State *L, const luaL_Reg *modules);

/* Pushes the value of a module as the program itself has it. Raises what its text raises. */
void script_require(lua_State *L, const char *name);

/* Calls the function that a module returns with the arguments on top. As lua_pcall: where it fails,
 * or the module does, the error stands there and the status says so. */
int script_pcall(lua_State *L, const char *name, int arguments, int results);

/* Pops a value, which is the module `name` for scripts. */
void script_set_module(lua_State *L, const char *name);

/* Pops a value, which is the global `name` of scripts. */
void script_set_global(lua_State *L, const char *name);

#endif

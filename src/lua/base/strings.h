/* lua/base/strings.h - protects the metatable of strings.
 *
 * Built-in scripts call string methods. Therefore Lua's own methods, as in ("x"):gsub, cannot be
 * changed through `string` or the metatable. Methods and operators that the user adds work as
 * usual. */
#ifndef LUA_STRINGS_H
#define LUA_STRINGS_H

#include <lua.h>

/* Installs the protection. Must be called once, after Lua's libraries are open and the globals of
 * scripts exist. */
void strings_keep(lua_State *L);

#endif

/* lua/strings.h - the metatable of strings.
 *
 * The program's scripts call methods of strings everywhere. So the methods that Lua has stay what
 * they are, ("x"):gsub, whatever the user makes of `string` or of the metatable; what the user adds
 * to either works as ever, and so do operators.
 */
#ifndef LUA_STRINGS_H
#define LUA_STRINGS_H

#include <lua.h>

/* Once, after Lua's libraries and the globals of scripts. */
void strings_keep(lua_State *L);

#endif

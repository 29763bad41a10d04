/* lua/base/settings.h - pushes the values of a definition as Lua values. */
#ifndef LUA_SETTINGS_H
#define LUA_SETTINGS_H

#include "archard/setting.h"

#include <lua.h>

/* Pushes the value of one setting: a number, a text, a boolean, "auto", { distance=, value= } or
 * the table of a group. Pushes nil if the setting has no value. */
void settings_push(lua_State *L, const arc_setting *setting, const void *definition);

/* Sets all values of the list as fields of the table on top of the stack. */
void settings_set(lua_State *L, const arc_setting *list, const void *definition);

#endif

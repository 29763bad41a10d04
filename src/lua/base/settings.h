/* lua/settings.h - the values of a definition, and what is known of its settings. */
#ifndef LUA_SETTINGS_H
#define LUA_SETTINGS_H

#include "archard/setting.h"

#include <lua.h>

/* Pushes the value of a member as scripts see it: a number, a name, "auto", { distance=, value= }
 * or a table of a group's values. */
void settings_push(lua_State *L, const arc_setting *setting, const void *definition);

/* Sets the values of a whole list as fields of the table on top of the stack. */
void settings_set(lua_State *L, const arc_setting *list, const void *definition);

#endif

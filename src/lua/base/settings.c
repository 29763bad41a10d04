/* Converts the settings of a definition to Lua values. */
#include "lua/base/settings.h"
#include "lua/base/array.h"
#include "lua/base/strict.h"

#include <lauxlib.h>

static void push_series(lua_State *L, arc_series series) {
  lua_createtable(L, 0, 2);
  array_set(L, "distance", series.distance, (size_t)series.count);
  array_set(L, "value", series.value, (size_t)series.count);
}

void settings_set(lua_State *L, const arc_setting *list, const void *definition) {
  for (const arc_setting *s = list; s->name; s++) {
    settings_push(L, s, definition);
    if (s->kind == ARC_GROUP) strict_table(L, s->name);
    lua_setfield(L, -2, s->name);
  }
}

void settings_push(lua_State *L, const arc_setting *s, const void *definition) {
  const void *member = arc_setting_value(s, definition);
  const arc_series series = arc_setting_series(s, definition);
  if (arc_setting_is_auto(s, definition))
    lua_pushliteral(L, "auto");
  else if (series.count > 0)
    push_series(L, series);
  else if (s->kind == ARC_NUMBER)
    lua_pushnumber(L, *(const double *)member);
  else if (s->kind == ARC_WHOLE)
    lua_pushinteger(L, *(const int *)member);
  else if (s->choices == arc_switch_names)
    lua_pushboolean(L, *(const int *)member);
  else if (s->kind == ARC_CHOICE)
    lua_pushstring(L, s->choices[*(const int *)member]);
  else if (s->kind == ARC_TEXT && *(const char *)member)
    lua_pushstring(L, member);
  else if (s->kind == ARC_GROUP)
    lua_newtable(L), settings_set(L, s->group, member);
  else
    lua_pushnil(L);
}

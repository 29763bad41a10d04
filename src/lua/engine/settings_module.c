/* Module `archard.settings`: lists of all settings of definitions and of the columns of the
 * history, for help, the manual, completion and studies. */
#include "lua/base/array.h"
#include "lua/base/archard.h"
#include "lua/engine/classes.h"

#include <math.h>

static const struct {
  const char *name;
  const arc_setting *list;
} definitions[] = {
    {"material", arc_material_settings}, {"hertz", arc_hertz_settings},
    {"model", arc_model_settings},       {"contact", arc_contact_settings},
    {"wear", arc_wear_settings},         {"contact.move", arc_motion_settings},
    {"body", arc_body_settings},
};

enum { DEFINITIONS = sizeof definitions / sizeof *definitions };

static void set_text(lua_State *L, const char *name, const char *text) {
  lua_pushstring(L, text);
  lua_setfield(L, -2, name);
}

/* Sets field `name` to the lower or upper bound of a range. An infinite bound is omitted. */
static void set_bound(lua_State *L, const char *name, double value) {
  if (!isfinite(value)) return;
  array_set_number(L, name, value);
}

static void set_flag(lua_State *L, const char *name, int flag) {
  lua_pushboolean(L, flag);
  lua_setfield(L, -2, name);
}

/* Returns true if the setting is a choice between strings, not between true and false. */
static int is_choice(const arc_setting *s) {
  return s->kind == ARC_CHOICE && s->choices != arc_switch_names;
}

/* Sets the field `values` to the list of the valid strings, which completion suggests. An empty
 * list is omitted. */
static void set_values(lua_State *L, const arc_setting *s) {
  lua_newtable(L);
  int count = 0;
  const char *const *words = is_choice(s) ? s->choices : NULL;
  for (int i = 0; words && words[i]; i++) {
    lua_pushstring(L, words[i]);
    lua_rawseti(L, -2, ++count);
  }
  if (s->forms & ARC_AUTOMATIC) {
    lua_pushliteral(L, "auto");
    lua_rawseti(L, -2, ++count);
  }
  if (count > 0)
    lua_setfield(L, -2, "values");
  else
    lua_pop(L, 1);
}

/* Sets the field `type` to a description of the valid values. The description has no unit, because
 * the unit is a separate field. */
static void set_type(lua_State *L, const arc_setting *s) {
  arc_setting bare = *s;
  char text[240];
  bare.unit = "";
  set_text(L, "type", arc_setting_expected(&bare, text, sizeof text));
}

/* Pushes the table that describes one setting. `path` is the name of the setting after the names of
 * its groups, such as "mesh.size". */
static void push_setting(lua_State *L, const char *path, const arc_setting *s) {
  lua_newtable(L);
  set_text(L, "path", path);
  set_text(L, "name", s->name);
  set_text(L, "text", s->text);
  set_text(L, "class", s->class_name);
  set_type(L, s);
  set_values(L, s);
  if (s->unit && s->unit[0]) set_text(L, "unit", s->unit);
  if (arc_setting_usual(s)[0]) set_text(L, "default", arc_setting_usual(s));
  if (s->kind == ARC_NUMBER) {
    set_bound(L, "low", s->low);
    set_bound(L, "high", s->high);
  }
  set_flag(L, "plain", s->kind != ARC_OTHER);
  set_flag(L, "choice", is_choice(s));
  set_flag(L, "group", s->kind == ARC_GROUP);
  set_flag(L, "series", (s->forms & ARC_SERIES) != 0);
  set_flag(L, "optional", (s->forms & ARC_OPTIONAL) != 0);
  set_flag(L, "fixed", (s->forms & ARC_FIXED) != 0);
}

/* Appends the settings of a list to the table on top of the stack. Each group is followed by its
 * settings, unless the group has its own class, whose list contains them. */
static void add_list(lua_State *L, const char *prefix, const arc_setting *list) {
  luaL_checkstack(L, 8, "settings");
  for (const arc_setting *s = list; s->name; s++) {
    const char *path = lua_pushfstring(L, "%s%s", prefix, s->name);
    push_setting(L, path, s);
    lua_rawseti(L, -3, (lua_Integer)lua_rawlen(L, -3) + 1);
    lua_pop(L, 1);
    if (s->kind != ARC_GROUP || s->class_name) continue;
    const char *inside = lua_pushfstring(L, "%s%s.", prefix, s->name);
    lua_insert(L, -2);
    add_list(L, inside, s->group);
    lua_remove(L, -2);
  }
}

/* Pushes a table with one list of settings for each definition. */
static void push_definitions(lua_State *L) {
  lua_newtable(L);
  for (int i = 0; i < DEFINITIONS; i++) {
    lua_newtable(L);
    add_list(L, "", definitions[i].list);
    lua_setfield(L, -2, definitions[i].name);
  }
}

static void add_column(lua_State *L, const char *name, const char *unit, const char *text) {
  lua_newtable(L);
  set_text(L, "name", name);
  set_text(L, "unit", unit);
  set_text(L, "text", text);
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
}

/* Pushes { material=, hertz=, model=, contact=, wear=, ["contact.move"]=, body=, columns= }. Each
 * field is a list of settings, except `columns`, which is the list of the columns of the history.
 */
int luaopen_archard_settings(lua_State *L) {
  push_definitions(L);
  lua_newtable(L);
#define ADD_COLUMN(name, unit, range, rule, text) add_column(L, #name, unit, text);
  ARC_WEAR_COLUMNS(ADD_COLUMN)
  lua_setfield(L, -2, "columns");
  return 1;
}

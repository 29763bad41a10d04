/* Reads tables of named fields into structs and checks the values. */
#include "lua/base/args.h"
#include "lua/base/box.h"
#include "lua/base/error.h"
#include "lua/base/names.h"

#include <lauxlib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- messages --------------------------------------------------------------------------------- */

const char *args_show_number(lua_State *L, double value) {
  char text[40];
  snprintf(text, sizeof text, "%.14g", value);
  return lua_pushstring(L, text);
}

/* Raises an error for the invalid value on top of the stack. `near` is a similar valid string that
 * the message suggests, or NULL. */
static void refuse_field(lua_State *L, args_location location, const char *name,
                         const char *expected, const char *near) __attribute__((noreturn));

static void refuse_field(lua_State *L, args_location location, const char *name,
                         const char *expected, const char *near) {
  const char *shown = names_push_shown(L, lua_gettop(L));
  error_raise(L, ARC_ARGUMENT, location.where, "field '%s%s': expected %s, got %s%s%s%s",
              location.prefix, name, expected, shown, near ? "; did you mean \"" : "",
              near ? near : "", near ? "\"?" : "");
}

void args_refuse(lua_State *L, args_location location, const char *name, const char *expected) {
  refuse_field(L, location, name, expected, NULL);
}

static const char *push_known(lua_State *L, const arc_setting *list) {
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  for (const arc_setting *field = list; field->name; field++) {
    if (field != list) luaL_addstring(&text, ", ");
    luaL_addstring(&text, field->name);
  }
  luaL_pushresult(&text);
  return lua_tostring(L, -1);
}

void args_unknown(lua_State *L, args_location location, const arc_setting *list, const char *name) {
  static const char *const of_model[] = {"radius", "thickness", "cylinder", "plate", "mesh", NULL};
  names_search search = names_begin(name);
  for (const arc_setting *field = list; field->name; field++) names_offer(&search, field->name);
  names_search model = names_begin(name);
  for (int i = 0; of_model[i] && location.prefix[0] == '\0'; i++) names_offer(&model, of_model[i]);
  if (model.best && (!search.best || strcmp(model.best, name) == 0))
    error_raise(L, ARC_ARGUMENT, location.where,
                "unknown field '%s': it is a field of model{}, as in model = { %s = ... }", name,
                model.best);
  if (search.best)
    error_raise(L, ARC_ARGUMENT, location.where, "unknown field '%s%s' (did you mean '%s'%s?)",
                location.prefix, name, search.best, names_relation(&search));
  if (strcmp(name, "E") == 0 || strcmp(name, "nu") == 0 || strcmp(name, "material") == 0)
    error_raise(L, ARC_ARGUMENT, location.where,
                "unknown field '%s%s': it is a field of a body, as in model = { upper = "
                "body.cylinder{ %s = ... } }",
                location.prefix, name, name);
  error_raise(L, ARC_ARGUMENT, location.where, "unknown field '%s%s' (known: %s)", location.prefix,
              name, push_known(L, list));
}

void args_refuse_position(lua_State *L, args_location location) {
  const size_t length = strlen(location.prefix);
  const int number = lua_type(L, -1) == LUA_TNUMBER;
  const char *key = luaL_tolstring(L, -2, NULL);
  lua_pushlstring(L, location.prefix, length > 0 ? length - 1 : 0);
  error_raise(L, ARC_ARGUMENT, location.where, "fields are given by name; found [%s]%s%s%s", key,
              length > 0 ? " in " : "", lua_tostring(L, -1),
              number ? " (numbers have a decimal point, as in 0.11)" : "");
}

void args_check_table(lua_State *L, int index, const char *where) {
  if (lua_istable(L, index)) return;
  error_raise(L, ARC_ARGUMENT, where,
              "expected a table of named fields, got %s; help \"%s\" lists the fields",
              names_push_shown(L, index), where);
}

void args_check_names(lua_State *L, int index, args_location location, const arc_setting *list) {
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) args_refuse_position(L, location);
    if (!arc_setting_find(list, names_push_text(L, -2)))
      args_unknown(L, location, list, lua_tostring(L, -1));
    lua_pop(L, 1);
  }
}

/* --- reading arguments ------------------------------------------------------------------------ */

enum { LONGEST_TEXT = 240 }; /* [bytes] buffer for a text that describes valid values */

static void refuse(lua_State *L, args_location location, const arc_setting *s)
    __attribute__((noreturn));

/* Returns the choice most similar to the text on top of the stack, or NULL. */
static const char *nearest_choice(lua_State *L, const arc_setting *s) {
  if (s->kind != ARC_CHOICE || s->choices == arc_switch_names || lua_type(L, -1) != LUA_TSTRING)
    return NULL;
  names_search search = names_begin(lua_tostring(L, -1));
  for (int i = 0; s->choices[i]; i++) names_offer(&search, s->choices[i]);
  return search.best;
}

static void refuse(lua_State *L, args_location location, const arc_setting *s) {
  char expected[LONGEST_TEXT];
  refuse_field(L, location, s->name, arc_setting_expected(s, expected, sizeof expected),
               nearest_choice(L, s));
}

double args_number(lua_State *L, args_location location, const arc_setting *s) {
  arc_error error = {0};
  if (lua_type(L, -1) != LUA_TNUMBER) refuse(L, location, s);
  const double value = lua_tonumber(L, -1);
  error_check(L, arc_setting_check_number(s, location.prefix, value, &error), &error,
              location.where, -1);
  return value;
}

/* Returns the index in `choices` of the text at stack index `index`, or -1 if the text is not one
 * of the choices. The text "plane" is a short form of "plane strain". */
static int find_choice(lua_State *L, int index, const char *const *choices) {
  if (choices == arc_switch_names) return lua_isboolean(L, index) ? lua_toboolean(L, index) : -1;
  if (lua_type(L, index) != LUA_TSTRING) return -1;
  const char *word = lua_tostring(L, index);
  if (strcmp(word, "plane") == 0) word = "plane strain";
  for (int i = 0; choices[i]; i++)
    if (strcmp(choices[i], word) == 0) return i;
  return -1;
}

int args_choice(lua_State *L, int index, args_location location, const char *name,
                const char *const *choices, int otherwise) {
  if (lua_isnoneornil(L, index) && otherwise >= 0) return otherwise;
  const int found = find_choice(L, index, choices);
  if (found >= 0) return found;
  if (lua_isnone(L, index))
    lua_pushnil(L);
  else
    lua_pushvalue(L, index);
  refuse(L, location, &(arc_setting){.name = name, .kind = ARC_CHOICE, .choices = choices});
}

static void set_number(const arc_setting *s, void *definition, double value) {
  if (s->kind == ARC_WHOLE)
    *(int *)arc_setting_member(s, definition) = (int)value;
  else
    *(double *)arc_setting_member(s, definition) = value;
}

/* Returns true if the value on top of the stack is "auto", a function or a series and the setting
 * allows such a value. Stores "auto" as 0. */
static int other_form(lua_State *L, const arc_setting *s, void *definition) {
  const int type = lua_type(L, -1);
  int automatic = 0;
  if (s->forms & ARC_AUTOMATIC && type == LUA_TSTRING)
    automatic = strcmp(lua_tostring(L, -1), "auto") == 0;
  if (automatic) set_number(s, definition, 0);
  return automatic || (s->forms & ARC_FUNCTION && type == LUA_TFUNCTION) ||
         (s->forms & ARC_SERIES && type == LUA_TTABLE);
}

static void read_number(lua_State *L, args_location location, const arc_setting *s,
                        void *definition) {
  if (!other_form(L, s, definition)) set_number(s, definition, args_number(L, location, s));
}

static void read_text(lua_State *L, args_location location, const arc_setting *s, char *to) {
  size_t length;
  const char *text = lua_type(L, -1) == LUA_TSTRING ? lua_tolstring(L, -1, &length) : NULL;
  if (!text || length == 0 || length >= ARC_TEXT_SIZE || strlen(text) != length)
    refuse(L, location, s);
  memcpy(to, text, length + 1);
}

/* Reads a group of settings from a table of fields, or from an object of the group's class. */
static void read_group(lua_State *L, args_location location, const arc_setting *s,
                       void *definition) {
  void *member = arc_setting_member(s, definition);
  if (s->class_name && box_copy_value(L, -1, s->class_name, member)) return;
  if (!lua_istable(L, -1)) refuse(L, location, s);
  args_location inside = {location.where, lua_pushfstring(L, "%s%s.", location.prefix, s->name)};
  args_read(L, -2, inside, s->group, member);
  lua_pop(L, 1);
}

/* Stores the value on top of the stack in the struct member of the setting. */
static void read_value(lua_State *L, args_location location, const arc_setting *s,
                       void *definition) {
  switch (s->kind) {
  case ARC_NUMBER:
  case ARC_WHOLE:
    read_number(L, location, s, definition);
    break;
  case ARC_CHOICE:
    *(int *)arc_setting_member(s, definition) =
        args_choice(L, -1, location, s->name, s->choices, -1);
    break;
  case ARC_TEXT:
    read_text(L, location, s, arc_setting_member(s, definition));
    break;
  case ARC_GROUP:
    read_group(L, location, s, definition);
    break;
  case ARC_OTHER:
    break;
  }
}

int args_get(lua_State *L, int index, const char *name) {
  if (lua_type(L, index) == LUA_TTABLE) return lua_getfield(L, index, name);
  lua_pushnil(L);
  return LUA_TNIL;
}

void args_push_copy(lua_State *L, int index) {
  index = lua_absindex(L, index);
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, index);) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
}

int args_given(lua_State *L, int index, const char *name) {
  const int type = args_get(L, index, name);
  lua_pop(L, 1);
  return type != LUA_TNIL;
}

void args_read(lua_State *L, int index, args_location location, const arc_setting *list,
               void *definition) {
  if (lua_isnoneornil(L, index)) return;
  luaL_checkstack(L, 12, location.where);
  index = lua_absindex(L, index);
  args_check_table(L, index, location.where);
  args_check_names(L, index, location, list);
  for (const arc_setting *s = list; s->name; s++) {
    if (lua_getfield(L, index, s->name) != LUA_TNIL) read_value(L, location, s, definition);
    lua_pop(L, 1);
  }
}

/* The checks of definition tables. Leans on names.c for the name the user may have meant. */
#include "lua/base/args.h"
#include "lua/base/error.h"
#include "lua/base/names.h"

#include <lauxlib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- what was expected, what came ------------------------------------------------------------ */

const char *args_show_number(lua_State *L, double value) {
  char text[40];
  snprintf(text, sizeof text, "%.14g", value);
  return lua_pushstring(L, text);
}

void args_refuse(lua_State *L, args_place place, const char *name, const char *expected) {
  const char *shown = names_push_shown(L, lua_gettop(L));
  error_raise(L, ARC_ARGUMENT, place.where, "field '%s%s': expected %s, got %s", place.prefix, name,
              expected, shown);
}

/* Pushes "a number in [0, 1]" and the like. */
static const char *push_range(lua_State *L, const args_field *field) {
  const char *kind = field->kind == ARGS_WHOLE ? "a whole number" : "a number";
  int low_open = field->open & ARGS_LOW_OPEN, high_open = field->open & ARGS_HIGH_OPEN;
  char text[80] = "";
  if (isfinite(field->low) && isfinite(field->high))
    snprintf(text, sizeof text, " in %c%.14g, %.14g%c", low_open ? '(' : '[', field->low,
             field->high, high_open ? ')' : ']');
  else if (isfinite(field->low))
    snprintf(text, sizeof text, " %s %.14g", low_open ? ">" : ">=", field->low);
  return lua_pushfstring(L, "%s%s", kind, text);
}

/* Pushes `"a", "b" or "c"`. */
static const char *push_choices(lua_State *L, const char *const *choices) {
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  for (int i = 0; choices[i]; i++) {
    if (i > 0) luaL_addstring(&text, choices[i + 1] ? ", " : " or ");
    luaL_addchar(&text, '"');
    luaL_addstring(&text, choices[i]);
    luaL_addchar(&text, '"');
  }
  luaL_pushresult(&text);
  return lua_tostring(L, -1);
}

/* --- names ------------------------------------------------------------------------------------ */

static const char *push_known(lua_State *L, const args_field *fields) {
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  for (const args_field *field = fields; field->name; field++) {
    if (field != fields) luaL_addstring(&text, ", ");
    luaL_addstring(&text, field->name);
  }
  luaL_pushresult(&text);
  return lua_tostring(L, -1);
}

void args_unknown(lua_State *L, args_place place, const args_field *fields, const char *name) {
  names_search search = names_begin(name);
  for (const args_field *field = fields; field->name; field++) names_offer(&search, field->name);
  if (search.best)
    error_raise(L, ARC_ARGUMENT, place.where, "unknown field '%s%s' (did you mean '%s'?)",
                place.prefix, name, search.best);
  static const char *const of_model[] = {"radius", "thickness", "cylinder", "plate", "mesh", NULL};
  for (int i = 0; of_model[i] && place.prefix[0] == '\0'; i++)
    if (strcmp(name, of_model[i]) == 0)
      error_raise(L, ARC_ARGUMENT, place.where,
                  "unknown field '%s': it is a field of model{}, as in model = { %s = ... }", name,
                  name);
  error_raise(L, ARC_ARGUMENT, place.where, "unknown field '%s%s' (known: %s)", place.prefix, name,
              push_known(L, fields));
}

void args_check_names(lua_State *L, int index, args_place place, const args_field *fields) {
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      error_raise(L, ARC_ARGUMENT, place.where, "fields are given by name; found [%s]%s%s",
                  luaL_tolstring(L, -2, NULL), place.prefix[0] ? " in " : "", place.prefix);
    const char *name = lua_tostring(L, -2);
    const args_field *field = fields;
    while (field->name && strcmp(field->name, name) != 0) field++;
    if (!field->name) args_unknown(L, place, fields, name);
  }
}

/* --- reading --------------------------------------------------------------------------------- */

static int in_range(double value, const args_field *field) {
  int above = field->open & ARGS_LOW_OPEN ? value > field->low : value >= field->low;
  int below = field->open & ARGS_HIGH_OPEN ? value < field->high : value <= field->high;
  return isfinite(value) && above && below;
}

double args_number(lua_State *L, args_place place, const args_field *field) {
  if (lua_type(L, -1) == LUA_TNUMBER && in_range(lua_tonumber(L, -1), field))
    return lua_tonumber(L, -1);
  const char *range = push_range(L, field);
  lua_insert(L, -2);
  args_refuse(L, place, field->name, range);
}

static int read_whole(lua_State *L, args_place place, const args_field *field) {
  double value = args_number(L, place, field);
  if (value == floor(value) && fabs(value) <= 1e9) return (int)value;
  args_refuse(L, place, field->name, "a whole number");
}

int args_choice(lua_State *L, int index, args_place place, const char *name,
                const char *const *choices, int otherwise) {
  if (lua_isnoneornil(L, index) && otherwise >= 0) return otherwise;
  if (lua_type(L, index) == LUA_TSTRING)
    for (int i = 0; choices[i]; i++)
      if (strcmp(choices[i], lua_tostring(L, index)) == 0) return i;
  if (lua_isnone(L, index))
    lua_pushnil(L);
  else
    lua_pushvalue(L, index);
  const char *expected = push_choices(L, choices);
  lua_insert(L, -2);
  args_refuse(L, place, name, expected);
}

/* Reads the value on top of the stack. */
static void read_field(lua_State *L, args_place place, const args_field *field, char *member) {
  switch (field->kind) {
  case ARGS_NUMBER:
    *(double *)(void *)member = args_number(L, place, field);
    break;
  case ARGS_WHOLE:
    *(int *)(void *)member = read_whole(L, place, field);
    break;
  case ARGS_CHOICE:
    *(int *)(void *)member = args_choice(L, -1, place, field->name, field->choices, -1);
    break;
  case ARGS_READER:
    field->read(L, place, field->name, member);
    break;
  case ARGS_ANY:
    break;
  }
}

int args_get(lua_State *L, int index, const char *name) {
  if (lua_type(L, index) == LUA_TTABLE) return lua_getfield(L, index, name);
  lua_pushnil(L);
  return LUA_TNIL;
}

void args_read(lua_State *L, int index, args_place place, const args_field *fields,
               void *definition) {
  if (lua_isnoneornil(L, index)) return;
  luaL_checkstack(L, 12, place.where);
  index = lua_absindex(L, index);
  if (!lua_istable(L, index))
    error_raise(L, ARC_ARGUMENT, place.where, "expected a table of named fields, got %s",
                names_push_shown(L, index));
  args_check_names(L, index, place, fields);
  for (const args_field *field = fields; field->name; field++) {
    if (lua_getfield(L, index, field->name) != LUA_TNIL)
      read_field(L, place, field, (char *)definition + field->offset);
    lua_pop(L, 1);
  }
}

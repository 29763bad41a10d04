/* Creates tables of results with one field for each body. The key of the field is the name of the
 * body. Other words for a body are aliases of this key: its role (upper, lower), its kind and its
 * default name. */
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/base/strict.h"
#include "lua/engine/classes.h"

#include <string.h>

const char *const body_names[] = {"cylinder", "plate", NULL};

static const arc_model_def usual;

const char *body_name(const arc_model_def *def, arc_body body) {
  return arc_model_body_name(def ? def : &usual, body);
}

/* --- names of bodies -------------------------------------------------------------------------- */

int body_find(const arc_model_def *def, const char *word, arc_body *body) {
  return arc_model_find_body(def ? def : &usual, word, body);
}

/* Pushes the names of both bodies for an error message. If the names are not the default names,
 * adds which body is the upper and which the lower. */
static const char *push_expected(lua_State *L, const arc_model_def *def) {
  const char *upper = body_name(def, ARC_UPPER), *lower = body_name(def, ARC_LOWER);
  lua_pushfstring(L, "\"%s\" or \"%s\"", upper, lower);
  if (def && (strcmp(upper, body_names[0]) != 0 || strcmp(lower, body_names[1]) != 0))
    lua_pushfstring(L, "%s (the upper and the lower body)", lua_tostring(L, -1));
  return lua_tostring(L, -1);
}

arc_body body_argument(lua_State *L, int index, const char *where, const arc_model_def *def,
                       int otherwise) {
  arc_body body = ARC_UPPER;
  if (lua_isnoneornil(L, index) && otherwise >= 0) return (arc_body)otherwise;
  if (lua_type(L, index) == LUA_TSTRING && body_find(def, lua_tostring(L, index), &body) == 1)
    return body;
  const char *expected = push_expected(L, def);
  if (lua_isnone(L, index))
    lua_pushnil(L);
  else
    lua_pushvalue(L, index);
  args_refuse(L, (args_location){where, ""}, "body", expected);
}

/* --- tables by body --------------------------------------------------------------------------- */

/* Adds `word` as an alias to the table on top of the stack if the word identifies exactly one
 * body. */
static void add_word(lua_State *L, const arc_model_def *def, const char *word) {
  arc_body body;
  if (body_find(def, word, &body) != 1) return;
  lua_pushstring(L, body_name(def, body));
  lua_setfield(L, -2, word);
}

/* Pushes a table that maps each alias of a body to the name of the body's field. */
static void push_words(lua_State *L, const arc_model_def *def) {
  lua_newtable(L);
  for (int b = 0; b < ARC_BODIES; b++) {
    add_word(L, def, arc_model_role_name((arc_body)b));
    add_word(L, def, body_names[b]);
    add_word(L, def, body_name(def, (arc_body)b));
  }
  for (int k = 0; arc_solid_names[k]; k++) add_word(L, def, arc_solid_names[k]);
}

/* Sets the metatable of the table on top of the stack. Each pair of bodies has one metatable, which
 * is created at its first use. `push` pushes the table of aliases. */
static void set_answering(lua_State *L, const arc_model_def *def, const char *where,
                          void (*push)(lua_State *L, const arc_model_def *def)) {
  const arc_model_def *pair = def ? def : &usual;
  luaL_checkstack(L, 12, where);
  const char *key = lua_pushfstring(L, "archard.by_body %s %s %s %d %d", where,
                                    body_name(def, ARC_UPPER), body_name(def, ARC_LOWER),
                                    pair->body[ARC_UPPER].kind, pair->body[ARC_LOWER].kind);
  if (luaL_getmetatable(L, key) == LUA_TNIL) {
    lua_pop(L, 1);
    push(L, def);
    strict_metatable(L, where, -1);
    lua_remove(L, -2);
    lua_pushvalue(L, -1);
    lua_setfield(L, LUA_REGISTRYINDEX, key);
  }
  lua_setmetatable(L, -3);
  lua_pop(L, 1);
}

void by_body_named(lua_State *L, const arc_model_def *def, const char *where) {
  set_answering(L, def, where, push_words);
}

/* Adds the alias "depth_WORD" or "volume_WORD" of a column of the history if `word` identifies
 * exactly one body. `what` is "depth" or "volume". */
static void add_column(lua_State *L, const arc_model_def *def, const char *what, const char *word) {
  arc_body body;
  if (body_find(def, word, &body) != 1) return;
  lua_pushfstring(L, "%s_%s", what, word);
  lua_pushfstring(L, "%s_%s", what, body_names[body]);
  lua_rawset(L, -3);
}

static void push_columns(lua_State *L, const arc_model_def *def) {
  lua_newtable(L);
  const int columns = lua_gettop(L);
  push_words(L, def);
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
    const char *word = lua_tostring(L, -2);
    lua_pushvalue(L, columns);
    add_column(L, def, "depth", word);
    add_column(L, def, "volume", word);
    lua_pop(L, 1);
  }
  lua_settop(L, columns);
}

void columns_by_body(lua_State *L, const arc_model_def *def, const char *where) {
  set_answering(L, def, where, push_columns);
}

void set_by_body(lua_State *L, const arc_model_def *def, arc_body body) {
  lua_setfield(L, -2, body_name(def, body));
}

void push_by_body(lua_State *L, const arc_model_def *def, double upper, double lower,
                  const char *where) {
  lua_createtable(L, 0, 3);
  lua_pushnumber(L, upper);
  set_by_body(L, def, ARC_UPPER);
  lua_pushnumber(L, lower);
  set_by_body(L, def, ARC_LOWER);
  by_body_named(L, def, where);
}

void push_body_names(lua_State *L, const arc_model_def *def) {
  lua_createtable(L, 0, 2);
  for (int b = 0; b < ARC_BODIES; b++) {
    lua_pushstring(L, body_name(def, (arc_body)b));
    set_by_body(L, def, (arc_body)b);
  }
  by_body_named(L, def, "model.bodies");
}

void push_usual_names(lua_State *L, int index, args_location location, const arc_model_def *def) {
  index = lua_absindex(L, index);
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    arc_body body;
    const char *name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : NULL;
    const int found = name ? body_find(def, name, &body) : 0;
    if (found < 0)
      error_raise(L, ARC_ARGUMENT, location.where,
                  "field '%s%s': ambiguous: both bodies match; use upper or lower", location.prefix,
                  name);
    if (found) {
      lua_getfield(L, -3, body_names[body]);
      if (!lua_isnil(L, -1))
        error_raise(L, ARC_ARGUMENT, location.where, "field '%s%s': this body is given twice",
                    location.prefix, name);
      lua_pop(L, 1);
      lua_pushstring(L, body_names[body]);
    } else {
      lua_pushvalue(L, -2);
    }
    lua_pushvalue(L, -2);
    lua_settable(L, -5);
  }
}

/* Creates the stress object of a contact, which contains a table of nodal arrays for each body. */
#include "lua/base/array_read.h"
#include "lua/base/call.h"
#include "lua/engine/classes.h"
#include "lua/engine/surface_maps.h"
#include "lua/base/error.h"
#include "lua/base/strict.h"

#include <stdio.h>

static const char kind[] = "archard.stress";

static void destroy_field(void *thing) {
  arc_field *field = thing;
  arc_field_destroy(&field);
}

static int holder_tostring(lua_State *L) {
  lua_pushliteral(L, "field");
  return 1;
}

/* Class of boxes that own a stress field of the engine while it is converted to tables or files. */
static const box_class field_class = {
    .name = "stress of a body", .tostring = holder_tostring, .destroy = destroy_field};

const arc_field *field_push_holder(lua_State *L, const arc_contact *contact, arc_body body,
                                   const char *where) {
  arc_error error = {0};
  arc_field *field = NULL;
  box *holder = box_push(L, &field_class);
  arc_status status = arc_contact_field(contact, body, &field, &error);
  holder->thing = field;
  error_check(L, status, &error, where, -1);
  return field;
}

/* Pushes the stress field of one body as a table of nodal arrays. */
static void push_field(lua_State *L, const arc_contact *contact, arc_body body) {
  const arc_field *field = field_push_holder(L, contact, body, "contact:stress");
#define SET_COLUMN(name, unit, text) array_set(L, #name, field->name, (size_t)field->nodes);
  lua_newtable(L);
  ARC_FIELD_COLUMNS(SET_COLUMN)
  mesh_push_elements(L, arc_model_mesh(arc_contact_model(contact), body));
  lua_setfield(L, -2, "elements");
  strict_table(L, "stress");
  box_empty(lua_touserdata(L, -2), &field_class);
  lua_replace(L, -2);
}

/* Returns item `position` of the array `name` in the table on top of the stack. Returns NaN if
 * the item is not a number, because scripts can change the table. */
static double element_of(lua_State *L, const char *name, lua_Integer position) {
  double value = NAN;
  if (lua_getfield(L, -1, name) == LUA_TTABLE) {
    if (lua_rawgeti(L, -1, position) == LUA_TNUMBER) value = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return value;
}

/* Returns the index of the largest number in array `name` of the table on top of the stack. */
static lua_Integer largest_of(lua_State *L, const char *name) {
  lua_Integer best = 1;
  double largest = -HUGE_VAL;
  const int is_list = lua_getfield(L, -1, name) == LUA_TTABLE;
  const size_t count =
      is_list ? array_length(L, (args_location){"stress", ""}, name, ARRAY_MOST) : 0;
  for (size_t i = 1; i <= count; i++) {
    if (lua_rawgeti(L, -1, (lua_Integer)i) == LUA_TNUMBER && lua_tonumber(L, -1) > largest) {
      largest = lua_tonumber(L, -1);
      best = (lua_Integer)i;
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return best;
}

/* Pushes a line of text with the largest value of one stress, and its position. The stress is in
 * the table on top of the stack. */
static void push_largest(lua_State *L, const char *label, const char *stress) {
  char line[160];
  lua_Integer at = largest_of(L, stress);
  snprintf(line, sizeof line, "\n  %-8s  %s up to %.6g MPa at x = %.4g, y = %.4g mm", label, stress,
           element_of(L, stress, at), element_of(L, "x", at), element_of(L, "y", at));
  lua_pushstring(L, line);
}

/* Pushes the weak table that maps stress objects to their contacts. */
static void push_origins(lua_State *L) {
  if (!luaL_getsubtable(L, LUA_REGISTRYINDEX, "archard.stress origins")) {
    lua_createtable(L, 0, 1);
    lua_pushliteral(L, "k");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
  }
}

const arc_contact *stress_contact(lua_State *L, int index, const char *where) {
  lua_pushvalue(L, index);
  push_origins(L);
  lua_insert(L, -2);
  lua_gettable(L, -2);
  const arc_contact *contact =
      lua_isnil(L, -1) ? NULL : box_check(L, -1, &contact_class, where)->thing;
  lua_pop(L, 2); /* the entry of the weak table keeps the contact alive */
  return contact;
}

/* Returns the model definition of a stress object, or NULL for the default bodies. */
static const arc_model_def *pair_of(lua_State *L, int index) {
  const arc_contact *contact = stress_contact(L, index, "stress");
  return contact ? arc_model_definition(arc_contact_model(contact)) : NULL;
}

static int stress_tostring(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const arc_model_def *def = pair_of(L, 1);
  lua_pushliteral(L, "stress: lists of nodal values for each body");
  for (int body = 0; body < ARC_BODIES; body++) {
    const char *name = body_name(def, (arc_body)body);
    if (lua_getfield(L, 1, name) != LUA_TTABLE) {
      lua_pop(L, 1);
      continue;
    }
    push_largest(L, name, "mises");
    lua_insert(L, -2);
    push_largest(L, "", "shear");
    lua_replace(L, -2);
    lua_concat(L, 3);
  }
  return 1;
}

/* Metamethod __index of stress objects: returns the table of a body for an alias of its name, or
 * the contact for `contact`. The contact is not stored as a field, so that a loop over the
 * object visits only the bodies. */
static int stress_index(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  const arc_model_def *def = pair_of(L, 1);
  arc_body body;
  if (lua_type(L, 2) == LUA_TSTRING && body_find(def, lua_tostring(L, 2), &body) == 1) {
    lua_pushstring(L, body_name(def, body));
    lua_rawget(L, 1);
    return 1;
  }
  lua_pushliteral(L, "contact");
  if (!lua_rawequal(L, 2, 3)) {
    if (lua_type(L, 2) == LUA_TSTRING && strict_reads_called(L))
      strict_refuse(L, "stress", lua_tostring(L, 2), 1);
    return 0;
  }
  push_origins(L);
  lua_pushvalue(L, 1);
  lua_gettable(L, -2);
  return 1;
}

/* contact:stress() returns { cylinder=, plate= }, a table of nodal arrays for each body. */
int stress_new(lua_State *L) {
  static const luaL_Reg events[] = {
      {"__tostring", stress_tostring}, {"__index", stress_index}, {NULL, NULL}};
  const arc_contact *contact = box_self(L, &contact_class, "contact:stress")->thing;
  luaL_checkstack(L, 12, "contact:stress");
  if (arc_model_has_maps(arc_model_definition(arc_contact_model(contact))))
    return stress_push_space(L, contact, 2, "contact:stress");
  lua_createtable(L, 0, 2);
  for (int body = 0; body < ARC_BODIES; body++) {
    push_field(L, contact, (arc_body)body);
    set_by_body(L, arc_model_definition(arc_contact_model(contact)), (arc_body)body);
  }
  push_origins(L);
  lua_pushvalue(L, -2);
  lua_pushvalue(L, 1);
  lua_settable(L, -3);
  lua_pop(L, 1);
  if (luaL_newmetatable(L, kind)) {
    call_set_functions(L, events);
    lua_newtable(L);
    lua_setfield(L, -2, "__methods");
    lua_createtable(L, 1, 0);
    lua_pushliteral(L, "contact");
    lua_rawseti(L, -2, 1);
    lua_setfield(L, -2, "__fields");
  }
  lua_setmetatable(L, -2);
  return 1;
}

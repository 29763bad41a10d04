/* Module `archard.measure`: computes quantities from wear profiles, and creates tables with one
 * entry per body. The classes in C use the functions of measure_module.h directly. */
#include "lua/engine/bodies.h"
#include "lua/engine/classes.h"
#include "lua/engine/measure_module.h"
#include "lua/base/archard.h"
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/base/strict.h"

#include <lauxlib.h>

int measure_push_combined(lua_State *L, arc_depths cylinder, arc_depths plate) {
  double *sum = array_buffer(L, plate.count);
  arc_measure_combined(cylinder, plate, sum);
  lua_createtable(L, 0, 2);
  array_set(L, "x", plate.x, plate.count);
  array_set(L, "h", sum, plate.count);
  strict_table(L, "combined");
  return 1;
}

int measure_push_partition(lua_State *L, arc_depths cylinder, arc_depths plate) {
  double *x = array_buffer(L, plate.count), *value = array_buffer(L, plate.count);
  const size_t worn = arc_measure_local_partition(cylinder, plate, x, value);
  lua_createtable(L, 0, 2);
  array_set(L, "x", x, worn);
  array_set(L, "value", value, worn);
  strict_table(L, "local_partition");
  return 1;
}

/* Reads the tables at indices `x` and `y`, which must have equal length, into buffers on the
 * stack. */
static arc_depths read_columns(lua_State *L, args_location location, int x, int y) {
  arc_depths read;
  size_t count;
  lua_pushvalue(L, x);
  read.x = array_read(L, location, "x", &read.count);
  lua_pushvalue(L, y);
  read.h = array_read(L, location, "y", &count);
  if (count != read.count)
    error_raise(L, ARC_ARGUMENT, location.where,
                "expected arrays of equal length, got %d and %d numbers", (int)read.count,
                (int)count);
  return read;
}

/* Reads the profile { x=, h= } at `index`. */
static arc_depths read_profile(lua_State *L, const char *where, int index) {
  luaL_checktype(L, index, LUA_TTABLE);
  luaL_checkstack(L, 12, where);
  lua_getfield(L, index, "x");
  lua_getfield(L, index, "h");
  const int top = lua_gettop(L);
  return read_columns(L, (args_location){where, ""}, top - 1, top);
}

/* combined(cylinder, plate) returns { x=, h= }, the sum of two profiles (Eq. 31 of Mattei and Di
 * Puccio). */
static int measure_combined(lua_State *L) {
  static const char where[] = "measure.combined";
  const arc_depths cylinder = read_profile(L, where, 1);
  return measure_push_combined(L, cylinder, read_profile(L, where, 2));
}

/* local_partition(cylinder, plate) returns { x=, value= }, the cylinder's share of the combined
 * depth (Eq. 30 of Mattei and Di Puccio). */
static int measure_local_partition(lua_State *L) {
  static const char where[] = "measure.local_partition";
  const arc_depths cylinder = read_profile(L, where, 1);
  return measure_push_partition(L, cylinder, read_profile(L, where, 2));
}

/* sawtooth(x, y, reach) returns the root mean square of the part of y that alternates from node to
 * node, for |x| <= reach. */
static int measure_sawtooth(lua_State *L) {
  const double reach = luaL_checknumber(L, 3);
  const arc_depths y = read_columns(L, (args_location){"measure.sawtooth", ""}, 1, 2);
  lua_pushnumber(L, arc_measure_sawtooth(y.x, y.h, y.count, -reach, reach));
  return 1;
}

/* --- tables by body --------------------------------------------------------------------------- */

/* Reads the names of the bodies from the model table at index 1. Without a table, the bodies have
 * the default names. */
static arc_model_def read_names(lua_State *L) {
  arc_model_def def = {0};
  if (lua_istable(L, 1) || lua_isuserdata(L, 1)) body_read_names(L, 1, &def);
  return def;
}

/* bodies(model) returns a table of the names of both bodies, like the field `bodies` of a model. */
static int measure_bodies(lua_State *L) {
  const arc_model_def def = read_names(L);
  push_body_names(L, &def);
  return 1;
}

/* by_body(model, upper, lower, where) returns a table by body, like w.depth, of the number `upper`
 * for the upper body and `lower` for the lower body. */
static int measure_by_body(lua_State *L) {
  const arc_model_def def = read_names(L);
  push_by_body(L, &def, luaL_checknumber(L, 2), luaL_checknumber(L, 3), luaL_checkstring(L, 4));
  return 1;
}

/* columns(model, history, where) adds aliases with the names of the bodies to the columns of the
 * history, and returns the history. */
static int measure_columns(lua_State *L) {
  const arc_model_def def = read_names(L);
  luaL_checktype(L, 2, LUA_TTABLE);
  const char *where = luaL_optstring(L, 3, "history");
  lua_pushvalue(L, 2);
  columns_by_body(L, &def, where);
  return 1;
}

int luaopen_archard_measure(lua_State *L) {
  static const luaL_Reg functions[] = {{"bodies", measure_bodies},
                                       {"by_body", measure_by_body},
                                       {"columns", measure_columns},
                                       {"combined", measure_combined},
                                       {"local_partition", measure_local_partition},
                                       {"sawtooth", measure_sawtooth},
                                       {NULL, NULL}};
  luaL_newlib(L, functions);
  return 1;
}

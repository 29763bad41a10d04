/* Reads surfaces of bodies that are given by points: profiles over x, and maps over x and z. */
#include "lua/engine/body_points.h"
#include "lua/base/array_read.h"
#include "lua/base/call.h"
#include "lua/base/error.h"
#include "lua/base/scripts.h"

#include <lauxlib.h>
#include <string.h>

/* --- profiles --------------------------------------------------------------------------------- */

enum { SAMPLES = 20001 }; /* number of sample points of a function */

static arc_series sample_function(lua_State *L, int function, args_location location,
                                  double width) {
  double *x = array_buffer(L, 2 * SAMPLES), *y = x + SAMPLES;
  for (int i = 0; i < SAMPLES; i++) {
    x[i] = width * ((double)i / (SAMPLES - 1) - 0.5);
    lua_pushvalue(L, function);
    lua_pushnumber(L, x[i]);
    lua_call(L, 1, 1);
    if (lua_type(L, -1) != LUA_TNUMBER)
      args_refuse(L, location, "y", "a function that returns a height in mm");
    y[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return (arc_series){SAMPLES, x, y};
}

/* Reads the lists x and y of the table at `index` and pushes one buffer that contains both. */
static arc_series copy_lists(lua_State *L, int index, args_location location) {
  size_t xs, ys;
  lua_getfield(L, index, "x");
  if (!lua_istable(L, -1)) args_refuse(L, location, "x", "a list of positions in mm, with y");
  const double *x = array_read(L, location, "x", &xs);
  lua_getfield(L, index, "y");
  const double *y = array_read(L, location, "y", &ys);
  if (xs != ys || xs < 2 || xs > 1000000)
    error_raise(
        L, ARC_ARGUMENT, location.where,
        "fields '%sx' and '%sy': expected two lists of equal length (2 or more), got %d and %d "
        "numbers",
        location.prefix, location.prefix, (int)xs, (int)ys);
  double *both = array_buffer(L, 2 * xs);
  memcpy(both, x, xs * sizeof *x);
  memcpy(both + xs, y, xs * sizeof *y);
  return (arc_series){(int)xs, both, both + xs};
}

void body_read_profile(lua_State *L, int index, args_location location, double radius,
                       arc_body_def *def) {
  const int top = lua_gettop(L), type = lua_getfield(L, index, "y");
  if (type == LUA_TFUNCTION)
    def->y_series = sample_function(L, top + 1, location, def->width > 0 ? def->width : 2 * radius);
  else if (type == LUA_TTABLE)
    def->y_series = copy_lists(L, index, location);
  else
    args_refuse(L, location, "y", "a function y(x) or a list of heights in mm");
  call_keep(L);
  lua_settop(L, top);
}

/* --- maps ------------------------------------------------------------------------------------- */

/* Reads list `name` of the table at `index` as the values of a series and pushes the buffer of the
 * series. The indices 0, 1, 2, ... are used as the distances of the series. */
static arc_series push_numbers(lua_State *L, int index, args_location location, const char *name) {
  size_t count;
  if (lua_getfield(L, index, name) != LUA_TTABLE)
    args_refuse(L, location, name, "a list of numbers in mm, as returned by body.map{ y=map }");
  const double *values = array_read(L, location, name, &count);
  if (count > ARRAY_MOST / 2)
    error_raise(L, ARC_ARGUMENT, location.where,
                "field '%s%s': expected at most %d numbers, got %f", location.prefix, name,
                ARRAY_MOST / 2, (double)count);
  double *both = array_buffer(L, 2 * count + 1);
  for (size_t i = 0; i < count; i++) both[i] = (double)i;
  memcpy(both + count, values, count * sizeof *values);
  return (arc_series){(int)count, both, both + count};
}

void body_read_map(lua_State *L, int index, args_location location, arc_body_def *def) {
  const char *const names[] = {"x", "z", "y"};
  arc_series *const to[] = {&def->x_series, &def->z_series, &def->y_series};
  const int top = lua_gettop(L);
  for (int k = 0; k < 3; k++) {
    *to[k] = push_numbers(L, index, location, names[k]);
    call_keep(L);
    lua_settop(L, top);
  }
}

int body_is(lua_State *L, int index, const char *class) {
  if (luaL_getmetafield(L, index, "__name") == LUA_TNIL) return 0;
  const int is = lua_type(L, -1) == LUA_TSTRING && strcmp(lua_tostring(L, -1), class) == 0;
  lua_pop(L, 1);
  return is;
}

void body_take_profile(lua_State *L) {
  lua_pushvalue(L, 1);
  if (!body_is(L, -1, "profile")) lua_getfield(L, 1, "y");
  if (body_is(L, -1, "profile")) {
    lua_getfield(L, -1, "x");
    lua_setfield(L, 2, "x");
    lua_getfield(L, -1, "z");
    lua_setfield(L, 2, "y");
  }
  lua_settop(L, 2);
}

void body_take_map(lua_State *L, args_location location) {
  static const char *const names[] = {"x", "z", "y", "unit"};
  lua_pushvalue(L, 1);
  if (!body_is(L, 1, "map")) lua_getfield(L, 1, "y");
  if (!body_is(L, -1, "map")) {
    script_require(L, "archard.map.made");
    lua_getfield(L, -1, "new");
    lua_newtable(L);
    for (int k = 0; k < 3; k++) lua_getfield(L, 1, names[k]), lua_setfield(L, -2, names[k]);
    lua_call(L, 1, 1);
  }
  lua_getfield(L, -1, "unit");
  if (lua_type(L, -1) != LUA_TSTRING || strcmp(lua_tostring(L, -1), "mm") != 0)
    args_refuse(L, location, "y", "a map of heights in mm");
  lua_pop(L, 1);
  for (int k = 0; k < 3; k++) lua_getfield(L, -1, names[k]), lua_setfield(L, 2, names[k]);
  lua_settop(L, 2);
}

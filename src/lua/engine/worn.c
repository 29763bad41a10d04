/* Converts the field `worn` of contacts and wear runs to a shape of the engine. The field is a wear
 * object, or a table with a function x -> depth or a profile { x=, h= } for each body. */
#include "lua/base/array_read.h"
#include "lua/engine/bodies.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"
#include "lua/base/names.h"

#include <stdio.h>

static void destroy_shape(void *thing) {
  arc_shape *shape = thing;
  arc_shape_destroy(&shape);
}

static int shape_tostring(lua_State *L) {
  lua_pushliteral(L, "worn shape");
  return 1;
}

const box_class shape_class = {
    .name = "shape", .tostring = shape_tostring, .destroy = destroy_shape};

static const arc_setting by_body[] = {
    ARGS_OTHER("cylinder"),
    ARGS_OTHER("plate"),
    {.name = NULL},
};

static const char *const prefixes[ARC_BODIES] = {"worn.cylinder.", "worn.plate."};

/* --- profiles given as arrays ----------------------------------------------------------------- */

/* Pushes field `name` of the profile at `index`, and a buffer with its numbers. Returns the
 * buffer. */
static const double *push_column(lua_State *L, int index, args_location location, const char *name,
                                 size_t *count) {
  lua_getfield(L, index, name);
  return array_read(L, location, name, count);
}

static void check_profile(lua_State *L, args_location location, arc_depths profile) {
  for (size_t i = 0; i < profile.count; i++) {
    if (profile.h[i] < 0)
      error_raise(L, ARC_ARGUMENT, location.where,
                  "field '%sh[%d]': expected a depth >= 0 in mm, got %s", location.prefix,
                  (int)i + 1, args_show_number(L, profile.h[i]));
    if (i > 0 && profile.x[i] <= profile.x[i - 1])
      error_raise(L, ARC_ARGUMENT, location.where,
                  "field '%sx[%d]': expected increasing x, got %s after %s", location.prefix,
                  (int)i + 1, args_show_number(L, profile.x[i]),
                  args_show_number(L, profile.x[i - 1]));
  }
}

/* Reads and checks the profile { x=, h= } at `index`. If the value has a metamethod __worn, reads
 * the table that __worn returns. The buffers stay on the stack. */
static arc_depths push_profile(lua_State *L, int index, args_location location) {
  size_t depths = 0;
  arc_depths profile = {0, NULL, NULL};
  index = lua_absindex(L, index);
  luaL_checkstack(L, 12, location.where);
  if (luaL_callmeta(L, index, "__worn")) index = lua_gettop(L);
  if (!lua_istable(L, index))
    args_refuse(L, location, "",
                "a table { x=, h= } or an object whose __worn returns such a table");
  profile.x = push_column(L, index, location, "x", &profile.count);
  profile.h = push_column(L, index, location, "h", &depths);
  if (depths != profile.count || depths < 2)
    error_raise(
        L, ARC_ARGUMENT, location.where,
        "fields '%sx' and '%sh': expected two arrays of equal length (2 or more), got %d and "
        "%d numbers",
        location.prefix, location.prefix, (int)profile.count, (int)depths);
  check_profile(L, location, profile);
  return profile;
}

/* Reads the names of the bodies from the field `model` of the table at `index`. */
static arc_model_def names_of_model(lua_State *L, int index) {
  arc_model_def def = {0};
  args_get(L, index, "model");
  const box *object = box_test(L, -1, &model_class);
  if (object && object->thing)
    def = *arc_model_definition(object->thing);
  else if (lua_istable(L, -1))
    body_read_names(L, lua_gettop(L), &def);
  lua_pop(L, 1);
  return def;
}

/* Replaces the table on top of the stack by a copy. The keys of the table name bodies; the keys of
 * the copy are body_names. */
static void use_usual_names(lua_State *L, int index, const char *where) {
  const arc_model_def def = names_of_model(L, index);
  push_usual_names(L, -1, (args_location){where, "worn."}, &def);
  lua_remove(L, -2);
}

void worn_check(lua_State *L, int index, const char *where) {
  args_location location = {where, ""};
  args_get(L, index, "worn");
  if (lua_isnil(L, -1)) return;
  if (box_test(L, -1, &wear_class)) {
    box_check(L, lua_gettop(L), &wear_class, where);
    return;
  }
  if (!lua_istable(L, -1))
    args_refuse(L, location, "worn", "a wear object or a table { cylinder=, plate= }");
  use_usual_names(L, index, where);
  int worn = lua_gettop(L);
  args_check_names(L, worn, (args_location){where, "worn."}, by_body);
  for (int body = 0; body < ARC_BODIES; body++) {
    int type = lua_getfield(L, worn, body_names[body]);
    const int map = type == LUA_TTABLE && worn_is_map(L, -1);
    if (type == LUA_TTABLE && !map)
      push_profile(L, -1, (args_location){where, prefixes[body]});
    else if (type != LUA_TNIL && type != LUA_TFUNCTION && !map)
      args_refuse(L, (args_location){where, "worn."}, body_names[body],
                  "a function of x, a table { x=, h= } or, in 3-D, a map");
    lua_settop(L, worn);
  }
}

const arc_model_def *worn_model_def(lua_State *L, int worn) {
  box *other = box_test(L, worn, &wear_class);
  return other ? arc_model_definition(arc_wear_model(other->thing)) : NULL;
}

arc_model *worn_given_model(lua_State *L, int worn) {
  box *other = box_test(L, worn, &wear_class);
  arc_model *model = other ? arc_wear_model(other->thing) : NULL;
  return model && arc_model_is_given(model) ? model : NULL;
}

/* --- depths at the nodes ---------------------------------------------------------------------- */

/* Samples the profile at `index` at the nodes of the body. */
static void sample_profile(lua_State *L, int index, args_location location, const arc_shape *shape,
                           arc_body body, double *depth) {
  arc_error error = {0};
  const arc_depths profile = push_profile(L, index, location);
  const arc_status status = arc_shape_sample(shape, body, profile, depth, &error);
  error_check(L, status, &error, location.where, -1);
}

/* Calls the function at `index` for the depth [mm] at x. */
static double call_depth(lua_State *L, int index, const char *where, const char *body, double x) {
  char call[80];
  snprintf(call, sizeof call, "worn.%s(%.6g)", body, x);
  lua_pushvalue(L, index);
  lua_pushnumber(L, x);
  if (error_pcall(L, 1, 1) != LUA_OK) error_callback(L, where, call);
  double depth = lua_tonumber(L, -1);
  if (lua_type(L, -1) != LUA_TNUMBER || !(isfinite(depth) && depth >= 0))
    error_raise(L, ARC_CALLBACK, where, "%s: expected a depth >= 0 in mm, got %s", call,
                names_push_shown(L, -1));
  lua_pop(L, 1);
  return depth;
}

/* Computes the depths [mm] of one body at its nodes from the table at `worn`. Returns 0 if the body
 * is not worn. */
static int sample(lua_State *L, int worn, const arc_shape *shape, arc_body body, double *depth,
                  const char *where) {
  const arc_profile nodes = arc_shape_profile(shape, body);
  const char *name = body_names[body];
  int type = lua_getfield(L, worn, name), value = lua_gettop(L);
  if (type == LUA_TTABLE && worn_is_map(L, value))
    args_refuse(L, (args_location){where, "worn."}, name,
                "a function of x or a table { x=, h= }: maps are for geometry = \"3-D\"");
  if (type == LUA_TTABLE)
    sample_profile(L, value, (args_location){where, prefixes[body]}, shape, body, depth);
  for (int i = 0; type == LUA_TFUNCTION && i < nodes.count; i++)
    depth[i] = call_depth(L, value, where, name, nodes.x[i]);
  return type != LUA_TNIL;
}

/* Subtracts the smallest depth from all depths and returns the smallest depth. */
static double split_even(double *depth, int count) {
  double even = depth[0];
  for (int i = 1; i < count; i++)
    if (depth[i] < even) even = depth[i];
  for (int i = 0; i < count; i++) depth[i] -= even;
  return even;
}

static void wear_body(lua_State *L, int worn, arc_shape *shape, arc_body body, const char *where) {
  int top = lua_gettop(L);
  arc_profile nodes = arc_shape_profile(shape, body);
  arc_error error = {0};
  double *depth = array_buffer(L, (size_t)nodes.count);
  if (sample(L, worn, shape, body, depth, where)) {
    double even = body == ARC_PLATE ? split_even(depth, nodes.count) : 0;
    if (even > 0)
      error_check(L, arc_shape_wear_evenly(shape, body, even, &error), &error, where, -1);
    error_check(L, arc_shape_wear(shape, body, depth, &error), &error, where, -1);
  }
  lua_settop(L, top);
}

arc_shape *worn_push_shape(lua_State *L, int worn, arc_model *model, const arc_wear_def *def,
                           const char *where) {
  arc_error error = {0};
  arc_shape *shape = NULL;
  worn = lua_absindex(L, worn);
  luaL_checkstack(L, 12, where);
  if (!lua_isnil(L, worn) && arc_model_has_maps(arc_model_definition(model)))
    return worn_push_map(L, worn, model, def, where);
  box *holder = box_push(L, &shape_class);
  arc_status status = arc_shape_create(model, def->geometry, def->refresh, &shape, &error);
  holder->thing = shape;
  error_check(L, status, &error, where, -1);
  box *other = box_test(L, worn, &wear_class);
  if (other)
    error_check(L, arc_shape_remap(arc_wear_shape(other->thing), shape, &error), &error, where, -1);
  for (int body = 0; body < ARC_BODIES && !other && !lua_isnil(L, worn); body++)
    wear_body(L, worn, shape, (arc_body)body, where);
  return shape;
}

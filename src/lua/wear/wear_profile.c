/* Class wear: methods that return profiles, pressures and results computed from them. */
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/base/strict.h"
#include "lua/base/names.h"
#include "lua/engine/measure_module.h"
#include "lua/engine/surface_maps.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

#include <stdlib.h>

/* Returns the body that the value at index 2 names. If the value is nil or none, returns the
 * upper body. */
static arc_body wear_body(lua_State *L, const arc_wear *wear, const char *where) {
  return body_argument(L, 2, where, arc_model_definition(arc_wear_model(wear)), ARC_UPPER);
}

static int is_meshed(const arc_wear *wear) {
  return !arc_model_has_maps(arc_model_definition(arc_wear_model(wear)));
}

/* Pushes a userdata with the surface arrays of a run, and returns the arrays. */
static const arc_array *push_surfaces(lua_State *L, const arc_wear *wear, const char *where,
                                      size_t *count) {
  arc_error error = {0};
  arc_array **held = arrays_push_holder(L);
  error_check(L, arc_wear_surfaces(wear, held, count, &error), &error, where,
              (lua_Number)arc_wear_last(wear)->update);
  return *held;
}

/* Pushes the section { x=, NAME=, ... } for the methods wear:profile and wear:pressure of 3-D runs.
 * The position of the section, { z = 0 } or { x = 0 }, is at index 3. */
static int push_section(lua_State *L, const arc_wear *wear, const char *where,
                        const char *const *names) {
  size_t count;
  lua_settop(L, 3);
  const arc_body body = wear_body(L, wear, where);
  const arc_array *arrays = push_surfaces(L, wear, where, &count);
  surface_push_section(L, 3, where, arrays, count, body, names);
  return 1;
}

/* wear:map(body, quantity) returns a map of "depth", "height" or "pressure". */
int wear_map(lua_State *L) {
  static const char where[] = "wear:map";
  static const char *const what[] = {"depth", "height", "pressure", NULL};
  static const char *const name[] = {"h", "y", "p"}, *const unit[] = {"mm", "mm", "MPa"};
  const arc_wear *wear = wear_self(L, where);
  size_t count;
  lua_settop(L, 3);
  if (is_meshed(wear))
    error_raise(
        L, ARC_ARGUMENT, where,
        "expected a run with geometry = \"3-D\", got a two-dimensional run: use w:profile()");
  const arc_body body = wear_body(L, wear, where);
  const int which = args_choice(L, 3, (args_location){where, ""}, "what", what, 0);
  const arc_array *arrays = push_surfaces(L, wear, where, &count);
  surface_push_map(L, arrays, count, body, name[which], unit[which]);
  return 1;
}

/* wear:surfaces() returns the present surfaces as a list, see surface_push_list. */
int wear_surfaces(lua_State *L) {
  static const char where[] = "wear:surfaces";
  size_t count;
  const arc_array *arrays = push_surfaces(L, wear_self(L, where), where, &count);
  surface_push_list(L, arrays, count);
  return 1;
}

/* wear:profile(body) returns { x=, h=, y=, worn_x=, way= }. */
int wear_profile(lua_State *L) {
  static const char *const names[] = {"h", "y", NULL};
  const arc_wear *wear = wear_self(L, "wear:profile");
  if (!is_meshed(wear)) return push_section(L, wear, "wear:profile", names);
  if (!lua_isnoneornil(L, 3))
    error_raise(
        L, ARC_ARGUMENT, "wear:profile",
        "expected no section: the run is two-dimensional (sections need geometry = \"3-D\")");
  arc_body body = wear_body(L, wear, "wear:profile");
  arc_profile profile = arc_shape_profile(arc_wear_shape(wear), body);
  lua_createtable(L, 0, 5);
  array_set(L, "x", profile.x, (size_t)profile.count);
  array_set(L, "h", profile.h, (size_t)profile.count);
  array_set(L, "y", profile.y, (size_t)profile.count);
  array_set(L, "worn_x", profile.worn_x, (size_t)profile.count);
  array_set(L, "way", profile.way, (size_t)profile.count);
  strict_table(L, "wear:profile");
  return 1;
}

/* Pushes and returns the contact of a run in the reference configuration: plate at x = 0, nominal
 * load. */
static const arc_contact *push_contact(lua_State *L, const arc_wear *wear, const char *where) {
  arc_error error = {0};
  arc_contact *contact = NULL;
  lua_getiuservalue(L, 1, 1);
  box *made = box_push(L, &contact_class);
  box_keep(L, -2);
  arc_status status = arc_wear_contact(wear, &contact, &error);
  made->thing = contact;
  error_check(L, status, &error, where, (lua_Number)arc_wear_last(wear)->update);
  box_weigh(L, arc_contact_bytes(contact));
  return contact;
}

/* wear:contact() returns the contact with the plate at x = 0 under the nominal load. */
int wear_contact(lua_State *L) {
  push_contact(L, wear_self(L, "wear:contact"), "wear:contact");
  return 1;
}

/* Field wear.p_average: the largest pressure of wear:contact() [MPa] after averaging over the
 * default length. */
int wear_p_average(lua_State *L) {
  const arc_wear *wear = wear_self(L, "wear");
  lua_settop(L, 1);
  lua_pushnumber(L, arc_contact_get(push_contact(L, wear, "wear")).p_average);
  return 1;
}

/* Pushes the pressures { x=, p= } of a run whose bodies have no meshes. */
static void push_shown(lua_State *L, const arc_wear *wear, arc_body body) {
  static const char *const names[] = {"x", "p"};
  arc_error error = {0};
  arc_array *arrays;
  size_t count;
  error_check(L, arc_wear_surfaces(wear, &arrays, &count, &error), &error, "wear:pressure", -1);
  lua_createtable(L, 0, 2);
  for (int i = 0; i < 2; i++) {
    const arc_array *array = arc_array_find(arrays, count, body, names[i]);
    array_set(L, names[i], array->values, arc_array_count(array));
  }
  free(arrays);
  strict_table(L, "pressure");
}

/* wear:pressure(body) returns the pressures { x=, p= } of wear:contact(). */
int wear_pressure(lua_State *L) {
  static const char *const names[] = {"p", NULL};
  const arc_wear *wear = wear_self(L, "wear:pressure");
  if (!is_meshed(wear)) return push_section(L, wear, "wear:pressure", names);
  arc_body body = wear_body(L, wear, "wear:pressure");
  if (!arc_model_mesh(arc_wear_model(wear), body)) {
    push_shown(L, wear, body);
    return 1;
  }
  contact_push_pressure(L, push_contact(L, wear, "wear:pressure"), body);
  return 1;
}

/* --- sums over both bodies at the plate's nodes, with the plate at x = 0 ---------------------- */

static arc_depths depths_of(const arc_shape *shape, arc_body body) {
  const arc_profile profile = arc_shape_profile(shape, body);
  return (arc_depths){(size_t)profile.count, profile.x, profile.h};
}

/* wear:combined() returns { x=, h= }, the sum of both depths (Eq. 31 of Mattei and Di Puccio). */
int wear_combined(lua_State *L) {
  const arc_shape *shape = arc_wear_shape(wear_self(L, "wear:combined"));
  model_check_meshed(L, arc_shape_model(shape), "wear:combined");
  return measure_push_combined(L, depths_of(shape, ARC_CYLINDER), depths_of(shape, ARC_PLATE));
}

/* wear:local_partition() returns { x=, value= }, the cylinder's share of the sum of both depths at
 * worn points (Eq. 30 of Mattei and Di Puccio). */
int wear_local_partition(lua_State *L) {
  const arc_shape *shape = arc_wear_shape(wear_self(L, "wear:local_partition"));
  model_check_meshed(L, arc_shape_model(shape), "wear:local_partition");
  return measure_push_partition(L, depths_of(shape, ARC_CYLINDER), depths_of(shape, ARC_PLATE));
}

/* --- smoothness ------------------------------------------------------------------------------- */

/* wear:roughness(body) returns the sawtooth part of the profile divided by the largest depth. */
int wear_roughness(lua_State *L) {
  const arc_wear *wear = wear_self(L, "wear:roughness");
  arc_body body = wear_body(L, wear, "wear:roughness");
  lua_pushnumber(L, arc_wear_roughness(wear, body));
  return 1;
}

/* wear:stability() returns { eigenvalue=, jump_limit= }. Ripples grow if the setting `jump` exceeds
 * jump_limit. */
int wear_stability(lua_State *L) {
  static const char where[] = "wear:stability";
  lua_settop(L, 1);
  box *made = box_self_idle(L, &wear_class, where);
  arc_wear *wear = made->thing;
  arc_error error = {0};
  double eigenvalue = 0;
  const arc_callbacks callbacks = {.stop = interrupt_pending};
  lua_getiuservalue(L, 1, RUN_FUNCTIONS);
  functions_call call = functions_enter(L, 2, made);
  made->busy = RUN_BUSY;
  arc_status status = arc_wear_stability(wear, &callbacks, &eigenvalue, &error);
  made->busy = RUN_IDLE;
  functions_leave(L, &call, where);
  error_check(L, status, &error, where, (lua_Number)arc_wear_last(wear)->update);
  lua_createtable(L, 0, 2);
  array_set_number(L, "eigenvalue", eigenvalue);
  array_set_number(L, "jump_limit", 2 / eigenvalue);
  strict_table(L, "wear:stability");
  return 1;
}

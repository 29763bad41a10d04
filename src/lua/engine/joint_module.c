/* Module `archard.sphere`: functions of the engine for ball-and-socket joints. Only scripts/joint
 * uses this module; it checks the user's arguments. A gait is a flat list with 15 numbers for each
 * increment: rotation matrix (9), rotation vector (3), load (3). */
#include "archard/joint.h"
#include "lua/base/archard.h"
#include "lua/base/array_read.h"
#include "lua/base/box.h"
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"
#include "lua/engine/classes.h"

#include <lauxlib.h>
#include <math.h>
#include <string.h>

enum { numbers = sizeof(arc_gait_instant) / sizeof(double) };

static void destroy(void *thing) {
  arc_joint *joint = thing;
  arc_joint_destroy(&joint);
}

static const box_class sphere_class = {.name = "sphere", .destroy = destroy};

static arc_joint *joint_at(lua_State *L, int index, const char *where) {
  return box_check(L, index, &sphere_class, where)->thing;
}

static double number_of(lua_State *L, const char *name, double otherwise) {
  lua_getfield(L, -1, name);
  const double value = luaL_optnumber(L, -1, otherwise);
  lua_pop(L, 1);
  return value;
}

/* --- definitions ------------------------------------------------------------------------------ */

/* Reads the field `material` of the table on top of the stack. */
static arc_material read_material(lua_State *L) {
  const arc_material usual = arc_material_default();
  lua_getfield(L, -1, "material");
  luaL_checktype(L, -1, LUA_TTABLE);
  const arc_material read = {.E = number_of(L, "E", usual.E), .nu = number_of(L, "nu", usual.nu)};
  lua_pop(L, 1);
  return read;
}

/* Reads the field `layers`, a list of { thickness=, material= }, of the table on top of the
 * stack. */
static void read_layers(lua_State *L, arc_layer *layer) {
  memset(layer, 0, ARC_MOST_LAYERS * sizeof *layer);
  lua_getfield(L, -1, "layers");
  for (int i = 0; i < ARC_MOST_LAYERS && lua_istable(L, -1); i++) {
    lua_rawgeti(L, -1, i + 1);
    if (lua_istable(L, -1)) {
      layer[i].thickness = number_of(L, "thickness", 0);
      layer[i].material = read_material(L);
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

static void read_head(lua_State *L, arc_joint_def *def) {
  lua_getfield(L, 1, "head");
  def->radius = number_of(L, "radius", def->radius);
  def->core = read_material(L);
  read_layers(L, def->head);
  lua_pop(L, 1);
}

static void read_cup(lua_State *L, arc_joint_def *def) {
  lua_getfield(L, 1, "cup");
  def->clearance = number_of(L, "clearance", def->clearance);
  def->inclination = number_of(L, "inclination", def->inclination);
  def->cover = number_of(L, "cover", def->cover);
  read_layers(L, def->cup);
  lua_pop(L, 1);
}

/* create{ head={ radius=, material=, layers= }, cup={ clearance=, inclination=, cover=, layers= },
 * foundation=, order=, mesh={ size= } } returns a joint. */
static int sphere_create(lua_State *L) {
  arc_joint_def def = arc_joint_default();
  arc_error error = {0};
  arc_joint *joint;
  luaL_argexpected(L, lua_istable(L, 1) || lua_isuserdata(L, 1), 1, "joint");
  lua_settop(L, 1);
  read_head(L, &def);
  read_cup(L, &def);
  def.second_order = number_of(L, "order", 1) > 1;
  lua_getfield(L, 1, "mesh");
  def.size = number_of(L, "size", def.size);
  lua_pop(L, 1);
  lua_getfield(L, 1, "foundation");
  def.foundation = (arc_foundation)args_choice(L, -1, (args_location){"joint", ""}, "foundation",
                                               arc_foundation_names, 0);
  lua_pop(L, 1);
  box *made = box_push(L, &sphere_class);
  const arc_status status = arc_joint_create(&def, &joint, &error);
  error_check(L, status, &error, "joint", -1);
  made->thing = joint;
  box_weigh(L, arc_joint_bytes(joint));
  return 1;
}

/* --- gaits ------------------------------------------------------------------------------------ */

static int push_gait(lua_State *L, const arc_gait_instant *gait, int n) {
  array_push(L, gait->rotation, (size_t)n * numbers);
  return 1;
}

static arc_gait_instant *gait_buffer(lua_State *L, int n) {
  return (arc_gait_instant *)array_buffer(L, (size_t)n * numbers);
}

static int increments(lua_State *L, int index) {
  const lua_Integer n = luaL_checkinteger(L, index);
  luaL_argcheck(L, n >= 1 && n <= 100000, index, "expected 1 to 100000");
  return (int)n;
}

/* named(name, increments, angle, load) returns a built-in gait. Only some gaits use `angle`
 * [degree] and `load` [N]. */
static int sphere_named(lua_State *L) {
  arc_error error = {0};
  const int n = increments(L, 2);
  const double angle = luaL_optnumber(L, 3, 0), load = luaL_optnumber(L, 4, 0);
  arc_gait_instant *gait = gait_buffer(L, n);
  const arc_status status = arc_gait_named(luaL_checkstring(L, 1), n, angle, load, gait, &error);
  error_check(L, status, &error, "gait", -1);
  return push_gait(L, gait, n);
}

static double *list_at(lua_State *L, int index, const char *name, size_t expected) {
  size_t count;
  lua_pushvalue(L, index);
  double *list = array_read(L, (args_location){"gait", ""}, name, &count);
  if (count != expected)
    error_raise(L, ARC_ARGUMENT, "gait", "field '%s': expected %d numbers, got %d", name,
                (int)expected, (int)count);
  return list;
}

/* angles(increments, { flexion, adduction, rotation, ... }, { Fx, Fy, Fz, ... }, order) returns a
 * gait from joint angles [degree] and loads [N]. */
static int sphere_angles(lua_State *L) {
  arc_error error = {0};
  const int n = increments(L, 1);
  const double *angle = list_at(L, 2, "angles", 3 * (2 * (size_t)n + 1));
  const double *load = list_at(L, 3, "load", 3 * (size_t)n);
  arc_gait_instant *gait = gait_buffer(L, n);
  const arc_status status =
      arc_gait_from_angles(n, angle, load, luaL_checkstring(L, 4), gait, &error);
  error_check(L, status, &error, "gait", -1);
  return push_gait(L, gait, n);
}

static const arc_gait_instant *read_gait(lua_State *L, int index, int *n) {
  size_t count;
  lua_pushvalue(L, index);
  const double *list = array_read(L, (args_location){"wear", ""}, "loading", &count);
  *n = (int)(count / numbers);
  return (const arc_gait_instant *)(const void *)list;
}

/* path(gait, radius) returns, for one cycle, the length of the path of the load over the head [mm],
 * and the friction work divided by the coefficient of friction [N mm]. */
static int sphere_path(lua_State *L) {
  int n;
  const arc_gait_instant *gait = read_gait(L, 1, &n);
  lua_pushnumber(L, arc_gait_track(n, gait, luaL_checknumber(L, 2)));
  lua_pushnumber(L, arc_gait_work(n, gait, luaL_checknumber(L, 2)));
  return 2;
}

/* --- contact ---------------------------------------------------------------------------------- */

/* press(joint, Fx, Fy, Fz, rotation) solves a contact under the load [N] and returns { p_max=, ...
 * }. `rotation` is the rotation matrix of the head, or nil. */
static int sphere_press(lua_State *L) {
  arc_joint *joint = joint_at(L, 1, "contact");
  const double load[] = {luaL_checknumber(L, 2), luaL_checknumber(L, 3), luaL_checknumber(L, 4)};
  const arc_callbacks callbacks = {.stop = interrupt_pending};
  const double *rotation = lua_istable(L, 5) ? list_at(L, 5, "rotation", 9) : NULL;
  arc_joint_contact c;
  arc_error error = {0};
  const arc_status status = arc_joint_press(joint, rotation, load, &callbacks, &c, &error);
  error_check(L, status, &error, "contact", -1);
  lua_createtable(L, 0, 9);
  array_set_number(L, "p_max", c.p_max);
  array_set_number(L, "p_center", c.p_center);
  array_set_number(L, "area", c.area);
  array_set_number(L, "half_angle", c.half_angle);
  array_set_number(L, "normal_force", c.normal_force);
  array_set_number(L, "rim_margin", c.rim_margin);
  array_set_number(L, "iterations", c.iterations);
  array_set(L, "approach", c.approach, 3);
  return 1;
}

/* --- maps ------------------------------------------------------------------------------------- */

static size_t sites_of(const arc_joint *joint) {
  return 2 * (size_t)arc_joint_rows(joint) * (size_t)arc_joint_rows(joint);
}

/* map(joint, quantity) returns the number of rows of a grid, and a flat list of the values in its
 * cells, row by row. The number of cells in a row is twice the number of rows. */
static int sphere_map(lua_State *L) {
  static const char *const what[] = {"head", "cup", "pressure", "cross shear", "creep", NULL};
  const arc_joint *joint = joint_at(L, 1, "map");
  const int which = luaL_checkoption(L, 2, NULL, what);
  const double *values = which == 2 ? arc_joint_pressure(joint) : NULL;
  if (which < 2) values = arc_joint_depth(joint, which == 0 ? ARC_UPPER : ARC_LOWER);
  if (which == 4) values = arc_joint_creep(joint);
  if (which == 3) {
    double *share = array_buffer(L, sites_of(joint));
    arc_joint_cross_shear(joint, share);
    values = share;
  }
  lua_pushinteger(L, arc_joint_rows(joint));
  array_push(L, values, sites_of(joint));
  return 2;
}

/* set(joint, "head" or "cup", depths) sets the wear depths of this body [mm]. */
static int sphere_set(lua_State *L) {
  static const char *const body[] = {"head", "cup", NULL};
  arc_error error = {0};
  arc_joint *joint = joint_at(L, 1, "wear");
  const int which = luaL_checkoption(L, 2, NULL, body);
  const double *depth = list_at(L, 3, "worn", sites_of(joint));
  const arc_status status =
      arc_joint_set_depth(joint, which == 0 ? ARC_UPPER : ARC_LOWER, depth, &error);
  error_check(L, status, &error, "wear", -1);
  return 0;
}

/* --- wear ------------------------------------------------------------------------------------- */

/* Data for calls of the user's functions: their stack indices, and a description of the function
 * that failed (NULL: none). */
typedef struct called {
  lua_State *L;
  int k, alpha, creep;
  double thickness; /* [mm] thickness of the cup's first layer */
  const char *failed;
} called;

/* Pushes a function and its argument table. Returns 0 without pushing if a function has already
 * failed. */
static int push_function(called *c, int function, double cycles) {
  if (c->failed) return 0;
  lua_pushvalue(c->L, function);
  lua_createtable(c->L, 0, 3);
  array_set_number(c->L, "cycle", cycles);
  return 1;
}

static double call_pushed(called *c, const char *name) {
  if (error_pcall(c->L, 1, 1) != LUA_OK) c->failed = name;
  if (!c->failed && lua_type(c->L, -1) != LUA_TNUMBER) {
    lua_pushfstring(c->L, "expected a number, got %s", luaL_typename(c->L, -1));
    c->failed = name;
  }
  if (c->failed) return NAN;
  const double value = lua_tonumber(c->L, -1);
  lua_pop(c->L, 1);
  return value;
}

static double coefficient(void *context, double cross_shear, double p_mean, double cycles) {
  called *c = context;
  if (!push_function(c, c->k, cycles)) return NAN;
  array_set_number(c->L, "cross_shear", cross_shear);
  array_set_number(c->L, "p_mean", p_mean);
  return call_pushed(c, "the function k");
}

static double share_of_head(void *context, double cycles) {
  called *c = context;
  return push_function(c, c->alpha, cycles) ? call_pushed(c, "the function alpha") : NAN;
}

static double creep_of(void *context, double p_mean, double cycles) {
  called *c = context;
  if (!push_function(c, c->creep, cycles)) return NAN;
  array_set_number(c->L, "thickness", c->thickness);
  array_set_number(c->L, "p_mean", p_mean);
  return call_pushed(c, "the function creep");
}

/* Names of the fields of a record, in the order of push_record. */
static const char *const record_names[] = {"cycles",     "updates", "solutions", "volume_head",
                                           "volume_cup", "p_peak",  "area",      "work",
                                           "rim_margin", NULL};

static void read_record(lua_State *L, int index, arc_joint_record *r) {
  lua_pushvalue(L, index);
  r->cycles = number_of(L, "cycles", 0);
  r->updates = (int)number_of(L, "updates", 0);
  r->solutions = (int)number_of(L, "solutions", 0);
  r->volume[ARC_UPPER] = number_of(L, "volume_head", 0);
  r->volume[ARC_LOWER] = number_of(L, "volume_cup", 0);
  lua_pop(L, 1);
}

static int push_record(lua_State *L, const arc_joint_record *r) {
  const double value[] = {
      r->cycles, r->updates, r->solutions, r->volume[ARC_UPPER], r->volume[ARC_LOWER],
      r->p_peak, r->area,    r->work,      r->rim_margin};
  lua_createtable(L, 0, 10);
  for (int i = 0; record_names[i]; i++) array_set_number(L, record_names[i], value[i]);
  array_set(L, "penetration", r->penetration, 3);
  return 1;
}

/* State of a call of sphere_update or sphere_advance. The Lua arguments of these functions are
 * (joint, gait, k, alpha, cycles, record, ..., creep). */
typedef struct worn {
  box *holder;
  arc_joint_wear_def def;
  called functions;
  arc_joint_record record;
  double cycles;
  size_t bytes; /* [bytes] size of the joint in memory before the update */
} worn;

static const arc_callbacks interruptible = {.stop = interrupt_pending};

static void begin_wear(lua_State *L, worn *w, int arguments) {
  *w = (worn){.holder = box_check(L, 1, &sphere_class, "wear"),
              .functions = {.L = L, .k = 3, .alpha = 4, .creep = arguments},
              .cycles = luaL_checknumber(L, 5)};
  lua_settop(L, arguments);
  read_record(L, 6, &w->record);
  w->def.instant = read_gait(L, 2, &w->def.instants);
  w->functions.thickness = arc_joint_definition(w->holder->thing)->cup[0].thickness;
  w->def.context = &w->functions;
  w->def.k_function = lua_isfunction(L, 3) ? coefficient : NULL;
  w->def.alpha_function = lua_isfunction(L, 4) ? share_of_head : NULL;
  w->def.creep = lua_isfunction(L, arguments) ? creep_of : NULL;
  if (!w->def.k_function) w->def.k = luaL_checknumber(L, 3);
  if (!w->def.alpha_function) w->def.alpha = luaL_checknumber(L, 4);
  if (w->holder->busy) error_raise(L, ARC_ARGUMENT, "wear", "this joint is already running");
  w->holder->busy = 1;
  w->bytes = arc_joint_bytes(w->holder->thing);
}

static int end_wear(lua_State *L, worn *w, arc_status status, arc_error *error) {
  const size_t bytes = arc_joint_bytes(w->holder->thing);
  w->holder->busy = 0;
  if (bytes > w->bytes)
    box_weigh(L, bytes - w->bytes); /* the update has allocated larger contact arrays */
  if (w->functions.failed) error_callback(L, "wear", w->functions.failed);
  error_check(L, status, error, "wear", -1);
  return push_record(L, &w->record);
}

/* update(joint, gait, k, alpha, cycles, record, explicit, creep) wears the joint by one update of
 * `cycles` cycles and returns the new record. `explicit` is true for the explicit scheme. */
static int sphere_update(lua_State *L) {
  worn w;
  arc_error error = {0};
  begin_wear(L, &w, 8);
  w.def.explicit_scheme = lua_toboolean(L, 7);
  const arc_status status =
      arc_joint_update(w.holder->thing, &w.def, w.cycles, &interruptible, &w.record, &error);
  return end_wear(L, &w, status, &error);
}

/* advance(joint, gait, k, alpha, most, record, tolerance, step, creep) wears the joint by one step
 * of at most `most` cycles, whose length is chosen by error control. Returns the new record and the
 * length of the next step [cycles]. */
static int sphere_advance(lua_State *L) {
  worn w;
  arc_error error = {0};
  const double tolerance = luaL_checknumber(L, 7);
  double step = luaL_checknumber(L, 8);
  begin_wear(L, &w, 9);
  const arc_status status = arc_joint_advance(w.holder->thing, &w.def, tolerance, w.cycles, &step,
                                              &interruptible, &w.record, &error);
  end_wear(L, &w, status, &error);
  lua_pushnumber(L, step);
  return 2;
}

/* state(joint) returns the state of the joint as a list of numbers. set_state(joint, list) restores
 * this state. */
static int sphere_state(lua_State *L) {
  const arc_joint *joint = joint_at(L, 1, "wear");
  const size_t count = arc_joint_state_count(joint);
  double *state = array_buffer(L, count);
  arc_joint_state(joint, state);
  array_push(L, state, count);
  return 1;
}

static int sphere_set_state(lua_State *L) {
  arc_error error = {0};
  size_t count;
  arc_joint *joint = joint_at(L, 1, "joint.open");
  lua_settop(L, 2);
  const double *state = array_read_any(L, (args_location){"joint.open", ""}, "state", &count);
  error_check(L, arc_joint_set_state(joint, state, count, &error), &error, "joint.open", -1);
  return 0;
}

/* limit(joint, gait, k) returns the largest stable length of an explicit update [cycles]. */
static int sphere_limit(lua_State *L) {
  arc_joint_wear_def def = {.k = luaL_checknumber(L, 3)};
  const arc_joint *joint = joint_at(L, 1, "wear");
  def.instant = read_gait(L, 2, &def.instants);
  lua_pushnumber(L, arc_joint_explicit_limit(joint, &def));
  return 1;
}

/* sensitivity(run, options) returns the sensitivities of the results of a joint's run. */
static int sphere_sensitivity(lua_State *L) {
  lua_settop(L, 2);
  script_require(L, "archard.uncertainty.sensitivity");
  lua_insert(L, 1);
  lua_call(L, 2, 1);
  return 1;
}

static int has_field(lua_State *L, const char *name) {
  lua_pushstring(L, name);
  const int has = lua_rawget(L, -2) != LUA_TNIL;
  lua_pop(L, 1);
  return has;
}

/* Returns true if the value on top of the stack is a joint, or a table of the fields of a joint.
 * Replaces such a table by a joint. */
static int is_joint(lua_State *L) {
  if (luaL_getmetafield(L, -1, "__name") != LUA_TNIL) {
    const int is = lua_type(L, -1) == LUA_TSTRING && strcmp(lua_tostring(L, -1), "joint") == 0;
    lua_pop(L, 1);
    return is;
  }
  if (!lua_istable(L, -1)) return 0;
  if (!has_field(L, "cup") && !has_field(L, "head")) return 0;
  script_require(L, "archard.joint.joint");
  lua_insert(L, -2);
  lua_call(L, 1, 1);
  return 1;
}

int joint_takes(lua_State *L, const char *method) {
  if (!lua_istable(L, 1)) return 0;
  lua_pushliteral(L, "model");
  lua_rawget(L, 1);
  if (!is_joint(L)) {
    lua_settop(L, 1);
    return 0;
  }
  lua_settop(L, 2);
  lua_getfield(L, 2, method);
  lua_insert(L, 2);
  args_push_copy(L, 1);
  lua_pushnil(L);
  lua_setfield(L, -2, "model");
  lua_call(L, 2, 1);
  return 1;
}

int luaopen_archard_sphere(lua_State *L) {
  static const luaL_Reg functions[] = {{"create", sphere_create},
                                       {"named", sphere_named},
                                       {"angles", sphere_angles},
                                       {"path", sphere_path},
                                       {"press", sphere_press},
                                       {"map", sphere_map},
                                       {"set", sphere_set},
                                       {"update", sphere_update},
                                       {"limit", sphere_limit},
                                       {"advance", sphere_advance},
                                       {"state", sphere_state},
                                       {"set_state", sphere_set_state},
                                       {"sensitivity", sphere_sensitivity},
                                       {NULL, NULL}};
  call_new_library(L, functions);
  return 1;
}

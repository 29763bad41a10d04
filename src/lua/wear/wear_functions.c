/* Stores and calls the functions that the user set in the definition of a run, and handles their
 * errors. */
#include "lua/wear/wear_functions.h"
#include "lua/base/array.h"
#include "lua/base/error.h"

#include <stdio.h>
#include <string.h>

/* Indices of the user values of the holder, a userdata that stores the functions of a run. During a
 * call the values on the stack have the same order. The index of a function is its index in
 * arc_wear_settings plus 1. Then the state object and the error value follow. */
enum {
  LOCAL = ARC_AT_local_factor + 1,
  STATE = ARC_WEAR_SETTINGS_COUNT + 1,
  ERROR,
  PLACES = ERROR
};

static int place_of(const arc_setting *setting) {
  return (int)(setting - arc_wear_settings) + 1;
}

typedef struct wear_functions {
  functions_place now;
  callback_state *state;
  int vector;     /* true: local_factor is called once with arrays of all nodes */
  char what[200]; /* description of the call that failed, for the error message */
} wear_functions;

static const char kind[] = "archard.functions";

/* --- calls ------------------------------------------------------------------------------------ */

static lua_State *begin(wear_functions *f, const arc_wear_record *state, callback_state *before) {
  const box *run = f->now.run;
  *before = *f->state;
  f->state->record = state;
  f->state->pair = run ? arc_model_definition(arc_wear_model(run->thing)) : f->now.pair;
  if (f->now.run) f->now.run->busy = RUN_IN_STEP;
  return f->now.L;
}

static void end(wear_functions *f, int top, callback_state before) {
  *f->state = before;
  if (f->now.run) f->now.run->busy = RUN_BUSY;
  lua_settop(f->now.L, top);
}

/* Stores the error value on top of the stack in the holder. */
static arc_status fail(wear_functions *f) {
  lua_setiuservalue(f->now.L, f->now.at, ERROR);
  f->now.failed = 1;
  return ARC_CALLBACK;
}

static void name_call(wear_functions *f, const char *name, const arc_wear_record *state) {
  snprintf(f->what, sizeof f->what, "%s(state at distance %.6g mm, cycle %.6g)", name,
           state->distance, state->cycle);
}

/* Calls a function of the user with the state object as argument. The function must return a
 * number. */
static arc_status ask(void *context, const arc_setting *what, const arc_wear_record *state,
                      double *value) {
  wear_functions *f = context;
  callback_state before;
  lua_State *L = begin(f, state, &before);
  const int top = lua_gettop(L);
  arc_status status = ARC_OK;
  lua_pushvalue(L, f->now.at + place_of(what));
  lua_pushvalue(L, f->now.at + STATE);
  int called = error_pcall(L, 1, 1);
  if (called != LUA_OK || lua_type(L, -1) != LUA_TNUMBER) {
    name_call(f, what->name, state);
    if (called == LUA_OK) lua_pushfstring(L, "expected a number, got %s", luaL_typename(L, -1));
    status = fail(f);
  } else {
    *value = lua_tonumber(L, -1);
  }
  end(f, top, before);
  return status;
}

/* --- local factors ---------------------------------------------------------------------------- */

typedef struct local_call {
  wear_functions *held;
  arc_body body;
  int n, at; /* number of nodes; `at`: index of the present node, or -1 for all nodes */
  const double *x, *z, *p; /* z is NULL in two dimensions */
  double *factor;
} local_call;

/* Computes the local factors by one call of the user's function for each node. Nodes without
 * pressure do not wear and are omitted. The stack contains the function and the state. */
static int each_node(lua_State *L) {
  local_call *call = lua_touserdata(L, 3);
  lua_pushstring(L, body_names[call->body]);
  for (int i = 0; i < call->n; i++) {
    if (!(call->p[i] > 0)) continue;
    call->at = i;
    lua_pushvalue(L, 1);
    lua_pushvalue(L, 4);
    lua_pushnumber(L, call->x[i]);
    lua_pushnumber(L, call->p[i]);
    lua_pushvalue(L, 2);
    if (call->z) lua_pushnumber(L, call->z[i]);
    lua_call(L, call->z ? 5 : 4, 1);
    if (lua_type(L, -1) != LUA_TNUMBER)
      return luaL_error(L, "expected a number, got %s", luaL_typename(L, -1));
    call->factor[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return 0;
}

/* Pushes the list of the values at the nodes under pressure. */
static void push_loaded(lua_State *L, const local_call *call, const double *values) {
  lua_Integer count = 0;
  int loaded = 0;
  for (int i = 0; i < call->n; i++) loaded += call->p[i] > 0;
  lua_createtable(L, loaded, 0);
  for (int i = 0; i < call->n; i++) {
    if (!(call->p[i] > 0)) continue;
    lua_pushnumber(L, values[i]);
    lua_rawseti(L, -2, ++count);
  }
}

/* Computes the local factors by one call of the user's function for all nodes under pressure. The
 * stack contains the function and the state. */
static int all_nodes(lua_State *L) {
  local_call *call = lua_touserdata(L, 3);
  lua_pushvalue(L, 1);
  lua_pushstring(L, body_names[call->body]);
  push_loaded(L, call, call->x);
  push_loaded(L, call, call->p);
  lua_pushvalue(L, 2);
  if (call->z) push_loaded(L, call, call->z);
  lua_call(L, call->z ? 5 : 4, 1);
  if (!lua_istable(L, -1))
    return luaL_error(L, "expected an array of factors, got %s", luaL_typename(L, -1));
  lua_Integer at = 0;
  for (int i = 0; i < call->n; i++) {
    if (!(call->p[i] > 0)) continue;
    if (lua_rawgeti(L, -1, ++at) != LUA_TNUMBER)
      return luaL_error(L, "expected one number for each x, got %s for x[%d]", luaL_typename(L, -1),
                        (int)at);
    call->factor[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return 0;
}

static void name_local_call(const local_call *call, const arc_wear_record *state) {
  wear_functions *f = call->held;
  if (call->at < 0)
    snprintf(f->what, sizeof f->what,
             "local_factor.vector(\"%s\", xs, ps, state at distance %.6g mm)",
             body_names[call->body], state->distance);
  else
    snprintf(f->what, sizeof f->what,
             "local_factor(\"%s\", x = %.6g mm, p = %.6g MPa, state at distance %.6g mm)",
             body_names[call->body], call->x[call->at], call->p[call->at], state->distance);
}

static arc_status call_local_factor(void *context, arc_body body, int n, const double *x,
                                    const double *z, const double *p, const arc_wear_record *state,
                                    double *factor) {
  wear_functions *f = context;
  local_call call = {f, body, n, -1, x, z, p, factor};
  callback_state before;
  lua_State *L = begin(f, state, &before);
  const int top = lua_gettop(L);
  arc_status status = ARC_OK;
  lua_pushcfunction(L, f->vector ? all_nodes : each_node);
  lua_pushvalue(L, f->now.at + LOCAL);
  lua_pushvalue(L, f->now.at + STATE);
  lua_pushlightuserdata(L, &call);
  if (error_pcall(L, 3, 0) != LUA_OK) {
    name_local_call(&call, state);
    status = fail(f);
  }
  end(f, top, before);
  return status;
}

/* --- calls of the engine ---------------------------------------------------------------------- */

static functions_call enter(lua_State *L, int holder, box *run, const arc_model_def *pair) {
  wear_functions *f = lua_touserdata(L, holder);
  functions_call call = {f, {0}};
  if (!f) return call;
  luaL_checkstack(L, PLACES + 20, "functions of a run");
  lua_pushvalue(L, holder);
  call.outer = f->now;
  f->now = (functions_place){L, run, pair, lua_gettop(L), 0};
  for (int location = 1; location <= STATE; location++) lua_getiuservalue(L, f->now.at, location);
  return call;
}

functions_call functions_enter(lua_State *L, int holder, box *run) {
  return enter(L, holder, run, NULL);
}

functions_call functions_enter_making(lua_State *L, int holder, const arc_model_def *pair) {
  return enter(L, holder, NULL, pair);
}

int functions_failed(const functions_call *call) {
  return call->held && call->held->now.failed;
}

void functions_leave(lua_State *L, functions_call *call, const char *where) {
  wear_functions *f = call->held;
  if (!f) return;
  const int failed = f->now.failed;
  if (failed) {
    lua_getiuservalue(L, f->now.at, ERROR);
    lua_pushnil(L);
    lua_setiuservalue(L, f->now.at, ERROR);
  }
  f->now = call->outer;
  if (failed) error_callback(L, where, f->what);
}

/* --- the object that stores the functions ----------------------------------------------------- */

static wear_functions *push_holder(lua_State *L) {
  wear_functions *f = lua_newuserdatauv(L, sizeof *f, PLACES);
  memset(f, 0, sizeof *f);
  luaL_newmetatable(L, kind);
  lua_setmetatable(L, -2);
  f->state = state_push(L);
  lua_setiuservalue(L, -2, STATE);
  return f;
}

/* Pushes the function f of local_factor = { vector = f }. Raises an error if f is not a
 * function. */
static void push_vector(lua_State *L, args_location location) {
  static const arc_setting names[] = {ARGS_OTHER("vector"), {.name = NULL}};
  char prefix[60];
  snprintf(prefix, sizeof prefix, "%slocal_factor.", location.prefix);
  args_location inside = {location.where, prefix};
  args_check_names(L, -1, inside, names);
  if (lua_getfield(L, -1, "vector") != LUA_TFUNCTION)
    args_refuse(L, inside, "vector", "a function(body, xs, ps, state, zs)");
}

/* Pushes the user's function for a setting, or nil. Returns 0 if the table at `index` does not
 * contain the setting. */
static int push_given(lua_State *L, int index, const arc_setting *s, args_location location,
                      int *vector) {
  const int type = args_get(L, index, s->name), local = place_of(s) == LOCAL;
  if (type == LUA_TNIL || type == LUA_TFUNCTION) return type != LUA_TNIL;
  if (local && type == LUA_TTABLE) {
    push_vector(L, location);
    *vector = 1;
  } else if (local && !(type == LUA_TBOOLEAN && !lua_toboolean(L, -1))) {
    char expected[160];
    args_refuse(L, location, s->name, arc_setting_expected(s, expected, sizeof expected));
  } else {
    lua_pushnil(L);
  }
  return 1;
}

/* Sets the function pointer of a setting in the definition. The pointer is NULL if the user gave
 * no function. */
static void set_pointer(const arc_setting *s, int given, arc_wear_def *def) {
  if (place_of(s) == LOCAL)
    def->local_factor = given ? call_local_factor : NULL;
  else
    *(arc_state_fn *)(void *)((char *)def + s->function) = given ? ask : NULL;
}

void functions_read(lua_State *L, int index, int previous, args_location location,
                    arc_wear_def *def) {
  const wear_functions *before = previous ? lua_touserdata(L, previous) : NULL;
  luaL_checkstack(L, 16, location.where);
  wear_functions *f = push_holder(L);
  int holder = lua_gettop(L), any = 0;
  for (const arc_setting *s = arc_wear_settings; s->name; s++) {
    if (!(s->forms & ARC_FUNCTION)) continue;
    int vector = 0;
    if (!push_given(L, index, s, location, &vector) && before) {
      lua_getiuservalue(L, previous, place_of(s));
      vector = before->vector;
    }
    const int given = lua_isfunction(L, -1);
    if (place_of(s) == LOCAL) f->vector = vector;
    any = any || given;
    set_pointer(s, given, def);
    lua_setiuservalue(L, holder, place_of(s));
    lua_settop(L, holder);
  }
  def->context = any ? f : NULL;
  if (any) return;
  lua_pop(L, 1);
  lua_pushnil(L);
}

void functions_push(lua_State *L, int holder, const char *field) {
  const arc_setting *s = arc_setting_find(arc_wear_settings, field);
  if (s && lua_touserdata(L, holder))
    lua_getiuservalue(L, holder, place_of(s));
  else
    lua_pushnil(L);
}

void functions_push_names(lua_State *L, const arc_wear_def *def) {
  int count = 0;
  lua_newtable(L);
  for (const arc_setting *s = arc_wear_settings; s->name; s++) {
    if (!arc_setting_has_function(s, def)) continue;
    lua_pushstring(L, s->name);
    lua_rawseti(L, -2, ++count);
  }
}

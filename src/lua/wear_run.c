/* Class wear: stepping, running, progress and interruption. */
#include "lua/error.h"
#include "lua/interrupt.h"
#include "lua/wear.h"

#include <math.h>

static lua_Number next_update(const arc_wear *wear) {
  return (lua_Number)arc_wear_last(wear)->update + 1;
}

/* --- step ------------------------------------------------------------------------------------ */

static int count_argument(lua_State *L, int index, const char *where) {
  static const args_field count = {.name = "n", .kind = ARGS_WHOLE, .low = 1, .high = 1e9};
  if (lua_isnoneornil(L, index)) return 1;
  lua_settop(L, index);
  double value = args_number(L, (args_place){where, ""}, &count);
  if (value != floor(value)) args_refuse(L, (args_place){where, ""}, "n", "a whole number");
  return (int)value;
}

/* Pushes the record after `steps` updates from row `first` of the history on. */
static void push_progress(lua_State *L, const arc_wear *wear, size_t first) {
  size_t count;
  const arc_wear_record *records = arc_wear_history(wear, &count);
  if (count - first > 1)
    record_push_lines(L, records + first, count - first);
  else
    record_push_line(L, arc_wear_last(wear));
  record_push(L, arc_wear_last(wear));
}

/* wear:step(n) -> the last record; nothing happens at the end of the distance */
int wear_step(lua_State *L) {
  static const char where[] = "wear:step";
  box *made = box_self_idle(L, &wear_class, where);
  arc_wear *wear = made->thing;
  int steps = count_argument(L, 2, where);
  size_t first;
  arc_wear_history(wear, &first);
  arc_error error = {0};
  for (int i = 0; i < steps; i++) {
    double before = arc_wear_last(wear)->distance;
    arc_status status = arc_wear_step(wear, interrupt_pending, NULL, &error);
    error_check(L, status, &error, where, next_update(wear));
    if (arc_wear_last(wear)->distance <= before) break;
    if (interrupt_pending(NULL)) error_check(L, ARC_STOPPED, &error, where, -1);
  }
  push_progress(L, wear, first);
  return 1;
}

/* --- run ------------------------------------------------------------------------------------- */

/* What the engine hands back to on_progress. The run's object stands at index 1. */
typedef struct run_call {
  lua_State *L;
  int function; /* index of the progress function; 0: none */
  int asked;    /* it asked to stop */
  int failed;   /* it raised the error on top of the stack */
} run_call;

static int on_progress(void *context, const arc_wear *wear) {
  (void)wear;
  run_call *call = context;
  lua_State *L = call->L;
  if (!call->function) return 0;
  lua_pushvalue(L, call->function);
  lua_pushvalue(L, 1);
  call->failed = error_pcall(L, 1, 1) != LUA_OK;
  if (call->failed) return 1;
  call->asked = lua_toboolean(L, -1);
  lua_pop(L, 1);
  return call->asked;
}

typedef struct run_def {
  double distance, cycles;
} run_def;

static const args_field definition[] = {
    ARGS_ABOVE(run_def, "distance", distance, 0),
    ARGS_ABOVE(run_def, "cycles", cycles, 0),
    ARGS_OTHER("progress"),
    {.name = NULL},
};

/* The distance to run to [mm], from the start. */
static double read_goal(lua_State *L, const arc_wear *wear) {
  static const char where[] = "wear:run";
  const arc_wear_def *def = arc_wear_definition(wear);
  run_def run = {0, 0};
  args_read(L, 2, (args_place){where, ""}, definition, &run);
  if (run.distance > 0 && run.cycles > 0)
    error_raise(L, ARC_ARGUMENT, where,
                "fields 'distance' and 'cycles': expected one of them, got both");
  if (run.cycles > 0) run.distance = run.cycles * arc_wear_strokes(wear) * def->stroke;
  if (run.distance <= 0) return def->distance;
  double covered = arc_wear_last(wear)->distance;
  if (run.distance < covered)
    error_raise(L, ARC_ARGUMENT, where,
                "the run is at %s mm already, beyond %s mm (both counted from its start)",
                args_show_number(L, covered), args_show_number(L, run.distance));
  return run.distance;
}

/* Pushes what draws the progress of a run to `goal`, or nil: archard.run_progress decides. */
static void push_display(lua_State *L, double goal) {
  lua_getglobal(L, "require");
  lua_pushliteral(L, "archard.run_progress");
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) {
    lua_pushvalue(L, 1);
    lua_pushnumber(L, goal);
    if (lua_pcall(L, 2, 1, 0) == LUA_OK) return;
  }
  lua_pop(L, 1);
  lua_pushnil(L); /* a run does not fail for want of a display */
}

/* Pushes the progress function; returns its index, or 0 where there is none. */
static int push_progress_function(lua_State *L, double goal) {
  int type = args_get(L, 2, "progress");
  if (type == LUA_TFUNCTION) return lua_gettop(L);
  if (type != LUA_TNIL && type != LUA_TBOOLEAN)
    args_refuse(L, (args_place){"wear:run", ""}, "progress",
                "a function of the wear object, true or false");
  if (type == LUA_TBOOLEAN && !lua_toboolean(L, -1)) return 0;
  push_display(L, goal);
  return lua_isfunction(L, -1) ? lua_gettop(L) : 0;
}

/* Calls the function on top of the stack, even where an interrupt is about to end everything: its
 * hook rests meanwhile. */
static void call_undisturbed(lua_State *L) {
  lua_Hook hook = lua_gethook(L);
  int mask = lua_gethookmask(L), count = lua_gethookcount(L);
  if (hook) lua_sethook(L, NULL, 0, 0);
  lua_pcall(L, 0, 0, 0);
  if (hook) lua_sethook(L, hook, mask, count);
}

/* A display of our own is told that the run is over, however it ended. */
static void end_display(lua_State *L, const run_call *call) {
  int top = lua_gettop(L);
  if (call->function && args_get(L, 2, "progress") != LUA_TFUNCTION) {
    lua_pushvalue(L, call->function);
    call_undisturbed(L);
  }
  lua_settop(L, top);
}

/* wear:run{ distance=, cycles=, progress= } -> the object itself */
int wear_run(lua_State *L) {
  static const char where[] = "wear:run";
  arc_error error = {0};
  lua_settop(L, 2);
  box *made = box_self_idle(L, &wear_class, where);
  arc_wear *wear = made->thing;
  double goal = read_goal(L, wear);
  run_call call = {.L = L, .function = push_progress_function(L, goal)};
  luaL_checkstack(L, 12, where);
  made->busy = 1;
  arc_status status = arc_wear_run(wear, goal, interrupt_pending, on_progress, &call, &error);
  made->busy = 0;
  end_display(L, &call);
  if (call.failed) error_callback(L, where, "progress");
  if (!(status == ARC_STOPPED && call.asked))
    error_check(L, status, &error, where, next_update(wear));
  lua_settop(L, 1);
  return 1;
}

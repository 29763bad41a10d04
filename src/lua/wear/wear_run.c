/* Class wear: methods that compute steps and runs, show progress and handle interrupts. */
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

static lua_Number next_update(const arc_wear *wear) {
  return (lua_Number)arc_wear_last(wear)->update + 1;
}

/* --- interruption ----------------------------------------------------------------------------- */

/* Raises "interrupted" after Ctrl-C. The message contains the position of the run, because the
 * progress bar with this position was erased. */
static void refuse_interrupted(lua_State *L, const arc_wear *wear) {
  char text[120];
  const arc_wear_record *last = arc_wear_last(wear);
  lua_getfield(L, LUA_REGISTRYINDEX, INTERRUPT_PROMPT);
  const char *after = lua_toboolean(L, -1) ? " (w:run() continues)" : "";
  lua_pop(L, 1);
  snprintf(text, sizeof text, "cycle %.10g, %.6g of %.6g mm%s", last->cycle, last->distance,
           arc_wear_definition(wear)->distance, after);
  interrupt_raise(L, text);
}

static void check_ended(lua_State *L, const arc_wear *wear, arc_status status,
                        const arc_error *error, const char *where) {
  if (status == ARC_STOPPED && interrupt_pending(NULL)) refuse_interrupted(L, wear);
  error_check(L, status, error, where, next_update(wear));
}

/* --- step ------------------------------------------------------------------------------------- */

static int count_argument(lua_State *L, int index, const char *where) {
  static const arc_setting count = {.name = "n", .kind = ARC_WHOLE, .low = 1, .high = 1e9};
  if (lua_isnoneornil(L, index)) return 1;
  lua_settop(L, index);
  double value = args_number(L, (args_location){where, ""}, &count);
  if (value != floor(value)) args_refuse(L, (args_location){where, ""}, "n", "a whole number");
  return (int)value;
}

/* Pushes the last record. The text of the record shows the updates of this call, which are the rows
 * of the history from row `first` on. */
static void push_progress(lua_State *L, const arc_wear *wear, size_t first) {
  size_t count;
  const arc_wear_record *records = arc_wear_history(wear, &count);
  if (count - first > 1)
    record_push_lines(L, records + first, count - first);
  else
    record_push_line(L, arc_wear_last(wear));
  record_push(L, arc_wear_last(wear));
}

static void warn(void *context, const char *text) {
  lua_warning(context, text, 0);
}

/* Computes one step of the engine with the functions of the run at index 1. */
static void step_once(lua_State *L, box *made, const char *where) {
  arc_wear *wear = made->thing;
  const arc_callbacks callbacks = {.stop = interrupt_pending, .warn = warn, .context = L};
  arc_error error = {0};
  lua_getiuservalue(L, 1, RUN_FUNCTIONS);
  functions_call call = functions_enter(L, lua_gettop(L), made);
  made->busy = RUN_BUSY;
  arc_status status = arc_wear_step(wear, &callbacks, &error);
  made->busy = RUN_IDLE;
  functions_leave(L, &call, where);
  check_ended(L, wear, status, &error, where);
  lua_settop(L, 2);
}

/* Warns that wear:step had no effect, because the run has reached the end of its distance. */
static void warn_finished(lua_State *L, const arc_wear *wear) {
  char text[160];
  snprintf(text, sizeof text,
           "wear:step: nothing to do: the run has reached its distance of %.10g mm; "
           "extend it by w:set{ distance = ... }",
           arc_wear_definition(wear)->distance);
  lua_warning(L, text, 0);
}

/* wear:step(n) computes n steps and returns the last record. If the run has reached the end of its
 * distance, the call has no effect. */
int wear_step(lua_State *L) {
  static const char where[] = "wear:step";
  lua_settop(L, 2);
  box *made = box_self_idle(L, &wear_class, where);
  arc_wear *wear = made->thing;
  int steps = count_argument(L, 2, where);
  size_t first;
  arc_wear_history(wear, &first);
  for (int i = 0; i < steps; i++) {
    double before = arc_wear_last(wear)->cycle;
    step_once(L, made, where);
    if (arc_wear_last(wear)->cycle <= before) break;
    if (interrupt_pending(NULL)) refuse_interrupted(L, wear);
  }
  size_t rows;
  arc_wear_history(wear, &rows);
  if (rows == first) warn_finished(L, wear);
  push_progress(L, wear, first);
  return 1;
}

/* --- run -------------------------------------------------------------------------------------- */

/* Context of the engine's callbacks. The run's object is at index 1. */
typedef struct run_call {
  lua_State *L;
  int progress, stop_when; /* stack indices of the functions; 0: none */
  int display;             /* 1: `progress` is the built-in display */
  double shown;            /* time of its last call [s] */
  const char *asked;       /* name of the function that requested the end of the run */
  const char *failed;      /* name of the function that raised the error on top of the stack */
  functions_call functions;
} run_call;

/* Calls a function of the user with the run as argument. Returns true if the run must end. */
static int call_user(run_call *call, int function, const char *name) {
  lua_State *L = call->L;
  if (!function) return 0;
  lua_pushvalue(L, function);
  lua_pushvalue(L, 1);
  if (error_pcall(L, 1, 1) != LUA_OK) {
    call->failed = name;
    return 1;
  }
  if (lua_toboolean(L, -1)) call->asked = name;
  lua_pop(L, 1);
  return call->asked != NULL;
}

static void warn_of_run(void *context, const char *text) {
  lua_warning(((run_call *)context)->L, text, 0);
}

/* Calls a function with the arguments on top of the stack, without the interrupt hook, so that an
 * interrupt cannot stop it. */
static void call_undisturbed(lua_State *L, int arguments) {
  lua_Hook hook = lua_gethook(L);
  int mask = lua_gethookmask(L), count = lua_gethookcount(L);
  if (hook) lua_sethook(L, NULL, 0, 0);
  lua_pcall(L, arguments, 0, 0);
  if (hook) lua_sethook(L, hook, mask, count);
}

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Calls the built-in display once a second during a long step, with the run and true. */
static void show_step(run_call *call) {
  static const double pause = 1; /* [s] */
  if (!call->display || call->failed) return;
  const double now = seconds();
  if (now - call->shown < pause) return;
  lua_State *L = call->L;
  const int top = lua_gettop(L);
  call->shown = now;
  lua_pushvalue(L, call->progress);
  lua_pushvalue(L, 1);
  lua_pushboolean(L, 1);
  call_undisturbed(L, 2);
  lua_settop(L, top);
}

/* Returns true if the engine must stop, after an interrupt or an error of a function. The check for
 * errors is needed because the engine ignores an error in a predictor step. */
static int is_to_stop(void *context) {
  show_step(context);
  return interrupt_pending(NULL) || functions_failed(&((run_call *)context)->functions);
}

static int after_step(void *context, const arc_wear *wear) {
  (void)wear;
  run_call *call = context;
  call->shown = seconds();
  const int progress = call_user(call, call->progress, "progress");
  if (call->failed) return 1;
  return call_user(call, call->stop_when, "stop_when") || progress;
}

/* Pushes the function that displays the progress of a run to `goal` [mm].
 * archard.lib.run_progress returns nil if there is no display. */
static void push_display(lua_State *L, double goal) {
  lua_pushvalue(L, 1);
  lua_pushnumber(L, goal);
  if (script_pcall(L, "archard.lib.run_progress", 2, 1) == LUA_OK) return;
  lua_pop(L, 1);
  lua_pushnil(L); /* nil: no progress is displayed */
}

/* Pushes the function that displays progress and sets its stack index, 0 if there is no such
 * function. */
static void push_progress_function(lua_State *L, double goal, run_call *call) {
  int type = args_get(L, 2, "progress");
  if (type == LUA_TFUNCTION) {
    call->progress = lua_gettop(L);
    return;
  }
  if (type != LUA_TNIL && type != LUA_TBOOLEAN)
    args_refuse(L, (args_location){"wear:run", ""}, "progress",
                "a function of the wear object, true or false");
  if (type == LUA_TBOOLEAN && !lua_toboolean(L, -1)) return;
  push_display(L, goal);
  call->display = lua_isfunction(L, -1);
  call->progress = call->display ? lua_gettop(L) : 0;
  call->shown = seconds();
}

/* Calls the function of the built-in display without an argument, which means that the run has
 * ended. */
static void end_display(lua_State *L, const run_call *call) {
  int top = lua_gettop(L);
  if (call->display) {
    lua_pushvalue(L, call->progress);
    call_undisturbed(L, 0);
  }
  lua_settop(L, top);
}

/* Warns about targets that the run did not reach before the end of its distance. */
static void warn_not_reached(lua_State *L, const arc_wear *wear, const wear_goals *goals) {
  char text[200];
  const arc_wear_record *last = arc_wear_last(wear);
  for (size_t i = 0; i < goals->count; i++) {
    const arc_wear_target *t = &goals->target[i];
    snprintf(text, sizeof text, "wear:run: %s = %g was not reached: it is %.4g at the end, %g mm",
             goals->name[i], t->value, arc_wear_record_get(last, t->column), last->distance);
    lua_warning(L, text, 0);
  }
}

/* Pushes the run. If there were several end conditions, also pushes the name of the condition
 * that ended the run. */
static int push_outcome(lua_State *L, const wear_goals *goals, const run_call *call, int reached) {
  lua_pushvalue(L, 1);
  if (goals->count == 0 && !goals->stop_when) return 1;
  lua_pushstring(L, reached >= 0 ? goals->name[reached] : call->asked ? call->asked : "distance");
  return 2;
}

/* wear:run{ distance=, cycles=, depth=, volume=, ..., stop_when=, progress= } returns the wear
 * object. If there are end conditions other than the distance, it also returns the name of the
 * condition that ended the run. */
int wear_run(lua_State *L) {
  static const char where[] = "wear:run";
  arc_error error = {0};
  lua_settop(L, 2);
  box *made = box_self_idle(L, &wear_class, where);
  arc_wear *wear = made->thing;
  int reached = -1;
  const wear_goals goals = wear_goals_read(L, wear);
  run_call call = {.L = L, .stop_when = goals.stop_when};
  const arc_callbacks callbacks = {
      .stop = is_to_stop, .warn = warn_of_run, .progress = after_step, .context = &call};
  push_progress_function(L, goals.distance, &call);
  luaL_checkstack(L, 20, where);
  lua_getiuservalue(L, 1, RUN_FUNCTIONS);
  call.functions = functions_enter(L, lua_gettop(L), made);
  made->busy = RUN_BUSY;
  arc_status status = arc_wear_run_until(wear, goals.distance, goals.target, goals.count,
                                         &callbacks, &reached, &error);
  made->busy = RUN_IDLE;
  end_display(L, &call);
  functions_leave(L, &call.functions, where);
  if (call.failed && !interrupt_pending(NULL)) error_callback(L, where, call.failed);
  if (!(status == ARC_STOPPED && call.asked)) check_ended(L, wear, status, &error, where);
  if (status == ARC_OK && reached < 0) warn_not_reached(L, wear, &goals);
  return push_outcome(L, &goals, &call, reached);
}

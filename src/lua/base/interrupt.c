/* Implements interrupts: the request flag, the hook, and the tracking of coroutines. While a
 * request is pending, the hook raises the error "interrupted" at every instruction. */
#include "lua/base/interrupt.h"

#include <lauxlib.h>
#include <signal.h>
#include <stdio.h>

/* The number of pending requests, whether there ever was a request, and the running coroutine.
 * These variables are static, because a signal handler has no argument for them. */
static volatile sig_atomic_t requests, ever;
static lua_State *volatile running;

/* Instruction limit of the sandbox: the remaining instructions, the function called at the limit,
 * and the error message of an exceeded limit (NULL: not exceeded). */
static double instructions_left;
static void (*limit_reached)(void);
static const char *volatile exceeded;
enum { PERIOD = 10000 }; /* number of instructions between two checks of the limit */

/* Error messages of an interrupt: `explained` contains the progress of the run, `plain` does not.
 * `explained` is set outside the signal handler. */
static const char plain[] = "interrupted";
static char explained[300];

/* Text that describes the progress of a search over many runs, or "". In error messages it replaces
 * the progress of the present run. */
static char report[240];

static void rest(lua_State *L);

/* Pushes the position "file:line: " of the running Lua function, or of the caller of a C
 * function. */
static void push_place(lua_State *L) {
  luaL_where(L, 0);
  if (lua_rawlen(L, -1) > 0) return;
  lua_pop(L, 1);
  luaL_where(L, 1);
}

/* Raises the message `explained`, without "file:line:" before it. */
static void raise_explained(lua_State *L) {
  lua_pushstring(L, explained);
  lua_error(L);
}

static void stop_hook(lua_State *L, lua_Debug *event) {
  (void)event;
  if (!interrupt_pending(NULL)) { /* no request is pending: the hook remained from an earlier
                                     request while the coroutine did not run */
    rest(L);
    return;
  }
  if (!explained[0] && report[0]) snprintf(explained, sizeof explained, "%s: %s", report, plain);
  if (explained[0] && !exceeded) raise_explained(L);
  push_place(L);
  lua_pushstring(L, exceeded ? exceeded : plain);
  lua_concat(L, 2);
  lua_error(L);
}

/* Installs the stop hook. Signal handlers may call this function, because lua_sethook is safe in
 * signal handlers. */
static void arm(lua_State *L) {
  lua_sethook(L, stop_hook, LUA_MASKCALL | LUA_MASKRET | LUA_MASKCOUNT, 1);
}

static void charge(void) {
  instructions_left -= PERIOD;
  if (instructions_left > 0 || exceeded) return;
  interrupt_exceed("instruction limit of the sandbox exceeded");
  if (limit_reached) limit_reached();
}

/* Hook that counts instructions for the limit of the sandbox, while no request is pending. */
static void count_hook(lua_State *L, lua_Debug *event) {
  charge();
  if (exceeded) stop_hook(L, event);
}

static void rest(lua_State *L) {
  if (instructions_left > 0 || exceeded)
    lua_sethook(L, count_hook, LUA_MASKCOUNT, PERIOD);
  else
    lua_sethook(L, NULL, 0, 0);
}

void interrupt_limit(lua_State *L, double instructions, void (*reached)(void)) {
  instructions_left = instructions;
  limit_reached = reached;
  rest(L);
}

void interrupt_exceed(const char *text) {
  exceeded = text;
  interrupt_request();
}

const char *interrupt_exceeded(void) {
  return exceeded;
}

int interrupt_request(void) {
  int before = (int)requests;
  requests = before + 1;
  ever = 1;
  if (running) arm(running);
  return before;
}

int interrupt_ever(void) {
  return ever;
}

int interrupt_pending(void *context) {
  (void)context;
  return requests != 0 || exceeded;
}

void interrupt_raise(lua_State *L, const char *progress) {
  snprintf(explained, sizeof explained, "%s: %s", report[0] ? report : progress, plain);
  raise_explained(L);
}

void interrupt_report(const char *text) {
  snprintf(report, sizeof report, "%s", text);
}

void interrupt_clear(void) {
  requests = 0;
  explained[0] = report[0] = '\0';
}

/* Sets the running coroutine. Installs the hook in it if a request is pending. */
static void switch_to(lua_State *L) {
  running = L;
  if (interrupt_pending(NULL)) arm(L);
}

void interrupt_attach(lua_State *L) {
  switch_to(L);
}

void interrupt_detach(lua_State *L) {
  running = NULL;
  rest(L);
}

/* Resumes `co` with the `count` values on top of L. Returns the number of results moved to L. After
 * an error returns -1; the error value stays on top of `co`, because closing `co` needs it. */
static int resume(lua_State *L, lua_State *co, int count) {
  if (!lua_checkstack(co, count)) return luaL_error(L, "too many arguments to resume");
  lua_xmove(L, co, count);
  int results = 0;
  switch_to(co);
  int status = lua_resume(co, L, count, &results);
  switch_to(L);
  if (status != LUA_OK && status != LUA_YIELD) return -1;
  luaL_checkstack(L, results + 1, "too many results to resume");
  lua_xmove(co, L, results);
  return results;
}

static lua_State *check_coroutine(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTHREAD);
  return lua_tothread(L, 1);
}

static int tracked_resume(lua_State *L) {
  lua_State *co = check_coroutine(L);
  int results = resume(L, co, lua_gettop(L) - 1);
  int count = results >= 0 ? results : 1;
  if (results < 0) lua_xmove(co, L, 1);
  lua_pushboolean(L, results >= 0);
  lua_insert(L, -(count + 1));
  return count + 1;
}

/* Closes a coroutine that ended with an error. Does nothing if the coroutine has no error status.
 */
static void close_failed(lua_State *L, lua_State *co) {
  int status = lua_status(co);
  if (status == LUA_OK || status == LUA_YIELD) return;
  switch_to(co);
  lua_resetthread(co);
  switch_to(L);
}

/* Calls a wrapped coroutine and raises its errors in the caller. An error text gets the caller's
 * position as prefix. */
static int call_wrapped(lua_State *L) {
  lua_State *co = lua_tothread(L, lua_upvalueindex(1));
  int results = resume(L, co, lua_gettop(L));
  if (results >= 0) return results;
  close_failed(L, co);
  lua_xmove(co, L, 1);
  if (lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

/* Creates a coroutine. Subtracts one period of instructions from the limit, because each coroutine
 * counts its periods separately. */
static lua_State *new_coroutine(lua_State *L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State *co = lua_newthread(L);
  if (instructions_left > 0) charge();
  return co;
}

static int tracked_create(lua_State *L) {
  lua_State *co = new_coroutine(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  return 1;
}

static int tracked_wrap(lua_State *L) {
  lua_State *co = new_coroutine(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  lua_pushcclosure(L, call_wrapped, 1);
  return 1;
}

/* Replaces coroutine.close. Pending __close methods run with the interrupt hook installed, so that
 * a request to interrupt also stops them. */
static int tracked_close(lua_State *L) {
  lua_State *co = check_coroutine(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  int closable = lua_status(co) != LUA_OK;
  if (closable) switch_to(co);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  if (closable) switch_to(L);
  return lua_gettop(L);
}

void interrupt_install(lua_State *L) {
  static const luaL_Reg tracked[] = {
      {"create", tracked_create}, {"resume", tracked_resume}, {"wrap", tracked_wrap}, {NULL, NULL}};
  lua_getglobal(L, "coroutine");
  luaL_setfuncs(L, tracked, 0);
  lua_getfield(L, -1, "close");
  lua_pushcclosure(L, tracked_close, 1);
  lua_setfield(L, -2, "close");
  lua_pop(L, 1);
}

/* Each running function has a frame on the C stack, with a list of the objects that it uses.
 * Functions end in the reverse order of their start, because coroutines cannot yield across them
 * and each frame catches errors. */
#include "lua/base/call.h"

#include <assert.h>

enum { MOST_HELD = 16 }; /* largest number of objects that one function can mark as used */

typedef struct frame {
  struct frame *outer;
  const void *first; /* first argument of the function; it exists as long as the frame */
  int count, keeps;  /* keeps: true if the registry has values of call_keep for this frame */
  call_held *held[MOST_HELD];
} frame;

static _Thread_local frame *current; /* frame of the innermost running function; NULL: none */

/* --- saved functions -------------------------------------------------------------------------- */

static int is_held(const frame *f, const call_held *held) {
  for (int i = 0; i < f->count; i++)
    if (f->held[i] == held) return 1;
  return 0;
}

/* Stores the object in the registry, so that it is not freed while a function uses it. */
static void keep_alive(lua_State *L, int index, call_held *held) {
  luaL_checkstack(L, 2, "objects");
  lua_pushvalue(L, index);
  lua_rawsetp(L, LUA_REGISTRYINDEX, held);
  held->kept = 1;
}

void call_hold(lua_State *L, int index, call_held *held) {
  if (!current || is_held(current, held)) return;
  if (current->count == MOST_HELD) luaL_error(L, "too many objects in one call");
  if (!held->kept && lua_touserdata(L, index) != current->first) keep_alive(L, index, held);
  current->held[current->count++] = held;
  held->count++;
}

int call_is_held_outside(const call_held *held) {
  return held->count > (current && is_held(current, held));
}

void call_keep(lua_State *L) {
  assert(current);
  luaL_checkstack(L, 4, "objects");
  if (!current->keeps) {
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, current);
    current->keeps = 1;
  }
  lua_rawgetp(L, LUA_REGISTRYINDEX, current);
  lua_insert(L, -2);
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  lua_pop(L, 1);
}

/* Removes the value of `key` from the registry. Returns 0 if the Lua stack is full; then the
 * value stays in the registry. */
static int forget(lua_State *L, const void *key) {
  if (!lua_checkstack(L, 1)) return 0;
  lua_pushnil(L);
  lua_rawsetp(L, LUA_REGISTRYINDEX, key);
  return 1;
}

static void release(lua_State *L, const frame *f) {
  for (int i = 0; i < f->count; i++) {
    call_held *held = f->held[i];
    if (--held->count > 0) continue;
    held->last(held);
    if (held->kept) held->kept = !forget(L, held);
  }
  if (f->keeps) forget(L, f);
}

/* --- calls ------------------------------------------------------------------------------------ */

void call_now(lua_State *L, int arguments, int results) {
  frame own; /* initialised below without memset, because each read of a field calls call_now */
  own.outer = current;
  own.first = arguments > 0 ? lua_touserdata(L, -arguments) : NULL;
  own.count = own.keeps = 0;
  current = &own;
  const int status = lua_pcall(L, arguments, results, 0);
  current = own.outer;
  release(L, &own);
  if (status != LUA_OK) lua_error(L);
}

/* Calls the wrapped function, which is upvalue 1. A copy of the first argument stays on the stack
 * below the function, so that the garbage collector does not free the object. */
static int call(lua_State *L) {
  const int arguments = lua_gettop(L);
  if (arguments > 0)
    lua_pushvalue(L, 1);
  else
    lua_pushnil(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_rotate(L, 1, 2);
  call_now(L, arguments, LUA_MULTRET);
  return lua_gettop(L) - 1;
}

void call_wrap(lua_State *L) {
  lua_pushcclosure(L, call, 1);
}

void call_push(lua_State *L, lua_CFunction function) {
  lua_pushcfunction(L, function);
  call_wrap(L);
}

void call_set_functions(lua_State *L, const luaL_Reg *list) {
  for (const luaL_Reg *each = list; each->name; each++) {
    call_push(L, each->func);
    lua_setfield(L, -2, each->name);
  }
}

void call_new_library(lua_State *L, const luaL_Reg *list) {
  luaL_checkversion(L);
  lua_newtable(L);
  call_set_functions(L, list);
}

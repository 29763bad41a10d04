/* lua/base/call.h - wrapper of the C functions that scripts call.
 *
 * Lua code may run at any allocation (the garbage collector calls finalizers), in every callback
 * and in every metamethod. Therefore a C function marks each object that it uses until it returns
 * or fails. While an object is marked, changes are refused and closing is deferred. Every function
 * that uses boxes (box.h) must be wrapped before scripts can call it. */
#ifndef LUA_CALL_H
#define LUA_CALL_H

#include <lauxlib.h>
#include <lua.h>

/* Replaces the C function on top of the stack by its wrapped version. */
void call_wrap(lua_State *L);

/* Pushes the wrapped version of the C function `function`. */
void call_push(lua_State *L, lua_CFunction function);

/* Calls a function like lua_call, with the protection of a wrapped function. The first argument
 * must stay on the caller's stack. */
void call_now(lua_State *L, int arguments, int results);

/* These functions work like luaL_setfuncs and luaL_newlib, but also wrap each function. */
void call_set_functions(lua_State *L, const luaL_Reg *list);
void call_new_library(lua_State *L, const luaL_Reg *list);

/* Member of each object that can be marked as used. `count` is the number of functions that use the
 * object. `kept` is true if the registry keeps the object alive. `last` is called when no function
 * uses the object any more. */
typedef struct call_held {
  int count, kept;
  void (*last)(struct call_held *self);
} call_held;

/* Marks the object at `index` as used until the running function returns. `held` is the object's
 * member for marks. Repeated calls in one function count as one mark. */
void call_hold(lua_State *L, int index, call_held *held);

/* Returns true if a function other than the running function uses the object. */
int call_is_held_outside(const call_held *held);

/* Pops a value and keeps it alive until the running function returns. */
void call_keep(lua_State *L);

#endif

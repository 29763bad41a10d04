/* lua/call.h - wrapper of the C functions that scripts call.
 *
 * Lua code may run at any allocation (the garbage collector calls finalizers), in every callback
 * and in every metamethod. Therefore a C function holds each object that it uses until it returns
 * or fails: the object is not moved, changes are refused, and closing is deferred. Every function
 * that uses boxes (box.h) is given to scripts through this file.
 */
#ifndef LUA_CALL_H
#define LUA_CALL_H

#include <lauxlib.h>
#include <lua.h>

/* Replaces the C function on top of the stack by its wrapped version. */
void call_wrap(lua_State *L);

/* Pushes the wrapped version of a C function. */
void call_push(lua_State *L, lua_CFunction function);

/* lua_call of a function as if it were wrapped. The first argument must stay on the caller's stack.
 */
void call_now(lua_State *L, int arguments, int results);

/* luaL_setfuncs and luaL_newlib with wrapped functions. */
void call_set_functions(lua_State *L, const luaL_Reg *list);
void call_new_library(lua_State *L, const luaL_Reg *list);

/* Member of each object that can be held. count: functions that hold it; kept: the registry keeps
 * it alive; last: called when the last function releases it. */
typedef struct call_held {
  int count, kept;
  void (*last)(struct call_held *self);
} call_held;

/* Holds the object at `index`, whose member is `held`, until the running function returns. Repeated
 * calls in one function count once. */
void call_hold(lua_State *L, int index, call_held *held);

/* True if a function outside the running one holds the object. */
int call_is_held_outside(const call_held *held);

/* Pops a value and keeps it alive until the running function returns. */
void call_keep(lua_State *L);

#endif

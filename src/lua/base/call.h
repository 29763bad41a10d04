/* lua/call.h - functions as scripts call them.
 *
 * Lua may run at any allocation, since the collector starts finalizers there, and in every callback
 * and metamethod. So whatever a function of ours looks into is held until it returns or fails: it
 * stays where it is; a change meanwhile is refused, and closing waits. Functions that look into
 * boxes (box.h) are handed to scripts through this file, all of them.
 */
#ifndef LUA_CALL_H
#define LUA_CALL_H

#include <lauxlib.h>
#include <lua.h>

/* Replaces the C function on top of the stack by one that holds what it uses while it runs. */
void call_wrap(lua_State *L);

/* Pushes such a function. */
void call_push(lua_State *L, lua_CFunction function);

/* lua_call, once, of a function that would be one when wrapped; the first argument must stay on the
 * stack of whoever calls. */
void call_now(lua_State *L, int arguments, int results);

/* luaL_setfuncs and luaL_newlib of such functions. */
void call_set_functions(lua_State *L, const luaL_Reg *list);
void call_new_library(lua_State *L, const luaL_Reg *list);

/* In a value that can be held: by how many functions it is, whether the registry keeps it alive
 * meanwhile, and what the last of them calls. */
typedef struct call_held {
  int count, kept;
  void (*last)(struct call_held *self);
} call_held;

/* Holds the value at `index`, which has `held` in it, until the function that runs returns; once in
 * each. */
void call_hold(lua_State *L, int index, call_held *held);

/* Whether functions around the one that runs hold it. */
int call_is_held_outside(const call_held *held);

/* Pops a value, which lives until the function that runs returns. */
void call_keep(lua_State *L);

#endif

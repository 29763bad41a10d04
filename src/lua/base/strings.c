/* Strings have a real metatable, which user scripts cannot reach, and a proxy. getmetatable
 * returns the proxy, which forwards reads and writes to the real metatable. The user's __index
 * is used only for names that are not methods of Lua's string library. */
#include "lua/base/strings.h"

#include "lua/base/strict.h"

#include <lauxlib.h>
#include <string.h>

/* Registry keys of the real metatable, the proxy, the protected methods and the user's __index.
 * The address of each variable is the key. */
static const char real_key = 0, shown_key = 0, methods_key = 0, index_key = 0;

static void push(lua_State *L, const char *key) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, key);
}

static int is_text(lua_State *L, int index, const char *text) {
  return lua_type(L, index) == LUA_TSTRING && strcmp(lua_tostring(L, index), text) == 0;
}

/* --- methods ---------------------------------------------------------------------------------- */

/* Pushes the value that the user's __index (a function or a table, on top of the stack) has for the
 * name at index 2. Upvalue 2: the string library. */
static int call_user(lua_State *L) {
  if (lua_isnil(L, -1)) return 1;
  if (lua_rawequal(L, -1, lua_upvalueindex(2))) {
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) == LUA_TNIL) strict_method(L, lua_upvalueindex(2));
    return 1;
  }
  if (lua_isfunction(L, -1)) {
    lua_pushvalue(L, 1);
    lua_pushvalue(L, 2);
    lua_call(L, 2, 1);
    return 1;
  }
  lua_pushvalue(L, 2);
  lua_gettable(L, -2);
  return 1;
}

/* Metamethod __index(string or methods, name): returns a protected method, or the value of the
 * user's __index. Upvalue 1: the protected methods. */
static int string_index(lua_State *L) {
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  push(L, &index_key);
  return call_user(L);
}

/* Pops the user's __index and installs an __index for strings. A table as __index is much faster
 * than a function. Therefore a function is installed only if the user's __index is a function,
 * which must receive the string. */
static void take_index(lua_State *L) {
  const int wants_string = lua_isfunction(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &index_key);
  push(L, &real_key);
  push(L, &methods_key);
  if (wants_string) luaL_getmetafield(L, -1, "__index");
  lua_setfield(L, wants_string ? -3 : -2, "__index");
  lua_pop(L, wants_string ? 2 : 1);
}

/* --- the proxy metatable ---------------------------------------------------------------------- */

/* Metamethod __index(proxy, name): reads an entry of the real metatable, or the user's __index. */
static int shown_index(lua_State *L) {
  lua_settop(L, 2);
  if (is_text(L, 2, "__index")) return push(L, &index_key), 1;
  if (lua_isnil(L, 2) || is_text(L, 2, "__metatable")) return 0;
  push(L, &real_key);
  lua_insert(L, 2);
  lua_rawget(L, 2);
  return 1;
}

/* Metamethod __newindex(proxy, name, value): sets an entry of the real metatable, or the user's
 * __index. */
static int shown_newindex(lua_State *L) {
  lua_settop(L, 3);
  if (is_text(L, 2, "__index")) {
    take_index(L);
  } else if (!is_text(L, 2, "__metatable")) {
    push(L, &real_key);
    lua_insert(L, 2);
    lua_rawset(L, 2);
  }
  return 0;
}

/* Removes all entries of the user from the metatable of strings and adds the entries of the
 * table (or nil) at index 2. */
static void replace_shown(lua_State *L) {
  push(L, &real_key);
  for (lua_pushnil(L); lua_next(L, 3); lua_settop(L, 4)) {
    if (is_text(L, 4, "__index") || is_text(L, 4, "__metatable")) continue;
    lua_pushvalue(L, 4);
    lua_pushnil(L);
    lua_rawset(L, 3);
  }
  lua_pushnil(L);
  take_index(L);
  if (!lua_istable(L, 2)) return;
  push(L, &shown_key);
  for (lua_pushnil(L); lua_next(L, 2); lua_settop(L, 5)) {
    lua_pushvalue(L, 5);
    lua_insert(L, 6);
    lua_settable(L, 4);
  }
}

/* --- debug.getmetatable and setmetatable for the user ----------------------------------------- */

static int call_original(lua_State *L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

static int get_metatable(lua_State *L) {
  if (lua_type(L, 1) != LUA_TSTRING) return call_original(L);
  push(L, &shown_key);
  return 1;
}

static int set_metatable(lua_State *L) {
  if (lua_type(L, 1) != LUA_TSTRING || !(lua_istable(L, 2) || lua_type(L, 2) == LUA_TNIL))
    return call_original(L);
  lua_settop(L, 2);
  replace_shown(L);
  lua_settop(L, 1);
  return 1;
}

static void wrap(lua_State *L, const char *name, lua_CFunction function) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

/* --- installation ----------------------------------------------------------------------------- */

/* Stores a copy of the string library, which is on top of the stack. string.dump is omitted,
 * because the sandbox removes it. */
static void keep_methods(lua_State *L) {
  const int library = lua_gettop(L);
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, library); lua_pop(L, 1)) {
    if (is_text(L, -2, "dump")) continue;
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -5);
  }
  lua_createtable(L, 0, 1);
  lua_pushvalue(L, -2);
  lua_pushvalue(L, library);
  lua_pushcclosure(L, string_index, 2);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &methods_key);
}

static void push_shown(lua_State *L) {
  static const luaL_Reg events[] = {
      {"__index", shown_index}, {"__newindex", shown_newindex}, {NULL, NULL}};
  lua_newtable(L);
  luaL_newlib(L, events);
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
}

/* Stores the metatable on top of the stack as the real metatable of strings. Creates a proxy,
 * which getmetatable then returns. */
static void hide(lua_State *L) {
  push_shown(L);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &shown_key);
  lua_setfield(L, -2, "__metatable");
  lua_rawsetp(L, LUA_REGISTRYINDEX, &real_key);
}

void strings_keep(lua_State *L) {
  const int top = lua_gettop(L);
  lua_pushliteral(L, "");
  if (lua_getmetatable(L, top + 1)) {
    hide(L);
    lua_getglobal(L, "string");
    keep_methods(L);
    take_index(L);
    lua_getglobal(L, "debug");
    wrap(L, "getmetatable", get_metatable);
    wrap(L, "setmetatable", set_metatable);
  }
  lua_settop(L, top);
}

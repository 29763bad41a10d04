/* Loads the embedded Lua files (lua/base/embedded.h) as modules "archard.NAME", and creates the
 * globals for these scripts. */
#include "lua/base/scripts.h"

#include "lua/base/embedded.h"

#include <string.h>

/* Registry keys of two tables: the modules, and the globals of built-in scripts. The keys are the
 * addresses of these variables. */
static const char modules_key = 0, globals_key = 0;

/* --- globals ---------------------------------------------------------------------------------- */

static void copy_into(lua_State *L, int from, int into) {
  from = lua_absindex(L, from);
  into = lua_absindex(L, into);
  for (lua_pushnil(L); lua_next(L, from); lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, into);
  }
}

/* Replaces Lua's libraries in the table on top of the stack by copies. _G and package are not
 * copied, because scripts use them to read the user's globals. */
static void copy_libraries(lua_State *L) {
  static const char *const names[] = {"coroutine", "debug", "io",     "math",
                                      "os",        "table", "string", "utf8"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    lua_newtable(L);
    if (lua_getfield(L, -2, names[i]) == LUA_TTABLE) copy_into(L, -1, -2);
    lua_pop(L, 1);
    lua_setfield(L, -2, names[i]);
  }
}

/* The function print for built-in scripts: calls the user's print, or Lua's print if the user's
 * print is not a function. Upvalue: Lua's print. */
static int user_print(lua_State *L) {
  lua_pushglobaltable(L);
  lua_pushliteral(L, "print");
  if (lua_rawget(L, -2) != LUA_TFUNCTION) {
    lua_pop(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
  }
  lua_insert(L, 1);
  lua_pop(L, 1);
  lua_call(L, lua_gettop(L) - 1, 0);
  return 0;
}

/* Metamethod __index(io, name): returns the user's io.NAME if it is a table or userdata, otherwise
 * Lua's stream. Upvalue: table of Lua's streams. */
static int user_stream(lua_State *L) {
  if (lua_getfield(L, lua_upvalueindex(1), luaL_checkstring(L, 2)) == LUA_TNIL) return 1;
  lua_pushglobaltable(L);
  lua_pushliteral(L, "io");
  int type = lua_rawget(L, 4);
  if (type == LUA_TTABLE) {
    lua_pushvalue(L, 2);
    type = lua_rawget(L, 5);
  }
  if (type != LUA_TTABLE && type != LUA_TUSERDATA) lua_settop(L, 3);
  return 1;
}

/* Removes the streams stdin, stdout and stderr from the copy of io in the table on top of the
 * stack, so that reading a stream calls user_stream. */
static void follow_streams(lua_State *L) {
  static const char *const names[] = {"stdin", "stdout", "stderr"};
  lua_getfield(L, -1, "io");
  lua_createtable(L, 0, 1);
  lua_newtable(L);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    lua_getfield(L, -3, names[i]);
    lua_setfield(L, -2, names[i]);
    lua_pushnil(L);
    lua_setfield(L, -4, names[i]);
  }
  lua_pushcclosure(L, user_stream, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

/* raw_pairs and raw_ipairs replace pairs and ipairs in built-in scripts. They ignore metamethods of
 * the user's tables. */
static int raw_pairs(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_pushnil(L);
  return 3;
}

static int raw_item(lua_State *L) {
  const lua_Integer i = (lua_Integer)((lua_Unsigned)luaL_checkinteger(L, 2) + 1);
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_pushinteger(L, i);
  return lua_rawgeti(L, 1, i) == LUA_TNIL ? 1 : 2;
}

static int raw_ipairs(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_pushinteger(L, 0);
  return 3;
}

/* Sets pairs, ipairs and getmetatable in the globals on top of the stack to versions that ignore
 * metamethods. */
static void set_raw_functions(lua_State *L) {
  lua_getfield(L, -1, "next");
  lua_pushcclosure(L, raw_pairs, 1);
  lua_setfield(L, -2, "pairs");
  lua_pushcfunction(L, raw_item);
  lua_pushcclosure(L, raw_ipairs, 1);
  lua_setfield(L, -2, "ipairs");
  lua_getfield(L, -1, "debug");
  lua_getfield(L, -1, "getmetatable");
  lua_setfield(L, -3, "getmetatable");
  lua_pop(L, 1);
}

static int own_require(lua_State *L) {
  script_require(L, luaL_checkstring(L, 1));
  return 1;
}

static int no_global(lua_State *L) {
  return luaL_error(L, "unknown global '%s' in a built-in script", luaL_tolstring(L, 2, NULL));
}

/* Makes it an error to read or assign an unknown global in built-in scripts. */
static void refuse_others(lua_State *L) {
  static const luaL_Reg events[] = {
      {"__index", no_global}, {"__newindex", no_global}, {NULL, NULL}};
  luaL_newlib(L, events);
  lua_setmetatable(L, -2);
}

static void make_globals(lua_State *L) {
  lua_newtable(L);
  lua_pushglobaltable(L);
  copy_into(L, -1, -2);
  lua_pop(L, 1);
  copy_libraries(L);
  follow_streams(L);
  lua_getfield(L, -1, "print");
  lua_pushcclosure(L, user_print, 1);
  lua_setfield(L, -2, "print");
  lua_pushcfunction(L, own_require);
  lua_setfield(L, -2, "require");
  set_raw_functions(L);
  refuse_others(L);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &globals_key);
}

void script_set_global(lua_State *L, const char *name) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &globals_key);
  lua_pushstring(L, name);
  lua_rotate(L, -3, -1);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

/* --- modules ---------------------------------------------------------------------------------- */

/* Runs the script and pushes its return value. */
static void run_script(lua_State *L, const embedded_script *script) {
  const char *chunk = lua_pushfstring(L, "@%s", script->path);
  if (luaL_loadbuffer(L, script->text, strlen(script->text), chunk) != LUA_OK) lua_error(L);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &globals_key);
  lua_setupvalue(L, -2, 1);
  lua_call(L, 0, 1);
  lua_remove(L, -2);
}

static const embedded_script *find_script(const char *name) {
  static const char prefix[] = "archard.";
  if (strncmp(name, prefix, sizeof prefix - 1) != 0) return NULL;
  const embedded_script *script = embedded_scripts;
  while (script->name && strcmp(script->name, name + sizeof prefix - 1) != 0) script++;
  return script->name ? script : NULL;
}

/* Metamethod __index of the table of modules: loads the module `name`. Upvalue: the list of modules
 * in C. */
static int open_module(lua_State *L) {
  const char *name = luaL_checkstring(L, 2);
  const luaL_Reg *module = lua_touserdata(L, lua_upvalueindex(1));
  while (module->name && strcmp(module->name, name) != 0) module++;
  const embedded_script *script = find_script(name);
  if (module->name)
    luaL_requiref(L, name, module->func, 0);
  else if (script)
    run_script(L, script);
  else
    luaL_error(L, "unknown module '%s'", name);
  lua_pushvalue(L, 2);
  lua_pushvalue(L, -2);
  lua_rawset(L, 1);
  return 1;
}

void script_require(lua_State *L, const char *name) {
  luaL_checkstack(L, 4, name);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key);
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
}

/* Calls the function that a module returns. The stack contains the name of the module and the
 * arguments. */
static int call_module(lua_State *L) {
  script_require(L, lua_touserdata(L, 1));
  lua_replace(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int script_pcall(lua_State *L, const char *name, int arguments, int results) {
  luaL_checkstack(L, 4, name);
  lua_pushcfunction(L, call_module);
  lua_pushlightuserdata(L, (void *)name);
  lua_rotate(L, -(arguments + 2), 2);
  return lua_pcall(L, arguments + 1, results, 0);
}

void script_set_module(lua_State *L, const char *name) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key);
  lua_pushstring(L, name);
  lua_rotate(L, -3, -1);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

static void make_modules(lua_State *L, const luaL_Reg *modules) {
  lua_newtable(L);
  lua_createtable(L, 0, 1);
  lua_pushlightuserdata(L, (void *)modules);
  lua_pushcclosure(L, open_module, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &modules_key);
}

/* Registers all modules in package.preload, so that require in user scripts returns the same values
 * as script_require. */
static void fill_preload(lua_State *L, const luaL_Reg *modules) {
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_PRELOAD_TABLE);
  lua_pushcfunction(L, own_require);
  for (const embedded_script *script = embedded_scripts; script->name; script++) {
    const char *name = lua_pushfstring(L, "archard.%s", script->name);
    lua_pushvalue(L, -2);
    lua_setfield(L, -4, name);
    lua_pop(L, 1);
  }
  for (const luaL_Reg *module = modules; module->name; module++) {
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, module->name);
  }
  lua_pop(L, 2);
}

void script_preload(lua_State *L, const luaL_Reg *modules) {
  make_globals(L);
  make_modules(L, modules);
  fill_preload(L, modules);
}

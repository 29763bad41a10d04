/* Raises errors for unknown names of globals, and of fields in tables, objects and Lua's
 * libraries. */
#include "lua/base/strict.h"
#include "lua/base/archard.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/base/scripts.h"

#include <lauxlib.h>
#include <stdlib.h>
#include <string.h>

static const char lax_key = 0; /* registry key of the option --lax; only the address is used */

void strict_lax(lua_State *L) {
  lua_pushboolean(L, 1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &lax_key);
}

static int is_lax(lua_State *L) {
  const int lax = lua_rawgetp(L, LUA_REGISTRYINDEX, &lax_key) == LUA_TBOOLEAN;
  lua_pop(L, 1);
  return lax;
}

static int reads_at(lua_State *L, int level) {
  lua_Debug reader;
  if (is_lax(L) || !lua_getstack(L, level, &reader)) return 0;
  lua_getinfo(L, "S", &reader);
  return strcmp(reader.what, "C") != 0 && strncmp(reader.source, "@scripts/", 9) != 0;
}

int strict_reads(lua_State *L) {
  return reads_at(L, 1);
}

int strict_reads_called(lua_State *L) {
  return reads_at(L, 2);
}

/* --- valid names ------------------------------------------------------------------------------ */

/* Adds the string keys of the table at `index`, and the strings in its list part, to the candidates
 * of a search. */
static void offer_all(lua_State *L, int index, names_search *search) {
  if (!lua_istable(L, index)) return;
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TSTRING)
      names_offer(search, lua_tostring(L, -2));
    else if (lua_type(L, -1) == LUA_TSTRING)
      names_offer(search, lua_tostring(L, -1));
  }
}

static int by_text(const void *a, const void *b) {
  return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Pushes a list such as " (known: cylinder, plate)" of the string keys of the table at `index`.
 * Pushes "" if the table has no string keys or more than eight. */
static const char *push_few(lua_State *L, int index) {
  enum { most = 8 };
  const char *keys[most];
  int count = 0;
  if (!lua_istable(L, index)) return lua_pushliteral(L, "");
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) continue;
    if (count == most) {
      lua_pop(L, 2);
      return lua_pushliteral(L, "");
    }
    keys[count++] = lua_tostring(L, -2);
  }
  qsort(keys, (size_t)count, sizeof *keys, by_text);
  lua_pushliteral(L, "");
  for (int i = 0; i < count; i++) {
    lua_pushfstring(L, "%s%s%s", lua_tostring(L, -1), i == 0 ? " (known: " : ", ", keys[i]);
    lua_remove(L, -2);
  }
  if (count > 0) lua_pushliteral(L, ")"), lua_concat(L, 2);
  return lua_tostring(L, -1);
}

/* Returns a hint for the error message if the name is a term of another class, otherwise NULL. */
static const char *elsewhere(const char *where, const char *name) {
  static const char *const list[][3] = {
      {"body", "cup", ": a ball in its socket is a joint{ cup = { clearance = 0.06 } }"},
      {"body", "pin", ": a pin is a body.punch{}, a body.ball{} or a body.cylinder{}"},
      {"body", "socket", ": a ball in its socket is a joint{ cup = { clearance = 0.06 } }"}};
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    if (strcmp(where, list[i][0]) == 0 && strcmp(name, list[i][1]) == 0) return list[i][2];
  if (strcmp(name, "plot") == 0)
    return "; help \"plot\" lists the functions that draw objects, such as plot.profile";
  return NULL;
}

void strict_refuse(lua_State *L, const char *where, const char *name, int known) {
  names_search search = names_begin(name);
  const char *meant = elsewhere(where, name);
  if (meant) error_raise(L, ARC_ARGUMENT, where, "no field '%s'%s", name, meant);
  luaL_checkstack(L, 10, where);
  known = lua_absindex(L, known);
  offer_all(L, known, &search);
  if (search.best)
    error_raise(L, ARC_ARGUMENT, where, "no field '%s'; did you mean '%s'?", name, search.best);
  const char *few = push_few(L, known);
  if (lua_istable(L, known) && luaL_getmetafield(L, known, "__call") != LUA_TNIL)
    error_raise(L, ARC_ARGUMENT, where,
                "no field '%s'%s; for methods of the objects that %s{} makes: help \"%s.%s\"", name,
                few, where, where, name);
  error_raise(L, ARC_ARGUMENT, where, "no field '%s'%s", name, few);
}

/* --- tables ----------------------------------------------------------------------------------- */

/* Metamethod __index(table, name): returns the field that an alias names, or raises the error for
 * an unknown name. Upvalues: name of the table, table of aliases or nil. */
static int table_index(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  if (lua_istable(L, lua_upvalueindex(2))) {
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL) {
      lua_rawget(L, 1);
      return 1;
    }
  }
  if (lua_type(L, 2) == LUA_TSTRING && strict_reads(L))
    strict_refuse(L, lua_tostring(L, lua_upvalueindex(1)), lua_tostring(L, 2), 1);
  return 0;
}

/* Metamethod __tostring: formats the table as the prompt prints it, for the width of the
 * terminal. */
static int table_tostring(lua_State *L) {
  lua_settop(L, 1);
  script_require(L, "archard.lib.pretty");
  lua_getfield(L, -1, "fitted");
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  return 1;
}

/* Sets __index of the metatable on top of the stack. `words` is the absolute index of the table of
 * aliases; 0: no aliases. */
static void set_index(lua_State *L, const char *where, int words) {
  lua_pushstring(L, where);
  if (words)
    lua_pushvalue(L, words);
  else
    lua_pushnil(L);
  lua_pushcclosure(L, table_index, 2);
  lua_setfield(L, -2, "__index");
}

/* Fills a metatable for strict tables. strict_is recognises a table by the name in the field
 * __table. The field __plain makes the prompt print the table like an ordinary table. */
static void fill_metatable(lua_State *L, const char *where, int words) {
  set_index(L, where, words);
  lua_pushstring(L, where);
  lua_setfield(L, -2, "__table");
  lua_pushcfunction(L, table_tostring);
  lua_setfield(L, -2, "__tostring");
  lua_pushboolean(L, 1);
  lua_setfield(L, -2, "__plain");
}

void strict_table(lua_State *L, const char *where) {
  luaL_checkstack(L, 6, where);
  if (luaL_newmetatable(L, lua_pushfstring(L, "archard.table %s", where))) {
    lua_pushnil(L);
    lua_setfield(L, -2, "__name");
    fill_metatable(L, where, 0);
  }
  lua_setmetatable(L, -3);
  lua_pop(L, 1);
}

int strict_is(lua_State *L, int index, const char *where) {
  if (luaL_getmetafield(L, index, "__table") == LUA_TNIL) return 0;
  const char *what = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  const int is = strcmp(what, where) == 0;
  lua_pop(L, 1);
  return is;
}

void strict_metatable(lua_State *L, const char *where, int words) {
  words = lua_absindex(L, words);
  lua_newtable(L);
  fill_metatable(L, where, words);
}

void strict_module(lua_State *L, const char *where) {
  if (!lua_getmetatable(L, -1)) lua_newtable(L);
  lua_pushliteral(L, "__index");
  if (lua_rawget(L, -2) == LUA_TNIL) {
    lua_pop(L, 1);
    set_index(L, where, 0);
  } else {
    lua_pop(L, 1);
  }
  lua_setmetatable(L, -2);
}

/* --- globals ---------------------------------------------------------------------------------- */

/* Globals that may be read without an error; reading them returns nil. Lua programs read them to
 * detect their environment. `_` is the last value of the prompt. */
static const char *const asked_for[] = {"_",       "unpack",   "loadstring", "setfenv",
                                        "getfenv", "module",   "jit",        "bit",
                                        "bit32",   "newproxy", "ngx",        NULL};

static int is_among(const char *const *names, const char *name) {
  while (*names && strcmp(*names, name) != 0) names++;
  return *names != NULL;
}

static int was_assigned(lua_State *L) {
  lua_pushvalue(L, 2);
  const int found = lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL;
  lua_pop(L, 1);
  return found;
}

/* Metamethod __index(globals, name): raises an error for a name that was never assigned. Upvalue:
 * the set of assigned names, whose values may be nil. */
static int global_index(lua_State *L) {
  lua_settop(L, 2);
  if (lua_type(L, 2) != LUA_TSTRING || !strict_reads(L) || was_assigned(L)) return 0;
  const char *name = lua_tostring(L, 2);
  if (is_among(asked_for, name)) return 0;
  names_search search = names_begin(name);
  offer_all(L, 1, &search);
  if (search.best) return luaL_error(L, "no global '%s'; did you mean '%s'?", name, search.best);
  return luaL_error(L, "no global '%s'", name);
}

static int global_newindex(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 3);
  luaL_argcheck(L, !lua_isnil(L, 2) && lua_tonumber(L, 2) == lua_tonumber(L, 2), 2, "no name");
  lua_pushvalue(L, 2);
  lua_pushboolean(L, 1);
  lua_rawset(L, lua_upvalueindex(1));
  lua_rawset(L, 1);
  return 0;
}

void strict_globals(lua_State *L) {
  lua_pushglobaltable(L);
  lua_createtable(L, 0, 2);
  lua_newtable(L);
  lua_pushvalue(L, -1);
  lua_pushcclosure(L, global_index, 1);
  lua_setfield(L, -3, "__index");
  lua_pushcclosure(L, global_newindex, 1);
  lua_setfield(L, -2, "__newindex");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

/* --- Lua's own libraries ---------------------------------------------------------------------- */

/* Library functions of other Lua versions that may be read without an error, because programs
 * test whether they exist. Reading them returns nil. */
static const char *const asked_of_libraries[] = {
    "pow",  "ldexp", "frexp",   "cosh",     "sinh",    "tanh",    "log10", "mod",   "maxn", "getn",
    "setn", "gfind", "foreach", "foreachi", "setfenv", "getfenv", "new",   "clear", NULL};

/* Metamethod __index(library, name): raises an error for an unknown name. Upvalue: name of the
 * library. */
static int library_index(lua_State *L) {
  lua_settop(L, 2);
  if (lua_type(L, 2) != LUA_TSTRING) return 0;
  return is_among(asked_of_libraries, lua_tostring(L, 2)) ? 0 : table_index(L);
}

void strict_method(lua_State *L, int library) {
  if (lua_type(L, 2) != LUA_TSTRING || is_among(asked_of_libraries, lua_tostring(L, 2))) return;
  if (strict_reads(L)) strict_refuse(L, "string", lua_tostring(L, 2), library);
}

static void strict_library(lua_State *L, const char *name) {
  if (lua_getglobal(L, name) == LUA_TTABLE && !lua_getmetatable(L, -1)) {
    lua_createtable(L, 0, 1);
    lua_pushstring(L, name);
    lua_pushcclosure(L, library_index, 1);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
  }
}

void strict_libraries(lua_State *L) {
  static const char *const names[] = {"math", "string", "table", "os", "io", "utf8", "coroutine"};
  const int top = lua_gettop(L);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    strict_library(L, names[i]);
    lua_settop(L, top);
  }
}

/* --- the module archard.strict ---------------------------------------------------------------- */

/* table(t, where) makes the table t strict, with the name `where` in messages, and returns t. */
static int module_table(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const char *where = luaL_checkstring(L, 2);
  lua_pushvalue(L, 1);
  strict_table(L, where);
  return 1;
}

/* Returns true if the list at index `known` contains the text at index `name`. */
static int is_listed(lua_State *L, int known, int name) {
  int found = 0;
  for (lua_Integer i = 1; !found && lua_rawgeti(L, known, i) != LUA_TNIL; i++) {
    found = lua_rawequal(L, -1, name);
    lua_pop(L, 1);
  }
  if (!found) lua_pop(L, 1);
  return found;
}

/* refuse(where, name, known) raises the error for an unknown name if the user's code reads the
 * name. This code is two levels up, because an __index function in Lua calls refuse. Returns nil
 * for other code, and for a name in the list `known`, because such a field may be nil. */
static int module_refuse(lua_State *L) {
  luaL_checktype(L, 3, LUA_TTABLE);
  if (lua_type(L, 2) != LUA_TSTRING || !reads_at(L, 2) || is_listed(L, 3, 2)) return 0;
  strict_refuse(L, luaL_checkstring(L, 1), lua_tostring(L, 2), 3);
}

/* Pushes the field `name` (index 2) of the object at index 1. The fields of a read-only object (a
 * userdata) are in its user value 1. For any other object, pushes nil. */
static int push_own(lua_State *L) {
  if (lua_type(L, 1) != LUA_TUSERDATA) return lua_pushnil(L), LUA_TNIL;
  lua_getiuservalue(L, 1, 1);
  lua_pushvalue(L, 2);
  return lua_rawget(L, -2);
}

/* Metamethod __index(object, name): returns a method or field, or raises the error for an unknown
 * name. Upvalues: methods of the class, names of all methods and fields, name of the class. */
static int object_index(lua_State *L) {
  lua_settop(L, 2);
  if (lua_type(L, 2) != LUA_TSTRING) return 0;
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  if (strict_reads(L) && !is_listed(L, lua_upvalueindex(2), 2))
    strict_refuse(L, lua_tostring(L, lua_upvalueindex(3)), lua_tostring(L, 2), lua_upvalueindex(2));
  push_own(L);
  return 1;
}

/* Metamethod __newindex(object, name, value) of read-only objects. Only built-in scripts can set
 * fields. Upvalue: name of the class. */
static int object_newindex(lua_State *L) {
  lua_settop(L, 3);
  if (strict_reads(L)) {
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    error_raise(L, ARC_ARGUMENT, lua_tostring(L, lua_upvalueindex(1)),
                "field '%s' cannot be set: the object is read-only", name);
  }
  if (lua_type(L, 1) != LUA_TUSERDATA) return lua_rawset(L, 1), 0;
  lua_getiuservalue(L, 1, 1);
  lua_replace(L, 1);
  lua_rawset(L, 1);
  return 0;
}

/* Pops a table and appends its string keys and list values to the list below it. */
static void gather(lua_State *L) {
  for (lua_pushnil(L); lua_istable(L, -2) && lua_next(L, -2); lua_pop(L, 1)) {
    lua_pushvalue(L, lua_type(L, -2) == LUA_TSTRING ? -2 : -1);
    lua_rawseti(L, -5, (lua_Integer)lua_rawlen(L, -5) + 1);
  }
  lua_settop(L, 2);
}

/* Checks that the first argument is an object of the class, and then calls the method. Upvalues:
 * the method, the metatable of the class. */
static int object_method(lua_State *L) {
  const int arguments = lua_gettop(L);
  if (arguments == 0 || !lua_getmetatable(L, 1) || !lua_rawequal(L, -1, lua_upvalueindex(2))) {
    lua_settop(L, 1);
    lua_getfield(L, lua_upvalueindex(2), "__name");
    const char *class = lua_tostring(L, -1), *shown = names_push_shown(L, 1);
    error_raise(L, ARC_ARGUMENT, class,
                "expected a %s object, got %s; methods are called with a colon, as object:method()",
                class, shown);
  }
  lua_settop(L, arguments);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, arguments, LUA_MULTRET);
  return lua_gettop(L);
}

/* methods(metatable) wraps each function in __methods, so that the function checks the class of its
 * first argument. Returns the metatable. */
static int module_methods(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  if (lua_getfield(L, 1, "__methods") != LUA_TTABLE) return lua_settop(L, 1), 1;
  for (lua_pushnil(L); lua_next(L, 2); lua_settop(L, 3)) {
    lua_pushvalue(L, 1);
    lua_pushcclosure(L, object_method, 2);
    lua_pushvalue(L, 3);
    lua_insert(L, -2);
    lua_rawset(L, 2);
  }
  lua_settop(L, 1);
  return 1;
}

static const char lua_classes[] =
    "archard.lua_classes"; /* registry key of the table that maps each __name to its metatable */

/* class(metatable) completes the metatable of a class of objects made in Lua, and returns it. Its
 * __index returns the methods in __methods and the fields of the object, and raises errors for
 * unknown names. A field in __fields may be nil. The text of __tostring is escaped. */
static int module_class(lua_State *L) {
  module_methods(L);
  lua_newtable(L);
  lua_getfield(L, 1, "__methods");
  gather(L);
  lua_getfield(L, 1, "__fields");
  gather(L);
  if (lua_getfield(L, 1, "__methods") != LUA_TTABLE) {
    lua_pop(L, 1);
    lua_newtable(L);
  }
  lua_pushvalue(L, 2);
  lua_getfield(L, 1, "__name");
  lua_pushcclosure(L, object_index, 3);
  lua_setfield(L, 1, "__index");
  lua_getfield(L, 1, "__name");
  lua_pushcclosure(L, object_newindex, 1);
  lua_setfield(L, 1, "__newindex");
  if (lua_getfield(L, 1, "__tostring") != LUA_TNIL) {
    lua_pushcclosure(L, error_plain_result, 1);
    lua_setfield(L, 1, "__tostring");
  }
  lua_settop(L, 1);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, lua_classes);
  lua_getfield(L, 1, "__name");
  lua_pushvalue(L, 1);
  lua_settable(L, -3);
  lua_settop(L, 1);
  return 1;
}

/* class_named(name) returns the metatable that class() completed for the class `name`, or nil. */
static int module_class_named(lua_State *L) {
  luaL_checkstring(L, 1);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, lua_classes);
  lua_pushvalue(L, 1);
  lua_rawget(L, -2);
  return 1;
}

/* is(value, name) returns true if the value is an object of the class `name` (its __name). */
static int module_is(lua_State *L) {
  const char *name = luaL_checkstring(L, 2);
  lua_settop(L, 1);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, lua_classes);
  lua_getfield(L, 2, name);
  lua_pushboolean(L, lua_getmetatable(L, 1) && lua_rawequal(L, -1, 3));
  return 1;
}

/* object(fields, class) returns a read-only object of the class with the fields of the table
 * `fields`. */
static int module_object(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  lua_newuserdatauv(L, 0, 1);
  lua_pushvalue(L, 1);
  lua_setiuservalue(L, -2, 1);
  lua_pushvalue(L, 2);
  lua_setmetatable(L, -2);
  return 1;
}

int luaopen_archard_strict(lua_State *L) {
  static const luaL_Reg functions[] = {{"table", module_table},
                                       {"refuse", module_refuse},
                                       {"methods", module_methods},
                                       {"class", module_class},
                                       {"class_named", module_class_named},
                                       {"is", module_is},
                                       {"object", module_object},
                                       {NULL, NULL}};
  luaL_newlib(L, functions);
  return 1;
}

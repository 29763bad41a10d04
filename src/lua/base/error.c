/* Creates error objects and their text. A stop requested by the user raises the text "interrupted"
 * instead of an object. */
#include "lua/base/error.h"
#include "lua/base/interrupt.h"

#include <lauxlib.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char kind[] = "archard.error";

/* Pushes field `name` of the error object at index 1, or "" if the field is not a string. */
static const char *push_text(lua_State *L, const char *name) {
  if (lua_getfield(L, 1, name) != LUA_TSTRING) {
    lua_pop(L, 1);
    lua_pushliteral(L, "");
  }
  return lua_tostring(L, -1);
}

/* Metamethod __tostring: returns "file:line: where: message (update 12)" for an error object. */
static int error_tostring(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const char *position = push_text(L, "position");
  const char *where = push_text(L, "where");
  const char *message = push_text(L, "message");
  if (lua_getfield(L, 1, "step") == LUA_TNUMBER)
    lua_pushfstring(L, "%s%s: %s (update %I)", position, where, message,
                    (LUAI_UACINT)lua_tointeger(L, -1));
  else
    lua_pushfstring(L, "%s%s: %s", position, where, message);
  return 1;
}

/* Metamethod __concat: makes "failed: " .. err valid for error objects. */
static int error_concat(lua_State *L) {
  luaL_tolstring(L, 1, NULL);
  luaL_tolstring(L, 2, NULL);
  lua_concat(L, 2);
  return 1;
}

static void set_text(lua_State *L, const char *name, const char *text) {
  lua_pushstring(L, text);
  lua_setfield(L, -2, name);
}

int error_user_level(lua_State *L) {
  lua_Debug frame;
  for (int level = 1; lua_getstack(L, level, &frame); level++) {
    lua_getinfo(L, "S", &frame);
    if (strcmp(frame.what, "main") == 0) return level;
    if (strcmp(frame.what, "Lua") == 0 && strncmp(frame.source, "@scripts/", 9) != 0) return level;
  }
  return 0;
}

void error_push_plain(lua_State *L, const char *text) {
  const size_t capacity = 4 * strlen(text) + 1;
  char *shown = lua_newuserdatauv(L, capacity, 0);
  arc_show_text(text, shown, capacity);
  lua_pushstring(L, shown);
  lua_remove(L, -2);
}

int error_plain_result(lua_State *L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  if (lua_type(L, -1) == LUA_TSTRING) error_push_plain(L, lua_tostring(L, -1));
  return 1;
}

/* Pops the message on top of the stack and pushes an error object that contains it. */
static void push_object(lua_State *L, arc_status code, const char *where) {
  error_push_plain(L, lua_tostring(L, -1));
  lua_remove(L, -2);
  lua_createtable(L, 0, 6);
  lua_insert(L, -2);
  lua_setfield(L, -2, "message");
  set_text(L, "code", arc_status_name(code));
  set_text(L, "where", where);
  luaL_where(L, error_user_level(L));
  lua_setfield(L, -2, "position");
  if (luaL_newmetatable(L, kind)) {
    lua_pushcfunction(L, error_tostring);
    lua_setfield(L, -2, "__tostring");
    lua_pushcfunction(L, error_concat);
    lua_setfield(L, -2, "__concat");
  }
  lua_setmetatable(L, -2);
}

/* Raises the error on top of the stack. The function is declared as noreturn, because lua_error is
 * not. */
__attribute__((noreturn)) static void throw(lua_State * L) {
  lua_error(L);
  abort();
}

void error_raise(lua_State *L, arc_status code, const char *where, const char *format, ...) {
  luaL_checkstack(L, 10, where);
  va_list arguments;
  va_start(arguments, format);
  lua_pushvfstring(L, format, arguments);
  va_end(arguments);
  push_object(L, code, where);
  throw(L);
}

void error_check(lua_State *L, arc_status status, const arc_error *error, const char *where,
                 lua_Number step) {
  if (status == ARC_OK) return;
  if (status == ARC_STOPPED && interrupt_pending(NULL)) luaL_error(L, "interrupted");
  luaL_checkstack(L, 10, where);
  lua_pushstring(L, error->message[0] ? error->message : arc_status_text(status));
  push_object(L, status, where);
  if (step >= 0) {
    lua_pushinteger(L, (lua_Integer)step);
    lua_setfield(L, -2, "step");
  }
  throw(L);
}

static int to_text(lua_State *L) {
  luaL_tolstring(L, 1, NULL);
  return 1;
}

/* Pushes the error value on top of the stack as a string. The call is protected, because a
 * __tostring of the user may raise an error. */
static void push_error_text(lua_State *L) {
  lua_pushcfunction(L, to_text);
  lua_pushvalue(L, -2);
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) return;
  lua_pop(L, 1);
  lua_pushfstring(L, "(error value is a %s)", luaL_typename(L, -1));
}

void error_callback(lua_State *L, const char *where, const char *name) {
  if (interrupt_pending(NULL)) throw(L);
  luaL_checkstack(L, 10, where);
  const int cause = lua_gettop(L);
  push_error_text(L);
  lua_pushfstring(L, "%s failed: %s", name, lua_tostring(L, -1));
  push_object(L, ARC_CALLBACK, where);
  lua_pushvalue(L, cause);
  lua_setfield(L, -2, "cause");
  throw(L);
}

/* Pushes the traceback at index 1 without the lines about built-in scripts. */
static int without_own(lua_State *L) {
  luaL_Buffer kept;
  luaL_buffinit(L, &kept);
  for (const char *line = lua_tostring(L, 1), *end; *line; line = end) {
    end = line + strcspn(line, "\n");
    end += *end == '\n';
    if (strncmp(line, "\tscripts/", 9) != 0) luaL_addlstring(&kept, line, (size_t)(end - line));
  }
  luaL_pushresult(&kept);
  return 1;
}

/* Message handler that adds a traceback to plain text while the stack frames still exist. Error
 * objects stay unchanged. */
static int add_traceback(lua_State *L) {
  if (lua_type(L, 1) != LUA_TSTRING) return 1;
  luaL_traceback(L, L, lua_tostring(L, 1), 1);
  lua_replace(L, 1);
  return without_own(L);
}

int error_pcall(lua_State *L, int arguments, int results) {
  int function = lua_gettop(L) - arguments;
  lua_pushcfunction(L, add_traceback);
  lua_insert(L, function);
  int status = lua_pcall(L, arguments, results, function);
  lua_remove(L, function);
  return status;
}

/* Runs chunks in protected calls and prints their error messages and tracebacks. */
#include "cli/chunk.h"

#include "archard/base.h"
#include "lua/base/error.h"
#include "lua/base/interrupt.h"

#include <lauxlib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Replaces an error value of any type by a text. */
static int to_text(lua_State *L) {
  if (lua_type(L, 1) != LUA_TSTRING && luaL_getmetafield(L, 1, "__tostring") == LUA_TNIL)
    lua_pushfstring(L, "(error value is a %s)", luaL_typename(L, 1));
  else
    luaL_tolstring(L, 1, NULL);
  return 1;
}

/* Returns true if the stack from `level` on contains a Lua function other than the chunk. Only
 * then is a traceback useful. */
static int has_callers(lua_State *L, int level) {
  lua_Debug frame;
  for (; lua_getstack(L, level, &frame); level++) {
    lua_getinfo(L, "S", &frame);
    if (strcmp(frame.what, "Lua") == 0) return 1;
  }
  return 0;
}

/* Message handler of lua_pcall that adds a traceback to the message. After an interrupt it adds
 * no traceback and calls no Lua code, because the hook is still active. For an error object the
 * traceback omits the frames of the program's own scripts. */
static int describe(lua_State *L) {
  if (interrupt_pending(NULL)) return 1;
  const int level = lua_istable(L, 1) ? error_user_level(L) : 1;
  to_text(L);
  if (has_callers(L, level)) luaL_traceback(L, L, lua_tostring(L, -1), level);
  return 1;
}

/* Returns the length of `text` without the ending `foot`. If `text` does not have this ending,
 * returns `length`. */
static size_t without(const char *text, size_t length, const char *foot) {
  size_t tail = strlen(foot);
  return length >= tail && strncmp(text + length - tail, foot, tail) == 0 ? length - tail : length;
}

/* Returns the length of a traceback without the frames of this program at its end. */
static size_t without_foot(const char *text) {
  size_t length = without(text, strlen(text), "\n\t[C]: in ?");
  return without(text, length, "\n\t(...tail calls...)");
}

void print_plain(const char *text, size_t length) {
  const size_t capacity = 4 * length + 1;
  char *part = strndup(text, length), *shown = part ? malloc(capacity) : NULL;
  if (shown) arc_show_text(part, shown, capacity);
  fputs(shown ? shown : "not enough memory for a message", stderr);
  free(shown);
  free(part);
}

run_status run_refused(lua_State *L) {
  const int stopped = interrupt_pending(NULL) && !interrupt_exceeded();
  run_status status = stopped ? RUN_INTERRUPTED : RUN_FAILED;
  interrupt_clear();
  lua_pushcfunction(L, to_text);
  lua_insert(L, -2);
  lua_pcall(L, 1, 1, 0);
  const char *text = lua_tostring(L, -1);
  if (text == NULL) text = "(error without a message)";
  fflush(stdout);
  fputs("archard: ", stderr);
  print_plain(text, without_foot(text));
  fputc('\n', stderr);
  lua_pop(L, 1);
  return status;
}

run_status run_call(lua_State *L, int arguments, int results) {
  int base = lua_gettop(L) - arguments;
  lua_pushcfunction(L, describe);
  lua_insert(L, base);
  interrupt_attach(L);
  int status = lua_pcall(L, arguments, results, base);
  interrupt_detach(L);
  lua_remove(L, base);
  return status == LUA_OK ? RUN_OK : run_refused(L);
}

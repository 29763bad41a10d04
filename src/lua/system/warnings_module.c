/* Module `archard.warnings`: collects warnings in worker processes, whose standard error is not
 * shown. */
#include "lua/base/archard.h"

#include <lauxlib.h>
#include <stdio.h>
#include <string.h>

/* The collected warnings. The size is fixed, because warnings may occur in code that must not
 * raise errors. */
static struct {
  char text[1000];
  int continued, full;
} kept;

static void append(const char *text) {
  const size_t used = strlen(kept.text), capacity = sizeof kept.text - used;
  if (!kept.full) kept.full = snprintf(kept.text + used, capacity, "%s", text) >= (int)capacity;
}

static void keep_warning(void *ignored, const char *message, int to_be_continued) {
  (void)ignored;
  if (!kept.continued && !to_be_continued && message[0] == '@') return;
  if (!kept.continued && kept.text[0]) append("; ");
  append(message);
  kept.continued = to_be_continued;
}

/* keep() switches from printing warnings to collecting them. */
static int warnings_keep(lua_State *L) {
  lua_setwarnf(L, keep_warning, NULL);
  return 0;
}

/* take() returns the warnings since its last call, joined by "; ", or nil if there are none. */
static int warnings_take(lua_State *L) {
  if (kept.text[0])
    lua_pushstring(L, kept.text);
  else
    lua_pushnil(L);
  memset(&kept, 0, sizeof kept);
  return 1;
}

int luaopen_archard_warnings(lua_State *L) {
  static const luaL_Reg functions[] = {
      {"keep", warnings_keep}, {"take", warnings_take}, {NULL, NULL}};
  luaL_newlib(L, functions);
  return 1;
}

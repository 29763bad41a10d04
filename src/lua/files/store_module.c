/* Module `archard.store`: functions for run files (archard/store.h). The user's interfaces are
 * study, wear:save and session in scripts/. */
#include "lua/base/array.h"
#include "lua/base/archard.h"
#include "lua/base/call.h"
#include "lua/base/file_name.h"
#include "lua/files/store_module.h"
#include "lua/base/error.h"

#include <math.h>
#include <stdlib.h>

static const char *const mode_names[] = {"read", "write", "create", NULL};
static const char *const use_names[] = {"settings", "definition", "results", NULL};

static arc_store *self(lua_State *L, const char *where) {
  return box_self_idle(L, &store_class, where)->thing;
}

int store_id_argument(lua_State *L, int index, const char *where) {
  static const arc_setting id = {.name = "case", .kind = ARC_WHOLE, .low = 1, .high = 1e9};
  lua_pushvalue(L, index);
  double value = args_number(L, (args_location){where, ""}, &id);
  lua_pop(L, 1);
  return (int)value;
}

/* --- opening ---------------------------------------------------------------------------------- */

static void close_store(void *thing) {
  arc_store *store = thing;
  arc_store_close(&store);
}

arc_store *store_push(lua_State *L, const char *path, arc_store_mode mode, const char *where) {
  arc_error error = {0};
  arc_store *store = NULL;
  box *made = box_push(L, &store_class);
  arc_status status = arc_store_open(path, mode, &store, &error);
  made->thing = store;
  error_check(L, status, &error, where, -1);
  return store;
}

/* store.open(path, mode) opens a run file and returns a store object. `mode` is "read" (default),
 * "write" or "create". */
static int store_open(lua_State *L) {
  int mode = args_choice(L, 2, (args_location){"store.open", ""}, "mode", mode_names, 0);
  const char *path = path_argument(L, 1, "store.open", "file");
  store_push(L, path, (arc_store_mode)mode, "store.open");
  return 1;
}

/* store:publish() finishes a file begun by store.replace: it renames the temporary file to the
 * final name and closes the file. */
static int store_publish(lua_State *L) {
  box *held = box_self_idle(L, &store_class, "store:publish");
  arc_error error = {0};
  arc_store *store = held->thing;
  const arc_status status = arc_store_publish(&store, &error);
  held->thing = store;
  error_check(L, status, &error, "store:publish", -1);
  return 0;
}

/* store.replace(path, kind) returns a new store in a temporary file. store:publish then replaces
 * the file `path` by the temporary file. */
static int store_replace(lua_State *L) {
  const char *path = path_argument(L, 1, "store.replace", "file");
  const char *kind = luaL_checkstring(L, 2);
  arc_error error = {0};
  arc_store *store = NULL;
  box *made = box_push(L, &store_class);
  arc_status status = arc_store_replace(path, kind, &store, &error);
  made->thing = store;
  error_check(L, status, &error, "store.replace", -1);
  return 1;
}

/* --- functions of the whole file -------------------------------------------------------------- */

/* Defines a Lua method of a store that has no arguments and calls one function of the engine. */
#define PLAIN(name, call)                                                                          \
  static int store_##name(lua_State *L) {                                                          \
    arc_error error = {0};                                                                         \
    arc_store *store = self(L, "store:" #name);                                                    \
    error_check(L, call(store, &error), &error, "store:" #name, -1);                               \
    return 0;                                                                                      \
  }
PLAIN(begin, arc_store_begin)
PLAIN(commit, arc_store_commit)
PLAIN(check, arc_store_check)
PLAIN(release, arc_store_release)

static int store_rollback(lua_State *L) {
  arc_store_rollback(self(L, "store:rollback"));
  return 0;
}

/* store:info(name) returns the text of the note `name`, or nil if the file has no such note. */
static int store_info(lua_State *L) {
  arc_error error = {0};
  char *text = NULL;
  arc_status status = arc_store_info(self(L, "store:info"), luaL_checkstring(L, 2), &text, &error);
  error_check(L, status, &error, "store:info", -1);
  lua_pushstring(L, text); /* pushes nil if `text` is NULL */
  free(text);
  return 1;
}

/* store:set_info(name, text) stores a note, or removes the note if `text` is nil. */
static int store_set_info(lua_State *L) {
  arc_error error = {0};
  arc_store *store = self(L, "store:set_info");
  const char *name = luaL_checkstring(L, 2), *text = luaL_optstring(L, 3, NULL);
  error_check(L, arc_store_set_info(store, name, text, &error), &error, "store:set_info", -1);
  return 0;
}

/* store:merge(path) adds the finished cases of another file. */
static int store_merge(lua_State *L) {
  arc_error error = {0};
  arc_store *store = self(L, "store:merge");
  const char *path = path_argument(L, 2, "store:merge", "file");
  error_check(L, arc_store_merge(store, path, &error), &error, "store:merge", -1);
  return 0;
}

/* --- cases ------------------------------------------------------------------------------------ */

/* store:add(id, label) adds a case. */
static int store_add(lua_State *L) {
  arc_error error = {0};
  arc_store *store = self(L, "store:add");
  int id = store_id_argument(L, 2, "store:add");
  error_check(L, arc_store_add(store, id, luaL_checkstring(L, 3), &error), &error, "store:add", -1);
  return 0;
}

/* store:mark(id, status, message, seconds) sets the status of a case, and optionally a message and
 * the computing time. */
static int store_mark(lua_State *L) {
  static const char where[] = "store:mark";
  arc_error error = {0};
  arc_store *store = self(L, where);
  int id = store_id_argument(L, 2, where);
  int mark = args_choice(L, 3, (args_location){where, ""}, "status", arc_case_status_names, -1);
  const char *message = luaL_optstring(L, 4, NULL);
  double seconds = luaL_optnumber(L, 5, (lua_Number)NAN);
  arc_status status = arc_store_mark(store, id, (arc_case_status)mark, message, seconds, &error);
  error_check(L, status, &error, where, -1);
  return 0;
}

static void push_case(lua_State *L, const arc_case *one) {
  lua_createtable(L, 0, 5);
  lua_pushinteger(L, one->id);
  lua_setfield(L, -2, "id");
  lua_pushstring(L, one->label);
  lua_setfield(L, -2, "label");
  lua_pushstring(L, arc_case_status_names[one->status]);
  lua_setfield(L, -2, "status");
  if (one->message[0]) {
    lua_pushstring(L, one->message);
    lua_setfield(L, -2, "message");
  }
  if (isfinite(one->seconds)) array_set_number(L, "seconds", one->seconds);
}

/* Pushes the list of cases. Lua arguments: the address of the cases and their number. The address
 * is light userdata, so that the caller can free the cases if this function raises an error. */
static int push_cases(lua_State *L) {
  const arc_case *cases = lua_touserdata(L, 1);
  size_t count = (size_t)lua_tointeger(L, 2);
  lua_createtable(L, (int)count, 0);
  for (size_t i = 0; i < count; i++) {
    push_case(L, &cases[i]);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
  return 1;
}

/* store:cases() returns a list of { id=, label=, status=, message=, seconds= }. */
static int store_cases(lua_State *L) {
  arc_error error = {0};
  arc_case *cases;
  size_t count;
  arc_status status = arc_store_cases(self(L, "store:cases"), &cases, &count, &error);
  error_check(L, status, &error, "store:cases", -1);
  lua_pushcfunction(L, push_cases);
  lua_pushlightuserdata(L, cases);
  lua_pushinteger(L, (lua_Integer)count);
  int failed = lua_pcall(L, 2, 1, 0);
  free(cases);
  return failed ? lua_error(L) : 1;
}

/* store:values(id, use) returns the named values of a case as a table. `use` is "settings"
 * (default), "definition" or "results". */
static int store_values(lua_State *L) {
  static const char where[] = "store:values";
  arc_store *store = self(L, where);
  int id = store_id_argument(L, 2, where);
  int use = args_choice(L, 3, (args_location){where, ""}, "use", use_names, 0);
  store_push_values(L, store, id, (arc_value_use)use, where);
  return 1;
}

/* store:set_values(id, use, table) stores the fields of the table as named values of a case. `use`
 * is "settings", "definition" or "results". */
static int store_set_values(lua_State *L) {
  static const char where[] = "store:set_values";
  arc_store *store = self(L, where);
  int id = store_id_argument(L, 2, where);
  int use = args_choice(L, 3, (args_location){where, ""}, "use", use_names, -1);
  luaL_checktype(L, 4, LUA_TTABLE);
  store_write_values(L, store, id, (arc_value_use)use, 4, where);
  return 0;
}

/* --- the class -------------------------------------------------------------------------------- */

static int store_path(lua_State *L) {
  lua_pushstring(L, arc_store_path(self(L, "store")));
  return 1;
}

static int store_tostring(lua_State *L) {
  lua_pushfstring(L, "run file %s", arc_store_path(self(L, "store")));
  return 1;
}

static const luaL_Reg methods[] = {
    {"publish", store_publish},
    {"begin", store_begin},
    {"commit", store_commit},
    {"rollback", store_rollback},
    {"check", store_check},
    {"release", store_release},
    {"info", store_info},
    {"set_info", store_set_info},
    {"merge", store_merge},
    {"add", store_add},
    {"mark", store_mark},
    {"cases", store_cases},
    {"values", store_values},
    {"set_values", store_set_values},
    {"save", store_save},
    {"history", store_history},
    {"surfaces", store_surfaces},
    {"wear", store_wear},
    {NULL, NULL},
};

static const luaL_Reg fields[] = {{"path", store_path}, {NULL, NULL}};

const box_class store_class = {
    .name = "store",
    .methods = methods,
    .fields = fields,
    .tostring = store_tostring,
    .destroy = close_store,
};

int luaopen_archard_store(lua_State *L) {
  static const luaL_Reg functions[] = {{"open", store_open},
                                       {"replace", store_replace},
                                       {"note_saved", store_note_saved},
                                       {NULL, NULL}};
  call_new_library(L, functions);
  return 1;
}

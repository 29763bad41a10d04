/* Saves and opens runs in run files: methods of stores, and wear:save and wear.open for files with
 * one run. */
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/base/file_name.h"
#include "lua/base/scripts.h"
#include "lua/engine/surface_maps.h"
#include "lua/files/store_module.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { most_surfaces = 1000000 };

static arc_store *self(lua_State *L, const char *where) {
  return box_self_idle(L, &store_class, where)->thing;
}

/* --- saving ----------------------------------------------------------------------------------- */

static double read_number(lua_State *L, const char *name) {
  lua_getfield(L, -1, name);
  double value = luaL_checknumber(L, -1);
  lua_pop(L, 1);
  return value;
}

/* Reads one array of the surface table on top of the stack. The buffer of the array is appended to
 * the table `anchors`, which keeps the buffer alive. */
static void read_array(lua_State *L, int anchors, arc_array *array) {
  lua_getfield(L, -1, array->name);
  array->values =
      array_read(L, (args_location){"store:save", "surfaces."}, array->name, &array->size[0]);
  lua_rawseti(L, anchors, (lua_Integer)lua_rawlen(L, anchors) + 1);
  lua_pop(L, 1);
}

/* Reads the table { body=, update=, distance=, x=, h=, y=, p= }, with z in 3-D, on top of the
 * stack. Returns the number of its arrays. */
static size_t read_surface(lua_State *L, int anchors, arc_array *arrays) {
  arc_array array = {
      .update = read_number(L, "update"), .distance = read_number(L, "distance"), .size = {0, 1}};
  size_t count = 0;
  lua_getfield(L, -1, "body");
  array.body = body_argument(L, lua_gettop(L), "store:save", NULL, -1);
  lua_pop(L, 1);
  for (const char *const *name = arc_surface_names; *name; name++) {
    array.name = *name;
    read_array(L, anchors, &array);
    arrays[count++] = array;
  }
  array.name = "z";
  const int is_map = lua_getfield(L, -1, array.name) != LUA_TNIL;
  lua_pop(L, 1);
  if (is_map) {
    read_array(L, anchors, &array);
    arrays[count++] = array;
  }
  return count;
}

/* Saves a run with its present surfaces and with `count` arrays of earlier surfaces. */
static arc_status save(arc_store *store, int id, const arc_wear *wear, const arc_array *earlier,
                       size_t count, arc_error *error) {
  arc_array *present;
  size_t more;
  arc_status status = arc_wear_surfaces(wear, &present, &more, error);
  arc_array *all = status == ARC_OK ? malloc((count + more) * sizeof *all) : NULL;
  if (all) {
    if (count > 0) memcpy(all, earlier, count * sizeof *all);
    memcpy(all + count, present, more * sizeof *all);
    status = arc_store_save(store, id, wear, all, count + more, error);
  } else if (status == ARC_OK) {
    status = arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a run");
  }
  free(all);
  free(present);
  return status;
}

/* Reads the list of surfaces at index 4 as arrays. Pushes the arrays, and a table that keeps their
 * numbers alive. */
static arc_array *read_surfaces(lua_State *L, const char *where, size_t *arrays) {
  enum { most_names = 16 };
  const size_t count = lua_istable(L, 4)
                           ? array_length(L, (args_location){where, ""}, "surfaces", most_surfaces)
                           : 0;
  arc_array *list = lua_newuserdatauv(L, (most_names * count + 1) * sizeof *list, 0);
  lua_newtable(L);
  const int anchors = lua_gettop(L);
  *arrays = 0;
  for (size_t i = 0; i < count; i++) {
    if (lua_rawgeti(L, 4, (lua_Integer)i + 1) != LUA_TTABLE)
      args_refuse(L, (args_location){where, ""}, "surfaces", "a list of tables");
    *arrays += read_surface(L, anchors, list + *arrays);
    lua_pop(L, 1);
  }
  return list;
}

/* store:save(id, wear, surfaces) saves a run and earlier surfaces. */
int store_save(lua_State *L) {
  static const char where[] = "store:save";
  lua_settop(L, 4);
  arc_store *store = self(L, where);
  const arc_wear *wear = box_check(L, 3, &wear_class, where)->thing;
  size_t count;
  const arc_array *surfaces = read_surfaces(L, where, &count);
  arc_error error = {0};
  arc_status status = save(store, store_id_argument(L, 2, where), wear, surfaces, count, &error);
  error_check(L, status, &error, where, -1);
  return 0;
}

/* --- history and surfaces --------------------------------------------------------------------- */

/* Calls `push` by lua_pcall with the address and the length of the block, and then frees the block.
 * The result of `push` (or the error) stays on top of the stack. */
static int push_and_free(lua_State *L, lua_CFunction push, void *block, size_t count) {
  lua_pushcfunction(L, push);
  lua_pushlightuserdata(L, block);
  lua_pushinteger(L, (lua_Integer)count);
  int failed = lua_pcall(L, 2, 1, 0);
  free(block);
  return failed ? lua_error(L) : 1;
}

static int push_history(lua_State *L) {
  const arc_wear_record *records = lua_touserdata(L, 1);
  records_push_columns(L, records, (size_t)lua_tointeger(L, 2));
  return 1;
}

/* store:history(id) returns the columns by name, or nil if no history is stored. */
int store_history(lua_State *L) {
  arc_error error = {0};
  arc_wear_record *history;
  size_t count;
  arc_status status = arc_store_history(
      self(L, "store:history"), store_id_argument(L, 2, "store:history"), &history, &count, &error);
  error_check(L, status, &error, "store:history", -1);
  if (count > 0) return push_and_free(L, push_history, history, count);
  free(history);
  return 0;
}

static int push_surfaces(lua_State *L) {
  surface_push_list(L, lua_touserdata(L, 1), (size_t)lua_tointeger(L, 2));
  return 1;
}

/* store:surfaces(id) returns a list, see surface_push_list. */
int store_surfaces(lua_State *L) {
  arc_error error = {0};
  arc_array *surfaces;
  size_t count;
  arc_status status =
      arc_store_surfaces(self(L, "store:surfaces"), store_id_argument(L, 2, "store:surfaces"),
                         &surfaces, &count, &error);
  error_check(L, status, &error, "store:surfaces", -1);
  return push_and_free(L, push_surfaces, surfaces, count);
}

/* --- restoring runs --------------------------------------------------------------------------- */

static void free_stored(void *thing) {
  arc_stored_run_free(thing);
}

static int stored_tostring(lua_State *L) {
  lua_pushliteral(L, "a stored definition");
  return 1;
}

/* Class of boxes that own an arc_stored_run, so that Lua errors leak nothing. */
static const box_class stored_class = {.name = "stored run",
                                       .tostring = stored_tostring,
                                       .destroy = free_stored,
                                       .value = sizeof(arc_stored_run)};

static arc_stored_run *push_stored(lua_State *L, arc_store *store, int id, const char *where) {
  arc_error error = {0};
  arc_stored_run *run = box_push(L, &stored_class)->thing;
  error_check(L, arc_store_definition(store, id, run, &error), &error, where, -1);
  return run;
}

/* Writes the settings that may be functions to `list`. The last item of the list has the name
 * NULL. */
static void list_functions(arc_setting list[ARC_WEAR_SETTINGS_COUNT + 1]) {
  int count = 0;
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (s->forms & ARC_FUNCTION) list[count++] = *s;
  list[count] = (arc_setting){.name = NULL};
}

/* Raises an error unless the user passes functions for all settings that were functions in the
 * saved run, and for no other settings. Pushes the holder of the functions, or nil without
 * functions. */
static void push_functions(lua_State *L, arc_stored_run *run, int given, const char *where) {
  args_location location = {where, ""};
  arc_setting again[ARC_WEAR_SETTINGS_COUNT + 1];
  list_functions(again);
  if (given) args_check_names(L, given, location, again);
  int any = 0;
  for (const arc_setting *s = again; s->name; s++) {
    const int was =
        run->functions[arc_setting_find(arc_wear_settings, s->name) - arc_wear_settings];
    const int type = args_get(L, given ? given : lua_gettop(L), s->name);
    if (was && type != LUA_TFUNCTION)
      args_refuse(L, location, s->name, "a function, as when the run was saved");
    if (!was && type != LUA_TNIL)
      args_refuse(L, location, s->name, "no value, since the run file contains it");
    lua_pop(L, 1);
    any = any || was;
  }
  lua_pushnil(L);
  if (any) functions_read(L, given, 0, location, &run->def);
}

void store_push_wear(lua_State *L, arc_store *store, int id, int given, const char *where) {
  arc_error error = {0};
  luaL_checkstack(L, 12, where);
  arc_stored_run *run = push_stored(L, store, id, where);
  box *stored = box_test(L, -1, &stored_class);
  push_functions(L, run, given, where);
  int holder = lua_gettop(L);
  arc_model *model = model_push_given(L, &run->model, run->given[0] ? run->given : NULL, where);
  arc_wear *wear = NULL;
  box *made = box_push(L, &wear_class);
  box_keep(L, -2);
  lua_pushvalue(L, holder);
  lua_setiuservalue(L, -2, RUN_FUNCTIONS);
  arc_status status = arc_store_restore(store, id, model, &run->def, &wear, &error);
  made->thing = wear;
  box_empty(stored, &stored_class);
  error_check(L, status, &error, where, -1);
  wear_note_saved(made);
  box_weigh(L, arc_wear_bytes(wear));
}

/* store:wear(id, functions) returns the stored wear object. */
int store_wear(lua_State *L) {
  int given = lua_istable(L, 3) ? 3 : 0;
  store_push_wear(L, self(L, "store:wear"), store_id_argument(L, 2, "store:wear"), given,
                  "store:wear");
  return 1;
}

/* store.note_saved(wear) marks the present state of a run as saved in a file. */
int store_note_saved(lua_State *L) {
  box *made = lua_touserdata(L, 1);
  box_check(L, 1, &wear_class, "store.note_saved");
  wear_note_saved(made);
  return 0;
}

/* Stores the values of the last record of a run as the results of the case. */
static arc_status write_results(arc_store *store, const arc_wear_record *last, arc_error *error) {
  const arc_value values[] = {
#define RESULT(column, unit, range, rule, text)                                                    \
  {.kind = ARC_VALUE_NUMBER, .name = #column, .number = last->column},
      ARC_WEAR_COLUMNS(RESULT)};
  return arc_store_set_values(store, 1, ARC_RESULTS, values, sizeof values / sizeof *values, error);
}

static arc_status write_run(arc_store *store, const arc_wear *wear, arc_error *error) {
  arc_status status = arc_store_begin(store, error);
  if (status == ARC_OK) status = arc_store_add(store, 1, "wear", error);
  if (status == ARC_OK) status = save(store, 1, wear, NULL, 0, error);
  if (status == ARC_OK) status = write_results(store, arc_wear_last(wear), error);
  if (status == ARC_OK) status = arc_store_mark(store, 1, ARC_CASE_DONE, NULL, (double)NAN, error);
  return status == ARC_OK ? arc_store_commit(store, error) : status;
}

/* wear:save(path) saves the run and returns the wear object. */
int wear_save(lua_State *L) {
  const arc_wear *wear = wear_self(L, "wear:save");
  lua_settop(L, 2);
  const char *path = path_argument(L, 2, "wear:save", "path");
  arc_error error = {0};
  arc_store *store;
  arc_status status = arc_store_replace(path, "wear", &store, &error);
  if (status == ARC_OK) status = write_run(store, wear, &error);
  if (status == ARC_OK) status = arc_store_publish(&store, &error);
  arc_store_close(&store);
  error_check(L, status, &error, "wear:save", -1);
  wear_note_saved(lua_touserdata(L, 1));
  lua_settop(L, 1);
  return 1;
}

/* Returns the number of the only case in the file. Raises an error if the file has several cases
 * or no case. */
static int only_case(lua_State *L, arc_store *store) {
  arc_error error = {0};
  arc_case *cases;
  size_t count;
  error_check(L, arc_store_cases(store, &cases, &count, &error), &error, "wear.open", -1);
  int id = count == 1 ? cases[0].id : 0;
  free(cases);
  if (id > 0) return id;
  error_raise(L, ARC_ARGUMENT, "wear.open",
              "%s: expected a file with one run, or a case number; the file has %d cases",
              arc_store_path(store), (int)count);
}

/* Returns true if the file has a joint's run. Raises an error for session files, which session.open
 * reads. */
static int is_of_joint(lua_State *L, arc_store *store) {
  arc_error error = {0};
  char *kind = NULL;
  error_check(L, arc_store_info(store, "kind", &kind, &error), &error, "wear.open", -1);
  const int session = kind && strcmp(kind, "session") == 0,
            joint = kind && strcmp(kind, "joint") == 0;
  free(kind);
  if (session)
    error_raise(L, ARC_ARGUMENT, "wear.open",
                "%s: expected a run file of kind wear or study, got a session (use session.open)",
                arc_store_path(store));
  return joint;
}

/* Pushes a joint's run from a file with one run (`id` 0) or from case `id` of a study. If the
 * stored run is not a joint's run, pushes nil and returns 0. The path is at index 1, the table of
 * functions at index 3. */
static int open_joint(lua_State *L, int id) {
  script_require(L, "archard.joint.file");
  lua_getfield(L, -1, id > 0 ? "open_case" : "open");
  lua_pushvalue(L, 1);
  lua_pushvalue(L, 3);
  lua_pushinteger(L, id);
  lua_call(L, 3, 1);
  return !lua_isnil(L, -1);
}

/* wear.open(path, case, { k=, alpha=, jump=, local_factor= }) returns the stored run. The case may
 * be omitted if the file has one run, and the table if no setting of the run was a function. */
int wear_open(lua_State *L) {
  lua_settop(L, 3);
  const char *path = path_argument(L, 1, "wear.open", "path");
  if (lua_istable(L, 2)) {
    lua_replace(L, 3);
    lua_pushnil(L);
    lua_insert(L, 2);
    lua_settop(L, 3);
  }
  int id = lua_isnil(L, 2) ? 0 : store_id_argument(L, 2, "wear.open"),
      given = lua_istable(L, 3) ? 3 : 0;
  arc_store *store = store_push(L, path, ARC_STORE_READ, "wear.open");
  box *opened = box_test(L, -1, &store_class);
  if (is_of_joint(L, store)) {
    box_empty(opened, &store_class);
    return open_joint(L, 0);
  }
  if (id == 0) id = only_case(L, store);
  if (open_joint(L, id)) {
    box_empty(opened, &store_class);
    return 1;
  }
  store_push_wear(L, store, id, given, "wear.open");
  box_empty(opened, &store_class);
  return 1;
}

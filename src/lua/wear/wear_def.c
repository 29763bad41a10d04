/* Class wear: reads the definition table of a run. */
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

#include <string.h>

/* --- series by distance ----------------------------------------------------------------------- */

static const arc_setting series_fields[] = {
    ARGS_OTHER("distance"),
    ARGS_OTHER("value"),
    {.name = NULL},
};

/* If the value of the setting is a table { distance=, value= }, reads the table as a series, whose
 * buffers stay on the stack. Any other value removes the series. The engine checks the numbers. */
static void push_series(lua_State *L, int index, args_location location, const arc_setting *s,
                        arc_wear_def *def) {
  arc_series *series = (arc_series *)(void *)((char *)def + s->series);
  size_t distances = 0, values = 0;
  const int type = args_get(L, index, s->name);
  if (type != LUA_TNIL) *series = (arc_series){0};
  if (type != LUA_TTABLE) return;
  int table = lua_gettop(L);
  args_location inside = {location.where, lua_pushfstring(L, "%s.", s->name)};
  args_check_names(L, table, inside, series_fields);
  lua_getfield(L, table, "distance");
  const double *distance = array_read(L, inside, "distance", &distances);
  lua_getfield(L, table, "value");
  const double *value = array_read(L, inside, "value", &values);
  if (distances != values || distances == 0 || distances > 1000000)
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields '%s.distance' and '%s.value': expected two arrays of equal length, got %d "
                "and %d numbers",
                s->name, s->name, (int)distances, (int)values);
  *series = (arc_series){(int)distances, distance, value};
}

static void read_all_series(lua_State *L, int index, args_location location, arc_wear_def *def) {
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (s->forms & ARC_SERIES) push_series(L, index, location, s, def);
}

/* --- cycles and distance ---------------------------------------------------------------------- */

/* Distributes `cycles`, which is the total for all blocks of loading. If the last block has no
 * `cycles`, it gets the remaining cycles. If the user gave no distance, the run ends after all
 * blocks. */
static void share_cycles(lua_State *L, args_location location, wear_request *request,
                         int distance_given) {
  arc_wear_def *def = &request->def;
  arc_loading *last = (arc_loading *)(size_t)&def->loading[def->blocks - 1];
  double before = request->cycle_before;
  for (int b = 0; b + 1 < def->blocks; b++) before += def->loading[b].cycles;
  if (request->cycles > 0 && (isfinite(last->cycles) || !(request->cycles > before)))
    error_raise(L, ARC_ARGUMENT, location.where,
                "field 'cycles': expected more than the %s cycles of all blocks of loading but the "
                "last, and no cycles in the last block; got %s",
                args_show_number(L, before), args_show_number(L, request->cycles));
  if (request->cycles > 0) last->cycles = request->cycles - before;
  if (!distance_given && isfinite(last->cycles)) def->distance = 0;
  request->cycles = 0;
}

arc_wear_def wear_request_settle(const wear_request *request, const arc_model_def *model) {
  arc_wear_def def = request->def;
  if (!request->own_k) arc_wear_def_of_bodies(&def, model);
  if (!request->own_steps) arc_wear_def_usual(&def, model);
  if (request->cycles > 0)
    def.distance = request->distance_before +
                   (request->cycles - request->cycle_before) * arc_wear_def_sliding(&def, model);
  return def;
}

/* --- the definition table --------------------------------------------------------------------- */

/* Raises an error for settings that are allowed only for a new run. */
static void refuse_changes(lua_State *L, int index, args_location location) {
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (s->forms & ARC_FIXED && args_given(L, index, s->name))
      error_raise(
          L, ARC_ARGUMENT, location.where,
          "field '%s' cannot be changed in a run; create a new run from its worn shape, wear{ worn "
          "= w, ... }",
          s->name);
}

/* Raises an error if a changed run would end before its present position. */
static void check_ahead(lua_State *L, args_location location, const wear_request *request) {
  const double cycles = request->cycles, distance = request->def.distance;
  if (cycles > 0 && cycles < request->cycle_before)
    error_raise(L, ARC_ARGUMENT, location.where,
                "field 'cycles': the run is already at cycle %s, beyond %s",
                args_show_number(L, request->cycle_before), args_show_number(L, cycles));
  if (distance > 0 && distance < request->distance_before)
    error_raise(
        L, ARC_ARGUMENT, location.where,
        "field 'distance': the run is already at %s mm, beyond %s mm (both from the start of the "
        "run)",
        args_show_number(L, request->distance_before), args_show_number(L, distance));
}

static wear_request begin_request(lua_State *L, int index, int changed, args_location location) {
  wear_request request = {.def = arc_wear_default()};
  if (!changed) return request;
  const arc_wear *wear = box_check(L, changed, &wear_class, location.where)->thing;
  refuse_changes(L, index, location);
  request.own_k = 1;
  request.def = *arc_wear_definition(wear);
  request.distance_before = arc_wear_last(wear)->distance;
  request.cycle_before = arc_wear_last(wear)->cycle;
  return request;
}

/* Applies a new loading, which also defines the motion. If the user set no load, the nominal load
 * of a new run becomes the largest load of the loading. */
static void settle_loading(lua_State *L, int index, args_location location, wear_request *request,
                           int changed) {
  if (args_given(L, index, "stroke"))
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields 'stroke' and 'loading': expected one of them, got both");
  if (args_given(L, index, "tangential"))
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields 'tangential' and 'loading': expected one of them, got both (a block of "
                "loading has a field 'tangential')");
  request->def.tangential = 0;
  share_cycles(L, location, request, args_given(L, index, "distance"));
  const double largest = loading_largest(&request->def);
  if (!changed && !args_given(L, index, "load") && largest > 0) request->def.load = largest;
}

/* Writes the settings that are allowed for a new run, or for a changed run, to `list`. */
static void list_settings(arc_setting list[ARC_WEAR_SETTINGS_COUNT + 2], int changed) {
  int count = 0;
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (!(changed && s->forms & ARC_FIXED)) list[count++] = *s;
  if (changed)
    list[count++] = (arc_setting)ARGS_OTHER("mesh"); /* wear_class.c reads this field of wear:set */
  list[count] = (arc_setting){.name = NULL};
}

static void read_cycles(lua_State *L, int index, args_location location, wear_request *request) {
  static const arc_setting cycles = {.name = "cycles", .unit = "cycles", ARC_RANGE_ABOVE(0)};
  if (args_get(L, index, cycles.name) != LUA_TNIL)
    request->cycles = args_number(L, location, &cycles);
  lua_pop(L, 1);
}

/* Returns true if the user set a jump other than "auto". */
static int chooses_jump(lua_State *L, int index) {
  const int type = args_get(L, index, "jump");
  const int chooses =
      type != LUA_TNIL && !(type == LUA_TSTRING && strcmp(lua_tostring(L, -1), "auto") == 0);
  lua_pop(L, 1);
  return chooses;
}

/* Returns true if the default scheme applies: to a new run without scheme and jump, and to a
 * changed run if the user sets jump = "auto", or a law that jumps, which has no implicit steps with
 * a tolerance. */
static int has_usual_steps(lua_State *L, int index, int changed, const arc_wear_def *def) {
  if (args_given(L, index, "scheme") || chooses_jump(L, index)) return 0;
  const int jumps = arc_law_properties[def->law] & ARC_LAW_JUMPS && def->tolerance > 0;
  return !changed || args_given(L, index, "jump") || (args_given(L, index, "law") && jumps);
}

/* Settles scheme and tolerance of a request. If the user sets the scheme but no tolerance, the
 * default tolerance of the scheme applies. With a jump, the implicit scheme has none. */
static void settle_steps(lua_State *L, int index, int changed, wear_request *request) {
  arc_wear_def *def = &request->def;
  const int own_tolerance = args_given(L, index, "tolerance"), jumps = chooses_jump(L, index);
  request->own_steps = !has_usual_steps(L, index, changed, def);
  if (!request->own_steps) def->scheme = ARC_EXPLICIT;
  if (own_tolerance) return;
  if (!request->own_steps || jumps || def->scheme == ARC_EXPLICIT) def->tolerance = 0;
  const int controlled = def->jump == 0 && !def->jump_function && !jumps && def->tolerance == 0;
  if (args_given(L, index, "scheme") && def->scheme == ARC_IMPLICIT && controlled)
    def->tolerance = ARC_USUAL_TOLERANCE;
}

/* --- coefficients of the bodies --------------------------------------------------------------- */

static const arc_setting of_bodies[ARC_BODIES] = {
    {.name = "k_cylinder", .unit = "mm2/N", ARC_RANGE_FROM(0)},
    {.name = "k_plate", .unit = "mm2/N", ARC_RANGE_FROM(0)},
};

static void refuse_both(lua_State *L, int index, args_location location, const char *of_body) {
  static const char *const of_couple[] = {"k", "alpha"};
  for (int i = 0; i < 2; i++)
    if (args_given(L, index, of_couple[i]))
      error_raise(L, ARC_ARGUMENT, location.where,
                  "fields '%s' and '%s': expected k and alpha, or k_cylinder and k_plate, got both",
                  of_couple[i], of_body);
}

/* Returns the wear coefficient of a body for which the user sets no coefficient. In a changed
 * run this is the present coefficient. For a new run an error is raised. */
static double coefficient_now(lua_State *L, args_location location, const wear_request *request,
                              int body) {
  const arc_wear_def *def = &request->def;
  const int plain = !def->k_function && !def->alpha_function && def->k_series.count == 0 &&
                    def->alpha_series.count == 0;
  if (!request->own_k || !plain)
    error_raise(L, ARC_ARGUMENT, location.where,
                "field '%s': expected a number >= 0 mm2/N together with '%s', got nil",
                of_bodies[body].name, of_bodies[!body].name);
  return def->k * (body == ARC_CYLINDER ? def->alpha : 1 - def->alpha);
}

/* If the user sets k_cylinder and k_plate, replaces the table at `index` by a copy with k and
 * alpha. */
static void read_bodies(lua_State *L, int index, args_location location, wear_request *request) {
  double k[ARC_BODIES];
  int given[ARC_BODIES];
  for (int b = 0; b < ARC_BODIES; b++)
    if ((given[b] = args_given(L, index, of_bodies[b].name)))
      refuse_both(L, index, location, of_bodies[b].name);
  if (!given[ARC_CYLINDER] && !given[ARC_PLATE]) return;
  for (int b = 0; b < ARC_BODIES; b++) {
    args_get(L, index, of_bodies[b].name);
    k[b] = given[b] ? args_number(L, location, &of_bodies[b])
                    : coefficient_now(L, location, request, b);
    lua_pop(L, 1);
  }
  arc_wear_def_partition(&request->def, k);
  args_push_copy(L, index);
  for (int b = 0; b < ARC_BODIES; b++) {
    lua_pushnil(L);
    lua_setfield(L, -2, of_bodies[b].name);
  }
  array_set_number(L, "k", request->def.k);
  array_set_number(L, "alpha", request->def.alpha);
  lua_replace(L, index);
}

/* Raises an error if the user sets `geometry` to a geometry of the model, such as "3-D". */
static void refuse_space(lua_State *L, int index, args_location location) {
  if (args_get(L, index, "geometry") == LUA_TSTRING)
    for (const char *const *name = arc_space_names; *name; name++)
      if (strcmp(*name, lua_tostring(L, -1)) == 0)
        error_raise(L, ARC_ARGUMENT, location.where,
                    "field 'geometry': expected \"moving\" or \"frozen\", got \"%s\", which is a "
                    "geometry of the bodies: give model = { geometry = \"%s\" }",
                    *name, *name);
  lua_pop(L, 1);
}

/* Raises an error if the field `name` is a function, because loads and strokes that vary in a
 * cycle belong in the field `loading`. */
static void refuse_function(lua_State *L, int index, args_location location, const char *name,
                            const char *expected) {
  if (args_get(L, index, name) == LUA_TFUNCTION) args_refuse(L, location, name, expected);
  lua_pop(L, 1);
}

wear_request wear_request_read(lua_State *L, int index, int changed) {
  args_location location = {changed ? "wear:set" : "wear", ""};
  luaL_checkstack(L, 30, "wear");
  wear_request request = begin_request(L, index, changed, location);
  arc_setting settings[ARC_WEAR_SETTINGS_COUNT + 2];
  list_settings(settings, changed);
  read_bodies(L, index, location, &request);
  request.own_k = request.own_k || args_given(L, index, "k") || args_given(L, index, "alpha");
  refuse_space(L, index, location);
  refuse_function(L, index, location, "load",
                  "a number > 0 N, or loading = { load = f } for a load that varies in a cycle");
  refuse_function(L, index, location, "stroke",
                  "a number > 0 mm, or loading = { x = f } for a motion that varies in a cycle");
  args_read(L, index, location, settings, &request.def);
  read_cycles(L, index, location, &request);
  settle_steps(L, index, changed, &request);
  if (request.cycles > 0 && args_given(L, index, "distance"))
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields 'distance' and 'cycles': expected one of them, got both");
  check_ahead(L, location, &request);
  read_all_series(L, index, location, &request.def);
  if (args_given(L, index, "stroke") && args_given(L, index, "tangential"))
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields 'stroke' and 'tangential': expected one of them, got both");
  if (args_given(L, index, "stroke") && args_given(L, index, "track") && request.def.track > 0)
    error_raise(
        L, ARC_ARGUMENT, location.where,
        "fields 'stroke' and 'track': expected one of them, got both (a cycle is a revolution)");
  if (args_given(L, index, "stroke")) request.def.tangential = 0;
  if (args_given(L, index, "stroke") || args_given(L, index, "tangential")) request.def.blocks = 0;
  if (loading_read(L, index, location, &request.def))
    settle_loading(L, index, location, &request, changed);
  else if (request.cycles > 0 && request.def.blocks > 0)
    error_raise(L, ARC_ARGUMENT, location.where,
                "field 'cycles': a run with loading needs a distance");
  int before = 0;
  if (changed && lua_getiuservalue(L, changed, RUN_FUNCTIONS) == LUA_TUSERDATA)
    before = lua_gettop(L);
  functions_read(L, index, before, location, &request.def);
  request.functions = lua_gettop(L);
  return request;
}

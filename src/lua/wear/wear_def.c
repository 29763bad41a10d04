/* Class wear: the definition table of a run. */
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

#include <string.h>

const char *const procedure_names[] = {"auto", "SP", "NSP", NULL};
const char *const scheme_names[] = {"explicit", "implicit", NULL};
const char *const slip_names[] = {"rigid", "total", NULL};
const char *const rule_names[] = {"trapezoid", "simple", NULL};
const char *const geometry_names[] = {"moving", "frozen", NULL};
const char *const update_names[] = {"cycle", "increment", NULL};
const char *const law_names[] = {"archard", "power", "threshold", NULL};

static const args_field k_range = {.name = "k", .kind = ARGS_NUMBER, .high = HUGE_VAL};
static const args_field alpha_range = {.name = "alpha", .kind = ARGS_NUMBER, .high = 1};
static const args_field jump_range = {
    .name = "jump", .kind = ARGS_NUMBER, .high = HUGE_VAL, .open = ARGS_LOW_OPEN};

/* A number in a range; tables and functions are read by push_series and functions_read. */
static void read_coefficient(lua_State *L, args_place place, const args_field *range,
                             const char *expected, double *number, arc_series *series) {
  int type = lua_type(L, -1);
  if (type != LUA_TNUMBER && type != LUA_TTABLE && type != LUA_TFUNCTION)
    args_refuse(L, place, range->name, expected);
  if (type == LUA_TNUMBER) *number = args_number(L, place, range);
  *series = (arc_series){0};
}

static void read_k(lua_State *L, args_place place, const char *name, void *member) {
  arc_wear_def *def = member;
  (void)name;
  read_coefficient(L, place, &k_range,
                   "a number >= 0, a function of the state or a table { distance=, value= }",
                   &def->k, &def->k_series);
}

static void read_alpha(lua_State *L, args_place place, const char *name, void *member) {
  arc_wear_def *def = member;
  (void)name;
  read_coefficient(L, place, &alpha_range,
                   "a number in [0, 1], a function of the state or a table { distance=, value= }",
                   &def->alpha, &def->alpha_series);
}

/* A number of cycles, "auto", or a function. */
static void read_jump(lua_State *L, args_place place, const char *name, void *member) {
  arc_wear_def *def = member;
  int type = lua_type(L, -1);
  def->jump_auto = type == LUA_TSTRING && strcmp(lua_tostring(L, -1), "auto") == 0;
  if (type == LUA_TNUMBER)
    def->jump = args_number(L, place, &jump_range);
  else if (!def->jump_auto && type != LUA_TFUNCTION)
    args_refuse(L, place, name, "a number > 0, \"auto\" or a function of the state");
}

/* The scheme; what belongs to the other one goes, unless it is given too (in the order of the
 * list). */
static void read_scheme(lua_State *L, args_place place, const char *name, void *member) {
  arc_wear_def *def = member;
  def->scheme = (arc_scheme)args_choice(L, -1, place, name, scheme_names, -1);
  if (def->scheme == ARC_EXPLICIT) def->tolerance = 0;
  if (def->scheme == ARC_IMPLICIT) def->jump_auto = 0;
}

static const args_field definition[] = {
    ARGS_READ(wear_request, "scheme", def, read_scheme),
    ARGS_READ(wear_request, "k", def, read_k),
    ARGS_READ(wear_request, "alpha", def, read_alpha),
    ARGS_ABOVE(wear_request, "load", def.load, 0),
    ARGS_ABOVE(wear_request, "stroke", def.stroke, 0),
    ARGS_ABOVE(wear_request, "distance", def.distance, 0),
    ARGS_ABOVE(wear_request, "cycles", cycles, 0),
    ARGS_READ(wear_request, "jump", def, read_jump),
    {.name = "increments",
     .kind = ARGS_WHOLE,
     .offset = offsetof(wear_request, def.increments),
     .low = 2,
     .high = 1e5},
    ARGS_FROM(wear_request, "refresh", def.refresh, 0),
    ARGS_NAMED(wear_request, "procedure", def.procedure, procedure_names),
    ARGS_NAMED(wear_request, "slip", def.slip, slip_names),
    ARGS_NAMED(wear_request, "rule", def.rule, rule_names),
    ARGS_NAMED(wear_request, "geometry", def.geometry, geometry_names),
    ARGS_NAMED(wear_request, "update", def.update, update_names),
    ARGS_NAMED(wear_request, "law", def.law, law_names),
    ARGS_ABOVE(wear_request, "law_pressure", def.law_pressure, 0),
    ARGS_ABOVE(wear_request, "law_exponent", def.law_exponent, -1),
    {.name = "order",
     .kind = ARGS_WHOLE,
     .offset = offsetof(wear_request, def.order),
     .low = 1,
     .high = 2},
    ARGS_ABOVE(wear_request, "tolerance", def.tolerance, 0),
    ARGS_OTHER("model"),
    ARGS_OTHER("worn"),
    ARGS_OTHER("loading"),
    ARGS_OTHER("local_factor"),
    {.name = NULL},
};

/* --- series by distance ----------------------------------------------------------------------- */

static const args_field series_fields[] = {
    ARGS_OTHER("distance"),
    ARGS_OTHER("value"),
    {.name = NULL},
};

/* Reads { distance=, value= } where field `name` of the definition holds one; its numbers stay on
 * the stack. The engine checks them. */
static void push_series(lua_State *L, int index, args_place place, const char *name,
                        arc_series *series) {
  size_t distances = 0, values = 0;
  if (args_get(L, index, name) != LUA_TTABLE) return;
  int table = lua_gettop(L);
  args_place inside = {place.where, lua_pushfstring(L, "%s.", name)};
  args_check_names(L, table, inside, series_fields);
  lua_getfield(L, table, "distance");
  const double *distance = array_read(L, inside, "distance", &distances);
  lua_getfield(L, table, "value");
  const double *value = array_read(L, inside, "value", &values);
  if (distances != values || distances == 0 || distances > 1000000)
    error_raise(L, ARC_ARGUMENT, place.where,
                "fields '%s.distance' and '%s.value': expected two arrays of one length, got %d "
                "and %d numbers",
                name, name, (int)distances, (int)values);
  *series = (arc_series){(int)distances, distance, value};
}

/* --- how far ---------------------------------------------------------------------------------- */

/* With loading, `cycles` are those of all blocks, of which the last may be without a number; and no
 * distance at all means all the blocks. */
static void share_cycles(lua_State *L, args_place place, wear_request *request,
                         int distance_given) {
  arc_wear_def *def = &request->def;
  arc_loading *last = (arc_loading *)(size_t)&def->loading[def->blocks - 1];
  double before = request->cycle_before;
  for (int b = 0; b + 1 < def->blocks; b++) before += def->loading[b].cycles;
  if (request->cycles > 0 && (isfinite(last->cycles) || !(request->cycles > before)))
    error_raise(L, ARC_ARGUMENT, place.where,
                "field 'cycles': expected more than the %s cycles of the blocks of loading before "
                "the last, which has none of its own; got %s",
                args_show_number(L, before), args_show_number(L, request->cycles));
  if (request->cycles > 0) last->cycles = request->cycles - before;
  if (!distance_given && isfinite(last->cycles)) def->distance = 0;
  request->cycles = 0;
}

arc_wear_def wear_request_settle(const wear_request *request, const arc_model_def *model) {
  arc_wear_def def = request->def;
  if (request->cycles > 0)
    def.distance = request->distance_before + (request->cycles - request->cycle_before) *
                                                  arc_wear_def_strokes(&def, model) * def.stroke;
  return def;
}

/* --- all of it -------------------------------------------------------------------------------- */

/* What only a new run can have. */
static void refuse_changes(lua_State *L, int index, args_place place) {
  static const char *const fixed[] = {"model", "worn", "geometry", NULL};
  for (const char *const *name = fixed; *name; name++, lua_pop(L, 1))
    if (args_get(L, index, *name) != LUA_TNIL)
      error_raise(L, ARC_ARGUMENT, place.where,
                  "field '%s' cannot be changed in a run; make a new one of its shape, wear{ worn "
                  "= w, ... }",
                  *name);
}

/* Where a run that is changed begins anew; nothing lies behind it. */
static void check_ahead(lua_State *L, args_place place, const wear_request *request) {
  const double cycles = request->cycles, distance = request->def.distance;
  if (cycles > 0 && cycles < request->cycle_before)
    error_raise(L, ARC_ARGUMENT, place.where,
                "field 'cycles': the run is at cycle %s already, beyond %s",
                args_show_number(L, request->cycle_before), args_show_number(L, cycles));
  if (distance > 0 && distance < request->distance_before)
    error_raise(
        L, ARC_ARGUMENT, place.where,
        "field 'distance': the run is at %s mm already, beyond %s mm (both counted from its "
        "start)",
        args_show_number(L, request->distance_before), args_show_number(L, distance));
}

static wear_request begin_request(lua_State *L, int index, int changed, args_place place) {
  wear_request request = {.def = arc_wear_default()};
  if (!changed) return request;
  const arc_wear *wear = box_check(L, changed, &wear_class, place.where)->thing;
  refuse_changes(L, index, place);
  request.def = *arc_wear_definition(wear);
  request.distance_before = arc_wear_last(wear)->distance;
  request.cycle_before = arc_wear_last(wear)->cycle;
  return request;
}

static int given(lua_State *L, int index, const char *name) {
  int type = args_get(L, index, name);
  lua_pop(L, 1);
  return type != LUA_TNIL;
}

/* What follows from new loading, which has its own motion. A new run's nominal load is the largest,
 * unless it is given. */
static void settle_loading(lua_State *L, int index, args_place place, wear_request *request,
                           int changed) {
  if (given(L, index, "stroke"))
    error_raise(L, ARC_ARGUMENT, place.where,
                "fields 'stroke' and 'loading': expected one of them, got both");
  share_cycles(L, place, request, given(L, index, "distance"));
  const double largest = loading_largest(&request->def);
  if (!changed && !given(L, index, "load") && largest > 0) request->def.load = largest;
}

wear_request wear_request_read(lua_State *L, int index, int changed) {
  args_place place = {changed ? "wear:set" : "wear", ""};
  luaL_checkstack(L, 30, "wear");
  wear_request request = begin_request(L, index, changed, place);
  args_read(L, index, place, definition, &request);
  if (request.cycles > 0 && given(L, index, "distance"))
    error_raise(L, ARC_ARGUMENT, place.where,
                "fields 'distance' and 'cycles': expected one of them, got both");
  check_ahead(L, place, &request);
  push_series(L, index, place, "k", &request.def.k_series);
  push_series(L, index, place, "alpha", &request.def.alpha_series);
  if (given(L, index, "stroke")) request.def.blocks = 0;
  if (loading_read(L, index, place, &request.def))
    settle_loading(L, index, place, &request, changed);
  else if (request.cycles > 0 && request.def.blocks > 0)
    error_raise(L, ARC_ARGUMENT, place.where,
                "field 'cycles': a run with loading takes a distance");
  int before = 0;
  if (changed && lua_getiuservalue(L, changed, RUN_FUNCTIONS) == LUA_TUSERDATA)
    before = lua_gettop(L);
  functions_read(L, index, before, place, &request.def);
  request.functions = lua_gettop(L);
  return request;
}

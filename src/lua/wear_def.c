/* Class wear: the definition table of a run. */
#include "lua/array.h"
#include "lua/error.h"
#include "lua/wear.h"

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

/* A number in a range; a table is a series, which push_series reads. */
static void read_coefficient(lua_State *L, args_place place, const args_field *range,
                             double *member) {
  if (!lua_istable(L, -1)) *member = args_number(L, place, range);
}

static void read_k(lua_State *L, args_place place, const char *name, void *member) {
  (void)name;
  read_coefficient(L, place, &k_range, member);
}

static void read_alpha(lua_State *L, args_place place, const char *name, void *member) {
  (void)name;
  read_coefficient(L, place, &alpha_range, member);
}

/* A number of cycles, or "auto". */
static void read_jump(lua_State *L, args_place place, const char *name, void *member) {
  arc_wear_def *def = member;
  int text = lua_type(L, -1) == LUA_TSTRING;
  if (text && strcmp(lua_tostring(L, -1), "auto") == 0)
    def->jump_auto = 1;
  else if (text)
    args_refuse(L, place, name, "a number > 0 or \"auto\"");
  else
    def->jump = args_number(L, place, &jump_range);
}

static const args_field definition[] = {
    ARGS_READ(wear_request, "k", def.k, read_k),
    ARGS_READ(wear_request, "alpha", def.alpha, read_alpha),
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
    ARGS_NAMED(wear_request, "scheme", def.scheme, scheme_names),
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

/* --- what the binding cannot do yet ----------------------------------------------------------- */

static const struct {
  const char *field;
  int type; /* LUA_TNONE: any */
  const char *problem;
} later[] = {
    {"k", LUA_TFUNCTION, "functions are not available yet; give a number or a table"},
    {"alpha", LUA_TFUNCTION, "functions are not available yet; give a number or a table"},
    {"jump", LUA_TFUNCTION, "functions are not available yet; give a number or \"auto\""},
    {"loading", LUA_TNONE, "not available yet; give stroke and load"},
    {"local_factor", LUA_TNONE, "not available yet"},
};

static void refuse_later(lua_State *L, int index) {
  for (size_t i = 0; i < sizeof later / sizeof *later; i++) {
    int type = args_get(L, index, later[i].field);
    if (type != LUA_TNIL && (later[i].type == LUA_TNONE || later[i].type == type))
      error_raise(L, ARC_ARGUMENT, "wear", "field '%s': %s", later[i].field, later[i].problem);
    lua_pop(L, 1);
  }
}

/* --- series by distance ----------------------------------------------------------------------- */

static const args_field series_fields[] = {
    ARGS_OTHER("distance"),
    ARGS_OTHER("value"),
    {.name = NULL},
};

/* Reads { distance=, value= } where field `name` of the definition holds one; its numbers stay on
 * the stack. The engine checks them. */
static arc_series push_series(lua_State *L, int index, const char *name, const char *prefix) {
  args_place place = {"wear", prefix};
  size_t distances = 0, values = 0;
  if (args_get(L, index, name) != LUA_TTABLE) return (arc_series){0};
  int table = lua_gettop(L);
  args_check_names(L, table, place, series_fields);
  lua_getfield(L, table, "distance");
  const double *distance = array_read(L, place, "distance", &distances);
  lua_getfield(L, table, "value");
  const double *value = array_read(L, place, "value", &values);
  if (distances != values || distances == 0 || distances > 1000000)
    error_raise(L, ARC_ARGUMENT, "wear",
                "fields '%sdistance' and '%svalue': expected two arrays of one length, got %d and "
                "%d numbers",
                prefix, prefix, (int)distances, (int)values);
  return (arc_series){(int)distances, distance, value};
}

/* --- all of it -------------------------------------------------------------------------------- */

wear_request wear_request_read(lua_State *L, int index) {
  wear_request request = {.def = arc_wear_default(), .cycles = 0};
  luaL_checkstack(L, 20, "wear");
  refuse_later(L, index);
  args_read(L, index, (args_place){"wear", ""}, definition, &request);
  if (request.cycles > 0 && args_get(L, index, "distance") != LUA_TNIL)
    error_raise(L, ARC_ARGUMENT, "wear",
                "fields 'distance' and 'cycles': expected one of them, got both");
  request.def.k_series = push_series(L, index, "k", "k.");
  request.def.alpha_series = push_series(L, index, "alpha", "alpha.");
  return request;
}

arc_wear_def wear_request_settle(const wear_request *request, const arc_model_def *model) {
  arc_wear_def def = request->def;
  if (request->cycles > 0)
    def.distance = request->cycles * arc_wear_def_strokes(&def, model) * def.stroke;
  return def;
}

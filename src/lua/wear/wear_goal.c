/* Reads the end conditions of a wear run: a distance or number of cycles, target values of results
 * such as the depth, and a function. */
#include "lua/base/error.h"
#include "lua/wear/wear_class.h"

#include <stdio.h>
#include <string.h>

static const char where[] = "wear:run";

typedef struct run_def {
  double distance, cycles;
} run_def;

static const arc_setting definition[] = {
    ARGS_ABOVE_0(run_def, distance),
    ARGS_ABOVE_0(run_def, cycles),
    ARGS_OTHER("depth"),
    ARGS_OTHER("volume"),
    ARGS_OTHER("p_center"),
    ARGS_OTHER("p_max"),
    ARGS_OTHER("half_width"),
    ARGS_OTHER("stop_when"),
    ARGS_OTHER("progress"),
    {.name = NULL},
};

/* --- the distance ----------------------------------------------------------------------------- */

static void refuse_behind(lua_State *L, double covered, double wanted) {
  if (wanted < covered)
    error_raise(L, ARC_ARGUMENT, where,
                "the run is already at %s mm, beyond %s mm (both from the start of the run)",
                args_show_number(L, covered), args_show_number(L, wanted));
}

/* Returns the distance at the end of `cycles` cycles [mm]. Raises an error for a run with loading,
 * whose cycles may differ in length. */
static double distance_of_cycles(lua_State *L, const arc_wear *wear, double cycles) {
  const arc_wear_def *def = arc_wear_definition(wear);
  const double length = arc_wear_def_sliding(def, arc_model_definition(arc_wear_model(wear)));
  const double from = def->start_distance, before = def->start_cycle;
  if (def->blocks > 0)
    error_raise(L, ARC_ARGUMENT, where,
                "field 'cycles': expected a distance instead, because the cycles of 'loading' may "
                "differ in length");
  return from + (cycles - before) * length;
}

static double read_distance(lua_State *L, const arc_wear *wear) {
  run_def run = {0, 0};
  args_read(L, 2, (args_location){where, ""}, definition, &run);
  if (run.distance > 0 && run.cycles > 0)
    error_raise(L, ARC_ARGUMENT, where,
                "fields 'distance' and 'cycles': expected one of them, got both");
  if (run.cycles > 0) run.distance = distance_of_cycles(L, wear, run.cycles);
  if (run.distance <= 0) return arc_wear_definition(wear)->distance;
  refuse_behind(L, arc_wear_last(wear)->distance, run.distance);
  return run.distance;
}

/* --- measures --------------------------------------------------------------------------------- */

typedef struct measure {
  const char *group, *name; /* a field such as depth, and its subfield (NULL: none) */
  int column;
  int grows; /* true if the measure never decreases; its target must exceed the present value */
} measure;

#define COLUMN(name) ARC_WEAR_COLUMN_##name
static const measure measures[] = {
    {"depth", "cylinder", COLUMN(depth_cylinder), 1},
    {"depth", "plate", COLUMN(depth_plate), 1},
    {"volume", "cylinder", COLUMN(volume_cylinder), 1},
    {"volume", "plate", COLUMN(volume_plate), 1},
    {"volume", "total", ARC_WEAR_TOTAL_VOLUME, 1},
    {"p_center", NULL, COLUMN(p_center), 0},
    {"p_max", NULL, COLUMN(p_max), 0},
    {"half_width", NULL, COLUMN(half_width), 0},
    {NULL, NULL, 0, 0},
};

/* Adds the number on top of the stack as a target value of the measure. */
static void add_target(lua_State *L, const arc_wear *wear, const measure *m, args_location location,
                       wear_goals *goals) {
  const arc_setting range = {
      .name = m->name ? m->name : m->group, .high = HUGE_VAL, .open = ARC_LOW_OPEN};
  const double value = args_number(L, location, &range);
  const double now = arc_wear_record_get(arc_wear_last(wear), m->column);
  if (m->grows && value <= now)
    error_raise(L, ARC_ARGUMENT, where, "field '%s%s': the run is already at %s, beyond %s",
                location.prefix, range.name, args_show_number(L, now), args_show_number(L, value));
  goals->target[goals->count] = (arc_wear_target){m->column, value};
  snprintf(goals->name[goals->count], sizeof goals->name[0], "%s%s", location.prefix, range.name);
  goals->count++;
}

static void check_group(lua_State *L, const char *group) {
  static const arc_setting bodies[] = {ARGS_OTHER("cylinder"), ARGS_OTHER("plate"), {.name = NULL}};
  static const arc_setting all[] = {
      ARGS_OTHER("cylinder"), ARGS_OTHER("plate"), ARGS_OTHER("total"), {.name = NULL}};
  const int volume = strcmp(group, "volume") == 0;
  const int type = args_get(L, 2, group);
  if (type != LUA_TNIL && type != LUA_TTABLE)
    args_refuse(L, (args_location){where, ""}, group,
                volume ? "a table { cylinder=, plate=, total= }" : "a table { cylinder=, plate= }");
  if (type == LUA_TTABLE)
    args_check_names(L, -1, (args_location){where, volume ? "volume." : "depth."},
                     volume ? all : bodies);
  lua_pop(L, 1);
}

/* Replaces the table at index 2 by a copy. In the field `group` of the copy, names of bodies are
 * replaced by body_names. */
static void use_usual_names(lua_State *L, const arc_wear *wear, const char *group) {
  const arc_model_def *def = arc_model_definition(arc_wear_model(wear));
  const args_location location = {where, strcmp(group, "volume") == 0 ? "volume." : "depth."};
  if (args_get(L, 2, group) == LUA_TTABLE) {
    push_usual_names(L, -1, location, def);
    push_usual_names(L, 2, location, NULL);
    lua_insert(L, -2);
    lua_setfield(L, -2, group);
    lua_replace(L, 2);
  }
  lua_pop(L, 1);
}

static void read_targets(lua_State *L, const arc_wear *wear, wear_goals *goals) {
  use_usual_names(L, wear, "depth");
  use_usual_names(L, wear, "volume");
  check_group(L, "depth");
  check_group(L, "volume");
  for (const measure *m = measures; m->group; m++) {
    const int top = lua_gettop(L);
    args_location location = {where, ""};
    int type = args_get(L, 2, m->group);
    if (m->name && type == LUA_TTABLE) {
      type = lua_getfield(L, -1, m->name);
      location.prefix = strcmp(m->group, "volume") == 0 ? "volume." : "depth.";
    }
    if (type != LUA_TNIL) add_target(L, wear, m, location, goals);
    lua_settop(L, top);
  }
}

wear_goals wear_goals_read(lua_State *L, const arc_wear *wear) {
  wear_goals goals = {.distance = read_distance(L, wear)};
  read_targets(L, wear, &goals);
  const int type = args_get(L, 2, "stop_when");
  if (type == LUA_TFUNCTION)
    goals.stop_when = lua_gettop(L);
  else if (type != LUA_TNIL)
    args_refuse(L, (args_location){where, ""}, "stop_when", "a function of the wear object");
  return goals;
}

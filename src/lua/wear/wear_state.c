/* Class wear: the fields of a run (state, results, definition). */
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/base/strict.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

#include <stdlib.h>

static arc_wear *self(lua_State *L) {
  return wear_self(L, "wear");
}

static const arc_wear_record *last(lua_State *L) {
  return arc_wear_last(self(L));
}

static const arc_wear_def *def(lua_State *L) {
  return arc_wear_definition(self(L));
}

static const arc_model_def *pair_of(lua_State *L) {
  return arc_model_definition(arc_wear_model(self(L)));
}

/* --- the state -------------------------------------------------------------------------------- */

/* Functions that return the columns of the last record as fields. Some fields defined below
 * replace the column with the same name. */
#define COLUMN_FIELD(name, unit, range, rule, text) NUMBER_FIELD(wear_column, name, last(L)->name)
ARC_WEAR_COLUMNS(COLUMN_FIELD)
#undef COLUMN_FIELD

static int wear_update(lua_State *L) {
  lua_pushinteger(L, (lua_Integer)last(L)->update);
  return 1;
}

static int wear_solutions(lua_State *L) {
  lua_pushinteger(L, (lua_Integer)last(L)->solutions);
  return 1;
}

static int wear_depth(lua_State *L) {
  push_by_body(L, pair_of(L), last(L)->depth_cylinder, last(L)->depth_plate, "wear.depth");
  return 1;
}

static int wear_vector_depth(lua_State *L) {
  const arc_shape *shape = arc_wear_shape(self(L));
  /* in 3-D all wear is along y, so this field is equal to the field depth */
  if (arc_model_has_maps(pair_of(L))) return wear_depth(L);
  push_by_body(L, pair_of(L), arc_shape_vector_depth(shape, ARC_CYLINDER),
               arc_shape_vector_depth(shape, ARC_PLATE), "wear.vector_depth");
  return 1;
}

static int wear_volume(lua_State *L) {
  const arc_wear_record *record = last(L);
  push_by_body(L, pair_of(L), record->volume_cylinder, record->volume_plate, "wear.volume");
  array_set_number(L, "total", record->volume_cylinder + record->volume_plate);
  return 1;
}

static int wear_history(lua_State *L) {
  history_push(L, self(L));
  return 1;
}

static int wear_done(lua_State *L) {
  lua_pushboolean(L, last(L)->distance >= def(L)->distance);
  return 1;
}

static int wear_saved(lua_State *L) {
  self(L);
  lua_pushboolean(L, wear_is_saved(lua_touserdata(L, 1)));
  return 1;
}

/* --- the definition --------------------------------------------------------------------------- */

NUMBER_FIELD(wear, total_distance, def(L)->distance)
NUMBER_FIELD(wear, strokes, arc_wear_strokes(self(L)))
NUMBER_FIELD(wear, cycles, arc_wear_cycles(self(L)))
/* Field `load`: the load of the reference configuration [N], as defined by the user. The column
 * load_reference contains the load of the last update. */
NUMBER_FIELD(wear, load, def(L)->load)
/* Field `stroke`: the stroke of the plate [mm], also for runs with loading. */
NUMBER_FIELD(wear, stroke, arc_wear_travel(self(L)))

/* Pushes the user's function for a field. Returns 0 if the field is not a function. */
static int push_function(lua_State *L, const char *field) {
  lua_settop(L, 1);
  lua_getiuservalue(L, 1, RUN_FUNCTIONS);
  functions_push(L, 2, field);
  return lua_isfunction(L, -1);
}

/* Pushes a setting in the form that the user set: its function, or its value in the definition. */
static int push_quantity(lua_State *L, const arc_setting *s) {
  const arc_wear_def *settings = def(L);
  if (!push_function(L, s->name)) settings_push(L, s, settings);
  return 1;
}

static int wear_k(lua_State *L) {
  return push_quantity(L, &arc_wear_settings[ARC_AT_k]);
}

static int wear_alpha(lua_State *L) {
  return push_quantity(L, &arc_wear_settings[ARC_AT_alpha]);
}

/* Returns the wear coefficient of one body. It is the value in the definition if the coefficient
 * is constant, otherwise the value of the last update. */
static double coefficient(lua_State *L, int of_cylinder) {
  const arc_wear_def *d = def(L);
  const arc_wear_record *now = last(L);
  const int plain =
      !d->k_function && !d->alpha_function && d->k_series.count == 0 && d->alpha_series.count == 0;
  const double k = plain ? d->k : now->k, alpha = plain ? d->alpha : now->alpha;
  return k * (of_cylinder ? alpha : 1 - alpha);
}

NUMBER_FIELD(wear, k_cylinder, coefficient(L, 1))
NUMBER_FIELD(wear, k_plate, coefficient(L, 0))

static int wear_jump(lua_State *L) {
  return push_quantity(L, &arc_wear_settings[ARC_AT_jump]);
}

static int wear_friction(lua_State *L) {
  return push_quantity(L, &arc_wear_settings[ARC_AT_friction]);
}

/* wear:loop() returns the periodic cycle with friction on the present surfaces, { x=, tangential=,
 * energy=, stick_width=, gross= }. */
int wear_loop(lua_State *L) {
  box *made = box_self_idle(L, &wear_class, "wear:loop");
  arc_error error = {0};
  arc_loop *loop = NULL;
  const arc_callbacks callbacks = {.stop = interrupt_pending};
  lua_settop(L, 1);
  lua_getiuservalue(L, 1, RUN_FUNCTIONS);
  functions_call call = functions_enter(L, lua_gettop(L), made);
  made->busy = RUN_BUSY;
  const arc_status status = arc_wear_loop(made->thing, &callbacks, &loop, &error);
  made->busy = RUN_IDLE;
  functions_leave(L, &call, "wear:loop");
  error_check(L, status, &error, "wear:loop", -1);
  lua_createtable(L, 0, 6);
  array_set_number(L, "cycle", arc_wear_last(made->thing)->cycle);
  array_set(L, "x", loop->x, loop->count);
  array_set(L, "tangential", loop->tangential, loop->count);
  array_set_number(L, "energy", loop->energy);
  array_set_number(L, "stick_width", loop->stick_width);
  lua_pushboolean(L, loop->gross);
  lua_setfield(L, -2, "gross");
  strict_table(L, "wear:loop");
  free(loop);
  return 1;
}

static int wear_local_factor(lua_State *L) {
  self(L);
  if (!push_function(L, "local_factor")) lua_pushboolean(L, 0);
  return 1;
}

/* Field w.functions: the list of the settings that are functions. Files cannot store functions. */
static int wear_functions_given(lua_State *L) {
  functions_push_names(L, def(L));
  return 1;
}

/* Field w.loading: the sampled blocks of loading, or false if the run has no loading. */
static int wear_loading(lua_State *L) {
  const arc_wear_def *settings = def(L);
  if (settings->blocks == 0)
    lua_pushboolean(L, 0);
  else
    loading_push(L, settings);
  return 1;
}

/* Field w.procedure: the procedure that the run uses. If the setting is "auto", this is the
 * procedure that the program has chosen. */
static int wear_procedure(lua_State *L) {
  lua_pushstring(L, arc_procedure_names[arc_wear_procedure(self(L))]);
  return 1;
}

/* Field w.update_at: the setting `update`, because the field w.update is the number of updates. */
static int wear_update_at(lua_State *L) {
  lua_pushstring(L, arc_update_names[def(L)->update]);
  return 1;
}

static int wear_model(lua_State *L) {
  run_push_model(L, 1, self(L));
  return 1;
}

/* Field w.mesh: the meshes of both bodies with the present worn nodes. */
static int wear_mesh(lua_State *L) {
  mesh_push_worn(L, arc_wear_shape(self(L)));
  return 1;
}

const luaL_Reg wear_fields[] = {
#define COLUMN_ENTRY(name, unit, range, rule, text) {#name, wear_column_##name},
    ARC_WEAR_COLUMNS(COLUMN_ENTRY)
#undef COLUMN_ENTRY
        {"update", wear_update},
    {"solutions", wear_solutions},
    {"p_average", wear_p_average},
    {"depth", wear_depth},
    {"vector_depth", wear_vector_depth},
    {"volume", wear_volume},
    {"history", wear_history},
    {"done", wear_done},
    {"saved", wear_saved},
    {"k", wear_k},
    {"alpha", wear_alpha},
    {"k_cylinder", wear_k_cylinder},
    {"k_plate", wear_k_plate},
    {"total_distance", wear_total_distance},
    {"jump", wear_jump},
    {"friction", wear_friction},
    {"load", wear_load},
    {"stroke", wear_stroke},
    {"strokes", wear_strokes},
    {"cycles", wear_cycles},
    {"procedure", wear_procedure},
    {"update_at", wear_update_at},
    {"local_factor", wear_local_factor},
    {"loading", wear_loading},
    {"functions", wear_functions_given},
    {"model", wear_model},
    {"mesh", wear_mesh},
    {NULL, NULL},
};

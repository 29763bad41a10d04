/* Class wear: construction, cloning and the table of methods. The other wear_*.c files implement
 * the methods. */
#include "lua/wear/wear_class.h"
#include "lua/base/call.h"
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/wear/wear_functions.h"

/* --- construction ----------------------------------------------------------------------------- */

/* Computes the half widths of the zones that the run needs. The whole run is considered, because
 * the contact of worn surfaces may be wider at the start than at the end. */
static arc_status needed_zones(const void *definition, const arc_model_def *model,
                               double zone[ARC_BODIES], arc_error *error) {
  const wear_request *request = definition;
  arc_wear_def def = wear_request_settle(request, model);
  arc_status status = arc_wear_check(&def, model, error);
  arc_model_def sized = *model;
  if (request->worn) sized.mesh.fineness = 0;
  if (status == ARC_OK) arc_wear_zones(&def, &sized, zone);
  return status;
}

/* Pushes and returns the shape at the start of the run, or NULL for an unworn start. */
static const arc_shape *push_start(lua_State *L, int worn, arc_model *model,
                                   const arc_wear_def *def) {
  box *other = box_test(L, worn, &wear_class);
  lua_pushvalue(L, worn);
  if (lua_isnil(L, worn)) return NULL;
  if (other && arc_wear_model(other->thing) == model &&
      arc_wear_definition(other->thing)->geometry == def->geometry)
    return arc_wear_shape(other->thing);
  return worn_push_shape(L, worn, model, def, "wear");
}

/* Stores the holder of functions at `index` as user value of the box on top of the stack. */
static void keep_functions(lua_State *L, int index) {
  lua_pushvalue(L, index);
  lua_setiuservalue(L, -2, RUN_FUNCTIONS);
}

/* Pushes a new run that starts with the shape defined by the value at `worn`. The value at
 * `holder` keeps the run's model alive. */
static arc_status push_run(lua_State *L, int holder, int worn, arc_model *model,
                           const wear_request *request, arc_error *error) {
  const arc_shape *start = push_start(L, worn, model, &request->def);
  box *made = box_push(L, &wear_class);
  box_keep(L, holder);
  keep_functions(L, request->functions);
  arc_wear *wear = NULL;
  arc_wear_def def = wear_request_settle(request, arc_model_definition(model));
  const int top = lua_gettop(L);
  functions_call call = functions_enter_making(L, request->functions, arc_model_definition(model));
  const arc_status status = arc_wear_create(model, &def, start, &wear, error);
  made->thing = wear;
  functions_leave(L, &call, "wear");
  lua_settop(L, top);
  if (status == ARC_OK) box_weigh(L, arc_wear_bytes(wear));
  return status;
}

/* Raises an error for the first layer that has a wear coefficient. */
static void refuse_layers(lua_State *L, const arc_model_def *model) {
  for (int b = 0; b < ARC_BODIES; b++)
    for (int l = 0; l < arc_body_layers(&model->body[b]); l++) {
      const double k = model->body[b].layer[l].material.k;
      if (k > 0)
        error_raise(L, ARC_ARGUMENT, "wear",
                    "fields 'k', 'alpha', 'k_cylinder', 'k_plate': layer %d of the %s has its own "
                    "wear coefficient, %s mm2/N; set either these fields or the k of each material",
                    l + 1, arc_body_name((arc_body)b), args_show_number(L, k));
    }
}

/* Raises an error if the user sets k or alpha although each body has its own wear coefficient. */
static void check_coefficients(lua_State *L, const wear_request *request,
                               const arc_model_def *model) {
  arc_wear_def def = request->def;
  if (!request->own_k || !arc_wear_def_of_bodies(&def, model)) return;
  if (!(model->material[ARC_CYLINDER].k > 0 || model->material[ARC_PLATE].k > 0))
    refuse_layers(L, model);
  error_raise(
      L, ARC_ARGUMENT, "wear",
      "fields 'k', 'alpha', 'k_cylinder', 'k_plate': the bodies have their own wear coefficients, "
      "%s and %s mm2/N (model.cylinder.k, model.plate.k); set either these fields or the k of the "
      "bodies",
      args_show_number(L, model->material[ARC_CYLINDER].k),
      args_show_number(L, model->material[ARC_PLATE].k));
}

/* Constructor wear{ model=, k=, alpha=, load=, stroke=, ... }. It is the metamethod __call of
 * the table `wear`. */
static int wear_new(lua_State *L) {
  lua_remove(L, 1);
  lua_settop(L, 1);
  if (joint_takes(L, "wear")) return 1;
  wear_request request = wear_request_read(L, 1, 0);
  worn_check(L, 1, "wear");
  int worn = lua_gettop(L);
  request.worn = !lua_isnil(L, worn);
  arc_model *model = model_argument(L, worn, "wear", request.def.load, 0, needed_zones, &request);
  int holder = lua_gettop(L);
  check_coefficients(L, &request, arc_model_definition(model));
  arc_error error = {0};
  arc_status status = push_run(L, holder, worn, model, &request, &error);
  if (status == ARC_ZONE && (model = model_push_wider(L, model, "wear", needed_zones, &request)))
    status = push_run(L, lua_gettop(L), worn, model, &request, &error);
  error_check(L, status, &error, "wear", -1);
  return 1;
}

/* --- saved state ------------------------------------------------------------------------------ */

static int rows_of(const box *made) {
  size_t rows;
  arc_wear_history(made->thing, &rows);
  return (int)rows;
}

int wear_is_saved(const box *made) {
  return made->tag == rows_of(made);
}

void wear_note_saved(box *made) {
  made->tag = rows_of(made);
}

/* Pushes the model of the run. After remeshing the model may differ from the model that is the
 * user value of the run's box. */
void run_push_model(lua_State *L, int index, const arc_wear *wear) {
  lua_getiuservalue(L, index, RUN_MODEL);
  const box *kept = box_test(L, -1, &model_class);
  if (kept && kept->thing == arc_wear_model(wear)) return;
  lua_pop(L, 1);
  model_push_living(L, arc_wear_model(wear));
  lua_pushvalue(L, -1);
  lua_setiuservalue(L, index, RUN_MODEL);
}

/* wear:clone() returns an independent copy of the run on the same model. */
static int wear_clone(lua_State *L) {
  const arc_wear *wear = wear_self(L, "wear:clone");
  arc_error error = {0};
  arc_wear *copy = NULL;
  lua_settop(L, 1);
  run_push_model(L, 1, wear);
  lua_getiuservalue(L, 1, RUN_FUNCTIONS);
  box *made = box_push(L, &wear_class);
  box_keep(L, 2);
  keep_functions(L, 3);
  arc_status status = arc_wear_clone(wear, &copy, &error);
  made->thing = copy;
  error_check(L, status, &error, "wear:clone", -1);
  made->tag = ((const box *)lua_touserdata(L, 1))->tag;
  box_weigh(L, arc_wear_bytes(copy));
  return 1;
}

static void warn(void *context, const char *text) {
  lua_warning(context, text, 0);
}

/* wear:set{ load=, alpha=, ..., mesh={...} } changes the settings in the table, keeps all other
 * settings and returns the wear object. */
static int wear_set(lua_State *L) {
  static const char where[] = "wear:set";
  arc_error error = {0};
  lua_settop(L, 2);
  box *made = box_self_idle(L, &wear_class, where);
  wear_request request = wear_request_read(L, 2, 1);
  /* repeats the check, because a function of the user may have closed the run */
  box_self_idle(L, &wear_class, where);
  arc_mesh_def mesh = arc_model_definition(arc_wear_model(made->thing))->mesh;
  const int remeshed = lua_istable(L, 2) && model_read_mesh(L, 2, where, &mesh);
  const arc_callbacks callbacks = {.stop = interrupt_pending, .warn = warn, .context = L};
  arc_wear_def def =
      wear_request_settle(&request, arc_model_definition(arc_wear_model(made->thing)));
  functions_call call = functions_enter(L, request.functions, made);
  made->busy = RUN_BUSY;
  arc_status status = arc_wear_set(made->thing, &def, remeshed ? &mesh : NULL, &callbacks, &error);
  made->busy = RUN_IDLE;
  functions_leave(L, &call, where);
  if (status == ARC_STOPPED && interrupt_pending(NULL)) interrupt_raise(L, "changing a run");
  error_check(L, status, &error, where, -1);
  made->tag = 0;
  lua_pushvalue(L, request.functions);
  lua_setiuservalue(L, 1, RUN_FUNCTIONS);
  lua_settop(L, 1);
  return 1;
}

/* --- the class -------------------------------------------------------------------------------- */

static void destroy_wear(void *thing) {
  arc_wear *wear = thing;
  arc_wear_destroy(&wear);
}

arc_wear *wear_self(lua_State *L, const char *where) {
  return box_self(L, &wear_class, where)->thing;
}

static const luaL_Reg methods[] = {
    {"step", wear_step},
    {"run", wear_run},
    {"set", wear_set},
    {"clone", wear_clone},
    {"save", wear_save},
    {"contact", wear_contact},
    {"profile", wear_profile},
    {"pressure", wear_pressure},
    {"map", wear_map},
    {"surfaces", wear_surfaces},
    {"combined", wear_combined},
    {"local_partition", wear_local_partition},
    {"roughness", wear_roughness},
    {"stability", wear_stability},
    {"sensitivity", wear_sensitivity},
    {"loop", wear_loop},
    {NULL, NULL},
};

static const void *definition(lua_State *L) {
  return arc_wear_definition(wear_self(L, "wear"));
}

const box_class wear_class = {
    .name = "wear",
    .settings = arc_wear_settings,
    .definition = definition,
    .methods = methods,
    .fields = wear_fields,
    .tostring = wear_tostring,
    .destroy = destroy_wear,
    .setter = "w:set{ field = value }",
};

static int class_tostring(lua_State *L) {
  lua_pushliteral(L, "wear: wear{ alpha=0.5, stroke=0.11 } creates a run; see help(wear)");
  return 1;
}

/* Pushes the callable table `wear` with the function `open`. */
int luaopen_archard_wear(lua_State *L) {
  static const luaL_Reg functions[] = {{"open", wear_open}, {NULL, NULL}};
  static const luaL_Reg events[] = {
      {"__call", wear_new}, {"__tostring", class_tostring}, {NULL, NULL}};
  call_new_library(L, functions);
  call_new_library(L, events);
  lua_setmetatable(L, -2);
  return 1;
}

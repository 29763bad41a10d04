/* Class model: two meshed and condensed bodies. Models of one definition are built once and shared:
 * a weak table in the registry finds the living ones, and the one asked for last is kept. */
#include "lua/base/array.h"
#include "lua/engine/bodies.h"
#include "lua/base/call.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/base/file_name.h"
#include "lua/base/scripts.h"

#include <stdio.h>

static const char cache_key = 0, last_key = 0; /* their addresses name the registry's entries */

/* --- the definition -------------------------------------------------------------------------- */

/* A definition of which all is "auto" that can be. */
static arc_model_def begin_definition(void) {
  arc_model_def def = {0};
  arc_settings_default(arc_model_settings, &def);
  return def;
}

/* A size that is given is what it is; one that is not follows the contact. */
static void check_fineness(lua_State *L, int index, args_place place, arc_mesh_def *mesh) {
  if (args_get(L, index, "mesh") == LUA_TTABLE) {
    const int at = lua_gettop(L);
    const int size = args_given(L, at, "size") && mesh->size > 0;
    if (size && args_given(L, at, "fineness"))
      error_raise(L, ARC_ARGUMENT, place.where,
                  "fields '%smesh.size' and '%smesh.fineness': expected one of them, got both",
                  place.prefix, place.prefix);
    if (size) mesh->fineness = 0;
  }
  lua_pop(L, 1);
}

/* Pushes the table at `index` without its bodies, which are read on their own. */
static void push_without_bodies(lua_State *L, int index, args_place place) {
  if (!lua_istable(L, index)) args_read(L, index, place, arc_model_settings, NULL); /* refuses */
  args_push_copy(L, index);
  lua_pushnil(L);
  lua_setfield(L, -2, "upper");
  lua_pushnil(L);
  lua_setfield(L, -2, "lower");
}

/* Reads the table at `index` over a definition; of a mesh that is given, nothing is left of what
 * was there. */
static void read_definition(lua_State *L, int index, args_place place, arc_model_def *def) {
  if (lua_isnil(L, index)) return;
  push_without_bodies(L, index, place);
  args_read(L, -1, place, arc_model_settings, def);
  lua_pop(L, 1);
  body_read(L, lua_absindex(L, index), place, def);
  check_fineness(L, index, place, &def->mesh);
}

/* What is not given stays, but for what follows from the size: that is found anew. */
static void begin_mesh(lua_State *L, int at, arc_mesh_def *mesh) {
  const int size = args_given(L, at, "size"), fineness = args_given(L, at, "fineness");
  if (!size && !fineness) return;
  mesh->size = mesh->height = 0;
  if (!args_given(L, at, "rows")) mesh->rows = 0;
  if (size && !fineness) mesh->fineness = 0;
}

int model_read_mesh(lua_State *L, int index, const char *where, arc_mesh_def *mesh) {
  const args_place place = {where, "mesh."};
  const int type = args_get(L, index, "mesh");
  if (type == LUA_TTABLE) {
    begin_mesh(L, lua_gettop(L), mesh);
    args_read(L, lua_gettop(L), place, arc_mesh_settings, mesh);
    lua_pop(L, 1);
    check_fineness(L, index, (args_place){where, ""}, mesh);
    return 1;
  }
  if (type != LUA_TNIL)
    args_refuse(L, (args_place){where, ""}, "mesh", "a table of the fields of model{ mesh = }");
  lua_pop(L, 1);
  return 0;
}

/* --- building and sharing -------------------------------------------------------------------- */

static int add_to_key(void *context, const char *path, const arc_setting *s, void *member,
                      const void *def) {
  char text[40];
  (void)path;
  if (s->kind == ARC_TEXT) {
    luaL_addlstring(context, member, ARC_TEXT_SIZE);
    return 0;
  }
  snprintf(text, sizeof text, "%a ", arc_setting_number(s, def));
  luaL_addstring(context, text);
  const arc_series series = arc_setting_series(s, def);
  if (series.count == 0) return 0;
  luaL_addlstring(context, (const char *)series.distance, (size_t)series.count * sizeof(double));
  luaL_addlstring(context, (const char *)series.value, (size_t)series.count * sizeof(double));
  return 0;
}

/* Pushes a text that is the same for equal definitions, and for them alone. */
static void push_key(lua_State *L, const arc_model_def *def) {
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  arc_settings_walk(arc_model_settings, "", def, add_to_key, &text);
  luaL_pushresult(&text);
}

/* Pushes the table from keys to holders: boxes no script sees, each the user value of the boxes
 * that scripts hold, so that it lives as long as any of them. */
static void push_cache(lua_State *L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &cache_key) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "v");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &cache_key);
}

/* How a long construction is shown: by archard.lib.build_progress, once it takes its time. */
typedef struct building {
  lua_State *L;
  int begun; /* the function stands on top of the stack */
} building;

static void begin_showing(building *b) {
  b->begun = 1;
  if (script_pcall(b->L, "archard.lib.build_progress", 0, 1) == LUA_OK) return;
  lua_pop(b->L, 1);
  lua_pushnil(b->L); /* a model does not fail for want of a display */
}

static void tell(building *b, int arguments) {
  if (lua_pcall(b->L, arguments, 0, 0) != LUA_OK) lua_pop(b->L, 1);
}

static void show(void *context, const char *what, double share, double seconds) {
  static const double patience = 1; /* [s] */
  building *b = context;
  if (seconds < patience || interrupt_pending(NULL)) return;
  if (!b->begun) begin_showing(b);
  if (lua_isnil(b->L, -1)) return;
  lua_pushvalue(b->L, -1);
  lua_pushstring(b->L, what);
  lua_pushnumber(b->L, share);
  lua_pushnumber(b->L, seconds);
  tell(b, 3);
}

static void end_showing(building *b) {
  if (!b->begun) return;
  if (lua_isnil(b->L, -1))
    lua_pop(b->L, 1);
  else
    tell(b, 0);
}

/* Puts a model into its box, or raises why there is none. */
static void end_build(lua_State *L, box *holder, arc_model *model, building *shown,
                      arc_status status, const arc_error *error, const char *where) {
  holder->thing = model;
  end_showing(shown);
  if (status == ARC_STOPPED && interrupt_pending(NULL)) interrupt_raise(L, "building a model");
  error_check(L, status, error, where, -1);
  box_weigh(L, arc_model_bytes(model));
}

/* Pushes a holder with a new model. */
static void build_holder(lua_State *L, const arc_model_def *def, const char *where) {
  arc_error error = {0};
  arc_model *model = NULL;
  box *holder = box_push(L, &model_class);
  building shown = {.L = L};
  const arc_callbacks callbacks = {.stop = interrupt_pending, .working = show, .context = &shown};
  arc_status status = arc_model_build_watched(def, &callbacks, &model, &error);
  end_build(L, holder, model, &shown, status, &error, where);
}

/* Pushes the holder for a definition. */
static void push_holder(lua_State *L, const arc_model_def *def, const char *where) {
  push_cache(L);
  push_key(L, def);
  lua_pushvalue(L, -1);
  if (lua_rawget(L, -3) != LUA_TUSERDATA) {
    lua_pop(L, 1);
    build_holder(L, def, where);
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -5);
  }
  lua_replace(L, -3);
  lua_pop(L, 1);
}

arc_model *model_push(lua_State *L, const arc_model_def *def, const char *where) {
  luaL_checkstack(L, 10, where);
  push_holder(L, def, where);
  int holder = lua_gettop(L);
  lua_pushvalue(L, holder);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &last_key);
  box *made = box_push(L, &model_class);
  made->thing = arc_model_retain(box_test(L, holder, &model_class)->thing);
  box_keep(L, holder);
  lua_remove(L, holder);
  return made->thing;
}

/* --- meshes from outside ---------------------------------------------------------------------- */

/* Reads the other fields of the table at index 1, whose mesh is a file. */
static void read_beside_file(lua_State *L, arc_model_def *def) {
  args_push_copy(L, 1);
  lua_pushnil(L);
  lua_setfield(L, -2, "mesh");
  read_definition(L, lua_gettop(L), (args_place){"model", ""}, def);
  lua_pop(L, 1);
}

/* Pushes a model of the meshes in a file. It is built anew each time: the file may have changed. */
static void push_of_file(lua_State *L, const char *path) {
  arc_model_def def = begin_definition();
  const int has_radius = args_given(L, 1, "radius");
  arc_mesh *mesh[ARC_BODIES];
  arc_model *model = NULL;
  arc_error error = {0};
  building shown = {.L = L};
  const arc_callbacks callbacks = {.stop = interrupt_pending, .working = show, .context = &shown};
  read_beside_file(L, &def);
  box *made = box_push(L, &model_class);
  arc_status status = arc_mesh_read_msh(path, mesh, &error);
  if (status == ARC_OK) {
    if (!has_radius) def.radius = mesh[ARC_CYLINDER]->radius;
    status = arc_model_build_given(&def, mesh, &callbacks, &model, &error);
  }
  end_build(L, made, model, &shown, status, &error, "model");
}

void model_push_living(lua_State *L, arc_model *model) {
  box *made = box_push(L, &model_class);
  made->thing = arc_model_retain(model);
  box_weigh(L, arc_model_bytes(model));
}

/* model{ radius=, cylinder=, plate=, thickness=, mesh={...} | "pair.msh" } */
static int model_new(lua_State *L) {
  lua_settop(L, 1);
  if (lua_istable(L, 1) && args_get(L, 1, "mesh") == LUA_TSTRING) {
    push_of_file(L, path_argument(L, -1, "model", "mesh", PATH_READ));
    return 1;
  }
  lua_settop(L, 1);
  arc_model_def def = begin_definition();
  if (!lua_isnil(L, 1)) read_definition(L, 1, (args_place){"model", ""}, &def);
  arc_model_fit_alone(&def);
  model_push(L, &def, "model");
  return 1;
}

/* --- as an argument -------------------------------------------------------------------------- */

static void suit_zones(lua_State *L, arc_model_def *def, const char *where, zones_fn zones,
                       const void *asker) {
  double needed[ARC_BODIES];
  arc_error error = {0};
  error_check(L, zones(asker, def, needed, &error), &error, where, -1);
  arc_model_fit_zones(def, needed);
}

arc_model *model_argument(lua_State *L, int worn, const char *where, double load, zones_fn zones,
                          const void *asker) {
  args_get(L, 1, "model");
  if (box_test(L, -1, &model_class)) return box_check(L, -1, &model_class, where)->thing;
  if (!lua_isnil(L, -1) && !lua_istable(L, -1))
    args_refuse(L, (args_place){where, ""}, "model", "a model object or a table of its fields");
  arc_model *kept = lua_isnil(L, -1) ? worn_given_model(L, worn) : NULL;
  if (kept) {
    lua_pop(L, 1);
    model_push_living(L, kept);
    return kept;
  }
  arc_model_def def = begin_definition();
  const arc_model_def *other = lua_isnil(L, -1) ? worn_model_def(L, worn) : NULL;
  if (other) {
    def = *other;
    for (int body = 0; body < ARC_BODIES; body++) def.mesh.zone[body] = 0;
  }
  read_definition(L, lua_gettop(L), (args_place){where, "model."}, &def);
  lua_pop(L, 1);
  arc_model_fit(&def, load);
  suit_zones(L, &def, where, zones, asker);
  return model_push(L, &def, where);
}

/* --- the object ------------------------------------------------------------------------------ */

static void model_release(void *thing) {
  arc_model *model = thing;
  arc_model_release(&model);
}

static arc_model *self(lua_State *L) {
  return box_self(L, &model_class, "model")->thing;
}

NUMBER_FIELD(model, seconds, arc_model_seconds(self(L)))
NUMBER_FIELD(model, bytes, arc_model_bytes(self(L)))

static int model_cylinder(lua_State *L) {
  material_push(L, arc_model_definition(self(L))->material[ARC_CYLINDER]);
  return 1;
}

static int model_plate(lua_State *L) {
  material_push(L, arc_model_definition(self(L))->material[ARC_PLATE]);
  return 1;
}

static int model_upper(lua_State *L) {
  body_push(L, arc_model_definition(self(L)), ARC_UPPER);
  return 1;
}

static int model_lower(lua_State *L) {
  body_push(L, arc_model_definition(self(L)), ARC_LOWER);
  return 1;
}

/* The meshes by body, and their definition beside them. */
static int model_mesh(lua_State *L) {
  const arc_model_def *def = arc_model_definition(self(L));
  settings_push(L, arc_setting_find(arc_model_settings, "mesh"), def);
  for (int body = 0; body < ARC_BODIES; body++) {
    mesh_push(L, 1, (arc_body)body);
    set_by_body(L, def, (arc_body)body);
  }
  by_body_named(L, def, "model.mesh");
  return 1;
}

static int model_bodies(lua_State *L) {
  push_body_names(L, arc_model_definition(self(L)));
  return 1;
}

const char *model_show_space(const arc_model_def *def, char *text, size_t size) {
  snprintf(text, size, "thickness %.6g mm%s", def->thickness,
           def->geometry == ARC_PLANE_STRESS ? ", plane stress" : "");
  if (def->geometry == ARC_AXISYMMETRIC) snprintf(text, size, "axisymmetric");
  if (def->axis > 0) snprintf(text, size, "axisymmetric about x = %.6g mm", -def->axis);
  return text;
}

static void add_body(luaL_Buffer *text, const arc_model *model, arc_body body) {
  const arc_model_def *def = arc_model_definition(model);
  const arc_mesh *mesh = arc_model_mesh(model, body);
  char line[160];
  snprintf(line, sizeof line,
           "\n  %-8s  E %.6g MPa, nu %.6g, %s, zone %.6g mm; %d nodes, %d elements",
           body_name(def, body), def->material[body].E, def->material[body].nu,
           arc_mesh_element(mesh, 4), def->mesh.zone[body], mesh->nodes, mesh->elements);
  luaL_addstring(text, line);
}

static int model_tostring(lua_State *L) {
  const arc_model *model = self(L);
  const arc_model_def *def = arc_model_definition(model);
  char line[200], space[100];
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  snprintf(line, sizeof line, "model: radius %.6g mm, %s, elements %.6g x %.6g mm, %.3g MB",
           def->radius, model_show_space(def, space, sizeof space), def->mesh.size,
           def->mesh.height, (double)arc_model_bytes(model) / 1e6);
  luaL_addstring(&text, line);
  add_body(&text, model, ARC_CYLINDER);
  add_body(&text, model, ARC_PLATE);
  luaL_pushresult(&text);
  return 1;
}

static const luaL_Reg fields[] = {
    {"seconds", model_seconds}, {"bytes", model_bytes},   {"cylinder", model_cylinder},
    {"plate", model_plate},     {"mesh", model_mesh},     {"upper", model_upper},
    {"lower", model_lower},     {"bodies", model_bodies}, {NULL, NULL},
};

static const void *definition(lua_State *L) {
  return arc_model_definition(self(L));
}

const box_class model_class = {
    .name = "model",
    .fields = fields,
    .settings = arc_model_settings,
    .definition = definition,
    .tostring = model_tostring,
    .destroy = model_release,
};

int luaopen_archard_model(lua_State *L) {
  call_push(L, model_new);
  return 1;
}

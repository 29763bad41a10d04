/* Class model: two bodies with meshes and condensed stiffness matrices. Equal definitions share
 * one model (model_share.c). */
#include "lua/base/array.h"
#include "lua/engine/bodies.h"
#include "lua/base/call.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"
#include "lua/base/file_name.h"
#include "lua/engine/pair_text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- the definition --------------------------------------------------------------------------- */

/* Returns a definition with all values at their defaults ("auto" where possible). */
static arc_model_def begin_definition(void) {
  arc_model_def def = {0};
  arc_settings_default(arc_model_settings, &def);
  return def;
}

/* Raises an error if both mesh.size and mesh.fineness are set. If the size is set, switches the
 * fineness off. */
static void check_fineness(lua_State *L, int index, args_location location, arc_mesh_def *mesh) {
  if (args_get(L, index, "mesh") == LUA_TTABLE) {
    const int at = lua_gettop(L);
    const int size = args_given(L, at, "size") && mesh->size > 0;
    if (size && args_given(L, at, "fineness"))
      error_raise(L, ARC_ARGUMENT, location.where,
                  "fields '%smesh.size' and '%smesh.fineness': expected one of them, got both",
                  location.prefix, location.prefix);
    if (size) mesh->fineness = 0;
  }
  lua_pop(L, 1);
}

/* Replaces the names of bodies in the field mesh.zone of the definition on top of the stack by
 * body_names. The definition is a copy, so the user's table is not changed. */
static void rename_zones(lua_State *L, args_location location, const arc_model_def *def) {
  const int top = lua_gettop(L);
  if (args_get(L, top, "mesh") == LUA_TTABLE && args_get(L, top + 1, "zone") == LUA_TTABLE) {
    args_push_copy(L, top + 1);
    push_usual_names(
        L, top + 2,
        (args_location){location.where, lua_pushfstring(L, "%smesh.zone.", location.prefix)}, def);
    lua_setfield(L, top + 3, "zone");
    lua_pushvalue(L, top + 3);
    lua_setfield(L, top, "mesh");
  }
  lua_settop(L, top);
}

/* Pushes a copy of the table at `index` without the fields upper and lower, because body_read reads
 * these fields. */
static void push_without_bodies(lua_State *L, int index, args_location location) {
  /* raises the error for a value that is not a table */
  if (!lua_istable(L, index)) args_read(L, index, location, arc_model_settings, NULL);
  args_push_copy(L, index);
  lua_pushnil(L);
  lua_setfield(L, -2, "upper");
  lua_pushnil(L);
  lua_setfield(L, -2, "lower");
}

/* Reads the table at `index` into the definition. If the value is nil, the definition is not
 * changed. */
static void read_definition(lua_State *L, int index, args_location location, arc_model_def *def) {
  if (lua_isnil(L, index)) return;
  arc_model_def called = *def;
  push_without_bodies(L, index, location);
  body_read_names(L, lua_absindex(L, index), &called);
  rename_zones(L, location, &called);
  args_read(L, -1, location, arc_model_settings, def);
  lua_pop(L, 1);
  body_read(L, lua_absindex(L, index), location, def);
  check_fineness(L, index, location, &def->mesh);
}

/* Prepares reading a table of mesh settings. If the table has a size or a fineness, resets the
 * values that were derived from the old size to "auto". Other values are not changed. */
static void begin_mesh(lua_State *L, int at, arc_mesh_def *mesh) {
  const int size = args_given(L, at, "size"), fineness = args_given(L, at, "fineness");
  if (!size && !fineness) return;
  mesh->size = mesh->height = 0;
  if (!args_given(L, at, "rows")) mesh->rows = 0;
  if (size && !fineness) mesh->fineness = 0;
}

int model_read_mesh(lua_State *L, int index, const char *where, arc_mesh_def *mesh) {
  const args_location location = {where, "mesh."};
  const int type = args_get(L, index, "mesh");
  if (type == LUA_TTABLE) {
    begin_mesh(L, lua_gettop(L), mesh);
    args_read(L, lua_gettop(L), location, arc_mesh_settings, mesh);
    lua_pop(L, 1);
    check_fineness(L, index, (args_location){where, ""}, mesh);
    return 1;
  }
  if (type != LUA_TNIL)
    args_refuse(L, (args_location){where, ""}, "mesh", "a table of the fields of model{ mesh = }");
  lua_pop(L, 1);
  return 0;
}

/* --- imported meshes -------------------------------------------------------------------------- */

/* Frees two imported meshes. Until the model becomes their owner, a box owns the meshes, so that a
 * Lua error leaks no memory. */
static void free_given(void *thing) {
  arc_mesh **given = thing;
  for (int b = 0; b < ARC_BODIES; b++) arc_mesh_destroy(&given[b]);
}

static int given_tostring(lua_State *L) {
  lua_pushliteral(L, "two meshes");
  return 1;
}

static const box_class given_class = {.name = "two meshes",
                                      .tostring = given_tostring,
                                      .destroy = free_given,
                                      .value = ARC_BODIES * sizeof(arc_mesh *)};

/* Replaces the text on top of the stack by a box with the meshes of both bodies. A text with
 * newlines is the contents of a mesh file, any other text is a file name. */
static arc_mesh **push_meshes(lua_State *L, args_location location) {
  const int top = lua_gettop(L);
  size_t length;
  const char *text = lua_tolstring(L, top, &length);
  const int is_mesh = strchr(text, '\n') != NULL;
  const char *name = lua_pushfstring(L, "%smesh", location.prefix);
  if (!is_mesh) path_argument(L, top, location.where, name);
  arc_error error = {0};
  arc_mesh **given = box_push(L, &given_class)->thing;
  const arc_status status = is_mesh ? arc_mesh_parse_msh(name, text, length, given, &error)
                                    : arc_mesh_read_msh(text, given, &error);
  error_check(L, status, &error, location.where, -1);
  lua_replace(L, top);
  lua_settop(L, top);
  return given;
}

/* Reads all fields of the table at `index` except the field `mesh`, which is a file name or the
 * contents of a mesh file. */
static void read_beside_mesh(lua_State *L, int index, args_location location, arc_model_def *def) {
  args_push_copy(L, index);
  lua_pushnil(L);
  lua_setfield(L, -2, "mesh");
  read_definition(L, lua_gettop(L), location, def);
  lua_pop(L, 1);
}

/* If the field `mesh` of the table at `index` is a text, pushes and returns the model with the
 * imported meshes. Otherwise pushes nothing and returns NULL. The file is read at each call,
 * because it may have changed. */
static arc_model *push_of_mesh(lua_State *L, int index, args_location location) {
  if (!lua_istable(L, index)) return NULL;
  index = lua_absindex(L, index);
  if (args_get(L, index, "mesh") != LUA_TSTRING) {
    lua_pop(L, 1);
    return NULL;
  }
  arc_model_def def = begin_definition();
  read_beside_mesh(L, index, location, &def);
  arc_mesh **given = push_meshes(L, location);
  if (!args_given(L, index, "radius")) def.radius = given[ARC_CYLINDER]->radius;
  arc_model *model = model_push_given(L, &def, given, location.where);
  lua_remove(L, -2);
  return model;
}

/* Constructor model{ radius=, cylinder=, plate=, thickness=, mesh={...} or "pair.msh" }. */
static int model_new(lua_State *L) {
  const args_location location = {"model", ""};
  lua_settop(L, 1);
  if (push_of_mesh(L, 1, location)) return 1;
  arc_model_def def = begin_definition();
  if (!lua_isnil(L, 1)) read_definition(L, 1, location, &def);
  if (!arc_model_has_maps(&def)) arc_model_fit_alone(&def);
  model_push(L, &def, "model");
  return 1;
}

/* --- models as arguments ---------------------------------------------------------------------- */

static void suit_zones(lua_State *L, arc_model_def *def, const char *where, zones_fn zones,
                       const void *definition) {
  double needed[ARC_BODIES];
  arc_error error = {0};
  error_check(L, zones(definition, def, needed, &error), &error, where, -1);
  arc_model_fit_zones(def, needed);
}

arc_model *model_argument(lua_State *L, int worn, const char *where, double load, int friction,
                          zones_fn zones, const void *definition) {
  args_get(L, 1, "model");
  if (box_test(L, -1, &model_class)) return box_check(L, -1, &model_class, where)->thing;
  if (!lua_isnil(L, -1) && !lua_istable(L, -1))
    args_refuse(L, (args_location){where, ""}, "model",
                "a model object or a table of its fields, such as { mesh = \"pair.msh\" }");
  arc_model *kept = lua_isnil(L, -1) ? worn_given_model(L, worn) : NULL;
  if (kept) {
    lua_pop(L, 1);
    model_push_living(L, kept);
    return kept;
  }
  const args_location location = {where, "model."};
  arc_model *given = push_of_mesh(L, -1, location);
  if (given) {
    lua_remove(L, -2);
    return given;
  }
  arc_model_def def = begin_definition();
  const arc_model_def *other = lua_isnil(L, -1) ? worn_model_def(L, worn) : NULL;
  if (other) {
    def = *other;
    for (int body = 0; body < ARC_BODIES; body++) def.mesh.zone[body] = 0;
  }
  read_definition(L, lua_gettop(L), location, &def);
  lua_pop(L, 1);
  if (!arc_model_has_maps(&def)) {
    arc_model_def fine = def;
    arc_model_fit(&def, load);
    suit_zones(L, &def, where, zones, definition);
    if (friction) {
      for (int b = 0; b < ARC_BODIES; b++) fine.mesh.zone[b] = def.mesh.zone[b];
      arc_model_fit_friction(&fine, load);
      def = fine;
    }
  }
  return model_push(L, &def, where);
}

arc_model *model_push_wider(lua_State *L, const arc_model *model, const char *where, zones_fn zones,
                            const void *definition) {
  arc_model_def def = *arc_model_definition(model);
  double needed[ARC_BODIES], before[ARC_BODIES];
  char text[200];
  args_get(L, 1, "model");
  const int object = box_test(L, -1, &model_class) != NULL;
  lua_pop(L, 1);
  if (!object || arc_model_is_given(model) || !arc_model_mesh(model, ARC_UPPER)) return NULL;
  if (zones(definition, &def, needed, NULL) != ARC_OK) return NULL;
  for (int b = 0; b < ARC_BODIES; b++) {
    before[b] = def.mesh.zone[b];
    needed[b] = fmax(needed[b], before[b]);
    def.mesh.zone[b] = 0;
  }
  arc_model_fit_zones(&def, needed);
  if (def.mesh.zone[ARC_UPPER] <= before[ARC_UPPER] &&
      def.mesh.zone[ARC_LOWER] <= before[ARC_LOWER])
    return NULL;
  snprintf(text, sizeof text,
           "%s: zones of %.4g and %.4g mm are too narrow; new meshes are built with zones of %.4g "
           "and %.4g mm",
           where, before[ARC_UPPER], before[ARC_LOWER], def.mesh.zone[ARC_UPPER],
           def.mesh.zone[ARC_LOWER]);
  lua_warning(L, text, 0);
  return model_push(L, &def, where);
}

/* --- the object ------------------------------------------------------------------------------- */

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

/* Field model.mesh: a table of the mesh settings, with the mesh object of each body. */
static int model_mesh(lua_State *L) {
  const arc_model_def *def = arc_model_definition(self(L));
  settings_push(L, arc_setting_find(arc_model_settings, "mesh"), def);
  if (arc_model_has_maps(def)) return 1;
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
  const int usual = def->geometry == ARC_PLANE_STRAIN;
  snprintf(text, size, "thickness %.6g mm%s%s", def->thickness, usual ? "" : ", ",
           usual ? "" : arc_space_names[def->geometry]);
  if (def->geometry == ARC_AXISYMMETRIC) snprintf(text, size, "axisymmetric");
  if (def->axis > 0) snprintf(text, size, "axisymmetric about x = %.6g mm", -def->axis);
  return text;
}

static void add_body(luaL_Buffer *text, const arc_model *model, arc_body body) {
  const arc_model_def *def = arc_model_definition(model);
  const arc_mesh *mesh = arc_model_mesh(model, body);
  char line[160];
  if (!mesh) return;
  snprintf(line, sizeof line,
           "\n  %-8s  E %.6g MPa, nu %.6g, %s, zone %.6g mm; %d nodes, %d elements",
           body_name(def, body), def->material[body].E, def->material[body].nu,
           arc_mesh_element(mesh, 4), def->mesh.zone[body], mesh->nodes, mesh->elements);
  luaL_addstring(text, line);
  if (def->material[body].name[0]) luaL_addstring(text, "\n    of ");
  luaL_addstring(text, def->material[body].name);
  pair_add_layers(text, def, body, "\n    layer   ");
}

/* Pushes the description of a model of two half-spaces, which have no meshes. */
static int push_half_spaces(lua_State *L, const arc_model_def *def) {
  char line[200];
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  luaL_addstring(&text, "model: 3-D, half-spaces");
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_body_def solid = arc_model_solid(def, (arc_body)b);
    snprintf(line, sizeof line, "\n  %-8s  E %.6g MPa, nu %.6g", body_name(def, (arc_body)b),
             def->material[b].E, def->material[b].nu);
    luaL_addstring(&text, line);
    if (solid.y_series.count > 0) {
      snprintf(line, sizeof line, ", map of %d x %d points", solid.x_series.count,
               solid.z_series.count);
      luaL_addstring(&text, line);
    }
    if (arc_body_is_spatial(&solid) && solid.radius > 0) {
      snprintf(line, sizeof line, ", radius %.6g mm along x, %.6g mm along z", solid.radius,
               solid.radius_z);
      luaL_addstring(&text, line);
    }
    if (def->body[b].height > 0) {
      snprintf(line, sizeof line, ", %.6g mm on a rigid base", def->body[b].height);
      luaL_addstring(&text, line);
    }
    pair_add_layers(&text, def, (arc_body)b, ", layer ");
  }
  luaL_pushresult(&text);
  return 1;
}

static int model_tostring(lua_State *L) {
  if (arc_model_has_maps(arc_model_definition(self(L))))
    return push_half_spaces(L, arc_model_definition(self(L)));
  const arc_model *model = self(L);
  const arc_model_def *def = arc_model_definition(model);
  char line[500], pair[300], space[100];
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  snprintf(line, sizeof line, "model: %s, %s, elements %.6g x %.6g mm, %.3g MB",
           pair_show(def, pair, sizeof pair), model_show_space(def, space, sizeof space),
           def->mesh.size, def->mesh.height, (double)arc_model_bytes(model) / 1e6);
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

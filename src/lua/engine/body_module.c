/* Module body: body.cylinder{}, body.block{} and other functions return checked tables that
 * describe a body for model{}. */
#include "lua/engine/bodies.h"
#include "lua/engine/body_points.h"
#include "lua/base/array_read.h"
#include "lua/base/call.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/engine/classes.h"
#include "lua/engine/pair_text.h"

#include <stdio.h>
#include <string.h>

static const arc_setting common[] = {
    ARGS_OTHER("kind"),   ARGS_OTHER("name"),      ARGS_OTHER("material"),
    ARGS_OTHER("layers"), ARGS_OTHER("materials"), {.name = NULL},
};

static int is_own(arc_solid kind, const char *name) {
  for (const char *const *own = arc_body_fields(kind); *own; own++)
    if (strcmp(*own, name) == 0) return 1;
  return 0;
}

/* has_points returns true if the surface of this kind of body is given by points over x, has_map if
 * it is given by a map over x and z. */
static int has_points(arc_solid kind) {
  return is_own(kind, "y") && !is_own(kind, "z");
}

static int has_map(arc_solid kind) {
  return is_own(kind, "z");
}

static int is_known(arc_solid kind, const char *name) {
  return is_own(kind, name) || arc_setting_find(common, name) ||
         arc_setting_find(arc_material_settings, name);
}

enum { MOST_NAMES = 48 };

typedef struct name_list {
  const char *name[MOST_NAMES];
  int count;
} name_list;

static void add_name(name_list *to, const char *name) {
  if (to->count < MOST_NAMES) to->name[to->count++] = name;
}

/* Appends the names of the settings in `list` to `to`. String settings (the setting `name`) are
 * omitted. */
static void add_settings(name_list *to, const arc_setting *list) {
  for (const arc_setting *s = list; s->name; s++)
    if (s->kind != ARC_TEXT) add_name(to, s->name);
}

static void refuse_name(lua_State *L, args_location location, const char *name, const char *of,
                        const name_list *known) __attribute__((noreturn));

/* Raises the error for an unknown field. `of` is the text that follows the field in the message:
 * "", or the kind of the body such as " of a ring". */
static void refuse_name(lua_State *L, args_location location, const char *name, const char *of,
                        const name_list *known) {
  names_search search = names_begin(name);
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  for (int i = 0; i < known->count; i++) {
    names_offer(&search, known->name[i]);
    if (i > 0) luaL_addstring(&text, ", ");
    luaL_addstring(&text, known->name[i]);
  }
  luaL_pushresult(&text);
  if (search.best)
    error_raise(L, ARC_ARGUMENT, location.where, "unknown field '%s%s'%s (did you mean '%s'%s?)",
                location.prefix, name, of, search.best, names_relation(&search));
  error_raise(L, ARC_ARGUMENT, location.where, "unknown field '%s%s'%s (known: %s)",
              location.prefix, name, of, lua_tostring(L, -1));
}

static void refuse_body_name(lua_State *L, args_location location, arc_solid kind,
                             const char *name) {
  name_list known = {.count = 0};
  for (const char *const *own = arc_body_fields(kind); *own; own++) add_name(&known, *own);
  add_name(&known, "name");
  add_settings(&known, arc_material_settings);
  add_settings(&known, common + 2); /* skips kind and name, the first two settings */
  refuse_name(L, location, name, lua_pushfstring(L, " of a %s", arc_solid_names[kind]), &known);
}

static void check_names(lua_State *L, int index, args_location location, arc_solid kind) {
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) args_refuse_position(L, location);
    const char *name = names_push_text(L, -2);
    if (!is_known(kind, name)) refuse_body_name(L, location, kind, name);
    lua_pop(L, 1);
  }
}

/* Reads those fields of the table at `index` that are in `list`. Groups and series (materials,
 * layers) are omitted, because other functions read them. */
static void read_part(lua_State *L, int index, args_location location, const arc_setting *list,
                      void *definition) {
  lua_newtable(L);
  for (const arc_setting *s = list; s->name; s++) {
    if (s->kind == ARC_GROUP || s->forms & ARC_SERIES) continue;
    lua_getfield(L, index, s->name);
    lua_setfield(L, -2, s->name);
  }
  args_read(L, -1, location, list, definition);
  lua_pop(L, 1);
}

/* --- materials and layers --------------------------------------------------------------------- */

/* Raises an error if both `material` and one of E, nu and k are set. */
static void refuse_both(lua_State *L, int index, args_location location) {
  if (!args_given(L, index, "material")) return;
  for (const arc_setting *s = arc_material_settings; s->name; s++)
    if (s->kind != ARC_TEXT && args_given(L, index, s->name))
      error_raise(L, ARC_ARGUMENT, location.where,
                  "fields '%smaterial' and '%s%s': expected one of them, got both", location.prefix,
                  location.prefix, s->name);
}

/* Reads a material with all its settings from the field `name`. */
static void read_whole(lua_State *L, int index, args_location location, const char *name,
                       arc_material *to) {
  const arc_setting whole[] = {ARC_MATERIAL_SETTING(0, name, ""), {.name = NULL}};
  lua_newtable(L);
  lua_getfield(L, index, name);
  lua_setfield(L, -2, name);
  args_read(L, -1, location, whole, to);
  lua_pop(L, 1);
}

/* Reads the material of a body from the field `material` or from the fields E, nu and k. */
static void read_material(lua_State *L, int index, args_location location, arc_material *to) {
  refuse_both(L, index, location);
  read_whole(L, index, location, "material", to);
  for (const arc_setting *s = arc_material_settings; s->name; s++)
    if (s->kind != ARC_TEXT)
      read_part(L, index, location, (const arc_setting[]){*s, {.name = NULL}}, to);
}

/* Returns true if an item of the list `layers` has this setting. Excluded are the material of a
 * layer, and its name, which only `materials` uses. */
static int is_of_layer(const arc_setting *s) {
  return s->kind != ARC_TEXT && s->kind != ARC_GROUP;
}

static void refuse_layer_name(lua_State *L, args_location location, const char *name) {
  name_list known = {.count = 0};
  add_settings(&known, arc_layer_settings);
  add_settings(&known, arc_material_settings);
  refuse_name(L, location, name, "", &known);
}

static void read_layer(lua_State *L, args_location location, arc_layer *layer) {
  if (!lua_istable(L, -1)) args_refuse(L, location, "", "a table { thickness=, material= }");
  const int at = lua_gettop(L);
  layer->material = arc_material_default();
  for (lua_pushnil(L); lua_next(L, at); lua_pop(L, 3)) {
    luaL_tolstring(L, -2, NULL);
    const char *name = names_push_text(L, -1);
    const arc_setting *s = arc_setting_find(arc_layer_settings, name);
    if ((!s || s->kind == ARC_TEXT) && !arc_setting_find(arc_material_settings, name))
      refuse_layer_name(L, location, name);
  }
  for (const arc_setting *s = arc_layer_settings; s->name; s++)
    if (is_of_layer(s))
      read_part(L, at, location, (const arc_setting[]){*s, {.name = NULL}}, layer);
  if (layer->thickness == 0) {
    lua_pushnil(L);
    args_refuse(L, location, "thickness", "a number > 0 mm");
  }
  if (!args_given(L, at, "material") && !args_given(L, at, "E")) {
    lua_pushnil(L);
    args_refuse(L, location, "material",
                "a material object or a table " ARC_MATERIAL_TABLE ", or the field E");
  }
  read_material(L, at, location, &layer->material);
}

static const char a_list[] = "a list { { thickness=, material= } }";

/* Returns the number of layers in the list on top of the stack. Raises an error if a key is not an
 * index. */
static int count_layers(lua_State *L, args_location location) {
  if (!lua_istable(L, -1)) args_refuse(L, location, "layers", a_list);
  const int count = (int)array_length(L, location, "layers", ARC_MOST_LAYERS);
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
    const lua_Integer at = lua_isinteger(L, -2) ? lua_tointeger(L, -2) : 0;
    if (at < 1 || at > count)
      error_raise(L, ARC_ARGUMENT, location.where,
                  "field '%slayers': expected %s, got a table that is not a list", location.prefix,
                  a_list);
  }
  return count;
}

static void read_layers(lua_State *L, int index, args_location location, arc_body_def *def) {
  if (lua_getfield(L, index, "layers") == LUA_TNIL) {
    lua_pop(L, 1);
    return;
  }
  const int count = count_layers(L, location);
  for (int l = 0; l < count; l++) {
    lua_rawgeti(L, -1, l + 1);
    const char *prefix = lua_pushfstring(L, "%slayers[%d].", location.prefix, l + 1);
    lua_insert(L, -2);
    read_layer(L, (args_location){location.where, prefix}, &def->layer[l]);
    lua_pop(L, 2);
  }
  lua_pop(L, 1);
}

/* --- materials of a mesh by name -------------------------------------------------------------- */

/* Inserts a name into the first `count` names of the layers, which are in alphabetical order. */
static void enter_name(arc_body_def *def, int count, const char *name) {
  for (; count > 0 && strcmp(def->layer[count - 1].name, name) > 0; count--)
    def->layer[count] = def->layer[count - 1];
  snprintf(def->layer[count].name, sizeof def->layer[count].name, "%s", name);
}

/* Reads the keys of the table at `index` as names of materials. Returns their number. */
static int read_names(lua_State *L, int index, args_location location, arc_body_def *def) {
  int count = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) args_refuse_position(L, location);
    if (lua_rawlen(L, -2) == 0 || lua_rawlen(L, -2) >= ARC_TEXT_SIZE)
      error_raise(L, ARC_ARGUMENT, location.where,
                  "field '%s': expected " ARC_BODY_NAME ", got \"%s\"", location.prefix,
                  lua_tostring(L, -2));
    if (count == ARC_MESH_MATERIALS)
      error_raise(L, ARC_ARGUMENT, location.where,
                  "field '%s': expected at most %d materials, got more", location.prefix,
                  ARC_MESH_MATERIALS);
    enter_name(def, count++, lua_tostring(L, -2));
  }
  return count;
}

/* Reads the table `materials`. Lua tables have no order, so the materials are stored sorted by
 * name. */
static void read_materials(lua_State *L, int index, args_location location, arc_body_def *def) {
  const int top = lua_gettop(L);
  if (lua_getfield(L, index, "materials") != LUA_TNIL) {
    if (!lua_istable(L, -1))
      args_refuse(L, location, "materials",
                  "a table { NAME = material{}, ... } by the mesh's names");
    if (arc_body_layers(def) > 0)
      error_raise(L, ARC_ARGUMENT, location.where,
                  "fields '%slayers' and '%smaterials': expected one of them, got both",
                  location.prefix, location.prefix);
    const args_location inside = {location.where,
                                  lua_pushfstring(L, "%smaterials.", location.prefix)};
    const int count = read_names(L, top + 1, inside, def);
    for (int l = 0; l < count; l++) {
      def->layer[l].material = arc_material_default();
      read_whole(L, top + 1, inside, def->layer[l].name, &def->layer[l].material);
    }
  }
  lua_settop(L, top);
}

/* --- reading a body from a table -------------------------------------------------------------- */

static arc_solid read_kind(lua_State *L, int index, args_location location) {
  lua_getfield(L, index, "kind");
  const int kind = args_choice(L, -1, location, "kind", arc_solid_names, ARC_SOLID_USUAL);
  lua_pop(L, 1);
  if (kind == ARC_SOLID_USUAL)
    error_raise(L, ARC_ARGUMENT, location.where,
                "field '%skind': expected a body, e.g. body.cylinder{ radius=10 }, got a "
                "table without kind",
                location.prefix);
  return (arc_solid)kind;
}

static void read_at(lua_State *L, int index, args_location location, double radius,
                    arc_body_def *def, arc_material *material) {
  luaL_checkstack(L, 20, location.where);
  const arc_solid kind = read_kind(L, index, location);
  check_names(L, index, location, kind);
  *def = (arc_body_def){0};
  arc_settings_default(arc_body_settings, def);
  read_part(L, index, location, arc_body_settings, def);
  read_material(L, index, location, material);
  read_layers(L, index, location, def);
  read_materials(L, index, location, def);
  if (has_points(kind)) body_read_profile(L, index, location, radius, def);
  if (has_map(kind)) body_read_map(L, index, location, def);
}

/* Raises an error if the field `cylinder` or `plate` (a material) is set although the body has a
 * material of its own. */
static void refuse_pair(lua_State *L, int index, args_location location, arc_body body) {
  const char *role = arc_model_role_name(body), *usual = arc_body_name(body);
  if (args_given(L, index, usual))
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields '%s%s' and '%s%s': expected one of them (a body has its own E, nu and k), "
                "got both",
                location.prefix, role, location.prefix, usual);
}

void body_read(lua_State *L, int index, args_location location, arc_model_def *def) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const char *role = arc_model_role_name((arc_body)b);
    const int top = lua_gettop(L);
    if (lua_getfield(L, index, role) != LUA_TNIL) {
      if (!lua_istable(L, -1))
        args_refuse(L, location, role, "a body, e.g. body.cylinder{ radius=10 }");
      refuse_pair(L, index, location, (arc_body)b);
      const args_location inside = {location.where,
                                    lua_pushfstring(L, "%s%s.", location.prefix, role)};
      read_at(L, top + 1, inside, def->radius, &def->body[b], &def->material[b]);
    }
    lua_settop(L, top);
  }
}

/* Returns the index in `names` of the string in a field of the table at `index`, or `otherwise`. */
static int choice_at(lua_State *L, int index, const char *field, const char *const *names,
                     int otherwise) {
  if (lua_getfield(L, index, field) == LUA_TSTRING)
    for (int i = 0; names[i]; i++)
      if (strcmp(names[i], lua_tostring(L, -1)) == 0) otherwise = i;
  lua_pop(L, 1);
  return otherwise;
}

static void read_name(lua_State *L, arc_body_def *def) {
  def->kind = (arc_solid)choice_at(L, -1, "kind", arc_solid_names, (int)def->kind);
  if (lua_getfield(L, -1, "name") == LUA_TSTRING)
    snprintf(def->name, sizeof def->name, "%s", lua_tostring(L, -1));
  lua_pop(L, 1);
}

void body_read_names(lua_State *L, int index, arc_model_def *def) {
  def->geometry = (arc_space)choice_at(L, index, "geometry", arc_space_names, (int)def->geometry);
  for (int b = 0; b < ARC_BODIES; b++) {
    if (lua_getfield(L, index, arc_model_role_name((arc_body)b)) == LUA_TTABLE)
      read_name(L, &def->body[b]);
    lua_pop(L, 1);
  }
}

/* --- printing a body -------------------------------------------------------------------------- */

static int body_tostring(lua_State *L) {
  arc_model_def model = arc_model_default();
  read_at(L, 1, (args_location){"body", ""}, model.radius, &model.body[ARC_UPPER],
          &model.material[ARC_UPPER]);
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  pair_add_body(&text, &model, ARC_UPPER);
  luaL_pushresult(&text);
  return 1;
}

/* Sets the metatable of the table on top of the stack, so that it is printed as a body. */
static void set_body_class(lua_State *L) {
  if (luaL_newmetatable(L, "archard.body")) {
    call_push(L, body_tostring);
    lua_pushcclosure(L, error_plain_result, 1);
    lua_setfield(L, -2, "__tostring");
    lua_pushboolean(L, 1);
    lua_setfield(L, -2, "__plain");
  }
  lua_setmetatable(L, -2);
}

/* --- bodies as Lua tables --------------------------------------------------------------------- */

/* Sets a field of the table on top of the stack to the value of a setting. An optional setting
 * with the value 0 is omitted. */
static void set_given(lua_State *L, const arc_setting *s, const void *definition) {
  if (s->forms & ARC_OPTIONAL && arc_setting_number(s, definition) == 0) return;
  settings_push(L, s, definition);
  lua_setfield(L, -2, s->name);
}

/* Sets E, nu and k in the table on top of the stack. For a material with a name, sets the field
 * `material` to a material object instead. */
static void set_material(lua_State *L, arc_material material) {
  if (material.name[0]) {
    material_push(L, material);
    lua_setfield(L, -2, "material");
    return;
  }
  for (const arc_setting *s = arc_material_settings; s->name; s++)
    if (s->kind != ARC_TEXT) settings_push(L, s, &material), lua_setfield(L, -2, s->name);
}

static void push_layer(lua_State *L, const arc_layer *layer) {
  lua_newtable(L);
  for (const arc_setting *s = arc_layer_settings; s->name; s++)
    if (is_of_layer(s)) set_given(L, s, layer);
  set_material(L, layer->material);
}

static void set_layers(lua_State *L, const arc_body_def *def) {
  const int layers = arc_body_layers(def), named = def->layer[0].name[0] != 0;
  if (layers == 0) return;
  lua_createtable(L, layers, 0);
  for (int l = 0; l < layers; l++) {
    if (named && def->layer[l].material.name[0])
      material_push(L, def->layer[l].material);
    else
      push_layer(L, &def->layer[l]);
    if (named)
      lua_setfield(L, -2, def->layer[l].name);
    else
      lua_rawseti(L, -2, l + 1);
  }
  lua_setfield(L, -2, named ? "materials" : "layers");
}

/* Sets kind, name and the fields of the kind of body in the table on top of the stack. Optional
 * fields with the value 0 are omitted. */
static void set_shape(lua_State *L, const arc_body_def *def) {
  lua_pushstring(L, arc_solid_names[def->kind]);
  lua_setfield(L, -2, "kind");
  if (def->name[0]) lua_pushstring(L, def->name), lua_setfield(L, -2, "name");
  for (const arc_setting *s = arc_body_settings; s->name; s++)
    if (is_own(def->kind, s->name)) set_given(L, s, def);
  const arc_series y = def->y_series, x = def->x_series, z = def->z_series;
  if (has_map(def->kind)) {
    array_set(L, "x", x.value, (size_t)x.count);
    array_set(L, "z", z.value, (size_t)z.count);
  } else if (has_points(def->kind)) {
    array_set(L, "x", y.distance, (size_t)y.count);
  } else {
    return;
  }
  array_set(L, "y", y.value, (size_t)y.count);
}

void body_push(lua_State *L, const arc_model_def *model, arc_body body) {
  const arc_body_def *def = &model->body[body];
  if (def->kind == ARC_SOLID_USUAL) {
    lua_pushnil(L);
    return;
  }
  lua_newtable(L);
  set_shape(L, def);
  set_material(L, model->material[body]);
  set_layers(L, def);
  set_body_class(L);
}

/* --- constructors of bodies ------------------------------------------------------------------- */

/* body.KIND{...}: returns a checked copy of the table, with the field `kind`. */
static int make(lua_State *L) {
  const arc_solid kind = (arc_solid)lua_tointeger(L, lua_upvalueindex(1));
  char where[40];
  snprintf(where, sizeof where, "body.%s", arc_solid_names[kind]);
  const args_location location = {where, ""};
  arc_body_def def;
  arc_material material = arc_material_default();
  arc_error error = {0};
  lua_settop(L, 1);
  if (lua_isnil(L, 1)) lua_newtable(L), lua_replace(L, 1);
  args_check_table(L, 1, where);
  if ((has_points(kind) && body_is(L, 1, "profile")) || (has_map(kind) && body_is(L, 1, "map")))
    lua_newtable(L);
  else
    args_push_copy(L, 1);
  if (has_points(kind)) body_take_profile(L);
  if (has_map(kind)) body_take_map(L, location);
  lua_pushstring(L, arc_solid_names[kind]);
  lua_setfield(L, 2, "kind");
  read_at(L, 2, location, arc_model_default().radius, &def, &material);
  def = arc_body_resolve(&def, ARC_UPPER, arc_model_default().radius);
  error_check(L, arc_body_check(&def, "", &error), &error, where, -1);
  lua_settop(L, 2);
  set_body_class(L);
  return 1;
}

int luaopen_archard_body(lua_State *L) {
  lua_newtable(L);
  for (int kind = ARC_SOLID_USUAL + 1; arc_solid_names[kind]; kind++) {
    lua_pushinteger(L, kind);
    lua_pushcclosure(L, make, 1);
    call_wrap(L);
    lua_setfield(L, -2, arc_solid_names[kind]);
  }
  return 1;
}

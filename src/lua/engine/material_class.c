/* Class material: an elastic material, E and nu. */
#include "lua/engine/classes.h"
#include "lua/base/error.h"

#include <stdio.h>

static const box_class material_class;

static const args_field definition[] = {
    ARGS_ABOVE(arc_material, "E", E, 0),
    {.name = "nu",
     .kind = ARGS_NUMBER,
     .offset = offsetof(arc_material, nu),
     .low = -1,
     .high = 0.5,
     .open = ARGS_LOW_OPEN | ARGS_HIGH_OPEN},
    {.name = NULL},
};

static arc_material *self(lua_State *L) {
  return box_self(L, &material_class, "material")->thing;
}

NUMBER_FIELD(material, E, self(L)->E)
NUMBER_FIELD(material, nu, self(L)->nu)
NUMBER_FIELD(material, E_star, arc_material_E_star(*self(L)))

static int material_tostring(lua_State *L) {
  arc_material material = *self(L);
  char text[120];
  snprintf(text, sizeof text, "material: E %.6g MPa, nu %.6g, E_star %.6g MPa", material.E,
           material.nu, arc_material_E_star(material));
  lua_pushstring(L, text);
  return 1;
}

static const luaL_Reg fields[] = {
    {"E", material_E}, {"nu", material_nu}, {"E_star", material_E_star}, {NULL, NULL}};

static const box_class material_class = {
    .name = "material",
    .fields = fields,
    .tostring = material_tostring,
    .value = sizeof(arc_material),
};

void material_push(lua_State *L, arc_material material) {
  arc_material *value = box_push(L, &material_class)->thing;
  *value = material;
}

void material_read(lua_State *L, args_place place, const char *name, void *member) {
  arc_material *material = member;
  box *given = box_test(L, -1, &material_class);
  if (given) {
    *material = *(arc_material *)given->thing;
    return;
  }
  if (!lua_istable(L, -1)) args_refuse(L, place, name, "a material object or a table { E=, nu= }");
  args_place inner = {place.where, lua_pushfstring(L, "%s%s.", place.prefix, name)};
  args_read(L, -2, inner, definition, material);
  lua_pop(L, 1);
}

/* material{ E=, nu= } */
static int material_new(lua_State *L) {
  arc_material material = arc_material_default();
  arc_error error = {0};
  args_read(L, 1, (args_place){"material", ""}, definition, &material);
  error_check(L, arc_material_check(material, &error), &error, "material", -1);
  material_push(L, material);
  return 1;
}

int luaopen_archard_material(lua_State *L) {
  lua_pushcfunction(L, material_new);
  return 1;
}

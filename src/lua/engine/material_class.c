/* Class material: an elastic material (E, nu) with an optional wear coefficient k. */
#include "lua/base/call.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"

#include <stdio.h>

static const box_class material_class;

static arc_material *self(lua_State *L) {
  return box_self(L, &material_class, "material")->thing;
}

NUMBER_FIELD(material, E_star, arc_material_E_star(*self(L)))

static int material_tostring(lua_State *L) {
  arc_material material = *self(L);
  char text[160];
  snprintf(text, sizeof text, "material%s%.31s: E %.6g MPa, nu %.6g, E_star %.6g MPa",
           material.name[0] ? " " : "", material.name, material.E, material.nu,
           arc_material_E_star(material));
  lua_pushstring(L, text);
  if (material.k > 0)
    lua_pushfstring(L, "%s, k %s mm2/N = %s mm3/(N m)", text, args_show_number(L, material.k),
                    args_show_number(L, 1e3 * material.k));
  return 1;
}

static const luaL_Reg fields[] = {{"E_star", material_E_star}, {NULL, NULL}};

static const void *definition(lua_State *L) {
  return self(L);
}

static const box_class material_class = {
    .name = "material",
    .fields = fields,
    .tostring = material_tostring,
    .value = sizeof(arc_material),
    .settings = arc_material_settings,
    .definition = definition,
};

void material_push(lua_State *L, arc_material material) {
  arc_material *value = box_push(L, &material_class)->thing;
  *value = material;
}

/* Constructor material{ E=, nu=, k=, name= }. */
static int material_new(lua_State *L) {
  arc_material material = arc_material_default();
  args_read(L, 1, (args_location){"material", ""}, arc_material_settings, &material);
  material_push(L, material);
  return 1;
}

int luaopen_archard_material(lua_State *L) {
  call_push(L, material_new);
  return 1;
}

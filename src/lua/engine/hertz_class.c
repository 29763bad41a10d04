/* Class hertz: Hertz contact in closed form (line contact, ball, or elliptic contact in 3-D). */
#include "lua/base/call.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"

#include <stdio.h>

typedef struct hertz_value {
  arc_hertz_def def;
  arc_hertz result;
} hertz_value;

static const box_class hertz_class;

static const hertz_value *self(lua_State *L) {
  return box_self(L, &hertz_class, "hertz")->thing;
}

NUMBER_FIELD(hertz, half_width, self(L)->result.half_width)
NUMBER_FIELD(hertz, p_max, self(L)->result.p_max)
NUMBER_FIELD(hertz, half_width_z, self(L)->result.half_width_z)
NUMBER_FIELD(hertz, E_star, self(L)->result.E_star)
NUMBER_FIELD(hertz, approach, self(L)->result.approach)

static int hertz_cylinder(lua_State *L) {
  material_push(L, self(L)->def.material[ARC_CYLINDER]);
  return 1;
}

static int hertz_plate(lua_State *L) {
  material_push(L, self(L)->def.material[ARC_PLATE]);
  return 1;
}

static int hertz_tostring(lua_State *L) {
  const hertz_value *value = self(L);
  const int is_ball = value->def.geometry == ARC_AXISYMMETRIC;
  char text[300], thick[60] = "";
  if (!is_ball) snprintf(thick, sizeof thick, ", thickness %.6g mm", value->def.thickness);
  snprintf(text, sizeof text,
           "hertz:%s radius %.6g mm, load %.6g N%s%s\n"
           "  half width %.6g mm, largest pressure %.6g MPa, E_star %.6g MPa",
           is_ball ? " ball," : "", value->def.radius, value->def.load, thick,
           value->def.geometry == ARC_PLANE_STRESS ? ", plane stress" : "",
           value->result.half_width, value->result.p_max, value->result.E_star);
  if (value->def.geometry == ARC_SPATIAL)
    snprintf(text, sizeof text,
             "hertz: 3-D, radius %.6g mm along x, %.6g mm along z, load %.6g N\n"
             "  half widths %.6g and %.6g mm, largest pressure %.6g MPa, approach %.6g mm",
             value->def.radius, value->def.radius_z > 0 ? value->def.radius_z : value->def.radius,
             value->def.load, value->result.half_width, value->result.half_width_z,
             value->result.p_max, value->result.approach);
  lua_pushstring(L, text);
  return 1;
}

static const luaL_Reg fields[] = {
    {"half_width", hertz_half_width}, {"half_width_z", hertz_half_width_z},
    {"p_max", hertz_p_max},           {"E_star", hertz_E_star},
    {"approach", hertz_approach},     {"cylinder", hertz_cylinder},
    {"plate", hertz_plate},           {NULL, NULL},
};

static const void *definition(lua_State *L) {
  return &self(L)->def;
}

static const box_class hertz_class = {
    .name = "hertz",
    .fields = fields,
    .tostring = hertz_tostring,
    .value = sizeof(hertz_value),
    .settings = arc_hertz_settings,
    .definition = definition,
};

/* Constructor hertz{ radius=, load=, thickness=, cylinder=, plate= }. */
static int hertz_new(lua_State *L) {
  arc_hertz_def def = arc_hertz_default();
  arc_error error = {0};
  args_read(L, 1, (args_location){"hertz", ""}, arc_hertz_settings, &def);
  hertz_value *value = box_push(L, &hertz_class)->thing;
  value->def = def;
  arc_status status = arc_hertz_of(&def, &value->result, &error);
  error_check(L, status, &error, "hertz", -1);
  return 1;
}

int luaopen_archard_hertz(lua_State *L) {
  call_push(L, hertz_new);
  return 1;
}

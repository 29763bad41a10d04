/* Elastic materials. */
#include "archard/material.h"

#include <math.h>

#define ARC_SETTING_OF arc_material
const arc_setting arc_material_settings[] = {
    ARC_MATERIAL_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_TEXT){.name = NULL}};
#undef ARC_SETTING_OF

arc_material arc_material_default(void) {
  arc_material material;
  arc_settings_default(arc_material_settings, &material);
  return material;
}

double arc_material_E_star(arc_material m) {
  return m.E / (1 - m.nu * m.nu);
}

arc_status arc_material_check(arc_material m, arc_error *error) {
  return arc_settings_check(arc_material_settings, "", &m, error);
}

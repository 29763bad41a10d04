/* Closed-form Hertz line contact. */
#include "archard/model.h"

#include <math.h>

#define ARC_SETTING_OF arc_hertz_def
const arc_setting arc_hertz_settings[] = {
    ARC_HERTZ_SETTINGS(ARC_SETTING_NUMBER)
        ARC_MATERIAL_SETTING(arc_hertz_def, ARC_CYLINDER, "cylinder", "Material of the cylinder."),
    ARC_MATERIAL_SETTING(arc_hertz_def, ARC_PLATE, "plate", "Material of the plate."),
    {.name = NULL},
};
#undef ARC_SETTING_OF

arc_hertz_def arc_hertz_default(void) {
  arc_hertz_def def;
  arc_settings_default(arc_hertz_settings, &def);
  return def;
}

arc_status arc_hertz_solve(double radius, double thickness, double load,
                           const arc_material material[ARC_BODIES], arc_hertz *hertz,
                           arc_error *error) {
  const arc_hertz_def def = {radius, load, thickness, {material[0], material[1]}};
  const arc_status status = arc_settings_check(arc_hertz_settings, "", &def, error);
  if (status != ARC_OK) return status;
  const double pi = acos(-1), line = load / thickness;
  hertz->E_star = arc_contact_modulus(material);
  hertz->half_width = sqrt(4 * line * radius / (pi * hertz->E_star));
  hertz->p_max = 2 * line / (pi * hertz->half_width);
  return ARC_OK;
}

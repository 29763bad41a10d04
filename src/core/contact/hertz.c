/* Closed-form Hertz line contact. */
#include "archard/model.h"

#include <math.h>

static arc_status check(const char *field, const char *unit, double value, arc_error *error) {
  if (value > 0 && isfinite(value)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "%s: expected above 0 %s, got %g %s", field, unit, value,
                  unit);
}

arc_status arc_hertz_solve(double radius, double thickness, double load,
                           const arc_material material[ARC_BODIES], arc_hertz *hertz,
                           arc_error *error) {
  arc_status status;
  if ((status = check("radius", "mm", radius, error)) ||
      (status = check("thickness", "mm", thickness, error)) ||
      (status = check("load", "N", load, error)) ||
      (status = arc_material_check(material[ARC_CYLINDER], error)) ||
      (status = arc_material_check(material[ARC_PLATE], error)))
    return status;
  const double pi = acos(-1), line = load / thickness;
  hertz->E_star = arc_contact_modulus(material);
  hertz->half_width = sqrt(4 * line * radius / (pi * hertz->E_star));
  hertz->p_max = 2 * line / (pi * hertz->half_width);
  return ARC_OK;
}

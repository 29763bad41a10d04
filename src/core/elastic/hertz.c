/* Closed-form Hertz contact. */
#include "archard/model.h"
#include "archard/space.h"

#include "core/pair/kind.h"

#include <math.h>

#define ARC_SETTING_OF arc_hertz_def
const arc_setting arc_hertz_settings[] = {
    ARC_HERTZ_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_CHOICE) ARC_MATERIAL_SETTING(
        offsetof(arc_hertz_def, material[ARC_CYLINDER]), "cylinder", "Material of the cylinder."),
    ARC_MATERIAL_SETTING(offsetof(arc_hertz_def, material[ARC_PLATE]), "plate",
                         "Material of the plate."),
    {.name = NULL},
};
#undef ARC_SETTING_OF

arc_hertz_def arc_hertz_default(void) {
  arc_hertz_def def;
  arc_settings_default(arc_hertz_settings, &def);
  return def;
}

static void solve_line(const arc_hertz_def *d, arc_hertz *hertz) {
  const double pi = acos(-1), line = d->load / d->thickness;
  hertz->half_width = sqrt(4 * line * d->radius / (pi * hertz->E_star));
  hertz->p_max = 2 * line / (pi * hertz->half_width);
  hertz->approach = hertz->half_width_z = NAN;
}

static void solve_point(const arc_hertz_def *d, arc_hertz *hertz) {
  const double pi = acos(-1), a = cbrt(3 * d->load * d->radius / (4 * hertz->E_star));
  hertz->half_width = a;
  hertz->p_max = 3 * d->load / (2 * pi * a * a);
  hertz->approach = a * a / d->radius;
  hertz->half_width_z = a;
}

static arc_status solve_ellipse(const arc_hertz_def *d, arc_hertz *hertz, arc_error *error) {
  arc_hertz_ellipse e = {0, 0, 0, 0};
  const double across = d->radius_z > 0 ? d->radius_z : d->radius;
  const arc_status status =
      arc_hertz_ellipse_of(d->radius, across, hertz->E_star, d->load, &e, error);
  hertz->half_width = e.half_width;
  hertz->half_width_z = e.half_width_z;
  hertz->p_max = e.p_max;
  hertz->approach = e.approach;
  return status;
}

arc_status arc_hertz_of(const arc_hertz_def *def, arc_hertz *hertz, arc_error *error) {
  const arc_status status = arc_settings_check(arc_hertz_settings, "", def, error);
  if (status != ARC_OK) return status;
  if (!arc_kind_of(def->geometry)->elastic)
    return arc_fail(error, ARC_ARGUMENT, "field 'geometry': Hertz' formulas are not valid for %s",
                    arc_space_names[def->geometry]);
  hertz->E_star = arc_contact_modulus(def->geometry, def->material);
  if (def->geometry != ARC_SPATIAL && def->radius_z > 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'radius_z': expected geometry = \"3-D\" beside it, got \"%s\"",
                    arc_space_names[def->geometry]);
  if (def->geometry == ARC_SPATIAL) return solve_ellipse(def, hertz, error);
  if (def->geometry == ARC_AXISYMMETRIC)
    solve_point(def, hertz);
  else
    solve_line(def, hertz);
  return ARC_OK;
}

arc_status arc_hertz_solve(double radius, double thickness, double load,
                           const arc_material material[ARC_BODIES], arc_hertz *hertz,
                           arc_error *error) {
  const arc_hertz_def def = {.radius = radius,
                             .load = load,
                             .thickness = thickness,
                             .material = {material[0], material[1]}};
  return arc_hertz_of(&def, hertz, error);
}

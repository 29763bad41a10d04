/* Definitions of wear runs: defaults, checks, the choice of procedure, the zones they need. */
#include "core/wear/run.h"

#include <math.h>

arc_wear_def arc_wear_default(void) {
  return (arc_wear_def){.k = 1e-8,
                        .alpha = 0.5,
                        .load = 100,
                        .stroke = 0.11,
                        .distance = 1320,
                        .jump = 100,
                        .increments = 100,
                        .refresh = 0.005};
}

int wear_over_plate(const arc_wear_def *def, const arc_model_def *model) {
  return fabs(def->stroke - 2 * model->radius) <= 1e-9 * model->radius;
}

double arc_wear_def_strokes(const arc_wear_def *def, const arc_model_def *model) {
  return wear_over_plate(def, model) ? 1 : 2;
}

arc_procedure wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model) {
  if (def->procedure != ARC_AUTO) return def->procedure;
  return def->alpha == 1 || wear_over_plate(def, model) ? ARC_NSP : ARC_SP;
}

static arc_status positive(const char *field, const char *unit, double value, arc_error *error) {
  if (value > 0 && isfinite(value)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "%s: expected above 0 %s, got %g %s", field, unit, value,
                  unit);
}

arc_status arc_wear_check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  arc_status status;
  if (!(d->k >= 0) || !isfinite(d->k))
    return arc_fail(error, ARC_ARGUMENT, "k: expected 0 mm2/N or above, got %g mm2/N", d->k);
  if (!(d->alpha >= 0 && d->alpha <= 1))
    return arc_fail(error, ARC_ARGUMENT, "alpha: expected from 0 to 1, got %g", d->alpha);
  if ((status = positive("load", "N", d->load, error)) ||
      (status = positive("stroke", "mm", d->stroke, error)) ||
      (status = positive("distance", "mm", d->distance, error)) ||
      (status = positive("jump", "cycles", d->jump, error)))
    return status;
  if (d->increments < 2 || d->increments % 2 || d->increments > 100000)
    return arc_fail(error, ARC_ARGUMENT,
                    "increments: expected an even number from 2 to 100000, got %d", d->increments);
  if (!(d->refresh >= 0))
    return arc_fail(error, ARC_ARGUMENT, "refresh: expected 0 or above, got %g", d->refresh);
  if (d->stroke > 2 * model->radius * (1 + 1e-9))
    return arc_fail(error, ARC_ARGUMENT,
                    "stroke: expected at most the plate's width 2 radius = %g mm, got %g mm",
                    2 * model->radius, d->stroke);
  if (d->procedure == ARC_NSP && d->alpha != 1 && !wear_over_plate(d, model))
    return arc_fail(
        error, ARC_ARGUMENT,
        "procedure: NSP needs a plate that stays flat, alpha = 1 or stroke = 2 radius = %g mm; "
        "got alpha = %g, stroke = %g mm",
        2 * model->radius, d->alpha, d->stroke);
  return ARC_OK;
}

double wear_coefficient(const arc_wear_def *def, arc_body body) {
  return def->k * (body == ARC_CYLINDER ? def->alpha : 1 - def->alpha);
}

void arc_zone_for(double reach, double half_width, double zone[ARC_BODIES]) {
  const arc_mesh_def usual = arc_mesh_default();
  const double contact = 1.3 * half_width; /* room for the edge peaks of worn contacts */
  zone[ARC_CYLINDER] = fmax(usual.zone[ARC_CYLINDER], 2 * contact);
  zone[ARC_PLATE] = fmax(usual.zone[ARC_PLATE], 2 * (reach + contact));
}

/* Half width at the end: Hertz' at first, and a flat scar of the whole volume on the cylinder at
 * the most (on a flat plate, b^3 = 3 R k L d / 2 per thickness). */
static double widest_contact(const arc_wear_def *def, const arc_model_def *model) {
  arc_hertz hertz = {0};
  arc_hertz_solve(model->radius, model->thickness, def->load, model->material, &hertz, NULL);
  const double line = def->load / model->thickness;
  return hertz.half_width / 2 + cbrt(1.5 * model->radius * def->k * line * def->distance);
}

void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]) {
  const int slides = wear_choose_procedure(def, model) == ARC_SP;
  arc_zone_for(slides ? def->stroke / 2 : 0, widest_contact(def, model), zone);
}

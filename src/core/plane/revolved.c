/* Bodies of revolution in wear runs: valid settings, scars, and the slip due to a spin. */
#include "core/plane/cycle.h"

#include <math.h>

static arc_status refuse_revolved(const char *field, const char *why, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': %s", field, why);
}

static arc_status check_plane(const arc_wear_def *d, arc_error *error) {
  if (d->spin > 0) return refuse_revolved("spin", "expected 0, or an axisymmetric model", error);
  if (d->track > 0)
    return refuse_revolved("track",
                           "expected 0, or an axisymmetric model: a pin on a rotating disc", error);
  return ARC_OK;
}

arc_status arc_wear_check_revolved(const arc_wear_def *d, const arc_model_def *model,
                                   arc_error *error) {
  if (model->geometry != ARC_AXISYMMETRIC) return check_plane(d, error);
  if (arc_wear_has_friction(d))
    return refuse_revolved("friction",
                           "expected 0 for bodies of revolution: shear along x is not axisymmetric",
                           error);
  if (d->slide != ARC_SLIDE_Z)
    return refuse_revolved("slide",
                           "expected \"z\" for bodies of revolution, sliding across the section: a "
                           "contact that moves along x is not axisymmetric",
                           error);
  if (d->spin > 0 && d->track > 0)
    return refuse_revolved("track",
                           "expected none together with spin: a pin either slides along a track or "
                           "rotates about its axis",
                           error);
  if (d->track > 0 && model->axis > 0)
    return refuse_revolved(
        "track", "expected model.axis = 0, a pin that touches the disc on its axis", error);
  if (d->track > 0 && d->blocks > 0)
    return refuse_revolved("track", "expected stroke and load: a cycle is a revolution", error);
  const double spot = arc_model_half_width(model, d->load);
  if (d->track > 0 && d->track <= spot)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'track': expected more than the contact's radius, about %g mm, got %g mm", spot,
        d->track);
  if (d->track > 0 && d->procedure == ARC_SP)
    return refuse_revolved("procedure", "expected \"NSP\" with track: the disc stays flat", error);
  if (model->axis > 0 || d->spin > 0 || d->track > 0 || arc_wear_alpha_stays_one(d)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'alpha': expected 1 if neither track nor spin is set, as a disc that "
                  "passes under a pin wears along its whole track, got %g",
                  d->alpha);
}

/* Computes the half width b of a scar of volume V. The formulas are b^3 = 3 R V / 2 for a cylinder,
 * with V per length, and b^4 = 4 R V / pi for a ball. With a spin, V is replaced by its upper limit
 * V b / spin. */
double arc_wear_scar(const arc_wear_def *def, const arc_model_def *model, double radius,
                     double volume) {
  const double pi = acos(-1);
  const int turns = model->geometry == ARC_AXISYMMETRIC;
  if (turns && model->axis > 0) return cbrt(1.5 * radius * volume / (2 * pi * model->axis));
  if (turns && def->spin > 0) return cbrt(4 * radius * volume / (pi * def->spin));
  return turns ? pow(4 * radius * volume / pi, 0.25)
               : cbrt(1.5 * radius * volume / model->thickness);
}

/* Returns the mean radius [mm] of the area between node i and a neighbour, multiplied by the
 * area per radian. */
static double moment_beside(const revolution *r, double x, double other) {
  const double a = fabs(r->axis + x), b = fabs(r->axis + other), whole = b * b - a * a;
  if (whole == 0) return 0;
  return 2 * (b * b * (b * b * b - a * a * a) / 3 - (pow(b, 5) - pow(a, 5)) / 5) / whole;
}

/* The slip at a node is the mean slip over its area, also for a node on the axis. */
double arc_wear_spin_share(const arc_wear *w, const shape_side *side, int i) {
  const revolution *r = &side->body->chart.revolved;
  const double *at = side->settled, x = at[2 * i];
  double moment = 0, area = 0;
  if (w->def.spin == 0) return 1;
  for (int to = -1; to <= 1; to += 2) {
    if (i + to < 0 || i + to >= side->n) continue;
    const double other = at[2 * (i + to)], a = r->axis + x, b = r->axis + other;
    moment += fabs(moment_beside(r, x, other));
    area += fabs(b * b - a * a) / 2;
  }
  return moment / area / w->def.spin;
}

/* Periodic rough surfaces: each map is one period, and the points of the map are the cells. */
#include "core/space/space_kind.h"

#include <math.h>

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status refuse(arc_error *error, const char *field, const char *expected) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': with periodic = true expected %s", field,
                  expected);
}

static const arc_body_def *map_of(const arc_model_def *def) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_body_is_map(&def->body[b])) return &def->body[b];
  return NULL;
}

static double step_of(const arc_series *axis) {
  return (axis->value[axis->count - 1] - axis->value[0]) / (axis->count - 1);
}

static arc_status check_axis(const arc_series *axis, const arc_series *other, const char *name,
                             arc_error *error) {
  static const double apart = 1e-6; /* accepted relative deviation of a step */
  enum { fewest = 8 };
  if (axis->count < fewest || axis->count % 2 != 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'periodic': expected maps with an even number of points along %s, 8 or "
                    "more, got %d",
                    name, axis->count);
  if (axis->count == other->count &&
      fabs(step_of(axis) - step_of(other)) * axis->count <= apart * step_of(axis))
    return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'periodic': expected maps of one period on both bodies, got %d points "
                  "%g mm apart and %d points %g mm apart along %s",
                  axis->count, step_of(axis), other->count, step_of(other), name);
}

arc_status arc_space_check_periodic(const arc_model_def *def, arc_error *error) {
  const arc_body_def *first = map_of(def);
  if (!first) return refuse(error, "upper", "a body.map{} on one side");
  if (def->mesh.size > 0)
    return refuse(error, "mesh.size", "none: cells are the points of the map (map:resample)");
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_body_def *own = &def->body[b];
    const int lower = b == ARC_LOWER;
    if (!arc_body_is_map(own) && arc_body_is_spatial(own))
      return refuse(error, lower ? "lower" : "upper", "a body.map{} or body.block{}");
    if (!arc_body_is_map(own)) continue;
    if (own->radius > 0 || own->radius_z > 0)
      return refuse(error, lower ? "lower.radius" : "upper.radius", "none");
    arc_status status = check_axis(&own->x_series, &first->x_series, "x", error);
    if (status == ARC_OK) status = check_axis(&own->z_series, &first->z_series, "z", error);
    if (status != ARC_OK) return status;
  }
  return ARC_OK;
}

/* Checks the stroke if the lower body wears: it must be at least two periods long. After a whole
 * number of periods all points of the lower body have carried the same pressures; after any large
 * number of periods this is nearly true. */
static arc_status check_stroke(const arc_wear_def *d, const arc_model_def *model,
                               arc_error *error) {
  static const double fewest = 2;
  const arc_hertz_ellipse period = arc_space_period(model, d->load);
  const double along = 2 * (d->slide == ARC_SLIDE_Z ? period.half_width_z : period.half_width);
  if (d->stroke >= fewest * along) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'stroke': with periodic = true and a lower body that wears expected at "
                  "least %g periods, %g mm, got %g mm; or alpha = 1",
                  fewest, fewest * along, d->stroke);
}

arc_status arc_space_check_periodic_run(const arc_wear_def *d, const arc_model_def *model,
                                        arc_error *error) {
  const arc_body_def lower = arc_model_solid(model, ARC_LOWER);
  if (d->track > 0) return refuse(error, "track", "none: periodic surfaces have no track");
  if (!arc_body_is_flat(&lower))
    return refuse(
        error, "lower",
        "a body.block{}: exchange the bodies, so that the body with the map is the upper one");
  if (d->procedure == ARC_SP || d->blocks > 0)
    return refuse(error, d->blocks > 0 ? "loading" : "procedure",
                  "stroke without loading and procedure \"NSP\"");
  return arc_wear_alpha_stays_one(d) ? ARC_OK : check_stroke(d, model, error);
}

/* --- sizes ------------------------------------------------------------------------------------ */

double arc_space_period_height(void *context, double x, double z) {
  const arc_body_def *map = context;
  const arc_series *along = &map->x_series, *across = &map->z_series;
  return -arc_body_map_height(map, x + (along->value[0] + along->value[along->count - 1]) / 2,
                              z + (across->value[0] + across->value[across->count - 1]) / 2);
}

arc_hertz_ellipse arc_space_period(const arc_model_def *def, double load) {
  const arc_body_def *map = map_of(def);
  const double x = step_of(&map->x_series) * map->x_series.count,
               z = step_of(&map->z_series) * map->z_series.count;
  double least = INFINITY, most = -INFINITY;
  for (int k = 0; k < map->y_series.count; k++) {
    least = fmin(least, map->y_series.value[k]);
    most = fmax(most, map->y_series.value[k]);
  }
  return (arc_hertz_ellipse){.half_width = x / 2,
                             .half_width_z = z / 2,
                             .p_max = load / (x * z),
                             .approach = most - least};
}

double arc_space_period_step(const arc_model_def *def) {
  return step_of(&map_of(def)->x_series);
}

void arc_space_period_cells(const arc_model_def *def, int turned, arc_halfspace_def *cells) {
  const arc_body_def *map = map_of(def);
  const arc_series *along = turned ? &map->z_series : &map->x_series,
                   *across = turned ? &map->x_series : &map->z_series;
  cells->size_x = step_of(along);
  cells->size_z = step_of(across);
  cells->nx = along->count;
  cells->nz = across->count;
  cells->track = 0;
  cells->turned = turned;
}

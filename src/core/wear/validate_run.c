/* Checks a run: its history, its wear volumes, and the properties that its kind of pair checks. */
#include "core/wear/run.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* --- history ---------------------------------------------------------------------------------- */

/* Checks that all values of a record are finite. Only alpha-tilde (depth_partition) may be NaN, as
 * long as both bodies are unworn. */
static arc_status check_finite(const arc_wear_record *r, arc_error *error) {
  arc_wear_record known = *r;
  if (isnan(r->depth_partition) && !(r->depth_cylinder + r->depth_plate > 0))
    known.depth_partition = 0;
#define CHECK_COLUMN(name, unit, range, rule, text)                                                \
  if (!isfinite(known.name))                                                                       \
    return arc_fail(error, ARC_NUMERIC, "history: " #name " is %g after update %.0f", known.name,  \
                    known.update);
  ARC_WEAR_COLUMNS(CHECK_COLUMN)
#undef CHECK_COLUMN
  return ARC_OK;
}

static arc_status check_growth(const arc_wear_record *before, const arc_wear_record *now,
                               arc_error *error) {
#define CHECK_GROWTH(name)                                                                         \
  if (now->name < before->name)                                                                    \
    return arc_fail(error, ARC_NUMERIC, "history: " #name " falls by %g at update %.0f",           \
                    before->name - now->name, now->update);
  CHECK_GROWTH(update)
  CHECK_GROWTH(cycle)
  CHECK_GROWTH(distance)
  CHECK_GROWTH(volume_cylinder)
  CHECK_GROWTH(volume_plate)
  CHECK_GROWTH(load_distance)
  CHECK_GROWTH(solutions)
#undef CHECK_GROWTH
  return ARC_OK;
}

/* --- volumes: k L d of Archard's law ---------------------------------------------------------- */

/* Returns true if the wear volume of a record must equal k L d (wear coefficient, load, sliding
 * distance). This does not hold in runs with a loading, spin, friction, a nonlinear law, local
 * factors or elastic slip, or if coefficients change while the geometry is updated at every
 * increment. */
static int volume_is_known(const arc_wear *w) {
  const arc_wear_def *d = arc_wear_definition(w);
  const int varies =
      d->k_function || d->alpha_function || d->k_series.count > 0 || d->alpha_series.count > 0;
  return d->blocks == 0 && d->spin == 0 &&
         !(d->friction > 0 || d->friction_function || d->friction_series.count > 0) &&
         d->slip == ARC_SLIP_RIGID && (arc_law_properties[d->law] & ARC_LAW_LINEAR) &&
         !d->local_factor && !(varies && d->update == ARC_UPDATE_INCREMENT);
}

static arc_status check_volume(const arc_wear_def *d, const arc_wear_record *before,
                               const arc_wear_record *now, arc_body body, arc_error *error) {
  const int plate = body == ARC_PLATE;
  const double total = plate ? now->volume_plate : now->volume_cylinder;
  const double added = total - (plate ? before->volume_plate : before->volume_cylinder);
  const double k = now->k * (plate ? 1 - now->alpha : now->alpha);
  const double expected = k * d->load * (now->distance - before->distance);
  const double within = d->scheme == ARC_IMPLICIT ? 1e-6 : 1e-9;
  if (fabs(added - expected) <= within * expected + 1e-12 * total) return ARC_OK;
  return arc_fail(error, ARC_NUMERIC,
                  "volume: update %.0f removes %.17g mm3 from the %s, k L d is %.17g mm3",
                  now->update, added, arc_body_name(body), expected);
}

static arc_status check_history(const arc_wear *w, arc_error *error) {
  size_t count;
  const arc_wear_record *r = arc_wear_history(w, &count);
  const arc_wear_def *d = arc_wear_definition(w);
  const int known = volume_is_known(w);
  assert(count > 0);
  arc_status status = check_finite(&r[0], error);
  for (size_t i = 1; i < count && status == ARC_OK; i++) {
    status = check_finite(&r[i], error);
    if (status == ARC_OK) status = check_growth(&r[i - 1], &r[i], error);
    /* volumes are not checked in rows before the last change of the definition */
    if (!known || r[i - 1].distance < d->start_distance) continue;
    for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
      if (!w->manner.layered[b]) /* the record does not contain the wear coefficients of layers */
        status = check_volume(d, &r[i - 1], &r[i], (arc_body)b, error);
  }
  return status;
}

arc_status arc_wear_validate(const arc_wear *w, arc_error *error) {
  const arc_status status = check_history(w, error);
  return status == ARC_OK && w->kind->validate ? w->kind->validate(w, error) : status;
}

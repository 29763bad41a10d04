/* Definitions of wear runs: defaults, checks, copies, the choice of procedure, the zones they need.
 */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

arc_wear_def arc_wear_default(void) {
  return (arc_wear_def){.k = 1e-8,
                        .alpha = 0.5,
                        .load = 100,
                        .stroke = 0.11,
                        .distance = 1320,
                        .jump = 100,
                        .increments = 100,
                        .refresh = 0.005,
                        .law_pressure = 100,
                        .law_exponent = 1,
                        .order = 2};
}

int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model) {
  return def->blocks == 0 && fabs(def->stroke - 2 * model->radius) <= 1e-9 * model->radius;
}

double arc_wear_def_strokes(const arc_wear_def *def, const arc_model_def *model) {
  return arc_wear_over_plate(def, model) ? 1 : 2;
}

static int alpha_stays_one(const arc_wear_def *def) {
  return def->alpha == 1 && !def->alpha_function && def->alpha_series.count == 0;
}

arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model) {
  if (def->procedure != ARC_AUTO) return def->procedure;
  return alpha_stays_one(def) || arc_wear_over_plate(def, model) ? ARC_NSP : ARC_SP;
}

/* --- checks --- */

static arc_status positive(const char *field, const char *unit, double value, arc_error *error) {
  if (value > 0 && isfinite(value)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "%s: expected above 0 %s, got %g %s", field, unit, value,
                  unit);
}

static arc_status check_series(const char *field, const arc_series *s, double most,
                               arc_error *error) {
  for (int i = 0; i < s->count; i++) {
    if (!isfinite(s->distance[i]) || (i > 0 && !(s->distance[i] > s->distance[i - 1])))
      return arc_fail(error, ARC_ARGUMENT,
                      "%s.distance[%d]: expected increasing distances, got %g mm", field, i + 1,
                      s->distance[i]);
    if (!(s->value[i] >= 0 && s->value[i] <= most) || !isfinite(s->value[i]))
      return arc_fail(error, ARC_ARGUMENT, "%s.value[%d]: expected from 0 to %g, got %g", field,
                      i + 1, most, s->value[i]);
  }
  return ARC_OK;
}

static arc_status check_block(const arc_loading *l, int number, int last, arc_error *error) {
  double sliding = 0;
  if (l->count < 2)
    return arc_fail(error, ARC_ARGUMENT, "loading block %d: expected at least 2 points, got %d",
                    number, l->count);
  for (int i = 0; i < l->count; i++) {
    if (!isfinite(l->x[i]))
      return arc_fail(error, ARC_ARGUMENT, "loading block %d: x[%d] is not a finite position (%g)",
                      number, i + 1, l->x[i]);
    if (!(l->load[i] >= 0) || !isfinite(l->load[i]))
      return arc_fail(
          error, ARC_ARGUMENT,
          "loading block %d: load[%d]: expected above 0 N, or 0 for a lift-off, got %g N", number,
          i + 1, l->load[i]);
    if (i > 0) sliding += fabs(l->x[i] - l->x[i - 1]);
  }
  if (!(sliding > 0))
    return arc_fail(error, ARC_ARGUMENT, "loading block %d: the plate does not move, x stays %g mm",
                    number, l->x[0]);
  if (!(l->cycles > 0) || (!last && !isfinite(l->cycles)))
    return arc_fail(error, ARC_ARGUMENT, "loading block %d: cycles: expected above 0%s, got %g",
                    number, last ? "" : " and finite (only the last block may go on)", l->cycles);
  if (!l->periodic && l->cycles != 1)
    return arc_fail(error, ARC_ARGUMENT,
                    "loading block %d: a history that is not periodic runs once, got %g cycles",
                    number, l->cycles);
  return ARC_OK;
}

static arc_status check_loading(const arc_wear_def *d, arc_error *error) {
  for (int b = 0; b < d->blocks; b++) {
    const arc_status status = check_block(&d->loading[b], b + 1, b + 1 == d->blocks, error);
    if (status != ARC_OK) return status;
  }
  if (d->blocks > 0 && d->distance == 0 && !isfinite(d->loading[d->blocks - 1].cycles))
    return arc_fail(error, ARC_ARGUMENT,
                    "distance: needed where the last block of loading has no cycles");
  return ARC_OK;
}

static arc_status check_law(const arc_wear_def *d, arc_error *error) {
  if (d->law != ARC_LAW_ARCHARD && !(d->law_pressure > 0))
    return arc_fail(error, ARC_ARGUMENT, "law_pressure: expected above 0 MPa, got %g MPa",
                    d->law_pressure);
  if (d->law == ARC_LAW_POWER && !(d->law_exponent > -1 && d->law_exponent <= 10))
    return arc_fail(error, ARC_ARGUMENT, "law_exponent: expected above -1 and at most 10, got %g",
                    d->law_exponent);
  return ARC_OK;
}

static arc_status check_scheme(const arc_wear_def *d, arc_error *error) {
  if (!(d->tolerance >= 0 && d->tolerance < 1))
    return arc_fail(error, ARC_ARGUMENT, "tolerance: expected from 0 to 1, got %g", d->tolerance);
  if (d->tolerance > 0 && d->scheme != ARC_IMPLICIT)
    return arc_fail(error, ARC_ARGUMENT, "tolerance: needs scheme = \"implicit\"");
  if (d->tolerance > 0 && d->law == ARC_LAW_THRESHOLD)
    return arc_fail(error, ARC_ARGUMENT,
                    "tolerance: no step is short enough for law = \"threshold\", which jumps; use "
                    "scheme = \"explicit\" with jump = \"auto\"");
  if (d->order != 1 && d->order != 2)
    return arc_fail(error, ARC_ARGUMENT, "order: expected 1 or 2, got %d", d->order);
  if (d->jump_auto && d->scheme == ARC_IMPLICIT)
    return arc_fail(
        error, ARC_ARGUMENT,
        "jump: \"auto\" is for scheme = \"explicit\"; give the implicit scheme a tolerance");
  return ARC_OK;
}

static arc_status check_procedure(const arc_wear_def *d, const arc_model_def *model,
                                  arc_error *error) {
  if (d->blocks == 0 && d->stroke > 2 * model->radius * (1 + 1e-9))
    return arc_fail(error, ARC_ARGUMENT,
                    "stroke: expected at most the plate's width 2 radius = %g mm, got %g mm",
                    2 * model->radius, d->stroke);
  const double widest = 1.5 * model->radius; /* the mesher's widest zone less a contact */
  if (d->blocks == 0 && d->stroke > widest && arc_wear_choose_procedure(d, model) == ARC_SP)
    return arc_fail(error, ARC_ARGUMENT,
                    "stroke: a sliding plate (SP) takes at most 1.5 radius = %g mm, got %g mm; 2 "
                    "radius = %g mm is the half-reciprocating stroke over the whole plate (NSP)",
                    widest, d->stroke, 2 * model->radius);
  if (d->procedure == ARC_NSP && !alpha_stays_one(d) && !arc_wear_over_plate(d, model))
    return arc_fail(
        error, ARC_ARGUMENT,
        "procedure: NSP needs a plate that stays flat, alpha = 1 or stroke = 2 radius = %g mm; "
        "got alpha = %g, stroke = %g mm",
        2 * model->radius, d->alpha, d->stroke);
  return ARC_OK;
}

arc_status arc_wear_check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  arc_status status;
  if (!(d->k >= 0) || !isfinite(d->k))
    return arc_fail(error, ARC_ARGUMENT, "k: expected 0 mm2/N or above, got %g mm2/N", d->k);
  if (!(d->alpha >= 0 && d->alpha <= 1))
    return arc_fail(error, ARC_ARGUMENT, "alpha: expected from 0 to 1, got %g", d->alpha);
  if ((status = positive("load", "N", d->load, error)) ||
      (status = positive("stroke", "mm", d->stroke, error)) ||
      (d->blocks == 0 && (status = positive("distance", "mm", d->distance, error))) ||
      (status = positive("jump", "cycles", d->jump, error)))
    return status;
  if (!(d->distance >= 0) || !isfinite(d->distance))
    return arc_fail(error, ARC_ARGUMENT, "distance: expected above 0 mm, got %g mm", d->distance);
  if (d->increments < 2 || d->increments % 2 || d->increments > 100000)
    return arc_fail(error, ARC_ARGUMENT,
                    "increments: expected an even number from 2 to 100000, got %d", d->increments);
  if (!(d->refresh >= 0))
    return arc_fail(error, ARC_ARGUMENT, "refresh: expected 0 or above, got %g", d->refresh);
  if ((status = check_procedure(d, model, error)) || (status = check_law(d, error)) ||
      (status = check_scheme(d, error)) || (status = check_loading(d, error)) ||
      (status = check_series("k", &d->k_series, HUGE_VAL, error)))
    return status;
  return check_series("alpha", &d->alpha_series, 1, error);
}

/* --- copies --- */

/* Two arrays of n doubles as one block, given back as the first. */
static double *copy_pair(int n, const double *first, const double *second) {
  double *block = malloc(2 * (size_t)n * sizeof *block);
  if (!block) return NULL;
  memcpy(block, first, (size_t)n * sizeof *block);
  memcpy(block + n, second, (size_t)n * sizeof *block);
  return block;
}

static arc_status copy_series(arc_series *s) {
  if (s->count == 0) return ARC_OK;
  double *block = copy_pair(s->count, s->distance, s->value);
  if (!block) {
    *s = (arc_series){0};
    return ARC_MEMORY;
  }
  *s = (arc_series){s->count, block, block + s->count};
  return ARC_OK;
}

static arc_status copy_loading(const arc_wear_def *def, arc_wear_def *copy) {
  copy->loading = NULL;
  copy->blocks = 0;
  if (def->blocks == 0) return ARC_OK;
  arc_loading *blocks = malloc((size_t)def->blocks * sizeof *blocks);
  if (!blocks) return ARC_MEMORY;
  copy->loading = blocks;
  for (int b = 0; b < def->blocks; b++) {
    blocks[b] = def->loading[b];
    double *pair = copy_pair(blocks[b].count, def->loading[b].x, def->loading[b].load);
    if (!pair) return ARC_MEMORY;
    blocks[b].x = pair;
    blocks[b].load = pair + blocks[b].count;
    copy->blocks++;
  }
  return ARC_OK;
}

arc_status arc_wear_def_copy(const arc_wear_def *def, arc_wear_def *copy) {
  *copy = *def;
  const arc_status k = copy_series(&copy->k_series), alpha = copy_series(&copy->alpha_series);
  const arc_status loading = copy_loading(def, copy);
  if (k == ARC_OK && alpha == ARC_OK && loading == ARC_OK) return ARC_OK;
  arc_wear_def_free(copy);
  return ARC_MEMORY;
}

void arc_wear_def_free(arc_wear_def *def) {
  free((void *)(size_t)def->k_series.distance);
  free((void *)(size_t)def->alpha_series.distance);
  for (int b = 0; b < def->blocks; b++) free((void *)(size_t)def->loading[b].x);
  free((void *)(size_t)def->loading);
  *def = (arc_wear_def){0};
}

/* --- zones --- */

/* Room for the edge peaks of worn contacts, in half widths. */
static const double contact_room = 1.3;

void arc_zone_for(double reach, double half_width, double size, double zone[ARC_BODIES]) {
  const arc_mesh_def usual = arc_mesh_default();
  const double contact = contact_room * half_width, scale = size / usual.size;
  zone[ARC_CYLINDER] = fmax(scale * usual.zone[ARC_CYLINDER], 2 * contact);
  zone[ARC_PLATE] = fmax(scale * usual.zone[ARC_PLATE], 2 * (reach + contact));
}

/* Travelled distance of the whole run [mm]; blocks of loading may be all that tells. */
static double whole_distance(const arc_wear_def *def) {
  double sum = def->distance;
  for (int b = 0; b < def->blocks && def->distance == 0; b++) {
    const arc_loading *l = &def->loading[b];
    for (int i = 1; i < l->count; i++) sum += l->cycles * fabs(l->x[i] - l->x[i - 1]);
  }
  return sum;
}

static double largest_k(const arc_wear_def *def) {
  double k = def->k_series.count > 0 ? 0 : def->k;
  for (int i = 0; i < def->k_series.count; i++) k = fmax(k, def->k_series.value[i]);
  return k;
}

/* Half width of the widest contact: Hertz' at first, and a flat scar of the whole volume on the
 * cylinder at the most (on a flat plate, b^3 = 3 R k L d / 2 per thickness). */
static double widest_contact(const arc_wear_def *def, const arc_model_def *model, double load) {
  arc_hertz hertz = {0};
  arc_hertz_solve(model->radius, model->thickness, load, model->material, &hertz, NULL);
  const double line = load / model->thickness;
  const double scar = cbrt(1.5 * model->radius * largest_k(def) * line * whole_distance(def));
  const double widest = fmax(hertz.half_width, hertz.half_width / 2 + scar);
  /* on coarse meshes the room beside it is counted in elements: one under the edge, two that stay
   * open */
  return fmax(widest, (widest + 3 * model->mesh.size) / contact_room);
}

void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]) {
  const int slides = arc_wear_choose_procedure(def, model) == ARC_SP;
  double reach = slides && def->blocks == 0 ? def->stroke / 2 : 0, load = def->load;
  for (int b = 0; b < def->blocks; b++)
    for (int i = 0; i < def->loading[b].count; i++) {
      if (slides) reach = fmax(reach, fabs(def->loading[b].x[i]));
      load = fmax(load, def->loading[b].load[i]);
    }
  arc_zone_for(reach, widest_contact(def, model, load), model->mesh.size, zone);
}

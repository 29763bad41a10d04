/* Definitions of wear runs in 3-D: checks combinations of settings, and computes derived values,
 * such as the number of increments and the cells. */
#include "core/elastic/layer_wear.h"
#include "core/space/cerruti.h"
#include "core/space/space_kind.h"

#include <math.h>

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status refuse(arc_error *error, const char *field, const char *why) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': with geometry = \"3-D\" %s", field, why);
}

/* Rejects settings that are not available in 3-D. */
static arc_status check_built(const arc_wear_def *d, arc_error *error) {
  if (d->spin > 0) return refuse(error, "spin", "expected none");
  if (d->track > 0 && d->blocks > 0)
    return refuse(error, "track",
                  "expected stroke and load instead of loading: a cycle is a revolution");
  if (d->slip == ARC_SLIP_TOTAL) return refuse(error, "slip", "expected \"rigid\"");
  if (d->update == ARC_UPDATE_INCREMENT) return refuse(error, "update", "expected \"cycle\"");
  if (d->load_angle != 0)
    return refuse(error, "load_angle",
                  "expected 0: a load angle is possible only in a hole in 2-D");
  return ARC_OK;
}

/* Returns true if the unworn lower body is flat, and therefore uniform along the motion. */
static int lower_is_flat(const arc_model_def *model) {
  const arc_body_def lower = arc_model_solid(model, ARC_LOWER);
  return arc_body_is_flat(&lower);
}

/* Returns true if the contact is solved at one position only: procedure NSP, a pin on a disc, or
 * periodic surfaces. */
static int rests(const arc_wear_def *d, const arc_model_def *model) {
  return d->track > 0 || d->procedure == ARC_NSP || model->periodic ||
         (d->procedure == ARC_AUTO && arc_wear_alpha_stays_one(d) && lower_is_flat(model));
}

static arc_status check_increments(const arc_wear_def *d, const arc_model_def *model,
                                   arc_error *error) {
  enum { most = 4000 };
  const double made = d->blocks == 0 && d->increments == 0
                          ? 2 * d->stroke / arc_space_cell(model, d->load)
                          : d->increments;
  if (made <= most) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'increments': the stroke needs %.3g increments, one per cell of %.3g mm; "
                  "expected at most %d: use procedure = \"NSP\" or a larger mesh.size",
                  made, arc_space_cell(model, d->load), most);
}

static arc_status check_loading(const arc_wear_def *d, arc_error *error) {
  for (int b = 0; b < d->blocks; b++)
    if (d->loading[b].rotation || d->loading[b].load_angle)
      return refuse(error, "loading", "expected x and load: bodies in 3-D do not rotate");
  return ARC_OK;
}

/* Rejects friction on periodic surfaces, in a groove, with layers or on a rigid base, because the
 * response of such bodies to shear is not implemented. Also rejects friction in cycles in which the
 * bodies separate, because separation removes the shear caused by pressing. */
static arc_status check_friction(const arc_wear_def *d, const arc_model_def *model,
                                 arc_error *error) {
  if (!arc_wear_has_friction(d)) return ARC_OK;
  if (model->periodic) return refuse(error, "friction", "expected 0 on periodic surfaces");
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_body_layers(&model->body[b]) > 0 || model->body[b].height > 0)
      return refuse(
          error, "friction",
          "expected 0 with layers or a rigid base: the shear of such bodies is not computed");
  if (d->track > 0 || (d->procedure == ARC_NSP && !arc_wear_alpha_stays_one(d)))
    return refuse(error, "friction",
                  "expected 0 with track, or with procedure = \"NSP\" and alpha < 1");
  for (int b = 0; b < d->blocks; b++)
    for (int i = 0; i < d->loading[b].count; i++)
      if (!(d->loading[b].load[i] > 0))
        return refuse(error, "loading",
                      "expected loads above 0: with friction the bodies must stay in contact");
  return ARC_OK;
}

static arc_status check_groove(const arc_wear_def *d, const arc_model_def *model,
                               arc_error *error) {
  if (rests(d, model) && !lower_is_flat(model))
    return refuse(error, d->track > 0 ? "track" : "procedure",
                  "expected a lower body.block{}, which is uniform along the motion");
  const arc_hertz_ellipse hertz = arc_space_hertz(model, d->load);
  const int turned = d->slide == ARC_SLIDE_Z;
  const double scar = 2 * (turned ? hertz.half_width_z : hertz.half_width);
  const double widest = 2 * fmax(hertz.half_width, hertz.half_width_z);
  if (d->track > 0 && d->procedure == ARC_SP)
    return refuse(error, "procedure", "expected \"NSP\" with track: the contact does not move");
  if (d->track > 0 && d->track <= widest)
    return arc_fail(error, ARC_GEOMETRY,
                    "field 'track': expected more than the contact's width %g mm, got %g mm",
                    widest, d->track);
  if (d->track > 0 || d->procedure != ARC_NSP || arc_wear_alpha_stays_one(d)) return ARC_OK;
  if (d->blocks > 0)
    return refuse(error, "procedure",
                  "expected \"SP\" with loading: \"NSP\" needs a constant stroke");
  if (d->stroke >= 2 * scar) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'procedure': \"NSP\" treats the scar as a uniform groove: expected a stroke of at "
      "least 2 contact widths, got %.3g",
      d->stroke / scar);
}

arc_status arc_space_check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  arc_status status = check_built(d, error);
  if (status == ARC_OK) status = check_friction(d, model, error);
  if (status == ARC_OK && model->periodic) return arc_space_check_periodic_run(d, model, error);
  if (status == ARC_OK) status = check_loading(d, error);
  if (status == ARC_OK) status = check_groove(d, model, error);
  if (status == ARC_OK && !rests(d, model) && !(d->tangential > 0))
    status = check_increments(d, model, error);
  return status;
}

/* --- derived values */

int arc_space_prefers_implicit(const arc_wear_def *def) {
  (void)def;
  return 1;
}

/* Returns the factor [N/mm] between a tangential force and the nominal displacement, from which
 * distances are computed if a force drives the plate: 2 a E* with the mean contact radius a and the
 * contact modulus E*. */
static double force_per_distance(const arc_wear_def *def, const arc_model_def *model) {
  const arc_hertz_ellipse hertz = arc_space_hertz(model, def->load);
  return 2 * sqrt(hertz.half_width * hertz.half_width_z) *
         arc_contact_modulus(model->geometry, model->material);
}

wear_manner arc_space_manner(const arc_wear_def *def, const arc_model_def *model) {
  return (wear_manner){.procedure = rests(def, model) ? ARC_NSP : ARC_SP,
                       .strokes = 2,
                       .stroke = arc_wear_def_stroke(def),
                       .modulus = force_per_distance(def, model),
                       .thickness = 1,
                       .layered = {arc_layer_wear_differs(model, ARC_UPPER),
                                   arc_layer_wear_differs(model, ARC_LOWER)},
                       .rests = rests(def, model)};
}

static int are_unlike(const arc_model_def *model) {
  const arc_halfspace_def bodies = arc_space_bodies(model);
  return arc_cerruti_unlike(&bodies) != 0;
}

/* Returns the number of increments of a cycle: the number set by the user, or one per cell of the
 * stroke, at least 4. The automatic number of cells of a stroke is even, so that the
 * contact is at whole cells at both ends and in the middle of the stroke, also after the cells of a
 * long stroke were doubled; these cells may be wider than the usual cell, but not by much. With
 * friction the minimum is one per stroke, or two between unlike bodies, for which the error of the
 * wear is below 0.4 %. Cycles under a tangential force have this minimum. */
int arc_space_increments(const arc_wear_def *def, const arc_model_def *model) {
  enum { most = 1 << 20 };
  static const double wider = 1.25;
  if (def->increments > 0) return def->increments;
  const int of_slip = are_unlike(model) ? 4 : 2;
  if (def->tangential > 0) return of_slip;
  const int rubs = arc_wear_has_friction(def), fewest = rubs ? of_slip : 4;
  const double cells = def->stroke / arc_space_cell(model, def->load);
  const double unit = arc_space_stroke_unit(def, model, cells);
  const double half = unit * fmax(round(cells / unit), ceil(cells / unit / wider));
  return 2 * (int)fmin(fmax(fewest / 2, half), most);
}

double arc_space_reach(const arc_model_def *model, double load) {
  return arc_space_cell(model, load);
}

double arc_space_parts(const arc_wear_def *def, const arc_model_def *model,
                       const arc_loading *loading, double *parts) {
  const double longest = arc_space_cell(model, def->load);
  double sum = 0;
  if (parts) parts[0] = 0;
  for (int i = 1; i < loading->count; i++) {
    const double sliding = fabs(loading->x[i] - loading->x[i - 1]);
    const double made = def->increments > 0 ? 1 : fmax(1, ceil(sliding / longest - 1e-9));
    if (parts) parts[i] = made;
    sum += made;
  }
  return sum;
}

/* --- cells ------------------------------------------------------------------------------------ */

/* Returns twice the largest distance of the motion from x = 0 [mm]; 0 if the contact is solved at
 * one position only, or if a tangential force drives the lower body. */
static double stroke_of(const arc_wear_def *def, const arc_model_def *model) {
  double most = 0;
  if (rests(def, model) || def->tangential > 0) return 0;
  if (def->blocks == 0) return def->stroke;
  for (int b = 0; b < def->blocks; b++)
    for (int i = 0; i < def->loading[b].count; i++) most = fmax(most, fabs(def->loading[b].x[i]));
  return 2 * most;
}

/* Returns the estimated worn volume [mm3] for which the first window is sized: the volume at the
 * end of the run, unless its window grows with its cells before. If k is not constant, the volume
 * at the end is unknown. */
static double volume_of(const arc_wear_def *def, const arc_model_def *model) {
  const int known = !def->k_function && def->k_series.count == 0;
  const double most = arc_wear_has_friction(def)
                          ? arc_space_slip_volume(def, model)
                          : arc_space_first_volume(def, model, rests(def, model));
  if (known) return fmin(def->k * def->load * def->distance, most);
  return isfinite(most) ? most : 0;
}

arc_halfspace_def arc_space_cells(const arc_wear_def *def, const arc_model_def *model) {
  const double cell = arc_space_cell(model, def->load);
  const int plain = def->blocks == 0 && !rests(def, model) && !(def->tangential > 0) &&
                    !(arc_wear_has_friction(def) && def->stroke <= cell);
  const int half = arc_space_increments(def, model) / 2;
  const double increment = plain ? def->stroke / (half % 2 == 0 ? half : 2 * half) : 0;
  arc_halfspace_def cells;
  arc_model_def fine = *model;
  if (arc_wear_has_friction(def)) fine.mesh.size = arc_space_slip_cell(def, model);
  arc_space_fit(&fine, def->slide == ARC_SLIDE_Z, def->load, volume_of(def, model),
                stroke_of(def, model), increment, &cells);
  const arc_halfspace_def bodies =
      arc_space_bodies(model); /* uses the maps of *model, not of its local copy */
  for (int b = 0; b < ARC_BODIES; b++) cells.body[b] = bodies.body[b];
  cells.workers = def->workers;
  if (!rests(def, model)) {
    const double shifted = stroke_of(def, model) * arc_space_lower_share(model, cells.turned);
    const int rows = 2 * arc_space_whole_cells(shifted / 2 / cells.size_x - 1e-9);
    cells.nx += rows;
    cells.track += rows;
    arc_space_limit(model, &cells);
  }
  if (rests(def, model) && !arc_wear_alpha_stays_one(def)) {
    cells.groove = def->track > 0    ? 2 * acos(-1) * def->track
                   : model->periodic ? cells.nx * cells.size_x
                                     : def->stroke;
    cells.track = 0;
  }
  return cells;
}

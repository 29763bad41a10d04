/* Definition of wear runs in plane models: default procedure, strokes, increments, and checks of
 * the combinations of settings. */
#include "core/elastic/contact_estimate.h"
#include "core/plane/cycle.h"

#include <math.h>

/* Largest number of increments in a cycle, and in a loading history without repetition. */
static const double most_of_cycle = 1e5, most_of_history = 1e6;

/* Returns true if the stroke covers the whole plate, which then wears uniformly. Returns false for
 * holes, where uniform wear would change the clearance, and for surfaces that are not flat. */
int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model) {
  if (model->geometry == ARC_SPATIAL || arc_model_is_hole(model) || !arc_model_slides_along(model))
    return 0;
  return def->blocks == 0 && def->slide == ARC_SLIDE_X &&
         fabs(def->stroke - arc_model_width(model)) <= 1e-9 * model->radius;
}

double arc_wear_def_stroke(const arc_wear_def *def) {
  return def->track > 0 ? acos(-1) * def->track : def->stroke;
}

/* Returns the automatic number of increments of one stroke. */
static double half_increments(const arc_wear_def *def, const arc_model_def *model) {
  return ceil(def->stroke / arc_wear_reach(model, def->load) * (1 - 1e-9));
}

int arc_wear_def_increments(const arc_wear_def *def, const arc_model_def *model) {
  enum { usual = 100 };
  const int stays = arc_wear_choose_procedure(def, model) == ARC_NSP || def->tangential > 0 ||
                    def->slide == ARC_SLIDE_Z;
  if (def->increments > 0 || stays) return def->increments > 0 ? def->increments : usual;
  const double half = half_increments(def, model);
  return half > usual / 2 ? 2 * (int)half : usual;
}

double arc_wear_def_strokes(const arc_wear_def *def, const arc_model_def *model) {
  return arc_wear_over_plate(def, model) ? 1 : 2;
}

double arc_wear_def_sliding(const arc_wear_def *def, const arc_model_def *model) {
  if (!(def->tangential > 0)) return arc_wear_def_strokes(def, model) * arc_wear_def_stroke(def);
  const wear_manner manner = arc_kind_of(model->geometry)->manner(def, model);
  return 4 * def->tangential / manner.thickness / manner.modulus;
}

arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model) {
  if (def->procedure != ARC_AUTO) return def->procedure;
  if (arc_wear_over_plate(def, model) || def->track > 0) return ARC_NSP;
  if (arc_wear_has_friction(def) || !arc_model_slides_along(model)) return ARC_SP;
  return arc_wear_alpha_stays_one(def) ? ARC_NSP : ARC_SP;
}

int arc_wear_def_of_bodies(arc_wear_def *def, const arc_model_def *model) {
  const double k[ARC_BODIES] = {arc_model_wear_k(model, ARC_CYLINDER),
                                arc_model_wear_k(model, ARC_PLATE)};
  const int have = k[ARC_CYLINDER] > 0 || k[ARC_PLATE] > 0;
  if (have) arc_wear_def_partition(def, k);
  return have;
}

int arc_plane_prefers_implicit(const arc_wear_def *def) {
  for (int b = 0; b < def->blocks; b++)
    if (!def->loading[b].periodic) return 0;
  return !arc_wear_has_friction(def) && def->slip != ARC_SLIP_TOTAL && !def->local_factor &&
         def->update != ARC_UPDATE_INCREMENT;
}

wear_manner arc_plane_manner(const arc_wear_def *def, const arc_model_def *model) {
  const arc_procedure procedure = arc_wear_choose_procedure(def, model);
  const int over = arc_wear_over_plate(def, model), nsp = procedure == ARC_NSP;
  return (wear_manner){.procedure = procedure,
                       .strokes = over ? 1 : 2,
                       .stroke = arc_wear_def_stroke(def),
                       .modulus = arc_contact_modulus(model->geometry, model->material),
                       .radius = arc_chart_of(model).radius,
                       .thickness = model->thickness,
                       .rests = nsp || def->slide == ARC_SLIDE_Z,
                       .even = nsp && (over || def->track > 0),
                       .layered = {arc_body_layers(&model->body[ARC_UPPER]) > 0,
                                   arc_body_layers(&model->body[ARC_LOWER]) > 0},
                       .counts_forces = arc_chart_of(model).polar || def->spin > 0,
                       .closed =
                           arc_plane_stays_as_it_is(def, model) && !arc_wear_has_friction(def)};
}

/* --- checks ----------------------------------------------------------------------------------- */

/* Checks the range of rotations or load angles [degrees]. Rejects both for models without a
 * hole. */
static arc_status check_degrees(const arc_loading *l, const double *value, const char *name,
                                double most, const arc_model_def *model, int number,
                                arc_error *error) {
  for (int i = 0; value && i < l->count; i++)
    if (!(fabs(value[i]) < most))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'loading[%d].%s[%d]': expected a number in (%g, %g) degrees, got %g",
                      number, name, i + 1, -most, most, value[i]);
  if (!value || arc_model_is_hole(model)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'loading[%d].%s': expected a pair with a ring; other bodies do not rotate",
                  number, name);
}

static arc_status check_turning(const arc_loading *l, const arc_model_def *model, int number,
                                arc_error *error) {
  arc_status status = check_degrees(l, l->rotation, "rotation", 36000, model, number, error);
  if (status == ARC_OK)
    status = check_degrees(l, l->load_angle, "load_angle", 90, model, number, error);
  return status;
}

static arc_status check_procedure(const arc_wear_def *d, const arc_model_def *model,
                                  arc_error *error) {
  const double width = arc_model_width(model);
  if (d->blocks == 0 && d->slide == ARC_SLIDE_X && d->stroke > width * (1 + 1e-9))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'stroke': expected at most the plate's width %g mm (2 radius unless set by "
        "body.block{ width = }), got %g mm",
        width, d->stroke);
  const double widest = 0.75 * width; /* largest zone of the mesher minus the contact width [mm] */
  if (d->slide == ARC_SLIDE_Z && d->slip == ARC_SLIP_TOTAL)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'slip': total slip is only computed along x; slide = \"z\" needs slip = \"rigid\"");
  if (d->blocks == 0 && d->slide == ARC_SLIDE_X && d->stroke > widest &&
      arc_wear_choose_procedure(d, model) == ARC_SP)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'stroke': a sliding plate (SP) allows at most 0.75 of the width of the %s = %g mm, "
        "got %g mm; its width = %g mm is the half-reciprocating stroke over the whole plate (NSP)",
        arc_model_body_name(model, ARC_PLATE), widest, d->stroke, width);
  const int flat = arc_wear_alpha_stays_one(d) || d->track > 0 || arc_wear_over_plate(d, model);
  if (d->procedure == ARC_NSP && !flat)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'procedure': NSP needs a plate that stays flat: expected alpha = 1 or "
                    "stroke = 2 radius = %g mm, got alpha = %g, stroke = %g mm",
                    width, d->alpha, d->stroke);
  return ARC_OK;
}

/* Rejects friction together with motions in which the local slip is not along x. */
static arc_status check_friction(const arc_wear_def *d, const arc_model_def *model,
                                 arc_error *error) {
  if (!arc_wear_has_friction(d)) return ARC_OK;
  if (d->procedure == ARC_NSP && !arc_wear_over_plate(d, model))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'procedure': with friction expected \"SP\", because slip is computed "
                    "from the motion of the plate");
  if (d->slide == ARC_SLIDE_Z)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'slide': with friction expected \"x\", because slip is computed in the plane");
  return ARC_OK;
}

static arc_status check_hole(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  const int hole = arc_model_is_hole(model);
  if (d->load_angle != 0 && !hole)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'load_angle': expected 0 (other angles only in a hole), got %g degrees",
                    d->load_angle);
  if (hole && arc_wear_has_friction(d))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'friction': expected 0 in a hole, where shear carries a part of the load");
  return ARC_OK;
}

static arc_status refuse_path(const char *field, double most, double got, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%s': expected a path of at most %g increments, each an eighth of the "
                  "contact's half width, got %g; give increments, or a shorter path",
                  field, most, got);
}

/* Limits the number of automatic increments of the path. The points of a loading that the user
 * chose are not counted. */
static arc_status check_path(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  const int strokes = d->blocks == 0 && d->increments == 0 && d->slide == ARC_SLIDE_X;
  const double stroke = strokes ? 2 * half_increments(d, model) : 0;
  if (stroke > most_of_cycle) return refuse_path("stroke", most_of_cycle, stroke, error);
  for (int b = 0; b < d->blocks; b++) {
    const arc_loading *l = &d->loading[b];
    const double made = arc_loading_increments(d, model, l, NULL) - (l->count - 1);
    const double most = l->periodic ? most_of_cycle : most_of_history;
    if (made > most) return refuse_path("loading", most, made, error);
  }
  return ARC_OK;
}

arc_status arc_plane_check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  arc_status status = check_procedure(d, model, error);
  if (status == ARC_OK) status = arc_wear_check_revolved(d, model, error);
  if (status == ARC_OK) status = check_friction(d, model, error);
  if (status == ARC_OK) status = check_hole(d, model, error);
  for (int b = 0; b < d->blocks && status == ARC_OK; b++)
    status = check_turning(&d->loading[b], model, b + 1, error);
  return status == ARC_OK ? check_path(d, model, error) : status;
}

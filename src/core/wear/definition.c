/* Definitions of wear runs: defaults, checks, copies, choice of procedure, zones they need. */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* So many increments may be made for a cycle, all of which every update takes, and for a history
 * that goes by once. */
static const double most_of_cycle = 1e5, most_of_history = 1e6;

const char *const arc_procedure_names[] = {ARC_PROCEDURE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_scheme_names[] = {ARC_SCHEME_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_slide_names[] = {ARC_SLIDE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_slip_names[] = {ARC_SLIP_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_rule_names[] = {ARC_RULE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_update_names[] = {ARC_UPDATE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_law_names[] = {ARC_LAW_LIST(ARC_CHOICE_NAME) NULL};
#define LAW_PROPERTIES(name, text, properties, ...) properties,
const unsigned arc_law_properties[] = {ARC_LAW_LIST(LAW_PROPERTIES)};

/* Choices that are decided by comparison: a new one would quietly run as an old one. Whoever adds
 * one decides it in the places named, then counts it here. (Laws are formulas in their list.) */
#define DECIDED(LIST, count, where)                                                                \
  _Static_assert(0 LIST(ARC_CHOICE_ONE) == (count), "a new choice: decide it in " where)
DECIDED(ARC_PROCEDURE_LIST, 3, "definition.c, block.c, update.c, rate.c");
DECIDED(ARC_SCHEME_LIST, 2, "plan.c, step.c, update.c");
DECIDED(ARC_SLIP_LIST, 2, "rate.c");
DECIDED(ARC_RULE_LIST, 2, "rate.c");
DECIDED(ARC_UPDATE_LIST, 2, "block.c, update.c");
DECIDED(ARC_GEOMETRY_LIST, 2, "contact/shape.c, contact/mortar.c");

#define ARC_SETTING_OF arc_wear_def
const arc_setting arc_wear_settings[] = {
    ARC_WEAR_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_WHOLE, ARC_SETTING_CHOICE,
                      ARC_SETTING_QUANTITY, ARC_SETTING_FUNCTION, ARC_SETTING_OTHER){.name = NULL},
};
#undef ARC_SETTING_OF

arc_wear_def arc_wear_default(void) {
  arc_wear_def def = {0};
  arc_settings_default(arc_wear_settings, &def);
  return def;
}

/* What turns in a hole would change its fit by wearing all round, and what is not flat does not
 * wear alike. */
int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model) {
  if (arc_model_is_hole(model) || !arc_model_slides_along(model)) return 0;
  return def->blocks == 0 && def->slide == ARC_SLIDE_X &&
         fabs(def->stroke - arc_model_width(model)) <= 1e-9 * model->radius;
}

double arc_wear_def_stroke(const arc_wear_def *def) {
  return def->track > 0 ? acos(-1) * def->track : def->stroke;
}

/* As many in a stroke as follow the contact. */
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

int arc_wear_rubs(const arc_wear_def *def) {
  return def->friction > 0 || def->friction_function || def->friction_series.count > 0;
}

double arc_wear_def_sliding(const arc_wear_def *def, const arc_model_def *model) {
  if (!(def->tangential > 0)) return arc_wear_def_strokes(def, model) * arc_wear_def_stroke(def);
  return 4 * def->tangential / model->thickness /
         arc_contact_modulus(model->geometry, model->material);
}

int arc_wear_alpha_stays_one(const arc_wear_def *def) {
  return def->alpha == 1 && !def->alpha_function && def->alpha_series.count == 0;
}

arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model) {
  if (def->procedure != ARC_AUTO) return def->procedure;
  if (arc_wear_over_plate(def, model) || def->track > 0) return ARC_NSP;
  if (arc_wear_rubs(def) || !arc_model_slides_along(model)) return ARC_SP;
  return arc_wear_alpha_stays_one(def) ? ARC_NSP : ARC_SP;
}

void arc_wear_def_partition(arc_wear_def *def, const double k[ARC_BODIES]) {
  def->k = k[ARC_CYLINDER] + k[ARC_PLATE];
  if (def->k > 0) def->alpha = k[ARC_CYLINDER] / def->k;
  def->k_function = def->alpha_function = NULL;
  def->k_series = def->alpha_series = (arc_series){0};
}

int arc_wear_def_of_bodies(arc_wear_def *def, const arc_model_def *model) {
  const double k[ARC_BODIES] = {arc_model_wear_k(model, ARC_CYLINDER),
                                arc_model_wear_k(model, ARC_PLATE)};
  const int have = k[ARC_CYLINDER] > 0 || k[ARC_PLATE] > 0;
  if (have) arc_wear_def_partition(def, k);
  return have;
}

/* --- checks --- */

/* Degrees, of which only holes know. */
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
                  "field 'loading[%d].%s': expected a pair with a ring, in or around which a body "
                  "turns",
                  number, name);
}

static arc_status check_turning(const arc_loading *l, const arc_model_def *model, int number,
                                arc_error *error) {
  arc_status status = check_degrees(l, l->rotation, "rotation", 36000, model, number, error);
  if (status == ARC_OK)
    status = check_degrees(l, l->load_angle, "load_angle", 90, model, number, error);
  return status;
}

static arc_status check_points(const arc_loading *l, int number, arc_error *error) {
  for (int i = 0; i < l->count; i++) {
    if (!isfinite(l->x[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'loading[%d].x[%d]': expected a finite position in mm, got %g", number,
                      i + 1, l->x[i]);
    if (!(l->load[i] >= 0) || !isfinite(l->load[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'loading[%d].load[%d]': expected a number > 0 N, or 0 for a lift-off, "
                      "got %g",
                      number, i + 1, l->load[i]);
  }
  return ARC_OK;
}

/* Whether values come back to the first, but for rounding. */
static int closes(int count, const double *value) {
  double most = 0;
  for (int i = 0; i < count; i++) most = fmax(most, fabs(value[i]));
  return fabs(value[count - 1] - value[0]) <= 1e-9 * most;
}

/* Whether the coefficient of friction is one number, all the time. */
static int friction_is_known(const arc_wear_def *d) {
  return !d->friction_function && d->friction_series.count == 0;
}

/* Tangential force that is refused [N]: more will be told of on the way. */
static double carried(const arc_wear_def *d, double load) {
  if (friction_is_known(d)) return d->friction * load;
  return load > 0 ? INFINITY : 0;
}

/* More than friction carries, where that is known; and a cycle that does not come back. */
static arc_status check_rubbing(const arc_wear_def *d, const arc_loading *l, int number,
                                arc_error *error) {
  const int last = l->count - 1;
  for (int i = 0; i < l->count && l->tangential; i++) {
    if (!isfinite(l->tangential[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'loading[%d].tangential[%d]': expected a finite force in N, got %g",
                      number, i + 1, l->tangential[i]);
    if (fabs(l->tangential[i]) >= carried(d, l->load[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'loading[%d].tangential[%d]': expected less than friction times the "
                      "load, %g N, got %g N",
                      number, i + 1, carried(d, l->load[i]), l->tangential[i]);
  }
  if (!l->periodic)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].periodic': with friction expected a cycle: what counts is "
                    "its steady state",
                    number);
  const double *drive = l->tangential ? l->tangential : l->x;
  if (closes(l->count, drive) && closes(l->count, l->load)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'loading[%d]': with friction expected a cycle that ends where it begins, "
                  "got %s = %g and %g %s, load = %g and %g N",
                  number, l->tangential ? "tangential" : "x", drive[0], drive[last],
                  l->tangential ? "N" : "mm", l->load[0], l->load[last]);
}

static arc_status check_block(const arc_wear_def *d, const arc_model_def *model, int number,
                              arc_error *error) {
  const arc_loading *l = &d->loading[number - 1];
  const int last = number == d->blocks;
  double sliding = 0;
  if (l->count < 2)
    return arc_fail(error, ARC_ARGUMENT, "field 'loading[%d]': expected at least 2 points, got %d",
                    number, l->count);
  arc_status status = check_points(l, number, error);
  if (status == ARC_OK) status = check_turning(l, model, number, error);
  if (status != ARC_OK) return status;
  const double *drive = l->tangential ? l->tangential : l->rotation ? l->rotation : l->x;
  for (int i = 1; i < l->count; i++) sliding += fabs(drive[i] - drive[i - 1]);
  if (l->tangential && !arc_wear_rubs(d))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].tangential': a force drives the plate by friction only; "
                    "give friction",
                    number);
  if (!(sliding > 0) && l->tangential)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].tangential': expected a force that changes, got %g N all "
                    "the time",
                    number, l->tangential[0]);
  if (!isfinite(sliding))
    return arc_fail(error, ARC_ARGUMENT, "field 'loading[%d].%s': expected a finite way, got %g %s",
                    number, l->rotation ? "rotation" : "x", sliding,
                    l->rotation ? "degrees" : "mm");
  if (!(sliding > 0))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].%s': expected a plate that moves, got %g %s all the time",
                    number, l->rotation ? "rotation" : "x", drive[0],
                    l->rotation ? "degrees" : "mm");
  if (!(l->cycles > 0) || (!last && !isfinite(l->cycles)))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].cycles': expected a number > 0%s, got %g", number,
                    last ? "" : " and finite (only the last block may go on)", l->cycles);
  if (!l->periodic && l->cycles != 1)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'loading[%d].cycles': expected 1 for a history that is not periodic, got "
        "%g",
        number, l->cycles);
  return ARC_OK;
}

static arc_status check_loading(const arc_wear_def *d, const arc_model_def *model,
                                arc_error *error) {
  for (int b = 0; b < d->blocks; b++) {
    arc_status status = check_block(d, model, b + 1, error);
    if (status == ARC_OK && arc_wear_rubs(d))
      status = check_rubbing(d, &d->loading[b], b + 1, error);
    if (status != ARC_OK) return status;
  }
  if (d->distance == 0 && !(d->blocks > 0 && isfinite(d->loading[d->blocks - 1].cycles)))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'distance': expected a number > 0 mm, needed where no block of loading "
                    "ends the run, got 0");
  return ARC_OK;
}

static arc_status check_scheme(const arc_wear_def *d, arc_error *error) {
  if (d->tolerance > 0 && d->scheme != ARC_IMPLICIT)
    return arc_fail(error, ARC_ARGUMENT, "field 'tolerance': needs scheme = \"implicit\"");
  if (d->tolerance > 0 && (arc_law_properties[d->law] & ARC_LAW_JUMPS))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'tolerance': no step is short enough for law = \"%s\", which jumps; use "
                    "scheme = \"explicit\" with jump = \"auto\"",
                    arc_law_names[d->law]);
  if (d->jump_auto && d->scheme == ARC_IMPLICIT)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'jump': \"auto\" is for scheme = \"explicit\"; give the implicit scheme "
                    "a tolerance");
  return ARC_OK;
}

static arc_status check_procedure(const arc_wear_def *d, const arc_model_def *model,
                                  arc_error *error) {
  const double width = arc_model_width(model);
  if (d->blocks == 0 && d->slide == ARC_SLIDE_X && d->stroke > width * (1 + 1e-9))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'stroke': expected at most the plate's width 2 radius = %g mm, got %g mm", width,
        d->stroke);
  const double widest = 0.75 * width; /* the mesher's widest zone less a contact */
  if (d->slide == ARC_SLIDE_Z && d->slip == ARC_SLIP_TOTAL)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'slip': total slip is that along x, slide = \"z\" needs slip = \"rigid\"");
  if (d->blocks == 0 && d->slide == ARC_SLIDE_X && d->stroke > widest &&
      arc_wear_choose_procedure(d, model) == ARC_SP)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'stroke': a sliding plate (SP) takes at most 1.5 radius = %g mm, got %g mm; 2 "
        "radius = %g mm is the half-reciprocating stroke over the whole plate (NSP)",
        widest, d->stroke, width);
  const int flat = arc_wear_alpha_stays_one(d) || d->track > 0 || arc_wear_over_plate(d, model);
  if (d->procedure == ARC_NSP && !flat)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'procedure': NSP needs a plate that stays flat, alpha = 1 or stroke = 2 "
                    "radius = %g mm; "
                    "got alpha = %g, stroke = %g mm",
                    width, d->alpha, d->stroke);
  return ARC_OK;
}

static arc_status refuse_with_friction(const char *field, const char *why, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': with friction %s", field, why);
}

/* What stands on slip that is known beforehand, or on a state that outlives an update. */
static arc_status check_friction(const arc_wear_def *d, const arc_model_def *model,
                                 arc_error *error) {
  if (!arc_wear_rubs(d) && d->tangential > 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'tangential': a force drives the plate by friction only; give friction");
  if (!arc_wear_rubs(d) && (arc_law_properties[d->law] & ARC_LAW_OF_SHEAR))
    return arc_fail(error, ARC_ARGUMENT, "field 'law': \"%s\" is that of friction; give friction",
                    arc_law_names[d->law]);
  if (!arc_wear_rubs(d)) return ARC_OK;
  if (d->procedure == ARC_NSP && !arc_wear_over_plate(d, model))
    return refuse_with_friction("procedure", "expected \"SP\": slip needs the way of the plate",
                                error);
  if (d->update == ARC_UPDATE_INCREMENT)
    return refuse_with_friction(
        "update", "expected \"cycle\": updates within a cycle cause slip of their own", error);
  if (d->slide == ARC_SLIDE_Z)
    return refuse_with_friction("slide", "expected \"x\": its slip is that in the plane", error);
  if (d->slip == ARC_SLIP_TOTAL)
    return refuse_with_friction("slip", "expected \"rigid\": slip is found point by point anyway",
                                error);
  if (friction_is_known(d) && d->blocks == 0 && d->tangential >= d->friction * d->load)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'tangential': expected less than friction times the load, %g N, got %g "
                    "N",
                    d->friction * d->load, d->tangential);
  return ARC_OK;
}

static arc_status check_hole(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  const int hole = arc_model_is_hole(model);
  if (d->load_angle != 0 && !hole)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'load_angle': expected 0 but in a hole, got %g degrees", d->load_angle);
  if (hole && arc_wear_rubs(d))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'friction': expected 0 in a hole, where shear carries load too");
  return ARC_OK;
}

/* Where a changed run began anew. */
static arc_status check_start(const arc_wear_def *d, arc_error *error) {
  if (d->start_distance >= 0 && isfinite(d->start_distance) && d->start_cycle >= 0 &&
      isfinite(d->start_cycle))
    return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "fields 'start_distance' and 'start_cycle': expected numbers >= 0, got %g mm and "
                  "%g cycles",
                  d->start_distance, d->start_cycle);
}

static arc_status refuse_way(const char *field, double most, double got, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%s': expected a way of at most %g increments, each an eighth of the "
                  "contact's half width, got %g; give increments, or a shorter way",
                  field, most, got);
}

/* Points of a loading that the user gave are as many as they are. */
static arc_status check_way(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  const int strokes = d->blocks == 0 && d->increments == 0 && d->slide == ARC_SLIDE_X;
  const double stroke = strokes ? 2 * half_increments(d, model) : 0;
  if (stroke > most_of_cycle) return refuse_way("stroke", most_of_cycle, stroke, error);
  for (int b = 0; b < d->blocks; b++) {
    const arc_loading *l = &d->loading[b];
    const double made = arc_loading_increments(d, model, l, NULL) - (l->count - 1);
    const double most = l->periodic ? most_of_cycle : most_of_history;
    if (made > most) return refuse_way("loading", most, made, error);
  }
  return ARC_OK;
}

arc_status arc_wear_check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  arc_status status = arc_settings_check(arc_wear_settings, "", d, error);
  if (status == ARC_OK) status = check_start(d, error);
  if (status == ARC_OK) status = check_procedure(d, model, error);
  if (status == ARC_OK) status = arc_wear_check_revolved(d, model, error);
  if (status == ARC_OK) status = check_scheme(d, error);
  if (status == ARC_OK) status = check_friction(d, model, error);
  if (status == ARC_OK) status = check_hole(d, model, error);
  if (status == ARC_OK) status = check_loading(d, model, error);
  return status == ARC_OK ? check_way(d, model, error) : status;
}

/* --- copies --- */

/* x, load and what else there is of a block as one piece of memory. */
static arc_status copy_points(const arc_loading *from, arc_loading *to) {
  enum { lists = 5 };
  const double **list[lists] = {&to->x, &to->load, &to->tangential, &to->rotation, &to->load_angle};
  const size_t n = (size_t)from->count;
  double *points = malloc(lists * n * sizeof *points);
  *to = *from;
  if (!points) return ARC_MEMORY;
  for (int i = 0; i < lists; i++)
    if (*list[i]) *list[i] = memcpy(points + (size_t)i * n, *list[i], n * sizeof *points);
  return ARC_OK;
}

/* Two arrays of n doubles as one block, given back as the first. */
static double *copy_pair(int n, const double *first, const double *second) {
  double *block = malloc(2 * (size_t)n * sizeof *block);
  if (!block) return NULL;
  memcpy(block, first, (size_t)n * sizeof *block);
  memcpy(block + n, second, (size_t)n * sizeof *block);
  return block;
}

static arc_series *series_of(const arc_setting *s, arc_wear_def *def) {
  return (arc_series *)(void *)((char *)def + s->series);
}

/* Own copies of all series; those that could not be made are empty. */
static arc_status copy_series(arc_wear_def *def) {
  arc_status status = ARC_OK;
  for (const arc_setting *s = arc_wear_settings; s->name; s++) {
    const arc_series from = arc_setting_series(s, def);
    if (from.count == 0) continue;
    double *block = copy_pair(from.count, from.distance, from.value);
    if (!block) status = ARC_MEMORY;
    *series_of(s, def) =
        block ? (arc_series){from.count, block, block + from.count} : (arc_series){0};
  }
  return status;
}

static arc_status copy_loading(const arc_wear_def *def, arc_wear_def *copy) {
  copy->loading = NULL;
  copy->blocks = 0;
  if (def->blocks == 0) return ARC_OK;
  arc_loading *blocks = malloc((size_t)def->blocks * sizeof *blocks);
  if (!blocks) return ARC_MEMORY;
  copy->loading = blocks;
  for (int b = 0; b < def->blocks; b++) {
    if (copy_points(&def->loading[b], &blocks[b]) != ARC_OK) return ARC_MEMORY;
    copy->blocks++;
  }
  return ARC_OK;
}

arc_status arc_wear_def_copy(const arc_wear_def *def, arc_wear_def *copy) {
  *copy = *def;
  const arc_status series = copy_series(copy), loading = copy_loading(def, copy);
  if (series == ARC_OK && loading == ARC_OK) return ARC_OK;
  arc_wear_def_free(copy);
  return ARC_MEMORY;
}

void arc_wear_def_free(arc_wear_def *def) {
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (arc_setting_series(s, def).count > 0) free((void *)(size_t)series_of(s, def)->distance);
  for (int b = 0; b < def->blocks; b++) free((void *)(size_t)def->loading[b].x);
  free((void *)(size_t)def->loading);
  *def = (arc_wear_def){0};
}

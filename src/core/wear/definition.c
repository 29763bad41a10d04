/* Sets the defaults of definitions of wear runs, and checks and copies definitions. */
#include "core/wear/run.h"
#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const arc_procedure_names[] = {ARC_PROCEDURE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_scheme_names[] = {ARC_SCHEME_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_slide_names[] = {ARC_SLIDE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_slip_names[] = {ARC_SLIP_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_rule_names[] = {ARC_RULE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_update_names[] = {ARC_UPDATE_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_law_names[] = {ARC_LAW_LIST(ARC_CHOICE_NAME) NULL};
#define LAW_PROPERTIES(name, text, properties, ...) properties,
const unsigned arc_law_properties[] = {ARC_LAW_LIST(LAW_PROPERTIES)};

/* Numbers of choices that the code distinguishes by comparisons. A choice that is added to a list
 * must be handled in the files named here, because otherwise the code treats it like another
 * choice. After that, increase the number here. Laws need no such check, because they are formulas
 * in a list. */
#define DECIDED(LIST, count, where)                                                                \
  _Static_assert(0 LIST(ARC_CHOICE_ONE) == (count), "a new choice: handle it in " where)
DECIDED(ARC_PROCEDURE_LIST, 3, "plane/plane_definition.c, wear/run.h");
DECIDED(ARC_SCHEME_LIST, 2, "wear/step_length.c, step.c, update.c");
DECIDED(ARC_SLIP_LIST, 2, "plane/rate.c");
DECIDED(ARC_RULE_LIST, 2, "plane/rate.c");
DECIDED(ARC_UPDATE_LIST, 2, "wear/block.c, run.h");
DECIDED(ARC_GEOMETRY_LIST, 2, "contact/shape.c, contact/mortar.c");
DECIDED(ARC_CORRECTIONS_LIST, 2, "contact/shape.h");

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

int arc_wear_has_friction(const arc_wear_def *def) {
  return def->friction > 0 || !arc_wear_friction_is_known(def);
}

int arc_wear_friction_is_known(const arc_wear_def *def) {
  return !def->friction_function && def->friction_series.count == 0;
}

int arc_wear_alpha_stays_one(const arc_wear_def *def) {
  return def->alpha == 1 && !def->alpha_function && def->alpha_series.count == 0;
}

int arc_wear_jump_is_auto(const arc_wear_def *def) {
  return def->jump == 0 && !def->jump_function;
}

void arc_wear_def_usual(arc_wear_def *def, const arc_model_def *model) {
  const arc_kind *kind = arc_kind_of(model->geometry);
  const int jumps = arc_law_properties[def->law] & ARC_LAW_JUMPS;
  if (!kind->prefers_implicit) return;
  if (def->tolerance == 0 && (jumps || !kind->prefers_implicit(def))) return;
  def->scheme = ARC_IMPLICIT;
  if (def->tolerance == 0) def->tolerance = ARC_USUAL_TOLERANCE;
}

void arc_wear_def_partition(arc_wear_def *def, const double k[ARC_BODIES]) {
  def->k = k[ARC_CYLINDER] + k[ARC_PLATE];
  if (def->k > 0) def->alpha = k[ARC_CYLINDER] / def->k;
  def->k_function = def->alpha_function = NULL;
  def->k_series = def->alpha_series = (arc_series){0};
}

/* --- checks ----------------------------------------------------------------------------------- */

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

/* Returns true if the last value equals the first within rounding errors. */
static int closes(int count, const double *value) {
  double most = 0;
  for (int i = 0; i < count; i++) most = fmax(most, fabs(value[i]));
  return fabs(value[count - 1] - value[0]) <= 1e-9 * most;
}

/* Returns the tangential force [N] that would cause gross slip under a load [N]; forces must be
 * smaller. If friction is a table or a function, returns INFINITY (0 without load), because the run
 * checks the force. */
static double carried(const arc_wear_def *d, double load) {
  if (arc_wear_friction_is_known(d)) return d->friction * load;
  return load > 0 ? INFINITY : 0;
}

/* Rejects a force that reaches friction times load (if the friction coefficient is constant), and a
 * cycle that does not end where it begins. */
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
                    "field 'loading[%d].periodic': with friction expected true, because the "
                    "periodic state of the cycle is used",
                    number);
  const double *drive = l->tangential ? l->tangential : l->x;
  if (closes(l->count, drive) && closes(l->count, l->load)) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'loading[%d]': with friction expected a cycle that ends where it begins, "
      "got %s, which changes by %g %s from its first to its last value, and a load that "
      "changes by %g N",
      number, l->tangential ? "tangential" : "x", drive[last] - drive[0],
      l->tangential ? "N" : "mm", l->load[last] - l->load[0]);
}

/* Returns true if the load of a loading changes, which causes slip between bodies of different
 * materials. */
static int breathes(const arc_loading *l) {
  for (int i = 1; l->load && i < l->count; i++)
    if (l->load[i] != l->load[0]) return 1;
  return 0;
}

static arc_status check_block(const arc_wear_def *d, int number, arc_error *error) {
  const arc_loading *l = &d->loading[number - 1];
  const int last = number == d->blocks;
  double sliding = 0;
  if (l->count < 2)
    return arc_fail(error, ARC_ARGUMENT, "field 'loading[%d]': expected at least 2 points, got %d",
                    number, l->count);
  arc_status status = check_points(l, number, error);
  if (status != ARC_OK) return status;
  const double *drive = l->tangential ? l->tangential : l->rotation ? l->rotation : l->x;
  for (int i = 1; i < l->count; i++) sliding += fabs(drive[i] - drive[i - 1]);
  if (l->tangential && !arc_wear_has_friction(d))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].tangential': a force drives the plate only through "
                    "friction; set friction",
                    number);
  if (!(sliding > 0) && l->tangential && !breathes(l))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'loading[%d].tangential': expected a force or a load that changes, got a "
        "constant %g N",
        number, l->tangential[0]);
  if (!isfinite(sliding))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].%s': expected a finite path, got %g %s", number,
                    l->rotation ? "rotation" : "x", sliding, l->rotation ? "degrees" : "mm");
  if (!(sliding > 0) && !l->tangential)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].%s': expected a plate that moves, got a constant %g %s",
                    number, l->rotation ? "rotation" : "x", drive[0],
                    l->rotation ? "degrees" : "mm");
  if (!(l->cycles > 0) || (!last && !isfinite(l->cycles)))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'loading[%d].cycles': expected a number > 0%s, got %g", number,
                    last ? "" : " and finite (only the last block may be without end)", l->cycles);
  if (!l->periodic && l->cycles != 1)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'loading[%d].cycles': expected 1 for a history that is not periodic, got "
        "%g",
        number, l->cycles);
  return ARC_OK;
}

static arc_status check_loading(const arc_wear_def *d, arc_error *error) {
  for (int b = 0; b < d->blocks; b++) {
    arc_status status = check_block(d, b + 1, error);
    if (status == ARC_OK && arc_wear_has_friction(d))
      status = check_rubbing(d, &d->loading[b], b + 1, error);
    if (status != ARC_OK) return status;
  }
  if (d->distance == 0 && !(d->blocks > 0 && isfinite(d->loading[d->blocks - 1].cycles)))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'distance': expected a number > 0 mm, needed unless a block of loading "
                    "ends the run, got 0");
  return ARC_OK;
}

static arc_status check_scheme(const arc_wear_def *d, arc_error *error) {
  if (d->tolerance > 0 && d->scheme != ARC_IMPLICIT)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'tolerance': needs implicit steps: set scheme = \"implicit\", and no jump");
  if (d->tolerance > 0 && (arc_law_properties[d->law] & ARC_LAW_JUMPS))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'tolerance': no step is short enough for law = \"%s\", which is "
        "discontinuous; omit tolerance, or use scheme = \"explicit\" with jump = \"auto\"",
        arc_law_names[d->law]);
  if (d->scheme == ARC_IMPLICIT && d->tolerance == 0 && arc_wear_jump_is_auto(d))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'tolerance': expected a number > 0, because implicit steps with jump = "
                    "\"auto\" need it");
  return ARC_OK;
}

static arc_status refuse_with_friction(const char *field, const char *why, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': with friction %s", field, why);
}

/* Rejects settings that need friction if there is none, and settings that are not allowed with
 * friction. */
static arc_status check_friction(const arc_wear_def *d, arc_error *error) {
  if (!arc_wear_has_friction(d) && d->tangential > 0)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'tangential': a force drives the plate only through friction; set friction");
  if (!arc_wear_has_friction(d) && (arc_law_properties[d->law] & ARC_LAW_OF_SHEAR))
    return arc_fail(error, ARC_ARGUMENT, "field 'law': \"%s\" needs friction; set friction",
                    arc_law_names[d->law]);
  if (!arc_wear_has_friction(d)) return ARC_OK;
  if (d->update == ARC_UPDATE_INCREMENT)
    return refuse_with_friction(
        "update", "expected \"cycle\": an update within a cycle would itself cause slip", error);
  if (d->slip == ARC_SLIP_TOTAL)
    return refuse_with_friction(
        "slip", "expected \"rigid\": friction already includes the slip of each point", error);
  if (arc_wear_friction_is_known(d) && d->blocks == 0 && d->tangential >= d->friction * d->load)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'tangential': expected less than friction times the load, %g N, got %g "
                    "N",
                    d->friction * d->load, d->tangential);
  return ARC_OK;
}

/* Checks the distance and the cycle at which the loading of a changed run starts. */
static arc_status check_start(const arc_wear_def *d, arc_error *error) {
  if (d->start_distance >= 0 && isfinite(d->start_distance) && d->start_cycle >= 0 &&
      isfinite(d->start_cycle))
    return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "fields 'start_distance' and 'start_cycle': expected numbers >= 0, got %g mm and "
                  "%g cycles",
                  d->start_distance, d->start_cycle);
}

arc_status arc_wear_check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  arc_status status = arc_settings_check(arc_wear_settings, "", d, error);
  if (status == ARC_OK) status = check_start(d, error);
  if (status == ARC_OK) status = check_scheme(d, error);
  if (status == ARC_OK) status = check_friction(d, error);
  if (status == ARC_OK) status = check_loading(d, error);
  return status == ARC_OK ? arc_kind_of(model->geometry)->check(d, model, error) : status;
}

/* --- copies ----------------------------------------------------------------------------------- */

/* Copies x, load and the other arrays of a loading to one block of memory. */
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

/* Copies two arrays of n doubles to one block of memory. Returns the block, which starts with the
 * first copy; NULL if out of memory. */
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

/* Replaces all tables of a definition by copies. A table that cannot be copied becomes empty.
 * Error: ARC_MEMORY. */
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
    if (arc_setting_series(s, def).count > 0) arc_memory_release(series_of(s, def)->distance);
  for (int b = 0; b < def->blocks; b++) arc_memory_release(def->loading[b].x);
  arc_memory_release(def->loading);
  *def = (arc_wear_def){0};
}

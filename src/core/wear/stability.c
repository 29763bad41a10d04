/* Stability of explicit updates: how fast ripples grow, and a warning before they do. */
#include "core/base/callbacks.h"
#include "core/base/dense.h"
#include "core/wear/step.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static double normalise(int n, double *v) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += v[i] * v[i];
  const double length = sqrt(sum);
  for (int i = 0; i < n && length > 0; i++) v[i] /= length;
  return length;
}

/* Largest eigenvalue of diag(k) J by power iteration. */
double arc_wear_eigenvalue(const arc_wear *w, const double k_both[ARC_BODIES],
                           const double *jacobian, double *work) {
  /* even wear feels nothing */
  const double k[ARC_BODIES] = {k_both[ARC_CYLINDER],
                                w->procedure == ARC_NSP ? 0 : k_both[ARC_PLATE]};
  const int n = w->nc + w->np;
  double *v = work, *image = work + n, value = 0;
  /* a sawtooth with a slant: neither symmetric nor antisymmetric, the same every time */
  for (int i = 0; i < n; i++) v[i] = (i % 2 ? 1.0 : -1.0) * (1 + (double)i / n);
  for (int it = 0; it < 1000; it++) {
    const double before = value;
    if (normalise(n, v) == 0) return 0;
    arc_dense_multiply(n, 1, n, 1, jacobian, n, v, n, 0, image, n);
    value = 0;
    for (int i = 0; i < n; i++) {
      v[i] = k[i < w->nc ? ARC_CYLINDER : ARC_PLATE] * image[i];
      value += v[i] * v[i];
    }
    value = sqrt(value);
    if (value == 0 || fabs(value - before) < 1e-6 * value) break;
  }
  return value;
}

/* Of a cycle of a block on the present surfaces, at these coefficients. */
static arc_status find_eigenvalue(arc_wear *w, const wear_block *block, const double k[ARC_BODIES],
                                  const arc_callbacks *callbacks, double *eigenvalue,
                                  arc_error *error) {
  *eigenvalue = 0;
  if (k[ARC_CYLINDER] == 0 && k[ARC_PLATE] == 0) return ARC_OK;
  arc_status status = arc_path_enter(&w->path, block, w->model, error);
  if (status != ARC_OK) return status;
  const size_t n = (size_t)(w->nc + w->np);
  wear_jacobian jacobian = {0};
  double *work = malloc(2 * n * sizeof *work);
  if (!work || arc_wear_jacobian_create(&jacobian, w->nc, w->np) != ARC_OK) {
    free(work);
    return arc_fail(error, ARC_MEMORY, "out of memory for the stability limit");
  }
  wear_window cycle = {.shape = w->shape,
                       .last = block->count - 1,
                       .state = arc_wear_last(w),
                       .jacobian = &jacobian};
  wear_watch watch = {.callbacks = callbacks};
  status = arc_wear_friction(w, cycle.state, &cycle.mu, error);
  if (status == ARC_OK) status = arc_wear_evaluate(w, &cycle, &watch, &w->work.rate, error);
  if (status == ARC_OK) *eigenvalue = arc_wear_eigenvalue(w, k, jacobian.value, work);
  arc_wear_jacobian_free(&jacobian);
  free(work);
  return status;
}

arc_status arc_wear_stability(arc_wear *w, const arc_callbacks *callbacks, double *eigenvalue,
                              arc_error *error) {
  const wear_block *block = arc_wear_block_at(w, arc_wear_last(w)->cycle);
  double k[ARC_BODIES];
  const arc_status status = arc_wear_coefficients_now(w, k, error);
  return status == ARC_OK ? find_eigenvalue(w, block, k, callbacks, eigenvalue, error) : status;
}

/* --- warnings --- */

/* Explicit jumps that the user chose, of whole cycles. */
static int may_ripple(const arc_wear *w, const wear_block *block) {
  return w->def.scheme == ARC_EXPLICIT && !w->def.jump_auto && block->periodic;
}

/* What the eigenvalue may have become at most: it is linear in the coefficients together. */
static double eigenvalue_at_most(const wear_judged *j, const double k[ARC_BODIES]) {
  static const double noticed = 1.01;
  double growth = 1;
  for (int b = 0; b < ARC_BODIES; b++) {
    if (j->k[b] == 0 && k[b] > 0) return INFINITY;
    if (k[b] > noticed * j->k[b]) growth = fmax(growth, k[b] / j->k[b]);
  }
  return growth * j->eigenvalue;
}

/* Whether an update of so many cycles calls for another look: it costs a cycle of solutions. */
static int may_be_past(const arc_wear *w, const wear_block *block, const double k[ARC_BODIES],
                       double cycles) {
  static const double fallen = 0.8;
  const wear_judged *j = &w->judged;
  if (j->block != block) return 1;
  if ((!(arc_law_properties[w->def.law] & ARC_LAW_LINEAR) || w->def.local_factor) &&
      arc_wear_last(w)->p_center < fallen * j->p_center)
    return 1; /* the coefficients may grow at other pressures */
  return cycles * eigenvalue_at_most(j, k) > 2;
}

/* An update past the limit: its ripples grow until the results mean nothing. Said once. */
static void judge(arc_wear *w, const wear_block *block, const double k[ARC_BODIES], double cycles,
                  const arc_callbacks *callbacks) {
  wear_judged *j = &w->judged;
  const arc_wear_record *now = arc_wear_last(w);
  if (!may_be_past(w, block, k, cycles)) return;
  if (find_eigenvalue(w, block, k, callbacks, &j->eigenvalue, NULL) != ARC_OK)
    return; /* the step will tell */
  j->block = block;
  j->p_center = now->p_center;
  for (int b = 0; b < ARC_BODIES; b++) j->k[b] = k[b];
  const double limit = 2 / j->eigenvalue;
  if (cycles <= limit) return;
  j->warned = 1;
  char where[60] = "";
  if (now->distance > 0) snprintf(where, sizeof where, " at distance %g mm", now->distance);
  arc_warn(callbacks,
           "jump = %g cycles is past the stability limit of %.*g%s: ripples will grow; use jump = "
           "\"auto\" or scheme = \"implicit\"",
           cycles, limit < 1 ? 2 : 6, limit < 1 ? limit : floor(limit), where);
}

static void warn_unstable(arc_wear *w, const arc_callbacks *callbacks) {
  const wear_block *block = arc_wear_block_at(w, arc_wear_last(w)->cycle);
  double k[ARC_BODIES];
  if (w->judged.block || w->def.jump_function || !may_ripple(w, block)) return;
  if (arc_wear_coefficients_now(w, k, NULL) == ARC_OK) judge(w, block, k, w->def.jump, callbacks);
}

void arc_wear_watch_ripples(arc_wear *w, const wear_block *block, const arc_callbacks *callbacks) {
  const arc_wear_record *now = arc_wear_last(w);
  const double k[ARC_BODIES] = {now->k * now->alpha, now->k * (1 - now->alpha)};
  if (!callbacks || !callbacks->warn || w->judged.warned || !may_ripple(w, block)) return;
  judge(w, block, k, now->jump, callbacks);
}

/* The longest increment, over what follows the contact well. */
static double longest_increment(const arc_wear *w) {
  const arc_wear_def *d = &w->def;
  contact_pair pair = arc_model_pair(arc_model_definition(w->model));
  double longest =
      d->blocks > 0 ? 0 : 2 * d->stroke / d->increments / arc_wear_reach_of(&pair, d->load);
  for (int b = 0; b < d->blocks; b++) {
    const arc_loading *from = &d->loading[b];
    const double least = arc_loading_least(from, pair.def);
    for (int i = 1; i < from->count; i++)
      longest = fmax(longest, arc_loading_length(&pair, from, least, i));
  }
  return longest;
}

/* Increments whose number is the user's, and that leap over parts of the contact's way. */
static void warn_leaps(const arc_wear *w, const arc_callbacks *callbacks) {
  static const double leap = 4; /* half the contact's half width */
  const arc_wear_def *d = &w->def;
  if (d->increments == 0 || d->tangential > 0 || w->procedure == ARC_NSP || d->slide == ARC_SLIDE_Z)
    return;
  const double longest = longest_increment(w);
  if (longest <= leap * (1 + 1e-9)) return;
  if (d->blocks > 0)
    arc_warn(
        callbacks,
        "an increment of the loading is longer than half the contact's half width, and the wear "
        "will be uneven; give %.0f times as many points, or increments = \"auto\"",
        ceil(longest));
  else
    arc_warn(
        callbacks,
        "increments = %d: each is longer than half the contact's half width, and the wear will "
        "be uneven; take %d, or \"auto\"",
        d->increments, 2 * (int)ceil(longest * d->increments / 2 * (1 - 1e-9)));
}

static void warn_of_friction(const arc_wear *w, const arc_callbacks *callbacks) {
  double mu;
  if (arc_wear_friction(w, arc_wear_last(w), &mu, NULL) == ARC_OK)
    arc_friction_warn(w->model, mu, "wear", callbacks);
}

void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks) {
  const arc_wear_record *last = arc_wear_last(w);
  if (!callbacks || !callbacks->warn || last->distance >= w->def.distance) return;
  if (!w->warned && last->update == 0)
    arc_model_warn(w->model, w->def.load, last->half_width, callbacks);
  if (!w->warned) warn_leaps(w, callbacks);
  if (!w->warned && last->update == 0) warn_of_friction(w, callbacks);
  warn_unstable(w, callbacks);
  w->warned = 1;
}

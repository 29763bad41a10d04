/* Stability of explicit updates: how fast ripples grow, and a warning before they do. */
#include "core/base/callbacks.h"
#include "core/base/dense.h"
#include "core/wear/step.h"

#include <math.h>
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

arc_status arc_wear_stability(arc_wear *w, double *eigenvalue, arc_error *error) {
  const arc_wear_record *now = arc_wear_last(w);
  const wear_block *block = arc_wear_block_at(w, now->cycle);
  double k[ARC_BODIES];
  *eigenvalue = 0;
  arc_status status = arc_path_enter(&w->path, block, w->model, error);
  if (status == ARC_OK) status = arc_wear_coefficients_now(w, k, error);
  if (status != ARC_OK) return status;
  if (k[ARC_CYLINDER] == 0 && k[ARC_PLATE] == 0) return ARC_OK;
  const size_t n = (size_t)(w->nc + w->np);
  wear_jacobian jacobian = {0};
  double *work = malloc(2 * n * sizeof *work);
  if (!work || arc_wear_jacobian_create(&jacobian, w->nc, w->np) != ARC_OK) {
    free(work);
    return arc_fail(error, ARC_MEMORY, "out of memory for the stability limit");
  }
  const wear_window cycle = {
      .shape = w->shape, .last = block->count - 1, .state = now, .jacobian = &jacobian};
  wear_watch nobody = {0};
  status = arc_wear_evaluate(w, &cycle, &nobody, &w->work.rate, error);
  if (status == ARC_OK) *eigenvalue = arc_wear_eigenvalue(w, k, jacobian.value, work);
  arc_wear_jacobian_free(&jacobian);
  free(work);
  return status;
}

/* --- warnings --- */

/* Under constant coefficients it changes by a hundredth or two over a run. */
static int limit_varies(const arc_wear *w) {
  const arc_wear_def *d = &w->def;
  return d->k_function || d->alpha_function || d->k_series.count > 0 || d->alpha_series.count > 0 ||
         d->law != ARC_LAW_ARCHARD || d->local_factor || w->blocks > 1;
}

/* A fixed explicit jump past the limit: its ripples grow until the results mean nothing. */
static void warn_unstable(arc_wear *w, const arc_callbacks *callbacks) {
  const arc_wear_def *d = &w->def;
  double eigenvalue;
  if (d->scheme != ARC_EXPLICIT || d->jump_auto || d->jump_function) return;
  if (!arc_wear_block_at(w, arc_wear_last(w)->cycle)->periodic) return; /* one increment a step */
  if (arc_wear_stability(w, &eigenvalue, NULL) != ARC_OK) return;       /* the step will tell */
  const double limit = 2 / eigenvalue;
  if (d->jump <= limit) return;
  arc_warn(callbacks,
           "jump = %g cycles is past the stability limit of %.*g: ripples will grow; use jump = "
           "\"auto\" or scheme = \"implicit\"",
           d->jump, limit < 1 ? 2 : 6, limit < 1 ? limit : floor(limit));
}

/* The longest increment, over what follows the contact well. */
static double longest_increment(const arc_wear *w) {
  const arc_wear_def *d = &w->def;
  const arc_model_def *model = arc_model_definition(w->model);
  double longest =
      d->blocks > 0 ? 0 : 2 * d->stroke / d->increments / arc_wear_reach(model, d->load);
  for (int b = 0; b < d->blocks; b++)
    for (int i = 1; i < d->loading[b].count; i++)
      longest = fmax(longest, arc_loading_length(model, &d->loading[b], i));
  return longest;
}

/* Increments whose number is the user's, and that leap over parts of the contact's way. */
static void warn_leaps(const arc_wear *w, const arc_callbacks *callbacks) {
  static const double leap = 4; /* half the contact's half width */
  const arc_wear_def *d = &w->def;
  if (d->increments == 0 || w->procedure == ARC_NSP) return;
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

void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks) {
  const arc_wear_record *last = arc_wear_last(w);
  if (!callbacks || !callbacks->warn || last->distance >= w->def.distance) return;
  if (!w->warned && last->update == 0) arc_model_warn(w->model, last->half_width, callbacks);
  if (!w->warned) warn_leaps(w, callbacks);
  if (!w->warned || limit_varies(w)) warn_unstable(w, callbacks);
  w->warned = 1;
}

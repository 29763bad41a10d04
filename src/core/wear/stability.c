/* Computes the growth rate of ripples in explicit updates, and warns about unstable updates. */
#include "core/base/callbacks.h"
#include "core/pair/units.h"
#include "core/wear/step.h"

#include <math.h>
#include <stdio.h>

/* Computes the growth rate of ripples on the present surfaces in a cycle of a block, with the wear
 * coefficients k [mm2/N]. This rate is the largest eigenvalue [1/cycle]. */
static arc_status find_eigenvalue(arc_wear *w, const wear_block *block, const double k[ARC_BODIES],
                                  const arc_callbacks *callbacks, double *eigenvalue,
                                  arc_error *error) {
  *eigenvalue = 0;
  if (k[ARC_CYLINDER] == 0 && k[ARC_PLATE] == 0) return ARC_OK;
  wear_tangent *tangent = w->kind->tangent(w);
  if (!tangent) return arc_fail(error, ARC_MEMORY, "out of memory for the stability limit");
  wear_window cycle = {.block = block,
                       .shape = w->shape,
                       .last = block->count - 1,
                       .state = arc_wear_last(w),
                       .tangent = tangent};
  wear_progress progress = {.callbacks = callbacks};
  arc_status status = arc_wear_friction(w, cycle.state, &cycle.mu, error);
  if (status == ARC_OK) status = w->kind->rate(w, &cycle, &progress, &w->work.rate, error);
  if (status == ARC_OK) {
    *eigenvalue = w->kind->eigenvalue(w, k, tangent, callbacks);
    status = callbacks_check(callbacks, error);
  }
  w->kind->end_tangent(&tangent);
  return status;
}

arc_status arc_wear_stability(arc_wear *w, const arc_callbacks *callbacks, double *eigenvalue,
                              arc_error *error) {
  const wear_block *block = arc_wear_block_at(w, arc_wear_last(w)->cycle);
  double k[ARC_BODIES];
  const arc_status status = arc_wear_coefficients_now(w, k, error);
  return status == ARC_OK ? find_eigenvalue(w, block, k, callbacks, eigenvalue, error) : status;
}

/* --- warnings --------------------------------------------------------------------------------- */

/* Returns true if the run makes explicit updates of whole cycles whose length (jump) the user
 * chose. */
static int may_ripple(const arc_wear *w, const wear_block *block) {
  return w->def.scheme == ARC_EXPLICIT && !arc_wear_jump_is_auto(&w->def) &&
         !arc_wear_has_own_steps(w) && block->periodic;
}

/* Returns an upper bound of the present eigenvalue [1/cycle]: the last computed eigenvalue times
 * the growth of the wear coefficients, to which it is proportional. */
static double eigenvalue_at_most(const wear_judged *j, const double k[ARC_BODIES]) {
  static const double noticed = 1.01;
  double growth = 1;
  for (int b = 0; b < ARC_BODIES; b++) {
    if (j->k[b] == 0 && k[b] > 0) return INFINITY;
    if (k[b] > noticed * j->k[b]) growth = fmax(growth, k[b] / j->k[b]);
  }
  return growth * j->eigenvalue;
}

/* Returns true if an update of `cycles` may exceed the stability limit. The eigenvalue must then be
 * computed again, which requires the contact solutions of a cycle. */
static int may_be_past(const arc_wear *w, const wear_block *block, const double k[ARC_BODIES],
                       double cycles) {
  static const double fallen = 0.8;
  const wear_judged *j = &w->judged;
  if (j->block != block) return 1;
  if ((!(arc_law_properties[w->def.law] & ARC_LAW_LINEAR) || w->def.local_factor) &&
      arc_wear_last(w)->p_center < fallen * j->p_center)
    return 1; /* a law or a local factor may have larger values at other pressures */
  return cycles * eigenvalue_at_most(j, k) > 2;
}

/* Warns, once, that ripples grow because an update is longer than the stability limit. */
static void judge(arc_wear *w, const wear_block *block, const double k[ARC_BODIES], double cycles,
                  const arc_callbacks *callbacks) {
  wear_judged *j = &w->judged;
  const arc_wear_record *now = arc_wear_last(w);
  if (!may_be_past(w, block, k, cycles)) return;
  if (find_eigenvalue(w, block, k, callbacks, &j->eigenvalue, NULL) != ARC_OK)
    return; /* the step reports the error */
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

/* Largest accepted ripple: the difference between the pressure at a node and the mean of its
 * neighbours, divided by the mean pressure. In tests on elements of 20 and 10 um the ripple was
 * below 0.3 for steps of 0.9 times the stability limit, and above 1 for steps longer than the
 * limit. */
static const double most_ripple = 0.5;

arc_status arc_wear_refuse_ripples(arc_wear *w, const wear_plan *plan, const wear_outcome *out,
                                   const arc_callbacks *callbacks, arc_error *error) {
  double eigenvalue;
  if (plan->staged || !may_ripple(w, plan->block) || !w->kind->ripple) return ARC_OK;
  const double ripple = w->kind->ripple(w, out->shape, &out->record);
  if (!(ripple > most_ripple)) return ARC_OK;
  const arc_status status = arc_wear_stability(w, callbacks, &eigenvalue, error);
  if (status != ARC_OK || !(eigenvalue * plan->cycles > 2)) return status;
  return arc_fail(
      error, ARC_NOT_CONVERGED,
      "ripples: pressures of neighbouring nodes differ by %.0f %% of their mean, because "
      "updates of %.6g cycles are past the stability limit of %.4g; use jump = \"auto\", a "
      "shorter jump or scheme = \"implicit\"",
      100 * ripple, plan->cycles, 2 / eigenvalue);
}

static void warn_unstable(arc_wear *w, const arc_callbacks *callbacks) {
  const wear_block *block = arc_wear_block_at(w, arc_wear_last(w)->cycle);
  double k[ARC_BODIES];
  if (w->judged.block || w->def.jump_function || !may_ripple(w, block)) return;
  if (arc_wear_coefficients_now(w, k, NULL) == ARC_OK) judge(w, block, k, w->def.jump, callbacks);
}

void arc_wear_warn_of_ripples(arc_wear *w, const wear_block *block,
                              const arc_callbacks *callbacks) {
  const arc_wear_record *now = arc_wear_last(w);
  const double k[ARC_BODIES] = {now->k * now->alpha, now->k * (1 - now->alpha)};
  if (!callbacks || !callbacks->warn || w->judged.warned || !may_ripple(w, block)) return;
  judge(w, block, k, now->jump, callbacks);
}

/* Warns of values that suggest wrong units. The stroke is not checked with a loading (which
 * replaces it), for sliding along z (where it may be short), with friction (short strokes may
 * stick), and for conforming bodies (every stroke is short relative to the contact). */
static void warn_units(const arc_wear *w, const arc_callbacks *callbacks) {
  const arc_wear_record *now = arc_wear_last(w);
  const arc_model_def *model = arc_model_definition(w->model);
  const int fits = now->half_width > model->radius / 5;
  const int plain =
      w->def.blocks == 0 && w->def.slide == ARC_SLIDE_X && !fits && !arc_wear_has_friction(&w->def);
  arc_units_warn_pair(model, now->p_max, callbacks);
  arc_units_warn_friction(w->def.friction, callbacks);
  arc_units_warn_wear(now->k, plain ? w->def.stroke : 0, now->half_width, callbacks);
}

void arc_wear_warn(arc_wear *w, const arc_callbacks *callbacks) {
  const arc_wear_record *last = arc_wear_last(w);
  if (!callbacks || !callbacks->warn || last->distance >= w->def.distance) return;
  if (!w->warned && w->kind->warn) w->kind->warn(w, last->update == 0, callbacks);
  if (!w->warned && last->update == 0) warn_units(w, callbacks);
  warn_unstable(w, callbacks);
  w->warned = 1;
}

/* Computes the friction coefficient for the state of a run, and checks that friction can carry the
 * tangential force. */
#include "core/base/callbacks.h"
#include "core/wear/run.h"

#include <math.h>

/* Returns the index of the point of a block that needs the largest friction coefficient. Sets
 * *needed to this coefficient, which is infinite if a force acts at a load of 0. */
static int worst_point(const wear_block *b, double *needed) {
  int worst = 0;
  *needed = 0;
  for (int i = 0; i < b->count; i++) {
    const double force = fabs(b->tangential[i]), of = force > 0 ? force / b->line[i] : 0;
    if (of > *needed) *needed = of, worst = i;
  }
  return worst;
}

/* Checks friction coefficients from tables and functions, which may become too small during a run.
 * Constant coefficients are checked with the definition. */
arc_status arc_wear_friction_carries(const arc_wear *w, const arc_wear_record *state, double mu,
                                     arc_error *error) {
  const wear_block *b = arc_wear_block_at(w, state->cycle);
  double needed;
  if (!b->tangential) return ARC_OK;
  const int at = worst_point(b, &needed);
  if (mu > needed) return ARC_OK;
  const double thickness = w->manner.thickness;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'friction': expected more than %g, as a force of %g N drives the plate "
                  "under a load of %g N, got %g at a distance of %g mm",
                  needed, fabs(b->tangential[at]) * thickness, b->line[at] * thickness, mu,
                  state->distance);
}

int arc_wear_friction_changes(const arc_wear *w) {
  return w->def.friction_function || w->def.friction_series.count > 0;
}

arc_status arc_wear_friction_of(const arc_wear *w, const arc_wear_record *state, double *mu,
                                arc_error *error) {
  const arc_wear_def *d = &w->def;
  *mu = d->friction;
  if (d->friction_series.count > 0) *mu = arc_wear_series(&d->friction_series, state->distance);
  if (!d->friction_function) return ARC_OK;
  return arc_wear_evaluate_function(w, &arc_wear_settings[ARC_AT_friction], d->friction_function,
                                    state, mu, error);
}

arc_status arc_wear_friction(const arc_wear *w, const arc_wear_record *state, double *mu,
                             arc_error *error) {
  const arc_status status = arc_wear_friction_of(w, state, mu, error);
  return status == ARC_OK ? arc_wear_friction_carries(w, state, *mu, error) : status;
}

arc_status arc_wear_loop(arc_wear *w, const arc_callbacks *callbacks, arc_loop **loop,
                         arc_error *error) {
  const wear_block *block = arc_wear_block_at(w, arc_wear_last(w)->cycle);
  wear_window cycle = {
      .block = block, .shape = w->shape, .last = block->count - 1, .state = arc_wear_last(w)};
  wear_progress progress = {.callbacks = callbacks};
  *loop = NULL;
  if (!arc_wear_has_friction(&w->def))
    return arc_fail(error, ARC_ARGUMENT, "field 'friction': a run without friction has no loop");
  const arc_status status = arc_wear_friction(w, cycle.state, &cycle.mu, error);
  return status == ARC_OK ? w->kind->loop(w, &cycle, &progress, loop, error) : status;
}

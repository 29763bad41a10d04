/* Makes one update of the geometry: computes the coefficients, then the depths by the scheme of the
 * run. */
#include "core/base/callbacks.h"
#include "core/wear/step.h"

#include <math.h>
#include <string.h>

/* Applies the wear depths to the shape of an outcome, and adds volumes, energy and error to its
 * record. */
static arc_status apply(const arc_wear *w, wear_depths *depth, wear_outcome *out,
                        arc_error *error) {
  out->record.error = depth->error;
  out->record.energy += depth->energy * w->manner.thickness;
  if (w->manner.counts_forces) out->record.load_distance += depth->pressed * w->manner.thickness;
  out->record.p_peak = fmax(out->record.p_peak, depth->peak);
  return w->kind->wear(w, out->shape, depth, &out->record, error);
}

/* Returns the integral of the load over the sliding distance of a window [N mm], computed by the
 * same integration rule as the wear. The load is the integral of the pressure over the area. Under
 * rigid slip the result is therefore, for each body, the integral of pressure times sliding
 * distance over its area (Eq. 15 of the reference paper). */
static double load_distance(const arc_wear *w, const wear_block *b, int first, int last) {
  double sum = 0;
  for (int at = first + 1; at <= last; at++) {
    const double line =
        w->def.rule == ARC_TRAPEZOID ? (b->line[at] + b->line[at - 1]) / 2 : b->line[at];
    sum += line * fabs(b->x[at] - b->x[at - 1]);
  }
  return b->repeat * sum * w->manner.thickness;
}

/* --- schemes ---------------------------------------------------------------------------------- */

static int is_explicit(const arc_wear *w, const wear_plan *plan) {
  return w->def.scheme == ARC_EXPLICIT || plan->explicit;
}

/* Computes the wear depths that an update adds over a window of the run. */
static arc_status find_depths(arc_wear *w, const wear_plan *plan, const wear_window *window,
                              const update_coefficients *coefficients, wear_progress *progress,
                              wear_depths *depth, arc_error *error) {
  if (!is_explicit(w, plan))
    return arc_wear_implicit(w, window, coefficients, progress, depth, error);
  wear_rate *rate = &w->work.rate;
  const arc_status status = w->kind->rate(w, window, progress, rate, error);
  if (status == ARC_OK) arc_wear_depths_of_rate(w, rate, coefficients, depth);
  return status;
}

/* Updates the geometry at every increment of a cycle (Eq. 4 of the reference paper, with the
 * pressure on the geometry before the increment). */
static arc_status split_update(arc_wear *w, wear_plan *plan, wear_progress *progress,
                               wear_outcome *out, arc_error *error) {
  update_coefficients whole;
  if (isfinite(plan->most)) { /* the length of the update follows from the integral of k */
    const arc_status status = arc_wear_integrate_coefficients(w, plan, NULL, &whole, error);
    if (status != ARC_OK) return status;
  }
  const wear_block *b = plan->block;
  arc_wear_record *record = &out->record;
  const arc_wear_record start = *record;
  const double length = plan->end - start.distance;
  wear_depths *depth = &w->work.depth;
  double gone = 0; /* completed fraction of the update */
  for (int i = 0; i + 1 < b->count; i++) {
    const double part = b->repeat * fabs(b->x[i + 1] - b->x[i]) / b->sliding;
    const double from = start.distance + gone * length;
    arc_wear_record middle = *record;
    middle.distance = from + part * length / 2;
    middle.cycle = start.cycle + (gone + part / 2) * plan->cycles;
    update_coefficients coefficients = {.cycles = plan->cycles};
    const wear_window window = {.block = b,
                                .shape = out->shape,
                                .first = i,
                                .last = i + 1,
                                .chained = i > 0,
                                .state = &middle};
    arc_status status =
        arc_wear_coefficients(w, from, from + part * length, &middle, coefficients.mean.k, error);
    if (status == ARC_OK)
      status = find_depths(w, plan, &window, &coefficients, progress, depth, error);
    if (status == ARC_OK) status = apply(w, depth, out, error);
    if (status != ARC_OK) return status;
    gone += part;
    record->distance = start.distance + gone * length;
    record->cycle = start.cycle + gone * plan->cycles;
    record->solutions = start.solutions + progress->solutions;
    record->depth_cylinder = w->kind->deepest(out->shape, ARC_CYLINDER);
    record->depth_plate = w->kind->deepest(out->shape, ARC_PLATE);
    arc_wear_note_coefficients(coefficients.mean.k, record);
    memcpy(out->predicted.k, coefficients.mean.k, sizeof out->predicted.k);
  }
  return ARC_OK;
}

/* Data of an update of whole cycles or of a single increment. */
typedef struct whole {
  arc_wear *w;
  wear_plan *plan;
  wear_window window;
  wear_progress *progress;
  wear_rate *rate; /* wear rate at the start of the update; NULL: not computed */
  update_coefficients coefficients;
} whole;

/* --- the start -------------------------------------------------------------------------------- */

static arc_status want_tangent(arc_wear *w, arc_error *error) {
  if (!w->start.tangent) w->start.tangent = w->kind->tangent(w);
  return w->start.tangent ? ARC_OK : arc_fail(error, ARC_MEMORY, "out of memory for an update");
}

/* Solves a window at the start of an update. The rate of a whole cycle is cached unless there are
 * local factors, which depend on the state. */
static arc_status solve_start(arc_wear *w, const wear_plan *plan, wear_window window,
                              wear_progress *progress, arc_error *error) {
  wear_start *s = &w->start;
  const int before = progress->solutions;
  s->block = NULL;
  s->linear = plan->staged;
  s->mu = window.mu;
  arc_status status = s->linear ? want_tangent(w, error) : ARC_OK;
  window.tangent = s->linear ? s->tangent : NULL;
  if (status == ARC_OK) status = w->kind->rate(w, &window, progress, &s->rate, error);
  if (status != ARC_OK) return status;
  s->solutions = progress->solutions - before;
  if (plan->block->periodic && !w->def.local_factor) s->block = plan->block;
  return ARC_OK;
}

/* Copies the cached wear rate to `rate`. Sets the number of uncounted contact solutions in the
 * cache to 0, so that these solutions are counted only once. */
static void take_start(arc_wear *w, wear_rate *rate) {
  arc_wear_rate_copy(&w->start.rate, rate, w->nc + w->np);
  w->start.solutions = 0;
}

/* Writes the friction results of a cycle to the record of the surfaces on which it was solved. */
static void note_rubbing(const arc_wear *w, const wear_rate *rate, arc_wear_record *record) {
  const double thickness = w->manner.thickness;
  record->cycle_energy = rate->energy * thickness;
  record->largest_shear = rate->shear * thickness;
  record->stick_width = rate->stick;
  record->gross = rate->gross;
}

arc_status arc_wear_solve_next_cycle(arc_wear *w, const wear_plan *plan, wear_outcome *out,
                                     const arc_callbacks *callbacks, arc_error *error) {
  w->start.block = NULL;
  const int asked = is_explicit(w, plan) || arc_wear_has_friction(&w->def);
  if (!asked || !plan->block->periodic || splits_cycles(w)) return ARC_OK;
  wear_progress later = {.callbacks = callbacks};
  wear_window cycle = {.block = plan->block,
                       .shape = out->shape,
                       .last = plan->block->count - 1,
                       .state = w->def.local_factor ? NULL : &out->record};
  arc_status status = arc_wear_friction(w, &out->record, &cycle.mu, error);
  if (status == ARC_OK) status = solve_start(w, plan, cycle, &later, error);
  if (status == ARC_ZONE || status == ARC_NUMERIC)
    return ARC_OK; /* the next step reports the error */
  if (status != ARC_OK) return status;
  out->record.p_peak = w->start.rate.peak;
  note_rubbing(w, &w->start.rate, &out->record);
  if (w->def.blocks == 0) out->record.p_peak = fmax(out->record.p_peak, out->record.p_max);
  return ARC_OK;
}

/* Computes the wear rate at the start of an update, or copies it from the cache. Only explicit
 * updates, and runs whose settings are functions of the state, need this rate; for other updates
 * the function does nothing. */
static arc_status find_start(whole *u, arc_error *error) {
  arc_wear *w = u->w;
  if (!is_explicit(w, u->plan) && !arc_wear_has_state_functions(w)) return ARC_OK;
  u->rate = &w->work.rate;
  const wear_start *kept = &w->start;
  arc_status status = ARC_OK;
  if (kept->block == u->plan->block && kept->mu == u->window.mu &&
      (kept->linear || !u->plan->staged))
    u->progress->solutions += kept->solutions;
  else
    status = solve_start(w, u->plan, u->window, u->progress, error);
  if (status == ARC_OK) take_start(w, u->rate);
  return status;
}

/* Computes the coefficients of the planned update and, for an update in stages, its eigenvalue. The
 * plan is shortened if it needs more than the largest number of stages. */
static arc_status find_coefficients(whole *u, double *eigenvalue, arc_error *error) {
  arc_wear *w = u->w;
  arc_status status = arc_wear_integrate_coefficients(w, u->plan, u->rate, &u->coefficients, error);
  for (int cut = 0; cut < 3 && u->plan->staged && status == ARC_OK; cut++) {
    *eigenvalue =
        w->kind->eigenvalue(w, u->coefficients.mean.k, w->start.tangent, u->progress->callbacks);
    status = callbacks_check(u->progress->callbacks, error);
    if (status != ARC_OK) break;
    const double longest = arc_wear_longest_staged(w, *eigenvalue);
    if (u->coefficients.cycles <= longest) break;
    arc_wear_plan_shorten(w, u->plan, longest);
    status = arc_wear_integrate_coefficients(w, u->plan, u->rate, &u->coefficients, error);
  }
  return status;
}

/* Chooses the friction coefficient at the start of an update. Explicit updates of one stage use the
 * mean of the coefficient over the update. Updates of several stages use the value at the start or,
 * if the coefficient jumps there, the value after the jump. */
static arc_status find_friction(whole *u, arc_error *error) {
  static const double slight = 1e-6;
  const int asks = u->plan->staged || !is_explicit(u->w, u->plan);
  const double mu = asks ? u->coefficients.friction_at_start : u->coefficients.mean.friction;
  if (fabs(mu - u->window.mu) <= slight * mu) return ARC_OK;
  const arc_wear_record middle = arc_wear_state_within(u->w, u->plan, 0.5, NULL, NULL);
  u->window.mu = mu;
  const arc_status status = arc_wear_friction_carries(u->w, &middle, mu, error);
  return status == ARC_OK ? find_start(u, error) : status;
}

/* Predicts the surface at the middle of an update, for which the shape computes data such as its
 * compliance. Does nothing unless the update is implicit, of whole cycles, and has a tolerance. */
static arc_status look_ahead(whole *u, arc_shape *shape, wear_depths *depth, arc_error *error) {
  arc_wear *w = u->w;
  wear_rate *rate = &w->work.rate;
  if (!w->kind->look_ahead || is_explicit(w, u->plan) || w->def.tolerance == 0 ||
      !u->plan->block->periodic)
    return ARC_OK;
  const update_coefficients half = {.cycles = u->coefficients.cycles / 2,
                                    .mean = u->coefficients.mean};
  arc_status status = u->rate ? ARC_OK : w->kind->rate(w, &u->window, u->progress, rate, error);
  if (status != ARC_OK) return status;
  arc_wear_depths_of_rate(w, rate, &half, depth);
  return w->kind->look_ahead(w, shape, depth, error);
}

static arc_status depths_of_update(whole *u, arc_shape *shape, wear_depths *depth,
                                   arc_error *error) {
  arc_wear *w = u->w;
  double eigenvalue = 0;
  arc_status status = find_start(u, error);
  if (status == ARC_OK) status = find_coefficients(u, &eigenvalue, error);
  if (status == ARC_OK) status = find_friction(u, error);
  if (status != ARC_OK) return status;
  if (u->plan->staged)
    return arc_wear_stages(w, &u->window, &u->coefficients, eigenvalue, u->progress, u->rate, depth,
                           error);
  const int again = arc_wear_has_state_functions(w) && w->def.local_factor;
  if (is_explicit(w, u->plan) && !again) {
    arc_wear_depths_of_rate(w, u->rate, &u->coefficients, depth);
    return ARC_OK;
  }
  const update_coefficients half = {.cycles = u->coefficients.cycles / 2,
                                    .mean = u->coefficients.mean};
  const arc_wear_record middle = arc_wear_state_within(w, u->plan, 0.5, u->rate, &half);
  u->window.state = &middle;
  status = look_ahead(u, shape, depth, error);
  if (status != ARC_OK) return status;
  return find_depths(w, u->plan, &u->window, &u->coefficients, u->progress, depth, error);
}

static arc_status whole_update(arc_wear *w, wear_plan *plan, wear_progress *progress,
                               wear_outcome *out, arc_error *error) {
  const int generic = !plan->block->periodic;
  const arc_wear_record middle = arc_wear_has_state_functions(w)
                                     ? out->record
                                     : arc_wear_state_within(w, plan, 0.5, NULL, NULL);
  whole u = {.w = w, .plan = plan, .progress = progress};
  u.window = (wear_window){.block = plan->block,
                           .shape = out->shape,
                           .first = generic ? plan->first : 0,
                           .last = generic ? plan->first + 1 : plan->block->count - 1,
                           .state = &middle};
  wear_depths *depth = &w->work.depth;
  arc_status status = arc_wear_friction(w, &out->record, &u.window.mu, error);
  if (status != ARC_OK) return status;
  status = depths_of_update(&u, out->shape, depth, error);
  if (status != ARC_OK) return status;
  arc_wear_note_coefficients(u.coefficients.mean.k, &out->record);
  out->predicted = u.coefficients.last;
  return apply(w, depth, out, error);
}

arc_status arc_wear_update(arc_wear *w, wear_plan *plan, wear_progress *progress, wear_outcome *out,
                           arc_error *error) {
  const int split = splits_cycles(w) && plan->block->periodic;
  const arc_status status = split ? split_update(w, plan, progress, out, error)
                                  : whole_update(w, plan, progress, out, error);
  out->record.update += split ? plan->block->count - 1 : 1;
  const int generic = !plan->block->periodic;
  const int first = generic ? plan->first : 0, last = plan->block->count - 1;
  if (w->manner.counts_forces) return status;
  out->record.load_distance +=
      plan->times * load_distance(w, plan->block, first, generic ? first + 1 : last);
  return status;
}

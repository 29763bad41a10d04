/* Makes a step of a run: plans the step, attempts it, shortens it if necessary, and ends it at
 * targets. A step that fails does not change the run. */
#include "core/base/callbacks.h"
#include "core/wear/step.h"

#include <math.h>

/* Returns the tolerance of a step with error control, and 0 for all other steps. */
static double tolerance_of(const arc_wear *w, const wear_plan *plan) {
  return plan->staged ? ARC_STAGED_TOLERANCE : w->def.tolerance;
}

static void add_deviation(double value, double predicted, double scale, double *largest) {
  if (scale > 0) *largest = fmax(*largest, fabs(value - predicted) / scale);
}

/* Computes the largest relative difference between the predicted and the actual coefficients of
 * wear and friction at the end of a step; 0 without a prediction. */
static arc_status find_deviation(arc_wear *w, const wear_outcome *out, double *deviation,
                                 arc_error *error) {
  static const double margin = 1e-6; /* distance from the end of the step, where a coefficient may
                                        jump, as a fraction of the step */
  const arc_wear_record *before = arc_wear_last(w);
  arc_wear_record end = out->record;
  wear_coefficients now;
  *deviation = 0;
  end.distance -= margin * (end.distance - before->distance);
  end.cycle -= margin * (end.cycle - before->cycle);
  arc_status status = arc_wear_coefficients(w, end.distance, end.distance, &end, now.k, error);
  if (status == ARC_OK) status = arc_wear_friction_of(w, &end, &now.friction, error);
  if (status != ARC_OK) return status;
  const double largest = fmax(out->record.k, now.k[ARC_CYLINDER] + now.k[ARC_PLATE]);
  for (int b = 0; b < ARC_BODIES; b++)
    add_deviation(now.k[b], out->predicted.k[b], largest, deviation);
  add_deviation(now.friction, out->predicted.friction, now.friction, deviation);
  return ARC_OK;
}

/* Returns the change of the wear coefficients between two records, for the body where it is larger,
 * divided by the larger k. */
static double apart(const arc_wear_record *a, const arc_wear_record *b) {
  const double c = fabs(a->k * a->alpha - b->k * b->alpha);
  const double p = fabs(a->k * (1 - a->alpha) - b->k * (1 - b->alpha)), k = fmax(a->k, b->k);
  return k > 0 ? fmax(c, p) / k : 0;
}

/* Makes the planned step on a copy of the shape. The run is unchanged. */
static arc_status attempt_once(arc_wear *w, wear_plan *plan, wear_progress *progress,
                               wear_outcome *out, arc_error *error) {
  const arc_wear_record *last = arc_wear_last(w);
  arc_wear_record *record = &out->record;
  *record = *last;
  record->error = record->p_peak = 0;
  arc_wear_note_motion(w, plan->block, plan->first, record);
  w->kind->discard(&out->shape);
  arc_status status = w->kind->copy(w->shape, &out->shape, error);
  if (status == ARC_OK) status = arc_wear_update(w, plan, progress, out, error);
  if (status != ARC_OK) return status;
  record->cycle = last->cycle + plan->cycles;
  record->jump = plan->cycles;
  record->distance = plan->end;
  record->solutions = last->solutions + progress->solutions;
  return w->kind->measure(w, out->shape, record, error);
}

/* Returns the sliding distance of the step that ends at `end`, divided by the sliding distance of
 * the run up to `end`. */
static double added_by(const arc_wear *w, const arc_wear_record *end) {
  const double gone = end->distance - w->block[0].start_distance;
  return gone > 0 ? (end->distance - arc_wear_last(w)->distance) / gone : 1;
}

/* Makes a step. If functions of the state differ from their predicted values, a step of second
 * order is repeated with its computed final state as the prediction. In steps with error control,
 * the error includes a part of the remaining difference. */
static arc_status follow(arc_wear *w, wear_plan *plan, arc_wear_record *end_state,
                         wear_progress *progress, wear_outcome *out, arc_error *error) {
  enum { most_tries = 3 };
  static const double let_pass = 0.02, usual = 1e-3, left_over = 0.3;
  const double tolerance = tolerance_of(w, plan), goal = tolerance > 0 ? tolerance : usual;
  double deviation = 0, off = 0;
  for (int try = 0; try < most_tries; try++) {
    arc_status status = attempt_once(w, plan, progress, out, error);
    const int follows = status == ARC_OK && (tolerance > 0 || arc_wear_follows(w, plan));
    if (!follows || !arc_wear_has_state_functions(w)) return status;
    if ((status = find_deviation(w, out, &deviation, error)) != ARC_OK) return status;
    if (plan->end_state) off = fmax(off, left_over * apart(end_state, &out->record));
    *end_state = out->record;
    plan->end_state = end_state;
    if (!arc_wear_follows(w, plan) || deviation * added_by(w, end_state) <= let_pass * goal) break;
  }
  if (tolerance > 0)
    out->record.error =
        fmax(out->record.error, fmax(deviation / 2, off) * added_by(w, &out->record) / tolerance);
  return ARC_OK;
}

static arc_status attempt(arc_wear *w, wear_plan *plan, wear_progress *progress, wear_outcome *out,
                          arc_error *error) {
  arc_wear_record end_state = {0};
  plan->end_state = NULL;
  const arc_status status = follow(w, plan, &end_state, progress, out, error);
  plan->end_state = NULL;
  return status;
}

/* Replaces the implicit step of a plan by an explicit step of at most half the stability limit,
 * because a discontinuous law may have no implicit solution. */
static arc_status give_up_implicit(arc_wear *w, wear_plan *plan, const wear_progress *progress,
                                   arc_error *error) {
  double eigenvalue;
  const arc_status status = arc_wear_stability(w, progress->callbacks, &eigenvalue, error);
  plan->explicit = 1;
  if (status == ARC_OK && plan->block->periodic && eigenvalue * plan->cycles > 1)
    arc_wear_plan_shorten(w, plan, 1 / eigenvalue);
  return status;
}

/* Returns the factor by which a step is shortened if its error is too large. */
static double cut_share(const arc_wear *w, const wear_plan *plan, double error) {
  const double power = w->def.order == 1 && !plan->staged ? 0.5 : 1.0 / 3;
  return fmax(0.1, 0.8 * pow(error, -power));
}

/* Returns the largest accepted error, divided by the tolerance. A step in stages aims at the
 * tolerance but is accepted up to twice the tolerance. Such steps are expensive, and their error
 * estimates jump when the edge of the contact crosses a node. */
static double passable(const wear_plan *plan) {
  return plan->staged ? 2 : 1;
}

static int has_outgrown(const arc_wear *w, arc_status status) {
  return w->kind->growth && w->kind->growth->has_outgrown(w, status);
}

/* Returns true if the contact has reached the edge of its mesh and a shorter step does not help. */
static int is_at_edge(const arc_wear *w, const wear_plan *plan, arc_status status) {
  return has_outgrown(w, status) && arc_wear_plan_is_short(w, plan);
}

/* Makes a step. Repeats it with a shorter length if it does not converge or its error is too large.
 */
static arc_status attempt_with_cuts(arc_wear *w, wear_plan *plan, wear_progress *progress,
                                    wear_outcome *out, arc_error *error) {
  enum { most_cuts = 20, most_failures = 3, patience = 6 };
  const wear_plan whole_plan = *plan;
  int failures = 0;
  for (int cut = 0;; cut++) {
    arc_status status = attempt(w, plan, progress, out, error);
    if ((w->def.scheme != ARC_IMPLICIT && !plan->staged) || cut == most_cuts) return status;
    if (status == ARC_OK && out->record.error <= passable(plan)) return status;
    if (!plan->staged && has_outgrown(w, status)) return status;
    const int lost = status == ARC_ZONE || status == ARC_NUMERIC;
    if (status != ARC_OK && status != ARC_NOT_CONVERGED && !lost) return status;
    failures += status != ARC_OK;
    if (plan->staged && failures > patience) return status;
    if (is_at_edge(w, plan, status)) return status;
    if (!plan->staged && !plan->explicit && (failures == most_failures || cut == patience)) {
      *plan = whole_plan;
      if ((status = give_up_implicit(w, plan, progress, error)) != ARC_OK) return status;
    } else if (status != ARC_OK) {
      arc_wear_plan_shorten(w, plan, plan->cycles / 4);
    } else {
      arc_wear_plan_shorten(w, plan, plan->cycles * cut_share(w, plan, out->record.error));
    }
  }
}

/* Targets of a run, and the index of the target that was reached (-1: none). */
typedef struct wear_targets {
  const arc_wear_target *target;
  size_t count;
  int reached;
} wear_targets;

/* Returns the value of the target's column in a record minus the value of the target. */
static double beyond(const arc_wear_record *record, const arc_wear_target *t) {
  return arc_wear_record_get(record, t->column) - t->value;
}

static int passed(const arc_wear *w, const arc_wear_record *record, const arc_wear_target *t) {
  const double before = beyond(arc_wear_last(w), t), after = beyond(record, t);
  return before != 0 && (after == 0 || (before < 0) != (after < 0));
}

/* Shortens a step that has passed a target, by the Illinois method, until it ends at the target. */
static arc_status meet_target(arc_wear *w, const wear_plan *whole_plan, const arc_wear_target *t,
                              wear_progress *progress, wear_outcome *out, arc_error *error) {
  enum { most_tries = 60 };
  double now = beyond(&out->record, t);
  const double close =
      1e-10 * fmax(fabs(t->value), fabs(arc_wear_record_get(&out->record, t->column)));
  double low = 0, below = beyond(arc_wear_last(w), t);
  double high = whole_plan->cycles, above = now;
  int last = 0;
  for (int i = 0; i < most_tries && fabs(now) > close && high - low >= 1e-13 * high; i++) {
    const double cycles = low + (high - low) * below / (below - above);
    wear_plan plan = *whole_plan;
    arc_wear_plan_shorten(w, &plan, cycles);
    const arc_status status = attempt(w, &plan, progress, out, error);
    if (status != ARC_OK) return status;
    now = beyond(&out->record, t);
    if ((now < 0) == (below < 0)) {
      low = cycles, below = now;
      if (last == -1) above /= 2;
      last = -1;
    } else {
      high = cycles, above = now;
      if (last == 1) below /= 2;
      last = 1;
    }
  }
  return ARC_OK;
}

/* Shortens the step to the first target that the step passed. */
static arc_status meet_targets(arc_wear *w, const wear_plan *plan, wear_progress *progress,
                               wear_targets *targets, wear_outcome *out, arc_error *error) {
  wear_plan first = *plan;
  for (size_t i = 0; i < targets->count; i++) {
    const arc_wear_target *t = &targets->target[i];
    if (!passed(w, &out->record, t)) continue;
    const arc_status status = meet_target(w, &first, t, progress, out, error);
    if (status != ARC_OK) return status;
    arc_wear_plan_shorten(w, &first, out->record.jump);
    targets->reached = (int)i;
  }
  return ARC_OK;
}

static arc_status try_step(arc_wear *w, double limit, const arc_callbacks *callbacks,
                           wear_targets *targets, int *moved, arc_error *error) {
  wear_plan plan = {0};
  wear_outcome out = {0};
  wear_progress progress = {.callbacks = callbacks}; /* includes the solutions of failed attempts */
  arc_status status = arc_wear_plan_step(w, limit, callbacks, &plan, moved, error);
  if (status != ARC_OK || !*moved) return status;
  status = attempt_with_cuts(w, &plan, &progress, &out, error);
  if (status == ARC_OK) status = meet_targets(w, &plan, &progress, targets, &out, error);
  if (status == ARC_OK) status = arc_wear_refuse_ripples(w, &plan, &out, callbacks, error);
  if (status == ARC_OK) status = arc_wear_solve_next_cycle(w, &plan, &out, callbacks, error);
  if (status == ARC_OK) status = arc_wear_append(w, &out.record, error);
  if (status != ARC_OK) w->start.block = NULL;
  if (status == ARC_OK) {
    arc_shape *old = w->shape;
    w->shape = out.shape;
    out.shape = old;
  }
  w->kind->discard(&out.shape);
  if (status == ARC_OK) arc_wear_warn_of_ripples(w, plan.block, callbacks);
  if (status == ARC_OK && callbacks && callbacks->warn && w->kind->warn_late)
    w->late = w->kind->warn_late(w, w->late, callbacks);
#ifdef ARC_CHECKS
  arc_error broken;
  if (status == ARC_OK && arc_wear_validate(w, &broken) == ARC_NUMERIC)
    status = arc_fail(error, ARC_NUMERIC, "%s", broken.message);
#endif
  return status;
}

/* Makes a step. If the contact reaches the edge of its zones, the step is repeated on larger
 * meshes. If this fails as well, the run is unchanged and the first error is reported. */
static arc_status step_towards(arc_wear *w, double limit, const arc_callbacks *callbacks,
                               wear_targets *targets, int *moved, arc_error *error) {
  enum { most_tries = 4 };
  arc_error why = {0}, trouble = {0};
  arc_wear *before = NULL, *larger;
  const arc_growth *growth = w->kind->growth;
  arc_status status = growth && arc_wear_can_move(w, limit) && growth->must_grow(w, &why)
                          ? why.status
                          : try_step(w, limit, callbacks, targets, moved, &why);
  const arc_status first = status;
  for (int i = 0; i < most_tries && has_outgrown(w, status); i++) {
    const arc_status built = growth->grow(w, status, callbacks, &larger, &trouble);
    if (built == ARC_STOPPED) status = arc_fail(&why, built, "%s", trouble.message);
    if (built != ARC_OK) break;
    arc_wear_exchange(w, larger);
    if (before)
      arc_wear_destroy(&larger);
    else
      before = larger;
    status = try_step(w, limit, callbacks, targets, moved, &trouble);
    if (status == ARC_STOPPED) arc_fail(&why, status, "%s", trouble.message);
  }
  if (before && status == ARC_OK)
    growth->report(before, w, callbacks);
  else if (before)
    arc_wear_exchange(w, before);
  arc_wear_destroy(&before);
  if (status == ARC_OK || status == ARC_STOPPED)
    return status == ARC_OK ? status : arc_fail(error, status, "%s", why.message);
  why.status = first;
  return growth ? growth->refuse(w, &why, &trouble, error)
                : arc_fail(error, first, "%s", why.message);
}

arc_status arc_wear_step(arc_wear *w, const arc_callbacks *callbacks, arc_error *error) {
  wear_targets none = {0};
  int moved;
  if (!w->warned) arc_wear_warn(w, callbacks);
  return step_towards(w, w->def.distance, callbacks, &none, &moved, error);
}

arc_status arc_wear_run_until(arc_wear *w, double distance, const arc_wear_target *target,
                              size_t count, const arc_callbacks *callbacks, int *reached,
                              arc_error *error) {
  wear_targets targets = {.target = target, .count = count, .reached = -1};
  if (reached) *reached = -1;
  if (!(distance > 0) || !isfinite(distance))
    return arc_fail(error, ARC_ARGUMENT, "field 'distance': expected a number > 0 mm, got %g",
                    distance);
  if (distance > w->def.distance) w->def.distance = distance;
  arc_wear_warn(w, callbacks);
  while (targets.reached < 0) {
    int moved;
    const arc_status status = step_towards(w, distance, callbacks, &targets, &moved, error);
    if (status != ARC_OK || !moved) return status;
    if (callbacks_progress(callbacks, w)) return arc_fail(error, ARC_STOPPED, "stopped on request");
  }
  if (reached) *reached = targets.reached;
  return ARC_OK;
}

arc_status arc_wear_run(arc_wear *w, double distance, const arc_callbacks *callbacks,
                        arc_error *error) {
  return arc_wear_run_until(w, distance, NULL, 0, callbacks, NULL, error);
}

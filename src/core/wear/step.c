/* One step of a run: how far, with which coefficients, by which scheme; then all of it or nothing.
 */
#include "archard/measure.h"
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- with which coefficients --- */

/* Volumes [mm3] that depths `delta` and even wear take from a shape, before it is worn by them. */
static void add_volumes(const arc_wear *w, const arc_shape *shape,
                        const double *const delta[ARC_BODIES], double even,
                        arc_wear_record *record) {
  const arc_model_def *md = arc_model_definition(w->model);
  double sum[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < shape->side[b].n; i++)
      sum[b] += delta[b][i] * arc_shape_width(&shape->side[b], i);
  record->volume_cylinder += sum[ARC_CYLINDER] * md->thickness;
  record->volume_plate += (sum[ARC_PLATE] + even * 2 * md->radius) * md->thickness;
}

static int wears_evenly(const arc_wear *w) {
  return w->over_plate && w->procedure == ARC_NSP;
}

/* w->delta := what w->rate takes in so many cycles; returns the even depth of the plate. */
static double depths_of_rate(arc_wear *w, double cycles, const double k[ARC_BODIES]) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const double scale = b == ARC_PLATE && w->procedure == ARC_NSP ? 0 : cycles * k[b];
    for (int i = 0; i < w->shape->side[b].n; i++) w->delta[b][i] = scale * w->rate.node[b][i];
  }
  return wears_evenly(w) ? cycles * k[ARC_PLATE] * w->rate.even : 0;
}

/* The state a share of the way through an update, predicted from w->rate and coefficients k. */
static arc_wear_record predict(arc_wear *w, const wear_plan *plan, double share,
                               const double k[ARC_BODIES]) {
  arc_wear_record state = *arc_wear_last(w);
  const double even = depths_of_rate(w, share * plan->times, k);
  const double *const delta[ARC_BODIES] = {w->delta[0], w->delta[1]};
  double *deepest[ARC_BODIES] = {&state.depth_cylinder, &state.depth_plate};
  state.distance += share * (plan->end - state.distance);
  state.cycle += share * plan->cycles;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < w->shape->side[b].n; i++)
      *deepest[b] =
          fmax(*deepest[b], w->shape->side[b].h[i] + w->delta[b][i] + (b == ARC_PLATE ? even : 0));
  add_volumes(w, w->shape, delta, even, &state);
  state.depth_partition = arc_depth_partition(state.depth_cylinder, state.depth_plate);
  return state;
}

/* The state half-way through an update, where functions of the state are asked: from the rate at
 * its start, with their value a quarter of the way. *rated: w->rate is that of the start. */
static arc_status middle_state(arc_wear *w, const wear_plan *plan, const wear_window *window,
                               arc_wear_record *middle, int *rated, int *solutions,
                               arc_error *error) {
  const arc_wear_record *before = arc_wear_last(w);
  static const double nothing[ARC_BODIES] = {0};
  double k[ARC_BODIES];
  *rated = arc_wear_has_state_functions(w) && !arc_wear_closed_form(w);
  if (!*rated) {
    w->rate.even = 0;
    *middle = predict(w, plan, 0.5, nothing);
    return ARC_OK;
  }
  arc_status status = arc_wear_coefficients(w, before->distance, plan->end, before, k, error);
  if (status == ARC_OK)
    status = arc_wear_evaluate(w, w->shape, window, plan->monitor->stop, plan->monitor->context,
                               solutions, error);
  if (status != ARC_OK) return status;
  const arc_wear_record quarter = predict(w, plan, 0.25, k);
  status = arc_wear_coefficients(w, before->distance, plan->end, &quarter, k, error);
  if (status == ARC_OK) *middle = predict(w, plan, 0.5, k);
  return status;
}

/* --- by which scheme --- */

/* Wears `next` by w->delta and `even`, and adds the volumes. */
static arc_status apply(arc_wear *w, arc_shape *next, double even, arc_wear_record *record,
                        arc_error *error) {
  const double *const delta[ARC_BODIES] = {w->delta[0], w->delta[1]};
  add_volumes(w, next, delta, even, record);
  for (int b = 0; b < ARC_BODIES; b++) {
    int any = 0;
    for (int i = 0; i < next->side[b].n && !any; i++) any = delta[b][i] != 0;
    if (!any) continue;
    const arc_status status = arc_shape_wear(next, (arc_body)b, delta[b], error);
    if (status != ARC_OK) return status;
  }
  if (even != 0) arc_shape_wear_evenly(next, ARC_PLATE, even);
  return ARC_OK;
}

/* One update over a window of the path, on w->next. */
static arc_status update(arc_wear *w, const wear_window *window, double cycles,
                         const double k[ARC_BODIES], const wear_plan *plan, arc_wear_record *record,
                         arc_error *error) {
  const wear_monitor *m = plan->monitor;
  int solutions = 0;
  arc_status status;
  double even;
  if (w->def.scheme == ARC_IMPLICIT && !plan->explicit) {
    status = arc_wear_implicit(w, w->next, window, cycles, k, m->stop, m->context, &solutions,
                               &record->error, error);
    even = wears_evenly(w) ? cycles * k[ARC_PLATE] * w->rate.even : 0;
  } else {
    status = arc_wear_evaluate(w, w->next, window, m->stop, m->context, &solutions, error);
    even = depths_of_rate(w, cycles, k);
  }
  record->solutions += solutions;
  return status == ARC_OK ? apply(w, w->next, even, record, error) : status;
}

/* alpha = 0 over the whole plate: the load is all that counts. */
static arc_status closed_form_update(arc_wear *w, double cycles, const double k[ARC_BODIES],
                                     arc_wear_record *record, arc_error *error) {
  memset(w->delta[0], 0, (size_t)(w->nc + w->np) * sizeof(double));
  return apply(w, w->next, cycles * k[ARC_PLATE] * w->block[0].line[0], record, error);
}

/* Every increment of a cycle with an update of its own (Eq. 4 with p_{i-1} of the geometry before).
 */
static arc_status quasi_continuous(arc_wear *w, const wear_plan *plan, arc_wear_record *record,
                                   arc_error *error) {
  const wear_block *b = plan->block;
  const double start = record->distance, length = plan->end - start;
  double gone = 0;
  for (int i = 0; i + 1 < b->count; i++) {
    const double part = b->repeat * fabs(b->x[i + 1] - b->x[i]) / b->sliding * length;
    arc_wear_record middle = *record;
    middle.distance = start + gone + part / 2;
    double k[ARC_BODIES];
    arc_status status =
        arc_wear_coefficients(w, start + gone, start + gone + part, &middle, k, error);
    const wear_window window = {.first = i, .last = i + 1, .chained = i > 0, .state = &middle};
    if (status == ARC_OK) status = update(w, &window, plan->cycles, k, plan, record, error);
    if (status != ARC_OK) return status;
    gone += part;
    record->distance = start + gone;
    record->depth_cylinder = arc_shape_depth(w->next, ARC_CYLINDER);
    record->depth_plate = arc_shape_depth(w->next, ARC_PLATE);
    arc_wear_note_coefficients(k, record);
  }
  return ARC_OK;
}

static arc_status whole_update(arc_wear *w, const wear_plan *plan, arc_wear_record *record,
                               arc_error *error) {
  const double from = record->distance;
  const int generic = !plan->block->periodic;
  arc_wear_record middle = *record;
  wear_window window = {.first = generic ? plan->first : 0,
                        .last = generic ? plan->first + 1 : plan->block->count - 1,
                        .state = &middle};
  double k[ARC_BODIES];
  int solutions = 0, rated;
  arc_wear_record found;
  arc_status status = middle_state(w, plan, &window, &found, &rated, &solutions, error);
  record->solutions += solutions;
  middle = found;
  if (status == ARC_OK) status = arc_wear_coefficients(w, from, plan->end, &middle, k, error);
  if (status != ARC_OK) return status;
  arc_wear_note_coefficients(k, record);
  if (arc_wear_closed_form(w)) return closed_form_update(w, plan->cycles, k, record, error);
  /* the explicit rate at the start serves twice, unless local factors see the middle */
  if (rated && (w->def.scheme == ARC_EXPLICIT || plan->explicit) && !w->def.local_factor)
    return apply(w, w->next, depths_of_rate(w, plan->times, k), record, error);
  return update(w, &window, plan->times, k, plan, record, error);
}

/* --- all of it or nothing --- */

/* Adaptive steps also answer for functions of the state: taken at the middle, they are good to the
 * second difference of what they give at both ends and in the middle, over the share of wear that
 * the step adds. */
static arc_status add_coefficient_error(arc_wear *w, arc_wear_record *record, arc_error *error) {
  if (!arc_wear_has_state_functions(w) || w->def.tolerance == 0) return ARC_OK;
  const arc_wear_record *before = arc_wear_last(w);
  double start[ARC_BODIES], end[ARC_BODIES];
  arc_status status =
      arc_wear_coefficients(w, before->distance, before->distance, before, start, error);
  if (status == ARC_OK)
    status = arc_wear_coefficients(w, record->distance, record->distance, record, end, error);
  if (status != ARC_OK || !(record->k > 0)) return status;
  const double middle[ARC_BODIES] = {record->k * record->alpha, record->k * (1 - record->alpha)};
  const double gone = record->distance - w->block[0].start_distance;
  const double added = gone > 0 ? (record->distance - before->distance) / gone : 1;
  for (int b = 0; b < ARC_BODIES; b++) {
    const double bend =
        fabs(start[b] - 2 * middle[b] + end[b]) / 6 + fabs(end[b] - start[b]) * added / 12;
    record->error = fmax(record->error, bend / record->k * added / w->def.tolerance);
  }
  return ARC_OK;
}

/* Tries the plan on w->next, which holds a worn copy afterwards; the run itself stays. */
static arc_status attempt(arc_wear *w, const wear_plan *plan, arc_wear_record *record,
                          arc_error *error) {
  *record = *arc_wear_last(w);
  record->error = 0;
  arc_shape_destroy(&w->next);
  arc_status status = arc_shape_clone(w->shape, &w->next, error);
  if (status != ARC_OK) return status;
  const int split =
      w->def.update == ARC_UPDATE_INCREMENT && plan->block->periodic && w->procedure == ARC_SP;
  status = split ? quasi_continuous(w, plan, record, error) : whole_update(w, plan, record, error);
  if (status != ARC_OK) return status;
  record->update += split ? plan->block->count - 1 : 1;
  record->cycle += plan->cycles;
  record->jump = plan->cycles;
  record->distance = plan->end;
  status = arc_wear_measure(w, w->next, record, error);
  return status == ARC_OK ? add_coefficient_error(w, record, error) : status;
}

static void shorten(const arc_wear *w, wear_plan *plan, double cycles) {
  const double share = cycles / plan->cycles, from = arc_wear_last(w)->distance;
  plan->end = from + share * (plan->end - from);
  plan->times *= share;
  plan->cycles = cycles;
}

/* A law with a jump in it may have no implicit solution for any step: then the plan is an explicit
 * one, at half the length at which ripples would grow. */
static arc_status give_up_implicit(arc_wear *w, wear_plan *plan, arc_error *error) {
  double eigenvalue;
  const arc_status status = arc_wear_stability(w, &eigenvalue, error);
  plan->explicit = 1;
  if (status == ARC_OK && plan->block->periodic && eigenvalue * plan->cycles > 1)
    shorten(w, plan, 1 / eigenvalue);
  return status;
}

/* Implicit steps that do not converge, or err too much, are cut and tried again. */
static arc_status attempt_with_cuts(arc_wear *w, wear_plan *plan, arc_wear_record *record,
                                    arc_error *error) {
  enum { most_cuts = 20, most_failures = 3, patience = 6 };
  const wear_plan whole_plan = *plan;
  int failures = 0;
  const double power = w->def.order == 1 ? 0.5 : 1.0 / 3;
  for (int cut = 0;; cut++) {
    arc_status status = attempt(w, plan, record, error);
    if (w->def.scheme != ARC_IMPLICIT || cut == most_cuts) return status;
    if (status == ARC_OK && record->error <= 1) return status;
    if (status != ARC_OK && status != ARC_NOT_CONVERGED) return status;
    failures += status == ARC_NOT_CONVERGED;
    if (!plan->explicit && (failures == most_failures || cut == patience)) {
      *plan = whole_plan;
      if ((status = give_up_implicit(w, plan, error)) != ARC_OK) return status;
    } else if (status == ARC_NOT_CONVERGED) {
      shorten(w, plan, plan->cycles / 4);
    } else {
      shorten(w, plan, plan->cycles * fmax(0.1, 0.8 * pow(record->error, -power)));
    }
  }
}

static double column_of(const arc_wear_record *record, size_t column) {
  if (column == ARC_WEAR_TOTAL_VOLUME) return record->volume_cylinder + record->volume_plate;
  return *(const double *)(const void *)((const char *)record + column);
}

static int passed(const arc_wear *w, const arc_wear_record *record, const arc_wear_target *t) {
  const double before = column_of(arc_wear_last(w), t->column) - t->value;
  const double after = column_of(record, t->column) - t->value;
  return before != 0 && (after == 0 || (before < 0) != (after < 0));
}

/* Shortens a step that passed a target until it ends on it: false position with Illinois' weights.
 */
static arc_status meet_target(arc_wear *w, const wear_plan *whole_plan, const arc_wear_target *t,
                              arc_wear_record *record, arc_error *error) {
  enum { most_tries = 60 };
  const double close = 1e-10 * fmax(fabs(t->value), fabs(column_of(record, t->column)));
  double low = 0, below = column_of(arc_wear_last(w), t->column) - t->value;
  double high = whole_plan->cycles, above = column_of(record, t->column) - t->value;
  int last = 0;
  for (int i = 0; i < most_tries; i++) {
    if (fabs(column_of(record, t->column) - t->value) <= close || high - low < 1e-13 * high)
      return ARC_OK;
    const double cycles = low + (high - low) * below / (below - above);
    wear_plan plan = *whole_plan;
    shorten(w, &plan, cycles);
    const arc_status status = attempt(w, &plan, record, error);
    if (status != ARC_OK) return status;
    const double value = column_of(record, t->column) - t->value;
    if ((value < 0) == (below < 0)) {
      low = cycles, below = value;
      if (last == -1) above /= 2;
      last = -1;
    } else {
      high = cycles, above = value;
      if (last == 1) below /= 2;
      last = 1;
    }
  }
  return ARC_OK;
}

/* Of all targets passed in the step, the one that is met first. */
static arc_status meet_targets(arc_wear *w, const wear_plan *plan, arc_wear_record *record,
                               arc_error *error) {
  wear_monitor *m = plan->monitor;
  wear_plan first = *plan;
  for (size_t t = 0; t < m->count; t++) {
    if (!passed(w, record, &m->targets[t])) continue;
    const arc_status status = meet_target(w, &first, &m->targets[t], record, error);
    if (status != ARC_OK) return status;
    shorten(w, &first, record->jump);
    m->reached = (int)t;
  }
  return ARC_OK;
}

static arc_status step_towards(arc_wear *w, double limit, wear_monitor *monitor, int *moved,
                               arc_error *error) {
  wear_plan plan = {.monitor = monitor};
  arc_wear_record record;
  monitor->reached = -1;
  arc_status status = arc_wear_plan_step(w, limit, &plan, moved, error);
  if (status != ARC_OK || !*moved) return status;
  status = attempt_with_cuts(w, &plan, &record, error);
  if (status == ARC_OK) status = meet_targets(w, &plan, &record, error);
  if (status == ARC_OK) status = arc_wear_append(w, &record, error);
  if (status == ARC_OK) {
    arc_shape *old = w->shape;
    w->shape = w->next;
    w->next = old;
  }
  arc_shape_destroy(&w->next);
  return status;
}

arc_status arc_wear_step(arc_wear *w, arc_stop_fn stop, void *context, arc_error *error) {
  wear_monitor monitor = {.stop = stop, .context = context};
  int moved;
  return step_towards(w, w->def.distance, &monitor, &moved, error);
}

arc_status arc_wear_run_until(arc_wear *w, double distance, const arc_wear_target *targets,
                              size_t count, arc_stop_fn stop, arc_wear_progress_fn progress,
                              void *context, int *reached, arc_error *error) {
  if (reached) *reached = -1;
  if (!(distance > 0) || !isfinite(distance))
    return arc_fail(error, ARC_ARGUMENT, "distance: expected above 0 mm, got %g mm", distance);
  if (distance > w->def.distance) w->def.distance = distance;
  for (;;) {
    wear_monitor monitor = {.stop = stop, .context = context, .targets = targets, .count = count};
    int moved;
    const arc_status status = step_towards(w, distance, &monitor, &moved, error);
    if (status != ARC_OK || !moved) return status;
    if (progress && progress(context, w)) return arc_fail(error, ARC_STOPPED, "stopped on request");
    if (monitor.reached < 0) continue;
    if (reached) *reached = monitor.reached;
    return ARC_OK;
  }
}

arc_status arc_wear_run(arc_wear *w, double distance, arc_stop_fn stop,
                        arc_wear_progress_fn progress, void *context, arc_error *error) {
  return arc_wear_run_until(w, distance, NULL, 0, stop, progress, context, NULL, error);
}

/* One update of the geometry: with which coefficients, by which scheme. */
#include "archard/measure.h"
#include "core/wear/step.h"

#include <math.h>
#include <string.h>

/* --- depths and what they take --- */

/* Volumes [mm3] that depths take from a shape, before it is worn by them. */
static void add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                        arc_wear_record *record) {
  const arc_model_def *md = arc_model_definition(w->model);
  double sum[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < shape->side[b].n; i++)
      sum[b] += depth->node[b][i] * arc_shape_width(&shape->side[b], i);
  record->volume_cylinder += sum[ARC_CYLINDER] * md->thickness;
  record->volume_plate += (sum[ARC_PLATE] + depth->even * 2 * md->radius) * md->thickness;
}

/* What a rate takes in so many cycles. */
static void depths_of_rate(const arc_wear *w, const wear_rate *rate, const wear_dose *dose,
                           wear_depths *depth) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const double scale = b == ARC_PLATE && w->procedure == ARC_NSP ? 0 : dose->cycles * dose->k[b];
    for (int i = 0; i < w->shape->side[b].n; i++) depth->node[b][i] = scale * rate->node[b][i];
  }
  depth->even = wears_evenly(w) ? dose->cycles * dose->k[ARC_PLATE] * rate->even : 0;
  depth->error = 0;
  depth->peak = rate->peak;
}

static int any_depth(const double *depth, int n) {
  for (int i = 0; i < n; i++)
    if (depth[i] != 0) return 1;
  return 0;
}

/* Wears the outcome's shape, and adds volumes and error. */
static arc_status apply(const arc_wear *w, const wear_depths *depth, wear_outcome *out,
                        arc_error *error) {
  add_volumes(w, out->shape, depth, &out->record);
  out->record.error = depth->error;
  out->record.p_peak = fmax(out->record.p_peak, depth->peak);
  for (int b = 0; b < ARC_BODIES; b++) {
    if (!any_depth(depth->node[b], out->shape->side[b].n)) continue;
    const arc_status status = arc_shape_wear(out->shape, (arc_body)b, depth->node[b], error);
    if (status != ARC_OK) return status;
  }
  if (depth->even != 0) arc_shape_wear_evenly(out->shape, ARC_PLATE, depth->even);
  return ARC_OK;
}

/* --- with which coefficients --- */

/* The state a share of the way through an update. */
static arc_wear_record on_the_way(const arc_wear *w, const wear_plan *plan, double share) {
  arc_wear_record state = *arc_wear_last(w);
  state.distance += share * (plan->end - state.distance);
  state.cycle += share * plan->cycles;
  return state;
}

/* The same with the depths and volumes that a rate and coefficients k lead to. */
static arc_wear_record predict(arc_wear *w, const wear_plan *plan, double share,
                               const wear_rate *rate, const double k[ARC_BODIES]) {
  arc_wear_record state = on_the_way(w, plan, share);
  const wear_dose dose = {share * plan->times, {k[ARC_CYLINDER], k[ARC_PLATE]}};
  wear_depths *depth = &w->work.depth;
  double *deepest[ARC_BODIES] = {&state.depth_cylinder, &state.depth_plate};
  depths_of_rate(w, rate, &dose, depth);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double even = b == ARC_PLATE ? depth->even : 0, *h = w->shape->side[b].h;
    for (int i = 0; i < w->shape->side[b].n; i++)
      *deepest[b] = fmax(*deepest[b], h[i] + depth->node[b][i] + even);
  }
  add_volumes(w, w->shape, depth, &state);
  state.depth_partition = arc_depth_partition(state.depth_cylinder, state.depth_plate);
  return state;
}

/* The state half-way through an update, where functions of the state are asked: from the rate at
 * its start, with their value a quarter of the way. */
static arc_status predict_middle(arc_wear *w, const wear_plan *plan, const wear_rate *rate,
                                 arc_wear_record *middle, arc_error *error) {
  const arc_wear_record *before = arc_wear_last(w);
  double k[ARC_BODIES];
  arc_status status = arc_wear_coefficients(w, before->distance, plan->end, before, k, error);
  if (status != ARC_OK) return status;
  const arc_wear_record quarter = predict(w, plan, 0.25, rate, k);
  status = arc_wear_coefficients(w, before->distance, plan->end, &quarter, k, error);
  if (status == ARC_OK) *middle = predict(w, plan, 0.5, rate, k);
  return status;
}

/* --- by which scheme --- */

static int is_explicit(const arc_wear *w, const wear_plan *plan) {
  return w->def.scheme == ARC_EXPLICIT || plan->explicit;
}

/* What a dose takes over a window. */
static arc_status find_depths(arc_wear *w, const wear_plan *plan, const wear_window *window,
                              const wear_dose *dose, wear_watch *watch, wear_depths *depth,
                              arc_error *error) {
  if (!is_explicit(w, plan)) return arc_wear_implicit(w, window, dose, watch, depth, error);
  wear_rate *rate = &w->work.rate;
  const arc_status status = arc_wear_evaluate(w, window, watch, rate, error);
  if (status == ARC_OK) depths_of_rate(w, rate, dose, depth);
  return status;
}

/* Every increment of a cycle with an update of its own (Eq. 4 with p_{i-1} of the geometry before).
 */
static arc_status split_update(arc_wear *w, const wear_plan *plan, wear_watch *watch,
                               wear_outcome *out, arc_error *error) {
  const wear_block *b = plan->block;
  arc_wear_record *record = &out->record;
  const double start = record->distance, length = plan->end - start;
  const double solutions = record->solutions;
  wear_depths *depth = &w->work.depth;
  double gone = 0;
  for (int i = 0; i + 1 < b->count; i++) {
    const double part = b->repeat * fabs(b->x[i + 1] - b->x[i]) / b->sliding * length;
    const double from = start + gone;
    arc_wear_record middle = *record;
    middle.distance = from + part / 2;
    wear_dose dose = {.cycles = plan->cycles};
    const wear_window window = {
        .shape = out->shape, .first = i, .last = i + 1, .chained = i > 0, .state = &middle};
    arc_status status = arc_wear_coefficients(w, from, from + part, &middle, dose.k, error);
    if (status == ARC_OK) status = find_depths(w, plan, &window, &dose, watch, depth, error);
    if (status == ARC_OK) status = apply(w, depth, out, error);
    if (status != ARC_OK) return status;
    gone += part;
    record->distance = start + gone;
    record->solutions = solutions + watch->solutions;
    record->depth_cylinder = arc_shape_depth(out->shape, ARC_CYLINDER);
    record->depth_plate = arc_shape_depth(out->shape, ARC_PLATE);
    arc_wear_note_coefficients(dose.k, record);
  }
  return ARC_OK;
}

/* alpha = 0 over the whole plate: the load is all that counts. */
static void closed_form(const arc_wear *w, const wear_dose *dose, wear_depths *depth) {
  memset(depth->node[0], 0, (size_t)(w->nc + w->np) * sizeof(double));
  depth->even = dose->cycles * dose->k[ARC_PLATE] * w->block[0].line[0];
  depth->error = depth->peak = 0;
}

static arc_status whole_update(arc_wear *w, const wear_plan *plan, wear_watch *watch,
                               wear_outcome *out, arc_error *error) {
  const int generic = !plan->block->periodic, closed = arc_wear_closed_form(w);
  const int rated = arc_wear_has_state_functions(w) && !closed;
  const double from = out->record.distance;
  wear_rate *rate = &w->work.rate;
  wear_depths *depth = &w->work.depth;
  arc_wear_record middle = out->record;
  const wear_window window = {.shape = out->shape,
                              .first = generic ? plan->first : 0,
                              .last = generic ? plan->first + 1 : plan->block->count - 1,
                              .state = &middle};
  wear_dose dose = {.cycles = plan->times};
  arc_status status = ARC_OK;
  if (rated) status = arc_wear_evaluate(w, &window, watch, rate, error);
  if (status == ARC_OK && rated) status = predict_middle(w, plan, rate, &middle, error);
  if (!rated) middle = on_the_way(w, plan, 0.5);
  if (status == ARC_OK) status = arc_wear_coefficients(w, from, plan->end, &middle, dose.k, error);
  if (status != ARC_OK) return status;
  arc_wear_note_coefficients(dose.k, &out->record);
  if (closed)
    closed_form(w, &dose, depth);
  else if (rated && is_explicit(w, plan) && !w->def.local_factor)
    depths_of_rate(w, rate, &dose, depth); /* the rate at the start serves twice */
  else
    status = find_depths(w, plan, &window, &dose, watch, depth, error);
  return status == ARC_OK ? apply(w, depth, out, error) : status;
}

arc_status arc_wear_update(arc_wear *w, const wear_plan *plan, wear_watch *watch, wear_outcome *out,
                           arc_error *error) {
  const int split =
      w->def.update == ARC_UPDATE_INCREMENT && plan->block->periodic && w->procedure == ARC_SP;
  const arc_status status =
      split ? split_update(w, plan, watch, out, error) : whole_update(w, plan, watch, out, error);
  out->record.update += split ? plan->block->count - 1 : 1;
  return status;
}

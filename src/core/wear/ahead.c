/* What a rate takes in a dose, and the state on the way through an update that it predicts. */
#include "archard/measure.h"
#include "core/wear/step.h"

#include <math.h>

void arc_wear_add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                          arc_wear_record *record) {
  const arc_model_def *md = arc_model_definition(w->model);
  double sum[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < shape->side[b].n; i++)
      sum[b] += depth->node[b][i] * arc_shape_span(shape, (arc_body)b, i);
  record->volume_cylinder += sum[ARC_CYLINDER] * md->thickness;
  record->volume_plate += (sum[ARC_PLATE] + depth->even * 2 * md->radius) * md->thickness;
}

void arc_wear_depths_of_rate(const arc_wear *w, const wear_rate *rate, const wear_dose *dose,
                             wear_depths *depth) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const double scale = b == ARC_PLATE && w->procedure == ARC_NSP ? 0 : dose->cycles * dose->k[b];
    for (int i = 0; i < w->shape->side[b].n; i++) depth->node[b][i] = scale * rate->node[b][i];
  }
  depth->even = wears_evenly(w) ? dose->cycles * dose->k[ARC_PLATE] * rate->even : 0;
  depth->error = 0;
  depth->peak = rate->peak;
}

arc_wear_record arc_wear_on_the_way(arc_wear *w, const wear_plan *plan, double share,
                                    const wear_rate *rate, const wear_dose *dose) {
  arc_wear_record state = *arc_wear_last(w);
  state.distance += share * (plan->end - state.distance);
  state.cycle += share * plan->cycles;
  arc_wear_note_motion(w, plan->block, plan->first, &state);
  if (!rate) return state;
  wear_depths *depth = &w->work.depth;
  double *deepest[ARC_BODIES] = {&state.depth_cylinder, &state.depth_plate};
  arc_wear_depths_of_rate(w, rate, dose, depth);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double even = b == ARC_PLATE ? depth->even : 0, *h = w->shape->side[b].h;
    for (int i = 0; i < w->shape->side[b].n; i++)
      *deepest[b] = fmax(*deepest[b], h[i] + depth->node[b][i] + even);
  }
  arc_wear_add_volumes(w, w->shape, depth, &state);
  state.depth_partition = arc_depth_partition(state.depth_cylinder, state.depth_plate);
  return state;
}

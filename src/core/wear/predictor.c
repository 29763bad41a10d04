/* Depths of a rate over a dose, and the predicted state within an update. */
#include "archard/measure.h"
#include "core/wear/step.h"

#include <math.h>

void arc_wear_depths_of_rate(const arc_wear *w, const wear_rate *rate, const wear_dose *dose,
                             wear_depths *depth) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const double scale = dose->cycles * sites_k(w, dose->k, b);
    for (int i = 0; i < sites_of(w, b); i++) depth->node[b][i] = scale * rate->node[b][i];
  }
  depth->even = w->manner.even ? dose->cycles * dose->k[ARC_PLATE] * rate->even : 0;
  depth->error = 0;
  depth->peak = rate->peak;
  depth->energy = dose->cycles * rate->energy;
  depth->pressed = dose->cycles * rate->pressed;
}

/* --- what is measured --------------------------------------------------------------------------
 */

/* Wear [mm3/N] between a state and the previous one. */
static double dose_to(const arc_wear_record *state, const arc_wear_record *before) {
  return state->k * (state->distance - before->distance);
}

/* Three states and the wear between them; unknown states are NULL. */
typedef struct course {
  const arc_wear_record *before, *now, *ahead;
  double since, to; /* [mm3/N] */
} course;

static course course_of(const arc_wear *w, const wear_plan *plan) {
  course c = {.now = arc_wear_last(w), .ahead = plan->ahead};
  if (w->records > 1) c.since = dose_to(c.now, c.now - 1);
  if (c.since > 0) c.before = c.now - 1;
  if (c.ahead) c.to = dose_to(c.ahead, c.now);
  if (!(c.to > 0)) c.ahead = NULL;
  return c;
}

/* Interpolates a quantity at `wear` [mm3/N]: by the parabola through three monotonic states;
 * without a state ahead, by extrapolation with a decreasing rate. */
static double on_course(const course *c, int column, double wear) {
  const double now = arc_wear_record_get(c->now, column);
  const double slope = c->before ? (now - arc_wear_record_get(c->before, column)) / c->since : 0;
  if (!c->before && !c->ahead) return now;
  if (!c->ahead) return fmax(now / 2, now + slope * wear / (1 + wear / c->since));
  const double rise = (arc_wear_record_get(c->ahead, column) - now) / c->to;
  const double bend = slope * rise > 0 ? (rise - slope) / (c->since + c->to) : 0;
  return now + rise * wear + bend * wear * (wear - c->to);
}

/* Pressures and widths of an intermediate state, and with a state ahead the depths. */
static void follow_course(const arc_wear *w, const wear_plan *plan, double wear,
                          arc_wear_record *state) {
  const course c = course_of(w, plan);
  state->p_center = on_course(&c, ARC_WEAR_COLUMN_p_center, wear);
  state->p_max = on_course(&c, ARC_WEAR_COLUMN_p_max, wear);
  state->half_width = on_course(&c, ARC_WEAR_COLUMN_half_width, wear);
  if (!c.ahead) return;
  state->depth_cylinder = on_course(&c, ARC_WEAR_COLUMN_depth_cylinder, wear);
  state->depth_plate = on_course(&c, ARC_WEAR_COLUMN_depth_plate, wear);
}

int arc_wear_follows(const arc_wear *w, const wear_plan *plan) {
  return arc_wear_has_state_functions(w) && plan->block->periodic &&
         (plan->staged || w->def.scheme == ARC_IMPLICIT);
}

arc_wear_record arc_wear_on_the_way(arc_wear *w, const wear_plan *plan, double share,
                                    const wear_rate *rate, const wear_dose *dose) {
  arc_wear_record state = *arc_wear_last(w);
  state.distance += share * (plan->end - state.distance);
  state.cycle += share * plan->cycles;
  arc_wear_note_motion(w, plan->block, plan->first, &state);
  if (!rate || !dose) return state;
  wear_depths *depth = &w->work.depth;
  double *deepest[ARC_BODIES] = {&state.depth_cylinder, &state.depth_plate};
  arc_wear_depths_of_rate(w, rate, dose, depth);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double even = b == ARC_PLATE && w->def.track == 0 ? depth->even : 0,
                 *h = w->kind->sites(w->shape, (arc_body)b).h;
    for (int i = 0; i < sites_of(w, b); i++)
      *deepest[b] = fmax(*deepest[b], h[i] + depth->node[b][i] + even);
  }
  w->kind->add_volumes(w, w->shape, depth, &state);
  const double k = dose->k[ARC_CYLINDER] + dose->k[ARC_PLATE];
  if (arc_wear_follows(w, plan))
    follow_course(w, plan, dose->cycles * k * plan->block->sliding, &state);
  state.depth_partition = arc_depth_partition(state.depth_cylinder, state.depth_plate);
  return state;
}

arc_status arc_wear_friction_on_the_way(arc_wear *w, const wear_dose *dose, double share,
                                        double *mu, arc_error *error) {
  static const double last = 1 - 1e-7; /* what jumps at the end is the next update's */
  if (!dose->plan) return ARC_OK;
  const wear_rate *rate = w->def.friction_function ? &w->start.rate : NULL;
  const wear_dose gone = {share * dose->cycles, {dose->k[0], dose->k[1]}, {0}, NULL, 0, 0};
  const arc_wear_record state = arc_wear_on_the_way(w, dose->plan, fmin(share, last), rate, &gone);
  return arc_wear_friction(w, &state, mu, error);
}

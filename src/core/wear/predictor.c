/* Computes the depths that a wear rate causes in an update, and predicts states within an
 * update. */
#include "archard/measure.h"
#include "core/wear/step.h"

#include <math.h>

void arc_wear_depths_of_rate(const arc_wear *w, const wear_rate *rate,
                             const update_coefficients *coefficients, wear_depths *depth) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const double scale = coefficients->cycles * sites_k(w, coefficients->mean.k, b);
    for (int i = 0; i < sites_of(w, b); i++) depth->node[b][i] = scale * rate->node[b][i];
  }
  depth->even =
      w->manner.even ? coefficients->cycles * coefficients->mean.k[ARC_PLATE] * rate->even : 0;
  depth->error = 0;
  depth->peak = rate->peak;
  depth->energy = coefficients->cycles * rate->energy;
  depth->pressed = coefficients->cycles * rate->pressed;
}

/* --- prediction of measured quantities */

/* Returns the integral of k over the distance [mm3/N] from the state `before` to the next state. */
static double k_integral_to(const arc_wear_record *state, const arc_wear_record *before) {
  return state->k * (state->distance - before->distance);
}

/* The previous, the present and the predicted final state of an update, and the integrals of k
 * between them. A state that is not available is NULL. */
typedef struct course {
  const arc_wear_record *before, *now, *end_state;
  double since, to; /* [mm3/N] integral of k from `before` to `now`, and from `now` to
                     * `end_state` */
} course;

static course course_of(const arc_wear *w, const wear_plan *plan) {
  course c = {.now = arc_wear_last(w), .end_state = plan->end_state};
  if (w->records > 1) c.since = k_integral_to(c.now, c.now - 1);
  if (c.since > 0) c.before = c.now - 1;
  if (c.end_state) c.to = k_integral_to(c.end_state, c.now);
  if (!(c.to > 0)) c.end_state = NULL;
  return c;
}

/* Returns the predicted value of a column where the integral of k over the distance from the
 * present state equals `wear` [mm3/N]. The value is interpolated by the parabola through the three
 * states, or by a line if they are not monotonic. Without a final state it is extrapolated with a
 * decreasing slope. */
static double on_course(const course *c, int column, double wear) {
  const double now = arc_wear_record_get(c->now, column);
  const double slope = c->before ? (now - arc_wear_record_get(c->before, column)) / c->since : 0;
  if (!c->before && !c->end_state) return now;
  if (!c->end_state) return fmax(now / 2, now + slope * wear / (1 + wear / c->since));
  const double rise = (arc_wear_record_get(c->end_state, column) - now) / c->to;
  const double bend = slope * rise > 0 ? (rise - slope) / (c->since + c->to) : 0;
  return now + rise * wear + bend * wear * (wear - c->to);
}

/* Predicts the pressures and the half width of an intermediate state. Predicts the depths too if
 * the plan has a final state. */
static void follow_course(const arc_wear *w, const wear_plan *plan, double wear,
                          arc_wear_record *state) {
  const course c = course_of(w, plan);
  state->p_center = on_course(&c, ARC_WEAR_COLUMN_p_center, wear);
  state->p_max = on_course(&c, ARC_WEAR_COLUMN_p_max, wear);
  state->half_width = on_course(&c, ARC_WEAR_COLUMN_half_width, wear);
  if (!c.end_state) return;
  state->depth_cylinder = on_course(&c, ARC_WEAR_COLUMN_depth_cylinder, wear);
  state->depth_plate = on_course(&c, ARC_WEAR_COLUMN_depth_plate, wear);
}

int arc_wear_follows(const arc_wear *w, const wear_plan *plan) {
  return arc_wear_has_state_functions(w) && plan->block->periodic &&
         (plan->staged || w->def.scheme == ARC_IMPLICIT);
}

arc_wear_record arc_wear_state_within(arc_wear *w, const wear_plan *plan, double share,
                                      const wear_rate *rate,
                                      const update_coefficients *coefficients) {
  arc_wear_record state = *arc_wear_last(w);
  state.distance += share * (plan->end - state.distance);
  state.cycle += share * plan->cycles;
  arc_wear_note_motion(w, plan->block, plan->first, &state);
  if (!rate || !coefficients) return state;
  wear_depths *depth = &w->work.depth;
  double *deepest[ARC_BODIES] = {&state.depth_cylinder, &state.depth_plate};
  arc_wear_depths_of_rate(w, rate, coefficients, depth);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double even = b == ARC_PLATE && w->def.track == 0 ? depth->even : 0,
                 *h = w->kind->sites(w->shape, (arc_body)b).h;
    for (int i = 0; i < sites_of(w, b); i++)
      *deepest[b] = fmax(*deepest[b], h[i] + depth->node[b][i] + even);
  }
  w->kind->add_volumes(w, w->shape, depth, &state);
  const double k = coefficients->mean.k[ARC_CYLINDER] + coefficients->mean.k[ARC_PLATE];
  if (arc_wear_follows(w, plan))
    follow_course(w, plan, coefficients->cycles * k * plan->block->sliding, &state);
  state.depth_partition = arc_depth_partition(state.depth_cylinder, state.depth_plate);
  return state;
}

arc_status arc_wear_friction_within(arc_wear *w, const update_coefficients *coefficients,
                                    double share, double *mu, arc_error *error) {
  static const double last = 1 - 1e-7; /* largest fraction that is evaluated, because a jump at the
                                          end belongs to the next update */
  if (!coefficients->plan) return ARC_OK;
  const wear_rate *rate = w->def.friction_function ? &w->start.rate : NULL;
  const update_coefficients gone = {.cycles = share * coefficients->cycles,
                                    .mean = coefficients->mean};
  const arc_wear_record state =
      arc_wear_state_within(w, coefficients->plan, fmin(share, last), rate, &gone);
  return arc_wear_friction(w, &state, mu, error);
}

/* Chooses the length of a step: the smallest of the jump, the remaining part of the block, and the
 * distance to the limit. */
#include "core/wear/step.h"

#include <math.h>

/* A remaining distance shorter than this fraction of the whole distance is a rounding error. */
static const double rounding = 1e-12;
/* Relative tolerance within which a step is extended or shortened to end with its block. */
static const double whole = 1e-9;

/* --- lengths of updates */

/* Returns the integral of k over the distance [mm3/N] that causes the wear depth `depth` [mm] at
 * the present pressure in the centre of the contact. */
static double k_integral_for(const arc_wear *w, double depth) {
  const double p = arc_wear_last(w)->p_center;
  return p > 0 ? depth / p : INFINITY;
}

/* Returns the number of cycles over which k, integrated over the distance, reaches k_integral
 * [mm3/N]. */
static double cycles_for(const wear_block *block, const double k[ARC_BODIES], double k_integral) {
  const double per_cycle = (k[ARC_CYLINDER] + k[ARC_PLATE]) * block->sliding;
  return per_cycle > 0 ? k_integral / per_cycle : INFINITY;
}

/* Largest wear of an update. It is a fraction of the natural depth (the scale of elastic
 * displacements) in the first updates, and of the present depth in later updates. */
static const double first_depth = 0.15, later_depth = 0.05;
/* Largest wear of the first implicit update, which has no error estimate, as a fraction of the
 * natural depth. */
static const double first_implicit_depth = 0.06;
/* Length of automatic updates of one stage, as a fraction of the stability limit 2 / eigenvalue. */
static const double safe_share = 0.6;

static double total_depth(const arc_wear *w) {
  const arc_wear_record *now = arc_wear_last(w);
  return now->depth_cylinder + now->depth_plate;
}

/* Returns the largest wear of an automatic update, as the sum of both bodies [mm]. */
static double depth_limit(const arc_wear *w) {
  return fmax(first_depth * w->kind->natural_depth(w), later_depth * total_depth(w));
}

/* --- uniform wear */

/* Returns true if the plate wears uniformly and no other wear occurs. Uniform wear changes the
 * contact only because layers become thinner. */
static int only_evenly(const arc_wear *w) {
  return w->manner.even && arc_wear_last(w)->alpha == 0;
}

static double layer_k_integral(const arc_wear *w, int scars) {
  return w->kind->layer_k_integral ? w->kind->layer_k_integral(w, scars) : INFINITY;
}

/* Returns the largest integral of k over the distance of an update [mm3/N] if only uniform wear
 * occurs. It does not depend on the pressure in the contact. */
static double most_evenly(const arc_wear *w) {
  return fmin(w->kind->even_k_integral(w, depth_limit(w)), layer_k_integral(w, 0));
}

int arc_wear_plan_is_short(const arc_wear *w, const wear_plan *plan) {
  static const double little = 0.01;
  const arc_wear_record *now = arc_wear_last(w);
  return now->k * (plan->end - now->distance) * now->p_max < little * depth_limit(w);
}

/* Plans an update of one stage. Its length is limited by stability and by the wear of an update. */
static arc_status plan_plain(arc_wear *w, const arc_callbacks *callbacks, wear_plan *plan,
                             arc_error *error) {
  double k[ARC_BODIES], eigenvalue = 0;
  plan->most = only_evenly(w) ? most_evenly(w) : k_integral_for(w, depth_limit(w));
  if (w->manner.closed) return ARC_OK;
  arc_status status = arc_wear_coefficients_now(w, k, error);
  if (status == ARC_OK) status = arc_wear_stability(w, callbacks, &eigenvalue, error);
  if (status == ARC_OK && eigenvalue > 0)
    plan->most = fmin(plan->most, safe_share * 2 / eigenvalue * (k[ARC_CYLINDER] + k[ARC_PLATE]) *
                                      plan->block->sliding);
  return status;
}

/* Returns the largest integral of k over the distance of an update in stages [mm3/N], from the
 * estimated error of the last update. The value depends only on the history, so a stored run
 * continues with the same steps. */
static double most_staged(const arc_wear *w) {
  static const double growth = 3, fall = 0.2, safety = 0.9;
  const arc_wear_record *now = arc_wear_last(w);
  if (w->records < 2 || !(now->error > 0))
    return k_integral_for(w, first_depth * w->kind->natural_depth(w));
  const double last = now->k * (now->distance - now[-1].distance);
  return last * fmin(growth, fmax(fall, safety / cbrt(now->error)));
}

/* Plans an automatic explicit update. */
static arc_status plan_automatic(arc_wear *w, const arc_callbacks *callbacks, wear_plan *plan,
                                 arc_error *error) {
  if (splits_cycles(w) || w->manner.closed) return plan_plain(w, callbacks, plan, error);
  plan->staged = 1;
  plan->most = only_evenly(w) ? most_evenly(w) : fmin(most_staged(w), layer_k_integral(w, 1));
  return ARC_OK;
}

/* Returns true if the last step removed no material. This happens when wear in partial slip has
 * ended. */
static int removed_nothing(const arc_wear *w) {
  const arc_wear_record *now = arc_wear_last(w);
  return w->records > 1 && now->volume_cylinder == now[-1].volume_cylinder &&
         now->volume_plate == now[-1].volume_plate;
}

/* Returns the sliding distance of a cycle in the last step, divided by that of the next step. It is
 * exactly 1 within a block. */
static double cycle_ratio(const arc_wear *w, const wear_block *block) {
  const arc_wear_record *now = arc_wear_last(w);
  const int within = now->cycle > block->start_cycle * (1 + whole);
  if (w->records < 2 || within || !(now->jump > 0)) return 1;
  return (now->distance - now[-1].distance) / now->jump / block->sliding;
}

/* Computes the length of the next adaptive step [cycles] from the estimated errors of the last
 * steps. The length depends only on the history, so a stored run continues with the same steps. */
static arc_status adaptive_jump(const arc_wear *w, const wear_block *block, double *jump,
                                arc_error *error) {
  static const double most_growth = 2, least_growth = 0.2, safety = 0.85;
  const arc_wear_record *now = arc_wear_last(w);
  double k[ARC_BODIES];
  const arc_status status = arc_wear_coefficients_now(w, k, error);
  if (status != ARC_OK) return status;
  if (now->error > 0) {
    const double order = w->def.order == 1 ? 2 : 3;
    const double growth = safety * pow(now->error, -1 / order);
    const double before = w->records > 2
                              ? now[-1].jump
                              : 0; /* jump before the last one, which may have been shortened */
    *jump = fmin(most_growth * fmax(now->jump, before), now->jump * fmax(least_growth, growth)) *
            cycle_ratio(w, block);
  } else {
    *jump = cycles_for(block, k,
                       only_evenly(w)
                           ? most_evenly(w)
                           : k_integral_for(w, first_implicit_depth * w->kind->natural_depth(w)));
    if (removed_nothing(w)) *jump = fmax(*jump, most_growth * now->jump);
  }
  *jump = fmin(*jump, cycles_for(block, k, layer_k_integral(w, 1)));
  return ARC_OK;
}

int arc_wear_has_own_steps(const arc_wear *w) {
  return w->def.scheme == ARC_EXPLICIT && !w->def.jump_function &&
         arc_law_properties[w->def.law] & ARC_LAW_JUMPS;
}

static arc_status choose_jump(arc_wear *w, const arc_callbacks *callbacks, wear_plan *plan,
                              double *jump, arc_error *error) {
  const int own = arc_wear_has_own_steps(w);
  *jump = INFINITY;
  if (w->def.scheme == ARC_IMPLICIT && w->def.tolerance > 0)
    return adaptive_jump(w, plan->block, jump, error);
  if (own && w->def.jump > 0)
    *jump = w->def.jump; /* upper limit of the length of updates in stages */
  if (arc_wear_jump_is_auto(&w->def) || own) return plan_automatic(w, callbacks, plan, error);
  *jump = w->def.jump;
  if (!w->def.jump_function) return ARC_OK;
  return arc_wear_evaluate_function(w, &arc_wear_settings[ARC_AT_jump], w->def.jump_function,
                                    arc_wear_last(w), jump, error);
}

/* Returns the largest distance at the end of the step [mm]: the limit of the run or the end of
 * the block. */
static double bound(const arc_wear *w, const wear_block *block, double limit) {
  return block == &w->block[w->blocks - 1] && block->periodic
             ? limit
             : fmin(limit, arc_wear_block_end(block));
}

/* Plans a step of a loading that runs once: to the end of the present increment, but not beyond the
 * distance `limit` [mm]. */
static void plan_increment(const arc_wear *w, double limit, wear_plan *plan) {
  const arc_wear_record *now = arc_wear_last(w);
  const wear_block *b = plan->block;
  const int increments = b->count - 1;
  const double at = (now->cycle - b->start_cycle) * increments;
  plan->first = (int)floor(at + whole);
  if (plan->first >= increments) plan->first = increments - 1;
  const double done = fmax(0, at - plan->first);
  const double length = fabs(b->x[plan->first + 1] - b->x[plan->first]);
  plan->times = 1 - (done < whole ? 0 : done);
  plan->end = now->distance + plan->times * length;
  if (plan->first == increments - 1) plan->end = arc_wear_block_end(b);
  if (plan->end > limit && length > 0) {
    plan->times = (limit - now->distance) / length;
    plan->end = limit;
  }
  plan->cycles = plan->times / increments;
}

void arc_wear_plan_shorten(const arc_wear *w, wear_plan *plan, double cycles) {
  const double share = cycles / plan->cycles, from = arc_wear_last(w)->distance;
  plan->end = from + share * (plan->end - from);
  plan->times *= share;
  plan->cycles = cycles;
}

/* Returns ARC_NOT_CONVERGED if the last steps made almost no progress, because the run would not
 * end. */
static arc_status check_progress(const arc_wear *w, const wear_plan *plan, double limit,
                                 arc_error *error) {
  enum { many = 30 };
  static const double nothing = 1e-12; /* smallest progress, relative to the remaining distance */
  if (!plan->block->periodic || w->records <= many) return ARC_OK;
  const arc_wear_record *now = arc_wear_last(w);
  const double gone = now->distance - (now - many)->distance, left = limit - now->distance;
  if (gone > nothing * left) return ARC_OK;
  return arc_fail(error, ARC_NOT_CONVERGED,
                  "field 'jump': the last %d steps, to %.6g mm, advanced %.3g mm in total; %.6g mm "
                  "remain, so the run would not end; use longer steps if a jump is set, or make a "
                  "law, a coefficient or a factor that jumps there continuous",
                  many, now->distance, gone, left);
}

int arc_wear_can_move(const arc_wear *w, double limit) {
  const arc_wear_record *now = arc_wear_last(w);
  const wear_block *block = arc_wear_block_at(w, now->cycle);
  const int finished = !block->periodic && block == &w->block[w->blocks - 1] &&
                       now->cycle >= block->start_cycle + 1 - whole;
  return !finished && (limit - now->distance) > rounding * (limit + block->sliding);
}

arc_status arc_wear_plan_step(arc_wear *w, double limit, const arc_callbacks *callbacks,
                              wear_plan *plan, int *moved, arc_error *error) {
  const arc_wear_record *now = arc_wear_last(w);
  plan->block = arc_wear_block_at(w, now->cycle);
  plan->most = INFINITY;
  const double end = bound(w, plan->block, limit),
               left = (end - now->distance) / plan->block->sliding;
  *moved = arc_wear_can_move(w, limit);
  if (!*moved) return ARC_OK;
  const arc_status status = check_progress(w, plan, limit, error);
  if (status != ARC_OK) return status;
  if (!plan->block->periodic) {
    plan_increment(w, limit, plan);
    return ARC_OK;
  }
  double jump;
  const arc_status chosen = choose_jump(w, callbacks, plan, &jump, error);
  if (chosen != ARC_OK) return chosen;
  const int to_end = left <= jump * (1 + whole);
  plan->cycles = plan->times = left < jump * (1 - whole) ? left : jump;
  plan->end = to_end ? end : now->distance + plan->cycles * plan->block->sliding;
  return ARC_OK;
}

/* Integrates the coefficients of wear and friction over a planned update. The method is a
 * Runge-Kutta pair of orders 3 and 2 (Bogacki and Shampine). Its steps end at the points of tables.
 * Between these points k, alpha and friction are linear, so the integrals are exact. Functions of
 * the state are evaluated along the path predicted from the rate at the start. If the step length
 * decreases towards zero, a coefficient jumps, and the update ends at the jump. This file uses
 * coefficient.c and predictor.c. */
#include "core/wear/step.h"

#include <math.h>
#include <string.h>

/* Relative tolerance of the integral over a step. */
static const double tolerance = 1e-5;
/* Lengths as fractions of the update. A step that would have to be shorter than `shortest` contains
 * a jump. Functions are not evaluated closer than `margin` to the ends of the update, so that a
 * jump at an end belongs to one update only. */
static const double shortest = 1e-9, margin = 1e-7;
/* Tables are not evaluated closer than this fraction of the update to the ends of the update. */
static const double table_margin = 1e-10;
/* Functions are evaluated just before a table point, which may be a discontinuity. */
static const double before_point = 1 - 1e-9;
/* Definition of a jump in a table: the value changes by more than `large` times the larger value
 * within one interval, and both neighbouring intervals are more than `steep` times as long as this
 * one. */
static const double large = 0.1, steep = 20;
/* Minimum number of steps of an update whose length is fixed, and of an update whose length is
 * unknown. */
static const double chosen_steps = 4, open_steps = 64;
/* The update ends when the integral of k equals the largest value of the plan within this relative
 * tolerance. */
static const double near = 1e-3;
/* Minimum number of samples of a function per cycle or, in long runs, per run. They are needed
 * because the error estimate does not include changes between samples. The number per cycle is not
 * an integer, to avoid aliasing. */
static const double per_cycle = 1.618, per_run = 3236;
/* If rejected steps outnumber accepted steps by this number, no step length resolves the function
 * (for example a random function). The function is then sampled in equal steps. */
enum { most_refused = 200 };

/* Components of the integrated vector: k of the cylinder, k of the plate, friction. */
enum { FRICTION = ARC_BODIES, COMPONENTS };

typedef struct integration {
  arc_wear *w;
  const wear_plan *plan;
  const wear_rate *rate;
  arc_error *error;
  double length;        /* sliding distance of the plan [mm] */
  double at;            /* fraction of the update that has been integrated */
  double y[COMPONENTS]; /* integrals of k [mm2/N] and of friction over the fraction `at` */
  double k[COMPONENTS]; /* coefficients at `at` */
  double first[COMPONENTS];
  int calls, changed[COMPONENTS]; /* number of evaluations; 1 if any value of the coefficient
                                     differed from `first` */
  int refused;                    /* number of rejected minus accepted steps */
  int sampled;                    /* 1 if no step could resolve the function */
} integration;

/* Returns the value to which errors of component b of the coefficients k are relative. */
static double size_of(int b, const double k[COMPONENTS]) {
  return b == FRICTION ? k[b] : fmax(k[ARC_CYLINDER], k[ARC_PLATE]);
}

static wear_coefficients from_vector(const double v[COMPONENTS]) {
  return (wear_coefficients){{v[ARC_CYLINDER], v[ARC_PLATE]}, v[FRICTION]};
}

static double total(const double k[COMPONENTS]) {
  return k[ARC_CYLINDER] + k[ARC_PLATE];
}

/* Computes the coefficients k at the fraction `share` (0 to 1) of the update. y contains the
 * integrals up to this fraction. */
static arc_status evaluate(integration *s, double share, const double y[COMPONENTS],
                           double k[COMPONENTS]) {
  const update_coefficients gone = {.cycles = s->plan->times, .mean = from_vector(y)};
  const double off = arc_wear_has_state_functions(s->w) ? margin : table_margin;
  const double inside = fmin(fmax(share, off), 1 - off);
  const arc_wear_record state = arc_wear_state_within(s->w, s->plan, inside, s->rate, &gone);
  arc_status status =
      arc_wear_coefficients(s->w, state.distance, state.distance, &state, k, s->error);
  if (status == ARC_OK) status = arc_wear_friction_of(s->w, &state, &k[FRICTION], s->error);
  if (status != ARC_OK) return status;
  if (s->calls++ == 0) memcpy(s->first, k, sizeof s->first);
  for (int b = 0; b < COMPONENTS; b++) s->changed[b] |= k[b] != s->first[b];
  return ARC_OK;
}

/* Makes one step of the Runge-Kutta pair over the fraction h of the update. Computes the integrals
 * y and the coefficients k at the end of the step, and the estimated error divided by the
 * tolerance. */
static arc_status try_step(integration *s, double h, double y[COMPONENTS], double k[COMPONENTS],
                           double *error) {
  const double *k1 = s->k;
  double k2[COMPONENTS], k3[COMPONENTS], on[COMPONENTS];
  for (int b = 0; b < COMPONENTS; b++) on[b] = s->y[b] + h / 2 * k1[b];
  arc_status status = evaluate(s, s->at + h / 2, on, k2);
  if (status != ARC_OK) return status;
  for (int b = 0; b < COMPONENTS; b++) on[b] = s->y[b] + 3 * h / 4 * k2[b];
  if ((status = evaluate(s, s->at + 3 * h / 4, on, k3)) != ARC_OK) return status;
  for (int b = 0; b < COMPONENTS; b++) y[b] = s->y[b] + h * (2 * k1[b] + 3 * k2[b] + 4 * k3[b]) / 9;
  if ((status = evaluate(s, s->at + h * before_point, y, k)) != ARC_OK) return status;
  *error = 0;
  for (int b = 0; b < COMPONENTS; b++) {
    const double scale =
        fmax(fmax(size_of(b, k1), size_of(b, k2)), fmax(size_of(b, k3), size_of(b, k)));
    const double off = fabs(-5 * k1[b] / 72 + k2[b] / 12 + k3[b] / 9 - k[b] / 8);
    if (scale > 0) *error = fmax(*error, off / (tolerance * scale));
  }
  return ARC_OK;
}

static void accept_step(integration *s, double at, const double y[COMPONENTS],
                        const double k[COMPONENTS]) {
  s->at = at;
  memcpy(s->y, y, sizeof s->y);
  if (k != s->k) memcpy(s->k, k, sizeof s->k);
}

/* --- end of a step ---------------------------------------------------------------------------- */

static double distance_at(const integration *s, double share) {
  return arc_wear_last(s->w)->distance + share * s->length;
}

/* Returns the next point of a table after s->at, as a fraction of the update. */
static double next_point(const integration *s, const arc_series *table) {
  const double here = distance_at(s, s->at + shortest);
  for (int i = 0; i < table->count; i++)
    if (table->distance[i] > here)
      return (table->distance[i] - arc_wear_last(s->w)->distance) / s->length;
  return 1;
}

/* Returns the fraction of the update at which a step must end: the next point of the tables, or 1.
 * A table is ignored if a function replaces it. */
static double next_end(const integration *s) {
  const arc_wear_def *d = &s->w->def;
  double end = 1;
  if (!d->k_function) end = fmin(end, next_point(s, &d->k_series));
  if (!d->alpha_function) end = fmin(end, next_point(s, &d->alpha_series));
  if (!d->friction_function) end = fmin(end, next_point(s, &d->friction_series));
  return end;
}

/* Returns true if a table jumps in its interval that ends at the fraction `share` of the update. */
static int table_jumps(const integration *s, const arc_series *t, double share, double range) {
  const double end = distance_at(s, share);
  for (int i = 1; i < t->count; i++) {
    const double width = t->distance[i] - t->distance[i - 1];
    if (fabs(t->distance[i] - end) > fmax(1e-6 * width, 1e-12 * end)) continue;
    if (width == 0) return 1;
    const double before = i > 1 ? t->distance[i - 1] - t->distance[i - 2] : INFINITY;
    const double after = i + 1 < t->count ? t->distance[i + 1] - t->distance[i] : INFINITY;
    if (fabs(t->value[i] - t->value[i - 1]) > large * range && steep * width < before &&
        steep * width < after)
      return 1;
  }
  return 0;
}

static double range_of(int b, const double k[COMPONENTS]) {
  return b == FRICTION ? k[b] : total(k);
}

static int ends_jump(const integration *s, double share, double from, const double k[COMPONENTS]) {
  const arc_wear_def *d = &s->w->def;
  if (share < margin * 10 || share > 1 - margin * 10) return 0;
  if (share - from <= 3 * shortest) { /* a discontinuity of a function */
    for (int b = 0; b < COMPONENTS; b++)
      if (fabs(k[b] - s->k[b]) > large * fmax(range_of(b, k), range_of(b, s->k))) return 1;
    return 0;
  }
  return (!d->k_function && table_jumps(s, &d->k_series, share, fmax(total(k), total(s->k)))) ||
         (!d->alpha_function && table_jumps(s, &d->alpha_series, share, 1)) ||
         (!d->friction_function &&
          table_jumps(s, &d->friction_series, share, fmax(k[FRICTION], s->k[FRICTION])));
}

/* --- integration ------------------------------------------------------------------------------ */

/* Returns the length of the first step as a fraction of the update. If the end of the update is
 * unknown, it is estimated from the initial coefficients. */
static double first_length(const integration *s, double longest) {
  const double whole = s->plan->most / (s->length * total(s->k));
  return fmin(longest, whole / chosen_steps);
}

/* Returns the length of the longest step, as a fraction of the update. */
static double longest_step(const integration *s) {
  const arc_wear *w = s->w;
  const double steps = isfinite(s->plan->most) ? open_steps : chosen_steps;
  const double run = w->def.distance - w->block[0].start_distance;
  const double asked = fmax(s->plan->block->sliding / per_cycle, run / per_run) / s->length;
  return fmin(1 / steps, arc_wear_has_state_functions(w) ? asked : 1);
}

/* Integrates the remaining part of the update in equal steps without error control. */
static arc_status sample_rest(integration *s) {
  const int steps = (int)fmax(open_steps, ceil((1 - s->at) / longest_step(s)));
  const double most = s->plan->most / s->length, h = (1 - s->at) / steps;
  s->sampled = 1;
  for (int i = 1; i <= steps; i++) {
    double y[COMPONENTS], k[COMPONENTS], error;
    const arc_status status = try_step(s, h, y, k, &error);
    if (status != ARC_OK) return status;
    const double added = total(y) - total(s->y), left = most - total(s->y);
    const double share = added > left ? left / added : 1;
    for (int b = 0; b < COMPONENTS; b++) y[b] = s->y[b] + share * (y[b] - s->y[b]);
    accept_step(s, i == steps && share == 1 ? 1 : s->at + share * h, y, k);
    if (share < 1) break;
  }
  return ARC_OK;
}

/* Integrates up to the end of the plan, up to the largest integral of the plan, or up to a jump. */
static arc_status integrate(integration *s) {
  const double most = s->plan->most / s->length;
  const double longest = longest_step(s);
  arc_status status = evaluate(s, 0, s->y, s->k);
  double h = status == ARC_OK ? first_length(s, longest) : 0;
  while (status == ARC_OK && s->at < 1) {
    double y[COMPONENTS], k[COMPONENTS], error, end = next_end(s);
    if (s->refused > most_refused) return sample_rest(s);
    h = fmax(fmin(h, longest), shortest);
    if (s->at + h * (1 + 1e-6) < end) end = s->at + h;
    const double length = end - s->at;
    if ((status = try_step(s, length, y, k, &error)) != ARC_OK) return status;
    if (error > 1 && length > 2 * shortest) {
      h = length * fmax(0.1, 0.9 * cbrt(1 / error));
      s->refused++;
      continue;
    }
    if (total(y) > most * (1 + near)) { /* the integral is too large: the step is repeated and ends
                                           at the largest integral */
      h = length * (most - total(s->y)) / (total(y) - total(s->y));
      if (h > shortest) continue;
      return ARC_OK;
    }
    const int jump = ends_jump(s, end, s->at, k);
    accept_step(s, end, y, jump ? s->k : k); /* the jump belongs to the next update */
    s->refused -= s->refused > 0 && length > 3 * shortest;
    if (jump || total(y) >= most * (1 - near)) return ARC_OK;
    h = length * fmin(5, error > 0 ? 0.9 * cbrt(1 / error) : 5);
  }
  return status;
}

static int varies(const arc_wear *w) {
  const arc_wear_def *d = &w->def;
  return d->k_function || d->alpha_function || d->k_series.count > 0 || d->alpha_series.count > 0 ||
         arc_wear_friction_changes(w);
}

/* Computes the length of an update with constant coefficients, without integration. The last two
 * updates of a run have equal lengths. */
static arc_status integrate_constant(integration *s) {
  const arc_status status = evaluate(s, 0, s->y, s->k);
  const double all = s->length * total(s->k), steps = ceil(all / s->plan->most * (1 - near));
  s->at = steps > 2 ? s->plan->most / all : 1 / fmax(steps, 1);
  return status;
}

arc_status arc_wear_integrate_coefficients(arc_wear *w, wear_plan *plan, const wear_rate *rate,
                                           update_coefficients *coefficients, arc_error *error) {
  integration s = {.w = w, .plan = plan, .rate = rate, .error = error};
  s.length = plan->end - arc_wear_last(w)->distance;
  const arc_status status = varies(w) ? integrate(&s) : integrate_constant(&s);
  if (status != ARC_OK) return status;
  double mean[COMPONENTS], last[COMPONENTS];
  for (int b = 0; b < COMPONENTS; b++) {
    mean[b] = s.changed[b] ? s.y[b] / s.at : s.first[b];
    last[b] = s.sampled ? NAN : s.k[b];
  }
  coefficients->mean = from_vector(mean);
  coefficients->last = from_vector(last);
  coefficients->friction_at_start = s.first[FRICTION];
  coefficients->plan = s.changed[FRICTION] ? plan : NULL;
  if (s.at < 1) arc_wear_plan_shorten(w, plan, s.at * plan->cycles);
  coefficients->cycles = plan->times;
  return ARC_OK;
}

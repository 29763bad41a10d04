/* Computes the wear coefficients of the bodies at a time (numbers, tables, functions of the state),
 * and the factors on them at a site (laws, local factors). */
#include "core/wear/run.h"

#include <math.h>

/* Returns the value of a table at a distance [mm], on the line between the two table points around
 * the distance `inside` [mm]. At a jump (two values at the same distance) the second value is used.
 */
static double series_at(const arc_series *s, double distance, double inside) {
  int i = 0;
  while (i < s->count && s->distance[i] <= inside) i++;
  if (i == 0) return s->value[0];
  if (i == s->count) return s->value[s->count - 1];
  const double share = (distance - s->distance[i - 1]) / (s->distance[i] - s->distance[i - 1]);
  return s->value[i - 1] + share * (s->value[i] - s->value[i - 1]);
}

double arc_wear_series(const arc_series *s, double distance) {
  return series_at(s, distance, distance);
}

/* Returns the distance of the first point of a table after `from`, but at most `to`. */
static double next_point(const arc_series *s, double from, double to) {
  for (int i = 0; i < s->count; i++)
    if (s->distance[i] > from) return fmin(to, s->distance[i]);
  return to;
}

typedef struct source {
  const arc_series *series;
  double constant;
} source;

static double value_at(const source *s, double distance, double inside) {
  return s->series->count > 0 ? series_at(s->series, distance, inside) : s->constant;
}

/* Computes the means of k alpha and k (1 - alpha) over the distances from `from` to `to`. k and
 * alpha are linear between points, so Simpson's rule is exact. */
static void average(const source *k, const source *alpha, double from, double to,
                    double mean[ARC_BODIES]) {
  mean[ARC_CYLINDER] = mean[ARC_PLATE] = 0;
  if (!(to > from) || (k->series->count == 0 && alpha->series->count == 0)) {
    const double at = (from + to) / 2, kv = value_at(k, at, at), av = value_at(alpha, at, at);
    mean[ARC_CYLINDER] = kv * av;
    mean[ARC_PLATE] = kv * (1 - av);
    return;
  }
  for (double a = from; a < to;) {
    const double b = fmin(next_point(k->series, a, to), next_point(alpha->series, a, to));
    const double at[3] = {a, (a + b) / 2, b}, weight[3] = {1 / 6.0, 4 / 6.0, 1 / 6.0};
    for (int i = 0; i < 3; i++) {
      const double share = weight[i] * (b - a) / (to - from), kv = value_at(k, at[i], at[1]),
                   av = value_at(alpha, at[i], at[1]);
      mean[ARC_CYLINDER] += share * kv * av;
      mean[ARC_PLATE] += share * kv * (1 - av);
    }
    a = b;
  }
}

arc_status arc_wear_evaluate_function(const arc_wear *w, const arc_setting *what,
                                      arc_state_fn function, const arc_wear_record *state,
                                      double *value, arc_error *error) {
  arc_error why;
  const arc_status status = function(w->def.context, what, state, value);
  if (status != ARC_OK)
    return arc_fail(error, status, "the function for %s failed at distance %g mm", what->name,
                    state->distance);
  if (arc_setting_check_number(what, "", *value, &why) == ARC_OK) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "%s from its function at distance %g mm", why.message,
                  state->distance);
}

int arc_wear_has_state_functions(const arc_wear *w) {
  return w->def.k_function || w->def.alpha_function || w->def.friction_function;
}

arc_status arc_wear_coefficients(const arc_wear *w, double from, double to,
                                 const arc_wear_record *state, double mean[ARC_BODIES],
                                 arc_error *error) {
  static const arc_series none = {0};
  const arc_wear_def *d = &w->def;
  source k = {d->k_function ? &none : &d->k_series, d->k};
  source alpha = {d->alpha_function ? &none : &d->alpha_series, d->alpha};
  arc_status status = ARC_OK;
  if (d->k_function)
    status = arc_wear_evaluate_function(w, &arc_wear_settings[ARC_AT_k], d->k_function, state,
                                        &k.constant, error);
  if (status == ARC_OK && d->alpha_function)
    status = arc_wear_evaluate_function(w, &arc_wear_settings[ARC_AT_alpha], d->alpha_function,
                                        state, &alpha.constant, error);
  if (status == ARC_OK) average(&k, &alpha, from, to, mean);
  return status;
}

arc_status arc_wear_coefficients_now(const arc_wear *w, double k[ARC_BODIES], arc_error *error) {
  const arc_wear_record *now = arc_wear_last(w);
  return arc_wear_coefficients(w, now->distance, now->distance, now, k, error);
}

void arc_wear_note_coefficients(const double k[ARC_BODIES], arc_wear_record *record) {
  record->k = k[ARC_CYLINDER] + k[ARC_PLATE];
  record->alpha = record->k > 0 ? k[ARC_CYLINDER] / record->k : record->alpha;
}

/* law_factor returns the factor by which the law of the run multiplies k at the pressure p [MPa].
 * law_growth returns the derivative d ln(p factor) / d ln p. */
static double law_factor(const arc_wear_def *d, double p) {
  switch (d->law) {
#define LAW_FACTOR(name, word, properties, text, factor, growth)                                   \
  case ARC_##name:                                                                                 \
    return factor;
    ARC_LAW_LIST(LAW_FACTOR)
  }
  return 1;
}

static double law_growth(const arc_wear_def *d, double p) {
  (void)p; /* avoids a warning if no law depends on p */
  switch (d->law) {
#define LAW_GROWTH(name, word, properties, text, factor, growth)                                   \
  case ARC_##name:                                                                                 \
    return growth;
    ARC_LAW_LIST(LAW_GROWTH)
  }
  return 1;
}

double arc_wear_law_slope(const arc_wear *w, double p, double q) {
  if (!(p > 0)) return law_factor(&w->def, 0);
  return q / p * law_growth(&w->def, p);
}

double arc_wear_law(const arc_wear *w, double p) {
  return p * law_factor(&w->def, p);
}

double arc_wear_law_rubbed(const arc_wear *w, double p, double mu) {
  return (arc_law_properties[w->def.law] & ARC_LAW_OF_SHEAR ? mu : 1) * arc_wear_law(w, p);
}

arc_status arc_wear_local(const arc_wear *w, const arc_wear_record *state, arc_body body,
                          const wear_sites *on, const double *p, double *factor, arc_error *error) {
  const arc_wear_def *d = &w->def;
  for (int i = 0; i < on->count; i++) factor[i] = 1;
  if (!d->local_factor) return ARC_OK;
  const arc_status status =
      d->local_factor(d->context, body, on->count, on->x, on->z, p, state, factor);
  if (status != ARC_OK)
    return arc_fail(error, status, "local_factor failed for the %s at distance %g mm",
                    arc_body_name(body), state->distance);
  for (int i = 0; i < on->count; i++)
    if (!(factor[i] >= 0) || !isfinite(factor[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'local_factor': expected a number >= 0, got %g for the %s at x = %g "
                      "mm, p = %g MPa",
                      factor[i], arc_body_name(body), on->x[i], p[i]);
  return ARC_OK;
}

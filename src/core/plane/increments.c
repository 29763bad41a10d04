/* Computes the number of increments that a motion needs. */
#include "core/base/callbacks.h"
#include "core/elastic/contact_estimate.h"
#include "core/plane/cycle.h"

#include <math.h>

double arc_loading_x(const arc_loading *from, const arc_model_def *model, int i) {
  return from->rotation ? arc_model_arc_length(model, from->rotation[i]) : from->x[i];
}

/* Returns the length of an increment [mm] that is short enough for accurate results, see
 * arc_wear_reach. The caller creates `pair` once, because its creation is slow. */
static double reach_of(contact_pair *pair, double load) {
  static const double share = 0.125; /* increment divided by the half width; the errors of centre
                                        pressures are below 1 %, also for short strokes */
  return share * arc_pair_estimate(pair, load).half_width;
}

double arc_wear_reach(const arc_model_def *model, double load) {
  contact_pair pair = arc_model_pair(model);
  return reach_of(&pair, load);
}

/* Returns the sliding distance [mm] from point i - 1 to point i of a loading. It is the distance
 * of the plate plus the distance by which a rotation of the load moves the contact. */
static double sliding_of(const arc_loading *from, const arc_model_def *model, int i) {
  const double sliding = fabs(arc_loading_x(from, model, i) - arc_loading_x(from, model, i - 1));
  if (!from->load_angle) return sliding;
  return sliding + fabs(arc_model_arc_length(model, from->load_angle[i] - from->load_angle[i - 1]));
}

/* Returns the smallest load for which the length of increments is computed. A lower limit is
 * necessary because the contact becomes arbitrarily narrow as the load falls to zero. All loads
 * below 1 % of the mean load together cause less than 1 % of the wear. */
static double least_load(const arc_loading *from, const arc_model_def *model) {
  static const double share = 0.01;
  double sum = 0, whole = 0;
  for (int i = 1; i < from->count; i++) {
    const double sliding = sliding_of(from, model, i);
    sum += sliding * (from->load[i] + from->load[i - 1]) / 2;
    whole += sliding;
  }
  return whole > 0 ? share * sum / whole : 0;
}

static double length_of(contact_pair *pair, const arc_loading *from, double least, int i) {
  const double load = fmax(from->load[i - 1], from->load[i]);
  if (!(load > 0)) return 0;
  return sliding_of(from, pair->def, i) / reach_of(pair, fmax(load, least));
}

/* Returns the number of increments of a loading, and writes the number for each segment to
 * parts[i] unless `parts` is NULL. Each segment is one increment if the user chose the
 * increments, and for NSP. */
double arc_loading_increments(const arc_wear_def *def, const arc_model_def *model,
                              const arc_loading *from, double *parts) {
  enum { of_load = 100 }; /* limit of increments per segment if only the load changes */
  const int stays = def->slide == ARC_SLIDE_Z && !from->load_angle;
  const int follow = def->increments == 0 && arc_wear_choose_procedure(def, model) != ARC_NSP;
  const double least = follow ? least_load(from, model) : 0;
  contact_pair pair = {.def = NULL};
  double count = 0;
  if (follow) pair = arc_model_pair(model);
  for (int i = 1; i < from->count; i++) {
    const double length = follow ? length_of(&pair, from, least, i) : 1;
    double here = fmax(1, ceil(length * (1 - 1e-9)));
    if (stays) here = fmin(here, of_load);
    if (parts) parts[i] = here;
    count += here;
  }
  return count;
}

/* Returns the length of the longest increment, divided by the length that is short enough for
 * accurate results. */
static double longest_increment(const arc_wear *w) {
  const arc_wear_def *d = &w->def;
  contact_pair pair = arc_model_pair(arc_model_definition(w->model));
  double longest = d->blocks > 0 ? 0 : 2 * d->stroke / d->increments / reach_of(&pair, d->load);
  for (int b = 0; b < d->blocks; b++) {
    const arc_loading *from = &d->loading[b];
    const double least = least_load(from, pair.def);
    for (int i = 1; i < from->count; i++) longest = fmax(longest, length_of(&pair, from, least, i));
  }
  return longest;
}

/* Warns if the user chose too few increments. */
void arc_plane_warn_leaps(const arc_wear *w, const arc_callbacks *callbacks) {
  static const double leap = 4; /* limit of the longest increment, as a multiple of the accurate
                                   length */
  const arc_wear_def *d = &w->def;
  if (d->increments == 0 || d->tangential > 0 || w->manner.procedure == ARC_NSP ||
      d->slide == ARC_SLIDE_Z)
    return;
  const double longest = longest_increment(w);
  if (longest <= leap * (1 + 1e-9)) return;
  if (d->blocks > 0)
    arc_warn(callbacks,
             "an increment of the loading is longer than half the contact's half width, and the "
             "computed wear will be wavy; give %.0f times as many points, or increments = \"auto\"",
             ceil(longest));
  else
    arc_warn(
        callbacks,
        "increments = %d: each is longer than half the contact's half width, and the computed wear "
        "will be wavy; use %.0f, or \"auto\"",
        d->increments, 2 * ceil(longest * d->increments / 2 * (1 - 1e-9)));
}

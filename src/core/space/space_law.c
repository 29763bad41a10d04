/* Computes wear that differs from k p ds with rigid slip because of a wear law, local factors or
 * friction: sums over the positions, and linearisation for implicit stages. */
#include "core/space/space_kind.h"

#include <math.h>
#include <stdlib.h>

int arc_space_is_linear(const arc_wear *w, const arc_wear_record *state) {
  return (arc_law_properties[w->def.law] & ARC_LAW_LINEAR) && !(w->def.local_factor && state) &&
         !arc_wear_has_friction(&w->def);
}

/* Workspace of values at the sites of the window. */
typedef struct window_sites {
  double *value; /* [count][window] slip times wear rate of the law times local factor */
  double *at;    /* [window] coordinates of the sites on the body along the motion [mm] */
  double *factor;
} window_sites;

static arc_status add_local(const arc_wear *w, const arc_wear_record *state, const space_shape *s,
                            arc_body body, double at, const double *p, const window_sites *v,
                            double *value, arc_error *error) {
  const int n = space_sites(s, ARC_UPPER);
  const double *x = s->grid->x[ARC_UPPER], *z = s->grid->z[ARC_UPPER];
  const int turned = space_turned(s);
  const wear_sites on = {n, turned ? x : v->at, NULL, turned ? v->at : z};
  for (int i = 0; i < n; i++) v->at[i] = (turned ? z[i] : x[i]) - (body == ARC_LOWER ? at : 0);
  const arc_status status = arc_wear_local(w, state, body, &on, p, v->factor, error);
  for (int i = 0; i < n; i++) value[i] *= v->factor[i];
  return status;
}

static arc_status fill(const arc_wear *w, const arc_wear_record *state, const space_shape *s,
                       const space_path *path, const double *pressure, double mu, arc_body body,
                       const window_sites *v, arc_error *error) {
  const int n = space_sites(s, ARC_UPPER);
  arc_status status = ARC_OK;
  for (int j = 0; j < path->count && status == ARC_OK; j++) {
    const double *p = pressure + (size_t)j * (size_t)n;
    double *value = v->value + (size_t)j * (size_t)n;
    const double *slip = path->slip ? path->slip + (size_t)j * (size_t)n : NULL;
    for (int i = 0; i < n; i++)
      value[i] = p[i] > 0 ? (slip ? slip[i] : 1) * arc_wear_law_rubbed(w, p[i], mu) : 0;
    if (w->def.local_factor && state)
      status = add_local(w, state, s, body, path->position[j].x, p, v, value, error);
  }
  return status;
}

arc_status arc_space_work(const arc_wear *w, const arc_wear_record *state, const space_shape *s,
                          const space_path *path, const double *pressure, double mu, arc_body body,
                          double *work, arc_error *error) {
  const size_t n = (size_t)space_sites(s, ARC_UPPER), all = (size_t)path->count * n;
  window_sites v = {.value = malloc((all + 2 * n) * sizeof *v.value)};
  if (!v.value) return arc_fail(error, ARC_MEMORY, "out of memory for the wear of a cycle");
  v.at = v.value + all;
  v.factor = v.at + n;
  arc_status status = fill(w, state, s, path, pressure, mu, body, &v, error);
  if (status == ARC_OK)
    status = arc_halfspace_sum(s->grid->h, path->position, path->count, v.value, body, work, error);
  free(v.value);
  return status;
}

/* Returns the growth exponent of the linearisation. A law that grows faster than p is replaced by
 * its tangent, so that long steps do not oscillate. All other laws are replaced by the secant,
 * because their tangent is unbounded at small p. */
double arc_space_law_growth(const arc_wear *w) {
  return fmax(1, arc_wear_law_slope(w, 1, 1));
}

/* Computes mean [sites]: the slip of each site of a body, averaged over the positions with their
 * weights. */
static arc_status mean_slip(const space_shape *s, const space_path *path, arc_body body,
                            double *mean, arc_error *error) {
  double weight = 0;
  for (int j = 0; j < path->count; j++) weight += path->position[j].weight;
  const arc_status status =
      arc_halfspace_sum(s->grid->h, path->position, path->count, path->slip, body, mean, error);
  for (int i = 0; i < space_sites(s, (int)body) && status == ARC_OK; i++) mean[i] /= weight;
  return status;
}

arc_status arc_space_linearise(const arc_wear *w, const arc_wear_record *state,
                               const space_shape *s, const space_path *path, const double *pressure,
                               double mu, arc_body body, double *work, double *factor,
                               arc_error *error) {
  const int n = space_sites(s, (int)body);
  const int of_shear = (arc_law_properties[w->def.law] & ARC_LAW_OF_SHEAR) != 0;
  const double growth = arc_space_law_growth(w),
               unloaded = (of_shear ? mu : 1) * arc_wear_law_slope(w, 0, 0);
  double *base = malloc((size_t)n * sizeof *base);
  if (!base) return arc_fail(error, ARC_MEMORY, "out of memory for the wear of a cycle");
  arc_status status = arc_space_work(w, state, s, path, pressure, mu, body, work, error);
  if (status == ARC_OK)
    status =
        arc_halfspace_sum(s->grid->h, path->position, path->count, pressure, body, base, error);
  for (int i = 0; i < n; i++) factor[i] = 1;
  if (status == ARC_OK && path->slip) status = mean_slip(s, path, body, factor, error);
  for (int i = 0; i < n && status == ARC_OK; i++)
    factor[i] = base[i] > 0 ? growth * work[i] / base[i] : unloaded * factor[i];
  free(base);
  return status;
}

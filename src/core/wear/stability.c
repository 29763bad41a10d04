/* Stability of explicit updates: largest eigenvalue of the cycle's wear as a linear map on both
 * surfaces' depths. */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct ripple {
  double *depth[ARC_BODIES]; /* [surface] */
} ripple;

/* Change of p at all nodes when the surfaces are lower by `in`, at one pose. work: [nc + nc + np].
 */
static void pressure_change(const pose *p, const ripple *in, double *work, double *pc, double *pp) {
  double *gap = work, *force = work + p->nc;
  pose_to_cylinder(p, in->depth[ARC_PLATE], gap);
  for (int i = 0; i < p->nc; i++) gap[i] += in->depth[ARC_CYLINDER][i];
  pose_linear(p, gap, force);
  pose_to_plate(p, force, pp);
  for (int i = 0; i < p->nc; i++) pc[i] = force[i] / p->wc[i];
  for (int l = 0; l < p->np; l++) pp[l] /= p->wp[l];
}

/* Share of increment i in the cycle's integral [mm of sliding]. */
static double weight(const arc_wear *w, int i) {
  if (w->poses == 1) return w->strokes * w->def.stroke;
  const double step = w->def.stroke / (w->poses - 1);
  return w->strokes * step * (i == 0 || i == w->poses - 1 ? 0.5 : 1);
}

/* out := -(change of one cycle's wear) for depths `in`. */
static void apply(const arc_wear *w, const ripple *in, ripple *out, double *work) {
  const int n[ARC_BODIES] = {w->reference.nc, w->reference.np};
  double *p[ARC_BODIES] = {work, work + n[0]};
  for (int b = 0; b < ARC_BODIES; b++) memset(out->depth[b], 0, (size_t)n[b] * sizeof(double));
  for (int i = 0; i < w->poses; i++) {
    pressure_change(&w->pose[i], in, work + n[0] + n[1], p[0], p[1]);
    const double share = weight(w, i);
    for (int b = 0; b < ARC_BODIES; b++)
      for (int k = 0; k < n[b]; k++)
        out->depth[b][k] -= wear_coefficient(&w->def, (arc_body)b) * share * p[b][k];
  }
  if (w->procedure == ARC_NSP) memset(out->depth[ARC_PLATE], 0, (size_t)n[1] * sizeof(double));
}

static double norm(const ripple *r, const int n[ARC_BODIES]) {
  double sum = 0;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < n[b]; i++) sum += r->depth[b][i] * r->depth[b][i];
  return sqrt(sum);
}

/* A sawtooth with a slant: neither symmetric nor antisymmetric, the same every time. */
static void fill_sawtooth(ripple *r, const int n[ARC_BODIES]) {
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < n[b]; i++) r->depth[b][i] = (i % 2 ? 1.0 : -1.0) * (1 + (double)i / n[b]);
}

static double power_iteration(const arc_wear *w, ripple *r, ripple *image, double *work) {
  const int n[ARC_BODIES] = {w->reference.nc, w->reference.np};
  double value = 0;
  fill_sawtooth(r, n);
  for (int it = 0; it < 500; it++) {
    const double length = norm(r, n), before = value;
    for (int b = 0; b < ARC_BODIES; b++)
      for (int i = 0; i < n[b]; i++) r->depth[b][i] /= length;
    apply(w, r, image, work);
    value = norm(image, n);
    const ripple swap = *r;
    *r = *image;
    *image = swap;
    if (value == 0 || fabs(value - before) < 1e-7 * value) break;
  }
  return value;
}

/* Poses must hold solutions of the present shape: their factors are the linearisation. */
arc_status arc_wear_stability(arc_wear *w, double *eigenvalue, arc_error *error) {
  *eigenvalue = 0;
  if (w->procedure == ARC_NSP && w->def.alpha == 0) return ARC_OK;
  const size_t nc = (size_t)w->reference.nc, np = (size_t)w->reference.np;
  arc_status status = wear_cycle(w, NULL, NULL, error);
  if (status != ARC_OK) return status;
  double *block = calloc(6 * nc + 5 * np, sizeof *block);
  if (!block) return arc_fail(error, ARC_MEMORY, "out of memory for the stability limit");
  ripple r = {{block, block + nc}}, image = {{block + nc + np, block + 2 * nc + np}};
  *eigenvalue = power_iteration(w, &r, &image, block + 2 * (nc + np));
  free(block);
  return ARC_OK;
}

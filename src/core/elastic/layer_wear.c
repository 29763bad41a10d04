/* Computes the wear coefficients of layered bodies as functions of depth. */
#include "core/elastic/layer_wear.h"

#include <math.h>

/* Returns the wear coefficient of a layer divided by the largest coefficient of the body, or 1
 * if no material of the body has a coefficient. */
static double share_of(const arc_model_def *def, arc_body body, int layer) {
  const double largest = arc_model_wear_k(def, body);
  const arc_material own = def->material[body];
  return largest > 0 ? arc_body_layer_material(&def->body[body], layer, own).k / largest : 1;
}

int arc_layer_wear_differs(const arc_model_def *def, arc_body body) {
  for (int l = 0, n = arc_body_layers(&def->body[body]); l <= n && n > 0; l++)
    if (share_of(def, body, l) != 1) return 1;
  return 0;
}

static stratum below(const layers_below *b, int i, int n) {
  const arc_body_def *solid = &b->def->body[b->body];
  if (b->solid) return arc_body_stratum(b->solid, i, n);
  return (stratum){n < arc_body_layers(solid) ? arc_body_interface(solid, n) : INFINITY, n};
}

double arc_layer_wear(const layers_below *b, int i, double h, double due) {
  const double from = h;
  double end = 0;
  for (int n = 0; due > 0 && end < INFINITY; n++) {
    const stratum here = below(b, i, n);
    const double share = share_of(b->def, b->body, here.layer);
    end = here.end;
    if (h >= end) continue;
    if (share == 0) break;
    const double gone = fmin(share * due, end - h);
    h = gone < end - h ? h + gone : end;
    due -= gone / share;
  }
  return h - from;
}

double arc_layer_wear_share(const layers_below *b, int i, double h) {
  int n = 0;
  while (h >= below(b, i, n).end) n++;
  return share_of(b->def, b->body, below(b, i, n).layer);
}

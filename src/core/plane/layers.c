/* Wear through layers: the coefficient is a table over depth. A depth at the largest coefficient is
 * converted layer by layer, so that an update through several layers uses the coefficient of each.
 */
#include "core/plane/cycle.h"

#include <math.h>

/* Wear coefficient of a layer relative to the largest; 1 if none has one. */
static double share_of(const arc_model_def *def, arc_body body, int layer) {
  const double largest = arc_model_wear_k(def, body);
  const arc_material own = def->material[body];
  return largest > 0 ? arc_body_layer_material(&def->body[body], layer, own).k / largest : 1;
}

double arc_wear_through_layers(const arc_shape *shape, arc_body body, int i, double h, double due) {
  const arc_model_def *def = arc_model_definition(shape->handle.model);
  const elastic_body *solid = shape->side[body].body;
  const double from = h;
  double end = 0;
  for (int n = 0; due > 0 && end < INFINITY; n++) {
    const stratum here = arc_body_stratum(solid, i, n);
    const double share = share_of(def, body, here.layer);
    end = here.end;
    if (h >= end) continue;
    if (share == 0) break;
    const double gone = fmin(share * due, end - h);
    h = gone < end - h ? h + gone : end;
    due -= gone / share;
  }
  return h - from;
}

static void into_layers(const arc_shape *shape, arc_body body, double *depth) {
  const arc_model_def *def = arc_model_definition(shape->handle.model);
  const shape_side *side = &shape->side[body];
  if (arc_body_layers(&def->body[body]) == 0) return;
  for (int i = 0; i < side->n; i++)
    if (depth[i] > 0) depth[i] = arc_wear_through_layers(shape, body, i, side->h[i], depth[i]);
}

void arc_wear_into_layers(const arc_shape *shape, double *depth) {
  into_layers(shape, ARC_CYLINDER, depth);
  into_layers(shape, ARC_PLATE, depth + shape->side[ARC_CYLINDER].n);
}

double arc_wear_layer_share(const arc_shape *shape, arc_body body, int i, double depth) {
  const arc_model_def *def = arc_model_definition(shape->handle.model);
  const shape_side *side = &shape->side[body];
  if (arc_body_layers(&def->body[body]) == 0) return 1;
  int n = 0;
  while (side->h[i] + depth >= arc_body_stratum(side->body, i, n).end) n++;
  return share_of(def, body, arc_body_stratum(side->body, i, n).layer);
}

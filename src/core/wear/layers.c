/* Wear through layers: the coefficient is a table over depth. A depth that is due at the largest
 * coefficient is spent layer by layer, each of which wears by its share of it, so that an update
 * that ends in another layer than it began in takes what both would. */
#include "core/wear/layers.h"

#include <math.h>

/* Share of the largest coefficient that a layer wears by; 1 where none has one. */
static double share_of(const arc_model_def *def, arc_body body, int layer) {
  const arc_body_def *solid = &def->body[body];
  const double largest = arc_model_wear_k(def, body);
  const double own =
      layer < arc_body_layers(solid) ? solid->layer[layer].material.k : def->material[body].k;
  return largest > 0 ? own / largest : 1;
}

double arc_wear_through_layers(const arc_model_def *def, arc_body body, double h, double due) {
  const arc_body_def *solid = &def->body[body];
  const int layers = arc_body_layers(solid);
  const double from = h;
  for (int l = 0; l <= layers && due > 0; l++) {
    const double end = l < layers ? arc_body_interface(solid, l) : INFINITY;
    const double share = share_of(def, body, l);
    if (h >= end) continue;
    if (share == 0) break;
    const double gone = fmin(share * due, end - h);
    h = gone < end - h ? h + gone : end;
    due -= gone / share;
  }
  return h - from;
}

void arc_wear_into_layers(const arc_shape *shape, arc_body body, double *depth) {
  const arc_model_def *def = arc_model_definition(shape->model);
  if (arc_body_layers(&def->body[body]) == 0) return;
  for (int i = 0; i < shape->side[body].n; i++)
    if (depth[i] > 0)
      depth[i] = arc_wear_through_layers(def, body, shape->side[body].h[i], depth[i]);
}

double arc_wear_layer_share(const arc_shape *shape, arc_body body, int i, double depth) {
  const arc_model_def *def = arc_model_definition(shape->model);
  const int layers = arc_body_layers(&def->body[body]);
  int layer = 0;
  if (layers == 0) return 1;
  while (layer < layers &&
         shape->side[body].h[i] + depth >= arc_body_interface(&def->body[body], layer))
    layer++;
  return share_of(def, body, layer);
}

/* Wear through the layers of meshed bodies. */
#include "core/elastic/layer_wear.h"
#include "core/plane/cycle.h"

static layers_below below(const arc_shape *shape, arc_body body) {
  return (layers_below){arc_model_definition(shape->handle.model), body, shape->side[body].body};
}

double arc_wear_through_layers(const arc_shape *shape, arc_body body, int i, double h, double due) {
  const layers_below layers = below(shape, body);
  return arc_layer_wear(&layers, i, h, due);
}

static void into_layers(const arc_shape *shape, arc_body body, double *depth) {
  const layers_below layers = below(shape, body);
  const shape_side *side = &shape->side[body];
  if (arc_body_layers(&layers.def->body[body]) == 0) return;
  for (int i = 0; i < side->n; i++)
    if (depth[i] > 0) depth[i] = arc_layer_wear(&layers, i, side->h[i], depth[i]);
}

void arc_wear_into_layers(const arc_shape *shape, double *depth) {
  into_layers(shape, ARC_CYLINDER, depth);
  into_layers(shape, ARC_PLATE, depth + shape->side[ARC_CYLINDER].n);
}

double arc_wear_layer_share(const arc_shape *shape, arc_body body, int i, double depth) {
  const layers_below layers = below(shape, body);
  if (arc_body_layers(&layers.def->body[body]) == 0) return 1;
  return arc_layer_wear_share(&layers, i, shape->side[body].h[i] + depth);
}

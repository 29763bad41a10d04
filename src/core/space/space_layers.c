/* Computes wear through the layers of half-spaces. The compliance of the unworn layers is used
 * throughout. */
#include "core/elastic/layer_wear.h"
#include "core/space/space_kind.h"

static layers_below below(const arc_shape *shape, arc_body body) {
  return (layers_below){arc_model_definition(space_shape_of(shape)->handle.model), body, NULL};
}

double arc_space_worn(const arc_shape *shape, arc_body body, int i, double due, double *share) {
  const layers_below layers = below(shape, body);
  const double h = space_shape_of(shape)->depth[body][i];
  const double worn = due > 0 ? arc_layer_wear(&layers, i, h, due) : 0;
  if (share) *share = arc_layer_wear_share(&layers, i, h + worn);
  return worn;
}

void arc_space_through_layers(const arc_shape *shape, double *depth) {
  const arc_model_def *def = arc_model_definition(space_shape_of(shape)->handle.model);
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = space_sites(space_shape_of(shape), b);
    if (arc_layer_wear_differs(def, (arc_body)b))
      for (int i = 0; i < n; i++) depth[i] = arc_space_worn(shape, (arc_body)b, i, depth[i], NULL);
    depth += n;
  }
}

double arc_space_open_share(const arc_wear *w, arc_body body) {
  const layers_below layers = below(w->shape, body);
  const wear_sites on = w->kind->sites(w->shape, body);
  int deepest = 0;
  for (int i = 0; i < on.count; i++)
    if (on.h[i] > on.h[deepest]) deepest = i;
  return arc_layer_wear_share(&layers, deepest, on.h[deepest]);
}

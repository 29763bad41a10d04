/* Wear through layers, where the coefficient is a table over depth. A depth at the largest
 * coefficient is converted layer by layer, so that an update through several layers uses the
 * coefficient of each. */
#ifndef ELASTIC_LAYER_WEAR_H
#define ELASTIC_LAYER_WEAR_H

#include "core/elastic/body.h"

/* The layers of a body below a site. */
typedef struct layers_below {
  const arc_model_def *def;
  arc_body body;
  const elastic_body
      *solid; /* body with a mesh; NULL: each layer has the same thickness everywhere */
} layers_below;

/* Returns true if the wear depends on the layer at the surface. */
int arc_layer_wear_differs(const arc_model_def *def, arc_body body);
/* Converts a depth [mm] at the largest wear coefficient to the depth with the coefficients of the
 * layers below site i, beginning at depth h. */
double arc_layer_wear(const layers_below *b, int i, double h, double due);
/* Returns the wear coefficient at depth h below site i, relative to the largest. */
double arc_layer_wear_share(const layers_below *b, int i, double h);

#endif

/* Wear through layers: the coefficient is a table over depth. A depth at the largest coefficient is
 * converted layer by layer, so that an update through several layers uses the coefficient of each.
 */
#ifndef ELASTIC_LAYER_WEAR_H
#define ELASTIC_LAYER_WEAR_H

#include "core/elastic/body.h"

/* The layers of a body below a site. */
typedef struct layers_below {
  const arc_model_def *def;
  arc_body body;
  const elastic_body *solid; /* with a mesh; NULL: layers are as thick all over */
} layers_below;

/* True if depths depend on which layer they are in. */
int arc_layer_wear_differs(const arc_model_def *def, arc_body body);
/* Converts a depth [mm] at the largest wear coefficient to the depth with the coefficients of the
 * layers below site i, starting at depth h. */
double arc_layer_wear(const layers_below *b, int i, double h, double due);
/* Wear coefficient at depth h below site i, relative to the largest. */
double arc_layer_wear_share(const layers_below *b, int i, double h);

#endif

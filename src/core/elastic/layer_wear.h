/* Wear through layers, whose wear coefficients form a table over depth. A depth that was
 * computed with the largest coefficient is converted layer by layer. Thus an update through
 * several layers uses the coefficient of each layer. */
#ifndef ELASTIC_LAYER_WEAR_H
#define ELASTIC_LAYER_WEAR_H

#include "core/elastic/body.h"

/* Layers of a body below its sites, which are surface nodes or surface cells. */
typedef struct layers_below {
  const arc_model_def *def;
  arc_body body;
  const elastic_body *solid; /* body with a mesh; NULL: each layer is equally thick everywhere */
} layers_below;

/* Returns true if the layers of a body have different wear coefficients. */
int arc_layer_wear_differs(const arc_model_def *def, arc_body body);
/* Converts `due`, a wear depth [mm] computed with the largest wear coefficient, to the depth
 * [mm] with the coefficients of the layers below site i. The wear begins at depth h [mm]. */
double arc_layer_wear(const layers_below *b, int i, double h, double due);
/* Returns the wear coefficient at depth h [mm] below site i, divided by the largest wear
 * coefficient of the body. */
double arc_layer_wear_share(const layers_below *b, int i, double h);

#endif

/* Wear through layers. */
#ifndef WEAR_LAYERS_H
#define WEAR_LAYERS_H

#include "core/contact/shape.h"

/* The depth from h on [mm] that a depth due at the largest wear coefficient of the layers under
 * node i of a body comes to at their own. */
double arc_wear_through_layers(const arc_shape *shape, arc_body body, int i, double h, double due);

/* The same for the depths of all nodes of both surfaces, the cylinder's first. */
void arc_wear_into_layers(const arc_shape *shape, double *depth);
/* Share of the largest coefficient by which node i of a body wears where it has lost `depth` more.
 */
double arc_wear_layer_share(const arc_shape *shape, arc_body body, int i, double depth);

#endif

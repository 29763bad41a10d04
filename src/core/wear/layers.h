/* Wear through layers. */
#ifndef WEAR_LAYERS_H
#define WEAR_LAYERS_H

#include "core/contact/shape.h"

/* Depths [surface] that a body would lose with the largest wear coefficient of its layers become
 * those that it loses with the coefficients of the layers it wears into. */
void arc_wear_into_layers(const arc_shape *shape, arc_body body, double *depth);

#endif

/* Stiffness of layered bodies under pressure waves. */
#ifndef ELASTIC_LAYERED_H
#define ELASTIC_LAYERED_H

#include "archard/model.h"

/* Returns the modulus of a half-plane of the material [MPa]: E*, or E in plane stress. */
double arc_material_modulus(arc_space space, arc_material material);

/* Returns the modulus [MPa] of the half-plane that has the same displacement under a pressure
 * wave of wave number q [1/mm] as the layered body. Without layers and with a distant base, the
 * result is exactly the modulus of the material. */
double arc_body_modulus(arc_space space, const arc_body_def *body, arc_material own, double q);
/* Returns the modulus [MPa], defined as for arc_body_modulus, of a list of layers from the
 * surface inwards on a base of the material `own`. The base is `base` mm thick (INFINITY: a
 * half-plane) and fixed at its lower face. */
double arc_layers_modulus(arc_space space, const arc_layer *layer, int layers, double base,
                          arc_material own, double q);
/* Returns the contact modulus [MPa] of two layered bodies under a pressure wave of wave number q
 * [1/mm]. */
double arc_pair_modulus(arc_space space, const arc_body_def body[ARC_BODIES],
                        const arc_material own[ARC_BODIES], double q);

#endif

/* Stiffness of layered bodies against pressure waves. */
#ifndef ELASTIC_LAYERED_H
#define ELASTIC_LAYERED_H

#include "archard/model.h"

/* Modulus of a material's half-plane [MPa]: E*, in plane stress E. */
double arc_material_modulus(arc_space space, arc_material material);

/* That of the half-plane which yields as much as a body with its layers does to a pressure of wave
 * number q [1/mm]; to the bit the material's where there are no layers and no base is near. */
double arc_body_modulus(arc_space space, const arc_body_def *body, arc_material own, double q);
/* The same for layers, from the surface inwards, on a base of the body's material, `base` mm thick
 * (INFINITY: a half-plane) and fixed below. */
double arc_layers_modulus(arc_space space, const arc_layer *layer, int layers, double base,
                          arc_material own, double q);
/* Contact modulus of two such bodies [MPa]. */
double arc_pair_modulus(arc_space space, const arc_body_def body[ARC_BODIES],
                        const arc_material own[ARC_BODIES], double q);

#endif

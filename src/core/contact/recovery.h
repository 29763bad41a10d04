/* Stresses at nodes from the displacements of a loaded body. */
#ifndef CONTACT_RECOVERY_H
#define CONTACT_RECOVERY_H

#include "core/elastic/body.h"

/* Stresses [3 * nodes] (xx, yy, xy, [MPa]) with nodes at xy and displacements u [2 * nodes] under
 * the pressures p [surface] on the candidate surface; the rest of the boundary is free or fixed. On
 * the boundary they fulfil the tractions, inside they are fitted to the elements' centres; of
 * second order in the element size both. ARC_MEMORY. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const double *p, double *stress);

#endif

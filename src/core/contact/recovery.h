/* Stresses at nodes from the displacements of a loaded body. */
#ifndef CONTACT_RECOVERY_H
#define CONTACT_RECOVERY_H

#include "core/elastic/body.h"

/* What acts on the candidate surface, by its nodes. */
typedef struct arc_tractions {
  const double *p; /* pressures [MPa] */
  const double *q; /* shear along the surface [MPa], or NULL */
  double sign;     /* 1 where q acts on this body along +x, -1 along -x */
} arc_tractions;

/* Stresses [3 * nodes] (xx, yy, xy, [MPa]) with nodes at xy and displacements u [2 * nodes] under
 * tractions on the candidate surface; the rest of the boundary is free or fixed. On
 * the boundary they fulfil the tractions, inside they are fitted to the elements' centres; of
 * second order in the element size both. ARC_MEMORY. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const arc_tractions *on, double *stress);

#endif

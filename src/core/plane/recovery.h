/* Stresses at nodes from the displacements of a loaded body. */
#ifndef PLANE_RECOVERY_H
#define PLANE_RECOVERY_H

#include "core/elastic/body.h"

/* Tractions on the candidate surface of a body [MPa]; the rest of the boundary is free or fixed. */
typedef struct surface_traction {
  double *normal;     /* [surface] pressure */
  double *load;       /* [surface] nodal forces / tributary widths */
  double *tangential; /* [surface] along the surface, towards larger x; NULL: none */
  double *cusp;       /* [surface] by how much the stress along the surface is more at a node than
                         between the two beside it, where it is not smooth; NULL: nowhere */
} surface_traction;

/* Stresses [3 * nodes] (xx, yy, xy, [MPa]) with nodes at xy and displacements u [2 * nodes] under
 * a traction. On the boundary they fulfil the tractions, inside they are fitted to the elements'
 * centres; of second order in the element size both. ARC_MEMORY. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const surface_traction *traction, double *stress);

#endif

/* Stresses at nodes from the displacements of a loaded body. */
#ifndef PLANE_RECOVERY_H
#define PLANE_RECOVERY_H

#include "core/elastic/body.h"

/* Tractions on the candidate surface of a body [MPa]. The rest of its boundary is free or fixed. */
typedef struct surface_traction {
  double *normal;     /* [surface] pressure */
  double *load;       /* [surface] nodal forces over tributary widths */
  double *tangential; /* [surface] along the surface, towards larger x; NULL: none */
  double *cusp; /* [surface] stress along the surface at a node minus that between the adjacent
                   nodes, where it is not smooth; NULL: none */
} surface_traction;

/* Computes the stresses [3 * nodes] (xx, yy, xy, [MPa]) for nodes at xy with displacements u [2 *
 * nodes] under a traction. On the boundary the stresses satisfy the tractions; inside they are
 * fitted to the stresses at the elements' centres. Both are of second order in the element size.
 * Error: ARC_MEMORY. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const surface_traction *traction, double *stress);

#endif

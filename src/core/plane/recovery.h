/* Computes stresses at nodes from the displacements of a loaded body. */
#ifndef PLANE_RECOVERY_H
#define PLANE_RECOVERY_H

#include "core/elastic/body.h"

/* Tractions on the candidate surface of a body [MPa]. The other parts of the boundary are free or
 * fixed. */
typedef struct surface_traction {
  double *normal;     /* [surface] pressures at the nodes */
  double *load;       /* [surface] nodal forces divided by tributary widths */
  double *tangential; /* [surface] shear along the surface, towards larger x; may be NULL */
  double *cusp; /* [surface] stress along the surface at a node minus its value beside the node, for
                   nodes where the stress is not smooth; may be NULL */
} surface_traction;

/* Computes the stresses [3 * nodes] (xx, yy, xy, [MPa]) at nodes with positions xy and
 * displacements u [2 * nodes, mm] under a traction. On the boundary the stresses satisfy the
 * tractions. Inside they are fitted to the stresses at the centres of elements. The errors of
 * both are of second order in the element size. Error: ARC_MEMORY. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const surface_traction *traction, double *stress);

#endif

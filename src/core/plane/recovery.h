/* Computes stresses at nodes from the displacements of a loaded body. */
#ifndef PLANE_RECOVERY_H
#define PLANE_RECOVERY_H

#include "core/elastic/body.h"

/* Tractions on the candidate surface of a body [MPa]. All other parts of the boundary are free
 * or fixed. */
typedef struct surface_traction {
  double *normal;     /* pressure at each surface node */
  double *load;       /* force on each surface node divided by its tributary width */
  double *tangential; /* shear at each surface node along the surface, towards larger x; may be
                         NULL */
  double *cusp;       /* stress along the surface at each node minus the stress beside the node,
                         nonzero where the stress is not smooth; may be NULL */
} surface_traction;

/* Computes the stresses xx, yy, xy [MPa] at all nodes of a body under a traction. xy and u are
 * the positions and displacements of the nodes [mm]. On the boundary the stresses satisfy the
 * tractions. Inside the body they are fitted to the stresses at the centres of elements. Their
 * errors are of second order in the element size. Error: ARC_MEMORY. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const surface_traction *traction, double *stress);

#endif

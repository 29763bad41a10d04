/* Condenses a body to its surface, for any worn shape, and computes displacements of the whole
 * body. */
#ifndef ELASTIC_CONDENSE_H
#define ELASTIC_CONDENSE_H

#include "core/elastic/body.h"

/* Computes the compliance in the chart's directions. box_at contains the positions of the
 * wear-box nodes in the chart, in the order of box_node. A uniform wear `even` [mm] shifts the
 * layers in the box toward the surface. Errors: ARC_NUMERIC, ARC_MEMORY. */
arc_status arc_body_condense(const elastic_body *body, const double *box_at, double even,
                             compliance *result, arc_error *error);

/* Computes the displacements of all nodes of a body in space by back-substitution, and writes
 * them to u [2 * nodes] [mm]. f [2 * surface] contains the forces on the surface nodes [N/mm],
 * first along s at all nodes and then along z. */
arc_status arc_body_displacements(const elastic_body *body, const double *box_at, double even,
                                  const double *f, double *u, arc_error *error);

#endif

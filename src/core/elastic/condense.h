/* Condenses a body to its surface, for any worn shape, and computes displacements of the whole
 * body. */
#ifndef ELASTIC_CONDENSE_H
#define ELASTIC_CONDENSE_H

#include "core/elastic/body.h"

/* Computes the compliance in the chart's directions, with the wear-box nodes at box_at [2 *
 * box_count] in the chart (in the order of box_node). An even wear `even` [mm] shifts the layers in
 * the box toward the surface by this length. Errors: ARC_NUMERIC, ARC_MEMORY. */
arc_status arc_body_condense(const elastic_body *body, const double *box_at, double even,
                             compliance *result, arc_error *error);

/* Computes the displacements u [2 * nodes] [mm] of the whole body in space by back-substitution. f
 * [2 * surface] has the surface forces [N/mm], first along s at all nodes, then along z. */
arc_status arc_body_displacements(const elastic_body *body, const double *box_at, double even,
                                  const double *f, double *u, arc_error *error);

#endif

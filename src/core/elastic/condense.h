/* A body condensed to its surface, on any worn shape; displacements back from it. */
#ifndef ELASTIC_CONDENSE_H
#define ELASTIC_CONDENSE_H

#include "core/elastic/body.h"

/* The compliance, in the chart's directions, with the wear-box nodes at box_at [2 * box_count] of
 * the chart (order of box_node). With an even wear `even` [mm] the layers in the box lie higher by
 * it. ARC_NUMERIC, ARC_MEMORY. */
arc_status arc_body_condense(const elastic_body *body, const double *box_at, double even,
                             compliance *result, arc_error *error);

/* Displacements u [2 * nodes] of the whole body, in space, under surface forces f [2 * surface,
 * N/mm], along s at all nodes first, then along z, by back-substitution. */
arc_status arc_body_displacements(const elastic_body *body, const double *box_at, double even,
                                  const double *f, double *u, arc_error *error);

#endif

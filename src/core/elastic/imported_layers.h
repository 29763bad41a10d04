/* Layers below the surface nodes of imported meshes. */
#ifndef ELASTIC_IMPORTED_LAYERS_H
#define ELASTIC_IMPORTED_LAYERS_H

#include "core/elastic/body.h"

/* Finds the strata of a given mesh whose body has layers; else does nothing. ARC_MEMORY. */
arc_status arc_body_find_strata(elastic_body *body, arc_error *error);
/* For a body with materials: *own := the body with layers of the thicknesses below the middle of
 * its surface. */
arc_body_def arc_body_under_middle(const elastic_body *body, arc_material *own);

#endif

/* Layers below the surface nodes of imported meshes. */
#ifndef ELASTIC_IMPORTED_LAYERS_H
#define ELASTIC_IMPORTED_LAYERS_H

#include "core/elastic/body.h"

/* Finds the strata of a given mesh whose body has layers; else does nothing. ARC_MEMORY. */
arc_status arc_body_find_strata(elastic_body *body, arc_error *error);
/* Of a body that has them: the body with those under the middle of its surface as layers by their
 * thickness, on *own. */
arc_body_def arc_body_under_middle(const elastic_body *body, arc_material *own);

#endif

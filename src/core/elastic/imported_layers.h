/* Layers below the surface nodes of imported meshes. */
#ifndef ELASTIC_IMPORTED_LAYERS_H
#define ELASTIC_IMPORTED_LAYERS_H

#include "core/elastic/body.h"

/* Determines the layers below each surface node of a layered body with an imported mesh. Does
 * nothing for all other bodies. Errors: ARC_MEMORY. */
arc_status arc_body_find_strata(elastic_body *body, arc_error *error);
/* Returns the definition of a body with uniform layers, which equal the layers below the middle
 * of the body's surface. Sets *own to the material below these layers. */
arc_body_def arc_body_under_middle(const elastic_body *body, arc_material *own);

#endif

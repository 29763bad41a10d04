/* Layers below the surface nodes of imported meshes. */
#ifndef ELASTIC_IMPORTED_LAYERS_H
#define ELASTIC_IMPORTED_LAYERS_H

#include "core/elastic/body.h"

/* Determines the layers below each surface node of a layered body with an imported mesh. Does
 * nothing for all other bodies. Errors: ARC_MEMORY. */
arc_status arc_body_find_strata(elastic_body *body, arc_error *error);
/* Returns the definition of a substitute body with uniform layers: those that the imported body has
 * below the middle of its surface. Sets *own to the material below these layers. */
arc_body_def arc_body_under_middle(const elastic_body *body, arc_material *own);

#endif

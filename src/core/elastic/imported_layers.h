/* Layers below the surface nodes of imported meshes. */
#ifndef ELASTIC_IMPORTED_LAYERS_H
#define ELASTIC_IMPORTED_LAYERS_H

#include "core/elastic/body.h"

/* Determines the layers below each surface node of an imported mesh whose body has layers; does
 * nothing for other meshes. Errors: ARC_MEMORY. */
arc_status arc_body_find_strata(elastic_body *body, arc_error *error);
/* Returns the definition of the body with uniform layers that equal those below the middle of its
 * surface, and sets *own to the material below them. */
arc_body_def arc_body_under_middle(const elastic_body *body, arc_material *own);

#endif

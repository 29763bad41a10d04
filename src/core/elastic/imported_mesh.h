/* Imported meshes: checks against the definition of a model. imported_shape.c checks the fields of
 * the shape. */
#ifndef ELASTIC_IMPORTED_MESH_H
#define ELASTIC_IMPORTED_MESH_H

#include "archard/model.h"

/* --- imported_mesh.c -------------------------------------------------------------------------- */

/* Checks a definition and two imported meshes. Completes the definition with values from the
 * meshes and writes it to *settled. Errors: ARC_ARGUMENT. */
arc_status arc_given_settle(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                            arc_model_def *settled, arc_error *error);
/* Sets the layer of each element of a mesh by the names of the body's layers. Errors:
 * ARC_MEMORY. */
arc_status arc_given_layers(arc_mesh *mesh, const arc_body_def *solid, arc_error *error);
/* Checks that a definition without imported meshes does not use settings that need one. Errors:
 * ARC_ARGUMENT. */
arc_status arc_given_refuse(const arc_model_def *def, arc_error *error);

/* --- imported_shape.c ------------------------------------------------------------------------- */

/* Checks that the definition does not define the shape of a body with an imported mesh, except for
 * the radii of a hole. Errors: ARC_ARGUMENT. */
arc_status arc_given_check_shape(const arc_model_def *def, arc_body body, arc_error *error);

#endif

/* Meshes from outside: whether they suit a definition (imported_shape.c: what else a body says
 * of its shape). */
#ifndef ELASTIC_IMPORTED_MESH_H
#define ELASTIC_IMPORTED_MESH_H

#include "archard/model.h"

/* Checks a definition and two meshes, and makes of it that of their model. ARC_ARGUMENT. */
arc_status arc_given_settle(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                            arc_model_def *settled, arc_error *error);
/* Refuses a shape that a body has beside a mesh from outside. ARC_ARGUMENT. */
arc_status arc_given_check_shape(const arc_model_def *def, arc_body body, arc_error *error);
/* Fills in the layer of each element by the names of the body's. ARC_MEMORY. */
arc_status arc_given_layers(arc_mesh *mesh, const arc_body_def *solid, arc_error *error);
/* Refuses what belongs to such meshes alone. ARC_ARGUMENT. */
arc_status arc_given_refuse(const arc_model_def *def, arc_error *error);

#endif

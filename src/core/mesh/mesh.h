/* Checks a mesh definition and estimates the size of a mesh before it is built. */
#ifndef MESH_MESH_H
#define MESH_MESH_H

#include "archard/mesh.h"

/* Checks a definition. Returns the errors of arc_mesh_build that depend on the definition alone. */
arc_status arc_mesh_check(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                          arc_error *error);
/* Returns the estimated number of nodes of a mesh. */
double arc_mesh_nodes(const arc_mesh_def *def, arc_body body, const arc_body_def *solid);

#endif

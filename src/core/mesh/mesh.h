/* What is known of a mesh before it is made. */
#ifndef MESH_MESH_H
#define MESH_MESH_H

#include "archard/mesh.h"

/* Errors of arc_mesh_build that are known beforehand. */
arc_status arc_mesh_check(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                          arc_error *error);
/* About how many nodes a mesh will have. */
double arc_mesh_nodes(const arc_mesh_def *def, arc_body body, const arc_body_def *solid);

#endif

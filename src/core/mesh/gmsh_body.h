/* Mesh of one body from a Gmsh file. */
#ifndef MESH_GMSH_BODY_H
#define MESH_GMSH_BODY_H

#include "core/mesh/gmsh_file.h"

/* Builds the mesh of one body. `owner` contains for each node of the file the body that uses the
 * node, or -1 if no body uses it yet. */
arc_status arc_msh_body(const msh_file *file, arc_body body, signed char *owner, arc_mesh **mesh,
                        arc_error *error);

#endif

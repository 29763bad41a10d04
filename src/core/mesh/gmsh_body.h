/* One body of a Gmsh file. */
#ifndef MESH_GMSH_BODY_H
#define MESH_GMSH_BODY_H

#include "core/mesh/gmsh_file.h"

/* Builds the mesh of one body. `owner` [nodes of the file] has the body that uses a node, or -1 if
 * none does yet. */
arc_status arc_msh_body(const msh_file *file, arc_body body, signed char *owner, arc_mesh **mesh,
                        arc_error *error);

#endif

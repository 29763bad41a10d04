/* Boundary polygon of a mesh. */
#ifndef MESH_OUTLINE_H
#define MESH_OUTLINE_H

#include "archard/mesh.h"

/* Computes the boundary polygon as the chain of all edges that belong to only one element. A
 * ring has two boundary polygons; the one with the contact surface is used. Errors: ARC_MEMORY,
 * ARC_GEOMETRY. */
arc_status arc_mesh_outline(arc_mesh *mesh);

#endif

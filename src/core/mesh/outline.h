/* The boundary polygon of a mesh. */
#ifndef MESH_OUTLINE_H
#define MESH_OUTLINE_H

#include "archard/mesh.h"

/* Chains the edges that belong to one element only into the boundary polygon; for a ring, which has
 * two, the one with the surface. ARC_MEMORY or ARC_GEOMETRY. */
arc_status arc_mesh_outline(arc_mesh *mesh);

#endif

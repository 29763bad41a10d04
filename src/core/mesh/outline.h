/* The boundary polygon of a mesh. */
#ifndef MESH_OUTLINE_H
#define MESH_OUTLINE_H

#include "archard/mesh.h"

/* Chains the edges that only one element has into the boundary polygon; of a ring, whose boundary
 * is two, that with the surface. ARC_MEMORY or ARC_GEOMETRY.
 */
arc_status arc_mesh_outline(arc_mesh *mesh);

#endif

/* Boundary of a body from a Gmsh file. */
#ifndef MESH_GMSH_BOUNDARY_H
#define MESH_GMSH_BOUNDARY_H

#include "core/mesh/gmsh_file.h"

/* A body that is built from the file. */
typedef struct msh_body {
  const msh_file *file;
  arc_mesh *mesh;
  int *local;  /* [nodes of the file] node number in the mesh, or -1 */
  int *origin; /* [nodes] index of the node in the file */
  int *source; /* [elements] index of the element in the file */
  int *next;   /* [nodes] next node on the boundary, or -1 for inner nodes */
  arc_error *error;
} msh_body;

/* Returns the number that a mesh node has in the Gmsh file. */
static inline long long arc_msh_tag(const msh_body *b, int node) {
  return ((const msh_node *)b->file->nodes.data)[b->origin[node]].tag;
}

/* Determines the boundary, the candidate surface and the fixed nodes of a body. */
arc_status arc_msh_boundary(msh_body *b);

#endif

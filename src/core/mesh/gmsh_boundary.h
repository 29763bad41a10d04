/* Boundary of a body from a Gmsh file. */
#ifndef MESH_GMSH_BOUNDARY_H
#define MESH_GMSH_BOUNDARY_H

#include "core/mesh/gmsh_file.h"

/* A body that is built from the file. */
typedef struct msh_body {
  const msh_file *file;
  arc_mesh *mesh;
  int *local;  /* number in the mesh of each node in the file, or -1 */
  int *origin; /* index in the file of each node in the mesh */
  int *source; /* index in the file of each element in the mesh */
  int *next;   /* next node on the boundary for each node in the mesh, or -1 for inner nodes */
  arc_error *error;
} msh_body;

/* Returns the number of a mesh node in the Gmsh file. */
static inline long long arc_msh_tag(const msh_body *b, int node) {
  return ((const msh_node *)b->file->nodes.data)[b->origin[node]].tag;
}

/* Determines the boundary, the candidate surface and the fixed nodes of a body. */
arc_status arc_msh_boundary(msh_body *b);

#endif

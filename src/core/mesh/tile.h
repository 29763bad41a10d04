/* A mesh under construction, as polygons over logical points. */
#ifndef MESH_TILE_H
#define MESH_TILE_H

#include "core/mesh/map.h"
#include "core/mesh/quadtree.h"

/* Keys of logical points are in half units, so that the middle of a cell has a key as well. */
typedef struct mesh_key {
  int i, j;
} mesh_key;

typedef struct mesh_builder {
  body_map map;
  int count, capacity;
  mesh_key
      *corner; /* [4 * capacity] corners of each element; a triangle repeats its third corner */
} mesh_builder;

/* Adds the elements of the half body s >= 0: first the wear box, column by column, then the rest.
 * Hanging nodes are closed with triangles. `columns` x `rows` is the half wear box. Errors:
 * ARC_MEMORY. */
arc_status arc_mesh_tile(mesh_builder *builder, const quadtree *tree, int columns, int rows);

#endif

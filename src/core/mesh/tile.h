/* Mesh under construction: elements whose corners are logical points. */
#ifndef MESH_TILE_H
#define MESH_TILE_H

#include "core/mesh/map.h"
#include "core/mesh/quadtree.h"

/* Key of a logical point. Keys count half units, because the middle of a cell needs a key too. */
typedef struct mesh_key {
  int i, j;
} mesh_key;

typedef struct mesh_builder {
  body_map map;
  int count, capacity;
  mesh_key
      *corner; /* [4 * capacity] corners of each element; a triangle repeats its third corner */
} mesh_builder;

/* Adds the elements of the half body s >= 0: first the `columns` x `rows` cells of the wear box,
 * column by column, then all other cells. Cells with hanging nodes are divided into triangles.
 * Error: ARC_MEMORY. */
arc_status arc_mesh_tile(mesh_builder *builder, const quadtree *tree, int columns, int rows);

#endif

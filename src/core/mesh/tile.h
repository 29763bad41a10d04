/* Mesh under construction. The corners of its elements are logical points. */
#ifndef MESH_TILE_H
#define MESH_TILE_H

#include "core/mesh/map.h"
#include "core/mesh/quadtree.h"

/* Key of a logical point. Its unit is half a unit of the quadtree, because the centre of a cell
 * needs a key as well. */
typedef struct mesh_key {
  int i, j;
} mesh_key;

typedef struct mesh_builder {
  body_map map;
  int count, capacity;
  mesh_key *corner; /* four corners of each element; a triangle repeats its third corner */
} mesh_builder;

/* Adds the elements of the half body s >= 0. The `columns` x `rows` cells of the wear box are
 * first, column by column, followed by all other cells. Cells with hanging nodes are divided
 * into triangles. Error: ARC_MEMORY. */
arc_status arc_mesh_tile(mesh_builder *builder, const quadtree *tree, int columns, int rows);

#endif

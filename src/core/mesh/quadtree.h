/* A quadtree over a grid of square root cells, in which the levels of neighbours differ by at
 * most one. Coordinates are integers in units of the finest cell. */
#ifndef MESH_QUADTREE_H
#define MESH_QUADTREE_H

#include "archard/base.h"

typedef struct quad_cell {
  int level; /* the cell is 2^level units wide and high */
  int i, j;  /* corner of the cell with the smallest i and j, in units of the finest cell */
  int child; /* index of the first of four children; -1 for a leaf */
} quad_cell;

typedef struct quadtree {
  int root_level;      /* level of the root cells */
  int columns, lines;  /* number of root cells along i and j; root (a, b) is cell a + b * columns */
  int count, capacity; /* number of all cells, and capacity of the array */
  quad_cell *cell;
} quadtree;

/* Returns the coarsest level allowed for a cell. The function is called each time a cell may be
 * split. */
typedef int (*quad_level_fn)(const void *context, const quad_cell *cell);

/* Splits cells until no leaf is coarser than allowed and the levels of neighbours with a common
 * edge differ by at most one. Error: ARC_MEMORY; the tree is empty then. */
arc_status arc_quadtree_build(quadtree *tree, int root_level, int columns, int lines,
                              quad_level_fn coarsest, const void *context);
void arc_quadtree_free(quadtree *tree);

/* Returns the leaf that contains the unit cell (i, j), or NULL for a cell outside the tree. */
const quad_cell *arc_quadtree_leaf(const quadtree *tree, int i, int j);

/* Returns as bits which edges of a leaf have a hanging node: bit 0 for the edge at the smallest j,
 * bit 1 at the largest i, bit 2 at the largest j, bit 3 at the smallest i. */
unsigned arc_quadtree_hanging(const quadtree *tree, const quad_cell *leaf);

#endif

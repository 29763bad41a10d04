/* A 2:1-balanced quadtree over a grid of square root cells, in integer units of the finest cell. */
#ifndef MESH_QUADTREE_H
#define MESH_QUADTREE_H

#include "archard/base.h"

typedef struct quad_cell {
  int level; /* the cell is 2^level units wide and high */
  int i, j;  /* its corner nearest the origin, in units */
  int child; /* index of the first of four children, -1 for a leaf */
} quad_cell;

typedef struct quadtree {
  int root_level;      /* level of the roots */
  int columns, lines;  /* root cells along i and j; root (a, b) is cell a + b * columns */
  int count, capacity; /* cells */
  quad_cell *cell;
} quadtree;

/* The coarsest level allowed for a cell; called before each split. */
typedef int (*quad_level_fn)(const void *context, const quad_cell *cell);

/* Splits until no leaf is coarser than allowed and neighbours across an edge differ by at most one
 * level. ARC_MEMORY: the tree is empty. */
arc_status arc_quadtree_build(quadtree *tree, int root_level, int columns, int lines,
                              quad_level_fn coarsest, const void *context);
void arc_quadtree_free(quadtree *tree);

/* The leaf that contains the unit cell (i, j); NULL outside. */
const quad_cell *arc_quadtree_leaf(const quadtree *tree, int i, int j);

/* Edges of a leaf that have a hanging node: bit 0 j-min, 1 i-max, 2 j-max, 3 i-min. */
unsigned arc_quadtree_hanging(const quadtree *tree, const quad_cell *leaf);

#endif

/* A 2:1-balanced quadtree. */
#include "core/mesh/quadtree.h"

#include <stdlib.h>

static int leaf_index(const quadtree *tree, int i, int j) {
  const int root = 1 << tree->root_level;
  if (i < 0 || j < 0 || i >= tree->columns * root || j >= tree->lines * root) return -1;
  int at = i / root + j / root * tree->columns;
  while (tree->cell[at].child >= 0) {
    const quad_cell *c = &tree->cell[at];
    const int half = 1 << (c->level - 1);
    at = c->child + (i >= c->i + half) + 2 * (j >= c->j + half);
  }
  return at;
}

const quad_cell *arc_quadtree_leaf(const quadtree *tree, int i, int j) {
  const int at = leaf_index(tree, i, j);
  return at < 0 ? NULL : &tree->cell[at];
}

static arc_status split(quadtree *tree, int at) {
  if (tree->count + 4 > tree->capacity) {
    const int capacity = 2 * tree->capacity + 64;
    quad_cell *grown = realloc(tree->cell, (size_t)capacity * sizeof *grown);
    if (!grown) return ARC_MEMORY;
    tree->cell = grown;
    tree->capacity = capacity;
  }
  quad_cell *parent = &tree->cell[at];
  const int level = parent->level - 1, half = 1 << level;
  parent->child = tree->count;
  for (int q = 0; q < 4; q++)
    tree->cell[tree->count++] =
        (quad_cell){level, parent->i + half * (q & 1), parent->j + half * (q >> 1), -1};
  return ARC_OK;
}

/* Returns the level of the finest leaf on the other side of an edge of a cell. The function
 * tests the two unit cells outside the edge that are next to its middle. */
static int finest_neighbour(const quadtree *tree, const quad_cell *c, int edge) {
  const int w = 1 << c->level, half = w / 2;
  int finest = c->level;
  for (int part = 0; part < 2; part++) {
    const int along = part ? half : (half > 0 ? half - 1 : 0);
    int i = c->i, j = c->j;
    switch (edge) {
    case 0:
      i += along, j -= 1;
      break;
    case 1:
      i += w, j += along;
      break;
    case 2:
      i += along, j += w;
      break;
    default:
      i -= 1, j += along;
    }
    const int n = leaf_index(tree, i, j);
    if (n >= 0 && tree->cell[n].level < finest) finest = tree->cell[n].level;
  }
  return finest;
}

/* Returns true if a leaf must be split because the level of a neighbour is lower by more than
 * one. */
static int unbalanced(const quadtree *tree, const quad_cell *c) {
  if (c->level < 2) return 0;
  const int w = 1 << c->level, quarter = w / 4;
  for (int part = 0; part < 4; part++) {
    const int along = part * quarter;
    const int at[4][2] = {{c->i + along, c->j - 1},
                          {c->i + w, c->j + along},
                          {c->i + along, c->j + w},
                          {c->i - 1, c->j + along}};
    for (int edge = 0; edge < 4; edge++) {
      const int n = leaf_index(tree, at[edge][0], at[edge][1]);
      if (n >= 0 && tree->cell[n].level < c->level - 1) return 1;
    }
  }
  return 0;
}

arc_status arc_quadtree_build(quadtree *tree, int root_level, int columns, int lines,
                              quad_level_fn coarsest, const void *context) {
  *tree = (quadtree){.root_level = root_level, .columns = columns, .lines = lines};
  tree->capacity = columns * lines;
  tree->cell = malloc((size_t)tree->capacity * sizeof *tree->cell);
  if (!tree->cell) return ARC_MEMORY;
  const int root = 1 << root_level;
  for (int b = 0; b < lines; b++)
    for (int a = 0; a < columns; a++)
      tree->cell[tree->count++] = (quad_cell){root_level, a * root, b * root, -1};

  for (int changed = 1; changed;) {
    changed = 0;
    for (int at = 0; at < tree->count; at++) {
      const quad_cell *c = &tree->cell[at];
      if (c->child >= 0 || c->level == 0) continue;
      if (coarsest(context, c) >= c->level && !unbalanced(tree, c)) continue;
      if (split(tree, at) != ARC_OK) {
        arc_quadtree_free(tree);
        return ARC_MEMORY;
      }
      changed = 1;
    }
  }
  return ARC_OK;
}

void arc_quadtree_free(quadtree *tree) {
  free(tree->cell);
  *tree = (quadtree){0};
}

unsigned arc_quadtree_hanging(const quadtree *tree, const quad_cell *leaf) {
  unsigned mask = 0;
  for (int edge = 0; edge < 4; edge++)
    if (finest_neighbour(tree, leaf, edge) < leaf->level) mask |= 1u << edge;
  return mask;
}

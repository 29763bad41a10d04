/* Converts the leaves of the quadtree to elements: quadrilaterals, or triangles if an edge has a
 * hanging node. All patterns are symmetric, so that the elements of mirrored bodies are mirror
 * images. */
#include "core/mesh/tile.h"

#include <stdlib.h>

static arc_status add(mesh_builder *b, mesh_key p, mesh_key q, mesh_key r, mesh_key s) {
  if (b->count == b->capacity) {
    const int capacity = 2 * b->capacity + 256;
    mesh_key *grown = realloc(b->corner, 4 * (size_t)capacity * sizeof *grown);
    if (!grown) return ARC_MEMORY;
    b->corner = grown;
    b->capacity = capacity;
  }
  mesh_key *c = &b->corner[4 * b->count++];
  c[0] = p, c[1] = q, c[2] = r, c[3] = s;
  return ARC_OK;
}

static arc_status add_triangle(mesh_builder *b, mesh_key p, mesh_key q, mesh_key r) {
  return add(b, p, q, r, r);
}

/* Writes the corners and the hanging nodes of a leaf to `point` in circular order. Returns the
 * number of points. */
static int walk_around(const quad_cell *c, unsigned hanging, mesh_key point[8]) {
  const int w = 2 << c->level, i = 2 * c->i, j = 2 * c->j, h = w / 2;
  const mesh_key corner[4] = {{i, j}, {i + w, j}, {i + w, j + w}, {i, j + w}};
  const mesh_key middle[4] = {{i + h, j}, {i + w, j + h}, {i + h, j + w}, {i, j + h}};
  int n = 0;
  for (int e = 0; e < 4; e++) {
    point[n++] = corner[e];
    if (hanging & (1u << e)) point[n++] = middle[e];
  }
  return n;
}

/* Divides a leaf with one hanging node into three triangles around this node. point[middle] is
 * the hanging node. */
static arc_status close_one(mesh_builder *b, const mesh_key point[5], int middle) {
  for (int t = 1; t <= 3; t++) {
    const arc_status status =
        add_triangle(b, point[middle], point[(middle + t) % 5], point[(middle + t + 1) % 5]);
    if (status != ARC_OK) return status;
  }
  return ARC_OK;
}

/* Divides a leaf with several hanging nodes into triangles around the centre of the cell. */
static arc_status close_fan(mesh_builder *b, const quad_cell *c, const mesh_key *point, int n) {
  const mesh_key centre = {2 * c->i + (1 << c->level), 2 * c->j + (1 << c->level)};
  for (int t = 0; t < n; t++) {
    const arc_status status = add_triangle(b, centre, point[t], point[(t + 1) % n]);
    if (status != ARC_OK) return status;
  }
  return ARC_OK;
}

static arc_status add_leaf(mesh_builder *b, const quadtree *tree, const quad_cell *leaf) {
  mesh_key point[8];
  const unsigned hanging = arc_quadtree_hanging(tree, leaf);
  const int n = walk_around(leaf, hanging, point);
  if (n == 4) return add(b, point[0], point[1], point[2], point[3]);
  if (n > 5) return close_fan(b, leaf, point, n);
  int middle = 0;
  while (!(hanging & (1u << middle))) middle++;
  return close_one(b, point, middle + 1);
}

/* Adds a triangle between a leaf in the last row and the centre of a solid arc. The last row
 * ends at a small circle. The key of the centre is (0, last row + 1). */
static arc_status add_core(mesh_builder *b, const quadtree *tree, const quad_cell *leaf) {
  const int last = tree->lines << tree->root_level, w = 1 << leaf->level;
  if (!b->map.core || leaf->j + w != last) return ARC_OK;
  return add_triangle(b, (mesh_key){2 * leaf->i, 2 * last}, (mesh_key){2 * (leaf->i + w), 2 * last},
                      (mesh_key){0, 2 * last + 2});
}

arc_status arc_mesh_tile(mesh_builder *b, const quadtree *tree, int columns, int rows) {
  arc_status status = ARC_OK;
  for (int i = 0; i < columns && status == ARC_OK; i++)
    for (int j = 0; j < rows && status == ARC_OK; j++)
      status = add_leaf(b, tree, arc_quadtree_leaf(tree, i, j));
  for (int at = 0; at < tree->count && status == ARC_OK; at++) {
    const quad_cell *leaf = &tree->cell[at];
    if (leaf->child >= 0) continue;
    const int in_box = leaf->level == 0 && leaf->i < columns && leaf->j < rows;
    if (!in_box) status = add_leaf(b, tree, leaf);
    if (status == ARC_OK) status = add_core(b, tree, leaf);
  }
  return status;
}

/* Inside the mesher: a mesh under construction, as polygons over logical points. */
#ifndef MESH_BUILD_H
#define MESH_BUILD_H

#include "archard/mesh.h"
#include "core/mesh/map.h"
#include "core/mesh/quadtree.h"

/* Logical points are keyed in half units, so that a cell's middle has one too. */
typedef struct mesh_key {
  int i, j;
} mesh_key;

typedef struct mesh_builder {
  body_map map;
  int count, capacity;
  mesh_key *corner; /* [4 * capacity] corners of each element; a triangle repeats its third */
} mesh_builder;

/* Errors of arc_mesh_build that are known beforehand. */
arc_status arc_mesh_check(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                          arc_error *error);
/* Whether a name is a word, ARC_BODY_NAME but for its length. */
int arc_body_is_word(const char *name);
/* Names that are words, and stand for nothing else. */
arc_status arc_body_check_name(const arc_body_def *body, const char *path, arc_error *error);
/* What a profile consists of; INFINITY, and no height, for others. */
typedef struct body_waves {
  double form;   /* radius of the parabola that fits best [mm]: negative where that is hollow,
                    INFINITY where it is flat */
  double length; /* of the waves on it [mm], INFINITY: there are none */
  double height; /* from valleys to peaks [mm] */
} body_waves;
body_waves arc_body_waves(const arc_body_def *body);

/* About how many nodes a mesh will have. */
double arc_mesh_nodes(const arc_mesh_def *def, arc_body body, const arc_body_def *solid);

/* Adds the elements of the half body s >= 0: the wear box first, column by column, then the rest;
 * hanging nodes are closed with triangles. `columns` x `rows` is the half wear box. ARC_MEMORY. */
arc_status arc_mesh_tile(mesh_builder *builder, const quadtree *tree, int columns, int rows);

/* Chains the edges that only one element has into the boundary polygon; of a ring, whose boundary
 * is two, that with the surface. ARC_MEMORY or ARC_GEOMETRY.
 */
arc_status arc_mesh_outline(arc_mesh *mesh);

#endif

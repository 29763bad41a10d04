/* From the mesher's logical rectangle to space: s along the surface, d below it, both counted in
 * finest cells. */
#ifndef MESH_MAP_H
#define MESH_MAP_H

#include "archard/mesh.h"
#include "core/mesh/body_shape.h"

/* One body's map. Near the contact one unit is size x height exactly; further out the units are
 * stretched evenly so that whole root cells fill the body. Rows lie on the interfaces of layers. */
typedef struct body_map {
  const arc_body_def *solid;
  double up;             /* 1: the body lies above its surface, -1: below */
  int round, hollow;     /* an arc; the hollow side of one */
  int core;              /* a solid arc: its middle is closed by a fan */
  double radius;         /* [mm] of the surface */
  double size, height;   /* [mm] of one unit near the contact */
  double near_s, near_d; /* [mm] extent of the part that is not stretched (half width, depth) */
  double units_s;        /* [mm] logical half width and the physical one it maps to */
  double half_s;
  double units_d; /* [mm] logical depth, and the physical one but of a solid arc, which shrinks */
  double depth;
  int root_level;
  int columns, lines; /* root cells over the half body */
  double crest;       /* [mm] of a profile */
  int layers;
  double line[ARC_MOST_LAYERS];  /* row of each layer's lower end, in units */
  double shift[ARC_MOST_LAYERS]; /* [mm] what comes on top of the depth there */
} body_map;

/* Chooses roots and stretch for a body whose contact region is near_s x near_d [mm]. */
body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                           double near_s, double near_d);

/* Position [mm] of the logical point (i, j) in units; mirrored points are mirror images but for the
 * surface's height. */
void arc_body_map_point(const body_map *map, double i, double j, double xy[2]);

/* Physical size [mm] of one unit of width at logical depth j (that of solid arcs shrinks towards
 * their centre). */
double arc_body_map_unit(const body_map *map, double j);

/* Whether both ends of the surface are one: whole arcs. */
static inline int arc_body_map_closed(const body_map *map) {
  return arc_body_is_closed(map->solid);
}

#endif

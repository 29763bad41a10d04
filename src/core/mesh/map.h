/* Map from the mesher's logical rectangle to coordinates: s along the surface, d below it, both in
 * units of the finest cells. */
#ifndef MESH_MAP_H
#define MESH_MAP_H

#include "archard/mesh.h"
#include "core/mesh/body_shape.h"

/* Map of one body. Near the contact a unit is exactly size x height; farther out units are
 * stretched uniformly so that a whole number of root cells fills the body. Rows lie on the
 * interfaces of layers. */
typedef struct body_map {
  const arc_body_def *solid;
  double up;             /* 1: the body lies above its surface, -1: below */
  int round, hollow;     /* an arc; the hollow side of one */
  int core;              /* a solid arc: triangles close its centre */
  double radius;         /* [mm] of the surface */
  double size, height;   /* [mm] of one unit near the contact */
  double near_s, near_d; /* [mm] extent of the part that is not stretched (half width, depth) */
  double units_s;        /* [mm] logical half width, and its physical value */
  double half_s;
  double units_d; /* [mm] logical depth, and its physical value (except solid arcs) */
  double depth;
  int root_level;
  int columns, lines; /* root cells over the half body */
  double crest;       /* [mm] of a profile */
  int layers;
  double line[ARC_MOST_LAYERS];  /* row of each layer's lower end, in units */
  double shift[ARC_MOST_LAYERS]; /* [mm] change of the depth there */
} body_map;

/* Chooses roots and stretch for a body whose contact region is near_s x near_d [mm]. */
body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                           double near_s, double near_d);

/* Position [mm] of the logical point (i, j) in units. Mirrored points are exact mirror images,
 * apart from the height of the surface. */
void arc_body_map_point(const body_map *map, double i, double j, double xy[2]);

/* Physical size [mm] of one unit of width at logical depth j (that of solid arcs shrinks towards
 * their centre). */
double arc_body_map_unit(const body_map *map, double j);

/* True if the surface is closed: full circles. */
static inline int arc_body_map_closed(const body_map *map) {
  return arc_body_is_closed(map->solid);
}

#endif

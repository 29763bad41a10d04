/* Map from the mesher's logical rectangle to coordinates: s along the surface, d below it, both in
 * units of the finest cells. */
#ifndef MESH_MAP_H
#define MESH_MAP_H

#include "archard/mesh.h"
#include "core/mesh/body_shape.h"

/* Map of one body. Near the contact a unit is exactly size x height. Farther out, units are
 * stretched uniformly so that a whole number of root cells fills the body. Rows lie on the
 * interfaces of layers. */
typedef struct body_map {
  const arc_body_def *solid;
  double up;             /* 1: the body lies above its surface, -1: below */
  int round, hollow;     /* true for an arc; true for the hollow side of an arc */
  int core;              /* true for a solid arc, whose centre is closed by triangles */
  double radius;         /* [mm] radius of the surface */
  double size, height;   /* [mm] size of one unit near the contact */
  double near_s, near_d; /* [mm] extent of the part that is not stretched (half width, depth) */
  double units_s;        /* [mm] unstretched and physical half width */
  double half_s;
  double units_d; /* [mm] unstretched depth, physical depth (except solid arcs) */
  double depth;
  int root_level;
  int columns, lines; /* number of root cells over the half body */
  double crest;       /* [mm] heights of a profile */
  int layers;
  double line[ARC_MOST_LAYERS];  /* row of each layer's lower end, in units */
  double shift[ARC_MOST_LAYERS]; /* [mm] change of the depth at these rows */
} body_map;

/* Chooses roots and stretching for a body whose contact region is near_s x near_d [mm]. */
body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                           double near_s, double near_d);

/* Computes the position [mm] of the logical point (i, j); i and j count units of the finest cells.
 * Mirrored points are exact mirror images, except for the height of the surface. */
void arc_body_map_point(const body_map *map, double i, double j, double xy[2]);

/* Returns the physical width [mm] of one unit at logical depth j; in solid arcs it shrinks towards
 * the centre. */
double arc_body_map_unit(const body_map *map, double j);

/* Returns true if the surface is closed, as a full circle is. */
static inline int arc_body_map_closed(const body_map *map) {
  return arc_body_is_closed(map->solid);
}

#endif

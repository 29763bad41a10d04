/* Map of the mesher from logical coordinates to positions. The logical coordinates are s along
 * the surface and the depth d below the surface, in units of the finest cells. */
#ifndef MESH_MAP_H
#define MESH_MAP_H

#include "archard/mesh.h"
#include "core/mesh/body_shape.h"

/* Map of a body from the integer coordinates of the quadtree to positions [mm]. Near the contact
 * a unit is exactly one element wide and one element high. Farther away, units are stretched
 * uniformly so that a whole number of the largest cells fills the body. The interfaces of layers
 * are on rows of the grid. */
typedef struct body_map {
  const arc_body_def *solid;
  double up;             /* 1 if the body lies above its surface, -1 if below */
  int round, hollow;     /* round: true for an arc; hollow: true for an arc that is hollow */
  int core;              /* true for a solid arc, which has triangles at its centre */
  double radius;         /* radius of the surface [mm] */
  double size, height;   /* width and height of one unit near the contact [mm] */
  double near_s, near_d; /* half width and depth of the part that is not stretched [mm] */
  double units_s; /* half width of the body [mm] before stretching (units_s) and after (half_s) */
  double half_s;
  double units_d; /* depth of the body [mm] before stretching (units_d) and after (depth; unused
                     for solid arcs) */
  double depth;
  int root_level;
  int columns, lines; /* number of root cells along half the surface, and in depth */
  double crest;       /* height of the highest point of a profile [mm], see arc_body_crest */
  int layers;
  double line[ARC_MOST_LAYERS];  /* number of the row at the lower end of each layer */
  double shift[ARC_MOST_LAYERS]; /* change of the depth of this row [mm] */
} body_map;

/* Chooses root cells and stretching for a body with a contact region of near_s x near_d [mm]. */
body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                           double near_s, double near_d);

/* Computes the position [mm] of the logical point (i, j), which is given in units of the finest
 * cells. The points (i, j) and (-i, j) are exact mirror images, apart from the height of the
 * surface. */
void arc_body_map_point(const body_map *map, double i, double j, double xy[2]);

/* Returns the physical width [mm] of one unit at row j. In solid arcs the width decreases
 * towards the centre. */
double arc_body_map_unit(const body_map *map, double j);

/* Returns true if the surface is a closed curve, such as a full circle. */
static inline int arc_body_map_closed(const body_map *map) {
  return arc_body_is_closed(map->solid);
}

#endif

/* From the mesher's logical rectangle to space: s along the surface, d below it, both counted in
 * finest cells. */
#ifndef MESH_MAP_H
#define MESH_MAP_H

#include "archard/mesh.h"

/* One body's map. Near the contact one unit is size x height exactly; further out the units are
 * stretched evenly so that whole root cells fill the body. */
typedef struct body_map {
  arc_body body;
  double radius;
  double size, height;   /* [mm] of one unit near the contact */
  double near_s, near_d; /* [mm] extent of the part that is not stretched (half width, depth) */
  double units_s;        /* [mm] logical half width and the physical one it maps to */
  double half_s;
  double units_d; /* [mm] logical depth; the plate's physical depth is its radius */
  int root_level;
  int columns, lines; /* root cells over the half body */
} body_map;

/* Chooses roots and stretch for a body whose contact region is near_s x near_d [mm]. */
body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, double radius, double near_s,
                           double near_d);

/* Position [mm] of the logical point (i, j) in units, i >= 0. */
void arc_body_map_point(const body_map *map, double i, double j, double xy[2]);

/* Physical size [mm] of one unit of width at logical depth j (the cylinder's shrinks towards its
 * centre). */
double arc_body_map_unit(const body_map *map, double j);

#endif

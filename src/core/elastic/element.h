/* Plane-strain elements: CPE3, CPE4 and CPE4I. Engineering strains; Voigt order xx, yy, xy. */
#ifndef ELASTIC_ELEMENT_H
#define ELASTIC_ELEMENT_H

#include "archard/model.h"

/* D of plane strain [MPa]: sigma = D epsilon. */
typedef struct elasticity {
  double c11, c12, c33;
  double nu;
} elasticity;

elasticity arc_elasticity_of(arc_material material);

/* What "auto" means for a Poisson's ratio: CPE4, as in the paper, where its locking costs at most
 * 0.14 % of the pressure at 20 um (nu up to 0.4), else CPE4I. Other kinds are as they are. */
arc_element arc_element_for(arc_element kind, double nu);

/* Bulk modulus [MPa], and D without it: what resists changes of shape alone. */
double arc_elasticity_bulk(elasticity d);
elasticity arc_elasticity_deviatoric(elasticity d);

/* An element's corners; `corners` is 3 or 4. */
typedef struct element {
  int corners;
  arc_element kind; /* formulation of a quadrilateral */
  double xy[4][2];
} element;

/* The element with the corners corner[4] (-1 fourth: triangle) of a mesh with nodes xy. */
element arc_element_at(const double *xy, const int corner[4], arc_element kind);

/* Stiffness per mm of thickness [N/mm2], k [64], row-major 2 corners x 2 corners in the order x0 y0
 * x1 y1 ... */
void arc_element_stiffness(const element *e, elasticity d, double *k);

/* Change of a triangle's area by the displacements of its corners: gradient [6], in mm2 per mm.
 * Returns the area. */
double arc_triangle_swelling(const element *e, double gradient[6]);

/* Stress at the centre of the element from corner displacements u [2 corners]: xx, yy, xy [MPa]. */
void arc_element_stress(const element *e, elasticity d, const double *u, double stress[3]);

#endif

/* Plane elements CPE3, CPE4, CPE4I and the same in plane stress; elements of revolution CAX3 and
 * CAX4, whose quadrilaterals have one common dilatation if CPE4I is chosen. Engineering strains;
 * Voigt order xx, yy, xy. */
#ifndef ELASTIC_ELEMENT_H
#define ELASTIC_ELEMENT_H

#include "core/elastic/chart.h"

/* D [MPa]: sigma = D epsilon; c11 and c12 for all normal strains, in plane stress for those in the
 * plane; c22 for the strain along y, equal to c11 except where materials lie above each other. */
typedef struct elasticity {
  double c11, c12, c33, c22;
  double nu;
} elasticity;

/* Of plane strain and of revolution; in a space. */
elasticity arc_elasticity_of(arc_material material);
elasticity arc_elasticity_in(arc_space space, arc_material material);

/* What "auto" means for a Poisson's ratio: CPE4, as in the paper, where its locking costs at most
 * 0.14 % of the pressure at 20 um (nu up to 0.4), else CPE4I. Other kinds are as they are. */
arc_element arc_element_for(arc_element kind, double nu);

/* Bulk modulus [MPa], and D without it (the deviatoric part). */
double arc_elasticity_bulk(elasticity d);
elasticity arc_elasticity_deviatoric(elasticity d);

/* An element's corners; `corners` is 3 or 4. */
typedef struct element {
  int corners;
  arc_element kind; /* formulation of a quadrilateral */
  double xy[4][2];
  revolution revolved;
} element;

/* The element with the corners corner[4] (-1 fourth: triangle) of a mesh with nodes xy. */
element arc_element_at(const double *xy, const int corner[4], arc_element kind);

/* Stiffness per mm of thickness [N/mm2], of revolution that of the whole ring [N/mm], k [64],
 * row-major 2 corners x 2 corners in the order x0 y0 x1 y1 ... */
void arc_element_stiffness(const element *e, elasticity d, double *k);

/* Change of a triangle's area by the displacements of its corners: gradient [6], in mm2 per mm.
 * Returns the area. Of revolution: of its ring's volume [mm3]. */
double arc_triangle_swelling(const element *e, double gradient[6]);

/* Stress at the centre of the element from corner displacements u [2 corners]: xx, yy, xy [MPa]. */
void arc_element_stress(const element *e, elasticity d, const double *u, double stress[3]);

/* The same for elements of revolution (element_revolved.c). */
void arc_revolved_stiffness(const element *e, elasticity d, double *k);
double arc_revolved_swelling(const element *e, double gradient[6]);
void arc_revolved_stress(const element *e, elasticity d, const double *u, double stress[3]);

/* Gradients (gradients.c) of the corner functions, for a triangle and at a point of a
 * quadrilateral; both return the Jacobian's determinant. Gradients of functions of xi and eta from
 * their slopes there. Gradients of the two bubbles, divided by the determinant at the point. */
double arc_triangle_gradients(const element *e, double g[][2]);
double arc_quad_gradients(const element *e, double xi, double eta, double g[][2]);
void arc_quad_to_space(const element *e, double xi, double eta, int n, double slope[][2],
                       double g[][2]);
void arc_bubble_gradients(const element *e, double xi, double eta, double det, double g[][2]);

#endif

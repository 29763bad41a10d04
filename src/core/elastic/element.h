/* Plane elements CPE3, CPE4, CPE4I and their forms in plane stress; elements of revolution CAX3 and
 * CAX4, whose quadrilaterals have one common dilatation if CPE4I is chosen. Engineering strains;
 * Voigt order xx, yy, xy. */
#ifndef ELASTIC_ELEMENT_H
#define ELASTIC_ELEMENT_H

#include "core/elastic/chart.h"

/* Elasticity D [MPa], sigma = D epsilon. c11 and c12 apply to all normal strains (in plane stress
 * to those in the plane), c22 to the strain along y, where it equals c11 unless layers lie above
 * each other. */
typedef struct elasticity {
  double c11, c12, c33, c22;
  double nu;
} elasticity;

/* Returns the elasticity for plane strain and revolution, and for the given geometry. */
elasticity arc_elasticity_of(arc_material material);
elasticity arc_elasticity_in(arc_space space, arc_material material);

/* Returns the element type that "auto" means for a Poisson's ratio: CPE4, as in the paper, if its
 * locking costs at most 0.14 % of the pressure at 20 um (nu up to 0.4), else CPE4I. Other types are
 * returned unchanged. */
arc_element arc_element_for(arc_element kind, double nu);

/* Return the bulk modulus [MPa], and D without it (the deviatoric part). */
double arc_elasticity_bulk(elasticity d);
elasticity arc_elasticity_deviatoric(elasticity d);

/* The corners of an element; `corners` is 3 or 4. */
typedef struct element {
  int corners;
  arc_element kind; /* formulation of a quadrilateral */
  double xy[4][2];
  revolution revolved;
} element;

/* Returns the element with the corners corner[4] of a mesh with nodes xy; corner[3] is -1 for a
 * triangle. */
element arc_element_at(const double *xy, const int corner[4], arc_element kind);

/* Computes the stiffness per mm of thickness [N/mm2], for bodies of revolution that of the whole
 * ring [N/mm]: k [64], row-major 2 corners x 2 corners in the order x0 y0 x1 y1 ... */
void arc_element_stiffness(const element *e, elasticity d, double *k);

/* Computes the change of a triangle's area by the displacements of its corners, gradient [6] in mm2
 * per mm, and returns the area. For bodies of revolution it is the volume of the ring [mm3]. */
double arc_triangle_swelling(const element *e, double gradient[6]);

/* Computes the stress xx, yy, xy [MPa] at the centre of the element from corner displacements u [2
 * corners]. */
void arc_element_stress(const element *e, elasticity d, const double *u, double stress[3]);

/* Functions for elements of revolution with the same meaning (element_revolved.c). */
void arc_revolved_stiffness(const element *e, elasticity d, double *k);
double arc_revolved_swelling(const element *e, double gradient[6]);
void arc_revolved_stress(const element *e, elasticity d, const double *u, double stress[3]);

/* Gradients (gradients.c). The first two functions compute gradients of the corner functions, for a
 * triangle and at a point of a quadrilateral, and return the determinant of the Jacobian. The third
 * converts slopes by xi and eta at a point to gradients. The fourth computes the gradients of the
 * two bubbles, divided by the determinant at the point. */
double arc_triangle_gradients(const element *e, double g[][2]);
double arc_quad_gradients(const element *e, double xi, double eta, double g[][2]);
void arc_quad_to_space(const element *e, double xi, double eta, int n, double slope[][2],
                       double g[][2]);
void arc_bubble_gradients(const element *e, double xi, double eta, double det, double g[][2]);

#endif

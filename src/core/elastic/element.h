/* Plane-strain elements CPE3, CPE4 and CPE4I, their forms in plane stress, and the elements of
 * revolution CAX3 and CAX4. If CPE4I is chosen, CAX4 has the same dilatation in the whole
 * element (B-bar). Shear strains are engineering strains. The components are in the order xx,
 * yy, xy. */
#ifndef ELASTIC_ELEMENT_H
#define ELASTIC_ELEMENT_H

#include "core/elastic/chart.h"

/* Elasticity matrix D [MPa]; the stress is D times the strain. c11 and c12 apply to all normal
 * strains (in plane stress to the strains in the plane). c22 applies to the strain along y and
 * equals c11 unless D is a mean over several layers. */
typedef struct elasticity {
  double c11, c12, c33, c22;
  double nu;
} elasticity;

/* An element with 3 or 4 corners. */
typedef struct element {
  int corners;
  arc_element kind; /* formulation of a quadrilateral */
  double xy[4][2];
  revolution revolved;
} element;

/* --- element.c -------------------------------------------------------------------------------- */

/* arc_elasticity_of returns the elasticity for plane strain and bodies of revolution.
 * arc_elasticity_in returns the elasticity for a given geometry. */
elasticity arc_elasticity_of(arc_material material);
elasticity arc_elasticity_in(arc_space space, arc_material material);

/* Returns the element type that "auto" selects for a Poisson's ratio. It is CPE4 for ratios up to
 * 0.4, otherwise CPE4I. At a ratio of 0.4, locking of 20 um elements changes the pressure by at
 * most 0.14 %. Types other than "auto" are returned unchanged. */
arc_element arc_element_for(arc_element kind, double nu);

/* arc_elasticity_bulk returns the bulk modulus [MPa], arc_elasticity_deviatoric the deviatoric
 * part of D. */
double arc_elasticity_bulk(elasticity d);
elasticity arc_elasticity_deviatoric(elasticity d);

/* Returns the element with the corners corner[4] of a mesh with the nodes xy; corner[3] is -1
 * for a triangle. */
element arc_element_at(const double *xy, const int corner[4], arc_element kind);

/* Computes the stiffness k of an element: per mm of thickness [N/mm2] or, for bodies of
 * revolution, of the whole ring [N/mm]. k is a row-major matrix with two unknowns per corner (at
 * most 64 numbers), in the order x0 y0 x1 y1 ... */
void arc_element_stiffness(const element *e, elasticity d, double *k);

/* Returns the area of a triangle [mm2]. Sets gradient [6] to the change of the area per
 * displacement of the corners [mm]. For bodies of revolution the area is replaced by the volume
 * of the ring [mm3]. */
double arc_triangle_swelling(const element *e, double gradient[6]);

/* Computes the stress xx, yy, xy [MPa] at the centre of the element from the displacements u of
 * its corners, x and y of each corner in turn. */
void arc_element_stress(const element *e, elasticity d, const double *u, double stress[3]);

/* --- element_revolved.c ----------------------------------------------------------------------- */

/* Versions of arc_element_stiffness, arc_triangle_swelling and arc_element_stress for elements
 * of revolution (element_revolved.c). */
void arc_revolved_stiffness(const element *e, elasticity d, double *k);
double arc_revolved_swelling(const element *e, double gradient[6]);
void arc_revolved_stress(const element *e, elasticity d, const double *u, double stress[3]);

/* --- gradients.c ------------------------------------------------------------------------------ */

/* These functions compute gradients [1/mm] (gradients.c). The first two compute the gradients of
 * the corner functions of a triangle, and of a quadrilateral at (xi, eta), and return the
 * determinant of the Jacobian. arc_quad_to_space converts n derivatives by xi and eta to
 * gradients. arc_bubble_gradients computes the gradients of both bubbles; det is the determinant
 * at (xi, eta). */
double arc_triangle_gradients(const element *e, double g[][2]);
double arc_quad_gradients(const element *e, double xi, double eta, double g[][2]);
void arc_quad_to_space(const element *e, double xi, double eta, int n, double slope[][2],
                       double g[][2]);
void arc_bubble_gradients(const element *e, double xi, double eta, double det, double g[][2]);

#endif

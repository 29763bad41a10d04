/* Displacements due to shear on rectangular cells (Cerruti's solution), on homogeneous
 * half-spaces. */
#ifndef SPACE_CERRUTI_H
#define SPACE_CERRUTI_H

#include "core/space/halfspace.h"

/* Computes the integrals of x^2 / r^3, x z / r^3 and z^2 / r^3 [mm] over a rectangle of half
 * sides a x b [mm] whose centre is at (x, z). r is the distance of the integration point from
 * the origin. */
void arc_cerruti_integrals(double x, double z, double a, double b, double integral[3]);
/* Returns the integral of x / r^2 [mm] over the same rectangle as in arc_cerruti_integrals. */
double arc_cerruti_couple(double x, double z, double a, double b);

/* Returns the factor of the coupling between shear and gap [1/MPa]: the upper body's factor minus
 * the lower body's. It is 0 for bodies with the same elastic behaviour ("like bodies"). */
double arc_cerruti_unlike(const arc_halfspace_def *def);

/* Returns the kernels in *found and computes them at the first call. Errors: ARC_ARGUMENT for
 * layers, bases or periodic windows, which are not supported; ARC_MEMORY. */
arc_status arc_cerruti_kernels(arc_halfspace *h, const space_shear_kernels **found,
                               arc_error *error);
void arc_cerruti_destroy(space_shear_kernels **kernels);

/* Computes u = C q [window] [mm], the displacement along x and z of the upper surface relative to
 * the lower one due to the shear q [MPa] on the upper body and -q on the lower body. u may be the
 * same array as q. */
void arc_cerruti_shear(const arc_halfspace *h, const double *const q[2], double *const u[2]);
/* Computes u = C q like arc_cerruti_shear, at the cells of a box that contains all shear. The
 * values of u outside the box are unchanged. arc_cerruti_in_box must have been called for a box of
 * this size; it computes the kernels at the first call. Error: ARC_MEMORY. */
arc_status arc_cerruti_in_box(arc_halfspace *h, const space_box *box, arc_error *error);
void arc_cerruti_shear_in(const arc_halfspace *h, const space_box *box, const double *const q[2],
                          double *const u[2]);
/* Multiplies r by an approximate inverse of C, which is symmetric and positive definite, at the
 * cells of a box after arc_cerruti_in_box. r must be 0 at the cells of the box that carry no shear.
 */
void arc_cerruti_precondition(const arc_halfspace *h, const space_box *box, double *const r[2]);
/* Computes the displacement u [window] [mm] along one axis (0: x, 1: z) due to the shear along
 * the same axis. */
void arc_cerruti_along(const arc_halfspace *h, int axis, const double *q, double *u);
/* Adds N q, the normal displacement due to shear [mm], to gap [window], which is unchanged for like
 * bodies. */
void arc_cerruti_add_gap(const arc_halfspace *h, const double *const q[2], double *gap);
/* Adds N p, the tangential displacement due to pressure [mm], to slip [window]. */
void arc_cerruti_add_slip(const arc_halfspace *h, const double *pressure, double *const slip[2]);

#endif

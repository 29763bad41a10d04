/* Influence of shear on rectangular cells (Cerruti's solution), on homogeneous half-spaces. */
#ifndef SPACE_CERRUTI_H
#define SPACE_CERRUTI_H

#include "core/space/halfspace.h"

/* Integrals of x^2 / r^3, x z / r^3 and z^2 / r^3 [mm] over a rectangle of half sides a x b whose
 * centre is at (x, z); r is the distance of its points from the origin. */
void arc_cerruti_integrals(double x, double z, double a, double b, double integral[3]);
/* Returns the integral of x / r^2 [mm] over such a rectangle (see arc_cerruti_integrals). */
double arc_cerruti_couple(double x, double z, double a, double b);

/* Returns the factor of the coupling between shear and gap [1/MPa]: the upper body's factor minus
 * the lower body's. It is 0 for bodies with the same elastic behaviour ("like bodies"). */
double arc_cerruti_unlike(const arc_halfspace_def *def);

/* Computes the kernels on first use. Errors: ARC_ARGUMENT for layers, bases or periodic windows,
 * which are not supported; ARC_MEMORY. */
arc_status arc_cerruti_kernels(arc_halfspace *h, const space_shear_kernels **found,
                               arc_error *error);
void arc_cerruti_destroy(space_shear_kernels **kernels);

/* u := C q, the tangential displacement along x and z [window] of the lower surface relative to the
 * upper one, opposite to the shear q on the upper body; u may be the same array as q. */
void arc_cerruti_shear(const arc_halfspace *h, const double *const q[2], double *const u[2]);
/* u := displacement along one axis (0: x, 1: z) due to the shear along the same axis [window]. */
void arc_cerruti_along(const arc_halfspace *h, int axis, const double *q, double *u);
/* gap += N q, the normal displacement due to shear; gap is unchanged for equal materials. */
void arc_cerruti_add_gap(const arc_halfspace *h, const double *const q[2], double *gap);
/* slip += N p, the tangential displacement due to pressure. */
void arc_cerruti_add_slip(const arc_halfspace *h, const double *pressure, double *const slip[2]);

#endif

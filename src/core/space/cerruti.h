/* Influence of shear on rectangles of cells (Cerruti), on homogeneous half-spaces. */
#ifndef SPACE_CERRUTI_H
#define SPACE_CERRUTI_H

#include "core/space/halfspace.h"

/* Integrals over the rectangle of half sides a x b whose centre is (x, z) away, with r the distance
 * of its points: x^2 / r^3, x z / r^3, z^2 / r^3 [mm]. */
void arc_cerruti_integrals(double x, double z, double a, double b, double integral[3]);
/* That of x / r^2 [mm]. */
double arc_cerruti_couple(double x, double z, double a, double b);

/* Factor of the coupling between shear and gap [1/MPa]: that of the upper body less that of the
 * lower one; 0: like bodies. */
double arc_cerruti_unlike(const arc_halfspace_def *def);

/* Computes the kernels on first use. ARC_ARGUMENT: layers, bases or periodic windows, which are not
 * supported; ARC_MEMORY. */
arc_status arc_cerruti_kernels(arc_halfspace *h, const space_shear_kernels **found,
                               arc_error *error);
void arc_cerruti_destroy(space_shear_kernels **kernels);

/* u := C q, the displacement of the lower body's surface over the upper one's against shear q on
 * the upper body, along x and z [window]; u may be q. */
void arc_cerruti_shear(const arc_halfspace *h, const double *const q[2], double *const u[2]);
/* u := the displacement of the same along axis 0 (x) or 1 (z) by shear along it [window]. */
void arc_cerruti_along(const arc_halfspace *h, int axis, const double *q, double *u);
/* gap += N q, by shear; unchanged for equal materials. */
void arc_cerruti_add_gap(const arc_halfspace *h, const double *const q[2], double *gap);
/* slip += N p, by pressure. */
void arc_cerruti_add_slip(const arc_halfspace *h, const double *pressure, double *const slip[2]);

#endif

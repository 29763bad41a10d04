/* Members of arc_halfspace, and functions that the files in core/space share. */
#ifndef SPACE_HALFSPACE_H
#define SPACE_HALFSPACE_H

#include "archard/space.h"
#include "core/base/team.h"
#include "core/numeric/convolution.h"

#include <pthread.h>

enum { SPACE_LEVELS = 8 };

/* Convolution kernels for friction: the tangential displacement of the pair due to shear, and, on
 * the whole window, the coupling between shear and pressure if the bodies have different
 * materials. */
typedef struct space_shear_kernels {
  double self[2]; /* displacement of a cell along x and z due to unit shear on the cell [mm/MPa] */
  convolution
      *along[SPACE_LEVELS][SPACE_LEVELS]
            [3]; /* kernels for each box size, NULL until the first use: displacement along x due to
                    shear qx, along x due to qz (equal to z due to qx), along z due to qz */
  convolution *inverse[SPACE_LEVELS][SPACE_LEVELS][2]; /* preconditioners for qx and for qz */
  convolution *couple[2]; /* change of the gap due to qx and due to qz; NULL for like bodies
                             (arc_cerruti_unlike) */
  convolution_work *work; /* second workspace, for convolutions of two fields at once */
} space_shear_kernels;

struct arc_halfspace {
  arc_halfspace_def def;
  int cells;      /* number of cells in the window */
  int rows;       /* number of rows on the lower body */
  double *kernel; /* [nx][nz] displacement due to unit pressure on a cell, by distance in cells
                     [mm/MPa] */
  double *recess[ARC_BODIES];
  int level_x[SPACE_LEVELS], level_z[SPACE_LEVELS]; /* available box sizes [cells], largest first */
  convolution *convolution[SPACE_LEVELS][SPACE_LEVELS], *inverse[SPACE_LEVELS][SPACE_LEVELS];
  space_shear_kernels *shear; /* NULL until the first contact with friction */
  pthread_mutex_t lock;       /* protects the creation of convolutions, on first use */
  convolution_work **work;    /* one workspace per worker */
  double *scratch;            /* [workers][2][window] temporary values */
  work_team *team;
};

/* The part of the window that contains the contact: rows x to x + nx - 1 and columns z to z + nz -
 * 1. level_x and level_z are the indices of nx and nz in the lists of box sizes. */
typedef struct space_box {
  int x, z, nx, nz, level_x, level_z;
} space_box;

/* A range of row or column indices. */
typedef struct space_range {
  int low, high; /* empty if high < low */
} space_range;

static inline double space_x(const arc_halfspace_def *d, int rows, int i) {
  return (i - (rows - 1) / 2.0) * d->size_x;
}
static inline double space_z(const arc_halfspace_def *d, int j) {
  return (j - (d->nz - 1) / 2.0) * d->size_z;
}

/* --- cell_box.c ------------------------------------------------------------------------------- */

/* Chooses box sizes [cells] for short transforms in a window of n rows or columns, largest first.
 * Each size is even or odd like n, so the box can lie symmetrically in the window. */
void arc_space_box_sizes(int n, int periodic, int size[SPACE_LEVELS]);
/* Returns the box that covers the whole window. */
space_box arc_space_window(const arc_halfspace *h);
/* Extends a range to index k. */
void arc_space_extend(space_range *r, int k);
/* Extends the ranges to all rows and columns with a cell whose value [window] is positive. */
void arc_space_find_range(const arc_halfspace *h, const double *value, space_range *x,
                          space_range *z);
/* Returns the smallest box that contains the ranges of rows and columns, with a margin [cells]. If
 * `symmetric` is 1, the box lies symmetrically in x. */
space_box arc_space_box(const arc_halfspace *h, space_range x, space_range z, int margin,
                        int symmetric);

/* --- halfspace.c ------------------------------------------------------------------------------ */

/* Set *found to a convolution for boxes of one size: with the kernel of the compliance, or with the
 * inverse symbol for preconditioning. Each convolution is created at the first call. */
arc_status arc_space_convolution(arc_halfspace *h, int level_x, int level_z,
                                 const convolution **found, arc_error *error);
arc_status arc_space_inverse(arc_halfspace *h, int level_x, int level_z, const convolution **found,
                             arc_error *error);

/* Creates a preconditioner for boxes of rows x columns cells: the convolution with the inverse of
 * an even kernel's symbol on a box that is a quarter larger. Values of the symbol below its
 * smallest positive value are replaced by this value, so the inverse is positive definite. Error:
 * ARC_MEMORY.
 */
arc_status arc_space_make_inverse(int rows, int columns, lag_fn kernel, const void *context,
                                  convolution **made, arc_error *error);

/* Returns true if the surface of a body is an endless plane, without recess, wear and map. */
int arc_space_is_flat(const arc_halfspace *h, const double *const depth[ARC_BODIES], arc_body body);

/* Returns `number` rounded up to a whole number of cells. Results are limited to a quarter of the
 * largest integer, so that a sum of three results does not overflow. */
int arc_space_whole_cells(double number);

/* Computes Hertz' contact for relative radii along two perpendicular axes [mm] and a load [N]. The
 * effective modulus follows from the compliance of the pair to pressure waves about as long as the
 * contact. Errors: as for arc_hertz_ellipse_of. */
arc_status arc_space_estimate(const arc_halfspace_def *def, double radius_x, double radius_z,
                              double load, arc_hertz_ellipse *hertz);

/* --- kernel.c --------------------------------------------------------------------------------- */

/* Returns the displacement at the origin due to unit pressure on a rectangle of half sides a x b
 * whose centre is at (x, z), multiplied by the pair's E* (Love's solution) [mm]. */
double arc_space_love(double x, double z, double a, double b);
/* Returns u ln(v + r) with r^2 = u^2 + v^2. Integrals over rectangles are sums of these terms. */
double arc_space_term(double u, double v);

/* Returns the compliance of the pair to a pressure wave of wave number q [1/mm]: displacement per
 * pressure [mm/MPa]. */
double arc_space_symbol(const arc_halfspace_def *def, double q);
/* Returns 1 / E* of the topmost materials of the two bodies. */
double arc_space_surface_compliance(const arc_halfspace_def *def);

/* Adds to the kernel [nx][nz] the contribution of layers and bases, which is the difference from
 * half-spaces of the topmost materials. */
arc_status arc_space_add_layers(const arc_halfspace_def *def, double *kernel, arc_error *error);
/* Returns the smallest thickness of a top layer, or depth of a body without layers [mm]; 0 if
 * both bodies are homogeneous half-spaces. */
double arc_space_thinnest(const arc_halfspace_def *def);

/* --- guess.c ---------------------------------------------------------------------------------- */

/* Computes an initial guess of the pressures in a window from its gaps and the load. */
void arc_space_guess(const arc_halfspace *h, const double *gap, double load, double *pressure);

/* --- slide.c ---------------------------------------------------------------------------------- */

/* Returns the friction work of the last increment of a state at site k, per area [N/mm]: its slip
 * times its mean friction limit. `before` is its pressure before the increment. Sites that stick do
 * no work. */
double arc_space_work_at(double friction, double before, const arc_halfspace_friction *state,
                         int k);

#endif

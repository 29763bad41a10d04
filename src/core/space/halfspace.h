/* Members of half-spaces, and functions shared in core/space. */
#ifndef SPACE_HALFSPACE_H
#define SPACE_HALFSPACE_H

#include "archard/space.h"
#include "core/base/team.h"
#include "core/numeric/convolution.h"

#include <pthread.h>

enum { SPACE_LEVELS = 5 };

/* Displacements along the surface: of the pair by shear, and between shear and pressure where the
 * bodies differ. For the whole window. */
typedef struct space_shear_kernels {
  double self[2];         /* of a cell on itself along x and z [mm/MPa] */
  convolution *along[3];  /* x by qx, x by qz (and z by qx), z by qz */
  convolution *couple[2]; /* gap by qx and qz; NULL: equal materials */
  convolution_work *work; /* a second one, for pairs of fields */
} space_shear_kernels;

struct arc_halfspace {
  arc_halfspace_def def;
  int cells;      /* of the window */
  int rows;       /* of the lower body */
  double *kernel; /* [nx][nz] displacement at a lag under unit pressure of a cell [mm/MPa] */
  double *recess[ARC_BODIES];
  int level_x[SPACE_LEVELS], level_z[SPACE_LEVELS]; /* sizes of boxes, largest first */
  convolution *convolution[SPACE_LEVELS][SPACE_LEVELS], *inverse[SPACE_LEVELS][SPACE_LEVELS];
  space_shear_kernels *shear; /* NULL before the first contact with friction */
  pthread_mutex_t lock;       /* convolutions, created on first use */
  convolution_work **work;    /* of each worker */
  double *scratch;            /* [workers][2][window] */
  work_team *team;
};

/* A part of the window that contains the contact: rows x .. x + nx - 1, and similarly across. */
typedef struct space_box {
  int x, z, nx, nz, level_x, level_z;
} space_box;

/* The convolution for boxes of a size, created on first use; its inverse symbol, for
 * preconditioning. */
arc_status arc_space_convolution(arc_halfspace *h, int level_x, int level_z,
                                 const convolution **found, arc_error *error);
arc_status arc_space_inverse(arc_halfspace *h, int level_x, int level_z, const convolution **found,
                             arc_error *error);

/* Displacement of a cell's centre by unit pressure on a rectangle a x b [half sides], whose centre
 * is (x, z) away, times E* of the couple (Love). */
double arc_space_love(double x, double z, double a, double b);
/* u ln(v + r) with r^2 = u^2 + v^2, of which the integrals over rectangles are made. */
double arc_space_term(double u, double v);

/* Compliance of the pair to waves of q [1/mm]: displacement per pressure [mm/MPa]. */
double arc_space_symbol(const arc_halfspace_def *def, double q);
/* 1 / E* of the couple of the topmost materials. */
double arc_space_surface_compliance(const arc_halfspace_def *def);
/* Adds the rest beyond that of the topmost materials to the kernel [nx][nz], where there are layers
 * or bases. */
arc_status arc_space_add_layers(const arc_halfspace_def *def, double *kernel, arc_error *error);
/* Thickness of the thinnest top layer, or depth of a body without; 0: homogeneous half-spaces. */
double arc_space_thinnest(const arc_halfspace_def *def);

/* Hertz' contact of relative radii along and across the motion [mm] under a load [N], with the
 * modulus for waves of about the contact's length; errors of arc_hertz_ellipse_of. */
arc_status arc_space_estimate(const arc_halfspace_def *def, double radius_x, double radius_z,
                              double load, arc_hertz_ellipse *hertz);

/* Initial guess of pressures under a load from the gap of a window. */
void arc_space_guess(const arc_halfspace *h, const double *gap, double load, double *pressure);

static inline double space_x(const arc_halfspace_def *d, int rows, int i) {
  return (i - (rows - 1) / 2.0) * d->size_x;
}
static inline double space_z(const arc_halfspace_def *d, int j) {
  return (j - (d->nz - 1) / 2.0) * d->size_z;
}

#endif

/* Internal structures and functions of a joint, which is a spherical head in a cup: lattice of
 * cells, maps on the lattice, compliance on a window. */
#ifndef SPHERE_SPHERE_H
#define SPHERE_SPHERE_H

#include "archard/joint.h"
#include "core/numeric/active_set.h"
#include "core/numeric/convolution.h"

/* Compliance on a window of the lattice. The window has size / 2 rows and columns on each side of
 * the z axis. */
typedef struct sphere_kernel {
  int size;       /* number of rows and of columns */
  int box, waves; /* number of columns with zero padding; number of wave numbers, box / 2 + 1 */
  double *symbol; /* [waves][size][size] transform of the displacement at a cell due to unit
                     pressure on a source cell [mm/MPa] */
  row_transform *rows;        /* Fourier transform of `size` rows */
  double *spectrum, *product; /* [size][waves] complex spectrum; [waves][size] real and imaginary
                                 parts of its product with `symbol` */
} sphere_kernel;

struct arc_joint {
  arc_joint_def def;
  int rows, sites;                   /* number of rows of the lattice; number of sites, 2 rows^2 */
  double d;                          /* size of a cell [rad] */
  double *normal;                    /* [sites][3] unit normals */
  double *area;                      /* [sites] cell areas [mm2] */
  double *h[ARC_BODIES], *p, *shear; /* [sites] wear depths [mm]; [sites] pressures [MPa];
                                        [sites][3] sums for the cross-shear */
  double *creep,
      *pressed; /* [sites] creep [mm]; [sites] mean pressure of a cycle, summed over cycles [MPa] */
  double *remainder; /* table of the compliance without its part 1/chord (sphere_kernel.c) */
  double limit, K; /* limit of (l + 1/2) C_l at large degrees l [mm/MPa], with the compliance C_l of
                      degree l; stiffness of the Winkler foundation [MPa/mm] */
  int size;        /* number of rows and of columns of the window */
  sphere_kernel *kernel; /* NULL with a Winkler foundation */
  active_work *work;
  double *gap, *mode, *cell, *press,
      *soft; /* [window] gaps, cell areas, pressures, and wear per pressure (`soft`), which is added
                to the diagonal of the compliance; `mode` [3][window] normals */
  double *kept; /* [kept_count][window] initial pressures for the instants of a cycle */
  int kept_count;
};

/* Returns the index of the site of a window's cell. */
static inline int sphere_site(const arc_joint *j, int cell) {
  const int row = j->rows / 2 - j->size / 2 + cell / j->size;
  return row * 2 * j->rows + j->rows - j->size / 2 + cell % j->size;
}

/* One contact of a cycle: the head at a given rotation under a load [N]. The wear per pressure in
 * this contact is added to the compliance (j->soft): `dose` times the wear coefficient k of the
 * cell times the sliding distance due to omega. The initial pressures are those of the last contact
 * at the same instant, or are computed if `instant` is negative. arc_sphere_solve stores the
 * pressures in j->press [window] and enlarges the window until the pressures at its border are
 * zero. */
typedef struct sphere_stand {
  const double *rotation, *load;
  const double *omega, *k; /* rotation vector of the sliding motion [rad], NULL: no wear in this
                              contact; map of wear coefficients [mm2/N], NULL: 1 */
  double dose;             /* number of cycles, times the wear coefficient if k is NULL */
  int instant;
} sphere_stand;

/* --- sphere_compliance.c ---------------------------------------------------------------------- */

/* Returns the sum of (l + 1/2) C_l of both bodies [mm/MPa], with the compliance C_l of degree l, at
 * the largest degree that a lattice of `rows` rows resolves. The sum equals its limit for large
 * degrees unless the surface layer is thinner than a cell. */
double arc_sphere_limit(const arc_joint_def *def, int rows);
/* Returns the stiffness of the Winkler foundation [MPa/mm]. */
double arc_sphere_winkler(const arc_joint_def *def);

/* --- sphere_kernel.c -------------------------------------------------------------------------- */

/* Returns the table of the compliance without its part 1/chord, for arc_sphere_kernel. Returns NULL
 * if there is no memory, or with *numeric = 1 if the compliance cannot be computed. */
double *arc_sphere_remainder(const arc_joint_def *def, int rows, int *numeric);
sphere_kernel *arc_sphere_kernel(const arc_joint *j, int size);
void arc_sphere_kernel_free(sphere_kernel **k);
/* Computes the displacements u = C p [mm] on the window [size * size] due to the pressures p [MPa];
 * u and p may be the same array. */
void arc_sphere_kernel_apply(sphere_kernel *k, const double *p, double *u);

/* --- lattice.c -------------------------------------------------------------------------------- */

/* Sets the number of rows of the window and discards the pressures from which contact solutions
 * start. Error: ARC_MEMORY. */
arc_status arc_sphere_open(arc_joint *j, int size, arc_error *error);
/* Allocates the pressures from which contact solutions start, for each of the `instants` instants
 * of a cycle, and sets them to 0. Error: ARC_MEMORY. */
arc_status arc_sphere_make_kept(arc_joint *j, int instants, arc_error *error);
/* Enlarges the window and discards these pressures. Errors: ARC_ZONE if the window has its
 * largest size, ARC_MEMORY. */
arc_status arc_sphere_grow(arc_joint *j, arc_error *error);

/* Returns the value of a map in the direction n by cubic interpolation between sites;
 * arc_sphere_linear interpolates linearly. */
double arc_sphere_cubic(const arc_joint *j, const double *map, const double n[3]);
double arc_sphere_linear(const arc_joint *j, const double *map, const double n[3]);

/* Returns the sliding distance |omega x n| radius at a site [mm]. */
double arc_sphere_sliding(const arc_joint *j, const double omega[3], int site);
void arc_sphere_rotate(const double R[9], const double n[3], double to[3]);
void arc_sphere_rotate_back(const double R[9], const double n[3], double to[3]);

/* --- state.c ---------------------------------------------------------------------------------- */

/* Restores an earlier state of this joint. A window that has grown since then retains its size, and
 * the initial pressures are discarded. */
void arc_sphere_restore(arc_joint *j, const double *state);
/* Restores an earlier state and window after an error. A larger window remains if there is no
 * memory for the earlier one. */
void arc_sphere_back(arc_joint *j, const double *state, size_t count);

/* --- sphere_contact.c ------------------------------------------------------------------------- */

/* Returns the smallest angle between the cells under pressure and the cup's rim [degrees]. Without
 * contact, returns the cover angle. */
double arc_sphere_rim_margin(const arc_joint *j);

arc_status arc_sphere_solve(arc_joint *j, const sphere_stand *at, double approach[3],
                            int *iterations, arc_error *error);

#endif

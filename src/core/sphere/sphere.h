/* Inside of a joint: lattice, compliance on a window of it, maps. */
#ifndef SPHERE_SPHERE_H
#define SPHERE_SPHERE_H

#include "archard/joint.h"
#include "core/numeric/active_set.h"
#include "core/numeric/convolution.h"

/* Compliance of a window of the lattice: `half` rows and columns on each side of the z axis. */
typedef struct sphere_kernel {
  int size;                   /* rows and columns: 2 half */
  int box, waves;             /* padded columns; box / 2 + 1 */
  double *symbol;             /* [waves][size][size] times the area of the source's cell */
  row_transform *rows;        /* of `size` rows */
  double *spectrum, *product; /* [size][waves] pairs; by waves [waves][size] of each part */
} sphere_kernel;

struct arc_joint {
  arc_joint_def def;
  int rows, sites;                   /* of the lattice; 2 rows^2 */
  double d;                          /* [rad] of a cell */
  double *normal;                    /* [sites][3] */
  double *area;                      /* [sites] [mm2] */
  double *h[ARC_BODIES], *p, *shear; /* [sites], [sites], [sites][3] */
  double *creep, *pressed;           /* [sites] [mm]; integral of p over cycles [MPa] */
  double *remainder;                 /* table of the compliance less its 1/chord part */
  double limit, K;       /* large degrees (l + 1/2) C_l [mm/MPa]; Winkler's stiffness [MPa/mm] */
  int size;              /* rows and columns of the window */
  sphere_kernel *kernel; /* NULL with Winkler's foundation */
  active_work *work;
  double *gap, *mode, *cell, *press, *soft; /* of the window; mode [3]; soft: added diagonal */
  double *kept; /* [kept_count][window]: pressures to start the instants from */
  int kept_count;
};

/* A over (l + 1/2), both bodies; stiffness of springs. */
double arc_sphere_limit(const arc_joint_def *def);
double arc_sphere_winkler(const arc_joint_def *def);

/* Table of the remainder for arc_sphere_kernel; NULL: no memory, or (*numeric) no compliance. */
double *arc_sphere_remainder(const arc_joint_def *def, int rows, int *numeric);
sphere_kernel *arc_sphere_kernel(const arc_joint *j, int size);
void arc_sphere_kernel_free(sphere_kernel **k);
/* u := C p on the window [size * size]; they may be the same. */
void arc_sphere_kernel_apply(sphere_kernel *k, const double *p, double *u);

/* Site of a cell of the window. */
static inline int sphere_site(const arc_joint *j, int cell) {
  const int row = j->rows / 2 - j->size / 2 + cell / j->size;
  return row * 2 * j->rows + j->rows - j->size / 2 + cell % j->size;
}

/* A window of so many rows; ARC_MEMORY. Pressures to start from are lost. */
arc_status arc_sphere_open(arc_joint *j, int size, arc_error *error);
/* So many instants to start from, of pressures 0; ARC_MEMORY. */
arc_status arc_sphere_make_kept(arc_joint *j, int instants, arc_error *error);
/* Back to an earlier state of this joint; a window that has grown since stays, and its pressures to
 * start from are lost. */
void arc_sphere_restore(arc_joint *j, const double *state);
/* Larger window; ARC_ZONE where there is none, ARC_MEMORY. Pressures to start from are lost. */
arc_status arc_sphere_grow(arc_joint *j, arc_error *error);

/* The value of a map at n: cubic between sites, or linear and with 0 beyond. */
double arc_sphere_cubic(const arc_joint *j, const double *map, const double n[3]);
double arc_sphere_linear(const arc_joint *j, const double *map, const double n[3]);

/* One contact: the head at rotation R under a load [N], with j->soft added to the compliance by
 * `dose` [mm/MPa] per mm of sliding of the rotation vector omega times k (a map, NULL: 1). Starts
 * from the pressures kept of an instant, negative: none. Leaves pressures in j->press [window]; the
 * window grows until its rim is free. */
typedef struct sphere_stand {
  const double *rotation, *load;
  const double *omega, *k; /* NULL: no wear meanwhile */
  double dose;             /* cycles, times k where that is NULL */
  int instant;
} sphere_stand;
arc_status arc_sphere_solve(arc_joint *j, const sphere_stand *at, double approach[3],
                            int *iterations, arc_error *error);

/* |omega x n| radius [mm]. */
double arc_sphere_sliding(const arc_joint *j, const double omega[3], int site);
void arc_sphere_rotate(const double R[9], const double n[3], double to[3]);
void arc_sphere_rotate_back(const double R[9], const double n[3], double to[3]);

#endif

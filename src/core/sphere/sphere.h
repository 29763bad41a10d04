/* Internal structures of a joint: lattice, compliance on a window of it, maps. */
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
  double *remainder;                 /* table of the compliance without its 1/chord part */
  double limit, K;       /* large degrees (l + 1/2) C_l [mm/MPa]; Winkler's stiffness [MPa/mm] */
  int size;              /* rows and columns of the window */
  sphere_kernel *kernel; /* NULL with Winkler's foundation */
  active_work *work;
  double *gap, *mode, *cell, *press, *soft; /* of the window; mode [3]; soft: added diagonal */
  double *kept; /* [kept_count][window]: initial pressures of the instants */
  int kept_count;
};

/* (l + 1/2) C_l of both bodies at the degree that the cells of `rows` resolve: the limit of large
 * degrees unless the surface layer is thinner than a cell. */
double arc_sphere_limit(const arc_joint_def *def, int rows);
/* Stiffness of springs [MPa/mm]. */
double arc_sphere_winkler(const arc_joint_def *def);

/* Table of the remainder for arc_sphere_kernel; NULL: no memory, or (*numeric) no compliance. */
double *arc_sphere_remainder(const arc_joint_def *def, int rows, int *numeric);
sphere_kernel *arc_sphere_kernel(const arc_joint *j, int size);
void arc_sphere_kernel_free(sphere_kernel **k);
/* u := C p on the window [size * size]; u and p may be the same array. */
void arc_sphere_kernel_apply(sphere_kernel *k, const double *p, double *u);

/* Site of a cell of the window. */
static inline int sphere_site(const arc_joint *j, int cell) {
  const int row = j->rows / 2 - j->size / 2 + cell / j->size;
  return row * 2 * j->rows + j->rows - j->size / 2 + cell % j->size;
}

/* Sets the number of rows of the window; discards initial pressures. ARC_MEMORY. */
arc_status arc_sphere_open(arc_joint *j, int size, arc_error *error);
/* Sets the number of instants with initial pressures, all 0. ARC_MEMORY. */
arc_status arc_sphere_make_kept(arc_joint *j, int instants, arc_error *error);
/* Restores an earlier state of this joint. A window that has grown since is kept, without initial
 * pressures. */
void arc_sphere_restore(arc_joint *j, const double *state);
/* Restores an earlier state and window after a failure; a larger window is kept if there is no
 * memory to restore it. */
void arc_sphere_back(arc_joint *j, const double *state, size_t count);
/* Enlarges the window and discards initial pressures. ARC_ZONE: it has its largest size;
 * ARC_MEMORY. */
arc_status arc_sphere_grow(arc_joint *j, arc_error *error);

/* The value of a map at n: cubic between sites, or linear and with 0 beyond. */
double arc_sphere_cubic(const arc_joint *j, const double *map, const double n[3]);
double arc_sphere_linear(const arc_joint *j, const double *map, const double n[3]);

/* Solves one contact: the head at rotation R under a load [N], with j->soft added to the compliance
 * by `dose` [mm/MPa] per mm of sliding of the rotation vector omega times k (a map, NULL: 1).
 * Initial pressures are those of the last contact at this instant; negative: none. Stores the
 * pressures in j->press [window]; the window is enlarged until pressures at its rim are zero. */
typedef struct sphere_stand {
  const double *rotation, *load;
  const double *omega, *k; /* NULL: no wear in this contact */
  double dose;             /* cycles, times k if k is NULL */
  int instant;
} sphere_stand;
/* Angle between the pressed cells and the cup's rim [degrees]; the cover without contact. */
double arc_sphere_rim_margin(const arc_joint *j);

arc_status arc_sphere_solve(arc_joint *j, const sphere_stand *at, double approach[3],
                            int *iterations, arc_error *error);

/* |omega x n| radius [mm]. */
double arc_sphere_sliding(const arc_joint *j, const double omega[3], int site);
void arc_sphere_rotate(const double R[9], const double n[3], double to[3]);
void arc_sphere_rotate_back(const double R[9], const double n[3], double to[3]);

#endif

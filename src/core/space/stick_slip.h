/* Solves for stick and slip of the cells of a contact with known pressures. The unknowns are the
 * shear q and the slip along x and z. Either the motion xi is given, or the tangential force, which
 * is the sum of area times q:
 *
 *   slip = known + xi - C q,  |q| <= bound,  slip = 0 where |q| < bound, else along q
 *
 * The solution is the minimum of the convex function q C q / 2 - q (known + xi) over |q| <= bound.
 *
 * The method is an active-set method: cells that stick have two unknowns, and cells that slip have
 * one, along the circle |q| = bound. Newton's method solves for the unknowns, with conjugate
 * gradients for its linear problems. */
#ifndef SPACE_STICK_SLIP_H
#define SPACE_STICK_SLIP_H

#include "core/space/cerruti.h"

typedef enum stick_slip_state { SHEAR_NONE, SHEAR_STICK, SHEAR_SLIP } stick_slip_state;

typedef struct stick_slip_problem {
  arc_halfspace *h;
  const double *bound;    /* friction limit [window] [MPa]; 0: the cell carries no shear */
  const double *known[2]; /* [window] known part of the slip [mm] */
  int by_force[2];        /* for x and z: 1 if the force is given and xi is computed */
  double force[2];        /* [N] */
  double tolerance;       /* tolerance of the slip, relative to the largest displacement C q */
  const arc_callbacks *callbacks;
} stick_slip_problem;

typedef struct stick_slip_count {
  int sets, iterations, applications;
  int flipping; /* number of solutions that ended while some cells still alternated between stick
                   and slip */
} stick_slip_count;

/* A cell that carries shear in a Newton step. */
typedef struct stick_slip_site {
  int cell;
  double free[3]; /* projection onto the free directions (x and z if the cell sticks, the tangent if
                     it slips), a symmetric matrix as xx, xz and zz */
  double slip;    /* slip divided by the friction limit, 0 if the cell sticks */
  double share;   /* square root of the operator's diagonal without slip, divided by the diagonal */
} stick_slip_site;

/* Initial values, results and workspace of a stick-slip solution. */
typedef struct stick_slip_work {
  double *q[2];            /* [window] shear [MPa]; input and output */
  double *slip[2];         /* [window] slip [mm]; output, also for cells without shear */
  double xi[2];            /* motion [mm]; input and output */
  stick_slip_state *state; /* [window] state of each cell; input and output */
  double *tangent[2];      /* [window] unit vectors at cells that slip */
  double *diagonal;        /* [window] slip divided by the friction limit, at cells that slip */
  double *r[2], *z[2], *d[2],
      *a[2]; /* residual, preconditioned residual, search direction, operator times direction */
  double *shape[2][2]; /* changes of the shear that increase the forces along x and z */
  space_box box; /* box of the cells that may carry shear; outside this box `a` is 0 during the
                    solution */
  stick_slip_site *site; /* [sites] cells that carry shear in the present Newton step */
  int sites;
  double *block;
} stick_slip_work;

/* --- stick_slip.c ----------------------------------------------------------------------------- */

/* Allocates the workspace and sets it to zero. On failure (ARC_MEMORY) its members are NULL. */
arc_status arc_stick_slip_begin(stick_slip_work *w, int cells, arc_error *error);
void arc_stick_slip_end(stick_slip_work *w);

/* Solves for shear, slip and motion. Errors: ARC_ARGUMENT for a force above the friction limit,
 * ARC_NOT_CONVERGED, ARC_STOPPED. After an error the contents of q and xi are undefined. */
arc_status arc_stick_slip_solve(const stick_slip_problem *problem, stick_slip_work *work,
                                stick_slip_count *count, arc_error *error);

/* --- stick_slip_newton.c ---------------------------------------------------------------------- */

/* Adds shear to q, where cells slip only along the tangent, so that its sums equal the given
 * forces. Returns 0 if the sets cannot carry the forces; q is then unchanged. */
int arc_stick_slip_set_forces(const stick_slip_problem *problem, stick_slip_work *work);

/* Subtracts the mean slip of the free directions from xi and from the slip of all cells, along axes
 * with given forces. The mean is weighted by the shear that arc_stick_slip_set_forces adds. */
void arc_stick_slip_move(const stick_slip_problem *problem, stick_slip_work *work);

/* Lists the cells that carry shear, and computes their residual: both components of the slip at
 * sticking cells, and the component along the tangent at slipping cells. Returns the largest one
 * [mm]. */
double arc_stick_slip_residual(const stick_slip_problem *problem, stick_slip_work *work);

/* Makes one Newton step from the present q, its residual, and the shapes of
 * arc_stick_slip_set_forces: solves for the changes of q and xi on the present sets, and adds these
 * changes. Where cells slip, q changes only along the tangent. The linear iteration stops at the
 * residual `least` [mm] or at the fraction `share` of the first residual. */
void arc_stick_slip_newton(const stick_slip_problem *problem, stick_slip_work *work, double share,
                           double least, stick_slip_count *count);

#endif

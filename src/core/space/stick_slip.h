/* Stick and slip over the cells of a contact whose pressures are known:
 *
 *   slip = known + xi - C q,  |q| <= bound,  slip = 0 where |q| < bound, else along q
 *
 * for shear q and slip along x and z, with the motion xi given, or its force sum of area q. It is
 * the minimum of q C q / 2 - q (known + xi) over |q| <= bound: convex.
 *
 * An active set: cells that stick have two unknowns, cells that slip one, along the circle |q| =
 * bound, with Newton's method on it and conjugate gradients inside. */
#ifndef SPACE_STICK_SLIP_H
#define SPACE_STICK_SLIP_H

#include "core/space/cerruti.h"

typedef enum stick_slip_state { SHEAR_NONE, SHEAR_STICK, SHEAR_SLIP } stick_slip_state;

typedef struct stick_slip_problem {
  arc_halfspace *h;
  const double *bound;    /* [window] [MPa]; 0: the cell carries no shear */
  const double *known[2]; /* [window] [mm] */
  int by_force[2];        /* along x and z: the force is given, xi is computed */
  double force[2];        /* [N] */
  double tolerance;       /* of slip, relative to the largest displacement C q */
  const arc_callbacks *callbacks;
} stick_slip_problem;

typedef struct stick_slip_count {
  int sets, iterations, applications;
  int flipping; /* increments that ended with cells alternating between stick and slip */
} stick_slip_count;

/* Initial values, results and workspace of a solution. */
typedef struct stick_slip_work {
  double *q[2];                      /* [window] in and out */
  double *slip[2];                   /* [window] out, of cells without shear too */
  double xi[2];                      /* in and out */
  stick_slip_state *state;           /* [window] in and out */
  double *tangent[2];                /* [window] of unit length where cells slip */
  double *diagonal;                  /* [window] slip over bound */
  double *r[2], *z[2], *d[2], *a[2]; /* residual, preconditioned, direction, operator on it */
  int *site, sites;                  /* cells that carry shear, of the present Newton step */
  double *block;
} stick_slip_work;

/* All zero; NULL members on failure: ARC_MEMORY. */
arc_status arc_stick_slip_begin(stick_slip_work *w, int cells, arc_error *error);
void arc_stick_slip_end(stick_slip_work *w);

/* ARC_ARGUMENT: a force that friction does not carry; ARC_NOT_CONVERGED, ARC_STOPPED. q and xi are
 * spoilt then. */
arc_status arc_stick_slip_solve(const stick_slip_problem *problem, stick_slip_work *work,
                                stick_slip_count *count, arc_error *error);

/* One Newton step: solves for the changes of q on the present sets, with slip of the present q, and
 * adds them to q, along tangents where cells slip, and to xi. `least`: residual [mm] from which
 * on it stops; it stops at a tenth of the first one too.
 * Returns 0 where the sets cannot carry the forces. */
int arc_stick_slip_newton(const stick_slip_problem *problem, stick_slip_work *work, double least,
                          stick_slip_count *count);

/* Largest slip error [mm]: of sticking cells, and along the tangents. */
double arc_stick_slip_residual(const stick_slip_problem *problem, const stick_slip_work *work);

#endif

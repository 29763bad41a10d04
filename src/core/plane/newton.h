/* The equation of an implicit stage in the plane, and what solves it. */
#ifndef PLANE_NEWTON_H
#define PLANE_NEWTON_H

#include "core/plane/cycle.h"

/* Arrays [n]. */
typedef struct newton {
  wear_stage *at;
  int n;       /* nodes of both surfaces */
  double area; /* what a cycle of the last evaluation wears [mm2] */
  double *residual, *step, *packed;
  double *start;                 /* z of a stage at first */
  double *defect, *last, *taken; /* steps: the plain one, the one before, and as accelerated */
  int nearer;                    /* the last iteration came nearer to the solution */
  wear_tangent *jacobian;
  double coarse;  /* jacobian->width of a kept one */
  double *matrix; /* [live x live] factors of I + h k J */
  int live, *node, *pivots;
  double h; /* cycles [-] the factors belong to; 0: none */
} newton;

arc_status arc_newton_begin(wear_stage *stage);
void arc_newton_end(wear_stage *stage, double cycles, wear_depths *depth);
/* Wear per cycle at z = 0 into `rate`, with the Jacobian. */
arc_status arc_newton_start(wear_stage *stage, double *rate);
/* Solves z = known + h rate(z) from the present z, whose rate is `rate`, and with the Jacobian of
 * the last evaluation that had one; rate becomes that of the solution, and z = known + h rate to
 * the bit. ARC_NOT_CONVERGED: try a shorter step. */
arc_status arc_newton_solve(wear_stage *stage, double h, double *rate);
/* Filters stiff ripples out of a defect, and returns the largest change of a pressure with it. */
double arc_newton_error(wear_stage *stage, double h, double *defect);

#endif

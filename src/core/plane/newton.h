/* Implicit stages in the plane: one complementarity problem for a contact at rest, else Newton's
 * method on the depths. */
#ifndef PLANE_NEWTON_H
#define PLANE_NEWTON_H

#include "core/plane/cycle.h"

/* Arrays [n]. */
typedef struct newton {
  wear_stage *at;
  int n;        /* nodes of both surfaces */
  double area;  /* worn area of a cycle in the last evaluation [mm2] */
  int rests;    /* 1: a single contact at rest under one load */
  int mirrored; /* 1: depths are symmetric about x = 0, to the bit */
  double *residual, *step;

  /* for a moving contact */
  double *packed;
  double *defect, *last, *taken; /* steps: the plain one, the one before, and as accelerated */
  wear_tangent *jacobian;
  double *matrix; /* [live x live] factors of I + h k J */
  int live, *node, *pivots;
  double h; /* cycles [-] the factors belong to; 0: none */

  /* for a contact at rest */
  contact_problem with_wear; /* it, with the wear of its forces in the compliance */
  double *per_force;         /* wear depth per force on a node [mm per N/mm] */
  double *opening;           /* of the gap, per depth [-] */
  double *moved, *force;     /* work; force by cylinder node [N/mm] */
} newton;

arc_status arc_newton_begin(wear_stage *stage);
void arc_newton_end(wear_stage *stage, double cycles, wear_depths *depth);
/* Computes the wear per cycle at z = 0 into `rate`. */
arc_status arc_newton_start(wear_stage *stage, double *rate);
/* Solves z = known + h rate(z) from the present z, whose rate is `rate`, which becomes that of the
 * solution: z = known + h rate to the bit. ARC_ZONE: the run has grown out of its mesh;
 * ARC_NOT_CONVERGED: try a shorter step. */
arc_status arc_newton_solve(wear_stage *stage, double h, double *rate);
/* Filters stiff ripples out of a defect, and returns the largest share of the load that it shifts
 * along the surface; negative: not available. */
double arc_newton_error(wear_stage *stage, double h, double *defect);

/* --- for rest_stage.c ------------------------------------------------------------------------- */
/* Share of the largest coefficient by which node i wears at the present z. */
double arc_newton_share(const newton *s, int i);
/* k times the wear of a cycle at the present z, with the Jacobian or without. */
arc_status arc_newton_evaluate(newton *s, double *rate, int with_jacobian);
/* residual = z - known - h rate; its largest entry, and the tolerance [mm]. */
double arc_newton_residual(newton *s, double h, const double *rate);
double arc_newton_allowed(const newton *s);
/* True if a shorter step would not help. */
int arc_newton_is_hopeless(const newton *s, arc_status status);

/* --- rest_stage.c ----------------------------------------------------------------------------- */
/* True if all points of the window are one contact under one load, without friction and elastic
 * slip. */
int arc_stage_rests(const wear_stage *stage);
arc_status arc_stage_solve_rest(newton *s, double h, double *rate);
/* Converts gap changes [active] of a solved problem to changes of its forces. Returns the largest
 * part of the load shifted along the surface. */
double arc_stage_forces(contact_problem *p, double *gap);
/* arc_newton_error for a stage solved by this function. */
double arc_stage_rest_error(newton *s, double *defect);

#endif

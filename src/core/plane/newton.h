/* Implicit stages of a step in plane models. For a contact at rest, a stage is one
 * complementarity problem. For a moving contact, Newton's method computes the depths. */
#ifndef PLANE_NEWTON_H
#define PLANE_NEWTON_H

#include "core/plane/cycle.h"

/* Workspace of a step. Arrays have one entry per surface node of both bodies unless stated
 * otherwise. */
typedef struct newton {
  wear_stage *at;
  int n;        /* number of surface nodes of both bodies */
  double area;  /* cross-sectional area lost per cycle in the last evaluation [mm2] */
  int rests;    /* true if the contact stays at one position under a constant load */
  int mirrored; /* true if the depths are exactly symmetric about x = 0 */
  double *residual, *step;

  /* members for a moving contact */
  double *packed;
  double *defect, *last, *taken; /* Newton step, previous Newton step, previous accepted step */
  wear_tangent *jacobian;
  double *matrix; /* triangular factors of I + h k J for the `live` unknowns */
  int live, *node, *pivots;
  double h; /* stage length h of these factors [cycles]; 0: not factorised */

  /* members for a contact at rest */
  contact_problem with_wear; /* contact problem with the wear added to its compliance */
  double *per_force;         /* wear depth per force on a node [mm per N/mm] */
  double *opening;           /* change of the gap per depth of wear at each node [-] */
  double *moved, *force;     /* workspace; forces on the cylinder's nodes [N/mm] */
} newton;

/* --- newton.c --------------------------------------------------------------------------------- */

arc_status arc_newton_begin(wear_stage *stage);
void arc_newton_end(wear_stage *stage, double cycles, wear_depths *depth);
/* Computes the wear per cycle at the start of a step, where z = 0, and stores it in `rate` [mm
 * per cycle]. */
arc_status arc_newton_start(wear_stage *stage, double *rate);
/* Solves z = known + h rate(z). On input z and `rate` are the initial guess. On return z equals
 * known + h rate exactly. Errors: ARC_ZONE if the run has outgrown its mesh; ARC_NOT_CONVERGED
 * if a shorter step is necessary. */
arc_status arc_newton_solve(wear_stage *stage, double h, double *rate);
/* Removes stiff ripples from `defect`, the estimated error of the depths. Returns the largest
 * fraction of the load that the remaining error moves along the surface, or a negative number if
 * this fraction cannot be computed. */
double arc_newton_error(wear_stage *stage, double h, double *defect);

/* --- for rest_stage.c ------------------------------------------------------------------------- */
/* Returns the wear coefficient at node i for the present z, divided by the largest wear
 * coefficient of the body. */
double arc_newton_share(const newton *s, int i);
/* Computes the wear per cycle at the present z, including the wear coefficients. Also computes
 * the Jacobian if `with_jacobian` is true. */
arc_status arc_newton_evaluate(newton *s, double *rate, int with_jacobian);
/* arc_newton_residual computes residual = z - known - h rate and returns its largest absolute
 * value [mm]. arc_newton_allowed returns the largest accepted residual [mm]. */
double arc_newton_residual(newton *s, double h, const double *rate);
double arc_newton_allowed(const newton *s);
/* Returns true if a shorter step cannot avoid the error `status`. */
int arc_newton_is_hopeless(const newton *s, arc_status status);

/* --- rest_stage.c ----------------------------------------------------------------------------- */

/* Returns true if all points of the window have the same contact under the same load, without
 * friction and without elastic slip. */
int arc_stage_rests(const wear_stage *stage);
arc_status arc_stage_solve_rest(newton *s, double h, double *rate);
/* Replaces changes of the gaps of a solved problem by the resulting changes of its forces under a
 * constant load. The array `gap` has one entry per node in contact. Returns the largest absolute
 * value of the sum of these changes from the left end to a node, divided by the load. */
double arc_stage_forces(contact_problem *p, double *gap);
/* Computes the result of arc_newton_error for a contact at rest. */
double arc_stage_rest_error(newton *s, double *defect);

#endif

/* Implicit stages in the plane. For a contact at rest a stage is one complementarity problem; for a
 * moving contact Newton's method solves for the depths. */
#ifndef PLANE_NEWTON_H
#define PLANE_NEWTON_H

#include "core/plane/cycle.h"

/* Workspace of a step. Arrays have n entries unless stated otherwise. */
typedef struct newton {
  wear_stage *at;
  int n;        /* number of nodes of both surfaces */
  double area;  /* worn area of a cycle in the last evaluation [mm2] */
  int rests;    /* 1: single contact at rest under one load */
  int mirrored; /* 1: depths are symmetric about x = 0, to the bit */
  double *residual, *step;

  /* for a moving contact */
  double *packed;
  double *defect, *last, *taken; /* the plain step, the previous plain step, the step made */
  wear_tangent *jacobian;
  double *matrix; /* [live x live] factors of I + h k J */
  int live, *node, *pivots;
  double h; /* number of cycles of these factors; 0: none */

  /* for a contact at rest */
  contact_problem with_wear; /* problem whose compliance includes the wear of its forces */
  double *per_force;         /* wear depth per force on a node [mm per N/mm] */
  double *opening;           /* change of the gap per depth [-] */
  double *moved, *force;     /* workspace; force by cylinder node [N/mm] */
} newton;

arc_status arc_newton_begin(wear_stage *stage);
void arc_newton_end(wear_stage *stage, double cycles, wear_depths *depth);
/* Computes the wear per cycle at z = 0 into `rate`. */
arc_status arc_newton_start(wear_stage *stage, double *rate);
/* Solves z = known + h rate(z). The present z and its `rate` are the initial guess and are replaced
 * by the solution, for which z = known + h rate to the bit. Errors: ARC_ZONE if the run has
 * outgrown its mesh; ARC_NOT_CONVERGED if a shorter step is necessary. */
arc_status arc_newton_solve(wear_stage *stage, double h, double *rate);
/* Filters stiff ripples out of a defect. Returns the largest share of the load that the defect
 * shifts along the surface, or a negative number if it is not available. */
double arc_newton_error(wear_stage *stage, double h, double *defect);

/* --- for rest_stage.c ------------------------------------------------------------------------- */
/* Returns the wear coefficient of node i at the present z, over the largest coefficient. */
double arc_newton_share(const newton *s, int i);
/* Computes k times the wear of a cycle at the present z, with or without the Jacobian. */
arc_status arc_newton_evaluate(newton *s, double *rate, int with_jacobian);
/* The first function computes residual = z - known - h rate and returns its largest entry; the
 * second returns the tolerance of the residual [mm]. */
double arc_newton_residual(newton *s, double h, const double *rate);
double arc_newton_allowed(const newton *s);
/* Returns true if a shorter step would not help. */
int arc_newton_is_hopeless(const newton *s, arc_status status);

/* --- rest_stage.c ----------------------------------------------------------------------------- */
/* Returns true if all points of the window have the same contact under the same load, without
 * friction and elastic slip. */
int arc_stage_rests(const wear_stage *stage);
arc_status arc_stage_solve_rest(newton *s, double h, double *rate);
/* Converts changes of the gaps [active] of a solved problem to changes of its forces. Returns the
 * largest share of the load that is shifted along the surface. */
double arc_stage_forces(contact_problem *p, double *gap);
/* arc_newton_error for a stage at rest (see arc_stage_solve_rest). */
double arc_stage_rest_error(newton *s, double *defect);

#endif

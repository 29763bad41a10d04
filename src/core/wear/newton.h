/* The equation of an implicit stage, z = known + h k rate(z), and what solves it. */
#ifndef WEAR_NEWTON_H
#define WEAR_NEWTON_H

#include "core/wear/step.h"

typedef struct newton {
  arc_wear *w;
  wear_window window; /* with `trial`, and `jacobian` where it is wanted */
  wear_trial trial;
  wear_watch *watch;
  wear_dose dose;
  arc_error error;
  int n;             /* nodes of both surfaces */
  double even, peak; /* rate of the last evaluation; its largest pressure [MPa] */
  double pressed;    /* its normal force over the sliding [N] */
  double energy;     /* what a cycle of the rate at hand dissipates [N] */
  double area;       /* what one of the last evaluation wears [mm2] */
  double *z, *known; /* [n] depths gained [mm] at the largest coefficient of each body's layers; the
                        fixed part of a stage */
  double *worn;      /* [n] what z comes to at their own */
  double *residual, *step, *down;
  double *rate[3]; /* [n] k times the wear of a cycle [mm] at the start and both stages */
  wear_jacobian jacobian;
  double coarse;                 /* jacobian.width of a kept one */
  double *matrix;                /* [live x live] factors of I + h k J */
  double *packed;                /* [n] */
  double *start;                 /* [n] z of a stage at first */
  double *defect, *last, *taken; /* [n] steps: the plain one, the one before, and as accelerated */
  int nearer;                    /* the last iteration came nearer to the solution */
  int live, *node, *pivots;
  double h; /* cycles [-] the factors belong to; 0: none */
} newton;

/* Room; ARC_MEMORY leaves what newton_free takes. s->w, window, watch and dose are set before. */
arc_status arc_newton_create(newton *s);
void arc_newton_free(newton *s);
/* Wear per cycle at z into `rate`; the Jacobian with it if asked for. */
arc_status arc_newton_evaluate(newton *s, double *rate, int with_jacobian);
/* Share of the largest coefficient by which node i wears now. */
double arc_newton_share(const newton *s, int i);
/* x := (I + h k J)^-1 x. */
arc_status arc_newton_direction(newton *s, double h, double *x);
/* Solves z = known + h rate(z) from the present z, whose rate is `rate`, and with the Jacobian of
 * the last evaluation that had one; rate becomes that of the solution, and z = known + h rate to
 * the bit. ARC_NOT_CONVERGED: try a shorter step. */
arc_status arc_newton_solve(newton *s, double h, double *rate);

#endif

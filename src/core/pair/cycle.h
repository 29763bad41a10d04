/* What a run and the kind of its pair of bodies hand to each other: the cycle's points, the wear of
 * a cycle at given depths, what an update takes off. Vectors over sites [n] hold the upper body's
 * first, then the lower one's; by body they are parts of one block. */
#ifndef PAIR_CYCLE_H
#define PAIR_CYCLE_H

#include "archard/wear.h"

/* What a definition comes to on a pair of bodies. */
typedef struct wear_manner {
  arc_procedure procedure; /* SP or NSP */
  double strokes;          /* r of Eq. (21): 2, or 1 where a cycle is a single pass */
  double stroke;           /* [mm] */
  double modulus;          /* [MPa] a tangential force per thickness, over it, counts as sliding */
  double radius;           /* [mm] at which a rotation slides */
  double thickness;        /* [mm] loads of a block are per thickness */
  int rests;               /* the contact stays at one position */
  int even; /* the lower body wears evenly, or along a track: its sites stay, see wear_rate.even */
  int counts_forces;       /* the load alone does not tell the work: rates count the forces */
  int layered[ARC_BODIES]; /* a body has layers, which may wear by coefficients of their own */
  int closed;              /* the contact never changes: no solution is needed */
} wear_manner;

/* A block of loading: points, which of them share a contact problem, how often. */
typedef struct wear_block {
  int count;          /* points; increments between them */
  double *x;          /* [count] position of the lower body [mm] */
  double *line;       /* [count] load per thickness [N/mm], 0: lifted off */
  double *pose_x;     /* [count] position of the contact [mm]: x, or 0 where it rests */
  double *angle;      /* [count] of the load [rad]; 0 but in holes */
  double *tangential; /* [count] force per thickness that drives the plate [N/mm]; NULL: x does */
  int press;          /* with friction: the point at which surfaces are pressed together */
  int *place;         /* [count] which contact problem a point belongs to */
  int poses;
  int periodic;
  double load, travel; /* largest [N]; from one end of the motion to the other [mm] */
  double repeat;  /* 2 where a half cycle stands for a whole one, 1/2 where both strokes stand for
                     one, else 1 */
  double sliding; /* travelled distance of a cycle [mm] */
  double cycles;  /* how often, may be INFINITY for the last */
  double start_distance, start_cycle; /* of the run, where this block begins */
} wear_block;

/* Wear of one cycle per unit of wear coefficient: sum of p ds over the strokes [MPa mm]. */
typedef struct wear_rate {
  double *node[ARC_BODIES]; /* [sites of the body]; one block */
  double even;         /* the lower body's, where it wears evenly (Eq. 27): a track 1 mm wide */
  double peak;         /* largest pressure at a site on the way [MPa] */
  double energy;       /* dissipated per thickness [N] */
  double shear, stick; /* largest tangential force [N/mm], width that never slips [mm] */
  double gross;        /* 1: all of the contact slips at some time */
  double pressed;      /* normal force over the sliding of a cycle [N] */
} wear_rate;

/* What an update takes off. */
typedef struct wear_depths {
  double *node[ARC_BODIES]; /* [sites of the body] [mm]; one block */
  double even;              /* off the whole lower body, or a track 1 mm wide [mm] */
  double error;             /* estimated by an implicit update, over the tolerance; else 0 */
  double peak;              /* largest pressure of the cycle they come from [MPa] */
  double energy;            /* dissipated meanwhile, per thickness [N] */
  double pressed;           /* normal force over the sliding of the update [N] */
} wear_depths;

/* -d rate / d depth of a window, as a kind has it. */
typedef struct wear_tangent wear_tangent;

/* A part of a block: increments first .. last. */
typedef struct wear_window {
  const wear_block *block;
  const arc_shape *shape; /* on which the contact is solved */
  int first, last;
  int chained; /* the solved point `first`, of an earlier shape, is at hand (Eq. 4) */
  const arc_wear_record *state; /* for local factors; NULL: they are not evaluated */
  double mu;                    /* coefficient of friction, where the run has one */
  const double *depth;          /* [n] by which the shape is worn deeper; NULL: it is as it is */
  wear_tangent *tangent;        /* if not NULL, written */
} wear_window;

/* Callbacks of a computation, and how many contact solutions it took so far. */
typedef struct wear_watch {
  const arc_callbacks *callbacks;
  int solutions;
} wear_watch;

/* The equation of a stage of an implicit step, z = known + h k rate(z). Arrays [n]. */
typedef struct wear_stage {
  arc_wear *run;
  wear_window window; /* without `depth` */
  wear_watch *watch;
  double k[ARC_BODIES]; /* wear coefficients [mm2/N] of sites that move */
  double *z;            /* depths gained [mm] at the largest coefficient of each body's layers */
  double *known;        /* the fixed part */
  double *worn;         /* what z comes to at the layers' own coefficients */
  wear_rate last;       /* of the last solution, without the sites' part */
  void *own;            /* the kind's */
  arc_error error;      /* of the last failure */
} wear_stage;

/* One body's surface; arrays owned by the shape. */
typedef struct wear_sites {
  int count;
  const double *x; /* [count] unworn position [mm] */
  const double *h; /* [count] wear depth [mm] */
  const double *z; /* [count] unworn position across the motion [mm]; NULL in the plane */
} wear_sites;

#endif

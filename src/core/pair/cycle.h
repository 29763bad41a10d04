/* Data exchanged between a run and the kind of its pair of bodies: points of the cycle, wear of a
 * cycle at given depths, depths of an update. Vectors over sites [n] hold the upper body's first,
 * then the lower one's; by body they are parts of one block. */
#ifndef PAIR_CYCLE_H
#define PAIR_CYCLE_H

#include "archard/wear.h"

/* Values derived from a definition for a pair of bodies. */
typedef struct wear_manner {
  arc_procedure procedure; /* SP or NSP */
  double strokes;          /* r of Eq. (21): 2, or 1 if a cycle is a single pass */
  double stroke;           /* [mm] */
  double modulus; /* [MPa] a tangential force per thickness / modulus counts as sliding distance */
  double radius;  /* [mm] radius at which a rotation slides */
  double thickness;  /* [mm] loads of a block are per thickness */
  int rests;         /* 1: the contact stays at one position */
  int even;          /* 1: the lower body wears evenly, or along a track: its sites do not move, see
                        wear_rate.even */
  int counts_forces; /* 1: the work depends on forces, which rates sum up, not on the load only */
  int layered[ARC_BODIES]; /* 1: a body has layers, possibly with other coefficients */
  int closed;              /* 1: the contact never changes, no solution is needed */
} wear_manner;

/* A block of loading: points, contact problems shared by points, number of cycles. */
typedef struct wear_block {
  int count;          /* points; increments between them */
  double *x;          /* [count] position of the lower body [mm] */
  double *line;       /* [count] load per thickness [N/mm], 0: lifted off */
  double *problem_x;  /* [count] position of the contact [mm]: x, or 0 for a contact at rest */
  double *angle;      /* [count] angle of the load [rad]; 0 except in holes */
  double *tangential; /* [count] tangential force per thickness [N/mm]; NULL: x is given */
  int press;          /* with friction: the point at which surfaces are pressed together */
  int *problem_of;    /* [count] index of the contact problem of a point */
  int problems;
  int periodic;
  double load, travel; /* largest [N]; from one end of the motion to the other [mm] */
  double repeat;  /* 2 if a half cycle represents a whole one, 1/2 if both strokes represent one,
                     else 1 */
  double sliding; /* travelled distance of a cycle [mm] */
  double cycles;  /* number of cycles, may be INFINITY in the last block */
  double start_distance, start_cycle; /* of the run at the start of this block */
} wear_block;

/* Wear of one cycle per unit of wear coefficient: sum of p ds over the strokes [MPa mm]. */
typedef struct wear_rate {
  double *node[ARC_BODIES]; /* [sites of the body]; one block */
  double even;              /* of an evenly worn lower body (Eq. 27), or a track 1 mm wide */
  double peak;              /* largest pressure at a site in the window [MPa] */
  double energy;            /* dissipated per thickness [N] */
  double shear, stick;      /* largest tangential force [N/mm]; width that never slips [mm] */
  double gross;             /* 1: all of the contact slips at some time */
  double pressed;           /* normal force over the sliding of a cycle [N] */
} wear_rate;

/* Depths of an update. */
typedef struct wear_depths {
  double *node[ARC_BODIES]; /* [sites of the body] [mm]; one block */
  double even;              /* even wear of the lower body, or of a track 1 mm wide [mm] */
  double error;             /* estimated error / tolerance of an implicit update; else 0 */
  double peak;              /* largest pressure of the cycle they come from [MPa] */
  double energy;            /* dissipated meanwhile, per thickness [N] */
  double pressed;           /* normal force over the sliding of the update [N] */
} wear_depths;

/* -d rate / d depth of a window, as a kind has it. */
typedef struct wear_tangent wear_tangent;

/* A part of a block: increments first .. last. */
typedef struct wear_window {
  const wear_block *block;
  const arc_shape *shape; /* shape on which the contact is solved */
  int first, last;
  int chained; /* 1: the solution of point `first` on an earlier shape is available (Eq. 4) */
  const arc_wear_record *state; /* state for local factors; NULL: they are not evaluated */
  double mu;                    /* coefficient of friction, where the run has one */
  const double *depth;          /* [n] additional depths of the shape; NULL: none */
  wear_tangent *tangent;        /* if not NULL, written */
} wear_window;

/* Callbacks of a computation, and its number of contact solutions. */
typedef struct wear_progress {
  const arc_callbacks *callbacks;
  int solutions;
} wear_progress;

/* The equation of a stage of an implicit step, z = known + h k rate(z). Arrays [n]. */
typedef struct wear_stage {
  arc_wear *run;
  wear_window window; /* without `depth` */
  wear_progress *progress;
  double k[ARC_BODIES]; /* wear coefficients [mm2/N] of sites that move */
  double *z;            /* depths gained [mm] at the largest coefficient of each body's layers */
  double *known;        /* the fixed part */
  double *worn;         /* z at the coefficients of the layers */
  wear_rate last;       /* of the last solution, without the wear of sites */
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

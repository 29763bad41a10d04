/* Declares the data that a run and its kind of pair exchange: the points of a cycle, the wear of a
 * cycle, and the depths of an update. Sites are the surface points (nodes or cells) of the bodies.
 * Vectors [n] contain first the values at the sites of the upper body, then the values at the sites
 * of the lower body. The vectors of both bodies are adjacent in one block of memory. */
#ifndef PAIR_CYCLE_H
#define PAIR_CYCLE_H

#include "archard/wear.h"

/* Properties of a run that the kind of pair derives from its definition. */
typedef struct wear_manner {
  arc_procedure procedure; /* SP: sliding plate; NSP: one contact per update */
  double strokes;   /* number of strokes in a cycle (r in the reference paper): 2, or 1 for a single
                       pass */
  double stroke;    /* [mm] stroke */
  double modulus;   /* [MPa] contact modulus; in cycles driven by a force, the nominal sliding
                       distance is the force per thickness divided by this modulus */
  double radius;    /* [mm] radius at which a rotation is converted to sliding distance */
  double thickness; /* [mm] thickness that converts loads [N] to loads per thickness [N/mm] */
  int rests;        /* true if the contact is solved at one position only */
  int even; /* true if the lower body wears uniformly or along a track, so that its sites have no
               depths of their own; see wear_rate.even */
  int counts_forces;       /* true if the normal force differs from the load and must be integrated
                              (wear_rate.pressed) */
  int layered[ARC_BODIES]; /* true if the body has layers, which may have different wear
                              coefficients */
  int closed; /* true if wear does not change the contact, so that no solution is needed */
} wear_manner;

/* A block of loading: its points, its contact problems, and its number of cycles. Several points
 * may share one contact problem. */
typedef struct wear_block {
  int count;          /* number of points; the block has count - 1 increments */
  double *x;          /* [count] position of the lower body [mm] */
  double *line;       /* [count] normal load per thickness [N/mm]; 0: the bodies are apart */
  double *problem_x;  /* [count] position of the contact [mm]: x, or 0 for a contact at rest */
  double *angle;      /* [count] angle of the load [rad]; 0 except in holes */
  double *tangential; /* [count] tangential force per thickness [N/mm]; NULL: the position x is
                         prescribed */
  int press;          /* with friction: index of the point where the bodies are pressed together */
  int *problem_of;    /* [count] index of the contact problem of each point */
  int problems;
  int periodic;
  double load, travel; /* largest load [N]; distance between the ends of the motion [mm] */
  double repeat;  /* factor on the wear of the points: 2 if they cover half a cycle, 1/2 if they
                     cover two strokes and a cycle is one stroke, else 1 */
  double sliding; /* sliding distance of a cycle [mm] */
  double cycles;  /* number of cycles, which may be INFINITY in the last block */
  double start_distance, start_cycle; /* distance [mm] and cycle number at the block's start */
} wear_block;

/* Wear rate: the wear depth of one cycle divided by the wear coefficient. It is the integral of
 * pressure over sliding distance in the cycle [MPa mm]. */
typedef struct wear_rate {
  double *node[ARC_BODIES]; /* [sites of the body] rate at each site, in one block of memory for
                               both bodies */
  double even; /* rate of a uniformly worn lower body (Eq. 27 of the reference paper), or of a track
                  1 mm wide */
  double peak; /* largest pressure at a site in the window [MPa] */
  double energy;       /* energy dissipated in the cycle, per thickness [N] */
  double shear, stick; /* largest tangential force per thickness [N/mm]; width that sticks
                          throughout the cycle [mm] */
  double gross;        /* 1 if the whole contact slips at some time, otherwise 0 */
  double pressed;      /* integral of the normal force over the sliding distance of a cycle [N] */
} wear_rate;

/* Wear depths of an update of the geometry. */
typedef struct wear_depths {
  double *node[ARC_BODIES]; /* [sites of the body] depth at each site [mm], in one block of memory
                               for both bodies */
  double even;    /* depth of uniform wear of the lower body, or of a track 1 mm wide [mm] */
  double error;   /* estimated error divided by the tolerance; 0 in updates without an estimate */
  double peak;    /* largest pressure [MPa] of the cycle that caused the depths */
  double energy;  /* energy dissipated in the update, per thickness [N] */
  double pressed; /* integral of the normal force over the sliding distance of the update [N] */
} wear_depths;

/* Derivative of the wear rate of a window with respect to the depths, with a negative sign. Its
 * format depends on the kind of pair. */
typedef struct wear_tangent wear_tangent;

/* A part of a block of loading, from point `first` to point `last`. */
typedef struct wear_window {
  const wear_block *block;
  const arc_shape *shape; /* shape on which the contact is solved */
  int first, last;
  int chained; /* true if point `first` may use the solution on an earlier shape (simple rule) */
  const arc_wear_record
      *state;            /* state for which local factors are computed; NULL: no local factors */
  double mu;             /* coefficient of friction, for runs with friction */
  const double *depth;   /* [n] depths in addition to those of the shape; NULL: none */
  wear_tangent *tangent; /* output: the tangent; NULL: it is not computed */
} wear_window;

/* Callbacks of a computation, and the number of contact problems solved so far. */
typedef struct wear_progress {
  const arc_callbacks *callbacks;
  int solutions;
} wear_progress;

/* The equation of a stage of an implicit step, z = known + h k rate(z), where z are the depths
 * after h cycles. All arrays are [n]. */
typedef struct wear_stage {
  arc_wear *run;
  wear_window window; /* window that is solved; the kind sets its member `depth` */
  wear_progress *progress;
  double
      k[ARC_BODIES]; /* [mm2/N] wear coefficients of the sites; 0 for a body that wears uniformly */
  double *z;         /* [mm] depths computed with the largest wear coefficient of each body */
  double *known;     /* constant part of z [mm] */
  double *worn;      /* [mm] the same depths, converted with the wear coefficients of the layers */
  wear_rate
      last;  /* wear rate of the last solution, without the rates of sites (`node` is not set) */
  void *own; /* data of the kind */
  arc_error error; /* error of the last failure */
} wear_stage;

/* The surface points (sites) of one body. The shape owns the arrays. */
typedef struct wear_sites {
  int count;
  const double *x; /* [count] unworn position [mm] */
  const double *h; /* [count] wear depth [mm] */
  const double *z; /* [count] unworn position across the motion [mm]; NULL in the plane */
} wear_sites;

/* Allocates a fretting loop with arrays for `count` points as one block, which the caller frees
 * with free(). The arrays are not initialised, and all other members are zero. Error: ARC_MEMORY;
 * *loop is then unchanged. */
arc_status arc_loop_create(size_t count, arc_loop **loop, arc_error *error);

#endif

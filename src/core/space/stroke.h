/* The contact problem of all positions of a stroke at once, with the wear of a step in their gaps.
 */
#ifndef SPACE_STROKE_H
#define SPACE_STROKE_H

#include "core/numeric/active_set.h"
#include "core/space/halfspace.h"

/* Position on the lower body: window row i interpolates row + i with weight 1 - share and the next
 * one with weight share. */
typedef struct stroke_place {
  int row;
  double share;
} stroke_place;

typedef struct stroke {
  arc_halfspace *h;
  const arc_callbacks *callbacks;
  int count;    /* of positions that are solved for */
  int mirrored; /* in x: the others are mirror images of these */
  int even;     /* in z: so are the halves of each */
  int worker;   /* whose workspace a single position uses */
  stroke_place *place;
  const double *extra;              /* [count][window] added to the gaps; NULL */
  double *weight;                   /* of the inner product [count]; half at a mirror's middle */
  double c[ARC_BODIES];             /* of the wear; 0: none */
  const double *factor[ARC_BODIES]; /* by site; NULL: 1 */
  space_box box;
  const convolution *kernel, *inverse;
  double *upper;      /* [box] wear of the upper body */
  double *lower;      /* [rows][box.nz] wear of the lower body */
  const double *from; /* pressures [count][box] the sums are of */
  double *to;
  int both; /* bodies are summed, also one that does not wear */
} stroke;

/* Finds a position on the track. ARC_ZONE: it needs a longer one. */
arc_status arc_stroke_place(const arc_halfspace *h, double x, stroke_place *place,
                            arc_error *error);

/* An operator_fn: K p + wear. */
arc_status arc_stroke_apply(void *context, const double *p, double *u);
/* A preconditioner without wear. */
arc_status arc_stroke_precondition(void *context, const double *r, double *z);

/* Sums weight times pressure by site on the box into upper and lower, for the bodies that wear or
 * for both. */
void arc_stroke_gather(stroke *s, const double *p, int both);

/* Sum of both bodies' values on the box at a position. */
void arc_stroke_read(const stroke *s, const double *const value[ARC_BODIES], int position,
                     double *sum);
/* Gap of a position without pressure, of the box: unworn shapes and depths (NULL: unworn). */
void arc_stroke_gap(const stroke *s, const double *const depth[ARC_BODIES], int position,
                    double *gap);

#endif

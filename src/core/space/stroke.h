/* The contact problem of all positions of a stroke at once, with the wear of a step in their gaps.
 */
#ifndef SPACE_STROKE_H
#define SPACE_STROKE_H

#include "core/numeric/active_set.h"
#include "core/space/halfspace.h"

/* Where a position reads and wears the lower body: window row i has 1 - share of row + i, and share
 * of the next one. */
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
  const double *extra;              /* [window] added to the gap of a single position; NULL */
  double *weight;                   /* of the inner product [count]; half at a mirror's middle */
  double c[ARC_BODIES];             /* of the wear; 0: none */
  const double *factor[ARC_BODIES]; /* by site; NULL: 1 */
  space_box box;
  const convolution *kernel, *inverse;
  double *upper;      /* [box] what the upper body has worn */
  double *lower;      /* [rows][box.nz] what the lower one has */
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

/* weight times pressure, summed by site of a body on the box, into upper and lower; of bodies that
 * wear alone, or of both. */
void arc_stroke_gather(stroke *s, const double *p, int both);

/* What a position reads of both bodies on the box, summed. */
void arc_stroke_read(const stroke *s, const double *const value[ARC_BODIES], int position,
                     double *sum);
/* Gap of a position without pressure, of the box: unworn shapes and depths (NULL: unworn). */
void arc_stroke_gap(const stroke *s, const double *const depth[ARC_BODIES], int position,
                    double *gap);

#endif

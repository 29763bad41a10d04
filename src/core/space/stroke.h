/* The contact problem of all positions of a stroke, solved at once. Its gaps include the wear of a
 * step. */
#ifndef SPACE_STROKE_H
#define SPACE_STROKE_H

#include "core/numeric/active_set.h"
#include "core/space/halfspace.h"

/* Position of the window on the lower body. Values at row i of the window are interpolated between
 * row `row` + i of the lower body (weight 1 - share) and the next row (weight share). */
typedef struct stroke_place {
  int row;
  double share;
} stroke_place;

typedef struct stroke {
  arc_halfspace *h;
  const arc_callbacks *callbacks;
  int count;    /* number of positions that are solved */
  int mirrored; /* 1 if the positions that are not solved are mirror images in x */
  int even;     /* 1 if each position is symmetric in z */
  int worker;   /* index of the workspace for a single position */
  stroke_place *place;
  const double *extra; /* [count][window] values added to the gaps [mm], or NULL */
  double *weight; /* [count] weights of the positions, which are sliding distances [mm]; halved in
                     the middle of a mirrored stroke */
  double c[ARC_BODIES]; /* wear depth divided by the sum of weight times pressure [mm2/N]; 0 for a
                           body without wear */
  const double *factor[ARC_BODIES]; /* factor of c at each site; NULL: all are 1 */
  space_box box;
  const convolution *kernel, *inverse;
  double *upper;      /* [box] wear of the upper body */
  double *lower;      /* [rows][box.nz] wear of the lower body */
  const double *from; /* [count][box] pressures to which the operator is applied */
  double *to;
  int both; /* 1 to sum for both bodies, including a body without wear */
} stroke;

/* Converts x [mm] to a position on the track. Error: ARC_ZONE if the track is too short. */
arc_status arc_stroke_place(const arc_halfspace *h, double x, stroke_place *place,
                            arc_error *error);

/* Computes u = K p plus the wear due to the pressures p (an operator_fn). The context is a
 * stroke. */
arc_status arc_stroke_apply(void *context, const double *p, double *u);
/* Applies a preconditioner that neglects the wear. */
arc_status arc_stroke_precondition(void *context, const double *r, double *z);

/* Sums weight times pressure by site of the box into upper and lower, for the bodies that wear,
 * or for both bodies if `both` is 1. */
void arc_stroke_gather(stroke *s, const double *p, int both);

/* Computes sum [box]: in one position of the window, the values [sites] of both bodies that face
 * each other at a cell are added. */
void arc_stroke_read(const stroke *s, const double *const value[ARC_BODIES], int position,
                     double *sum);
/* Computes the gaps of a position without pressure, on the box: the unworn shapes plus the depths
 * (depth = NULL: unworn bodies). */
void arc_stroke_gap(const stroke *s, const double *const depth[ARC_BODIES], int position,
                    double *gap);

#endif

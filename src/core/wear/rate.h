/* The wear of a cycle on a given shape, and how it answers to depth. */
#ifndef WEAR_RATE_H
#define WEAR_RATE_H

#include "core/wear/run.h"

/* Depths beyond those of a shape, at which contact is to be solved. */
typedef struct wear_trial {
  const double *depth[ARC_BODIES]; /* [surface] along the normals [mm] */
  const double *down[ARC_BODIES];  /* [surface] vertical share of the inward normals */
} wear_trial;

/* A part of the block at hand: increments first .. last. */
typedef struct wear_window {
  const arc_shape *shape; /* on which the contact is solved */
  int first, last;
  int chained;                  /* the path holds the solved point `first`, of an earlier shape
                                   (Eq. 4) */
  const arc_wear_record *state; /* for local factors */
  const wear_trial *trial;      /* NULL: the shape as it is */
  double *jacobian;             /* if not NULL, written: [n x n] with n = nc + np, column-major,
                                   -d rate / d depth at frozen compliance */
} wear_window;

/* Whom a computation asks, and how many contact solutions it took so far. */
typedef struct wear_watch {
  const arc_callbacks *callbacks;
  int solutions;
} wear_watch;

/* --- rate.c --- */
/* The wear of a window. */
arc_status arc_wear_evaluate(arc_wear *w, const wear_window *window, wear_watch *watch,
                             wear_rate *rate, arc_error *error);
/* Solves the point window->first only: can the contact be there? */
arc_status arc_wear_probe(arc_wear *w, const wear_window *window, arc_error *error);

/* --- jacobian.c --- */
/* Adds share * (-d q / d depth) of a solved pose to jacobian. down as in wear_trial. */
arc_status arc_wear_add_jacobian(const arc_wear *w, const pose *p, const wear_point *point,
                                 double share, const double *const down[ARC_BODIES],
                                 double *jacobian);

#endif

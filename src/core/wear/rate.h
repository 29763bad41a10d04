/* The wear of a cycle on a given shape, and how it answers to depth. */
#ifndef WEAR_RATE_H
#define WEAR_RATE_H

#include "core/wear/run.h"

/* Depths beyond those of a shape, at which contact is to be solved. */
typedef struct wear_trial {
  const double *depth[ARC_BODIES]; /* [surface] along the normals [mm] */
  const double *down[ARC_BODIES];  /* [surface] how much lower that makes the surface, see
                                      arc_shape_downward */
} wear_trial;

/* A trial on a shape by depths and room for `down`, [n] both, the cylinder's nodes first. */
wear_trial arc_wear_trial_on(const arc_shape *shape, const double *depth, double *down);

/* A part of the block at hand: increments first .. last. */
typedef struct wear_window {
  const arc_shape *shape; /* on which the contact is solved */
  int first, last;
  int chained;                    /* the path holds the solved point `first`, of an earlier shape
                                     (Eq. 4) */
  const arc_wear_record *state;   /* for local factors; NULL: they are not asked */
  double mu;                      /* coefficient of friction, where the run has one */
  const wear_trial *trial;        /* NULL: the shape as it is */
  struct wear_jacobian *jacobian; /* if not NULL, written */
} wear_window;

/* Whom a computation asks, and how many contact solutions it took so far. */
typedef struct wear_watch {
  const arc_callbacks *callbacks;
  int solutions;
} wear_watch;

/* --- rate.c --- */
/* Nothing wears: the nodes' [n] and all that is told beside them. */
void arc_wear_rate_clear(wear_rate *rate, int n);
void arc_wear_rate_copy(const wear_rate *from, wear_rate *to, int n);
/* The wear of a window. */
arc_status arc_wear_evaluate(arc_wear *w, const wear_window *window, wear_watch *watch,
                             wear_rate *rate, arc_error *error);
/* Solves the point window->first only: can the contact be there? */
arc_status arc_wear_probe(arc_wear *w, const wear_window *window, arc_error *error);

/* Brings the pose of point `at` of the block at hand up to date with a window. */
arc_status arc_wear_prepare(arc_wear *w, const wear_window *window, int at, arc_error *error);
/* What the solution on a pose presses and wears. */
arc_status arc_wear_take(arc_wear *w, const wear_window *window, const pose *p, wear_point *point,
                         arc_error *error);

/* Adds work at the cylinder's nodes [MPa mm], as a density along x, to the wear of both bodies, by
 * the factors of their places: the plate gets the same through the coupling (Eq. 15). on [np] is
 * room. */
void arc_wear_share(const arc_wear *w, const pose *p, const wear_point *point, const double *work,
                    double *on, wear_rate *rate);

/* --- mirror.c --- */
/* Whether the contact in the second half of a window is the mirror image of that in its first. */
int arc_wear_is_mirrored(const arc_wear *w, const wear_window *window);
/* Whether the wear is not, for factors of places. */
int arc_wear_has_places(const arc_wear *w, const wear_window *window);
/* The image of point `at`, just solved; `law` has what wears there without factors of places. */
arc_status arc_wear_reflect(arc_wear *w, const wear_window *window, int at, const wear_point *law,
                            arc_error *error);
/* The wear of a first half, and its Jacobian, become those of the whole window; `images`: the wear
 * of the other half, NULL where it is the mirror image. */
void arc_wear_add_mirror(const arc_wear *w, const wear_window *window, const wear_rate *images,
                         wear_rate *rate);

/* --- rubbing.c --- */
/* Whether the coefficient of friction is a table or a function. */
int arc_wear_friction_changes(const arc_wear *w);
/* The coefficient of friction of a state; what a function fails of. */
arc_status arc_wear_friction_of(const arc_wear *w, const arc_wear_record *state, double *mu,
                                arc_error *error);
/* ARC_ARGUMENT where it does not carry the force that drives the plate at a state. */
arc_status arc_wear_friction_carries(const arc_wear *w, const arc_wear_record *state, double mu,
                                     arc_error *error);
/* Both. */
arc_status arc_wear_friction(const arc_wear *w, const arc_wear_record *state, double *mu,
                             arc_error *error);

/* --- fretting.c --- */
/* The wear of a steady cycle with friction. */
arc_status arc_wear_fret(arc_wear *w, const wear_window *window, wear_watch *watch, wear_rate *rate,
                         arc_error *error);

/* --- slip.c --- */
/* Adds the work of the increment that ends at `at`, with the elastic part of the slip. */
void arc_wear_add_work(const arc_wear *w, int at, wear_rate *rate);

/* --- jacobian.c --- */
/* -d rate / d depth, at frozen compliance and along y. Neighbouring points whose contact hardly
 * differs are taken together: a Newton iteration does not mind. */
typedef struct wear_jacobian {
  int nc, np;
  double width;  /* [mm] of plate positions in a group; 0: every point is its own */
  double *value; /* [n x n], n = nc + np, column-major; cylinder first */
  struct jacobian_group *group;
} wear_jacobian;

arc_status arc_wear_jacobian_create(wear_jacobian *j, int nc, int np);
void arc_wear_jacobian_free(wear_jacobian *j);
void arc_wear_jacobian_clear(wear_jacobian *j);
/* Adds share * (-d q / d depth) of point `at` of the window, just solved, to the window's; points
 * come in order. way [surface] of both bodies: what each node slides, where that is not share; its
 * largest is. */
void arc_wear_jacobian_add(const arc_wear *w, const wear_window *window, int at, double share,
                           double *const way[ARC_BODIES]);
/* After the last pose: value is complete. */
void arc_wear_jacobian_finish(wear_jacobian *j);

#endif

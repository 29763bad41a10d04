/* Inside of arc_wear: what one run holds, and who does what in this layer. */
#ifndef WEAR_RUN_H
#define WEAR_RUN_H

#include "archard/wear.h"
#include "core/contact/pose.h"

/* A block of loading as it is simulated: points, the distinct plate positions among them, how
 * often. */
typedef struct wear_block {
  int count;        /* points; increments between them */
  double *x;        /* [count] plate position [mm] */
  double *line;     /* [count] load per thickness [N/mm], 0: lifted off */
  int *place;       /* [count] which pose a point belongs to */
  int poses;        /* distinct positions */
  double *position; /* [poses] [mm] */
  int periodic;
  double repeat;                      /* 2 where a half cycle stands for a whole one, else 1 */
  double sliding;                     /* travelled distance of a cycle [mm] */
  double cycles;                      /* how often, may be INFINITY for the last */
  double start_distance, start_cycle; /* of the run, where this block begins */
} wear_block;

/* Wear of one cycle per unit of wear coefficient: sum of p ds over the strokes [MPa mm]. */
typedef struct wear_rate {
  double *node[ARC_BODIES]; /* [surface of the body]; one block, cylinder first */
  double even;              /* the plate's, where it wears evenly (Eq. 27) */
} wear_rate;

/* One point of the path, solved. Arrays by body; one block. */
typedef struct wear_point {
  double *p[ARC_BODIES]; /* pressure [MPa] */
  double *q[ARC_BODIES]; /* p times the local factor of the wear law [MPa] */
  double *u[ARC_BODIES]; /* elastic displacement along x, plate against cylinder [mm] */
} wear_point;

struct arc_wear {
  arc_model *model;
  arc_wear_def def;        /* series and loading are own copies */
  arc_procedure procedure; /* SP or NSP */
  int over_plate;          /* the stroke is the whole plate's width */
  int blocks, current;     /* `current`: the block that the poses belong to */
  wear_block *block;
  arc_shape *shape, *next; /* as it stands; as it will be, during a step */
  int poses;               /* of the current block */
  pose *pose;              /* [poses] */
  pose reference;          /* plate at x = 0, nominal load */
  int nc, np;              /* surface nodes */
  wear_point point[2];     /* the last two points of the path */
  wear_rate rate;
  double *delta[ARC_BODIES]; /* [surface] depths of the update at hand; one block, cylinder first */
  double *memory;            /* holds the arrays of points, rate and delta */
  size_t records, capacity;
  arc_wear_record *history;
};

/* --- definition.c, block.c --- */
arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model);
int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model);
/* Deep copy of series and loading into *copy; frees with arc_wear_def_free. ARC_MEMORY leaves
 * nothing to free. */
arc_status arc_wear_def_copy(const arc_wear_def *def, arc_wear_def *copy);
void arc_wear_def_free(arc_wear_def *def);
/* The blocks of a checked definition: block [count], freed by arc_wear_blocks_free. */
arc_status arc_wear_blocks_create(const arc_wear_def *def, const arc_model_def *model,
                                  wear_block **block, int *count);
void arc_wear_blocks_free(wear_block **block, int count);
/* The block that holds the state of a record. */
int arc_wear_block_at(const arc_wear *w, const arc_wear_record *at);
/* Where it ends [mm]. */
double arc_wear_block_end(const wear_block *block);

/* --- coefficient.c --- */
/* Wear coefficients of both bodies [mm2/N], averaged over distances [from, to]; functions are asked
 * with `state`. */
arc_status arc_wear_coefficients(const arc_wear *w, double from, double to,
                                 const arc_wear_record *state, double k[ARC_BODIES],
                                 arc_error *error);
/* Asks a function for a quantity, and refuses what is out of its range. */
arc_status arc_wear_ask(const arc_wear *w, const arc_setting *what, arc_state_fn function,
                        const arc_wear_record *state, double *value, arc_error *error);
int arc_wear_has_state_functions(const arc_wear *w);
/* k and alpha of a record from the bodies' coefficients. */
void arc_wear_note_coefficients(const double k[ARC_BODIES], arc_wear_record *record);
/* q from p at a point: law and local factor. */
arc_status arc_wear_local(const arc_wear *w, const arc_wear_record *state, wear_point *point,
                          arc_error *error);
/* dq/dp of the law at a node. */
double arc_wear_law_slope(const arc_wear *w, double p, double q);

/* --- rate.c --- */
/* Frees the poses of the current block. */
void arc_wear_leave_block(arc_wear *w);
/* Makes poses for a block. ARC_MEMORY. */
arc_status arc_wear_enter_block(arc_wear *w, int block, arc_error *error);
/* Depths beyond those of a shape, at which contact is to be solved. */
typedef struct wear_trial {
  const double *depth[ARC_BODIES]; /* [surface] along the normals [mm] */
  const double *down[ARC_BODIES];  /* [surface] vertical share of the inward normals */
} wear_trial;
/* The wear of increments first..last of the current block on `shape` (deepened by `trial`, if not
 * NULL) into w->rate. J (if not NULL), [n x n] with n = nc + np, column-major: -d rate / d depth at
 * frozen compliance. `chained`: w->point holds the solved point `first` (of an earlier shape, Eq.
 * 4) in point[first % 2]. */
typedef struct wear_window {
  int first, last;
  int chained;
  const wear_trial *trial;
  double *jacobian;
  const arc_wear_record *state; /* for local factors */
} wear_window;
arc_status arc_wear_evaluate(arc_wear *w, const arc_shape *shape, const wear_window *window,
                             arc_stop_fn stop, void *context, int *solutions, arc_error *error);

/* Solves the point window->first only, on the run's shape: can the contact be there? */
arc_status arc_wear_probe(arc_wear *w, const wear_window *window, int *solutions, arc_error *error);

/* --- jacobian.c --- */
/* Adds share * (-d q / d depth) of a solved pose to jacobian. down as in wear_trial. */
arc_status arc_wear_add_jacobian(const arc_wear *w, const pose *p, const wear_point *point,
                                 double share, const double *const down[ARC_BODIES],
                                 double *jacobian);
/* Largest eigenvalue of diag(k) J. work [2 n]. */
double arc_wear_largest_eigenvalue(int nc, int np, const double k[ARC_BODIES],
                                   const double *jacobian, double *work);

/* --- implicit.c --- */
/* Depths of an implicit update of `cycles` cycles over a window into w->delta (even wear into
 * w->rate.even, per cycle); error_share: estimated error over tolerance (0 without one).
 * ARC_NOT_CONVERGED: try fewer cycles. */
arc_status arc_wear_implicit(arc_wear *w, const arc_shape *shape, const wear_window *window,
                             double cycles, const double k[ARC_BODIES], arc_stop_fn stop,
                             void *context, int *solutions, double *error_share, arc_error *error);

/* --- reference.c --- */
/* alpha = 0 over the whole plate: the contact never changes and no solution is needed. */
int arc_wear_closed_form(const arc_wear *w);
/* Reads the reference configuration of a shape into the record (which holds the rest). */
arc_status arc_wear_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                            arc_error *error);

/* --- wear.c --- */
arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error);

/* --- step.c --- */
typedef struct wear_monitor {
  arc_stop_fn stop;
  void *context;
  const arc_wear_target *targets;
  size_t count;
  int reached;
} wear_monitor;
/* What a step is about to do. */
typedef struct wear_plan {
  const wear_block *block;
  double cycles; /* so many cycles go by; an implicit step may take fewer */
  double times;  /* what the wear of the window counts: cycles, or the share of an increment */
  double end;    /* distance at which the step ends [mm] */
  int first;     /* generic history: the increment */
  int explicit;  /* although the scheme is implicit */
  wear_monitor *monitor;
} wear_plan;

/* --- plan.c --- */
/* The next step towards `limit` [mm]; enters its block. *moved: whether there is anything left to
 * do. */
arc_status arc_wear_plan_step(arc_wear *w, double limit, wear_plan *plan, int *moved,
                              arc_error *error);

#endif

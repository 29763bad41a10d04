/* archard/wear.h - Archard wear with a partition factor, step by step.
 *
 * k_c = alpha k, k_p = (1 - alpha) k. One step is one geometry update: the contact is solved at
 * every increment of a cycle on the present shape (SP), or once where the plate stays flat (NSP),
 * and `jump` cycles of that wear are applied together. A step either completes or leaves everything
 * as it was.
 */
#ifndef ARCHARD_WEAR_H
#define ARCHARD_WEAR_H

#include "archard/contact.h"

/* Fig. 7: SP simulates the sliding plate; NSP does not (alpha = 1, or a stroke over the whole
 * plate). */
typedef enum arc_procedure { ARC_AUTO = 0, ARC_SP = 1, ARC_NSP = 2 } arc_procedure;
/* Sliding distance of an increment: rigid plate motion, or with the elastic part (Abaqus' CSLIP).
 */
typedef enum arc_slip { ARC_SLIP_RIGID = 0, ARC_SLIP_TOTAL = 1 } arc_slip;
/* Integration over increments: Eq. (4) or Eq. (5). */
typedef enum arc_rule { ARC_TRAPEZOID = 0, ARC_SIMPLE = 1 } arc_rule;
typedef enum arc_scheme { ARC_EXPLICIT = 0, ARC_IMPLICIT = 1 } arc_scheme;
/* When the geometry is updated: after `jump` cycles together, or at every increment
 * (quasi-continuous). */
typedef enum arc_update { ARC_UPDATE_CYCLE = 0, ARC_UPDATE_INCREMENT = 1 } arc_update;
/* Wear law, as a factor on k: Archard 1; power (p / p0)^m; threshold: 1 where p > p0, else 0. */
typedef enum arc_law { ARC_LAW_ARCHARD = 0, ARC_LAW_POWER = 1, ARC_LAW_THRESHOLD = 2 } arc_law;

typedef struct arc_wear_record arc_wear_record;

/* A quantity that depends on the state of the run (k, alpha, jump). Anything but ARC_OK refuses the
 * step. */
typedef arc_status (*arc_state_fn)(void *context, const arc_wear_record *state, double *value);

/* A factor on k at each of the n nodes of one body: x [mm] own (unworn) position, p [MPa] at one
 * increment, to factor [n]. Anything but ARC_OK refuses the step. */
typedef arc_status (*arc_local_fn)(void *context, arc_body body, int n, const double *x,
                                   const double *p, const arc_wear_record *state, double *factor);

/* A quantity by travelled distance: linear between points, constant outside; distance [mm]
 * increases. */
typedef struct arc_series {
  int count; /* 0: none */
  const double *distance, *value;
} arc_series;

/* One block of loading: plate position and load at count >= 2 points of a cycle; both strokes are
 * simulated as they are. A load of 0 is a lift-off: no contact and no wear there. */
typedef struct arc_loading {
  int count;
  const double *x;    /* [count] [mm] */
  const double *load; /* [count] [N], >= 0 */
  double cycles;      /* how often, > 0 (INFINITY: to the end of the distance, last block only) */
  int periodic; /* 0: a generic history (Eq. 4): run once, updated at every increment, one increment
                   a step */
} arc_loading;

typedef struct arc_wear_def {
  double k;      /* [mm2/N] wear coefficient of the couple, 1e-8, >= 0 */
  double alpha;  /* [-] wear partition factor, 0.5, in [0, 1] */
  double load;   /* [N] 100, > 0, whole thickness; with `loading`: of the reference configuration */
  double stroke; /* [mm] 0.11, > 0; 2 radius: half-reciprocating over the whole plate (r = 1) */
  double distance; /* [mm] travelled distance to simulate, 1320, > 0; with `loading`: 0 means all
                      its blocks */
  double jump;     /* [cycles] cycles per geometry update (N-bar), 100, > 0 */
  int increments;  /* increments of a full cycle (n_c), 100, even, >= 2; half of them are simulated
                    */
  arc_procedure procedure;
  arc_scheme scheme;
  arc_slip slip;
  arc_rule rule;
  arc_geometry geometry;
  double refresh; /* [-] see arc_shape_create */
  arc_update update;

  arc_state_fn k_function, alpha_function,
      jump_function;                 /* instead of the numbers, where not NULL */
  arc_series k_series, alpha_series; /* instead of the numbers, where count > 0 */
  int jump_auto; /* non-zero: the largest stable and accurate jump, found anew at every update */
  arc_law law;
  double law_pressure;       /* [MPa] p0, > 0 for a law that needs it */
  double law_exponent;       /* [-] m of the power law, > -1 */
  arc_local_fn local_factor; /* NULL: 1 */
  void *context;             /* handed to every function above */

  int order;        /* of the implicit scheme: 1 (backward Euler) or 2 (default) */
  double tolerance; /* [-] of the implicit scheme: error of depth per step, relative; 0: steps of
                       `jump` */

  int blocks;                         /* 0: reciprocating by `stroke` under `load` */
  const arc_loading *loading;         /* [blocks], in this order; copied by the run */
  double start_distance, start_cycle; /* where the loading begins; set by arc_wear_set */
} arc_wear_def;

arc_wear_def arc_wear_default(void);

/* Checks a definition against the model it is to run on: ranges, and what goes together.
 * ARC_ARGUMENT names field, expectation and value. */
arc_status arc_wear_check(const arc_wear_def *def, const arc_model_def *model, arc_error *error);

/* Strokes of a cycle, r of Eq. (21): 2, or 1 where the stroke is the whole plate's width. */
double arc_wear_def_strokes(const arc_wear_def *def, const arc_model_def *model);

/* One row of history: the state after an update (row 0: before the first), all in the reference
 * configuration (plate at x = 0, nominal load). X(name, unit, text). */
#define ARC_WEAR_COLUMNS(X)                                                                        \
  X(update, "", "geometry updates so far")                                                         \
  X(cycle, "", "loading cycles so far")                                                            \
  X(distance, "mm", "travelled distance d")                                                        \
  X(jump, "", "cycles of this update")                                                             \
  X(k, "mm2/N", "wear coefficient of this update")                                                 \
  X(alpha, "", "wear partition factor of this update")                                             \
  X(p_center, "MPa", "pressure at the centre")                                                     \
  X(p_max, "MPa", "largest nodal pressure")                                                        \
  X(half_width, "mm", "half the contact width")                                                    \
  X(depth_cylinder, "mm", "largest wear depth of the cylinder")                                    \
  X(depth_plate, "mm", "largest wear depth of the plate")                                          \
  X(volume_cylinder, "mm3", "wear volume of the cylinder")                                         \
  X(volume_plate, "mm3", "wear volume of the plate")                                               \
  X(depth_partition, "", "wear depth partition factor alpha-tilde; NaN before any wear")           \
  X(error, "", "estimated error of an adaptive step, as a share of the tolerance")                 \
  X(solutions, "", "contact solutions so far")

struct arc_wear_record {
#define ARC_WEAR_MEMBER(name, unit, text) double name;
  ARC_WEAR_COLUMNS(ARC_WEAR_MEMBER)
#undef ARC_WEAR_MEMBER
};

/* A running simulation. Opaque; keeps its model alive. */
typedef struct arc_wear arc_wear;

/* A new run from unworn surfaces, or from `start` (copied; same model) if not NULL. Errors:
 * ARC_ARGUMENT with field, expectation and value; ARC_ZONE (a zone of the model too narrow for the
 * stroke, names what it needs). */
arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **wear, arc_error *error);
arc_status arc_wear_clone(const arc_wear *wear, arc_wear **copy, arc_error *error);
void arc_wear_destroy(arc_wear **wear);

/* A run as it stood after the last of `count` >= 1 records on `shape` (copied): goes on to the same
 * bits as one that was never stored. Errors as in arc_wear_create. */
arc_status arc_wear_restore(arc_model *model, const arc_wear_def *def, const arc_shape *shape,
                            const arc_wear_record *history, size_t count, arc_wear **wear,
                            arc_error *error);

/* The zones a model needs for this run, to build one that suits (see arc_mesh_def.zone). */
void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]);

/* One geometry update: `jump` cycles, or fewer where the definition's distance ends before. `stop`
 * (may be NULL) is asked between contact solutions: ARC_STOPPED. At the end of the distance: ARC_OK
 * and nothing happens. Anything but ARC_OK leaves the run as it was. */
arc_status arc_wear_step(arc_wear *wear, arc_stop_fn stop, void *context, arc_error *error);

/* Called after each step; non-zero stops the run with ARC_STOPPED (the step stays). */
typedef int (*arc_wear_progress_fn)(void *context, const arc_wear *wear);

/* Steps until `distance` [mm] (in total, met exactly by a shorter last step; may exceed the
 * definition's, and then becomes it). */
arc_status arc_wear_run(arc_wear *wear, double distance, arc_stop_fn stop,
                        arc_wear_progress_fn progress, void *context, arc_error *error);

/* A quantity of the record that ends a run where it is reached, exactly, by a shorter last step. */
typedef struct arc_wear_target {
  size_t column; /* offsetof(arc_wear_record, ...), or ARC_WEAR_TOTAL_VOLUME */
  double value;
} arc_wear_target;

/* In place of a column: the sum of both volumes. */
#define ARC_WEAR_TOTAL_VOLUME sizeof(arc_wear_record)

/* As arc_wear_run, and ends earlier where one of `count` targets is reached (to 1e-9 relative);
 * *reached is its index, or -1. A target that cannot be met within a step is passed. */
arc_status arc_wear_run_until(arc_wear *wear, double distance, const arc_wear_target *targets,
                              size_t count, arc_stop_fn stop, arc_wear_progress_fn progress,
                              void *context, int *reached, arc_error *error);

/* Changes the definition between steps (load, k, alpha, stroke, jump, loading, ...); the worn shape
 * and the history stay. The loading begins here, unless it is arc_wear_definition's own array: then
 * it goes on. On failure everything stays. */
arc_status arc_wear_set(arc_wear *wear, const arc_wear_def *def, arc_error *error);

const arc_wear_def *arc_wear_definition(const arc_wear *wear);
arc_procedure arc_wear_procedure(const arc_wear *wear); /* never ARC_AUTO */
double arc_wear_strokes(const arc_wear *wear);          /* r of Eq. (21): 2 or 1 */
double arc_wear_cycles(const arc_wear *wear);           /* N of Eq. (21), for the whole distance */
const arc_shape *arc_wear_shape(const arc_wear *wear);
arc_model *arc_wear_model(const arc_wear *wear);
const arc_wear_record *arc_wear_history(const arc_wear *wear, size_t *count);
const arc_wear_record *arc_wear_last(const arc_wear *wear);
size_t arc_wear_bytes(const arc_wear *wear);

/* The contact in the reference configuration on the present shape; a new object each call. */
arc_status arc_wear_contact(const arc_wear *wear, arc_contact **contact, arc_error *error);

/* Growth rate of ripples: largest eigenvalue of the wear of one cycle per unit of depth, linearised
 * about the present state [1/cycle], by power iteration. Explicit updates are stable while jump *
 * eigenvalue < 2. */
arc_status arc_wear_stability(arc_wear *wear, double *eigenvalue, arc_error *error);

/* Roughness of a profile [-]: its sawtooth part (fourth differences over 16, which give 1 for a
 * sawtooth of amplitude 1), root mean square over the middle of the contact, as a share of the
 * largest depth; smooth profiles stay under 1e-4 at the default mesh. */
double arc_wear_roughness(const arc_wear *wear, arc_body body);

#endif

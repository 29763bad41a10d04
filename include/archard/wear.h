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

typedef struct arc_wear_def {
  double k;        /* [mm2/N] wear coefficient of the couple, 1e-8, >= 0 */
  double alpha;    /* [-] wear partition factor, 0.5, in [0, 1] */
  double load;     /* [N] 100, > 0, whole thickness */
  double stroke;   /* [mm] 0.11, > 0; 2 radius: half-reciprocating over the whole plate (r = 1) */
  double distance; /* [mm] travelled distance to simulate, 1320, > 0 */
  double jump;     /* [cycles] cycles per geometry update (N-bar), 100, > 0 */
  int increments;  /* increments of a full cycle (n_c), 100, even, >= 2; half of them are simulated
                    */
  arc_procedure procedure;
  arc_scheme scheme;
  arc_slip slip;
  arc_rule rule;
  arc_geometry geometry;
  double refresh; /* [-] see arc_shape_create */
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
  X(solutions, "", "contact solutions so far")

typedef struct arc_wear_record {
#define ARC_WEAR_MEMBER(name, unit, text) double name;
  ARC_WEAR_COLUMNS(ARC_WEAR_MEMBER)
#undef ARC_WEAR_MEMBER
} arc_wear_record;

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

/* Roughness of a profile [-]: the largest second difference that changes sign from node to node, as
 * a share of the largest depth; a smooth profile stays under a few per mille. */
double arc_wear_roughness(const arc_wear *wear, arc_body body);

#endif

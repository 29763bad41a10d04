/* archard/wear.h - wear runs: Archard wear of two bodies, computed in steps.
 *
 * The wear coefficients are k_c = alpha k for the cylinder and k_p = (1 - alpha) k for the plate,
 * with the partition factor alpha. One step is one update of the geometry. The contact is solved on
 * the present shape at every increment of a cycle (SP), or once if the plate stays flat (NSP). Then
 * the wear of `jump` cycles is applied at once. A step that fails does not change the run. */
#ifndef ARCHARD_WEAR_H
#define ARCHARD_WEAR_H

#include "archard/wear_settings.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* One row of the history: the state after an update (row 0: before the first update). Pressures
 * (except p_peak) and widths refer to the plate at x = 0 under the nominal load. load, load_low and
 * travel refer to the cycle whose wear the update applied or, in a block of loading that runs once,
 * to the increment of the update (row 0: to the first cycle or increment). p_peak is
 *   - the largest pressure in a cycle on the surfaces of this row, and at least p_max if there is
 *     no loading;
 *   - with updates at every increment: the largest pressure in the solved increments of the update;
 *     in row 0 p_max.
 * Columns that are absent in older files are NaN.
 *
 * Each column is X(name, unit, range, rule, text). The range contains its limits and is written as
 * in archard/setting.h, for example FROM(0) for values >= 0. A value outside the range makes the
 * step fail with ARC_NUMERIC; a file with such a value is reported as damaged. The rule is one of
 * these: */
typedef enum arc_column_rule {
  ARC_COLUMN_LATER,  /* the column may be absent in older files, or undefined in the first rows; its
                        values are NaN before the first number, but not after it */
  ARC_COLUMN_ALWAYS, /* the column is in all files */
  ARC_COLUMN_GROWS   /* the column is in all files, and its values never decrease */
} arc_column_rule;
#define ARC_WEAR_COLUMNS(X)                                                                        \
  X(update, "", FROM(0), GROWS, "number of geometry updates so far")                               \
  X(cycle, "", FROM(0), GROWS, "number of loading cycles so far")                                  \
  X(distance, "mm", FROM(0), GROWS, "sliding distance so far")                                     \
  X(jump, "", FROM(0), ALWAYS, "number of cycles in this update")                                  \
  X(load, "N", FROM(0), LATER, "largest normal load in the cycle of this update")                  \
  X(load_low, "N", FROM(0), LATER, "smallest normal load in the cycle of this update")             \
  X(load_reference, "N", FROM(0), LATER, "normal load at which pressures and width are reported")  \
  X(travel, "mm", FROM(0), LATER, "stroke in the cycle of this update")                            \
  X(k, "mm2/N", FROM(0), ALWAYS, "wear coefficient of this update")                                \
  X(alpha, "", FROM(0), ALWAYS, "wear partition factor of this update")                            \
  X(p_center, "MPa", FROM(0), ALWAYS, "pressure at the centre of the contact")                     \
  X(p_max, "MPa", FROM(0), ALWAYS, "largest nodal pressure; mesh-dependent at scar edges")         \
  X(p_peak, "MPa", FROM(0), LATER, "largest nodal pressure in the cycle of this update")           \
  X(half_width, "mm", FROM(0), ALWAYS, "half the contact width")                                   \
  X(half_width_z, "mm", FROM(0), LATER, "half the contact width across the motion, in 3-D")        \
  X(area, "mm2", FROM(0), LATER, "contact area, in 3-D")                                           \
  X(depth_cylinder, "mm", FROM(0), ALWAYS, "largest wear depth of the cylinder")                   \
  X(depth_plate, "mm", FROM(0), ALWAYS, "largest wear depth of the plate")                         \
  X(volume_cylinder, "mm3", FROM(0), ALWAYS, "wear volume of the cylinder")                        \
  X(volume_plate, "mm3", FROM(0), ALWAYS, "wear volume of the plate")                              \
  X(load_distance, "N mm", FROM(0), LATER, "load (holes: normal force) integrated over distance")  \
  X(depth_partition, "", FROM(0), LATER, "depth partition factor alpha-tilde; NaN if unworn")      \
  X(error, "", FROM(0), LATER, "estimated error of the step divided by the tolerance")             \
  X(solutions, "", FROM(0), ALWAYS, "number of contact solutions so far")                          \
  X(box_rows, "", FROM(0), LATER, "number of element rows in the wear box")                        \
  X(elements, "", FROM(0), LATER, "number of elements in both meshes")                             \
  X(energy, "N mm", FROM(0), LATER, "energy dissipated by friction so far")                        \
  X(cycle_energy, "N mm", FROM(0), LATER, "energy dissipated in the cycle of this update")         \
  X(largest_shear, "N", FROM(0), LATER, "largest tangential force in the cycle of this update")    \
  X(stick_width, "mm", FROM(0), LATER, "width that sticks throughout the cycle of this update")    \
  X(gross, "", FROM(0), LATER, "1 if the whole contact slips at some time, else 0")

struct arc_wear_record {
#define ARC_WEAR_MEMBER(name, unit, range, rule, text) double name;
  ARC_WEAR_COLUMNS(ARC_WEAR_MEMBER)
#undef ARC_WEAR_MEMBER
};

/* Indices of the columns in the order of the list, followed by the index of the total volume. */
enum {
#define ARC_WEAR_COLUMN(name, unit, range, rule, text) ARC_WEAR_COLUMN_##name,
  ARC_WEAR_COLUMNS(ARC_WEAR_COLUMN)
#undef ARC_WEAR_COLUMN
      ARC_WEAR_COLUMN_COUNT,
  ARC_WEAR_TOTAL_VOLUME = ARC_WEAR_COLUMN_COUNT
};

/* arc_wear_record_get returns the value of a column, or the total volume. arc_wear_column_name
 * returns the name of a column, such as "p_center". */
double arc_wear_record_get(const arc_wear_record *record, int column);
const char *arc_wear_column_name(int column);

/* A wear run. Opaque; retains its model. */
typedef struct arc_wear arc_wear;

/* Creates a run on a copy of the shape `start` of the same model, or on unworn surfaces if `start`
 * is NULL. Errors: ARC_ARGUMENT (the message has the field, the expected and the actual value);
 * ARC_ZONE (a zone of the model is too narrow for the stroke; the message has the width needed). */
arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **wear, arc_error *error);
arc_status arc_wear_clone(const arc_wear *wear, arc_wear **copy, arc_error *error);
void arc_wear_destroy(arc_wear **wear);

/* Checks rows of a history against the ranges and rules of the columns. ARC_ARGUMENT: the message
 * has the row and the column. */
arc_status arc_wear_check_history(const arc_wear_record *history, size_t count, arc_error *error);

/* Restores a run from its history of `count` >= 1 records and a copy of its shape. The restored run
 * continues with the same results as the original run, to the bit. Errors as for
 * arc_wear_create. */
arc_status arc_wear_restore(arc_model *model, const arc_wear_def *def, const arc_shape *shape,
                            const arc_wear_record *history, size_t count, arc_wear **wear,
                            arc_error *error);

/* Returns the state of a run as *count arrays. arc_wear_resume restores the run from these arrays
 * and its history. *state is one block, which the caller frees with free(). Errors: ARC_MEMORY. */
arc_status arc_wear_state(const arc_wear *wear, arc_array **state, size_t *count, arc_error *error);

/* Checks the arrays of arc_wear_state, and restores the run from them and its history, like
 * arc_wear_restore. Errors: also those of arc_shape_restore. */
arc_status arc_wear_resume(arc_model *model, const arc_wear_def *def, const arc_array *state,
                           size_t arrays, const arc_wear_record *history, size_t count,
                           arc_wear **wear, arc_error *error);

/* Computes the zones [mm] (arc_mesh_def.zone) that a model needs for this run. The zones are wide
 * enough for the whole run. If element sizes follow the contact (mesh.fineness), the zones are only
 * wide enough for a contact of six unworn half widths, because such meshes are rebuilt when the
 * contact reaches their edge. */
void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]);

/* Makes one update of the geometry over `jump` cycles, or over fewer cycles at the end of the
 * distance. If the run has reached its end, the function makes no update and returns ARC_OK.
 * Returns ARC_STOPPED if a callback requested a stop. On failure the run is unchanged. The progress
 * callback is not called. The function warns if the mesh is too coarse for the contact (before the
 * first step with a definition) and if an explicit jump exceeds the limit of arc_wear_stability
 * (once). */
arc_status arc_wear_step(arc_wear *wear, const arc_callbacks *callbacks, arc_error *error);

/* Makes steps until the total sliding distance of the run is `distance` [mm]. The last step is
 * shortened so that it ends there exactly. A `distance` that exceeds the distance of the definition
 * replaces it. */
arc_status arc_wear_run(arc_wear *wear, double distance, const arc_callbacks *callbacks,
                        arc_error *error);

/* Target of a run: the run ends when a column reaches this value. The last step is shortened so
 * that it ends there. */
typedef struct arc_wear_target {
  int column; /* an index ARC_WEAR_COLUMN_..., or ARC_WEAR_TOTAL_VOLUME */
  double value;
} arc_wear_target;

/* Makes steps like arc_wear_run, but ends when one of the `count` targets is reached (with a
 * relative tolerance of 1e-9). *reached is the index of this target, or -1. If a quantity changes
 * discontinuously across its target, the run ends at the discontinuity. */
arc_status arc_wear_run_until(arc_wear *wear, double distance, const arc_wear_target *targets,
                              size_t count, const arc_callbacks *callbacks, int *reached,
                              arc_error *error);

/* Changes the definition (load, k, alpha, stroke, jump, loading, ...) between steps; shape and
 * history are kept. A new loading starts with its first block; the array `loading` of
 * arc_wear_definition continues at the present cycle. The run gets new meshes if `mesh` is not
 * NULL, or if the motion does not fit on the present meshes. New meshes are reported to the
 * callbacks. In `mesh`, "auto" sizes are set for an unworn contact, "auto" zones are set to the
 * needed widths, and rows = 0 keeps the depth of the wear box. Returns ARC_STOPPED if a callback
 * requested a stop. On failure the run is unchanged. */
arc_status arc_wear_set(arc_wear *wear, const arc_wear_def *def, const arc_mesh_def *mesh,
                        const arc_callbacks *callbacks, arc_error *error);

const arc_wear_def *arc_wear_definition(const arc_wear *wear);
arc_procedure
arc_wear_procedure(const arc_wear *wear); /* procedure that the run uses, never ARC_AUTO */
/* Returns the wear coefficient [mm2/N] of the layer that was exposed at the deepest worn point of a
 * body in the last update. */
double arc_wear_open_k(const arc_wear *wear, arc_body body);
double arc_wear_strokes(const arc_wear *wear); /* number of strokes in a cycle: 2 or 1 */
double
arc_wear_cycles(const arc_wear *wear); /* number of cycles in the whole distance of the run */
double arc_wear_travel(const arc_wear *wear); /* stroke [mm] of the present block */
const arc_shape *arc_wear_shape(const arc_wear *wear);
arc_model *arc_wear_model(const arc_wear *wear);
const arc_wear_record *arc_wear_history(const arc_wear *wear, size_t *count);
const arc_wear_record *arc_wear_last(const arc_wear *wear);
size_t arc_wear_bytes(const arc_wear *wear);

/* Solves the contact on the present shape in the reference configuration (plate at x = 0, nominal
 * load), and returns the contact as a new object. */
arc_status arc_wear_contact(const arc_wear *wear, arc_contact **contact, arc_error *error);

/* Names of the arrays that describe a surface after an update, as a list that ends with NULL. The
 * arrays have the size [nodes, 1]: the unworn position x [mm], the wear depth h [mm], the present
 * height y [mm], and the pressure p [MPa] with the plate at x = 0 under the nominal load. */
extern const char *const arc_surface_names[];

/* Returns the *count arrays of the present surfaces, first of the cylinder, then of the plate, in
 * the order of arc_surface_names. *surfaces is one block, which the caller frees with free().
 * Errors: those of arc_wear_contact. */
arc_status arc_wear_surfaces(const arc_wear *wear, arc_array **surfaces, size_t *count,
                             arc_error *error);

/* Checks that arrays are valid surfaces of a run. The arrays of each body and update must be in
 * sequence, with all names of arc_surface_names, equal numbers of finite values, increasing x and
 * pressures >= 0. ARC_ARGUMENT: the message has the first violation. */
arc_status arc_wear_check_surfaces(const arc_array *surfaces, size_t count, arc_error *error);

/* A fretting loop: tangential force over position in a periodic cycle, computed on the surfaces
 * before an update. */
typedef struct arc_loop {
  size_t count;
  double energy;            /* [N mm] energy dissipated in both strokes */
  double stick_width;       /* [mm] width that never slips */
  int gross;                /* 1 if the whole contact slips at some time, else 0 */
  const double *x;          /* [count] position of the plate's base [mm] */
  const double *tangential; /* [count] force on the plate [N] */
} arc_loop;

/* Computes the fretting loop on the present surfaces. *loop is one block, which the caller frees
 * with free(). Errors: ARC_ARGUMENT (the run has no friction), those of a step, and ARC_STOPPED if
 * a callback requested a stop. */
arc_status arc_wear_loop(arc_wear *wear, const arc_callbacks *callbacks, arc_loop **loop,
                         arc_error *error);

/* Computes the growth rate of ripples [1/cycle] at the present state by power iteration. It is the
 * largest eigenvalue of the derivative of one cycle's wear with respect to the depths. Explicit
 * updates are stable while jump * eigenvalue < 2. Returns ARC_STOPPED if a callback (NULL: none)
 * requested a stop. */
arc_status arc_wear_stability(arc_wear *wear, const arc_callbacks *callbacks, double *eigenvalue,
                              arc_error *error);

/* Returns the roughness of a profile [-]: its sawtooth part (arc_measure_sawtooth) over the middle
 * of the contact divided by the largest depth. On the default mesh the roughness of smooth profiles
 * is below 1e-4. */
double arc_wear_roughness(const arc_wear *wear, arc_body body);

/* Checks a run, for tests and for builds with ARC_CHECKS. All numbers must be finite, distances
 * must not decrease along the history, the wear volume must be k times load times distance by
 * Archard's law, the Jacobians of the elements must be positive, and the contact in the reference
 * configuration must be valid. Errors: ARC_NUMERIC (the message has the failed check and the
 * amount), ARC_MEMORY. */
arc_status arc_wear_validate(const arc_wear *wear, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

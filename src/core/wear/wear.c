/* A wear run: creation, one step, many steps. */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a wear run");
}

static arc_status allocate(arc_wear *w) {
  const int nc = arc_model_mesh(w->model, ARC_CYLINDER)->surface;
  const int np = arc_model_mesh(w->model, ARC_PLATE)->surface;
  w->poses = w->procedure == ARC_SP ? w->def.increments / 2 + 1 : 1;
  w->pose = calloc((size_t)w->poses, sizeof *w->pose);
  w->condensed = malloc((size_t)(w->poses + 1) * sizeof *w->condensed);
  w->work = malloc((size_t)(5 * (nc + np)) * sizeof *w->work);
  if (!w->pose || !w->condensed || !w->work) return ARC_MEMORY;
  w->rate.node[ARC_CYLINDER] = w->work + 4 * (nc + np);
  w->rate.node[ARC_PLATE] = w->rate.node[ARC_CYLINDER] + nc;
  for (int i = 0; i <= w->poses; i++) w->condensed[i] = -1;
  for (int i = 0; i < w->poses; i++)
    if (pose_create(&w->pose[i], w->model) != ARC_OK) return ARC_MEMORY;
  return pose_create(&w->reference, w->model);
}

/* A run with everything but history; `shape` is taken over, whatever happens. */
static arc_status create(arc_model *model, const arc_wear_def *def, arc_shape *shape,
                         arc_wear **result, arc_error *error) {
  *result = NULL;
  const arc_model_def *md = arc_model_definition(model);
  arc_wear *w = calloc(1, sizeof *w);
  if (!w) {
    arc_shape_destroy(&shape);
    return out_of_memory(error);
  }
  w->model = arc_model_retain(model);
  w->def = *def;
  w->shape = shape;
  w->procedure = wear_choose_procedure(def, md);
  w->over_plate = wear_over_plate(def, md);
  w->strokes = arc_wear_def_strokes(def, md);
  if (allocate(w) != ARC_OK) {
    arc_wear_destroy(&w);
    return out_of_memory(error);
  }
  *result = w;
  return ARC_OK;
}

static arc_status append(arc_wear *w, const arc_wear_record *record, arc_error *error) {
  if (w->records == w->capacity) {
    const size_t capacity = 2 * w->capacity + 16;
    arc_wear_record *grown = realloc(w->history, capacity * sizeof *grown);
    if (!grown) return out_of_memory(error);
    w->history = grown;
    w->capacity = capacity;
  }
  w->history[w->records++] = *record;
  return ARC_OK;
}

/* The widest positions must find candidates: said at creation rather than at the first step. */
static arc_status check_reach(arc_wear *w, arc_error *error) {
  if (w->procedure != ARC_SP) return ARC_OK;
  arc_error why;
  if (wear_prepare_pose(w, 0, w->shape, &why) == ARC_OK &&
      pose_solve(&w->pose[0], w->def.load / arc_model_definition(w->model)->thickness, &why) ==
          ARC_OK)
    return ARC_OK;
  double zone[ARC_BODIES];
  arc_wear_zones(&w->def, arc_model_definition(w->model), zone);
  return arc_fail(
      error, why.status,
      "stroke = %g mm: %s (this run needs mesh.zone = {cylinder = %.2f, plate = %.2f} mm)",
      w->def.stroke, why.message, zone[ARC_CYLINDER], zone[ARC_PLATE]);
}

static arc_status start_shape(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                              arc_shape **shape, arc_error *error) {
  if (!start) return arc_shape_create(model, def->geometry, def->refresh, shape, error);
  *shape = NULL;
  if (arc_shape_model(start) != model)
    return arc_fail(error, ARC_ARGUMENT, "worn: the starting shape belongs to another model");
  const arc_status status = arc_shape_clone(start, shape, error);
  if (status == ARC_OK) {
    (*shape)->geometry = def->geometry;
    (*shape)->refresh = def->refresh;
  }
  return status;
}

arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **result, arc_error *error) {
  *result = NULL;
  arc_status status = arc_wear_check(def, arc_model_definition(model), error);
  if (status != ARC_OK) return status;
  arc_shape *shape;
  if ((status = start_shape(model, def, start, &shape, error)) != ARC_OK) return status;
  arc_wear *w;
  if ((status = create(model, def, shape, &w, error)) != ARC_OK) return status;
  arc_wear_record first;
  status = check_reach(w, error);
  if (status == ARC_OK) status = wear_measure(w, w->shape, NULL, &first, error);
  if (status == ARC_OK) status = append(w, &first, error);
  if (status != ARC_OK) arc_wear_destroy(&w);
  *result = w;
  return status;
}

arc_status arc_wear_restore(arc_model *model, const arc_wear_def *def, const arc_shape *stored,
                            const arc_wear_record *history, size_t count, arc_wear **result,
                            arc_error *error) {
  *result = NULL;
  arc_status status = arc_wear_check(def, arc_model_definition(model), error);
  if (status == ARC_OK && (count < 1 || !history))
    status = arc_fail(error, ARC_ARGUMENT, "history: expected at least one record, got %zu", count);
  if (status != ARC_OK) return status;
  arc_shape *shape;
  if ((status = start_shape(model, def, stored, &shape, error)) != ARC_OK) return status;
  arc_wear *w;
  status = create(model, def, shape, &w, error);
  for (size_t r = 0; r < count && status == ARC_OK; r++) status = append(w, &history[r], error);
  if (status != ARC_OK) arc_wear_destroy(&w);
  *result = w;
  return status;
}

arc_status arc_wear_clone(const arc_wear *wear, arc_wear **copy, arc_error *error) {
  return arc_wear_restore(wear->model, &wear->def, wear->shape, wear->history, wear->records, copy,
                          error);
}

void arc_wear_destroy(arc_wear **wear) {
  if (!wear || !*wear) return;
  arc_wear *w = *wear;
  for (int i = 0; w->pose && i < w->poses; i++) pose_free(&w->pose[i]);
  pose_free(&w->reference);
  free(w->pose);
  free(w->condensed);
  free(w->work);
  free(w->history);
  arc_shape_destroy(&w->shape);
  arc_shape_destroy(&w->next);
  arc_model_release(&w->model);
  free(w);
  *wear = NULL;
}

/* --- steps
 * -------------------------------------------------------------------------------------------------------
 */

/* Wears `next` by so many cycles of w->rate and adds volumes [mm3] to the record. */
static arc_status apply(arc_wear *w, arc_shape *next, double cycles, arc_wear_record *record,
                        arc_error *error) {
  const arc_model_def *md = arc_model_definition(w->model);
  double *volume[ARC_BODIES] = {&record->volume_cylinder, &record->volume_plate};
  for (int b = 0; b < ARC_BODIES; b++) {
    const double scale = cycles * wear_coefficient(&w->def, (arc_body)b);
    if (scale == 0) continue;
    double *depth = w->rate.node[b], sum = 0;
    const double *width = b == ARC_CYLINDER ? w->pose[0].wc : w->pose[0].wp;
    if (b == ARC_PLATE && w->over_plate && w->procedure == ARC_NSP) {
      arc_shape_wear_evenly(next, ARC_PLATE, scale * w->rate.even);
      *volume[b] += scale * w->rate.even * 2 * md->radius * md->thickness;
      continue;
    }
    for (int i = 0; i < next->side[b].n; i++) {
      depth[i] *= scale;
      sum += depth[i] * width[i];
    }
    const arc_status status = arc_shape_wear(next, (arc_body)b, depth, error);
    if (status != ARC_OK) return status;
    *volume[b] += sum * md->thickness;
  }
  return ARC_OK;
}

/* One update of `cycles` cycles, ending at `distance`; commits only when all of it has worked. */
static arc_status update(arc_wear *w, double cycles, double distance, arc_stop_fn stop,
                         void *context, arc_error *error) {
  arc_wear_record record, before = *arc_wear_last(w);
  arc_status status = wear_cycle(w, stop, context, error);
  if (status != ARC_OK) return status;
  const int solved = w->def.alpha == 0 && w->over_plate && w->procedure == ARC_NSP ? 0 : w->poses;
  before.solutions += solved;
  before.update += 1;
  before.cycle += cycles;
  before.jump = cycles;
  before.distance = distance;
  if ((status = arc_shape_clone(w->shape, &w->next, error)) != ARC_OK) return status;
  status = apply(w, w->next, cycles, &before, error);
  if (status == ARC_OK) status = wear_measure(w, w->next, &before, &record, error);
  if (status == ARC_OK) status = append(w, &record, error);
  if (status == ARC_OK) {
    arc_shape *old = w->shape;
    w->shape = w->next;
    w->next = old;
  }
  arc_shape_destroy(&w->next);
  return status;
}

/* Cycles until `target` [mm] less than this are the end: what is left is rounding. */
static const double no_distance = 1e-12;

static arc_status step_towards(arc_wear *w, double target, arc_stop_fn stop, void *context,
                               arc_error *error) {
  const double done = arc_wear_last(w)->distance, per_cycle = w->strokes * w->def.stroke;
  const double left = (target - done) / per_cycle;
  if (left <= no_distance * (1 + target / per_cycle)) return ARC_OK;
  /* a last step that is whole but for rounding stays whole */
  const int last = left <= w->def.jump * (1 + 1e-9);
  const double cycles = last ? left : w->def.jump;
  return update(w, cycles, last ? target : done + cycles * per_cycle, stop, context, error);
}

arc_status arc_wear_step(arc_wear *w, arc_stop_fn stop, void *context, arc_error *error) {
  return step_towards(w, w->def.distance, stop, context, error);
}

arc_status arc_wear_run(arc_wear *w, double distance, arc_stop_fn stop,
                        arc_wear_progress_fn progress, void *context, arc_error *error) {
  if (!(distance > 0) || !isfinite(distance))
    return arc_fail(error, ARC_ARGUMENT, "distance: expected above 0 mm, got %g mm", distance);
  if (distance > w->def.distance) w->def.distance = distance;
  for (;;) {
    const size_t before = w->records;
    const arc_status status = step_towards(w, distance, stop, context, error);
    if (status != ARC_OK || w->records == before) return status;
    if (progress && progress(context, w)) return arc_fail(error, ARC_STOPPED, "stopped on request");
  }
}

/* --- what a run tells
 * -------------------------------------------------------------------------------------------- */

const arc_wear_def *arc_wear_definition(const arc_wear *w) {
  return &w->def;
}

arc_procedure arc_wear_procedure(const arc_wear *w) {
  return w->procedure;
}

double arc_wear_strokes(const arc_wear *w) {
  return w->strokes;
}

double arc_wear_cycles(const arc_wear *w) {
  return w->def.distance / (w->strokes * w->def.stroke);
}

const arc_shape *arc_wear_shape(const arc_wear *w) {
  return w->shape;
}

arc_model *arc_wear_model(const arc_wear *w) {
  return w->model;
}

const arc_wear_record *arc_wear_history(const arc_wear *w, size_t *count) {
  if (count) *count = w->records;
  return w->history;
}

const arc_wear_record *arc_wear_last(const arc_wear *w) {
  return &w->history[w->records - 1];
}

size_t arc_wear_bytes(const arc_wear *w) {
  const size_t n = (size_t)(w->reference.nc + w->reference.np);
  const size_t one_pose = 2 * (size_t)w->reference.nc * (size_t)w->reference.nc + 20 * n;
  return ((size_t)(w->poses + 1) * one_pose + 5 * n) * sizeof(double) + 2 * shape_bytes(w->shape) +
         w->capacity * sizeof(arc_wear_record);
}

arc_status arc_wear_contact(const arc_wear *w, arc_contact **contact, arc_error *error) {
  return arc_contact_solve(w->shape, w->def.load, 0, contact, error);
}

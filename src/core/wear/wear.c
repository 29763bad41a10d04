/* A wear run as an object: creation, restoring, change of definition, what it tells. */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a wear run");
}

/* One block of doubles for two points, the rate and the update's depths. */
static arc_status allocate(arc_wear *w) {
  w->nc = arc_model_mesh(w->model, ARC_CYLINDER)->surface;
  w->np = arc_model_mesh(w->model, ARC_PLATE)->surface;
  const int n = w->nc + w->np;
  w->memory = calloc((size_t)(8 * n), sizeof *w->memory);
  if (!w->memory) return ARC_MEMORY;
  double *at = w->memory;
  for (int k = 0; k < 2; k++) {
    double **part[] = {w->point[k].p, w->point[k].q, w->point[k].u};
    for (int m = 0; m < 3; m++, at += n) {
      part[m][ARC_CYLINDER] = at;
      part[m][ARC_PLATE] = at + w->nc;
    }
  }
  w->rate.node[ARC_CYLINDER] = at;
  w->rate.node[ARC_PLATE] = at + w->nc;
  w->delta[ARC_CYLINDER] = at + n;
  w->delta[ARC_PLATE] = at + n + w->nc;
  return arc_pose_create(&w->reference, w->model);
}

/* Takes a copy of a checked definition and what follows from it. */
static arc_status take_definition(arc_wear *w, const arc_wear_def *def) {
  const arc_model_def *md = arc_model_definition(w->model);
  arc_status status = arc_wear_def_copy(def, &w->def);
  if (status != ARC_OK) return status;
  w->procedure = arc_wear_choose_procedure(&w->def, md);
  w->over_plate = arc_wear_over_plate(&w->def, md);
  status = arc_wear_blocks_create(&w->def, md, &w->block, &w->blocks);
  w->current = -1;
  /* without a distance: all the blocks of loading */
  if (status == ARC_OK && w->def.distance == 0)
    w->def.distance = arc_wear_block_end(&w->block[w->blocks - 1]);
  return status;
}

/* A run with everything but history; `shape` is taken over, whatever happens. */
static arc_status create(arc_model *model, const arc_wear_def *def, arc_shape *shape,
                         arc_wear **result, arc_error *error) {
  *result = NULL;
  arc_wear *w = calloc(1, sizeof *w);
  if (!w) {
    arc_shape_destroy(&shape);
    return out_of_memory(error);
  }
  w->model = arc_model_retain(model);
  w->shape = shape;
  if (take_definition(w, def) != ARC_OK || allocate(w) != ARC_OK) {
    arc_wear_destroy(&w);
    return out_of_memory(error);
  }
  *result = w;
  return ARC_OK;
}

arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error) {
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

/* The outermost positions must find the contact: said at creation rather than in the middle of a
 * run. */
static arc_status check_reach(arc_wear *w, arc_error *error) {
  if (w->procedure != ARC_SP) return ARC_OK;
  int solutions = 0;
  for (int b = 0; b < w->blocks; b++) {
    const wear_block *block = &w->block[b];
    int least = 0, most = 0;
    for (int i = 1; i < block->count; i++) {
      if (block->x[i] < block->x[least]) least = i;
      if (block->x[i] > block->x[most]) most = i;
    }
    arc_status status = arc_wear_enter_block(w, b, error);
    if (status != ARC_OK) return status;
    arc_error why;
    const arc_wear_record unworn = {0};
    const wear_window ends[2] = {{.first = least, .last = least, .state = &unworn},
                                 {.first = most, .last = most, .state = &unworn}};
    for (int e = 0; e < 2 && status == ARC_OK; e++)
      status = arc_wear_probe(w, &ends[e], &solutions, &why);
    if (status == ARC_OK) continue;
    if (status != ARC_ZONE) return arc_fail(error, status, "%s", why.message);
    double zone[ARC_BODIES];
    arc_wear_zones(&w->def, arc_model_definition(w->model), zone);
    return arc_fail(error, status,
                    "%s (this run needs mesh.zone = {cylinder = %.2f, plate = %.2f} mm)",
                    why.message, zone[ARC_CYLINDER], zone[ARC_PLATE]);
  }
  return ARC_OK;
}

static arc_status start_shape(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                              arc_shape **shape, arc_error *error) {
  if (!start) return arc_shape_create(model, def->geometry, def->refresh, shape, error);
  *shape = NULL;
  if (arc_shape_model(start) != model)
    return arc_fail(error, ARC_ARGUMENT, "worn: the starting shape belongs to another model");
  arc_status status = arc_shape_clone(start, shape, error);
  if (status == ARC_OK) status = arc_shape_set_geometry(*shape, def->geometry, def->refresh, error);
  if (status != ARC_OK) arc_shape_destroy(shape);
  return status;
}

/* Row 0 of the history; the shape may be worn already. */
static arc_status first_record(arc_wear *w, arc_error *error) {
  const wear_block *block = &w->block[0];
  arc_wear_record first = {.distance = block->start_distance, .cycle = block->start_cycle};
  double k[ARC_BODIES];
  arc_status status = arc_wear_measure(w, w->shape, &first, error);
  if (status == ARC_OK)
    status = arc_wear_coefficients(w, first.distance, first.distance, &first, k, error);
  if (status != ARC_OK) return status;
  arc_wear_note_coefficients(k, &first);
  return arc_wear_append(w, &first, error);
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
  status = check_reach(w, error);
  if (status == ARC_OK) status = first_record(w, error);
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
  for (size_t r = 0; r < count && status == ARC_OK; r++)
    status = arc_wear_append(w, &history[r], error);
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
  arc_wear_leave_block(w);
  arc_pose_free(&w->reference);
  arc_wear_blocks_free(&w->block, w->blocks);
  arc_wear_def_free(&w->def);
  free(w->memory);
  free(w->history);
  arc_shape_destroy(&w->shape);
  arc_shape_destroy(&w->next);
  arc_model_release(&w->model);
  free(w);
  *wear = NULL;
}

arc_status arc_wear_set(arc_wear *w, const arc_wear_def *wanted, arc_error *error) {
  const arc_wear_record *now = arc_wear_last(w);
  arc_wear_def def = *wanted;
  const int same_loading = def.blocks > 0 && def.loading == w->def.loading;
  def.start_distance = same_loading ? w->def.start_distance : now->distance;
  def.start_cycle = same_loading ? w->def.start_cycle : now->cycle;
  arc_status status = arc_wear_check(&def, arc_model_definition(w->model), error);
  if (status != ARC_OK) return status;
  arc_wear *changed;
  status = arc_wear_restore(w->model, &def, w->shape, w->history, w->records, &changed, error);
  if (status == ARC_OK) status = check_reach(changed, error);
  if (status == ARC_OK) {
    const arc_wear old = *w;
    *w = *changed;
    *changed = old;
  }
  arc_wear_destroy(&changed);
  return status;
}

/* --- what a run tells --- */

const arc_wear_def *arc_wear_definition(const arc_wear *w) {
  return &w->def;
}

arc_procedure arc_wear_procedure(const arc_wear *w) {
  return w->procedure;
}

double arc_wear_strokes(const arc_wear *w) {
  return w->over_plate ? 1 : 2;
}

/* Cycles of the whole distance; the last block goes on where the distance does. */
double arc_wear_cycles(const arc_wear *w) {
  double cycles = 0, left = w->def.distance - w->block[0].start_distance;
  for (int b = 0; b < w->blocks && left > 0; b++) {
    const double here = left / w->block[b].sliding;
    cycles += b + 1 < w->blocks ? fmin(here, w->block[b].cycles) : here;
    left -= w->block[b].cycles * w->block[b].sliding;
  }
  return w->block[0].start_cycle + cycles;
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
  const size_t n = (size_t)(w->nc + w->np);
  return (size_t)(w->poses + 1) * arc_pose_bytes(&w->reference) + 8 * n * sizeof(double) +
         2 * arc_shape_bytes(w->shape) + w->capacity * sizeof(arc_wear_record);
}

arc_status arc_wear_contact(const arc_wear *w, arc_contact **contact, arc_error *error) {
  return arc_contact_solve(w->shape, w->def.load, 0, contact, error);
}

/* Creates, restores and changes wear runs, and returns their results. */
#include "core/base/carve.h"
#include "core/pair/model.h"
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a wear run");
}

static arc_status allocate(arc_wear *w) {
  const arc_status status = w->kind->begin(w);
  if (status != ARC_OK) return status;
  double **rate = w->work.rate.node, **depth = w->work.depth.node, **start = w->start.rate.node;
  const size_t nc = (size_t)w->nc, np = (size_t)w->np;
  const carve_part parts[] = {{&rate[0], nc},  {&rate[1], np},  {&depth[0], nc},
                              {&depth[1], np}, {&start[0], nc}, {&start[1], np}};
  return ARC_CARVE(parts) ? ARC_OK : ARC_MEMORY;
}

/* Copies a checked definition to a run, and sets the members that are derived from it. */
static arc_status take_definition(arc_wear *w, const arc_wear_def *def) {
  const arc_model_def *md = arc_model_definition(w->model);
  arc_status status = arc_wear_def_copy(def, &w->def);
  if (status != ARC_OK) return status;
  w->kind = w->model->kind;
  w->manner = w->kind->manner(&w->def, md);
  status = arc_wear_blocks_create(&w->def, md, &w->block, &w->blocks);
  /* without a distance the run includes all blocks of loading */
  if (status == ARC_OK && w->def.distance == 0)
    w->def.distance = arc_wear_block_end(&w->block[w->blocks - 1]);
  return status;
}

/* Computes row 0 of the history from the initial shape, which may be worn. */
static arc_status first_record(arc_wear *w, arc_error *error) {
  const wear_block *block = &w->block[0];
  arc_wear_record first = {.distance = block->start_distance, .cycle = block->start_cycle};
  double k[ARC_BODIES];
  arc_wear_note_motion(w, block, 0, &first);
  arc_status status = w->kind->measure(w, w->shape, &first, error);
  if (status == ARC_OK)
    status = arc_wear_coefficients(w, first.distance, first.distance, &first, k, error);
  if (status != ARC_OK) return status;
  arc_wear_note_coefficients(k, &first);
  return arc_wear_append(w, &first, error);
}

static arc_status check_reach(arc_wear *w, arc_error *error) {
  return w->kind->check_reach ? w->kind->check_reach(w, error) : ARC_OK;
}

/* Creates a run with a checked definition, a copy of a shape, and a history. */
static arc_status take_up(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                          const arc_wear_record *history, size_t count, arc_wear **result,
                          arc_error *error) {
  arc_wear *w = *result = calloc(1, sizeof *w);
  if (!w) return out_of_memory(error);
  w->model = arc_model_retain(model);
  if (take_definition(w, def) != ARC_OK) {
    arc_wear_destroy(result);
    return out_of_memory(error);
  }
  arc_status status = w->kind->surfaces(model, def, start, &w->shape, error);
  if (status == ARC_OK && allocate(w) != ARC_OK) status = out_of_memory(error);
  for (size_t r = 0; r < count && status == ARC_OK; r++)
    status = arc_wear_append(w, &history[r], error);
  if (status != ARC_OK) arc_wear_destroy(result);
  return status;
}

arc_status arc_wear_create_on(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                              arc_wear **result, arc_error *error) {
  *result = NULL;
  arc_status status = arc_wear_check(def, arc_model_definition(model), error);
  if (status == ARC_OK) status = take_up(model, def, start, NULL, 0, result, error);
  if (status == ARC_OK) status = check_reach(*result, error);
  if (status == ARC_OK) status = first_record(*result, error);
  if (status != ARC_OK) arc_wear_destroy(result);
  return status;
}

/* Destroys the run *w and sets *w to the run `by`. */
static void replace(arc_wear **w, arc_wear *by) {
  by->late = (*w)->late;
  arc_wear_destroy(w);
  *w = by;
}

arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **result, arc_error *error) {
  arc_wear *finer = NULL;
  arc_status status = arc_wear_create_on(model, def, start, result, error);
  const arc_growth *growth = status == ARC_OK ? (*result)->kind->growth : NULL;
  if (growth && growth->resolve) status = growth->resolve(*result, &finer, error);
  if (status != ARC_OK) arc_wear_destroy(result);
  if (finer) replace(result, finer);
  return status;
}

arc_status arc_wear_restore(arc_model *model, const arc_wear_def *def, const arc_shape *shape,
                            const arc_wear_record *history, size_t count, arc_wear **result,
                            arc_error *error) {
  *result = NULL;
  arc_status status = arc_wear_check(def, arc_model_definition(model), error);
  if (status != ARC_OK) return status;
  if (count < 1 || !history)
    return arc_fail(error, ARC_ARGUMENT, "history: expected at least one record, got %zu", count);
  status = arc_wear_check_history(history, count, error);
  if (status != ARC_OK) return status;
  return take_up(model, def, shape, history, count, result, error);
}

arc_status arc_wear_clone(const arc_wear *w, arc_wear **copy, arc_error *error) {
  return take_up(w->model, &w->def, w->shape, w->history, w->records, copy, error);
}

void arc_wear_destroy(arc_wear **wear) {
  if (!wear || !*wear) return;
  arc_wear *w = *wear;
  if (w->kind) {
    w->kind->end_tangent(&w->start.tangent);
    w->kind->end(w);
    w->kind->discard(&w->shape);
  }
  arc_wear_blocks_free(&w->block, w->blocks);
  arc_wear_def_free(&w->def);
  free(w->work.rate.node[0]);
  free(w->history);
  arc_model_release(&w->model);
  free(w);
  *wear = NULL;
}

/* If, after a change of the definition, the contact does not fit on the present surfaces, copies
 * the run to larger surfaces. */
static arc_status enlarge_model(arc_wear **w, const arc_callbacks *callbacks, arc_error *error) {
  const arc_growth *growth = (*w)->kind->growth;
  arc_wear *larger = NULL;
  arc_error why = {0};
  const arc_status status = check_reach(*w, &why);
  if (status == ARC_OK) return ARC_OK;
  if (status != ARC_ZONE || !growth || !growth->can_grow(*w))
    return arc_fail(error, status, "%s", why.message);
  const arc_status grown = growth->grow(*w, status, callbacks, &larger, error);
  if (grown == ARC_STOPPED) return grown;
  if (grown != ARC_OK) return arc_fail(error, status, "%s", why.message);
  growth->report(*w, larger, callbacks);
  replace(w, larger);
  return check_reach(*w, error);
}

static arc_status go_over(arc_wear **w, const arc_mesh_def *mesh, const arc_callbacks *callbacks,
                          arc_error *error) {
  const arc_growth *growth = (*w)->kind->growth;
  arc_wear *other = NULL;
  if (!growth)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'mesh': the sites of a run cannot be "
                    "changed");
  const arc_status status = growth->remesh(*w, mesh, callbacks, &other, error);
  if (status != ARC_OK) return status;
  growth->report_mesh(*w, other, callbacks);
  replace(w, other);
  return ARC_OK;
}

void arc_wear_exchange(arc_wear *a, arc_wear *b) {
  const arc_wear held = *a;
  *a = *b;
  *b = held;
}

arc_status arc_wear_set(arc_wear *w, const arc_wear_def *wanted, const arc_mesh_def *mesh,
                        const arc_callbacks *callbacks, arc_error *error) {
  const arc_wear_record *now = arc_wear_last(w);
  arc_wear_def def = *wanted;
  const int same_loading = def.blocks > 0 && def.loading == w->def.loading;
  def.start_distance = same_loading ? w->def.start_distance : now->distance;
  def.start_cycle = same_loading ? w->def.start_cycle : now->cycle;
  arc_status status = arc_wear_check(&def, arc_model_definition(w->model), error);
  if (status != ARC_OK) return status;
  arc_wear *changed;
  status = take_up(w->model, &def, w->shape, w->history, w->records, &changed, error);
  if (status == ARC_OK && mesh) status = go_over(&changed, mesh, callbacks, error);
  if (status == ARC_OK) status = enlarge_model(&changed, callbacks, error);
  if (status == ARC_OK) arc_wear_exchange(w, changed);
  arc_wear_destroy(&changed);
  return status;
}

/* --- results of a run */

double arc_wear_open_k(const arc_wear *w, arc_body body) {
  const arc_wear_record *now = arc_wear_last(w);
  const double k = now->k * (body == ARC_CYLINDER ? now->alpha : 1 - now->alpha);
  return w->kind->open_share ? k * w->kind->open_share(w, body) : k;
}

const arc_wear_def *arc_wear_definition(const arc_wear *w) {
  return &w->def;
}

arc_procedure arc_wear_procedure(const arc_wear *w) {
  return w->manner.procedure;
}

double arc_wear_strokes(const arc_wear *w) {
  return w->manner.strokes;
}

/* Returns the number of cycles in the whole distance of the run. The last block lasts to the end of
 * the distance. */
double arc_wear_cycles(const arc_wear *w) {
  double cycles = 0, left = w->def.distance - w->block[0].start_distance;
  for (int b = 0; b < w->blocks && left > 0; b++) {
    const double here = left / w->block[b].sliding;
    cycles += b + 1 < w->blocks ? fmin(here, w->block[b].cycles) : here;
    left -= w->block[b].cycles * w->block[b].sliding;
  }
  return w->block[0].start_cycle + cycles;
}

double arc_wear_travel(const arc_wear *w) {
  return arc_wear_block_at(w, arc_wear_last(w)->cycle)->travel;
}

const arc_shape *arc_wear_shape(const arc_wear *w) {
  return w->shape;
}

arc_model *arc_wear_model(const arc_wear *w) {
  return w->model;
}

size_t arc_wear_bytes(const arc_wear *w) {
  return 6 * (size_t)(w->nc + w->np) * sizeof(double) + w->capacity * sizeof(arc_wear_record) +
         (w->kind->bytes ? w->kind->bytes(w) : 0);
}

arc_status arc_wear_contact(const arc_wear *w, arc_contact **contact, arc_error *error) {
  *contact = NULL;
  if (w->kind->contact) return w->kind->contact(w, contact, error);
  return arc_fail(error, ARC_ARGUMENT, "pairs of kind \"%s\" have no contact objects",
                  w->kind->name);
}

double arc_wear_roughness(const arc_wear *w, arc_body body) {
  return w->kind->roughness ? w->kind->roughness(w, body) : NAN;
}

/* --- rates ------------------------------------------------------------------------------------ */

void arc_wear_rate_clear(wear_rate *rate, int n) {
  memset(rate->node[0], 0, (size_t)n * sizeof(double));
  *rate = (wear_rate){.node = {rate->node[ARC_UPPER], rate->node[ARC_LOWER]}};
}

void arc_wear_rate_copy(const wear_rate *from, wear_rate *to, int n) {
  wear_rate copy = *from;
  memcpy(to->node[0], from->node[0], (size_t)n * sizeof(double));
  memcpy(copy.node, to->node, sizeof copy.node);
  *to = copy;
}

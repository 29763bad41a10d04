/* A wear run as an object: creation, restoring, change of definition, what it tells. */
#include "core/wear/rate.h"
#include "core/wear/rebuild.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a wear run");
}

static arc_status allocate(arc_wear *w) {
  const int nc = w->nc = arc_model_mesh(w->model, ARC_CYLINDER)->surface;
  const int np = w->np = arc_model_mesh(w->model, ARC_PLATE)->surface;
  double *rate = calloc(7 * (size_t)(nc + np), sizeof *rate);
  if (!rate) return ARC_MEMORY;
  double *depth = rate + nc + np;
  w->work = (wear_work){
      .rate.node = {rate, rate + nc}, .depth.node = {depth, depth + nc}, .slip = depth + nc + np};
  double *start = rate + 6 * (nc + np);
  w->start.rate = (wear_rate){.node = {start, start + nc}};
  if (arc_path_create(&w->path, w->model, arc_wear_rubs(&w->def)) != ARC_OK) return ARC_MEMORY;
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
  /* without a distance: all the blocks of loading */
  if (status == ARC_OK && w->def.distance == 0)
    w->def.distance = arc_wear_block_end(&w->block[w->blocks - 1]);
  return status;
}

/* Points of a block where the plate stands farthest to either side, where the load does, and where
 * it does on the plate. */
enum { ENDS = 6 };
static int find_ends(const wear_block *block, double radius, int end[ENDS]) {
  int turns = 0;
  memset(end, 0, ENDS * sizeof *end);
  for (int i = 0; i < block->count; i++) {
    const double under = radius * block->angle[i];
    const double at[] = {block->x[i], under, under - block->x[i]};
    turns = turns || under != 0;
    for (int k = 0; k < ENDS; k++) {
      const double best = radius * block->angle[end[k]];
      const double then[] = {block->x[end[k]], best, best - block->x[end[k]]};
      if (k % 2 ? at[k / 2] > then[k / 2] : at[k / 2] < then[k / 2]) end[k] = i;
    }
  }
  return turns ? ENDS : 2;
}

/* Zones that the bodies have no room for. */
static arc_status refuse_way(const arc_model_def *def, const double zone[ARC_BODIES],
                             const arc_error *why, arc_error *error) {
  const double degrees = 0.5 * arc_model_widest_zone(def, ARC_PLATE) / arc_model_way(def, 1);
  char angle[100] = "";
  if (arc_model_is_hole(def))
    snprintf(angle, sizeof angle,
             ": %.0f degrees to either side, within which the contact stays as they turn", degrees);
  return arc_fail(
      error, ARC_ZONE,
      "%s (this run needs zones of %.2f and %.2f mm, more than the bodies have room for, "
      "%.2f and %.2f mm%s)",
      why->message, zone[ARC_CYLINDER], zone[ARC_PLATE], arc_model_widest_zone(def, ARC_CYLINDER),
      arc_model_widest_zone(def, ARC_PLATE), angle);
}

/* What went wrong at an end of a path; for want of room, with the zones that would do. */
static arc_status refuse_reach(const arc_wear *w, const arc_error *why, arc_error *error) {
  if (why->status != ARC_ZONE) return arc_fail(error, why->status, "%s", why->message);
  const arc_model_def *def = arc_model_definition(w->model);
  double zone[ARC_BODIES];
  arc_wear_zones(&w->def, def, zone);
  for (int b = 0; b < ARC_BODIES; b++)
    if (zone[b] > arc_model_widest_zone(def, (arc_body)b)) return refuse_way(def, zone, why, error);
  return arc_fail(error, ARC_ZONE,
                  "%s (this run needs mesh.zone = {cylinder = %.2f, plate = %.2f} mm)",
                  why->message, zone[ARC_CYLINDER], zone[ARC_PLATE]);
}

/* The outermost positions must find the contact: said at creation rather than in the middle of a
 * run. */
static arc_status check_reach(arc_wear *w, arc_error *error) {
  const arc_wear_record unworn = {0};
  arc_error why = {0};
  for (int b = 0; b < w->blocks && w->procedure == ARC_SP; b++) {
    int end[ENDS];
    const double radius = arc_model_body(w->model, ARC_UPPER)->chart.radius;
    const int ends = find_ends(&w->block[b], radius, end);
    const arc_status status = arc_path_enter(&w->path, &w->block[b], w->model, error);
    if (status != ARC_OK) return status;
    for (int e = 0; e < ends; e++) {
      const wear_window point = {
          .shape = w->shape, .first = end[e], .last = end[e], .state = &unworn};
      if (arc_wear_probe(w, &point, &why) != ARC_OK) return refuse_reach(w, &why, error);
    }
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
  arc_wear_note_motion(w, block, 0, &first);
  arc_status status = arc_wear_measure(w, w->shape, &first, error);
  if (status == ARC_OK)
    status = arc_wear_coefficients(w, first.distance, first.distance, &first, k, error);
  if (status != ARC_OK) return status;
  arc_wear_note_coefficients(k, &first);
  return arc_wear_append(w, &first, error);
}

/* A run of a checked definition on a copy of a shape, with a history. */
static arc_status take_up(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                          const arc_wear_record *history, size_t count, arc_wear **result,
                          arc_error *error) {
  arc_wear *w = *result = calloc(1, sizeof *w);
  if (!w) return out_of_memory(error);
  w->model = arc_model_retain(model);
  arc_status status = start_shape(model, def, start, &w->shape, error);
  if (status == ARC_OK && (take_definition(w, def) != ARC_OK || allocate(w) != ARC_OK))
    status = out_of_memory(error);
  for (size_t r = 0; r < count && status == ARC_OK; r++)
    status = arc_wear_append(w, &history[r], error);
  if (status != ARC_OK) arc_wear_destroy(result);
  return status;
}

arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **result, arc_error *error) {
  *result = NULL;
  arc_status status = arc_wear_check(def, arc_model_definition(model), error);
  if (status == ARC_OK) status = take_up(model, def, start, NULL, 0, result, error);
  if (status == ARC_OK) status = check_reach(*result, error);
  if (status == ARC_OK) status = first_record(*result, error);
  if (status != ARC_OK) arc_wear_destroy(result);
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
  arc_path_free(&w->path);
  arc_pose_free(&w->reference);
  arc_wear_blocks_free(&w->block, w->blocks);
  arc_wear_def_free(&w->def);
  if (w->start.jacobian) arc_wear_jacobian_free(w->start.jacobian);
  free(w->start.jacobian);
  free(w->work.rate.node[0]);
  free(w->history);
  arc_shape_destroy(&w->shape);
  arc_model_release(&w->model);
  free(w);
  *wear = NULL;
}

/* A run takes the place of another. */
static void replace(arc_wear **w, arc_wear *by) {
  arc_wear_destroy(w);
  *w = by;
}

/* Puts a changed run on larger meshes where its way has no room on those it has. */
static arc_status make_room(arc_wear **w, const arc_callbacks *callbacks, arc_error *error) {
  arc_wear *larger = NULL;
  arc_error why = {0};
  const arc_status status = check_reach(*w, &why);
  if (status == ARC_OK) return ARC_OK;
  if (status != ARC_ZONE || !arc_wear_has_room(*w))
    return arc_fail(error, status, "%s", why.message);
  const arc_status grown = arc_wear_grow(*w, status, callbacks, &larger, error);
  if (grown == ARC_STOPPED) return grown;
  if (grown != ARC_OK) return arc_fail(error, status, "%s", why.message);
  arc_wear_tell_grown(*w, larger, callbacks);
  replace(w, larger);
  return check_reach(*w, error);
}

static arc_status go_over(arc_wear **w, const arc_mesh_def *mesh, const arc_callbacks *callbacks,
                          arc_error *error) {
  arc_wear *other = NULL;
  const arc_status status = arc_wear_remesh(*w, mesh, callbacks, &other, error);
  if (status != ARC_OK) return status;
  arc_wear_tell_meshes(*w, other, "the meshes are those asked for", callbacks);
  replace(w, other);
  return ARC_OK;
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
  if (status == ARC_OK) status = make_room(&changed, callbacks, error);
  if (status == ARC_OK) arc_wear_exchange(w, changed);
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
  const size_t n = (size_t)(w->nc + w->np), linear = w->start.jacobian ? n * n : 0;
  const size_t rubs = w->path.rubs ? 1 : 0;
  const size_t grips =
      w->path.compliance ? (size_t)w->path.poses * arc_tangential_bytes(&w->path.compliance[0]) : 0;
  return (size_t)(w->path.poses + 1) * arc_pose_bytes(&w->reference) + grips +
         rubs * arc_friction_workspace_bytes(&w->path.workspace) +
         (15 * n + linear) * sizeof(double) + 2 * arc_shape_bytes(w->shape) +
         w->capacity * sizeof(arc_wear_record);
}

arc_status arc_wear_contact(const arc_wear *w, arc_contact **contact, arc_error *error) {
  arc_contact_def def = arc_contact_default();
  def.load = w->def.load;
  def.load_angle = w->def.load_angle;
  return arc_contact_solve(w->shape, &def, NULL, contact, error);
}

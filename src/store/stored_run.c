/* Runs in a run file: history, surfaces, and the state to go on from. Leans on definition.c for
 * what the run was asked to do. */
#include "store/store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = sizeof(arc_wear_record) / sizeof(double) };

static arc_status out_of_memory(const arc_store *store, arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
}

/* --- saving ----------------------------------------------------------------------------------- */

static arc_status save_history(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  size_t count;
  const arc_wear_record *history = arc_wear_history(wear, &count);
  query *q;
  arc_status status = arc_store_query(
      store, "INSERT INTO history (case_id, step@columns) VALUES (?1, ?2@values)", id, &q, error);
  for (size_t row = 0; row < count && status == ARC_OK; row++) {
    arc_query_set_whole(q, 2, (long long)row);
    for (int i = 0; i < COLUMNS; i++)
      arc_query_set_number(q, 3 + i, arc_wear_record_get(&history[row], i));
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

static arc_status save_surface(arc_store *store, int id, const arc_surface *surface,
                               arc_error *error) {
  query *q;
  arc_status status = arc_store_query(
      store,
      "INSERT OR REPLACE INTO surfaces (case_id, updates, distance_mm, body, node, x_mm, h_mm, "
      "y_mm, p_MPa) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9)",
      id, &q, error);
  for (size_t i = 0; i < surface->count && status == ARC_OK; i++) {
    const double *const column[] = {surface->x, surface->h, surface->y, surface->p};
    arc_query_set_number(q, 2, surface->update);
    arc_query_set_number(q, 3, surface->distance);
    arc_query_set_text(q, 4, arc_body_name(surface->body));
    arc_query_set_whole(q, 5, (long long)i);
    for (int c = 0; c < 4; c++) arc_query_set_number(q, 6 + c, column[c][i]);
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

static arc_status save_state(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  query *q;
  arc_status status =
      arc_store_query(store,
                      "INSERT INTO state (case_id, body, condensed, even, h, xy, settled) "
                      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)",
                      id, &q, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) {
    arc_surface_state state = arc_shape_state(arc_wear_shape(wear), (arc_body)b);
    size_t n = (size_t)state.count;
    arc_query_set_text(q, 2, arc_body_name((arc_body)b));
    arc_query_set_whole(q, 3, state.condensed);
    arc_query_set_number(q, 4, state.even);
    arc_query_set_array(q, 5, state.h, n);
    arc_query_set_array(q, 6, state.xy, 2 * n);
    arc_query_set_array(q, 7, state.settled, 2 * n);
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

static arc_status forget(arc_store *store, int id, arc_error *error) {
  static const char *const statements[] = {"DELETE FROM history WHERE case_id = ?1",
                                           "DELETE FROM surfaces WHERE case_id = ?1",
                                           "DELETE FROM state WHERE case_id = ?1"};
  arc_status status = ARC_OK;
  for (int i = 0; i < 3 && status == ARC_OK; i++)
    status = arc_store_run(store, statements[i], id, error);
  return status;
}

arc_status arc_store_save(arc_store *store, int id, const arc_wear *wear,
                          const arc_surface *surfaces, size_t count, arc_error *error) {
  int own = 0;
  if (arc_model_is_given(arc_wear_model(wear)))
    return arc_fail(error, ARC_ARGUMENT,
                    "a run on a mesh from outside cannot be stored: its file would not hold the "
                    "mesh");
  arc_status status = arc_store_enter(store, &own, error);
  if (status == ARC_OK) status = arc_store_open_seal(store, id, error);
  if (status == ARC_OK) status = forget(store, id, error);
  if (status == ARC_OK) status = arc_definition_save(store, id, wear, error);
  if (status == ARC_OK) status = save_history(store, id, wear, error);
  for (size_t i = 0; i < count && status == ARC_OK; i++)
    status = save_surface(store, id, &surfaces[i], error);
  if (status == ARC_OK) status = save_state(store, id, wear, error);
  return arc_store_leave(store, own, status, error);
}

/* --- history ---------------------------------------------------------------------------------- */

static arc_status count_rows(arc_store *store, const char *sql, int id, size_t *rows,
                             arc_error *error) {
  query *q;
  int row;
  arc_status status = arc_store_query(store, sql, id, &q, error);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  if (status == ARC_OK) *rows = (size_t)arc_query_whole(q, 0);
  arc_query_close(&q);
  return status;
}

static void read_record(query *q, arc_wear_record *record) {
  int column = 1;
#define READ(name, unit, text) record->name = arc_query_number(q, column++);
  ARC_WEAR_COLUMNS(READ)
#undef READ
}

arc_status arc_store_history(arc_store *store, int id, arc_wear_record **history, size_t *count,
                             arc_error *error) {
  query *q = NULL;
  size_t rows = 0;
  int row = 0;
  *history = NULL;
  *count = 0;
  arc_status status = arc_store_verify(store, id, error);
  if (status == ARC_OK)
    status = count_rows(store, "SELECT count(*) FROM history WHERE case_id = ?1", id, &rows, error);
  if (status != ARC_OK) return status;
  *history = malloc((rows + 1) * sizeof **history);
  if (!*history) return out_of_memory(store, error);
  status = arc_store_query(
      store, "SELECT step@columns FROM history WHERE case_id = ?1 ORDER BY step", id, &q, error);
  while (status == ARC_OK && *count < rows && (status = arc_query_step(q, &row, error)) == ARC_OK &&
         row)
    read_record(q, &(*history)[(*count)++]);
  arc_query_close(&q);
  if (status == ARC_OK) return ARC_OK;
  free(*history);
  *history = NULL;
  *count = 0;
  return status;
}

/* --- surfaces --------------------------------------------------------------------------------- */

/* Room for `rows` nodes in at most as many surfaces: the surfaces, then the four columns. */
static arc_surface *allocate_surfaces(size_t rows, double *column[4]) {
  arc_surface *block = malloc((rows + 1) * (sizeof *block + 4 * sizeof(double)));
  if (!block) return NULL;
  column[0] = (double *)(void *)(block + rows + 1);
  for (int c = 1; c < 4; c++) column[c] = column[c - 1] + rows;
  return block;
}

static arc_body body_named(const char *name) {
  return strcmp(name, arc_body_name(ARC_PLATE)) == 0 ? ARC_PLATE : ARC_CYLINDER;
}

/* Node `at` of all: goes to the last surface, or begins the next. */
static void read_node(query *q, size_t at, double *column[4], arc_surface *surfaces,
                      size_t *count) {
  double update = arc_query_number(q, 0);
  arc_body body = body_named(arc_query_text(q, 2));
  arc_surface *last = *count > 0 ? &surfaces[*count - 1] : NULL;
  if (!last || last->update != update || last->body != body) {
    last = &surfaces[(*count)++];
    *last = (arc_surface){.body = body,
                          .update = update,
                          .distance = arc_query_number(q, 1),
                          .x = column[0] + at,
                          .h = column[1] + at,
                          .y = column[2] + at,
                          .p = column[3] + at};
  }
  for (int c = 0; c < 4; c++) column[c][at] = arc_query_number(q, 3 + c);
  last->count++;
}

arc_status arc_store_surfaces(arc_store *store, int id, arc_surface **surfaces, size_t *count,
                              arc_error *error) {
  query *q = NULL;
  size_t rows = 0, at = 0;
  double *column[4];
  int row = 0;
  *count = 0;
  *surfaces = NULL;
  arc_status status = arc_store_verify(store, id, error);
  if (status == ARC_OK)
    status =
        count_rows(store, "SELECT count(*) FROM surfaces WHERE case_id = ?1", id, &rows, error);
  if (status != ARC_OK) return status;
  *surfaces = allocate_surfaces(rows, column);
  if (!*surfaces) return out_of_memory(store, error);
  status =
      arc_store_query(store,
                      "SELECT updates, distance_mm, body, x_mm, h_mm, y_mm, p_MPa FROM surfaces "
                      "WHERE case_id = ?1 ORDER BY updates, body, node",
                      id, &q, error);
  while (status == ARC_OK && at < rows && (status = arc_query_step(q, &row, error)) == ARC_OK &&
         row)
    read_node(q, at++, column, *surfaces, count);
  arc_query_close(&q);
  if (status == ARC_OK) return ARC_OK;
  free(*surfaces);
  *surfaces = NULL;
  *count = 0;
  return status;
}

/* --- going on --------------------------------------------------------------------------------- */

/* One body's state from a row: body, condensed, even, h, xy, settled; one block with its arrays. */
static arc_status read_state(arc_store *store, query *q, arc_surface_state *state, double **block,
                             arc_error *error) {
  size_t n = arc_query_array_count(q, 3);
  if (arc_query_array_count(q, 4) != 2 * n || arc_query_array_count(q, 5) != 2 * n)
    return arc_fail(error, ARC_FORMAT, "%s: the stored state of the %s is not complete",
                    store->path, arc_query_text(q, 0));
  free(*block);
  *block = malloc((5 * n + 1) * sizeof **block);
  if (!*block) return out_of_memory(store, error);
  arc_query_array(q, 3, *block, n);
  arc_query_array(q, 4, *block + n, 2 * n);
  arc_query_array(q, 5, *block + 3 * n, 2 * n);
  *state = (arc_surface_state){.count = (int)n,
                               .condensed = (int)arc_query_whole(q, 1),
                               .even = arc_query_number(q, 2),
                               .h = *block,
                               .xy = *block + n,
                               .settled = *block + 3 * n};
  return ARC_OK;
}

static arc_status read_states(arc_store *store, int id, arc_surface_state state[ARC_BODIES],
                              double *block[ARC_BODIES], arc_error *error) {
  query *q;
  int row = 0, found = 0;
  arc_status status = arc_store_query(
      store, "SELECT body, condensed, even, h, xy, settled FROM state WHERE case_id = ?1", id, &q,
      error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row) {
    arc_body body = body_named(arc_query_text(q, 0));
    status = read_state(store, q, &state[body], &block[body], error);
    found++;
  }
  arc_query_close(&q);
  if (status == ARC_OK && found != ARC_BODIES)
    status = arc_fail(error, ARC_FORMAT, "%s: expected the state of %d bodies, found %d",
                      store->path, ARC_BODIES, found);
  return status;
}

static arc_status restore_shape(arc_store *store, int id, arc_model *model, const arc_wear_def *def,
                                arc_shape **shape, arc_error *error) {
  arc_surface_state state[ARC_BODIES] = {0};
  double *block[ARC_BODIES] = {NULL, NULL};
  arc_status status = read_states(store, id, state, block, error);
  if (status == ARC_OK)
    status = arc_shape_restore(model, def->geometry, def->refresh, state, shape, error);
  for (int b = 0; b < ARC_BODIES; b++) free(block[b]);
  return status;
}

arc_status arc_store_restore(arc_store *store, int id, arc_model *model, const arc_wear_def *def,
                             arc_wear **wear, arc_error *error) {
  arc_shape *shape = NULL;
  arc_wear_record *history = NULL;
  size_t count = 0;
  *wear = NULL;
  arc_status status = arc_store_verify(store, id, error);
  if (status == ARC_OK) status = restore_shape(store, id, model, def, &shape, error);
  if (status == ARC_OK) status = arc_store_history(store, id, &history, &count, error);
  if (status == ARC_OK) status = arc_wear_restore(model, def, shape, history, count, wear, error);
  arc_shape_destroy(&shape);
  free(history);
  return status;
}

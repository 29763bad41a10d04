/* Runs in a run file: history, surfaces, and the state to go on from. Leans on stored_definition.c
 * for what the run was asked to do. What is read is checked before anything is made of it: the file
 * may be a stranger's. */
#include "store/store.h"

#include <limits.h>
#include <math.h>
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

/* Numbers of a row from a column on; where there is none NaN, and where there is something else 0
 * is returned. */
static int read_numbers(query *q, int column, double *to, int count) {
  for (int i = 0; i < count; i++) {
    const column_kind kind = arc_query_kind(q, column + i);
    if (kind != COLUMN_NONE && kind != COLUMN_WHOLE && kind != COLUMN_NUMBER) return 0;
    to[i] = arc_query_number(q, column + i);
  }
  return 1;
}

static arc_status read_record(arc_store *store, int id, query *q, arc_wear_record **history,
                              size_t *count, arc_error *error) {
  double number[COLUMNS];
  arc_wear_record *grown = arc_store_grown(*history, *count, sizeof *grown);
  if (!grown) return out_of_memory(store, error);
  *history = grown;
  if (arc_query_whole(q, 0) != (long long)*count || !read_numbers(q, 1, number, COLUMNS))
    return arc_store_damaged(store, error, id, "has no sound row %zu in its history", *count);
  int column = 0;
#define READ(name, unit, text) grown[*count].name = number[column++];
  ARC_WEAR_COLUMNS(READ)
#undef READ
  ++*count;
  return ARC_OK;
}

static arc_status check_history(arc_store *store, int id, const arc_wear_record *history,
                                size_t count, arc_error *error) {
  arc_error why = {0};
  if (arc_wear_check_history(history, count, &why) == ARC_OK) return ARC_OK;
  return arc_store_refused(store, error, id, &why);
}

arc_status arc_store_history(arc_store *store, int id, arc_wear_record **history, size_t *count,
                             arc_error *error) {
  query *q = NULL;
  int row = 0, own = 0;
  *history = NULL;
  *count = 0;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK) status = arc_store_verify_run(store, id, error);
  if (status == ARC_OK)
    status = arc_store_query(
        store, "SELECT step@columns FROM history WHERE case_id = ?1 ORDER BY step", id, &q, error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    status = read_record(store, id, q, history, count, error);
  arc_query_close(&q);
  arc_store_look_away(store, own);
  if (status == ARC_OK) status = check_history(store, id, *history, *count, error);
  if (status == ARC_OK) return ARC_OK;
  free(*history);
  *history = NULL;
  *count = 0;
  return status;
}

/* --- surfaces --------------------------------------------------------------------------------- */

enum { NODE = 4 }; /* numbers of a node: x, h, y, p */

/* Surfaces as they are read: their arrays are found once all nodes are there. */
typedef struct surface_list {
  arc_surface *surface;
  double (*node)[NODE];
  size_t surfaces, nodes;
} surface_list;

static int body_named(const char *name, arc_body *body) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (strcmp(name, arc_body_name((arc_body)b)) == 0) {
      *body = (arc_body)b;
      return 1;
    }
  return 0;
}

/* Whether a node may stand behind `before` (NULL: it is the first): along x they come in order. */
static int is_sound_node(const double node[NODE], const double *before) {
  for (int i = 0; i < NODE; i++)
    if (!isfinite(node[i])) return 0;
  return node[3] >= 0 && (!before || node[0] > before[0]);
}

static arc_surface *begin_surface(surface_list *list) {
  arc_surface *grown = arc_store_grown(list->surface, list->surfaces, sizeof *grown);
  if (!grown) return NULL;
  list->surface = grown;
  return &grown[list->surfaces++];
}

/* A row: updates, distance, body, node, and the numbers of the node, which goes to the last surface
 * or begins the next. */
static arc_status read_node(arc_store *store, int id, query *q, surface_list *list,
                            arc_error *error) {
  double at[2], number[NODE];
  arc_body body;
  if (!read_numbers(q, 0, at, 2) || !read_numbers(q, 4, number, NODE) || !isfinite(at[0]) ||
      !isfinite(at[1]) || !body_named(arc_query_text(q, 2), &body))
    return arc_store_damaged(store, error, id, "has a surface of '%s' that is none",
                             arc_query_text(q, 2));
  arc_surface *last = list->surfaces > 0 ? &list->surface[list->surfaces - 1] : NULL;
  if (!last || last->update != at[0] || last->body != body) {
    last = begin_surface(list);
    if (!last) return out_of_memory(store, error);
    *last = (arc_surface){.body = body, .update = at[0], .distance = at[1]};
  }
  double(*grown)[NODE] = arc_store_grown(list->node, list->nodes, sizeof *grown);
  if (!grown) return out_of_memory(store, error);
  list->node = grown;
  if (arc_query_whole(q, 3) != (long long)last->count ||
      !is_sound_node(number, last->count > 0 ? grown[list->nodes - 1] : NULL))
    return arc_store_damaged(store, error, id, "has no sound node %zu on its %s after update %g",
                             last->count, arc_body_name(body), at[0]);
  memcpy(grown[list->nodes++], number, sizeof number);
  last->count++;
  return ARC_OK;
}

/* One block: the surfaces, then the four columns of all their nodes. */
static arc_surface *pack(const surface_list *list) {
  const size_t bytes = list->surfaces * sizeof *list->surface;
  arc_surface *block = malloc(bytes + NODE * list->nodes * sizeof(double) + 1);
  if (!block) return NULL;
  double *column[NODE];
  for (size_t c = 0; c < NODE; c++) {
    column[c] = (double *)(void *)((char *)block + bytes) + c * list->nodes;
    for (size_t i = 0; i < list->nodes; i++) column[c][i] = list->node[i][c];
  }
  size_t first = 0;
  for (size_t s = 0; s < list->surfaces; s++) {
    block[s] = list->surface[s];
    block[s].x = column[0] + first;
    block[s].h = column[1] + first;
    block[s].y = column[2] + first;
    block[s].p = column[3] + first;
    first += block[s].count;
  }
  return block;
}

arc_status arc_store_surfaces(arc_store *store, int id, arc_surface **surfaces, size_t *count,
                              arc_error *error) {
  query *q = NULL;
  surface_list list = {0};
  int row = 0, own = 0;
  *count = 0;
  *surfaces = NULL;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK) status = arc_store_verify_run(store, id, error);
  if (status == ARC_OK)
    status = arc_store_query(store,
                             "SELECT updates, distance_mm, body, node, x_mm, h_mm, y_mm, p_MPa "
                             "FROM surfaces WHERE case_id = ?1 ORDER BY updates, body, node",
                             id, &q, error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    status = read_node(store, id, q, &list, error);
  arc_query_close(&q);
  arc_store_look_away(store, own);
  if (status == ARC_OK && !(*surfaces = pack(&list))) status = out_of_memory(store, error);
  if (status == ARC_OK) *count = list.surfaces;
  free(list.surface);
  free(list.node);
  return status;
}

/* --- going on --------------------------------------------------------------------------------- */

/* One body's state from a row: body, condensed, even, h, xy, settled; one block with its arrays. */
static arc_status read_state(arc_store *store, int id, query *q, arc_surface_state *state,
                             double **block, arc_error *error) {
  const size_t n = arc_query_array_count(q, 3);
  if (n > INT_MAX || arc_query_array_count(q, 4) != 2 * n || arc_query_array_count(q, 5) != 2 * n)
    return arc_store_damaged(store, error, id, "has no whole state of the %s",
                             arc_query_text(q, 0));
  *block = malloc((5 * n + 1) * sizeof **block);
  if (!*block) return out_of_memory(store, error);
  arc_query_array(q, 3, *block, n);
  arc_query_array(q, 4, *block + n, 2 * n);
  arc_query_array(q, 5, *block + 3 * n, 2 * n);
  *state = (arc_surface_state){.count = (int)n,
                               .condensed = arc_query_whole(q, 1) != 0,
                               .even = arc_query_number(q, 2),
                               .h = *block,
                               .xy = *block + n,
                               .settled = *block + 3 * n};
  return ARC_OK;
}

/* A row of the state goes to its body, which has but one. */
static arc_status place_state(arc_store *store, int id, query *q,
                              arc_surface_state state[ARC_BODIES], double *block[ARC_BODIES],
                              arc_error *error) {
  arc_body body;
  if (!body_named(arc_query_text(q, 0), &body) || block[body])
    return arc_store_damaged(store, error, id, "has the state of a body '%s' too many",
                             arc_query_text(q, 0));
  return read_state(store, id, q, &state[body], &block[body], error);
}

static arc_status read_states(arc_store *store, int id, arc_surface_state state[ARC_BODIES],
                              double *block[ARC_BODIES], arc_error *error) {
  query *q;
  int row = 0;
  arc_status status = arc_store_query(
      store, "SELECT body, condensed, even, h, xy, settled FROM state WHERE case_id = ?1", id, &q,
      error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    status = place_state(store, id, q, state, block, error);
  arc_query_close(&q);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    if (!block[b])
      status =
          arc_store_damaged(store, error, id, "has no state of the %s", arc_body_name((arc_body)b));
  return status;
}

/* A run as it is stored: what it went through, and where it stands; block has the arrays of state.
 */
typedef struct stored_run {
  arc_wear_record *history;
  size_t count;
  arc_surface_state state[ARC_BODIES];
  double *block[ARC_BODIES];
} stored_run;

static void free_stored(stored_run *run) {
  for (int b = 0; b < ARC_BODIES; b++) free(run->block[b]);
  free(run->history);
}

/* History and state of one moment: another program may be keeping the run on its way. */
static arc_status read_stored(arc_store *store, int id, stored_run *run, arc_error *error) {
  int own = 0;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK) status = arc_store_history(store, id, &run->history, &run->count, error);
  if (status == ARC_OK) status = read_states(store, id, run->state, run->block, error);
  arc_store_look_away(store, own);
  return status;
}

arc_status arc_store_restore(arc_store *store, int id, arc_model *model, const arc_wear_def *def,
                             arc_wear **wear, arc_error *error) {
  arc_shape *shape = NULL;
  stored_run run = {0};
  arc_error why = {0};
  *wear = NULL;
  arc_status status = read_stored(store, id, &run, error), made = ARC_OK;
  if (status == ARC_OK)
    made = arc_shape_restore(model, def->geometry, def->refresh, run.state, &shape, &why);
  if (status == ARC_OK && made == ARC_OK)
    made = arc_wear_restore(model, def, shape, run.history, run.count, wear, &why);
  if (made != ARC_OK) status = arc_store_refused(store, error, id, &why);
  arc_shape_destroy(&shape);
  free_stored(&run);
  return status;
}

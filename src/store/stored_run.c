/* Saves and reads the history, surfaces and state of runs in a run file. All data is checked
 * before use, because files are not trusted. */
#include "store/store.h"

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

/* Values of the column `part` in the table `arrays`: surfaces, or the state of a run. */
static const char surface[] = "surface", state[] = "state";

static arc_status save_arrays(arc_store *store, int id, const char *part, const arc_array *arrays,
                              size_t count, arc_error *error) {
  query *q;
  arc_status status = arc_store_query(store,
                                      "INSERT OR REPLACE INTO arrays (case_id, " ARC_ARRAYS
                                      ") VALUES (?1, ?2, ?3, ?4, "
                                      "?5, ?6, ?7, ?8, ?9)",
                                      id, &q, error);
  for (size_t i = 0; i < count && status == ARC_OK; i++) {
    arc_query_set_text(q, 2, part);
    arc_query_set_number(q, 3, arrays[i].update);
    arc_query_set_number(q, 4, arrays[i].distance);
    arc_query_set_text(q, 5, arc_body_name(arrays[i].body));
    arc_query_set_text(q, 6, arrays[i].name);
    arc_query_set_whole(q, 7, (long long)arrays[i].size[0]);
    arc_query_set_whole(q, 8, (long long)arrays[i].size[1]);
    arc_query_set_array(q, 9, arrays[i].values, arc_array_count(&arrays[i]));
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

static arc_status save_state(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  arc_array *arrays;
  size_t count;
  arc_status status = arc_wear_state(wear, &arrays, &count, error);
  if (status == ARC_OK) status = save_arrays(store, id, state, arrays, count, error);
  free(arrays);
  return status;
}

static arc_status forget(arc_store *store, int id, arc_error *error) {
  const arc_status status =
      arc_store_run(store, "DELETE FROM history WHERE case_id = ?1", id, error);
  if (status != ARC_OK) return status;
  return arc_store_run(store, "DELETE FROM arrays WHERE case_id = ?1", id, error);
}

/* Checks data before they are saved. The reader makes the same checks, so the saved file can be
 * opened later. */
static arc_status check_run(const arc_store *store, const arc_wear *wear, const arc_array *surfaces,
                            size_t count, arc_error *error) {
  size_t rows;
  const arc_wear_record *history = arc_wear_history(wear, &rows);
  arc_error why = {0};
  arc_status status = arc_wear_check_history(history, rows, &why);
  if (status == ARC_OK) status = arc_wear_check_surfaces(surfaces, count, &why);
  if (status == ARC_OK) return ARC_OK;
  return arc_fail(error, status, "%s: not stored: %s", store->path, why.message);
}

arc_status arc_store_save(arc_store *store, int id, const arc_wear *wear, const arc_array *surfaces,
                          size_t count, arc_error *error) {
  int own = 0;
  arc_status status = check_run(store, wear, surfaces, count, error);
  if (status != ARC_OK) return status;
  status = arc_store_enter(store, &own, error);
  if (status == ARC_OK) status = arc_store_open_seal(store, id, error);
  if (status == ARC_OK) status = forget(store, id, error);
  if (status == ARC_OK) status = arc_definition_save(store, id, wear, error);
  if (status == ARC_OK) status = save_history(store, id, wear, error);
  if (status == ARC_OK) status = save_arrays(store, id, surface, surfaces, count, error);
  if (status == ARC_OK) status = save_state(store, id, wear, error);
  return arc_store_leave(store, own, status, error);
}

/* --- history ---------------------------------------------------------------------------------- */

/* Reads `count` numbers of a row, beginning with column `column`. NULL becomes NaN. Returns 0 if
 * a value has another type. */
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
    return arc_store_damaged(store, error, id, "has no valid row %zu in its history", *count);
  int column = 0;
#define READ(name, unit, range, rule, text) grown[*count].name = number[column++];
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

/* --- arrays ----------------------------------------------------------------------------------- */

/* Arrays that were read. The values and the name of each array are in one block of memory. */
typedef struct array_list {
  arc_array *array;
  size_t count;
} array_list;

static void free_arrays(array_list *list) {
  for (size_t i = 0; i < list->count; i++) free((void *)(size_t)list->array[i].values);
  free(list->array);
}

static int body_named(const char *name, arc_body *body) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (strcmp(name, arc_body_name((arc_body)b)) == 0) {
      *body = (arc_body)b;
      return 1;
    }
  return 0;
}

/* Reads the two sizes of an array from adjacent columns. Returns 0 if their product is not the
 * length of the array in the next column. */
static int read_size(query *q, int column, size_t size[2]) {
  const long long rows = arc_query_whole(q, column), columns = arc_query_whole(q, column + 1);
  const size_t values = arc_query_array_count(q, column + 2);
  size[0] = (size_t)rows;
  size[1] = (size_t)columns;
  return rows >= 0 && columns >= 1 && arc_query_kind(q, column + 2) == COLUMN_ARRAY &&
         size[0] == values / size[1] && values % size[1] == 0;
}

/* Reads a row of the table `arrays` without its values. */
static int read_head(query *q, arc_array *array) {
  double at[2] = {0, 0};
  const int sound = read_numbers(q, 1, at, 2) && isfinite(at[0]) && isfinite(at[1]) &&
                    body_named(arc_query_text(q, 3), &array->body) && read_size(q, 5, array->size);
  array->update = at[0];
  array->distance = at[1];
  return sound;
}

static arc_status read_array(arc_store *store, int id, query *q, array_list *list,
                             arc_error *error) {
  arc_array *grown = arc_store_grown(list->array, list->count, sizeof *grown), array;
  if (!grown) return out_of_memory(store, error);
  list->array = grown;
  if (!read_head(q, &array))
    return arc_store_damaged(store, error, id, "has an invalid array '%s' of the %s",
                             arc_query_text(q, 4), arc_query_text(q, 3));
  const size_t bytes = arc_array_count(&array) * sizeof *array.values;
  double *block = malloc(bytes + strlen(arc_query_text(q, 4)) + 1);
  if (!block) return out_of_memory(store, error);
  arc_query_array(q, 7, block, arc_array_count(&array));
  array.values = block;
  array.name = strcpy((char *)block + bytes, arc_query_text(q, 4));
  grown[list->count++] = array;
  return ARC_OK;
}

/* Reads the arrays of a case with the value `part`, sorted by update, body and name. The arrays
 * are in one block of memory, which the caller frees. */
static arc_status read_arrays(arc_store *store, int id, const char *part, arc_array **arrays,
                              size_t *count, arc_error *error) {
  query *q;
  array_list list = {0};
  int row = 0;
  *arrays = NULL;
  *count = 0;
  arc_status status = arc_store_query(
      store,
      "SELECT " ARC_ARRAYS " FROM arrays WHERE case_id = ?1 AND part = ?2 ORDER BY updates, "
      "body, name",
      id, &q, error);
  if (status == ARC_OK) arc_query_set_text(q, 2, part);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    status = read_array(store, id, q, &list, error);
  arc_query_close(&q);
  if (status == ARC_OK && !(*arrays = arc_arrays_copy(list.array, list.count)))
    status = out_of_memory(store, error);
  if (status == ARC_OK) *count = list.count;
  free_arrays(&list);
  return status;
}

static arc_status check_surfaces(arc_store *store, int id, const arc_array *surfaces, size_t count,
                                 arc_error *error) {
  arc_error why = {0};
  if (arc_wear_check_surfaces(surfaces, count, &why) == ARC_OK) return ARC_OK;
  return arc_store_refused(store, error, id, &why);
}

arc_status arc_store_surfaces(arc_store *store, int id, arc_array **surfaces, size_t *count,
                              arc_error *error) {
  int own = 0;
  *surfaces = NULL;
  *count = 0;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK) status = arc_store_verify_run(store, id, error);
  if (status == ARC_OK) status = read_arrays(store, id, surface, surfaces, count, error);
  arc_store_look_away(store, own);
  if (status == ARC_OK) status = check_surfaces(store, id, *surfaces, *count, error);
  if (status == ARC_OK) return ARC_OK;
  free(*surfaces);
  *surfaces = NULL;
  *count = 0;
  return status;
}

/* --- continuing a stored run ------------------------------------------------------------------ */

/* History and state of a stored run. */
typedef struct stored_run {
  arc_wear_record *history;
  arc_array *state;
  size_t rows, arrays;
} stored_run;

/* Reads the history and the state in one transaction, because another program may store the run
 * at the same time. */
static arc_status read_stored(arc_store *store, int id, stored_run *run, arc_error *error) {
  int own = 0;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK) status = arc_store_history(store, id, &run->history, &run->rows, error);
  if (status == ARC_OK) status = read_arrays(store, id, state, &run->state, &run->arrays, error);
  arc_store_look_away(store, own);
  return status;
}

arc_status arc_store_restore(arc_store *store, int id, arc_model *model, const arc_wear_def *def,
                             arc_wear **wear, arc_error *error) {
  stored_run run = {0};
  arc_error why = {0};
  *wear = NULL;
  arc_status status = read_stored(store, id, &run, error);
  if (status == ARC_OK && arc_wear_resume(model, def, run.state, run.arrays, run.history, run.rows,
                                          wear, &why) != ARC_OK)
    status = arc_store_refused(store, error, id, &why);
  free(run.state);
  free(run.history);
  return status;
}

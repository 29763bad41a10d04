/* Reads and writes the list of cases in a run file, the status of each case and its named
 * values. */
#include "store/store.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STATUS_TEXT(name, text) text,
const char *const arc_case_status_names[] = {ARC_CASE_STATUS_LIST(STATUS_TEXT) NULL};

/* --- list of cases ---------------------------------------------------------------------------- */

/* Sets *found to 1 if a case with the number `id` exists, otherwise to 0. */
static arc_status find(arc_store *store, int id, int *found, arc_error *error) {
  query *q;
  arc_status status = arc_store_query(store, "SELECT 1 FROM cases WHERE id = ?1", id, &q, error);
  if (status == ARC_OK) status = arc_query_step(q, found, error);
  arc_query_close(&q);
  return status;
}

arc_status arc_store_add(arc_store *store, int id, const char *label, arc_error *error) {
  int found = 0;
  query *q = NULL;
  arc_status status = find(store, id, &found, error);
  if (status == ARC_OK && found)
    status = arc_fail(error, ARC_ARGUMENT, "%s: case %d already exists", store->path, id);
  if (status == ARC_OK)
    status = arc_store_query(
        store, "INSERT INTO cases (id, label, created) VALUES (?1, ?2, " ARC_STORE_NOW ")", id, &q,
        error);
  if (status == ARC_OK) {
    arc_query_set_text(q, 2, label);
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

static int status_named(const char *text) {
  for (int i = 0; arc_case_status_names[i]; i++)
    if (strcmp(arc_case_status_names[i], text) == 0) return i;
  return -1;
}

/* Reads one row with id, label, status, message and seconds. */
static arc_status read_case(arc_store *store, query *q, arc_case *one, arc_error *error) {
  const arc_status found = arc_store_id(store, q, &one->id, error);
  if (found != ARC_OK) return found;
  int status = status_named(arc_query_text(q, 2));
  if (status < 0)
    return arc_store_damaged(store, error, one->id, "has the unknown status '%s'",
                             arc_query_text(q, 2));
  one->status = (arc_case_status)status;
  arc_show_text(arc_query_text(q, 1), one->label, sizeof one->label);
  arc_show_text(arc_query_text(q, 3), one->message, sizeof one->message);
  one->seconds = arc_query_number(q, 4);
  return ARC_OK;
}

/* Appends the case in a row to the array and increments the size of the array. */
static arc_status add_case(arc_store *store, query *q, arc_case **cases, size_t *count,
                           arc_error *error) {
  arc_case *grown = arc_store_grown(*cases, *count, sizeof *grown);
  if (!grown) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  *cases = grown;
  const arc_status status = read_case(store, q, &(*cases)[*count], error);
  if (status == ARC_OK && *count > 0 && (*cases)[*count].id <= (*cases)[*count - 1].id)
    return arc_store_damaged(store, error, (*cases)[*count].id, "is listed twice");
  ++*count;
  return status;
}

arc_status arc_store_cases(arc_store *store, arc_case **cases, size_t *count, arc_error *error) {
  query *q = NULL;
  int row = 0;
  *cases = NULL;
  *count = 0;
  arc_status status = arc_query_open(
      store->db, "SELECT id, label, status, message, seconds FROM cases ORDER BY id", &q, error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    status = add_case(store, q, cases, count, error);
  arc_query_close(&q);
  if (status == ARC_OK) return ARC_OK;
  free(*cases);
  *cases = NULL;
  *count = 0;
  return status;
}

/* --- status of a case ------------------------------------------------------------------------- */

/* Checks that case `id` exists, after an update that changed no row. Errors: ARC_ARGUMENT if the
 * case does not exist. */
static arc_status find_done(arc_store *store, int id, arc_error *error) {
  int found = 0;
  const arc_status status = find(store, id, &found, error);
  if (status != ARC_OK || found) return status;
  return arc_fail(error, ARC_ARGUMENT, "%s: case %d does not exist", store->path, id);
}

static arc_status write_mark(arc_store *store, int id, arc_case_status mark, const char *message,
                             double seconds, arc_error *error) {
  query *q;
  arc_status status = arc_store_query(
      store,
      "UPDATE cases SET status = ?2, message = ?3, seconds = ?4, finished = CASE WHEN ?2 IN "
      "('done', 'failed') THEN " ARC_STORE_NOW " END WHERE id = ?1 AND (status <> 'done' OR ?2 IN "
      "('done', 'waiting'))",
      id, &q, error);
  if (status != ARC_OK) return status;
  arc_query_set_text(q, 2, arc_case_status_names[mark]);
  arc_query_set_text(q, 3, message);
  if (isfinite(seconds)) arc_query_set_number(q, 4, seconds);
  status = arc_query_run(q, error);
  arc_query_close(&q);
  if (status == ARC_OK && arc_database_changes(store->db) == 0) return find_done(store, id, error);
  return status;
}

arc_status arc_store_mark(arc_store *store, int id, arc_case_status mark, const char *message,
                          double seconds, arc_error *error) {
  int own = 0;
  arc_status status = arc_store_enter(store, &own, error);
  if (status == ARC_OK) status = arc_store_open_seal(store, id, error);
  if (status == ARC_OK) status = write_mark(store, id, mark, message, seconds, error);
  return arc_store_leave(store, own, status, error);
}

arc_status arc_store_release(arc_store *store, arc_error *error) {
  int own = 0;
  arc_status status = arc_store_enter(store, &own, error);
  if (status == ARC_OK)
    status = arc_store_open_seals(store, "SELECT id FROM cases WHERE status = 'running'", error);
  if (status == ARC_OK)
    status = arc_database_run(
        store->db, "UPDATE cases SET status = 'waiting', message = NULL WHERE status = 'running'",
        error);
  return arc_store_leave(store, own, status, error);
}

/* --- named values ----------------------------------------------------------------------------- */

/* SQL statements that delete the values of a case, indexed by arc_value_use. */
static const char *const forget[] = {"DELETE FROM settings WHERE case_id = ?1",
                                     "DELETE FROM definition WHERE case_id = ?1",
                                     "DELETE FROM results WHERE case_id = ?1"};
static const char *const insert[] = {
    "INSERT INTO settings (case_id, name, value) VALUES (?1, ?2, ?3)",
    "INSERT INTO definition (case_id, name, value) VALUES (?1, ?2, ?3)",
    "INSERT INTO results (case_id, name, value) VALUES (?1, ?2, ?3)"};
static const char *const look_up[] = {
    "SELECT name, value FROM settings WHERE case_id = ?1 ORDER BY name",
    "SELECT name, value FROM definition WHERE case_id = ?1 ORDER BY name",
    "SELECT name, value FROM results WHERE case_id = ?1 ORDER BY name"};

/* Sets a text as a parameter of a query. A long text is stored separately; the parameter is then
 * the name of the text. `name` must be valid until the query has run. */
static arc_status set_text(arc_store *store, query *q, const char *text, char name[ARC_TEXT_NAME],
                           arc_error *error) {
  const arc_status status = arc_store_put_text(store, text, name, error);
  arc_query_set_text(q, 3, name[0] ? name : text);
  return status;
}

static arc_status set_value(arc_store *store, query *q, const arc_value *value,
                            char name[ARC_TEXT_NAME], arc_error *error) {
  arc_query_set_text(q, 2, value->name);
  switch (value->kind) {
  case ARC_VALUE_NUMBER:
    arc_query_set_number(q, 3, value->number);
    break;
  case ARC_VALUE_FLAG: /* only flags are stored as integers */
    arc_query_set_whole(q, 3, value->number != 0);
    break;
  case ARC_VALUE_TEXT:
    return set_text(store, q, value->text, name, error);
  case ARC_VALUE_ARRAY:
    arc_query_set_array(q, 3, value->array, value->count);
    break;
  }
  return ARC_OK;
}

static arc_status insert_values(arc_store *store, int id, arc_value_use use,
                                const arc_value *values, size_t count, arc_error *error) {
  query *q;
  arc_status status = arc_store_query(store, insert[use], id, &q, error);
  for (size_t i = 0; i < count && status == ARC_OK; i++) {
    char name[ARC_TEXT_NAME];
    status = set_value(store, q, &values[i], name, error);
    if (status == ARC_OK) status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

arc_status arc_store_set_values(arc_store *store, int id, arc_value_use use,
                                const arc_value *values, size_t count, arc_error *error) {
  int own = 0;
  arc_status status = arc_store_enter(store, &own, error);
  if (status == ARC_OK) status = arc_store_open_seal(store, id, error);
  if (status == ARC_OK) status = arc_store_run(store, forget[use], id, error);
  if (status == ARC_OK) status = insert_values(store, id, use, values, count, error);
  return arc_store_leave(store, own, status, error);
}

/* Memory for the array or the text of a value that is read from a row. The caller frees both. */
typedef struct buffers {
  double *array;
  char *text;
} buffers;

static arc_status read_text(arc_store *store, query *q, arc_value *value, buffers *to,
                            arc_error *error) {
  value->kind = ARC_VALUE_TEXT;
  value->text = arc_query_text(q, 1);
  free(to->text);
  const arc_status status = arc_store_get_text(store, value->text, &to->text, error);
  if (to->text) value->text = to->text;
  return status;
}

static arc_status read_array(const arc_store *store, query *q, arc_value *value, buffers *to,
                             arc_error *error) {
  value->kind = ARC_VALUE_ARRAY;
  value->count = arc_query_array_count(q, 1);
  free(to->array);
  value->array = to->array = malloc((value->count + 1) * sizeof *to->array);
  if (!to->array) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  arc_query_array(q, 1, to->array, value->count);
  return ARC_OK;
}

/* Returns true if a name is a path such as "model.mesh.size": printable ASCII without empty
 * components. */
static int is_path(const char *name) {
  const size_t length = strlen(name);
  for (size_t i = 0; i < length; i++)
    if (name[i] < ' ' || name[i] > '~') return 0;
  return length > 0 && name[0] != '.' && name[length - 1] != '.' && !strstr(name, "..");
}

/* Reads the name and the value in a row. */
static arc_status read_value(arc_store *store, query *q, int id, arc_value *value, buffers *to,
                             arc_error *error) {
  if (arc_query_kind(q, 0) != COLUMN_TEXT || !is_path(arc_query_text(q, 0)))
    return arc_store_damaged(store, error, id, "has a value with the unknown name '%s'",
                             arc_query_text(q, 0));
  *value = (arc_value){.kind = ARC_VALUE_NUMBER, .name = arc_query_text(q, 0)};
  switch (arc_query_kind(q, 1)) {
  case COLUMN_WHOLE:
    value->kind = ARC_VALUE_FLAG;
    value->number = (double)arc_query_whole(q, 1);
    break;
  case COLUMN_TEXT:
    return read_text(store, q, value, to, error);
  case COLUMN_ARRAY:
    return read_array(store, q, value, to, error);
  case COLUMN_BYTES:
    return arc_fail(error, ARC_FORMAT, "%s: the file is damaged: '%s' is not a list of numbers",
                    store->path, value->name);
  case COLUMN_NONE:
  case COLUMN_NUMBER:
    value->number = arc_query_number(q, 1);
  }
  return ARC_OK;
}

arc_status arc_store_values(arc_store *store, int id, arc_value_use use, arc_value_fn see,
                            void *context, arc_error *error) {
  query *q = NULL;
  buffers held = {NULL, NULL};
  arc_value value;
  int row = 0, ended = 0, own = 0;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK)
    status = use == ARC_DEFINITION ? arc_store_verify_run(store, id, error)
                                   : arc_store_verify(store, id, error);
  if (status == ARC_OK) status = arc_store_query(store, look_up[use], id, &q, error);
  while (!ended && status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row) {
    status = read_value(store, q, id, &value, &held, error);
    if (status == ARC_OK) ended = see(context, &value);
  }
  arc_query_close(&q);
  arc_store_look_away(store, own);
  free(held.array);
  free(held.text);
  return status;
}

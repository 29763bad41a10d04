/* Computes and compares checksums (FNV-1a, 64 bit) of all data of finished cases. The checksum
 * is stored by the transaction that finishes the case, and compared by the functions that read
 * the case. SQLite detects damage to the structure of a file; the checksums detect damage to the
 * values. */
#include "store/store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const char *const parts[] = {
    "SELECT label, status, message, seconds FROM cases WHERE id = ?1",
    "SELECT name, value FROM settings WHERE case_id = ?1 ORDER BY name",
    "SELECT name, value FROM definition WHERE case_id = ?1 ORDER BY name",
    "SELECT name, value FROM results WHERE case_id = ?1 ORDER BY name",
    "SELECT * FROM history WHERE case_id = ?1 ORDER BY step",
    "SELECT * FROM arrays WHERE case_id = ?1 ORDER BY part, updates, body, name"};

/* Queries for surfaces and states in files of formats before 5. */
static const char *const older_parts[] = {
    "SELECT * FROM older_surfaces WHERE case_id = ?1 ORDER BY updates, body, node",
    "SELECT * FROM older_state WHERE case_id = ?1 ORDER BY body"};

uint64_t arc_store_checksum(uint64_t sum, const void *bytes, size_t count) {
  const unsigned char *at = bytes;
  for (size_t i = 0; i < count; i++) sum = (sum ^ at[i]) * 1099511628211u;
  return sum;
}

/* Adds a value and its type to a checksum. With the type, 1 and "1" have different checksums. */
static arc_status add_value(query *q, int column, uint64_t *sum) {
  const column_kind kind = arc_query_kind(q, column);
  const unsigned char tag = (unsigned char)kind;
  *sum = arc_store_checksum(*sum, &tag, 1);
  if (kind == COLUMN_WHOLE) {
    const long long whole = arc_query_whole(q, column);
    *sum = arc_store_checksum(*sum, &whole, sizeof whole);
  } else if (kind == COLUMN_NUMBER) {
    const double number = arc_query_number(q, column);
    *sum = arc_store_checksum(*sum, &number, sizeof number);
  } else if (kind == COLUMN_TEXT) {
    const char *text = arc_query_text(q, column);
    *sum = arc_store_checksum(*sum, text, strlen(text) + 1);
  } else if (kind == COLUMN_ARRAY) {
    const size_t count = arc_query_array_count(q, column);
    double *array = malloc((count + 1) * sizeof *array);
    if (!array) return ARC_MEMORY;
    arc_query_array(q, column, array, count);
    *sum = arc_store_checksum(*sum, array, count * sizeof *array);
    free(array);
  }
  return ARC_OK;
}

static arc_status add_part(arc_store *store, const char *sql, int id, uint64_t *sum,
                           arc_error *error) {
  query *q;
  int row = 0;
  arc_status status = arc_store_query(store, sql, id, &q, error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    for (int c = 0; c < arc_query_columns(q) && status == ARC_OK; c++)
      if ((status = add_value(q, c, sum)) != ARC_OK)
        arc_fail(error, status, "%s: out of memory", store->path);
  arc_query_close(&q);
  return status;
}

/* Computes the checksum of a case and writes it as text. */
static arc_status digest_of(arc_store *store, int id, char text[17], arc_error *error) {
  uint64_t sum = ARC_STORE_CHECKSUM;
  arc_status status = ARC_OK;
  for (size_t p = 0; p < COUNT(parts) && status == ARC_OK; p++)
    status = add_part(store, parts[p], id, &sum, error);
  for (size_t p = 0; store->older && p < COUNT(older_parts) && status == ARC_OK; p++)
    status = add_part(store, older_parts[p], id, &sum, error);
  snprintf(text, 17, "%016llx", (unsigned long long)sum);
  return status;
}

static arc_status seal(arc_store *store, int id, arc_error *error) {
  char text[17];
  query *q;
  arc_status status = digest_of(store, id, text, error);
  if (status != ARC_OK) return status;
  status = arc_store_query(store, "UPDATE cases SET checksum = ?2 WHERE id = ?1", id, &q, error);
  if (status == ARC_OK) {
    arc_query_set_text(q, 2, text);
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

/* Runs a query for the next case with an id greater than `after`. Sets *id to this id, or to 0
 * if there are no more cases. */
static arc_status first_case(arc_store *store, const char *sql, int after, int *id,
                             arc_error *error) {
  query *q;
  int row = 0;
  *id = 0;
  arc_status status = arc_store_query(store, sql, after, &q, error);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  if (status == ARC_OK && row) status = arc_store_id(store, q, id, error);
  arc_query_close(&q);
  return status;
}

/* --- cases that need a checksum --------------------------------------------------------------- */

/* SQL condition: true if the case must have a checksum. */
#define NEEDS_ONE                                                                                  \
  "(status = 'done' OR EXISTS (SELECT 1 FROM definition WHERE case_id = id) OR EXISTS (SELECT 1 "  \
  "FROM history WHERE case_id = id) OR EXISTS (SELECT 1 FROM arrays WHERE case_id = id))"

static int is_open(const arc_store *store, int id) {
  size_t i = 0;
  while (i < store->opened && store->open[i] != id) i++;
  return i < store->opened;
}

static arc_status note_open(arc_store *store, int id, arc_error *error) {
  if (store->opened > 0 && store->open[store->opened - 1] == id) return ARC_OK;
  int *grown = arc_store_grown(store->open, store->opened, sizeof *grown);
  if (!grown) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  store->open = grown;
  store->open[store->opened++] = id;
  return ARC_OK;
}

arc_status arc_store_open_seal(arc_store *store, int id, arc_error *error) {
  store->verified = 0;
  const arc_status status = note_open(store, id, error);
  if (status != ARC_OK) return status;
  return arc_store_run(store, "UPDATE cases SET checksum = NULL WHERE id = ?1", id, error);
}

arc_status arc_store_open_seals(arc_store *store, const char *ids, arc_error *error) {
  char sql[400];
  query *q;
  int row = 0, id = 0;
  store->verified = 0;
  arc_status status = arc_query_open(store->db, ids, &q, error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    if ((status = arc_store_id(store, q, &id, error)) == ARC_OK)
      status = note_open(store, id, error);
  arc_query_close(&q);
  if (status != ARC_OK) return status;
  snprintf(sql, sizeof sql, "UPDATE main.cases SET checksum = NULL WHERE id IN (%s)", ids);
  return arc_database_run(store->db, sql, error);
}

arc_status arc_store_seal_changed(arc_store *store, arc_error *error) {
  static const char unsealed[] =
      "SELECT id FROM cases WHERE id = ?1 AND checksum IS NULL AND " NEEDS_ONE;
  query *q;
  arc_status status = arc_query_open(store->db, unsealed, &q, error);
  for (size_t i = 0; i < store->opened && status == ARC_OK; i++) {
    int row;
    arc_query_set_whole(q, 1, store->open[i]);
    status = arc_query_step(q, &row, error);
    arc_query_reset(q);
    if (status == ARC_OK && row) status = seal(store, store->open[i], error);
  }
  arc_query_close(&q);
  return status;
}

/* --- comparing checksums ---------------------------------------------------------------------- */

/* Each of these queries returns two columns: the checksum of a case, and 1 if the case must have a
 * checksum, otherwise 0. The query of_run, for reading a run, also requires a checksum for data
 * without a case. */
static const char of_case[] = "SELECT checksum, status = 'done' FROM cases WHERE id = ?1";
static const char of_run[] =
    "SELECT checksum, " NEEDS_ONE " FROM cases WHERE id = ?1 UNION ALL SELECT NULL, 1 FROM "
    "(SELECT case_id FROM definition UNION ALL SELECT case_id FROM history UNION ALL SELECT "
    "case_id FROM arrays) WHERE case_id = ?1";

/* Reads the checksum of a case from the file. The text is "" if there is no checksum. */
static arc_status expected_digest(arc_store *store, const char *sql, int id, char text[17],
                                  int *needed, arc_error *error) {
  query *q;
  int row = 0;
  arc_status status = arc_store_query(store, sql, id, &q, error);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  snprintf(text, 17, "%s", status == ARC_OK && row ? arc_query_text(q, 0) : "");
  *needed = status == ARC_OK && row && arc_query_whole(q, 1) != 0;
  arc_query_close(&q);
  return status;
}

static arc_status compare(arc_store *store, const char *sql, int id, arc_error *error) {
  char found[17], expected[17];
  int needed;
  arc_status status = expected_digest(store, sql, id, expected, &needed, error);
  if (status == ARC_OK && needed && !expected[0])
    return arc_store_damaged(store, error, id, "has no checksum");
  if (status != ARC_OK || !expected[0]) return status;
  status = digest_of(store, id, found, error);
  if (status == ARC_OK && strcmp(found, expected) != 0)
    return arc_store_damaged(store, error, id, "does not match its checksum");
  if (status == ARC_OK) store->verified = id;
  return status;
}

/* Computes the checksum of a case and compares it with the stored checksum. Both are read in one
 * transaction, because another program may store the case at the same time. */
static arc_status verify(arc_store *store, const char *sql, int id, arc_error *error) {
  if (store->verified == id || is_open(store, id)) return ARC_OK;
  int own = 0;
  arc_status status = arc_store_look(store, &own, error);
  if (status == ARC_OK) status = compare(store, sql, id, error);
  arc_store_look_away(store, own);
  return status;
}

arc_status arc_store_verify(arc_store *store, int id, arc_error *error) {
  return verify(store, of_case, id, error);
}

arc_status arc_store_verify_run(arc_store *store, int id, arc_error *error) {
  return verify(store, of_run, id, error);
}

static const char sealed[] =
    "SELECT id FROM cases WHERE checksum IS NOT NULL AND id > ?1 ORDER BY id LIMIT 1";

arc_status arc_store_unseal_sound(arc_store *store, arc_error *error) {
  int id = 0;
  arc_status status = arc_store_script(
      store, "UPDATE cases SET checksum = 'missing' WHERE checksum IS NULL AND " NEEDS_ONE, error);
  while (status == ARC_OK && (status = first_case(store, sealed, id, &id, error)) == ARC_OK &&
         id > 0) {
    status = arc_store_verify(store, id, error);
    if (status == ARC_OK) status = arc_store_open_seal(store, id, error);
    if (status == ARC_FORMAT) status = ARC_OK;
  }
  return status;
}

arc_status arc_store_verify_all(arc_store *store, arc_error *error) {
  static const char to_verify[] =
      "SELECT id FROM cases WHERE (checksum IS NOT NULL OR " NEEDS_ONE ") AND id > ?1 "
      "ORDER BY id LIMIT 1";
  int id = 0;
  arc_status status;
  while ((status = first_case(store, to_verify, id, &id, error)) == ARC_OK && id > 0)
    if ((status = arc_store_verify_run(store, id, error)) != ARC_OK) return status;
  return status;
}

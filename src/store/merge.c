/* Merges run files, such as the parts of a study that were computed separately. */
#include "store/store.h"

#include <stdlib.h>
#include <sys/stat.h>

/* Runs a query that must not return rows. If it returns a row, reports an error with the case in
 * this row and the text `what`. */
static arc_status expect_none(arc_store *store, const char *sql, const char *from, const char *what,
                              arc_error *error) {
  query *q;
  int row = 0;
  char *text = arc_columns_sql(sql);
  if (!text) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  arc_status status = arc_query_open(store->db, text, &q, error);
  free(text);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  if (status == ARC_OK && row)
    status = arc_fail(error, ARC_ARGUMENT, "%s: case %lld %s (in %s)", from, arc_query_whole(q, 0),
                      what, store->path);
  arc_query_close(&q);
  return status;
}

#define VALUES  "case_id, name, value"
#define HISTORY "case_id, step@columns"
#define ARRAYS  "case_id, " ARC_ARRAYS

/* SQL query for the first case whose rows differ between the two files. The parameters of the
 * macros are: c, list of columns; t, table; w, condition; f and g, the two files. */
#define ROWS(f, t, c, w)    "SELECT " c " FROM " f "." t w
#define LESS(f, g, t, c, w) "SELECT * FROM (" ROWS(f, t, c, w) " EXCEPT " ROWS(g, t, c, w) ")"
#define DIFFERS(t, c, w)                                                                           \
  "SELECT case_id FROM (" LESS("main", "other", t, c, w) " UNION ALL " LESS(                       \
      "other", "main", t, c, w) ") ORDER BY case_id LIMIT 1"

static arc_status check_same_study(arc_store *store, const char *from, arc_error *error) {
  arc_status status = expect_none(
      store,
      "SELECT id FROM (SELECT id, label FROM main.cases EXCEPT SELECT id, label FROM other.cases "
      "UNION ALL SELECT id, label FROM (SELECT id, label FROM other.cases EXCEPT SELECT id, label "
      "FROM main.cases)) ORDER BY id LIMIT 1",
      from, "differs between the files, which are of different studies", error);
  if (status != ARC_OK) return status;
  return expect_none(store, DIFFERS("settings", VALUES, ""), from,
                     "has different settings in the files, which are of different studies", error);
}

#define IN_BOTH                                                                                    \
  " WHERE case_id IN (SELECT a.id FROM main.cases a JOIN other.cases b ON a.id = b.id"             \
  " WHERE a.status = 'done' AND b.status = 'done')"

/* Returns an error if both files contain results of the same finished case that differ. A case that
 * was computed twice has identical results, because runs are reproducible, and is accepted. */
static arc_status check_same_results(arc_store *store, const char *from, arc_error *error) {
  static const char *const parts[] = {DIFFERS("results", VALUES, IN_BOTH),
                                      DIFFERS("history", HISTORY, IN_BOTH),
                                      DIFFERS("arrays", ARRAYS, IN_BOTH)};
  arc_status status = ARC_OK;
  for (size_t i = 0; i < sizeof parts / sizeof *parts && status == ARC_OK; i++)
    status = expect_none(store, parts[i], from, "is finished in both, with other results", error);
  return status;
}

#define NEW                                                                                        \
  " WHERE case_id IN (SELECT id FROM other.cases WHERE status = 'done' AND id NOT IN "             \
  "(SELECT id FROM main.cases WHERE status = 'done'))"
#define COPY(table, columns)                                                                       \
  "DELETE FROM main." table NEW "; INSERT INTO main." table " (" columns ") SELECT " columns       \
  " FROM other." table NEW

/* Replaces the data of unfinished cases by the data of cases that are finished in the other file.
 * Copies the status of cases that are not waiting in the other file. The checksums are computed
 * again, because the other file may have its columns in another order. */
static arc_status copy_finished(arc_store *store, const char *from, arc_error *error) {
  static const char *const steps[] = {
      "INSERT OR IGNORE INTO main.texts (name, text) SELECT name, text FROM other.texts",
      COPY("definition", VALUES),
      COPY("results", VALUES),
      COPY("history", HISTORY),
      COPY("arrays", ARRAYS),
      "UPDATE main.cases SET (status, message, seconds, finished, checksum) ="
      "  (SELECT status, message, seconds, finished, NULL FROM other.cases o WHERE o.id = cases.id)"
      "  WHERE status <> 'done' AND id IN (SELECT id FROM other.cases WHERE status <> 'waiting')"};
  arc_status status = arc_store_open_seals(
      store,
      "SELECT c.id FROM main.cases c JOIN other.cases o ON o.id = c.id WHERE c.status <> 'done' "
      "AND o.status <> 'waiting'",
      error);
  for (size_t i = 0; i < sizeof steps / sizeof *steps && status == ARC_OK; i++)
    status = arc_store_script(store, steps[i], error);
  if (status != ARC_ARGUMENT) return status;
  return arc_fail(
      error, ARC_FORMAT,
      "%s: the file is damaged: a row of a case occurs twice, or a row belongs to no case", from);
}

static arc_status merge_attached(arc_store *store, const char *from, arc_error *error) {
  arc_status status = arc_store_begin(store, error);
  if (status != ARC_OK) return status;
  status = check_same_study(store, from, error);
  if (status == ARC_OK) status = check_same_results(store, from, error);
  if (status == ARC_OK) status = copy_finished(store, from, error);
  return arc_store_leave(store, 1, status, error);
}

/* Returns an error if `from` is the store's own file, or a link to it. SQLite would wait for the
 * store's own lock. */
static arc_status check_other(const arc_store *store, const char *from, arc_error *error) {
  struct stat own, other;
  if (stat(store->file, &own) != 0 || stat(from, &other) != 0) return ARC_OK;
  if (own.st_dev != other.st_dev || own.st_ino != other.st_ino) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "%s: is the study itself, expected another file", from);
}

/* Attaches the other file. The file is first opened as a store, so that the message is clear if
 * it is not a run file. */
static arc_status attach(arc_store *store, const char *from, arc_error *error) {
  arc_store *other = NULL;
  arc_status status = check_other(store, from, error);
  if (status == ARC_OK) status = arc_store_open(from, ARC_STORE_READ, &other, error);
  if (status == ARC_OK) status = arc_store_check(other, error);
  if (status == ARC_OK) status = arc_database_attach(store->db, other->db, error);
  arc_store_close(&other);
  return status;
}

arc_status arc_store_merge(arc_store *store, const char *from, arc_error *error) {
  arc_status status = attach(store, from, error);
  if (status != ARC_OK) return status;
  status = merge_attached(store, from, error);
  arc_status detached =
      arc_database_run(store->db, "DETACH other", status == ARC_OK ? error : NULL);
  return status == ARC_OK ? detached : status;
}

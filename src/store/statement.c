/* Runs SQL patterns, in which names of columns are inserted, for a whole store or for one of its
 * cases. */
#include "store/store.h"

#include <stdlib.h>

arc_status arc_store_query(arc_store *store, const char *sql, int id, query **q, arc_error *error) {
  *q = NULL;
  char *text = arc_columns_sql(sql);
  if (!text) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  arc_status status = arc_query_open(store->db, text, q, error);
  if (status == ARC_OK) arc_query_set_whole(*q, 1, id);
  free(text);
  return status;
}

arc_status arc_store_script(arc_store *store, const char *sql, arc_error *error) {
  char *text = arc_columns_sql(sql);
  if (!text) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  arc_status status = arc_database_run(store->db, text, error);
  free(text);
  return status;
}

arc_status arc_store_run(arc_store *store, const char *sql, int id, arc_error *error) {
  query *q;
  arc_status status = arc_store_query(store, sql, id, &q, error);
  if (status == ARC_OK) status = arc_query_run(q, error);
  arc_query_close(&q);
  return status;
}

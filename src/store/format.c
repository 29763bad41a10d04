/* Checks the format number of a file against the formats that this program supports. */
#include "store/store.h"

arc_status arc_schema_check(const char *path, long long format, arc_error *error) {
  if (format >= 1 && format <= ARC_STORE_FORMAT) return ARC_OK;
  return arc_fail(error, ARC_FORMAT,
                  "%s: format %lld is %s this program, which reads formats up "
                  "to %d",
                  path, format, format < 1 ? "unknown to" : "newer than", ARC_STORE_FORMAT);
}

arc_status arc_schema_format(arc_store *store, long long *format, arc_error *error) {
  query *q;
  int row;
  arc_status status = arc_query_open(store->db, "PRAGMA user_version", &q, error);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  if (status == ARC_OK) *format = arc_query_whole(q, 0);
  arc_query_close(&q);
  return status == ARC_OK ? arc_schema_check(store->path, *format, error) : status;
}

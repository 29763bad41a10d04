/* Begins and ends transactions. At the start of a transaction the format of the file is checked.
 * At the commit the checksums of finished cases are written. */
#include "store/store.h"

/* Begins a transaction. Checks the format, because a newer version may have converted the file
 * since it was opened. Also checks that the sandbox's limit of disk space is not exceeded. */
arc_status arc_store_begin(arc_store *store, arc_error *error) {
  long long format;
  arc_status status = arc_file_allowed(store->path, store->file, ARC_FILE_WRITE, error);
  if (status == ARC_OK) status = arc_database_run(store->db, "BEGIN IMMEDIATE", error);
  if (status != ARC_OK) return status;
  status = arc_schema_format(store, &format, error);
  if (status != ARC_OK) arc_store_rollback(store);
  return status;
}

arc_status arc_store_commit(arc_store *store, arc_error *error) {
  store->verified = 0;
  arc_status status = arc_store_seal_changed(store, error);
  if (status == ARC_OK) status = arc_database_run(store->db, "COMMIT", error);
  if (status != ARC_OK) arc_store_rollback(store);
  store->opened = 0;
  return status;
}

arc_status arc_store_enter(arc_store *store, int *own, arc_error *error) {
  *own = !arc_database_in_transaction(store->db);
  return *own ? arc_store_begin(store, error) : ARC_OK;
}

arc_status arc_store_leave(arc_store *store, int own, arc_status status, arc_error *error) {
  if (!own) return status;
  if (status == ARC_OK) return arc_store_commit(store, error);
  arc_store_rollback(store);
  return status;
}

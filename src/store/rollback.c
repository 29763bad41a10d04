/* Rolls back transactions, after a failure or after reading. */
#include "store/store.h"

/* Rolls back the transaction, unless SQLite has already rolled it back after a failure. The
 * statement is repeated because it may fail if memory is exhausted; a transaction that remains
 * open would lock the file. */
void arc_store_rollback(arc_store *store) {
  enum { most_tries = 10 };
  store->opened = 0;
  for (int i = 0; i < most_tries && arc_database_in_transaction(store->db); i++)
    arc_database_run(store->db, "ROLLBACK", NULL);
}

arc_status arc_store_look(arc_store *store, int *own, arc_error *error) {
  *own = !arc_database_in_transaction(store->db);
  const arc_status status = *own ? arc_database_run(store->db, "BEGIN", error) : ARC_OK;
  if (status != ARC_OK) *own = 0;
  return status;
}

void arc_store_look_away(arc_store *store, int own) {
  if (own) arc_store_rollback(store);
}

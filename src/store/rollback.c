/* Ends transactions without a commit: failed ones, and those of readers. */
#include "store/store.h"

/* SQLite has rolled back itself after some failures. Without memory the statement fails, and an
 * open transaction would lock the file: so it is repeated. */
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

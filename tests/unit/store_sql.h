/* Functions that read and change run files by SQL without the functions of archard. */
#ifndef TESTS_STORE_SQL_H
#define TESTS_STORE_SQL_H

#include "store_shared.h"

#include <sqlite3.h>

__attribute__((unused)) static void run_sql(const char *name, const char *sql) {
  sqlite3 *db;
  char *why = NULL;
  assert_int_equal(sqlite3_open(in_folder(name), &db), SQLITE_OK);
  if (sqlite3_exec(db, sql, NULL, NULL, &why) != SQLITE_OK) fail_msg("%s: %s", sql, why);
  sqlite3_close(db);
}

/* Updates the stored checksum of case 1 after a change by SQL. */
__attribute__((unused)) static void seal(const char *name) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_WRITE);
  must(arc_store_mark(store, 1, ARC_CASE_DONE, NULL, 1, &error), &error);
  arc_store_close(&store);
}

/* Reads all data of case 1, continues its run from the data and computes one step. */
__attribute__((unused)) static arc_status read_run(arc_store *store, arc_error *error) {
  arc_stored_run run;
  arc_model *model = NULL;
  arc_wear *wear = NULL;
  arc_status status = arc_store_definition(store, 1, &run, error);
  if (status != ARC_OK) return status;
  status = arc_stored_run_model(&run, NULL, &model, error);
  if (status == ARC_OK) status = arc_store_restore(store, 1, model, &run.def, &wear, error);
  if (status == ARC_OK) status = arc_wear_step(wear, NULL, error);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
  arc_stored_run_free(&run);
  return status;
}

__attribute__((unused)) static arc_status read_all(const char *name, arc_error *error) {
  arc_store *store;
  arc_array *surfaces = NULL;
  arc_case *cases = NULL;
  size_t count;
  arc_status status = arc_store_open(in_folder(name), ARC_STORE_READ, &store, error);
  if (status == ARC_OK) status = arc_store_cases(store, &cases, &count, error);
  if (status == ARC_OK) status = read_run(store, error);
  if (status == ARC_OK) status = arc_store_surfaces(store, 1, &surfaces, &count, error);
  free(cases);
  free(surfaces);
  arc_store_close(&store);
  return status;
}

__attribute__((unused)) static void assert_damaged(const char *name, const char *words) {
  arc_error error = {0};
  const arc_status status = read_all(name, &error);
  if (status != ARC_FORMAT) fail_msg("%s: status %d, %s", name, status, error.message);
  if (!strstr(error.message, "the file is damaged")) fail_msg("%s: %s", name, error.message);
  if (!strstr(error.message, words)) fail_msg("no '%s' in: %s", words, error.message);
}

#endif

/* Formats of the run file: what its columns are, and that files of older releases (tests/files)
 * become files of today, whole or not at all. tests/lua/formats.lua looks at what they hold. */
#include "store_sql.h"

/* A line for each column of each table and view, in the order of their names; to be freed. */
static char *structure_of(const char *path) {
  static const char sql[] =
      "SELECT group_concat(line, char(10)) || char(10) FROM (SELECT m.name || '.' || c.name || "
      "iif(m.type = 'view', '', iif(c.type = '', '', ' ') || c.type || iif(c.\"notnull\", "
      "' NOT NULL', '') || iif(c.pk, ' key ' || c.pk, '')) AS line "
      "FROM sqlite_schema m, pragma_table_xinfo(m.name) c WHERE m.type = 'table' "
      "ORDER BY line)";
  sqlite3 *db;
  sqlite3_stmt *statement;
  assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
  assert_int_equal(sqlite3_prepare_v2(db, sql, -1, &statement, NULL), SQLITE_OK);
  assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
  char *text = strdup((const char *)sqlite3_column_text(statement, 0));
  sqlite3_finalize(statement);
  sqlite3_close(db);
  assert_non_null(text);
  return text;
}

static void make_new(const char *name) {
  arc_store *store = opened(name, ARC_STORE_CREATE);
  arc_store_close(&store);
}

/* Copies tests/files/format-N.KIND into the test's folder. */
static void copy_old(int format, const char *kind, const char *name) {
  char path[100];
  snprintf(path, sizeof path, "tests/files/format-%d.%s", format, kind);
  copy_file(path, name);
}

static const char *const kinds[] = {"wear", "study", "share"};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* --- what the columns are --------------------------------------------------------------------- */

/* The columns follow from ARC_WEAR_COLUMNS and src/store/schema.c; files of one format must have
 * the same ones for ever. */
static void test_structure(void **state) {
  (void)state;
  char path[100], found[300];
  size_t count = 0;
  make_new("structure");
  char *structure = structure_of(in_folder("structure"));
  snprintf(path, sizeof path, "tests/files/format-%d.schema", ARC_STORE_FORMAT);
  unsigned char *expected = access(path, F_OK) == 0 ? bytes_of(path, &count) : NULL;
  int same = expected && count == strlen(structure) && memcmp(expected, structure, count) == 0;
  const char *build = getenv("BUILD");
  snprintf(found, sizeof found, "%s/format-%d.schema", build ? build : "build", ARC_STORE_FORMAT);
  if (!same) {
    write_bytes(found, structure, strlen(structure));
    fail_msg(
        "the columns of a run file (%s) are not those of format %d (%s). If format %d has been "
        "released: write files with that release's program (tests/files/write.lua), raise "
        "ARC_STORE_FORMAT in include/archard/store.h and add a line to the migrations in "
        "src/store/schema.c. Then keep the new columns: cp %s tests/files/",
        found, ARC_STORE_FORMAT, path, ARC_STORE_FORMAT, found);
  }
  free(structure);
  free(expected);
}

static void test_older_files_get_it(void **state) {
  (void)state;
  make_new("new");
  char *expected = structure_of(in_folder("new"));
  for (int format = 1; format < ARC_STORE_FORMAT; format++)
    for (int k = 0; k < KINDS; k++) {
      arc_error error = {0};
      copy_old(format, kinds[k], "old");
      arc_store *store = opened("old", ARC_STORE_WRITE);
      must(arc_store_check(store, &error), &error);
      arc_store_close(&store);
      char *structure = structure_of(in_folder("old"));
      assert_string_equal(structure, expected);
      free(structure);
    }
  free(expected);
}

/* --- opening old files ------------------------------------------------------------------------ */

static void test_reader_changes_nothing(void **state) {
  (void)state;
  arc_error error = {0};
  size_t before_count, after_count;
  copy_old(1, "study", "read");
  unsigned char *before = bytes_of(in_folder("read"), &before_count);
  arc_store *store = opened("read", ARC_STORE_READ);
  must(arc_store_check(store, &error), &error);
  assert_int_equal(arc_store_add(store, 9, "new", &error), ARC_IO);
  assert_non_null(strstr(error.message, "permission"));
  arc_store_close(&store);
  unsigned char *after = bytes_of(in_folder("read"), &after_count);
  assert_int_equal(after_count, before_count);
  assert_memory_equal(after, before, before_count);
  free(before);
  free(after);
}

/* What is wrong in an old file stays wrong, in its case alone. */
static void test_damage_stays(void **state) {
  (void)state;
  arc_error error = {0};
  copy_old(1, "study", "damaged");
  run_sql("damaged", "UPDATE history SET p_center = p_center * 2 WHERE case_id = 2 AND step = 1");
  for (int mode = ARC_STORE_READ; mode <= ARC_STORE_WRITE; mode++) {
    arc_store *store = opened("damaged", (arc_store_mode)mode);
    arc_wear_record *history;
    size_t count;
    must(arc_store_history(store, 1, &history, &count, &error), &error);
    assert_int_equal(count, 5);
    free(history);
    assert_int_equal(arc_store_history(store, 2, &history, &count, &error), ARC_FORMAT);
    assert_non_null(strstr(error.message, "case 2"));
    arc_store_close(&store);
  }
}

/* The last but one of the changes fails: none of them is there. */
static void test_whole_or_not_at_all(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store;
  copy_old(1, "wear", "odd");
  run_sql("odd", "ALTER TABLE surfaces RENAME COLUMN p TO pressure");
  char *before = structure_of(in_folder("odd"));
  assert_int_equal(arc_store_open(in_folder("odd"), ARC_STORE_WRITE, &store, &error), ARC_FORMAT);
  assert_null(store);
  char *after = structure_of(in_folder("odd"));
  assert_string_equal(before, after);
  free(before);
  free(after);
}

static void test_many_open_at_once(void **state) {
  (void)state;
  enum { PROGRAMS = 4 };
  pid_t child[PROGRAMS];
  copy_old(1, "study", "at once");
  for (int i = 0; i < PROGRAMS; i++) {
    child[i] = fork();
    if (child[i] == 0) {
      arc_error error = {0};
      arc_store *store;
      arc_status status =
          arc_store_open(in_folder("at once"), (arc_store_mode)(i % 2), &store, &error);
      if (status == ARC_OK) status = arc_store_check(store, &error);
      arc_store_close(&store);
      _exit(status == ARC_OK ? 0 : 1);
    }
  }
  for (int i = 0; i < PROGRAMS; i++) {
    int ended;
    waitpid(child[i], &ended, 0);
    assert_true(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  }
}

/* Refused when opened (test_store_trouble.c), and when it becomes newer under a writer. */
static void test_newer_meanwhile(void **state) {
  (void)state;
  arc_error error = {0};
  char known[40], today[60];
  make_new("meanwhile");
  arc_store *store = opened("meanwhile", ARC_STORE_WRITE);
  run_sql("meanwhile", "PRAGMA user_version = 99");
  assert_int_equal(arc_store_begin(store, &error), ARC_FORMAT);
  assert_non_null(strstr(error.message, "format 99 is newer"));
  snprintf(known, sizeof known, "knows up to %d", ARC_STORE_FORMAT);
  assert_non_null(strstr(error.message, known));
  snprintf(today, sizeof today, "PRAGMA user_version = %d", ARC_STORE_FORMAT);
  run_sql("meanwhile", today);
  must(arc_store_begin(store, &error), &error);
  must(arc_store_commit(store, &error), &error);
  arc_store_close(&store);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_structure),
                                     cmocka_unit_test(test_older_files_get_it),
                                     cmocka_unit_test(test_reader_changes_nothing),
                                     cmocka_unit_test(test_damage_stays),
                                     cmocka_unit_test(test_whole_or_not_at_all),
                                     cmocka_unit_test(test_many_open_at_once),
                                     cmocka_unit_test(test_newer_meanwhile)};
  arc_single_threaded();
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}

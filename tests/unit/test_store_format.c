/* Tests of the formats of the run file: structure of the tables, and files of older releases
 * (tests/files), which are converted completely or not at all. tests/lua/formats.lua checks the
 * contents of converted files. */
#include "store_sql.h"

/* Returns a text with a line for each column of each table and view, sorted by name; the caller
 * frees it. */
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

/* Copies tests/files/format-N.KIND to the test's folder. */
static void copy_old(int format, const char *kind, const char *name) {
  char path[100];
  snprintf(path, sizeof path, "tests/files/format-%d.%s", format, kind);
  copy_file(path, name);
}

static const char *const kinds[] = {"wear", "study", "share"};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* --- structure -------------------------------------------------------------------------------- */

/* Tests the columns of each table, which follow from ARC_WEAR_COLUMNS and src/store/schema.c:
 * all files of one format must have the same columns. */
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
        "the columns of a run file (%s) are not those of format %d (%s). Raise ARC_STORE_FORMAT in "
        "include/archard/store.h and add a line to the migrations in src/store/schema.c. Then keep "
        "the new columns, cp %s tests/files/, and files of the new format: build/archard "
        "tests/files/write.lua tests/files/format-N.",
        found, ARC_STORE_FORMAT, path, found);
  }
  free(structure);
  free(expected);
}

/* There are files of the present format, too, so that no column can be added to a format that is in
 * use. */
static void test_all_files_have_it(void **state) {
  (void)state;
  make_new("new");
  char *expected = structure_of(in_folder("new"));
  for (int format = 1; format <= ARC_STORE_FORMAT; format++)
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

/* Tests that damage to one case of an old file affects no other case. */
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

/* Tests that no conversion is applied if the last but one conversion fails. */
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

/* Tests a file that another program converts to a newer format while it is open for writing: the
 * write is refused. test_store_trouble.c tests files that have a newer format when they are
 * opened. */
static void test_newer_meanwhile(void **state) {
  (void)state;
  arc_error error = {0};
  char known[40], today[60];
  make_new("meanwhile");
  arc_store *store = opened("meanwhile", ARC_STORE_WRITE);
  run_sql("meanwhile", "PRAGMA user_version = 99");
  assert_int_equal(arc_store_begin(store, &error), ARC_FORMAT);
  assert_non_null(strstr(error.message, "format 99 is newer"));
  snprintf(known, sizeof known, "reads formats up to %d", ARC_STORE_FORMAT);
  assert_non_null(strstr(error.message, known));
  snprintf(today, sizeof today, "PRAGMA user_version = %d", ARC_STORE_FORMAT);
  run_sql("meanwhile", today);
  must(arc_store_begin(store, &error), &error);
  must(arc_store_commit(store, &error), &error);
  arc_store_close(&store);
}

/* --- surfaces read by SQL --------------------------------------------------------------------- */

enum { MOST_NUMBERS = 20000 };

/* Reads all numbers of the surfaces in the order of the rows; returns the number of values read. */
static int numbers_of(const char *name, double *number) {
  sqlite3 *db;
  sqlite3_stmt *s;
  int count = 0;
  assert_int_equal(sqlite3_open(in_folder(name), &db), SQLITE_OK);
  assert_int_equal(sqlite3_prepare_v2(db,
                                      "SELECT case_id, updates, distance_mm, body = 'plate', node, "
                                      "x_mm, h_mm, y_mm, p_MPa FROM surfaces ORDER BY case_id, "
                                      "updates, body, node",
                                      -1, &s, NULL),
                   SQLITE_OK);
  while (sqlite3_step(s) == SQLITE_ROW)
    for (int c = 0; c < sqlite3_column_count(s); c++) {
      assert_true(count < MOST_NUMBERS);
      number[count++] = sqlite3_column_double(s, c);
    }
  sqlite3_finalize(s);
  sqlite3_close(db);
  return count;
}

/* Tests that the view of the new format shows the same surfaces as the table that it replaced. */
static void test_surfaces_stay(void **state) {
  (void)state;
  static double table[MOST_NUMBERS], view[MOST_NUMBERS];
  copy_old(4, "study", "shown");
  const int count = numbers_of("shown", table);
  assert_true(count > 1000);
  arc_store *store = opened("shown", ARC_STORE_WRITE);
  arc_store_close(&store);
  assert_int_equal(numbers_of("shown", view), count);
  assert_memory_equal(view, table, (size_t)count * sizeof *view);
}

/* Returns a finite normal number of any magnitude from a reproducible random sequence. */
static double any_number(uint64_t *seed) {
  double number;
  do {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    const uint64_t bits = *seed ^ *seed >> 29;
    memcpy(&number, &bits, sizeof number);
  } while (!isnormal(number));
  return number;
}

/* Tests that the view shows numbers of all magnitudes with all bits. */
static void test_any_number_is_shown(void **state) {
  (void)state;
  enum { NODES = 2000, PLACES = 9, AT_H = 6, AT_Y = 7 };
  static double x[NODES], h[NODES], y[NODES], zero[NODES], shown[MOST_NUMBERS];
  static const double special[] = {
      0,      -0.0, 1, -1, 0.1, 2.2250738585072014e-308, 1.7976931348623157e308, 4503599627370497,
      1.0 / 3};
  enum { SPECIALS = sizeof special / sizeof *special };
  arc_error error = {0};
  arc_model *model = coarse_model();
  arc_wear *wear = short_run(model, 44);
  uint64_t seed = 1;
  for (int i = 0; i < NODES; i++) {
    x[i] = i;
    h[i] = i < SPECIALS ? special[i] : any_number(&seed);
    y[i] = any_number(&seed);
  }
  const arc_array arrays[] = {{"x", ARC_PLATE, 2, 44, {NODES, 1}, x},
                              {"h", ARC_PLATE, 2, 44, {NODES, 1}, h},
                              {"y", ARC_PLATE, 2, 44, {NODES, 1}, y},
                              {"p", ARC_PLATE, 2, 44, {NODES, 1}, zero}};
  arc_store *store = opened("any number", ARC_STORE_CREATE);
  must(arc_store_add(store, 1, "run", &error), &error);
  must(arc_store_save(store, 1, wear, arrays, 4, &error), &error);
  arc_store_close(&store);
  assert_int_equal(numbers_of("any number", shown), PLACES * NODES);
  for (int i = 0; i < NODES; i++) {
    assert_memory_equal(&shown[PLACES * i + AT_H], &h[i], sizeof *h);
    assert_memory_equal(&shown[PLACES * i + AT_Y], &y[i], sizeof *y);
  }
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_structure),
                                     cmocka_unit_test(test_all_files_have_it),
                                     cmocka_unit_test(test_reader_changes_nothing),
                                     cmocka_unit_test(test_damage_stays),
                                     cmocka_unit_test(test_whole_or_not_at_all),
                                     cmocka_unit_test(test_many_open_at_once),
                                     cmocka_unit_test(test_newer_meanwhile),
                                     cmocka_unit_test(test_surfaces_stay),
                                     cmocka_unit_test(test_any_number_is_shown)};
  arc_single_threaded();
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}

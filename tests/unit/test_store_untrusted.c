/* Tests of untrusted run files with arbitrary content and valid checksums: invalid content is
 * refused with a message before any object is created. The tests also run with sanitizers. */
#include "store_sql.h"

/* --- a good file and changed copies ----------------------------------------------------------- */

static const double distances[3] = {0, 50, 400}, k_at[3] = {2e-8, 1e-8, 1.5e-8};
static const double to_and_fro[5] = {-0.05, 0, 0.05, 0, -0.05}, loads[5] = {80, 100, 90, 100, 80};
static const arc_loading blocks[1] = {
    {.count = 5, .x = to_and_fro, .load = loads, .cycles = 1000, .periodic = 1}};

/* Creates the file "good" with a run that has a table of k and a loading. */
static int make_good(void **state) {
  arc_error error = {0};
  arc_wear *wear;
  if (make_folder(state) != 0) return -1;
  arc_model *model = coarse_model();
  arc_wear_def def = arc_wear_default();
  def.distance = 40;
  def.jump = 50;
  def.k_series = (arc_series){3, distances, k_at};
  def.blocks = 1;
  def.loading = blocks;
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  must(arc_wear_run(wear, 40, NULL, &error), &error);
  save_as("good", 1, wear);
  seal("good");
  arc_wear_destroy(&wear);
  arc_model_release(&model);
  return 0;
}

/* Copies the good file, changes the copy by SQL and updates the checksums. */
static void spoil(const char *name, const char *sql) {
  copy_good(name);
  run_sql(name, sql);
  seal(name);
}

/* Copies the good file to `name`, sets element `at` of the plate's state array `name_of` to `value`
 * and updates the checksums. */
static void set_number(const char *name, const char *name_of, int at, double value) {
  sqlite3 *db;
  sqlite3_stmt *s;
  char sql[200];
  double array[1000];
  copy_good(name);
  assert_int_equal(sqlite3_open(in_folder(name), &db), SQLITE_OK);
  snprintf(sql, sizeof sql,
           "SELECT numbers FROM arrays WHERE part = 'state' AND body = 'plate' AND name = '%s'",
           name_of);
  assert_int_equal(sqlite3_prepare_v2(db, sql, -1, &s, NULL), SQLITE_OK);
  assert_int_equal(sqlite3_step(s), SQLITE_ROW);
  const int bytes = sqlite3_column_bytes(s, 0);
  assert_true(bytes <= (int)sizeof array);
  memcpy(array, sqlite3_column_blob(s, 0), (size_t)bytes);
  sqlite3_finalize(s);
  array[at] = value;
  snprintf(sql, sizeof sql,
           "UPDATE arrays SET numbers = ?1 WHERE part = 'state' AND body = 'plate' AND name = '%s'",
           name_of);
  assert_int_equal(sqlite3_prepare_v2(db, sql, -1, &s, NULL), SQLITE_OK);
  sqlite3_bind_blob(s, 1, array, bytes, SQLITE_STATIC);
  assert_int_equal(sqlite3_step(s), SQLITE_DONE);
  sqlite3_finalize(s);
  sqlite3_close(db);
  seal(name);
}

/* --- opening ---------------------------------------------------------------------------------- */

static void test_good(void **state) {
  (void)state;
  arc_error error = {0};
  must(read_all("good", &error), &error);
}

/* --- definitions ------------------------------------------------------------------------------ */

#define LOOSE                                                                                      \
  "PRAGMA foreign_keys = OFF; DROP VIEW case_results; CREATE TABLE d AS SELECT * FROM "            \
  "definition; DROP TABLE definition; "                                                            \
  "ALTER TABLE d RENAME TO definition; "

static void test_functions_in_great_number(void **state) {
  (void)state;
  spoil("functions",
        LOOSE "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 2000) "
              "INSERT INTO definition SELECT 1, 'local_factor_function', 1 FROM n");
  assert_damaged("functions", "local_factor_function");
}

static void test_values_twice(void **state) {
  (void)state;
  spoil("twice", LOOSE "INSERT INTO definition SELECT * FROM definition WHERE name = 'load'");
  assert_damaged("twice", "load");
}

/* Tests that a shard with duplicate values cannot be merged with a study and that the error message
 * is not a message of SQLite. */
static void test_share_with_values_twice(void **state) {
  (void)state;
  arc_error error = {0};
  arc_case *cases;
  size_t count;
  copy_good("whole");
  arc_store *store = opened("whole", ARC_STORE_WRITE);
  must(arc_store_mark(store, 1, ARC_CASE_WAITING, NULL, 1, &error), &error);
  spoil("share", LOOSE "INSERT INTO definition SELECT * FROM definition WHERE name = 'load'");
  assert_int_equal(arc_store_merge(store, in_folder("share"), &error), ARC_FORMAT);
  assert_non_null(
      strstr(error.message, "share: the file is damaged: a row of a case occurs twice"));
  assert_null(strstr(error.message, "constraint"));
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(cases[0].status, ARC_CASE_WAITING);
  free(cases);
  must(read_run(store, &error), &error);
  arc_store_close(&store);
}

#define VALUE(name, value) "UPDATE definition SET value = " value " WHERE name = '" name "'"

static void test_arrays(void **state) {
  (void)state;
  spoil("empty", VALUE("k_series.value", "x''"));
  assert_damaged("empty", "k_series.value");
  spoil("short", VALUE("k_series.value", "substr(value, 1, 16)"));
  assert_damaged("short", "k_series.value");
  spoil("one", "DELETE FROM definition WHERE name = 'k_series.value'");
  assert_damaged("one", "k_series.value");
  spoil("odd", VALUE("k_series.value", "substr(value, 1, 23)"));
  assert_damaged("odd", "k_series.value");
  spoil("falling", VALUE("k_series.distance", "(SELECT value FROM definition WHERE "
                                              "name = 'k_series.value')"));
  assert_damaged("falling", "k.distance");
}

static int see_none(void *context, const arc_value *value) {
  (void)context;
  (void)value;
  return 0;
}

static void test_names(void **state) {
  (void)state;
  static const char *const names[] = {"''", "x'00616c706861'", "x'6c6f6164'", "'a..b'",
                                      "'k' || char(27)"};
  for (int i = 0; i < 5; i++)
    for (int use = ARC_SETTINGS; use <= ARC_RESULTS; use++) {
      static const char *const tables[] = {"settings", "definition", "results"};
      char sql[200];
      arc_error error = {0};
      snprintf(sql, sizeof sql, "INSERT INTO %s SELECT 1, %s, 1.0", tables[use], names[i]);
      spoil("names", sql);
      arc_store *store = opened("names", ARC_STORE_READ);
      assert_int_equal(arc_store_values(store, 1, (arc_value_use)use, see_none, NULL, &error),
                       ARC_FORMAT);
      if (!strstr(error.message, "the file is damaged: case 1 has a value with the unknown name"))
        fail_msg("%s in %s: %s", names[i], tables[use], error.message);
      arc_store_close(&store);
    }
}

static void test_loading(void **state) {
  (void)state;
  spoil("block", VALUE("loading.1.load", "substr(value, 1, 24)"));
  assert_damaged("block", "loading.1.x");
  spoil("long", VALUE("loading.1.x", "zeroblob(80000)"));
  assert_damaged("long", "loading.1.x");
  spoil("zero", "INSERT INTO definition SELECT 1, 'loading.01.x', zeroblob(80000)");
  assert_damaged("zero", "loading.01.x");
  spoil("renamed", "UPDATE definition SET name = 'loading.01.x' WHERE name = 'loading.1.x'");
  assert_damaged("renamed", "loading.01.x");
  spoil("pull", "INSERT INTO definition SELECT 1, 'loading.1.tangential', zeroblob(8)");
  assert_damaged("pull", "loading.1.");
  spoil("many", VALUE("blocks", "1e9"));
  assert_damaged("many", "blocks");
  spoil("last", "INSERT INTO definition SELECT 1, 'loading.999999.x', zeroblob(8)");
  assert_damaged("last", "loading.999999.x");
}

static void test_ranges(void **state) {
  (void)state;
  spoil("negative", VALUE("load", "-1.0"));
  assert_damaged("negative", "load");
  spoil("infinite", VALUE("distance", "9e999"));
  assert_damaged("infinite", "distance");
  spoil("none", VALUE("jump", "NULL"));
  assert_damaged("none", "jump");
  spoil("text", VALUE("load", "'100'"));
  assert_damaged("text", "load");
  spoil("half", VALUE("increments", "20.5"));
  assert_damaged("half", "increments");
  spoil("choice", VALUE("scheme", "'magic'"));
  assert_damaged("choice", "scheme");
  spoil("radius", VALUE("model.radius", "-10.0"));
  assert_damaged("radius", "radius");
  spoil("start", VALUE("start_distance", "9e999"));
  assert_damaged("start", "start_distance");
}

/* --- states ----------------------------------------------------------------------------------- */

static void test_states(void **state) {
  (void)state;
  static const struct {
    const char *column;
    int at;
    double value;
  } wrong[] = {{"settled", 20, 5}, {"settled", 20, -1e300}, {"settled", 21, NAN},
               {"xy", 20, 5},      {"xy", 21, INFINITY},    {"xy", 21, -1e300},
               {"xy", 0, NAN},     {"h", 10, -1},           {"h", 10, NAN},
               {"h", 10, 1e300},   {"h", 0, INFINITY},      {"settled", 0, 1e300}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    set_number("state", wrong[i].column, wrong[i].at, wrong[i].value);
    assert_damaged("state", "plate");
  }
  set_number("even", "even", 0, 1e300);
  assert_damaged("even", "case 1");
  set_number("uneven", "even", 0, -1);
  assert_damaged("uneven", "case 1");
  spoil("few", "UPDATE arrays SET numbers = substr(numbers, 1, 80 * columns), rows = 10 WHERE "
               "name IN ('h', 'xy', 'settled') AND part = 'state'");
  assert_damaged("few", "numbers 'h', got 10");
  spoil("long", "UPDATE arrays SET rows = 10 WHERE name = 'h' AND part = 'state'");
  assert_damaged("long", "array 'h'");
  spoil("wide", "UPDATE arrays SET rows = 2 * rows, columns = 1 WHERE part = 'state'");
  assert_damaged("wide", "case 1");
  spoil("flat", "UPDATE arrays SET columns = 0 WHERE part = 'state'");
  assert_damaged("flat", "array");
  spoil("empty", "UPDATE arrays SET rows = 0, numbers = x'' WHERE part = 'state'");
  assert_damaged("empty", "case 1");
  spoil("back", "UPDATE arrays SET rows = -1, columns = -1 WHERE part = 'state'");
  assert_damaged("back", "array");
  spoil("bytes", "UPDATE arrays SET numbers = x'000102' WHERE part = 'state'");
  assert_damaged("bytes", "array");
  spoil("body", "UPDATE arrays SET body = 'ball' WHERE body = 'plate' AND part = 'state'");
  assert_damaged("body", "ball");
  spoil("alone", "DELETE FROM arrays WHERE body = 'plate' AND part = 'state'");
  assert_damaged("alone", "state");
  spoil("more", "INSERT INTO arrays SELECT case_id, part, updates, distance_mm, body, 'odd', rows, "
                "columns, numbers FROM arrays WHERE part = 'state' AND name = 'h'");
  assert_damaged("more", "expected a state of 10 arrays");
}

/* --- histories and surfaces ------------------------------------------------------------------- */

static void test_histories(void **state) {
  (void)state;
  static const char *const wrong[] = {
      "p_max_MPa = NULL WHERE step = 2", "p_max_MPa = -1 WHERE step = 1",  "p_max_MPa = 9e999",
      "volume_plate_mm3 = 1e300",        "distance_mm = 0 WHERE step = 2", "updates = NULL",
      "cycle = 5000 WHERE step = 0",     "step = 7 WHERE step = 1",        "p_max_MPa = 'much'",
      "depth_plate_mm = x'00'"};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    char sql[100];
    snprintf(sql, sizeof sql, "UPDATE history SET %s", wrong[i]);
    spoil("history", sql);
    assert_damaged("history", "case 1");
  }
  spoil("nothing", "DELETE FROM history");
  assert_damaged("nothing", "history");
}

static void test_surfaces(void **state) {
  (void)state;
  static const char *const wrong[] = {
      "numbers = zeroblob(8 * rows) WHERE name = 'x'", /* all x equal */
      "numbers = CAST(substr(numbers, 1, 16) || x'000000000000f07f' || substr(numbers, 25) AS "
      "BLOB) "
      "WHERE name = 'h'", /* an infinite number */
      "numbers = CAST(substr(numbers, 1, 16) || x'000000000000f8ff' || substr(numbers, 25) AS "
      "BLOB) "
      "WHERE name = 'y'", /* not a number */
      "numbers = CAST(substr(numbers, 1, 16) || x'000000000000f0bf' || substr(numbers, 25) AS "
      "BLOB) "
      "WHERE name = 'p'", /* the number -1 */
      "numbers = substr(numbers, 1, 80), rows = 10 WHERE name = 'y'",
      "name = 'z' WHERE name = 'y'",
      "distance_mm = NULL",
      "distance_mm = 1 WHERE name = 'p'",
      "updates = 9e999",
      "rows = rows / 2, columns = 2",
      "body = 'ball'"};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    char sql[200];
    snprintf(sql, sizeof sql, "UPDATE OR IGNORE arrays SET %s", wrong[i]);
    spoil("surfaces", sql);
    assert_damaged("surfaces", "case 1");
  }
}

/* --- cases and checksums ---------------------------------------------------------------------- */

static void test_checksums_are_required(void **state) {
  (void)state;
  arc_error error = {0};
  copy_good("unsealed");
  run_sql("unsealed", "UPDATE cases SET checksum = NULL");
  assert_damaged("unsealed", "case 1 has no checksum");
  copy_good("waiting");
  run_sql("waiting", "UPDATE cases SET checksum = NULL, status = 'waiting'");
  assert_damaged("waiting", "case 1 has no checksum");
  copy_good("orphan");
  run_sql("orphan", "PRAGMA foreign_keys = OFF; DELETE FROM cases");
  assert_damaged("orphan", "case 1");

  /* writing to the file does not add a checksum */
  arc_store *store = opened("unsealed", ARC_STORE_WRITE);
  must(arc_store_add(store, 2, "another", &error), &error);
  must(arc_store_mark(store, 2, ARC_CASE_DONE, NULL, 1, &error), &error);
  assert_int_equal(arc_store_check(store, &error), ARC_FORMAT);
  arc_store_close(&store);
  assert_damaged("unsealed", "case 1 has no checksum");
}

static void test_old_files_need_checksums(void **state) {
  (void)state;
  size_t count;
  unsigned char *bytes = bytes_of("tests/files/format-3.wear", &count);
  for (int mode = ARC_STORE_READ; mode <= ARC_STORE_WRITE; mode++) {
    write_bytes(in_folder("old"), bytes, count);
    run_sql("old", "UPDATE cases SET checksum = NULL");
    arc_store *store = opened("old", (arc_store_mode)mode);
    arc_store_close(&store);
    assert_damaged("old", "case 1");
  }
  free(bytes);
}

static void test_cases(void **state) {
  (void)state;
  spoil("far",
        "PRAGMA foreign_keys = OFF; INSERT INTO cases (id, label) VALUES (99999999999, 'x')");
  assert_damaged("far", "99999999999");
  spoil("below", "INSERT INTO cases (id, label) VALUES (-3, 'x')");
  assert_damaged("below", "-3");
  spoil("status", "INSERT INTO cases (id, label, status) VALUES (2, 'x', 'odd')");
  assert_damaged("status", "odd");
}

/* --- views, triggers and page trees in untrusted files ---------------------------------------- */

static void test_structure(void **state) {
  (void)state;
  copy_good("view");
  run_sql("view",
          "ALTER TABLE history RENAME TO other; CREATE VIEW history AS SELECT * FROM other");
  assert_damaged("view", "history");
  copy_good("endless");
  run_sql("endless",
          "DROP VIEW surfaces; DROP TABLE arrays; CREATE VIEW arrays (case_id, part, updates, "
          "distance_mm, body, name, rows, columns, numbers) AS WITH RECURSIVE n(i) AS (SELECT 1 "
          "UNION ALL SELECT i + 1 FROM n) SELECT 1, 'state', 1, 1, 'plate', i, 1, 1, x'' FROM n");
  assert_damaged("endless", "");
  copy_good("column");
  run_sql("column", "ALTER TABLE history RENAME COLUMN p_max_MPa TO p");
  assert_damaged("column", "p_max_MPa");
  copy_good("table");
  run_sql("table", "PRAGMA foreign_keys = OFF; DROP VIEW surfaces; DROP TABLE arrays");
  assert_damaged("table", "arrays");
}

/* Tests that a trigger in the file has no effect. */
static void test_triggers(void **state) {
  (void)state;
  arc_error error = {0};
  arc_case *cases;
  size_t count;
  copy_good("trigger");
  run_sql("trigger", "CREATE TRIGGER t AFTER INSERT ON cases BEGIN DELETE FROM cases; END");
  arc_store *store = opened("trigger", ARC_STORE_WRITE);
  must(arc_store_add(store, 2, "new", &error), &error);
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 2);
  free(cases);
  arc_store_close(&store);
}

/* Writes an inner page of 300 rows, all with the same child page. */
static void make_inner(unsigned char *page, unsigned child) {
  enum { ROWS = 300, FIRST = 4096 - 8 * ROWS };
  const unsigned char header[8] = {5, 0, 0, ROWS >> 8, ROWS & 255, FIRST >> 8, FIRST & 255, 0};
  memset(page, 0, 4096);
  memcpy(page, header, sizeof header);
  for (unsigned row = 0; row <= ROWS; row++) {
    const unsigned at = 4096 - 8 * (row + 1);
    unsigned char *link = row < ROWS ? page + at : page + 8;
    link[2] = (unsigned char)(child >> 8);
    link[3] = (unsigned char)child;
    if (row == ROWS) continue;
    link[4] = 1; /* a row number, which the reader ignores */
    page[12 + 2 * row] = (unsigned char)(at >> 8);
    page[13 + 2 * row] = (unsigned char)at;
  }
}

/* Tests a tree that refers to the same page many times, so reading all rows would take too long:
 * the file is refused. */
static void test_tangled_tree(void **state) {
  (void)state;
  copy_good("tangled");
  run_sql("tangled",
          "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 60000) "
          "INSERT INTO cases (id, label) SELECT i + 1, 'a label that fills pages' FROM n");
  size_t count;
  unsigned char *bytes = bytes_of(in_folder("tangled"), &count);
  int inner = 0;
  for (size_t at = 4096; at + 4096 <= count; at += 4096) {
    unsigned char *page = bytes + at;
    if (page[0] != 13 || at < count / 2) continue; /* selects leaf pages of the table of cases */
    if (inner++ < 8) make_inner(page, (unsigned)(at / 4096 + 2));
  }
  assert_true(inner > 20);
  write_bytes(in_folder("tangled"), bytes, count);
  free(bytes);
  assert_damaged("tangled", "");
}

/* --- files that are no run files -------------------------------------------------------------- */

static void test_devices(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store;
  assert_int_equal(mkfifo(in_folder("fifo"), 0600), 0);
  const char *const paths[] = {in_folder("fifo"), "/dev/zero", "/dev/null", folder};
  for (int i = 0; i < 4; i++)
    for (int mode = ARC_STORE_READ; mode <= ARC_STORE_CREATE; mode++) {
      assert_int_not_equal(arc_store_open(paths[i], (arc_store_mode)mode, &store, &error), ARC_OK);
      assert_non_null(strstr(error.message, "not a file"));
    }
}

/* Tests that text from a file is shown without the control characters that terminals interpret. */
static void test_escape_codes(void **state) {
  (void)state;
  arc_error error = {0};
  arc_case *cases;
  size_t count;
  spoil("codes", "UPDATE cases SET label = 'a' || char(27) || ']0;b' || char(7), "
                 "message = 'c' || char(155) || 'd' || char(13)");
  arc_store *store = opened("codes", ARC_STORE_READ);
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_string_equal(cases[0].label, "a\\x1b]0;b\\x07");
  assert_null(strpbrk(cases[0].message, "\x1b\r"));
  assert_null(strstr(cases[0].message, "\xc2\x9b"));
  free(cases);
  arc_store_close(&store);
  spoil("name", "INSERT INTO definition SELECT 1, 'a' || char(27) || '[2J', 1");
  assert_damaged("name", "a\\x1b[2J");
}

int main(void) {
  arc_single_threaded();
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_good),
      cmocka_unit_test(test_functions_in_great_number),
      cmocka_unit_test(test_values_twice),
      cmocka_unit_test(test_share_with_values_twice),
      cmocka_unit_test(test_arrays),
      cmocka_unit_test(test_names),
      cmocka_unit_test(test_loading),
      cmocka_unit_test(test_ranges),
      cmocka_unit_test(test_states),
      cmocka_unit_test(test_histories),
      cmocka_unit_test(test_surfaces),
      cmocka_unit_test(test_checksums_are_required),
      cmocka_unit_test(test_old_files_need_checksums),
      cmocka_unit_test(test_cases),
      cmocka_unit_test(test_structure),
      cmocka_unit_test(test_triggers),
      cmocka_unit_test(test_tangled_tree),
      cmocka_unit_test(test_devices),
      cmocka_unit_test(test_escape_codes),
  };
  return cmocka_run_group_tests(tests, make_good, remove_folder);
}

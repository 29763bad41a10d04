/* Fuzz target for untrusted run files: arbitrary bytes, a valid file with changed bytes, or a
 * file whose tables were changed by SQL and have valid checksums. The target reads each file
 * like `wear.open`; if the file opens, the run computes one step. */
#include "fuzz.h"

#include <sqlite3.h>

#include "store/store.h"

/* --- creation of the valid file --------------------------------------------------------------- */

static void must(arc_status status, const arc_error *error) {
  if (status != ARC_OK) FOUND("%s", error->message);
}

static void make_sound(const char *path) {
  arc_error error = {0};
  arc_model_def of_model = arc_model_default();
  of_model.mesh.size = 0.08;
  of_model.mesh.height = 0.06;
  arc_wear_def def = arc_wear_default();
  static const double at[] = {0, 40, 90}, k[] = {1e-8, 2e-8, 1e-8};
  def.distance = 88, def.increments = 10, def.jump = 100;
  def.k_series = (arc_series){.distance = at, .value = k, .count = 3};
  arc_model *model;
  arc_wear *wear;
  arc_store *store;
  arc_array *present;
  size_t arrays;
  must(arc_model_build(&of_model, &model, &error), &error);
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  must(arc_wear_run(wear, 66, NULL, &error), &error);
  must(arc_store_open(path, ARC_STORE_CREATE, &store, &error), &error);
  must(arc_store_add(store, 1, "sound", &error), &error);
  must(arc_wear_surfaces(wear, &present, &arrays, &error), &error);
  must(arc_store_save(store, 1, wear, present, arrays, &error), &error);
  must(arc_store_mark(store, 1, ARC_CASE_DONE, NULL, 1, &error), &error);
  free(present);
  arc_store_close(&store);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

static const uint8_t *sound(size_t *count) {
  static uint8_t *bytes;
  static size_t size;
  if (!bytes) {
    const char *path = own_file(".sound");
    unlink(path);
    make_sound(path);
    struct stat facts;
    FILE *file = fopen(path, "rb");
    if (!file || stat(path, &facts) != 0) abort();
    size = (size_t)facts.st_size;
    bytes = malloc(size);
    if (!bytes || fread(bytes, 1, size, file) != size) abort();
    fclose(file);
    unlink(path);
  }
  *count = size;
  return bytes;
}

/* --- changes ---------------------------------------------------------------------------------- */

static const char *with_bytes_changed(source *s) {
  size_t size;
  const uint8_t *from = sound(&size);
  uint8_t *bytes = malloc(size);
  if (!bytes) abort();
  memcpy(bytes, from, size);
  while (s->left > 4) {
    uint32_t at;
    take_bytes(s, &at, sizeof at);
    bytes[at % size] ^= (uint8_t)(1 + take_byte(s) % 255);
  }
  const char *path = as_file(bytes, size, ".archard");
  free(bytes);
  return path;
}

/* Binds a value of a random type to a parameter of the statement. */
static void bind_any(sqlite3_stmt *q, int index, source *s) {
  uint8_t text[40];
  const unsigned length = take_byte(s) % sizeof text;
  switch (take_byte(s) % 6) {
  case 0:
    sqlite3_bind_null(q, index);
    break;
  case 1:
    sqlite3_bind_int64(q, index, (sqlite3_int64)(int8_t)take_byte(s));
    break;
  case 2:
    sqlite3_bind_double(q, index, take_any(s));
    break;
  case 3:
    sqlite3_bind_double(q, index, take_in(s, -1000, 1000));
    break;
  default:
    take_bytes(s, text, length);
    if (length % 2)
      sqlite3_bind_text(q, index, (char *)text, (int)length, SQLITE_TRANSIENT);
    else
      sqlite3_bind_blob(q, index, text, (int)(length / 8 * 8), SQLITE_TRANSIENT);
  }
}

static const char *const changes[] = {
    "UPDATE definition SET value = ?1 WHERE name = (SELECT name FROM definition LIMIT 1 OFFSET ?2)",
    "UPDATE definition SET name = ?1 WHERE name = (SELECT name FROM definition LIMIT 1 OFFSET ?2)",
    "DELETE FROM definition WHERE name = (SELECT name FROM definition LIMIT 1 OFFSET ?2)",
    "INSERT OR REPLACE INTO definition VALUES (1, ?1, ?2)",
    "UPDATE arrays SET numbers = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET rows = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET columns = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET name = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET part = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET updates = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET distance_mm = ?1 WHERE rowid = ?2",
    "UPDATE arrays SET body = ?1 WHERE rowid = ?2",
    "DELETE FROM arrays WHERE rowid = ?2",
    "UPDATE OR REPLACE arrays SET name = iif(name = 'xy', 'settled', 'xy') WHERE columns = 2",
    "UPDATE history SET step = ?1 WHERE step = ?2",
    "UPDATE history SET updates = ?1 WHERE step = ?2",
    "UPDATE history SET distance_mm = ?1 WHERE step = ?2",
    "UPDATE history SET p_center_MPa = ?1 WHERE step = ?2",
    "DELETE FROM history WHERE step = ?2",
    "UPDATE cases SET status = ?1",
    "UPDATE cases SET label = ?1",
    "UPDATE cases SET id = ?1",
    "UPDATE info SET value = ?1",
    "INSERT OR REPLACE INTO settings VALUES (1, ?1, ?2)",
    "INSERT OR REPLACE INTO results VALUES (1, ?1, ?2)",
    /* changes one number of an array */
    "UPDATE arrays SET numbers = CAST(substr(numbers, 1, 8 * (?2 % 30)) || substr(CAST(?1 AS BLOB) "
    "|| x'0000000000000000', 1, 8) || substr(numbers, 8 * (?2 % 30) + 9) AS BLOB) WHERE part = "
    "'state' AND name = 'h'",
    "UPDATE arrays SET numbers = CAST(substr(numbers, 1, 8 * (?2 % 99)) || substr(CAST(?1 AS BLOB) "
    "|| x'0000000000000000', 1, 8) || substr(numbers, 8 * (?2 % 99) + 9) AS BLOB) WHERE name = "
    "'settled'",
    "UPDATE arrays SET numbers = CAST(substr(numbers, 1, 8 * (?2 % 30)) || substr(CAST(?1 AS BLOB) "
    "|| x'0000000000000000', 1, 8) || substr(numbers, 8 * (?2 % 30) + 9) AS BLOB) WHERE part = "
    "'surface'",
    "UPDATE definition SET value = substr(value, 1, 8) WHERE name LIKE 'k.%' AND ?2 % 2",
};

static void change(sqlite3 *db, source *s) {
  sqlite3_stmt *q = NULL;
  const char *sql = changes[take_byte(s) % (sizeof changes / sizeof *changes)];
  if (sqlite3_prepare_v2(db, sql, -1, &q, NULL) != SQLITE_OK)
    FOUND("%s: %s", sql, sqlite3_errmsg(db));
  bind_any(q, 1, s);
  if (strstr(sql, "(1, ?1, ?2)"))
    bind_any(q, 2, s);
  else
    sqlite3_bind_int(q, 2, (int)(take_byte(s) % 64));
  sqlite3_step(q); /* a change that violates a constraint of the tables is not applied */
  sqlite3_finalize(q);
}

static const char *with_tables_changed(source *s) {
  size_t size;
  const uint8_t *bytes = sound(&size);
  const char *path = as_file(bytes, size, ".archard");
  sqlite3 *db;
  if (sqlite3_open(path, &db) != SQLITE_OK) abort();
  sqlite3_exec(db, "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY; BEGIN", NULL, NULL,
               NULL);
  for (int i = 0; i < 8 && s->left > 0; i++) change(db, s);
  sqlite3_exec(db, "COMMIT", NULL, NULL, NULL);
  sqlite3_close(db);
  arc_store *store = NULL;
  int status = arc_store_open(path, ARC_STORE_WRITE, &store, NULL);
  if (status == ARC_OK && arc_store_begin(store, NULL) == ARC_OK) {
    arc_store_open_seal(store, 1, NULL);
    arc_store_commit(store, NULL);
  }
  arc_store_close(&store);
  return path;
}

/* --- reading ---------------------------------------------------------------------------------- */

static int see(void *context, const arc_value *value) {
  *(size_t *)context += strlen(value->name) + value->count;
  return 0;
}

/* Builds the model of the valid file once and returns it for later runs with the same
 * definition. */
static arc_status model_of(arc_stored_run *run, arc_model **model) {
  static arc_model *kept;
  static arc_model_def of_kept;
  const arc_model_def *def = &run->model;
  if (run->given[ARC_UPPER]) return arc_stored_run_model(run, NULL, model, NULL);
  if (kept && memcmp(def, &of_kept, sizeof *def) == 0) {
    *model = arc_model_retain(kept);
    return ARC_OK;
  }
  const arc_status status = arc_model_build(def, model, NULL);
  if (status == ARC_OK && !kept) kept = arc_model_retain(*model), of_kept = *def;
  return status;
}

static void go_on(arc_store *store, int id, arc_stored_run *run) {
  arc_error error = {0};
  arc_model *model = NULL;
  arc_wear *wear = NULL;
  const double size = run->model.mesh.size;
  if (size > 0 && (size < 0.05 || run->model.radius > 1000 * size))
    return; /* a run with millions of elements is too slow for fuzzing */
  if (model_of(run, &model) == ARC_OK &&
      arc_store_restore(store, id, model, &run->def, &wear, &error) == ARC_OK)
    arc_wear_step(wear, NULL, &error);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

static void read_case(arc_store *store, int id) {
  size_t seen = 0, count;
  for (int use = 0; use <= ARC_RESULTS; use++)
    arc_store_values(store, id, (arc_value_use)use, see, &seen, NULL);
  arc_wear_record *history = NULL;
  arc_array *surfaces = NULL;
  arc_stored_run run;
  if (arc_store_history(store, id, &history, &count, NULL) == ARC_OK) free(history);
  if (arc_store_surfaces(store, id, &surfaces, &count, NULL) == ARC_OK) free(surfaces);
  if (arc_store_definition(store, id, &run, NULL) != ARC_OK) return;
  go_on(store, id, &run);
  arc_stored_run_free(&run);
}

static void read_all(const char *path) {
  arc_error error = {0};
  arc_store *store = NULL;
  arc_case *cases = NULL;
  size_t count = 0;
  arc_status status = arc_store_open(path, ARC_STORE_READ, &store, &error);
  if (status == ARC_OK) status = arc_store_check(store, &error);
  if (status == ARC_OK) status = arc_store_cases(store, &cases, &count, &error);
  if (status != ARC_OK && !error.message[0]) FOUND("an error without a message");
  for (size_t i = 0; i < count && i < 3; i++) read_case(store, cases[i].id);
  free(cases);
  arc_store_close(&store);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  source s = {data, size};
  const unsigned how = take_byte(&s) % 3;
  if (how == 0)
    read_all(as_file(s.data, s.left, ".archard"));
  else
    read_all(how == 1 ? with_bytes_changed(&s) : with_tables_changed(&s));
  return 0;
}

/* The run file: what goes in comes out to the same bits; what is not ours is refused and left as it
 * is; a full disk, a killed writer and two writers at once. */
#include "archard/store.h"

#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/archard-store-XXXXXX";

/* The path of a file in the test's folder; the next call but three overwrites it. */
static const char *in_folder(const char *name) {
  static char path[4][200];
  static int turn;
  turn = (turn + 1) % 4;
  snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
  return path[turn];
}

static int make_folder(void **state) {
  (void)state;
  return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state) {
  (void)state;
  char command[300];
  snprintf(command, sizeof command, "rm -rf %s", folder);
  return system(command);
}

static arc_store *opened(const char *name, arc_store_mode mode) {
  arc_error error = {0};
  arc_store *store;
  if (arc_store_open(in_folder(name), mode, &store, &error) != ARC_OK)
    fail_msg("%s", error.message);
  return store;
}

static void must(arc_status status, const arc_error *error) {
  if (status != ARC_OK) fail_msg("%s", error->message);
}

/* All bytes of a file; to be freed. */
static unsigned char *bytes_of(const char *path, size_t *count) {
  FILE *file = fopen(path, "rb");
  assert_non_null(file);
  fseek(file, 0, SEEK_END);
  *count = (size_t)ftell(file);
  rewind(file);
  unsigned char *bytes = malloc(*count + 1);
  assert_non_null(bytes);
  assert_int_equal(fread(bytes, 1, *count, file), *count);
  fclose(file);
  return bytes;
}

static void write_bytes(const char *path, const void *bytes, size_t count) {
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, count, file), count);
  assert_int_equal(fclose(file), 0);
}

/* --- cases and values ------------------------------------------------------------------------- */

static void test_cases(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store = opened("cases", ARC_STORE_CREATE);
  must(arc_store_add(store, 2, "second", &error), &error);
  must(arc_store_add(store, 1, "first", &error), &error);
  assert_int_equal(arc_store_add(store, 1, "again", &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "case 1"));
  must(arc_store_mark(store, 2, ARC_CASE_FAILED, "it's broken", 1.5, &error), &error);
  must(arc_store_mark(store, 1, ARC_CASE_RUNNING, NULL, (double)NAN, &error), &error);
  assert_int_equal(arc_store_mark(store, 3, ARC_CASE_DONE, NULL, 0, &error), ARC_ARGUMENT);
  arc_store_close(&store);

  store = opened("cases", ARC_STORE_WRITE);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 2);
  assert_int_equal(cases[0].id, 1);
  assert_int_equal(cases[0].status, ARC_CASE_RUNNING);
  assert_true(isnan(cases[0].seconds));
  assert_string_equal(cases[1].label, "second");
  assert_string_equal(cases[1].message, "it's broken");
  assert_true(cases[1].seconds == 1.5);
  free(cases);

  must(arc_store_release(store, &error), &error);
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(cases[0].status, ARC_CASE_WAITING);
  assert_int_equal(cases[1].status, ARC_CASE_FAILED);
  free(cases);
  arc_store_close(&store);
}

static void test_notes(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store = opened("notes", ARC_STORE_CREATE);
  char *text;
  must(arc_store_info(store, "kind", &text, &error), &error);
  assert_null(text);
  must(arc_store_set_info(store, "kind", "a study; 'quoted' \xc3\xa9", &error), &error);
  must(arc_store_info(store, "kind", &text, &error), &error);
  assert_string_equal(text, "a study; 'quoted' \xc3\xa9");
  free(text);
  must(arc_store_set_info(store, "kind", NULL, &error), &error);
  must(arc_store_info(store, "kind", &text, &error), &error);
  assert_null(text);
  arc_store_close(&store);
}

/* Doubles that formats like to lose. */
static const double awkward[] = {0.0,
                                 -0.0,
                                 1.0,
                                 -3.0,
                                 0.1,
                                 1e-308,
                                 4.9e-324,
                                 1e308,
                                 INFINITY,
                                 -INFINITY,
                                 1.0 / 3,
                                 100.0,
                                 9007199254740993.0};
enum { AWKWARD = sizeof awkward / sizeof *awkward };

typedef struct expectation {
  size_t seen;
} expectation;

static int is_as_written(void *context, const arc_value *value) {
  expectation *e = context;
  e->seen++;
  if (strcmp(value->name, "array") == 0) {
    assert_int_equal(value->kind, ARC_VALUE_ARRAY);
    assert_int_equal(value->count, AWKWARD);
    assert_memory_equal(value->array, awkward, sizeof awkward);
  } else if (strcmp(value->name, "empty") == 0) {
    assert_int_equal(value->kind, ARC_VALUE_ARRAY);
    assert_int_equal(value->count, 0);
  } else if (strcmp(value->name, "flag") == 0) {
    assert_int_equal(value->kind, ARC_VALUE_FLAG);
    assert_true(value->number == 1);
  } else if (strcmp(value->name, "text") == 0) {
    assert_int_equal(value->kind, ARC_VALUE_TEXT);
    assert_string_equal(value->text, "12");
  } else {
    int i = atoi(value->name);
    assert_int_equal(value->kind, ARC_VALUE_NUMBER);
    assert_memory_equal(&value->number, &awkward[i], sizeof(double));
  }
  return 0;
}

static void test_values(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store = opened("values", ARC_STORE_CREATE);
  arc_value values[AWKWARD + 4];
  char names[AWKWARD][8];
  for (int i = 0; i < AWKWARD; i++) {
    snprintf(names[i], sizeof names[i], "%d", i);
    values[i] = (arc_value){.kind = ARC_VALUE_NUMBER, .name = names[i], .number = awkward[i]};
  }
  values[AWKWARD] =
      (arc_value){.kind = ARC_VALUE_ARRAY, .name = "array", .array = awkward, .count = AWKWARD};
  values[AWKWARD + 1] = (arc_value){.kind = ARC_VALUE_ARRAY, .name = "empty"};
  values[AWKWARD + 2] = (arc_value){.kind = ARC_VALUE_FLAG, .name = "flag", .number = 1};
  values[AWKWARD + 3] = (arc_value){.kind = ARC_VALUE_TEXT, .name = "text", .text = "12"};
  must(arc_store_add(store, 7, "", &error), &error);
  for (int use = ARC_SETTINGS; use <= ARC_RESULTS; use++)
    must(arc_store_set_values(store, 7, (arc_value_use)use, values, AWKWARD + 4, &error), &error);
  arc_store_close(&store);

  store = opened("values", ARC_STORE_READ);
  for (int use = ARC_SETTINGS; use <= ARC_RESULTS; use++) {
    expectation e = {0};
    must(arc_store_values(store, 7, (arc_value_use)use, is_as_written, &e, &error), &error);
    assert_int_equal(e.seen, AWKWARD + 4);
  }
  arc_store_close(&store);
}

static void test_transactions(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store = opened("transactions", ARC_STORE_CREATE);
  must(arc_store_begin(store, &error), &error);
  must(arc_store_add(store, 1, "kept", &error), &error);
  must(arc_store_commit(store, &error), &error);
  must(arc_store_begin(store, &error), &error);
  must(arc_store_add(store, 2, "taken back", &error), &error);
  arc_store_rollback(store);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 1);
  free(cases);
  arc_store_close(&store);
  store = opened("transactions", ARC_STORE_READ);
  assert_int_equal(arc_store_add(store, 3, "read only", &error), ARC_IO);
  assert_non_null(strstr(error.message, "permission"));
  arc_store_close(&store);
}

/* --- runs ------------------------------------------------------------------------------------- */

static arc_model *coarse_model(void) {
  arc_error error = {0};
  arc_model_def def = arc_model_default();
  arc_model *model;
  def.mesh.size = 0.04;
  def.mesh.height = 0.04;
  def.mesh.zone[ARC_PLATE] = 1.4;
  def.material[ARC_PLATE].nu = 0.31;
  must(arc_model_build(&def, &model, &error), &error);
  return model;
}

static arc_wear *short_run(arc_model *model, double distance) {
  arc_error error = {0};
  arc_wear *wear;
  arc_wear_def def = arc_wear_default();
  def.distance = 330;
  def.increments = 20;
  def.alpha = 0.3;
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  must(arc_wear_run(wear, distance, NULL, NULL, NULL, &error), &error);
  return wear;
}

static void assert_same_doubles(const double *a, const double *b, size_t count) {
  for (size_t i = 0; i < count; i++)
    if (!(isnan(a[i]) && isnan(b[i]))) assert_memory_equal(&a[i], &b[i], sizeof *a);
}

static void assert_same_runs(const arc_wear *a, const arc_wear *b) {
  size_t rows, others;
  const arc_wear_record *history = arc_wear_history(a, &rows),
                        *other = arc_wear_history(b, &others);
  assert_int_equal(rows, others);
  assert_same_doubles((const double *)(const void *)history, (const double *)(const void *)other,
                      rows * sizeof *history / sizeof(double));
  for (int body = 0; body < ARC_BODIES; body++) {
    arc_surface_state one = arc_shape_state(arc_wear_shape(a), (arc_body)body);
    arc_surface_state two = arc_shape_state(arc_wear_shape(b), (arc_body)body);
    assert_int_equal(one.count, two.count);
    assert_int_equal(one.condensed, two.condensed);
    assert_same_doubles(&one.even, &two.even, 1);
    assert_same_doubles(one.h, two.h, (size_t)one.count);
    assert_same_doubles(one.xy, two.xy, 2 * (size_t)one.count);
    assert_same_doubles(one.settled, two.settled, 2 * (size_t)one.count);
  }
}

static void save_as(const char *name, int id, const arc_wear *wear) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_CREATE);
  must(arc_store_add(store, id, "run", &error), &error);
  must(arc_store_save(store, id, wear, NULL, 0, &error), &error);
  arc_store_close(&store);
}

static arc_wear *restored(const char *name, int id, arc_model **model) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_READ);
  arc_stored_run run;
  arc_wear *wear;
  must(arc_store_definition(store, id, &run, &error), &error);
  must(arc_model_build(&run.model, model, &error), &error);
  must(arc_store_restore(store, id, *model, &run.def, &wear, &error), &error);
  arc_stored_run_free(&run);
  arc_store_close(&store);
  return wear;
}

static void test_run_goes_on(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model(), *second_model;
  arc_wear *unbroken = short_run(model, 330), *half = short_run(model, 170);
  save_as("run", 4, half);
  arc_wear *again = restored("run", 4, &second_model);
  assert_same_runs(half, again);
  assert_true(arc_wear_definition(again)->alpha == 0.3);
  assert_int_equal(arc_wear_definition(again)->increments, 20);
  must(arc_wear_run(half, 330, NULL, NULL, NULL, &error), &error);
  must(arc_wear_run(again, 330, NULL, NULL, NULL, &error), &error);
  assert_same_runs(half, again);
  assert_true(arc_wear_last(unbroken)->distance == arc_wear_last(again)->distance);
  arc_wear_destroy(&unbroken);
  arc_wear_destroy(&half);
  arc_wear_destroy(&again);
  arc_model_release(&model);
  arc_model_release(&second_model);
}

/* Every kind of field: numbers, choices, series, blocks of loading. */
static const double distances[3] = {0, 50, 100}, k_at[3] = {2e-8, 1e-8, 1.5e-8},
                    alpha_at[2] = {0.25, 0.75};
static const double to_and_fro[5] = {-0.05, 0, 0.05, 0, -0.05}, loads[5] = {80, 100, 0, 100, 90};
static const arc_loading blocks[2] = {
    {.count = 5, .x = to_and_fro, .load = loads, .cycles = 250.5, .periodic = 1},
    {.count = 3, .x = to_and_fro + 1, .load = loads, .cycles = 1, .periodic = 0}};

static arc_wear_def rich_definition(void) {
  arc_wear_def def = arc_wear_default();
  def.jump = 12.5;
  def.distance = 0;
  def.slip = ARC_SLIP_TOTAL;
  def.rule = ARC_SIMPLE;
  def.geometry = ARC_FROZEN;
  def.refresh = 0.0;
  def.law = ARC_LAW_POWER;
  def.law_pressure = 100;
  def.law_exponent = 0.5;
  def.k_series = (arc_series){3, distances, k_at};
  def.alpha_series = (arc_series){2, distances, alpha_at};
  def.blocks = 2;
  def.loading = blocks;
  return def;
}

static void assert_same_definition(const arc_wear_def *a, const arc_wear_def *b) {
  assert_true(a->k == b->k && a->alpha == b->alpha && a->load == b->load);
  assert_true(a->distance == b->distance && a->jump == b->jump && a->refresh == b->refresh);
  assert_int_equal(a->slip, b->slip);
  assert_int_equal(a->rule, b->rule);
  assert_int_equal(a->geometry, b->geometry);
  assert_int_equal(a->scheme, b->scheme);
  assert_int_equal(a->law, b->law);
  assert_true(a->law_pressure == b->law_pressure && a->law_exponent == b->law_exponent);
  assert_int_equal(a->k_series.count, b->k_series.count);
  assert_memory_equal(a->k_series.distance, b->k_series.distance, sizeof distances);
  assert_memory_equal(a->k_series.value, b->k_series.value, sizeof k_at);
  assert_int_equal(a->alpha_series.count, b->alpha_series.count);
  assert_memory_equal(a->alpha_series.value, b->alpha_series.value, sizeof alpha_at);
  assert_int_equal(a->blocks, b->blocks);
  for (int i = 0; i < a->blocks; i++) {
    size_t size = (size_t)a->loading[i].count * sizeof(double);
    assert_int_equal(a->loading[i].count, b->loading[i].count);
    assert_int_equal(a->loading[i].periodic, b->loading[i].periodic);
    assert_true(a->loading[i].cycles == b->loading[i].cycles);
    assert_memory_equal(a->loading[i].x, b->loading[i].x, size);
    assert_memory_equal(a->loading[i].load, b->loading[i].load, size);
  }
}

static void test_definition(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model();
  arc_wear_def def = rich_definition();
  arc_stored_run back;
  arc_wear *wear;
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  must(arc_wear_step(wear, NULL, NULL, &error), &error);
  save_as("definition", 1, wear);
  arc_store *store = opened("definition", ARC_STORE_READ);
  must(arc_store_definition(store, 1, &back, &error), &error);
  assert_same_definition(arc_wear_definition(wear), &back.def);
  assert_string_equal(back.functions, "");
  arc_stored_run_free(&back);
  arc_store_close(&store);

  arc_model *second_model;
  arc_wear *again = restored("definition", 1, &second_model);
  for (int i = 0; i < 3; i++) {
    must(arc_wear_step(wear, NULL, NULL, &error), &error);
    must(arc_wear_step(again, NULL, NULL, &error), &error);
  }
  assert_same_runs(wear, again);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&again);
  arc_model_release(&model);
  arc_model_release(&second_model);
}

static arc_status ask(void *context, const arc_wear_record *record, double *value) {
  (void)context;
  (void)record;
  *value = 1e-8;
  return ARC_OK;
}

/* Of functions a file knows that they were there. */
static void test_functions(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model();
  arc_wear_def def = arc_wear_default();
  arc_wear *wear;
  def.k_function = ask;
  def.jump_function = ask;
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  save_as("function", 1, wear);
  arc_store *store = opened("function", ARC_STORE_READ);
  arc_stored_run back;
  must(arc_store_definition(store, 1, &back, &error), &error);
  assert_string_equal(back.functions, "jump k ");
  assert_null(back.def.k_function);
  arc_stored_run_free(&back);
  arc_store_close(&store);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

static void test_unknown_fields(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store = opened("unknown", ARC_STORE_CREATE);
  const arc_value bad[] = {{.kind = ARC_VALUE_NUMBER, .name = "colour", .number = 3},
                           {.kind = ARC_VALUE_TEXT, .name = "scheme", .text = "magic"},
                           {.kind = ARC_VALUE_TEXT, .name = "alpha", .text = "half"},
                           {.kind = ARC_VALUE_NUMBER, .name = "loading.0.x", .number = 1}};
  for (int i = 0; i < 4; i++) {
    arc_stored_run run;
    must(arc_store_add(store, i + 1, "case", &error), &error);
    must(arc_store_set_values(store, i + 1, ARC_DEFINITION, &bad[i], 1, &error), &error);
    assert_int_equal(arc_store_definition(store, i + 1, &run, &error), ARC_FORMAT);
    assert_non_null(strstr(error.message, bad[i].name));
    assert_null(run.memory);
  }
  arc_store_close(&store);
}

static void test_surfaces(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model();
  arc_wear *wear = short_run(model, 110);
  double x[3] = {-1, -0.0, 1}, h[3] = {0, 0.5, 0}, y[3] = {1, 2, 3}, p[3] = {0, 1.0 / 3, 0};
  arc_surface early = {ARC_PLATE, 2, 44, 3, x, h, y, p};
  arc_store *store = opened("surfaces", ARC_STORE_CREATE);
  must(arc_store_add(store, 1, "run", &error), &error);
  must(arc_store_save(store, 1, wear, &early, 1, &error), &error);
  must(arc_store_save(store, 1, wear, &early, 1, &error), &error); /* replaces */

  arc_surface *surfaces;
  size_t count;
  must(arc_store_surfaces(store, 1, &surfaces, &count, &error), &error);
  assert_int_equal(count, 3);
  assert_int_equal(surfaces[0].body, ARC_PLATE);
  assert_int_equal(surfaces[0].count, 3);
  assert_true(surfaces[0].update == 2 && surfaces[0].distance == 44);
  assert_memory_equal(surfaces[0].x, x, sizeof x);
  assert_memory_equal(surfaces[0].p, p, sizeof p);
  arc_profile profile = arc_shape_profile(arc_wear_shape(wear), ARC_CYLINDER);
  assert_int_equal(surfaces[1].body, ARC_CYLINDER);
  assert_int_equal(surfaces[1].count, profile.count);
  assert_memory_equal(surfaces[1].h, profile.h, (size_t)profile.count * sizeof(double));
  free(surfaces);

  must(arc_store_surfaces(store, 2, &surfaces, &count, &error), &error);
  assert_int_equal(count, 0);
  free(surfaces);
  arc_stored_run nothing;
  assert_int_equal(arc_store_definition(store, 2, &nothing, &error), ARC_ARGUMENT);
  arc_wear *none;
  assert_int_equal(arc_store_restore(store, 2, model, arc_wear_definition(wear), &none, &error),
                   ARC_FORMAT);
  assert_null(none);
  arc_store_close(&store);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

/* --- files that are not ours ------------------------------------------------------------------ */

/* Opening `name` in every mode is refused with `words`, and leaves every byte as it was. */
static void assert_refused(const char *name, arc_status expected, const char *words) {
  const char *path = in_folder(name);
  size_t before_count, after_count;
  unsigned char *before = bytes_of(path, &before_count);
  for (int mode = ARC_STORE_READ; mode <= ARC_STORE_CREATE; mode++) {
    arc_error error = {0};
    arc_store *store;
    assert_int_equal(arc_store_open(path, (arc_store_mode)mode, &store, &error), expected);
    assert_null(store);
    if (!strstr(error.message, words)) fail_msg("no '%s' in: %s", words, error.message);
    assert_non_null(strstr(error.message, path));
  }
  unsigned char *after = bytes_of(path, &after_count);
  assert_int_equal(before_count, after_count);
  assert_memory_equal(before, after, before_count);
  free(before);
  free(after);
}

/* A copy of a good file with some bytes changed. */
static void write_changed(const char *name, size_t at, const char *bytes, size_t count,
                          size_t keep) {
  arc_store *store = opened("good", ARC_STORE_CREATE);
  arc_store_close(&store);
  size_t size;
  unsigned char *good = bytes_of(in_folder("good"), &size);
  memcpy(good + at, bytes, count);
  write_bytes(in_folder(name), good, keep < size ? keep : size);
  free(good);
}

static void test_foreign_files(void **state) {
  (void)state;
  arc_store *store;
  arc_error error = {0};
  assert_int_equal(arc_store_open(in_folder("absent"), ARC_STORE_READ, &store, &error), ARC_IO);
  assert_int_equal(arc_store_open("/no/such/folder/f", ARC_STORE_CREATE, &store, &error), ARC_IO);
  write_bytes(in_folder("empty"), "", 0);
  assert_refused("empty", ARC_FORMAT, "empty");
  char text[300];
  memset(text, 'x', sizeof text);
  write_bytes(in_folder("text"), text, sizeof text);
  assert_refused("text", ARC_FORMAT, "not a run file");
  write_changed("other", 68, "\1\2\3\4", 4, SIZE_MAX);
  assert_refused("other", ARC_FORMAT, "another program");
  write_changed("newer", 60, "\0\0\0\x63", 4, SIZE_MAX);
  assert_refused("newer", ARC_FORMAT, "newer");
  write_changed("short", 0, "", 0, 5000);
  assert_refused("short", ARC_FORMAT, "damaged");
}

static void test_damaged_pages(void **state) {
  (void)state;
  char noise[4096];
  memset(noise, 0x5a, sizeof noise);
  write_changed("noise", 4096, noise, sizeof noise, SIZE_MAX);
  arc_error error = {0};
  arc_store *store;
  arc_status status = arc_store_open(in_folder("noise"), ARC_STORE_READ, &store, &error);
  if (status == ARC_OK) status = arc_store_check(store, &error);
  assert_int_equal(status, ARC_FORMAT);
  assert_non_null(strstr(error.message, "damaged"));
  arc_store_close(&store);
}

/* Reads all of the first case; whether that worked. */
static int reads_well(const char *name, const arc_wear_record *expected, size_t expected_count) {
  arc_error error = {0};
  arc_store *store;
  arc_wear_record *history = NULL;
  size_t count = 0;
  int well = 0;
  if (arc_store_open(in_folder(name), ARC_STORE_READ, &store, &error) != ARC_OK) return 0;
  if (arc_store_history(store, 1, &history, &count, &error) == ARC_OK) {
    assert_int_equal(count, expected_count);
    assert_memory_equal(history, expected, count * sizeof *history);
    well = 1;
  }
  free(history);
  arc_store_close(&store);
  return well;
}

/* A bit turned over anywhere is refused, or does not touch what is read. */
static void test_turned_bits(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model_def definition = arc_model_default();
  definition.mesh.size = 0.05;
  definition.mesh.height = 0.06;
  arc_model *model;
  must(arc_model_build(&definition, &model, &error), &error);
  arc_wear *wear = short_run(model, 44);
  arc_store *store = opened("bits", ARC_STORE_CREATE);
  must(arc_store_add(store, 1, "one", &error), &error);
  must(arc_store_save(store, 1, wear, NULL, 0, &error), &error);
  must(arc_store_mark(store, 1, ARC_CASE_DONE, NULL, 1, &error), &error);
  arc_store_close(&store);
  size_t rows, count;
  const arc_wear_record *history = arc_wear_history(wear, &rows);
  assert_true(reads_well("bits", history, rows));
  unsigned char *bytes = bytes_of(in_folder("bits"), &count);
  int refused = 0;
  for (size_t at = 100; at < count; at += count / 97) {
    bytes[at] ^= 4;
    write_bytes(in_folder("turned"), bytes, count);
    refused += !reads_well("turned", history, rows);
    bytes[at] ^= 4;
  }
  print_message("# %d of 97 turned bits refused, the others touch nothing that is read\n", refused);
  assert_true(refused > 5);
  free(bytes);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

static void test_replace(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store;
  char *text;
  for (int round = 0; round < 2; round++) {
    must(arc_store_replace(in_folder("replaced"), "wear", &store, &error), &error);
    must(arc_store_add(store, 1, "run", &error), &error);
    must(arc_store_publish(&store, &error), &error);
  }
  must(arc_store_replace(in_folder("replaced"), "wear", &store, &error), &error);
  arc_store_close(&store); /* thought better of it */
  store = opened("replaced", ARC_STORE_READ);
  must(arc_store_info(store, "kind", &text, &error), &error);
  assert_string_equal(text, "wear");
  free(text);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 1);
  free(cases);
  arc_store_close(&store);
  assert_int_equal(arc_store_replace(in_folder("replaced"), "study", &store, &error), ARC_ARGUMENT);
  write_bytes(in_folder("letter"), "Dear Sir", 8);
  assert_int_equal(arc_store_replace(in_folder("letter"), "wear", &store, &error), ARC_FORMAT);
  size_t size;
  unsigned char *letter = bytes_of(in_folder("letter"), &size);
  assert_memory_equal(letter, "Dear Sir", 8);
  free(letter);
}

/* --- hard times ------------------------------------------------------------------------------- */

static void add_many(arc_store *store, int from, int to, arc_error *error, arc_status *status) {
  *status = arc_store_begin(store, error);
  for (int id = from; id < to && *status == ARC_OK; id++)
    *status = arc_store_add(store, id, "a label of some length, so that pages fill up", error);
  if (*status == ARC_OK)
    *status = arc_store_commit(store, error);
  else
    arc_store_rollback(store);
}

static size_t count_of(const char *name) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_WRITE);
  must(arc_store_check(store, &error), &error);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  free(cases);
  arc_store_close(&store);
  return count;
}

/* A limit on the size of files stands in for a full disk: in a child, since it cannot be raised. */
static void test_full_disk(void **state) {
  (void)state;
  arc_store *store = opened("full", ARC_STORE_CREATE);
  arc_error error = {0};
  arc_status status;
  add_many(store, 1, 100, &error, &status);
  must(status, &error);
  arc_store_close(&store);
  pid_t child = fork();
  if (child == 0) {
    struct rlimit limit = {100000, 100000};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    if (arc_store_open(in_folder("full"), ARC_STORE_WRITE, &store, &error) != ARC_OK) _exit(2);
    add_many(store, 100, 20000, &error, &status);
    int told = status == ARC_IO && strstr(error.message, in_folder("full")) != NULL;
    arc_store_close(&store);
    _exit(told ? 0 : 3);
  }
  int ended;
  waitpid(child, &ended, 0);
  assert_true(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  assert_int_equal(count_of("full"), 99);
}

/* A writer is killed at some moment; whole batches are there, never a part of one. */
static void test_killed_writer(void **state) {
  (void)state;
  enum { ROUNDS = 12, BATCH = 50 };
  arc_store *store = opened("killed", ARC_STORE_CREATE);
  arc_store_close(&store);
  for (int round = 0; round < ROUNDS; round++) {
    size_t before = count_of("killed");
    pid_t child = fork();
    if (child == 0) {
      arc_error error = {0};
      arc_status status = arc_store_open(in_folder("killed"), ARC_STORE_WRITE, &store, &error);
      for (int id = (int)before + 1; status == ARC_OK; id += BATCH)
        add_many(store, id, id + BATCH, &error, &status);
      _exit(1);
    }
    usleep(3000u * (unsigned)(round + 1));
    kill(child, SIGKILL);
    int ended;
    waitpid(child, &ended, 0);
    assert_true(WIFSIGNALED(ended) && WTERMSIG(ended) == SIGKILL);
    size_t after = count_of("killed");
    assert_true(after >= before);
    assert_int_equal(after % BATCH, 0);
  }
}

static void test_two_writers(void **state) {
  (void)state;
  enum { WRITERS = 3, EACH = 20 };
  arc_store *store = opened("shared", ARC_STORE_CREATE);
  arc_store_close(&store);
  pid_t child[WRITERS];
  for (int w = 0; w < WRITERS; w++) {
    child[w] = fork();
    if (child[w] == 0) {
      arc_error error = {0};
      arc_status status = arc_store_open(in_folder("shared"), ARC_STORE_WRITE, &store, &error);
      for (int i = 0; i < EACH && status == ARC_OK; i++)
        status = arc_store_add(store, w * EACH + i + 1, "one of many", &error);
      _exit(status == ARC_OK ? 0 : 1);
    }
  }
  for (int w = 0; w < WRITERS; w++) {
    int ended;
    waitpid(child[w], &ended, 0);
    assert_true(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  }
  assert_int_equal(count_of("shared"), WRITERS * EACH);
}

/* --- shards ----------------------------------------------------------------------------------- */

static void make_share(const char *name, int done, double alpha, const arc_wear *wear) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_CREATE);
  arc_value value = {.kind = ARC_VALUE_NUMBER, .name = "alpha", .number = alpha};
  for (int id = 1; id <= 2; id++) {
    must(arc_store_add(store, id, id == 1 ? "one" : "two", &error), &error);
    must(arc_store_set_values(store, id, ARC_SETTINGS, &value, 1, &error), &error);
  }
  if (done > 0) {
    must(arc_store_save(store, done, wear, NULL, 0, &error), &error);
    must(arc_store_mark(store, done, ARC_CASE_DONE, NULL, 2.5, &error), &error);
  }
  arc_store_close(&store);
}

static void test_merge(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model(), *second_model;
  arc_wear *wear = short_run(model, 66);
  make_share("share 1", 1, 0.5, wear);
  make_share("share '2'", 2, 0.5, wear);
  make_share("stranger", 2, 0.25, wear);
  make_share("joined", 0, 0.5, wear);
  arc_store *store = opened("joined", ARC_STORE_WRITE);
  must(arc_store_merge(store, in_folder("share 1"), &error), &error);
  assert_int_equal(arc_store_merge(store, in_folder("stranger"), &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "different studies"));
  assert_int_equal(arc_store_merge(store, in_folder("share 1"), &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "case 1 is finished in both"));
  must(arc_store_merge(store, in_folder("share '2'"), &error), &error);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 2);
  for (size_t i = 0; i < count; i++) {
    assert_int_equal(cases[i].status, ARC_CASE_DONE);
    assert_true(cases[i].seconds == 2.5);
  }
  free(cases);
  arc_store_close(&store);
  arc_wear *again = restored("joined", 2, &second_model);
  assert_same_runs(wear, again);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&again);
  arc_model_release(&model);
  arc_model_release(&second_model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_cases),         cmocka_unit_test(test_notes),
      cmocka_unit_test(test_values),        cmocka_unit_test(test_transactions),
      cmocka_unit_test(test_run_goes_on),   cmocka_unit_test(test_definition),
      cmocka_unit_test(test_functions),     cmocka_unit_test(test_unknown_fields),
      cmocka_unit_test(test_surfaces),      cmocka_unit_test(test_foreign_files),
      cmocka_unit_test(test_damaged_pages), cmocka_unit_test(test_turned_bits),
      cmocka_unit_test(test_replace),       cmocka_unit_test(test_full_disk),
      cmocka_unit_test(test_killed_writer), cmocka_unit_test(test_two_writers),
      cmocka_unit_test(test_merge),
  };
  arc_single_threaded();
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}

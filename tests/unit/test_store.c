/* Tests of the run file: stored values are read back bit by bit. */
#include "store_shared.h"

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

/* Numbers that a faulty conversion would change. */
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
  must(arc_wear_run(half, 330, NULL, &error), &error);
  must(arc_wear_run(again, 330, NULL, &error), &error);
  assert_same_runs(half, again);
  assert_true(arc_wear_last(unbroken)->distance == arc_wear_last(again)->distance);
  arc_wear_destroy(&unbroken);
  arc_wear_destroy(&half);
  arc_wear_destroy(&again);
  arc_model_release(&model);
  arc_model_release(&second_model);
}

/* A definition with fields of every kind: numbers, choices, series, and blocks of loading. */
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
  must(arc_wear_step(wear, NULL, &error), &error);
  save_as("definition", 1, wear);
  arc_store *store = opened("definition", ARC_STORE_READ);
  must(arc_store_definition(store, 1, &back, &error), &error);
  assert_same_definition(arc_wear_definition(wear), &back.def);
  assert_false(back.functions[ARC_AT_k] || back.functions[ARC_AT_jump]);
  arc_stored_run_free(&back);
  arc_store_close(&store);

  arc_model *second_model;
  arc_wear *again = restored("definition", 1, &second_model);
  for (int i = 0; i < 3; i++) {
    must(arc_wear_step(wear, NULL, &error), &error);
    must(arc_wear_step(again, NULL, &error), &error);
  }
  assert_same_runs(wear, again);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&again);
  arc_model_release(&model);
  arc_model_release(&second_model);
}

static arc_status ask(void *context, const arc_setting *what, const arc_wear_record *record,
                      double *value) {
  (void)what;
  (void)context;
  (void)record;
  *value = 1e-8;
  return ARC_OK;
}

/* Tests that a file stores which settings were functions. */
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
  assert_true(back.functions[ARC_AT_k] && back.functions[ARC_AT_jump]);
  assert_false(back.functions[ARC_AT_alpha] || back.functions[ARC_AT_local_factor]);
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

static const double *values_of(const arc_array *arrays, size_t count, arc_body body,
                               const char *name) {
  const arc_array *found = arc_array_find(arrays, count, body, name);
  assert_non_null(found);
  return found->values;
}

/* Checks that a run with arrays that could not be read back is refused. */
static void check_refused(arc_store *store, const arc_wear *wear, const arc_array *surfaces,
                          size_t count, const char *word) {
  arc_error error = {0};
  assert_int_equal(arc_store_save(store, 1, wear, surfaces, count, &error), ARC_ARGUMENT);
  if (!strstr(error.message, word)) fail_msg("no '%s' in: %s", word, error.message);
}

static void test_surfaces(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model();
  arc_wear *wear = short_run(model, 110);
  double x[3] = {-1, -0.0, 1}, h[3] = {0, 0.5, 0}, y[3] = {1, 2, 3}, p[3] = {0, 1.0 / 3, 0};
  arc_array given[12] = {{"x", ARC_PLATE, 2, 44, {3, 1}, x},
                         {"h", ARC_PLATE, 2, 44, {3, 1}, h},
                         {"y", ARC_PLATE, 2, 44, {3, 1}, y},
                         {"p", ARC_PLATE, 2, 44, {3, 1}, p}},
            *present;
  size_t count;
  must(arc_wear_surfaces(wear, &present, &count, &error), &error);
  assert_int_equal(count, 8);
  memcpy(given + 4, present, 8 * sizeof *present);
  arc_store *store = opened("surfaces", ARC_STORE_CREATE);
  must(arc_store_add(store, 1, "run", &error), &error);
  must(arc_store_save(store, 1, wear, given, 12, &error), &error);
  must(arc_store_save(store, 1, wear, given, 12, &error), &error); /* replaces the stored values */

  arc_array *surfaces;
  must(arc_store_surfaces(store, 1, &surfaces, &count, &error), &error);
  assert_int_equal(count, 12);
  assert_int_equal(surfaces[0].body, ARC_PLATE);
  assert_int_equal(arc_array_count(&surfaces[0]), 3);
  assert_true(surfaces[0].update == 2 && surfaces[0].distance == 44);
  assert_memory_equal(values_of(surfaces, 4, ARC_PLATE, "x"), x, sizeof x);
  assert_memory_equal(values_of(surfaces, 4, ARC_PLATE, "p"), p, sizeof p);
  arc_profile profile = arc_shape_profile(arc_wear_shape(wear), ARC_CYLINDER);
  assert_int_equal(surfaces[4].body, ARC_CYLINDER);
  assert_int_equal(arc_array_count(&surfaces[4]), profile.count);
  assert_memory_equal(values_of(surfaces + 4, 8, ARC_CYLINDER, "h"), profile.h,
                      (size_t)profile.count * sizeof(double));
  arc_contact *contact;
  must(arc_wear_contact(wear, &contact, &error), &error);
  arc_pressure pressure = arc_contact_pressure(contact, ARC_PLATE);
  assert_int_equal(arc_array_count(&surfaces[8]), pressure.count);
  assert_memory_equal(values_of(surfaces + 4, 8, ARC_PLATE, "p"), pressure.p,
                      (size_t)pressure.count * sizeof(double));
  arc_contact_destroy(&contact);
  free(surfaces);

  check_refused(store, wear, given, 11, "expected p");
  p[1] = -1;
  check_refused(store, wear, given, 12, "expected for p[1]");
  p[1] = 1, x[2] = x[1];
  check_refused(store, wear, given, 12, "expected for x[2]");
  x[2] = 1, h[0] = NAN;
  check_refused(store, wear, given, 12, "expected for h[0]");
  h[0] = 0, given[2].size[0] = 2;
  check_refused(store, wear, given, 12, "expected y of 3 numbers");
  must(arc_store_surfaces(store, 1, &surfaces, &count, &error), &error);
  assert_int_equal(count, 12);
  free(surfaces);
  free(present);

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

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_cases),       cmocka_unit_test(test_notes),
      cmocka_unit_test(test_values),      cmocka_unit_test(test_transactions),
      cmocka_unit_test(test_run_goes_on), cmocka_unit_test(test_definition),
      cmocka_unit_test(test_functions),   cmocka_unit_test(test_unknown_fields),
      cmocka_unit_test(test_surfaces)};
  arc_single_threaded();
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}

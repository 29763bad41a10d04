/* Common parts of the run file tests: a temporary folder, runs on a coarse mesh, and
 * comparisons. */
#ifndef TESTS_STORE_SHARED_H
#define TESTS_STORE_SHARED_H

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

/* Returns the path of a file in the test's folder; the path is valid during the next three
 * calls. */
__attribute__((unused)) static const char *in_folder(const char *name) {
  static char path[4][200];
  static int turn;
  turn = (turn + 1) % 4;
  snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
  return path[turn];
}

__attribute__((unused)) static int make_folder(void **state) {
  (void)state;
  return mkdtemp(folder) ? 0 : -1;
}

__attribute__((unused)) static int remove_folder(void **state) {
  (void)state;
  char command[300];
  snprintf(command, sizeof command, "rm -rf %s", folder);
  return system(command);
}

__attribute__((unused)) static arc_store *opened(const char *name, arc_store_mode mode) {
  arc_error error = {0};
  arc_store *store;
  if (arc_store_open(in_folder(name), mode, &store, &error) != ARC_OK)
    fail_msg("%s", error.message);
  return store;
}

__attribute__((unused)) static void must(arc_status status, const arc_error *error) {
  if (status != ARC_OK) fail_msg("%s", error->message);
}

/* Returns all bytes of a file; the caller frees them. */
__attribute__((unused)) static unsigned char *bytes_of(const char *path, size_t *count) {
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

__attribute__((unused)) static void write_bytes(const char *path, const void *bytes, size_t count) {
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, count, file), count);
  assert_int_equal(fclose(file), 0);
}

/* Copies a file into the test's folder. */
__attribute__((unused)) static void copy_file(const char *path, const char *name) {
  size_t count;
  unsigned char *bytes = bytes_of(path, &count);
  write_bytes(in_folder(name), bytes, count);
  free(bytes);
}

/* Copies the file "good" of the test's folder to another name in this folder. */
__attribute__((unused)) static void copy_good(const char *name) {
  copy_file(in_folder("good"), name);
}

__attribute__((unused)) static arc_model *coarse_model(void) {
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

__attribute__((unused)) static arc_wear *short_run(arc_model *model, double distance) {
  arc_error error = {0};
  arc_wear *wear;
  arc_wear_def def = arc_wear_default();
  def.distance = 330;
  def.increments = 20;
  def.alpha = 0.3;
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  must(arc_wear_run(wear, distance, NULL, &error), &error);
  return wear;
}

__attribute__((unused)) static void assert_same_doubles(const double *a, const double *b,
                                                        size_t count) {
  for (size_t i = 0; i < count; i++)
    if (!(isnan(a[i]) && isnan(b[i]))) assert_memory_equal(&a[i], &b[i], sizeof *a);
}

__attribute__((unused)) static void assert_same_runs(const arc_wear *a, const arc_wear *b) {
  size_t rows, others;
  const arc_wear_record *history = arc_wear_history(a, &rows),
                        *other = arc_wear_history(b, &others);
  assert_int_equal(rows, others);
  assert_same_doubles((const double *)(const void *)history, (const double *)(const void *)other,
                      rows * sizeof *history / sizeof(double));
  arc_array one[ARC_SHAPE_STATE], two[ARC_SHAPE_STATE];
  arc_shape_state(arc_wear_shape(a), one);
  arc_shape_state(arc_wear_shape(b), two);
  for (int i = 0; i < ARC_SHAPE_STATE; i++) {
    assert_int_equal(arc_array_count(&one[i]), arc_array_count(&two[i]));
    assert_same_doubles(one[i].values, two[i].values, arc_array_count(&one[i]));
  }
}

/* Stores a run together with its present surfaces as the case with number `id`. */
__attribute__((unused)) static void save_run(arc_store *store, int id, const arc_wear *wear) {
  arc_error error = {0};
  arc_array *present;
  size_t count;
  must(arc_wear_surfaces(wear, &present, &count, &error), &error);
  must(arc_store_save(store, id, wear, present, count, &error), &error);
  free(present);
}

__attribute__((unused)) static void save_as(const char *name, int id, const arc_wear *wear) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_CREATE);
  must(arc_store_add(store, id, "run", &error), &error);
  save_run(store, id, wear);
  arc_store_close(&store);
}

__attribute__((unused)) static arc_wear *restored(const char *name, int id, arc_model **model) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_READ);
  arc_stored_run run;
  arc_wear *wear;
  must(arc_store_definition(store, id, &run, &error), &error);
  must(arc_stored_run_model(&run, NULL, model, &error), &error);
  must(arc_store_restore(store, id, *model, &run.def, &wear, &error), &error);
  arc_stored_run_free(&run);
  arc_store_close(&store);
  return wear;
}

#endif

/* Computes a wear run whose wear coefficient decreases during running-in. The run is stored
 * half-way, read from the file and continued. The result equals the result of the uninterrupted
 * run in every bit.
 *   cc running_in.c $(pkg-config --cflags --libs archard) -o running_in
 *   ./running_in FILE
 * Units: mm, N, MPa. */
#include <archard/store.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Computes the wear coefficient k, which decreases from 5e-8 to 1e-8 mm2/N with the distance.
 * `state` is the run's last record, extrapolated to the middle of the step. If the function
 * returns a status other than ARC_OK, the step fails. */
static arc_status running_in(void *context, const arc_setting *what, const arc_wear_record *state,
                             double *k) {
  (void)what;
  const double settled = *(const double *)context;
  *k = settled * (1 + 4 * exp(-state->distance / 20));
  return ARC_OK;
}

static void print(const char *title, const arc_wear *wear) {
  const arc_wear_record *last = arc_wear_last(wear);
  printf("%-10s %4.0f mm   k %.3e mm2/N   p_center %.2f MPa   volume %.6e mm3\n", title,
         last->distance, last->k, last->p_center, last->volume_cylinder + last->volume_plate);
}

/* Repeats wear steps until the run reaches a sliding distance [mm], as arc_wear_run does. A step
 * that fails does not change the run. */
static arc_status advance(arc_wear *wear, double distance, arc_error *why) {
  arc_status status = ARC_OK;
  while (status == ARC_OK && arc_wear_last(wear)->distance < distance)
    status = arc_wear_step(wear, NULL, why);
  return status;
}

/* Writes a new file with one case that contains the run. Its surfaces are also stored, so that
 * other programs can plot them. */
static arc_status save(const char *path, const arc_wear *wear, arc_error *why) {
  arc_store *store = NULL;
  arc_array *surfaces;
  size_t count;
  arc_status status = arc_wear_surfaces(wear, &surfaces, &count, why);
  if (status == ARC_OK) status = arc_store_replace(path, "example", &store, why);
  if (status == ARC_OK) status = arc_store_add(store, 1, "running in", why);
  if (status == ARC_OK) status = arc_store_save(store, 1, wear, surfaces, count, why);
  if (status == ARC_OK) status = arc_store_publish(&store, why);
  arc_store_close(&store);
  free(surfaces);
  return status;
}

/* Reads the run from a file. The file contains the definition and the state but no functions, so
 * the coefficient function is set again. */
static arc_status load(const char *path, double *settled, arc_wear **wear, arc_error *why) {
  arc_store *store;
  arc_model *model = NULL;
  arc_stored_run run;
  arc_status status = arc_store_open(path, ARC_STORE_READ, &store, why);
  if (status == ARC_OK) status = arc_store_definition(store, 1, &run, why);
  if (status == ARC_OK) {
    run.def.k_function = running_in;
    run.def.context = settled;
    status = arc_stored_run_model(&run, NULL, &model, why);
    if (status == ARC_OK) status = arc_store_restore(store, 1, model, &run.def, wear, why);
    arc_stored_run_free(&run);
  }
  arc_model_release(&model); /* the run keeps its own reference */
  arc_store_close(&store);
  return status;
}

int main(int count, char **arguments) {
  if (count != 2) {
    fprintf(stderr, "usage: running_in FILE\n");
    return 2;
  }
  const char *path = arguments[1];
  double settled = 1e-8; /* [mm2/N] */
  arc_error why = {0};
  arc_model *model = NULL;
  arc_wear *wear = NULL, *reopened = NULL;
  arc_single_threaded();

  arc_model_def model_def = arc_model_default();
  arc_wear_def def = arc_wear_default();
  def.k_function = running_in;
  def.context = &settled;
  def.distance = 88;
  def.jump = 20;

  arc_status status = arc_model_build(&model_def, &model, &why);
  if (status == ARC_OK) status = arc_wear_create(model, &def, NULL, &wear, &why);
  if (status == ARC_OK) status = advance(wear, 44, &why);
  if (status == ARC_OK) status = save(path, wear, &why);
  if (status == ARC_OK) status = load(path, &settled, &reopened, &why);
  if (status == ARC_OK) {
    print("stored", wear);
    status = advance(wear, def.distance, &why);
  }
  if (status == ARC_OK) status = advance(reopened, def.distance, &why);
  if (status == ARC_OK) {
    print("unbroken", wear);
    print("reopened", reopened);
    printf("%s\n", arc_wear_last(wear)->p_center == arc_wear_last(reopened)->p_center
                       ? "the same bits"
                       : "they differ");
  } else {
    fprintf(stderr, "running_in: %s: %s\n", arc_status_text(status), why.message);
  }
  arc_wear_destroy(&reopened);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
  return status == ARC_OK ? 0 : 1;
}

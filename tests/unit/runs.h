/* Common parts of the tests of wear runs: a coarse model, definitions of short runs, and a
 * comparison of whole runs. */
#ifndef TESTS_RUNS_H
#define TESTS_RUNS_H

#include "check.h"

static arc_model *coarse; /* built once; its meshed zone is wide enough for every stroke of these
                           * tests */

UNUSED static int set_up(void **state) {
  (void)state;
  arc_model_def def = coarse_definition();
  def.mesh.zone[ARC_PLATE] = 1.6;
  return arc_model_build(&def, &coarse, NULL) == ARC_OK ? 0 : -1;
}

UNUSED static int tear_down(void **state) {
  (void)state;
  arc_model_release(&coarse);
  return 0;
}

/* Returns the definition of a run with few steps and increments. */
UNUSED static arc_wear_def quick(double stroke, double alpha) {
  arc_wear_def def = arc_wear_default();
  def.stroke = stroke;
  def.alpha = alpha;
  def.increments = 20;
  def.distance = 132;
  def.jump = stroke == 20 ? 1 : 11 / stroke; /* six steps */
  return def;
}

UNUSED static arc_wear *start(const arc_wear_def *def) {
  arc_wear *wear = NULL;
  check_ok(arc_wear_create(coarse, def, NULL, &wear, why));
  return wear;
}

UNUSED static arc_wear *run(const arc_wear_def *def) {
  arc_wear *wear = start(def);
  check_ok(arc_wear_run(wear, def->distance, NULL, why));
  return wear;
}

/* --- identical bits --------------------------------------------------------------------------- */

UNUSED static void check_same_shape(const arc_shape *one, const arc_shape *two) {
  arc_array s[ARC_SHAPE_STATE], t[ARC_SHAPE_STATE];
  arc_shape_state(one, s);
  arc_shape_state(two, t);
  for (int i = 0; i < ARC_SHAPE_STATE; i++) {
    assert_int_equal(arc_array_count(&s[i]), arc_array_count(&t[i]));
    assert_memory_equal(s[i].values, t[i].values, arc_array_count(&s[i]) * sizeof(double));
  }
}

/* Checks that shapes, definitions and histories of two runs are identical bit by bit, except for
 * the number of solutions. */
UNUSED static void check_same(const arc_wear *one, const arc_wear *two) {
  size_t n, m;
  const arc_wear_record *r = arc_wear_history(one, &n), *s = arc_wear_history(two, &m);
  assert_int_equal(n, m);
  assert_memory_equal(r, s, n * sizeof *r);
  check_same_shape(arc_wear_shape(one), arc_wear_shape(two));
}

UNUSED static void check_volumes(const arc_wear *wear) {
  const arc_wear_def *def = arc_wear_definition(wear);
  const arc_wear_record *last = arc_wear_last(wear);
  const double total = def->k * def->load * last->distance;
  check_near(last->volume_cylinder, def->alpha * total, 1e-9 * total);
  check_near(last->volume_plate, (1 - def->alpha) * total, 1e-9 * total);
}

#endif

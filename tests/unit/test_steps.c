/* Tests of the steps of wear runs: a step is complete or has no effect, runs are stopped and
 * continued, distances are exact, and copies and restored states continue with identical bits. */
#include "runs.h"

/* --- steps ------------------------------------------------------------------------------------ */

static void test_last_step(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  def.jump = 170; /* each step is 37.4 mm, so 132 mm need 3.53 steps */
  arc_wear *wear = start(&def);
  static const double distance[] = {37.4, 74.8, 112.2, 132, 132};
  for (int step = 0; step < 5; step++) {
    check_ok(arc_wear_step(wear, NULL, why));
    check_share(arc_wear_last(wear)->distance, distance[step], 1e-14);
  }
  assert_true(arc_wear_last(wear)->distance == 132);
  assert_true(arc_wear_last(wear)->update == 4);
  check_share(arc_wear_last(wear)->jump, 90, 1e-12);
  check_share(arc_wear_last(wear)->cycle, 600, 1e-12);
  check_ok(arc_wear_run(wear, 200, NULL, why));
  assert_true(arc_wear_last(wear)->distance == 200);
  assert_true(arc_wear_definition(wear)->distance == 200);
  check_volumes(wear);
  arc_wear_destroy(&wear);
}

/* Tests that distances that are not exact binary fractions give whole steps without a tiny last
 * step. */
static void test_whole_steps(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  def.distance = 66;
  def.jump = 30;
  arc_wear *wear = run(&def);
  assert_true(arc_wear_last(wear)->update == 10);
  check_share(arc_wear_last(wear)->jump, 30, 1e-9);
  arc_wear_destroy(&wear);
}

static void test_history(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.25);
  arc_wear *wear = run(&def);
  size_t count;
  const arc_wear_record *r = arc_wear_history(wear, &count);
  assert_int_equal(count, 7);
  assert_true(isnan(r[0].depth_partition) && r[0].distance == 0 && r[0].volume_plate == 0);
  for (size_t k = 1; k < count; k++) {
    assert_true(r[k].update == (double)k && r[k].distance > r[k - 1].distance);
    assert_true(r[k].p_center < r[k - 1].p_center && r[k].half_width > 0.97 * r[k - 1].half_width);
    assert_true(r[k].depth_cylinder > r[k - 1].depth_cylinder);
    assert_true(r[k].p_peak >= r[k].p_max && r[k].p_max >= r[k].p_center &&
                r[k].solutions > r[k - 1].solutions);
    check_share(r[k].depth_partition,
                r[k].depth_cylinder / (r[k].depth_cylinder + r[k].depth_plate), 1e-15);
    assert_true(r[k].k == def.k && r[k].alpha == def.alpha);
  }
  assert_true(r[count - 1].half_width > 1.1 * r[0].half_width);
  arc_wear_destroy(&wear);
}

/* Tests that the pressure in the history equals the pressure of a contact solved for the present
 * shape. */
static void test_reference_contact(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *wear = run(&def);
  arc_contact *contact = NULL;
  check_ok(arc_wear_contact(wear, &contact, why));
  const arc_contact_result r = arc_contact_get(contact);
  check_share(arc_wear_last(wear)->p_center, r.p_center, 1e-12);
  check_share(arc_wear_last(wear)->p_max, r.p_max, 1e-12);
  check_share(arc_wear_last(wear)->half_width, r.half_width, 1e-12);
  arc_contact_destroy(&contact);
  arc_wear_destroy(&wear);
}

/* --- stopping and continuing ------------------------------------------------------------------ */

static int count_down(void *context) {
  int *left = context;
  return (*left)-- <= 0;
}

static void check_stops(const arc_wear_def *def, int step_length) {
  arc_wear *whole = run(def), *wear = start(def), *before = NULL;
  int stops = 0;
  for (int patience = 0; arc_wear_last(wear)->distance < 132; patience++) {
    int left = patience % step_length;
    const arc_callbacks callbacks = {.stop = count_down, .context = &left};
    arc_wear_destroy(&before);
    check_ok(arc_wear_clone(wear, &before, why));
    const arc_status status = arc_wear_step(wear, &callbacks, NULL);
    assert_true(status == ARC_OK || status == ARC_STOPPED);
    if (status == ARC_OK) continue;
    stops++;
    check_same(wear, before);
  }
  assert_true(stops >= 11);
  check_same(wear, whole);
  arc_wear_destroy(&before);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&whole);
}

/* Tests a run that is stopped at each contact solution of a step in turn: the run is unchanged
 * and then continues with identical bits. */
static void test_stop(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  check_stops(&def, 31);
  arc_wear_def automatic = def;
  automatic.jump = 0;
  check_stops(&automatic, 67);
  def.increments = 4;
  def.scheme = ARC_IMPLICIT;
  check_stops(&def, 60);
}

static int progress_calls;

static int stop_at_three(void *context, const arc_wear *wear) {
  (void)context;
  progress_calls++;
  return arc_wear_last(wear)->update >= 3;
}

static void test_progress(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *wear = start(&def);
  progress_calls = 0;
  check_refused(arc_wear_run(wear, 132, &(arc_callbacks){.progress = stop_at_three}, why),
                ARC_STOPPED, "stopped");
  assert_int_equal(progress_calls, 3);
  assert_true(arc_wear_last(wear)->update == 3);
  check_ok(arc_wear_run(wear, 132, NULL, why));
  arc_wear *whole = run(&def);
  check_same(wear, whole);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&whole);
}

/* Tests a step that cannot be computed because it would wear through the wear box: two attempts
 * give the same error and leave the run unchanged. */
static void test_failing_step(void **state) {
  (void)state;
  static const struct {
    double stroke, alpha, k;
  } hopeless[] = {{0.11, 0.5, 1e-5}, {0.11, 0, 1e-5}, {0.11, 1, 1e-5}, {20, 0.5, 2e-5}};
  for (int c = 0; c < 4; c++) {
    arc_wear_def def = quick(hopeless[c].stroke, hopeless[c].alpha);
    def.distance = 13200;
    arc_model_def md = *arc_model_definition(coarse);
    md.mesh.zone[0] = md.mesh.zone[1] = 4;
    arc_model *model = build_model(&md);
    arc_wear *wear = NULL, *before = NULL;
    check_ok(arc_wear_create(model, &def, NULL, &wear, why));
    check_ok(arc_wear_step(wear, NULL, why));
    arc_wear_def worse = def;
    worse.k = hopeless[c].k;
    worse.jump = 100 * def.jump;
    size_t count;
    const arc_wear_record *history = arc_wear_history(wear, &count);
    check_ok(arc_wear_restore(model, &worse, arc_wear_shape(wear), history, count, &before, why));
    arc_wear *failing = NULL;
    check_ok(arc_wear_clone(before, &failing, why));
    for (int twice = 0; twice < 2; twice++) {
      check_refused(arc_wear_step(failing, NULL, why), ARC_GEOMETRY, "wear box");
      check_same(failing, before);
    }
    arc_wear_destroy(&failing);
    arc_wear_destroy(&before);
    arc_wear_destroy(&wear);
    arc_model_release(&model);
  }
}

/* --- copies ----------------------------------------------------------------------------------- */

static void check_goes_on(const arc_wear_def *def) {
  arc_wear *whole = run(def), *wear = start(def), *copy = NULL, *stored = NULL;
  for (int step = 0; step < 3; step++) check_ok(arc_wear_step(wear, NULL, why));
  check_ok(arc_wear_clone(wear, &copy, why));
  check_same(wear, copy);
  arc_array *state;
  size_t arrays, count;
  check_ok(arc_wear_state(wear, &state, &arrays, why));
  const arc_wear_record *history = arc_wear_history(wear, &count);
  check_ok(arc_wear_resume(coarse, def, state, arrays, history, count, &stored, why));
  free(state);
  arc_wear_destroy(&wear);
  check_ok(arc_wear_run(copy, def->distance, NULL, why));
  check_ok(arc_wear_run(stored, def->distance, NULL, why));
  check_same(copy, whole);
  check_same(stored, whole);
  arc_wear_destroy(&whole);
  arc_wear_destroy(&copy);
  arc_wear_destroy(&stored);
}

static void test_copies_go_on(void **state) {
  (void)state;
  static const double strokes[] = {0.11, 0.44, 20}, alphas[] = {0.25, 1};
  for (int s = 0; s < 3; s++)
    for (int a = 0; a < 2; a++)
      for (int geometry = ARC_MOVING; geometry <= ARC_FROZEN; geometry++) {
        arc_wear_def def = quick(strokes[s], alphas[a]);
        def.geometry = (arc_geometry)geometry;
        check_goes_on(&def);
        def.jump = 0; /* the history contains the error estimates of earlier steps */
        def.k = 5e-8;
        check_goes_on(&def);
      }
}

/* Tests that steps of the original do not change the copy. */
static void test_copies_apart(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *wear = start(&def), *copy = NULL, *other = NULL;
  check_ok(arc_wear_step(wear, NULL, why));
  check_ok(arc_wear_clone(wear, &copy, why));
  check_ok(arc_wear_clone(wear, &other, why));
  check_ok(arc_wear_step(wear, NULL, why));
  check_same(copy, other);
  arc_wear_destroy(&wear);
  check_same(copy, other);
  arc_wear_destroy(&copy);
  arc_wear_destroy(&other);
}

/* Tests that a run started from another run's worn shape has this shape and an empty history. */
static void test_worn_start(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *first = run(&def), *second = NULL;
  check_ok(arc_wear_create(coarse, &def, arc_wear_shape(first), &second, why));
  check_same_shape(arc_wear_shape(first), arc_wear_shape(second));
  assert_true(arc_wear_last(second)->distance == 0 && arc_wear_last(second)->volume_plate == 0);
  check_share(arc_wear_last(second)->p_center, arc_wear_last(first)->p_center, 1e-12);
  check_ok(arc_wear_step(second, NULL, why));
  check_volumes(second);
  arc_model *other = coarse_model();
  arc_wear *foreign = first;
  check_refused(arc_wear_create(other, &def, arc_wear_shape(first), &foreign, why), ARC_ARGUMENT,
                "another model");
  assert_null(foreign);
  arc_model_release(&other);
  arc_wear_destroy(&first);
  arc_wear_destroy(&second);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_last_step),    cmocka_unit_test(test_whole_steps),
      cmocka_unit_test(test_history),      cmocka_unit_test(test_reference_contact),
      cmocka_unit_test(test_stop),         cmocka_unit_test(test_progress),
      cmocka_unit_test(test_failing_step), cmocka_unit_test(test_copies_go_on),
      cmocka_unit_test(test_copies_apart), cmocka_unit_test(test_worn_start),
  };
  return cmocka_run_group_tests_name("steps", tests, set_up, tear_down);
}

/* Tests of runs that need a larger mesh and of interrupted model construction: an interruption
 * leaves the previous state unchanged. */
#include "archard/contact.h"
#include "runs.h"

#include <string.h>

static int asked, patience, warnings;
static char warning[600];

static int stop_when_tired(void *context) {
  (void)context;
  return ++asked > patience;
}

static void hear(void *context, const char *text) {
  (void)context;
  warnings++;
  snprintf(warning, sizeof warning, "%s", text);
}

/* Returns a run whose next step exceeds its meshed zone. */
static arc_wear *about_to_grow(void) {
  arc_model_def md = coarse_definition();
  md.mesh.zone[ARC_CYLINDER] = md.mesh.zone[ARC_PLATE] = 0.72;
  arc_model *model = build_model(&md);
  arc_wear_def def = arc_wear_default();
  def.alpha = 1;
  def.k = 3e-8;
  def.jump = 40;
  arc_wear *wear, *ahead = NULL;
  check_ok(arc_wear_create(model, &def, NULL, &wear, why));
  for (int grown = 0; !grown;) {
    arc_wear_destroy(&ahead);
    check_ok(arc_wear_clone(wear, &ahead, why));
    check_ok(arc_wear_step(ahead, NULL, why));
    grown = arc_wear_model(ahead) != model;
    if (!grown) check_ok(arc_wear_step(wear, NULL, why));
  }
  arc_wear_destroy(&ahead);
  arc_model_release(&model);
  return wear;
}

/* Tests a run that is stopped at each call of the progress function: the run is unchanged and
 * then continues with identical results. */
static void test_stopped_while_growing(void **state) {
  (void)state;
  const arc_callbacks callbacks = {.stop = stop_when_tired, .warn = hear};
  arc_wear *wear = about_to_grow(), *untouched, *whole;
  check_ok(arc_wear_clone(wear, &untouched, why));
  check_ok(arc_wear_clone(wear, &whole, why));
  check_ok(arc_wear_step(whole, NULL, why));
  const arc_model *before = arc_wear_model(wear);
  arc_status status = ARC_STOPPED;
  warnings = 0;
  for (patience = 0; patience < 50 && status == ARC_STOPPED; patience++) {
    asked = 0;
    status = arc_wear_step(wear, &callbacks, NULL);
    if (status == ARC_OK) break;
    assert_int_equal(status, ARC_STOPPED);
    assert_ptr_equal(arc_wear_model(wear), before);
    check_same(wear, untouched);
  }
  assert_int_equal(status, ARC_OK);
  assert_true(patience >= 2);
  check_same(wear, whole);
  assert_true(arc_model_definition(arc_wear_model(wear))->mesh.zone[ARC_CYLINDER] > 0.72);
  assert_non_null(strstr(warning, "outgrows its mesh"));
  arc_wear_destroy(&wear);
  arc_wear_destroy(&untouched);
  arc_wear_destroy(&whole);
}

/* Tests that the worn surface is transferred unchanged to the larger mesh. */
static void test_grown_surface(void **state) {
  (void)state;
  arc_wear *wear = about_to_grow();
  arc_model_def md = *arc_model_definition(arc_wear_model(wear));
  const arc_wear_record last = *arc_wear_last(wear);
  md.mesh.zone[ARC_CYLINDER] = md.mesh.zone[ARC_PLATE] = 2;
  arc_model *larger = build_model(&md);
  arc_shape *shape;
  arc_contact *contact;
  check_ok(arc_shape_create(larger, ARC_MOVING, 0.05, &shape, why));
  check_ok(arc_shape_remap(arc_wear_shape(wear), shape, why));
  const arc_contact_def def = {.load = 100};
  check_ok(arc_contact_solve(shape, &def, NULL, &contact, why));
  check_near(arc_contact_get(contact).p_center, last.p_center, 0.002 * last.p_center);
  check_near(arc_shape_depth(shape, ARC_CYLINDER), last.depth_cylinder, 1e-9);
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
  arc_model_release(&larger);
  arc_wear_destroy(&wear);
}

/* Tests that an interrupted model construction returns no model and that the next construction
 * succeeds. */
static void test_model_stopped(void **state) {
  (void)state;
  arc_model_def md = arc_model_default();
  md.mesh.size = 0.005;
  md.mesh.height = 0.00625;
  arc_model *model = NULL;
  const arc_callbacks callbacks = {.stop = stop_when_tired};
  asked = patience = 0;
  check_refused(arc_model_build_with_callbacks(&md, &callbacks, &model, why), ARC_STOPPED, "model");
  assert_null(model);
  md = coarse_definition();
  patience = 1000000;
  check_ok(arc_model_build_with_callbacks(&md, &callbacks, &model, why));
  arc_model *alone = build_model(&md);
  arc_contact *one, *two;
  arc_shape *shape[2];
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape[0], why));
  check_ok(arc_shape_create(alone, ARC_MOVING, 0, &shape[1], why));
  const arc_contact_def def = {.load = 100};
  check_ok(arc_contact_solve(shape[0], &def, NULL, &one, why));
  check_ok(arc_contact_solve(shape[1], &def, NULL, &two, why));
  assert_true(arc_contact_get(one).p_center == arc_contact_get(two).p_center);
  arc_contact_destroy(&one);
  arc_contact_destroy(&two);
  for (int i = 0; i < 2; i++) arc_shape_destroy(&shape[i]);
  arc_model_release(&model);
  arc_model_release(&alone);
}

/* Tests that contacts with fewer than four elements give a warning. */
static void test_few_elements(void **state) {
  (void)state;
  const arc_callbacks callbacks = {.warn = hear};
  arc_shape *shape;
  check_ok(arc_shape_create(coarse, ARC_MOVING, 0, &shape, why));
  for (int few = 0; few < 2; few++) {
    arc_contact *contact;
    const arc_contact_def def = {.load = few ? 40 : 100};
    warnings = 0;
    check_ok(arc_contact_solve(shape, &def, &callbacks, &contact, why));
    assert_int_equal(warnings, few);
    arc_contact_destroy(&contact);
  }
  assert_non_null(strstr(warning, "fewer than 4 elements of 0.04 mm"));
  arc_shape_destroy(&shape);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_stopped_while_growing),
      cmocka_unit_test(test_grown_surface),
      cmocka_unit_test(test_model_stopped),
      cmocka_unit_test(test_few_elements),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}

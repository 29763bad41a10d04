/* Tests of the public contact functions with friction: validation of a solution, and the warning
 * for solutions that may not be unique. The validation is tested with changed internal numbers. */
#include "check.h"

#include "core/friction/friction.h"
#include "core/plane/solution.h"

static arc_contact *pressed(arc_model *model, double load, double friction,
                            const arc_callbacks *callbacks) {
  arc_shape *shape;
  arc_contact *contact;
  arc_contact_def def = arc_contact_default();
  def.load = load;
  def.friction = friction;
  check_ok(arc_shape_create(model, ARC_MOVING, 0.05, &shape, why));
  check_ok(arc_contact_solve(shape, &def, callbacks, &contact, why));
  arc_shape_destroy(&shape);
  check_ok(arc_contact_validate(contact, why));
  return contact;
}

static void test_validated(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  arc_contact *from = pressed(model, 100, 0.6, NULL), *c;
  arc_motion_def motion = arc_contact_motion(from);
  motion.x = 1.5e-3;
  check_ok(arc_contact_move(from, &motion, NULL, &c, why));
  check_ok(arc_contact_validate(c, why));
  const int middle = c->problem.active / 2, edge = 0, last = c->problem.active - 1;
  double *const numbers[] = {
      &c->workspace.t[c->problem.set[middle]], &c->workspace.slip[c->problem.set[edge]],
      &c->workspace.slip[c->problem.set[middle]], &c->workspace.slip[c->problem.set[last]]};
  const double wrong[] = {1e3, -1e-4, 1e-4, NAN};
  const char *const named[] = {"shear", "slip", "slip", "slip"};
  check_spoilt(arc_contact_validate(c, why), 4, numbers, wrong, named);
  arc_contact_destroy(&c);
  arc_contact_destroy(&from);
  arc_model_release(&model);
}

static void warned(void *context, const char *text) {
  *(int *)context += strstr(text, "Dundurs") != NULL;
}

static void test_uniqueness(void **state) {
  (void)state;
  arc_model_def def = coarse_definition();
  def.material[ARC_PLATE] = (arc_material){.E = 20e3, .nu = 0.1};
  arc_model *model = build_model(&def);
  for (int i = 0; i < 2; i++) {
    int warnings = 0;
    const arc_callbacks callbacks = {.warn = warned, .context = &warnings};
    arc_contact *contact = pressed(model, 20, i ? 1.2 : 0.3, &callbacks);
    assert_int_equal(warnings, i);
    arc_contact_destroy(&contact);
  }
  arc_model_release(&model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_validated),
      cmocka_unit_test(test_uniqueness),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

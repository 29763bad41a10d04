/* Tests of the validators: valid contacts and runs pass, and each kind of damage is detected and
 * named in the message. */
#include "runs.h"

#include "core/plane/solution.h"
#include "core/wear/run.h"

/* --- contacts --- */

static arc_contact *solved(void) {
  arc_shape *shape;
  arc_contact *contact;
  check_ok(arc_shape_create(coarse, ARC_MOVING, 0.05, &shape, why));
  check_ok(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.1}, NULL, &contact, why));
  arc_shape_destroy(&shape);
  check_ok(arc_contact_validate(contact, why));
  return contact;
}

static void test_contact(void **state) {
  (void)state;
  arc_contact *c = solved();
  double *const numbers[] = {&c->p[0][0], &c->f[1][0], &c->problem.gap[0], &c->problem.approach};
  const double wrong[] = {-1, 1, -1, 0};
  const char *const named[] = {"got -1 MPa", "forces on the plate", "at candidate 0",
                               "at candidate"};
  check_spoilt(arc_contact_validate(c, why), 4, numbers, wrong, named);
  check_ok(arc_contact_validate(c, why));
  arc_contact_destroy(&c);
}

/* --- runs --- */

static arc_status growing_k(void *context, const arc_setting *what, const arc_wear_record *state,
                            double *k) {
  (void)what;
  (void)context;
  *k = 1e-8 + 1e-10 * state->distance;
  return ARC_OK;
}

static void test_sound_runs(void **state) {
  (void)state;
  static const double strokes[] = {0.11, 0.44, 20}, alphas[] = {0, 0.5, 1};
  for (int k = 0; k < 3; k++)
    for (int kind = 0; kind < 5; kind++) {
      arc_wear_def def = quick(strokes[k], alphas[(k + kind) % 3]);
      def.scheme = kind == 1 ? ARC_IMPLICIT : ARC_EXPLICIT;
      def.slip = kind == 2 ? ARC_SLIP_TOTAL : ARC_SLIP_RIGID;
      def.geometry = kind == 3 ? ARC_FROZEN : ARC_MOVING;
      def.k_function = kind == 4 ? growing_k : NULL;
      arc_wear *wear = run(&def);
      check_ok(arc_wear_validate(wear, why));
      arc_wear_destroy(&wear);
    }
}

/* Tests the volume check for a run whose load changes between steps: each part of the run has
 * its own k L d. */
static void test_changed_run(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  arc_wear *wear = run(&def);
  def.load = 80;
  def.distance = 200;
  check_ok(arc_wear_set(wear, &def, NULL, NULL, why));
  check_ok(arc_wear_run(wear, 200, NULL, why));
  check_ok(arc_wear_validate(wear, why));
  arc_wear_destroy(&wear);
}

static void test_broken_runs(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *w = run(&def);
  arc_wear_record *last = &w->history[w->records - 1];
  const int middle = w->shape->side[0].n / 2;
  double *const numbers[] = {&last->p_max,
                             &last->distance,
                             &last->volume_cylinder,
                             &last->volume_plate,
                             &last->solutions,
                             &w->shape->side[0].h[middle],
                             &w->shape->side[1].xy[2 * middle],
                             &w->def.load};
  const double wrong[] = {NAN, 1, last->volume_cylinder * 1.001, 0, -1, -1e-3, 1, 101};
  const char *const named[] = {
      "p_max is nan",       "distance falls by 109", "from the cylinder", "volume_plate falls by",
      "solutions falls by", "depth -0.001 mm",       "in the worn plate", "k L d is"};
  check_spoilt(arc_wear_validate(w, why), 8, numbers, wrong, named);
  check_ok(arc_wear_validate(w, why));
  arc_wear_destroy(&w);
}

/* Checks that a number in the last record is reported with its name if it is NaN or smaller than
 * in the previous record. */
static void check_record(arc_wear *w, double *number, double wrong, const char *name,
                         const char *how) {
  char told[80];
  const double right = *number;
  snprintf(told, sizeof told, "history: %s %s", name, how);
  *number = wrong;
  check_refused(arc_wear_validate(w, why), ARC_NUMERIC, told);
  *number = right;
}

static void test_broken_records(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *w = run(&def);
  arc_wear_record *last = &w->history[w->records - 1];
#define BREAK(name, unit, range, rule, text) check_record(w, &last->name, NAN, #name, "is nan");
  ARC_WEAR_COLUMNS(BREAK)
#undef BREAK
  double *const growing[] = {&last->update, &last->cycle, &last->load_distance};
  static const char *const names[] = {"update", "cycle", "load_distance"};
  for (int k = 0; k < 3; k++) check_record(w, growing[k], -1, names[k], "falls by");
  check_ok(arc_wear_validate(w, why));
  arc_wear_destroy(&w);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_contact),        cmocka_unit_test(test_sound_runs),
      cmocka_unit_test(test_changed_run),    cmocka_unit_test(test_broken_runs),
      cmocka_unit_test(test_broken_records),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}

/* Tests of wear runs: volumes, procedures, integration, stability, and refused definitions. */
#include "runs.h"

/* --- volumes ---------------------------------------------------------------------------------- */

static void test_volumes(void **state) {
  (void)state;
  static const double strokes[] = {0.11, 0.22, 0.44, 20}, alphas[] = {0, 0.25, 0.5, 0.75, 1};
  for (int s = 0; s < 4; s++)
    for (int a = 0; a < 5; a++) {
      const arc_wear_def def = quick(strokes[s], alphas[a]);
      arc_wear *wear = run(&def);
      check_volumes(wear);
      assert_true(arc_wear_last(wear)->distance == 132);
      arc_wear_destroy(&wear);
      assert_null(wear);
    }
}

/* Tests that the volume in the record equals the volume of the profile, the sum of depth times
 * tributary width over the nodes. */
static void test_volume_of_profile(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.22, 0.5);
  arc_wear *wear = run(&def);
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_profile p = arc_shape_profile(arc_wear_shape(wear), (arc_body)b);
    double volume = 0;
    for (int i = 1; i + 1 < p.count; i++) volume += p.h[i] * (p.x[i + 1] - p.x[i - 1]) / 2;
    check_share(volume, def.k * def.load * def.distance / 2, 1e-4);
  }
  arc_wear_destroy(&wear);
}

/* Tests a model with a thickness: load and volume refer to the whole thickness, and the depths
 * equal the depths under the load per mm. */
static void test_thickness(void **state) {
  (void)state;
  arc_model_def md = *arc_model_definition(coarse);
  md.thickness = 4;
  arc_model *thick = build_model(&md);
  arc_wear_def def = quick(0.11, 0.5);
  arc_wear *thin = run(&def), *wide = NULL;
  def.load *= 4;
  check_ok(arc_wear_create(thick, &def, NULL, &wide, why));
  check_ok(arc_wear_run(wide, def.distance, NULL, why));
  check_volumes(wide);
  check_share(arc_wear_last(wide)->depth_cylinder, arc_wear_last(thin)->depth_cylinder, 1e-12);
  check_share(arc_wear_last(wide)->p_center, arc_wear_last(thin)->p_center, 1e-12);
  arc_wear_destroy(&thin);
  arc_wear_destroy(&wide);
  arc_model_release(&thick);
}

/* --- procedures ------------------------------------------------------------------------------- */

static void test_choice(void **state) {
  (void)state;
  static const struct {
    double stroke, alpha;
    arc_procedure procedure;
    double strokes;
  } expected[] = {{0.11, 0.5, ARC_SP, 2}, {0.11, 0, ARC_SP, 2}, {0.11, 1, ARC_NSP, 2},
                  {20, 0.5, ARC_NSP, 1},  {20, 0, ARC_NSP, 1},  {20, 1, ARC_NSP, 1},
                  {0.44, 0.99, ARC_SP, 2}};
  for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
    const arc_wear_def def = quick(expected[k].stroke, expected[k].alpha);
    arc_wear *wear = start(&def);
    assert_int_equal(arc_wear_procedure(wear), expected[k].procedure);
    assert_true(arc_wear_strokes(wear) == expected[k].strokes);
    check_share(arc_wear_cycles(wear), 132 / (expected[k].strokes * expected[k].stroke), 1e-12);
    arc_wear_destroy(&wear);
  }
}

/* Tests a stroke of 2R against Eq. (27) of the reference paper: the plate wears by (1 - alpha) k
 * L in each pass. */
static void test_plate_under_long_strokes(void **state) {
  (void)state;
  arc_wear_def def = quick(20, 0.25);
  def.distance = 1320;
  arc_wear *wear = run(&def);
  const arc_profile plate = arc_shape_profile(arc_wear_shape(wear), ARC_PLATE);
  for (int i = 0; i < plate.count; i++) check_near(plate.h[i], 0.0495e-3, 1e-12);
  assert_true(arc_wear_last(wear)->cycle == 66);
  arc_wear_destroy(&wear);
}

/* Tests that alpha = 0 with a stroke of 2R uses the Hertz pressure without any contact solution. */
static void test_hertz_forever(void **state) {
  (void)state;
  arc_wear_def def = quick(20, 0);
  arc_wear *wear = run(&def);
  const arc_wear_record *last = arc_wear_last(wear);
  check_near(last->p_center, 591.431, 5e-4);
  check_near(last->half_width, 0.107641, 5e-7);
  assert_true(last->depth_cylinder == 0 && last->solutions == 0);
  assert_true(last->depth_partition == 0);
  arc_wear_destroy(&wear);
}

/* Tests alpha = 1: sliding of the plate changes the results only slightly, by the positions of the
 * plate's nodes. */
static void test_forced_sliding(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 1);
  arc_wear *still = run(&def);
  def.procedure = ARC_SP;
  arc_wear *slides = run(&def);
  assert_int_equal(arc_wear_procedure(slides), ARC_SP);
  check_volumes(slides);
  check_share(arc_wear_last(slides)->depth_cylinder, arc_wear_last(still)->depth_cylinder, 0.01);
  check_share(arc_wear_last(slides)->p_center, arc_wear_last(still)->p_center, 0.01);
  assert_true(arc_wear_last(slides)->depth_plate == 0);
  arc_wear_destroy(&still);
  arc_wear_destroy(&slides);
}

/* Tests that for alpha = 1 the wear depends only on the distance, not on the stroke. */
static void test_one_cylinder(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 1);
  arc_wear *first = run(&def);
  def = quick(0.44, 1);
  arc_wear *second = run(&def);
  check_share(arc_wear_last(second)->depth_cylinder, arc_wear_last(first)->depth_cylinder, 1e-9);
  check_share(arc_wear_last(second)->p_center, arc_wear_last(first)->p_center, 1e-9);
  arc_wear_destroy(&first);
  arc_wear_destroy(&second);
}

/* --- integration ------------------------------------------------------------------------------ */

/* Tests the simple integration rule, Eq. (5) of the reference paper: it gives the same volume
 * and a slightly shifted plate profile. The shift decreases with the number of increments. */
static void test_simple_rule(void **state) {
  (void)state;
  double apart[2];
  for (int k = 0; k < 2; k++) {
    arc_wear_def def = quick(0.22, 0.5);
    def.increments = k ? 80 : 20;
    arc_wear *trapezoid = run(&def);
    def.rule = ARC_SIMPLE;
    arc_wear *simple = run(&def);
    check_volumes(simple);
    const arc_profile p = arc_shape_profile(arc_wear_shape(trapezoid), ARC_PLATE);
    const arc_profile q = arc_shape_profile(arc_wear_shape(simple), ARC_PLATE);
    apart[k] = 0;
    for (int i = 0; i < p.count; i++)
      apart[k] = fmax(apart[k], fabs(p.h[i] - q.h[i]) / arc_wear_last(simple)->depth_plate);
    arc_wear_destroy(&trapezoid);
    arc_wear_destroy(&simple);
  }
  assert_true(apart[0] > 0.001);
  check_below(apart[0], 0.1);
  check_below(apart[1], 0.4 * apart[0]);
}

/* Tests that the elastic part of the slip, Eq. (25) of the reference paper, is small but not
 * zero. */
static void test_total_slip(void **state) {
  (void)state;
  arc_wear_def def = quick(0.22, 0.5);
  arc_wear *rigid = run(&def);
  def.slip = ARC_SLIP_TOTAL;
  arc_wear *total = run(&def);
  const arc_wear_record *r = arc_wear_last(rigid), *t = arc_wear_last(total);
  assert_true(r->volume_cylinder != t->volume_cylinder);
  check_share(t->volume_cylinder, r->volume_cylinder, 0.02);
  check_share(t->volume_plate, r->volume_plate, 0.02);
  check_share(t->depth_cylinder, r->depth_cylinder, 0.02);
  arc_wear_destroy(&rigid);
  arc_wear_destroy(&total);
}

static void test_frozen(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  def.distance = 660;
  arc_wear *moving = run(&def);
  def.geometry = ARC_FROZEN;
  arc_wear *frozen = run(&def);
  check_volumes(frozen);
  const arc_wear_record *m = arc_wear_last(moving), *f = arc_wear_last(frozen);
  assert_true(m->p_center != f->p_center);
  check_share(f->depth_cylinder, m->depth_cylinder, 2e-3);
  check_share(f->depth_plate, m->depth_plate, 2e-3);
  check_share(f->p_center, m->p_center, 2e-3);
  arc_wear_destroy(&moving);
  arc_wear_destroy(&frozen);
}

/* Tests the effect of the step length: shorter steps change the depth little, and steps of half
 * the length change it half as much (first order). */
static void test_step_size(void **state) {
  (void)state;
  double depth[3];
  for (int k = 0; k < 3; k++) {
    arc_wear_def def = quick(0.11, 0.5);
    def.jump = 100 / (1 << k);
    arc_wear *wear = run(&def);
    depth[k] = arc_wear_last(wear)->depth_cylinder;
    arc_wear_destroy(&wear);
  }
  const double order = (depth[1] - depth[0]) / (depth[2] - depth[1]);
  print_message("# halving the jump shrinks its error by %.2f\n", order);
  assert_true(order > 1.6 && order < 2.6);
}

static void test_symmetric(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.22, 0.25);
  arc_wear *wear = run(&def);
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_profile p = arc_shape_profile(arc_wear_shape(wear), (arc_body)b);
    const double most = arc_shape_depth(arc_wear_shape(wear), (arc_body)b);
    for (int i = 0; i < p.count; i++) check_near(p.h[i], p.h[p.count - 1 - i], 1e-9 * most);
  }
  arc_wear_destroy(&wear);
}

/* --- stability and roughness ------------------------------------------------------------------ */

/* Tests that the eigenvalue gives the limit of explicit steps: surfaces are smooth below and
 * rough above the limit, and a run ends with an error before its pressures become meaningless. */
static void test_stability(void **state) {
  (void)state;
  arc_model *model = default_model();
  arc_wear_def def = arc_wear_default();
  def.geometry = ARC_FROZEN;
  arc_wear *wear = NULL;
  check_ok(arc_wear_create(model, &def, NULL, &wear, why));
  double eigenvalue = 0;
  arc_error error = {0};
  check_ok(arc_wear_stability(wear, NULL, &eigenvalue, why));
  arc_wear_destroy(&wear);
  for (int k = 0; k < 2; k++) {
    def.jump = (k ? 1.3 : 0.9) * 2 / eigenvalue;
    check_ok(arc_wear_create(model, &def, NULL, &wear, why));
    const arc_status status = arc_wear_run(wear, def.distance, NULL, &error);
    assert_int_equal(status, k ? ARC_NOT_CONVERGED : ARC_OK);
    const arc_wear_record *last = arc_wear_last(wear);
    const double rough =
        fmax(arc_wear_roughness(wear, ARC_CYLINDER), arc_wear_roughness(wear, ARC_PLATE));
    print_message("# jump = %.1f: roughness %.2g, to %g mm\n", def.jump, rough, last->distance);
    if (k == 0) check_below(rough, 1e-4);
    if (k == 1) assert_non_null(strstr(error.message, "ripples: pressures of neighbouring nodes"));
    if (k == 1) assert_true(last->distance > 0 && last->p_max < 2 * last->p_center);
    arc_wear_destroy(&wear);
  }
  arc_model_release(&model);
}

/* Tests that computing the stability limit does not change the run, which continues with
 * identical bits. */
static void test_stability_is_a_question(void **state) {
  (void)state;
  const arc_wear_def def = quick(0.11, 0.5);
  arc_wear *whole = run(&def), *wear = start(&def);
  double eigenvalue;
  while (arc_wear_last(wear)->distance < def.distance) {
    check_ok(arc_wear_stability(wear, NULL, &eigenvalue, why));
    check_ok(arc_wear_step(wear, NULL, why));
  }
  check_same(wear, whole);
  arc_wear_destroy(&whole);
  arc_wear_destroy(&wear);
}

static int warnings;
static char warning[600];

static void hear(void *context, const char *text) {
  (void)context;
  warnings++;
  snprintf(warning, sizeof warning, "%s", text);
}

/* Tests that increments that are too long give a warning, which names a sufficient number of
 * increments. */
static void test_leaps(void **state) {
  (void)state;
  static const arc_callbacks callbacks = {.warn = hear};
  static const double x[] = {-0.055, 0.055, -0.055}, load[] = {100, 100, 100};
  const arc_loading ends = {.count = 3, .x = x, .load = load, .cycles = INFINITY, .periodic = 1};
  const arc_loading once = {.count = 3, .x = x, .load = load, .cycles = 1};
  arc_wear_def def = quick(0.44, 0.5);
  for (int k = 0; k < 5; k++) {
    if (k == 1) def.increments = 0; /* "auto": the number of increments follows the contact width */
    if (k > 1) def.blocks = 1, def.loading = k == 4 ? &once : &ends, def.jump = 1;
    if (k == 3) def.increments = 2;
    if (k == 4)
      def.increments = 0, def.jump = 1e6,
      def.distance = 0; /* the jump is not used for a loading that runs once */
    if (k == 0) def.increments = 8;
    arc_wear *wear = start(&def);
    warnings = 0;
    check_ok(arc_wear_step(wear, &callbacks, why));
    assert_int_equal(warnings, k == 0 || k == 3);
    if (k == 0) assert_non_null(strstr(warning, "use 66, or \"auto\""));
    if (k == 3) assert_non_null(strstr(warning, "9 times as many points"));
    arc_wear_destroy(&wear);
  }
}

/* Tests a jump above the stability limit: each definition gives one warning, before the first step,
 * and the results are unchanged. */
static void test_warnings(void **state) {
  (void)state;
  static const arc_callbacks callbacks = {.warn = hear};
  arc_wear_def def = quick(0.11, 0.5);
  double eigenvalue;
  arc_wear *wear = start(&def);
  check_ok(arc_wear_stability(wear, NULL, &eigenvalue, why));
  arc_wear_destroy(&wear);
  def.jump = 1.01 * 2 / eigenvalue;
  def.distance = 1.5 * def.jump * 2 * def.stroke;
  arc_wear *whole = run(&def);
  wear = start(&def);
  warnings = 0;
  check_ok(arc_wear_step(wear, &callbacks, why));
  assert_int_equal(warnings, 1);
  assert_non_null(strstr(warning, "past the stability limit"));
  check_ok(arc_wear_step(wear, &callbacks, why));
  check_ok(arc_wear_run(wear, def.distance, &callbacks, why));
  assert_int_equal(warnings, 1);
  check_same(wear, whole);
  def.distance *= 2;
  check_ok(arc_wear_set(wear, &def, NULL, NULL, why));
  arc_error ripples;
  assert_int_equal(arc_wear_step(wear, &callbacks, &ripples), ARC_NOT_CONVERGED);
  assert_int_equal(warnings, 2);
  def.jump /= 1.2;
  check_ok(arc_wear_set(wear, &def, NULL, NULL, why));
  check_ok(arc_wear_step(wear, &callbacks, why));
  assert_int_equal(warnings, 2);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&whole);
}

/* --- refusals --------------------------------------------------------------------------------- */

static void refuse(const arc_wear_def *def, arc_status status, const char *part) {
  arc_wear *wear = (arc_wear *)coarse;
  check_refused(arc_wear_create(coarse, def, NULL, &wear, why), status, part);
  assert_null(wear);
}

static void test_refused_numbers(void **state) {
  (void)state;
  static const double bad[] = {-1, NAN, INFINITY, 0};
  for (int k = 0; k < 4; k++) {
    arc_wear_def def = arc_wear_default();
    def.load = bad[k];
    refuse(&def, ARC_ARGUMENT, "'load'");
    def = arc_wear_default();
    def.stroke = bad[k];
    refuse(&def, ARC_ARGUMENT, "'stroke'");
    def = arc_wear_default();
    def.distance = bad[k];
    refuse(&def, ARC_ARGUMENT, "'distance'");
    if (bad[k] == 0) continue; /* skipped because 0 is a valid jump: "auto" */
    def = arc_wear_default();
    def.jump = bad[k];
    refuse(&def, ARC_ARGUMENT, "'jump'");
    def = arc_wear_default();
    def.k = bad[k];
    refuse(&def, ARC_ARGUMENT, "'k'");
    def = arc_wear_default();
    def.alpha = bad[k];
    refuse(&def, ARC_ARGUMENT, "'alpha'");
  }
  arc_wear_def def = arc_wear_default();
  def.alpha = 1.0000001;
  refuse(&def, ARC_ARGUMENT, "'alpha'");
  def = arc_wear_default();
  def.refresh = NAN;
  refuse(&def, ARC_ARGUMENT, "'refresh'");
}

static void test_refused_combinations(void **state) {
  (void)state;
  static const int odd[] = {-4, -2, 1, 3, 101};
  for (int k = 0; k < 5; k++) {
    arc_wear_def def = arc_wear_default();
    def.increments = odd[k];
    refuse(&def, ARC_ARGUMENT, "'increments'");
  }
  arc_wear_def def = arc_wear_default();
  def.procedure = ARC_NSP;
  refuse(&def, ARC_ARGUMENT, "'procedure'");
  def = arc_wear_default();
  def.stroke = 20.1;
  refuse(&def, ARC_ARGUMENT, "'stroke'");
  def = arc_wear_default();
  def.load = 5000;
  refuse(&def, ARC_ZONE, "zone");
}

/* Tests that a stroke too long for the plate's zone is refused with a message that names the
 * required zone, and that this zone is sufficient. */
static void test_zone(void **state) {
  (void)state;
  arc_wear_def def = quick(2, 0.5);
  refuse(&def, ARC_ZONE, "mesh.zone");
  arc_model_def md = *arc_model_definition(coarse);
  arc_wear_zones(&def, &md, md.mesh.zone);
  assert_true(md.mesh.zone[ARC_PLATE] > 2.2);
  arc_model *wide = build_model(&md);
  arc_wear *wear = NULL;
  check_ok(arc_wear_create(wide, &def, NULL, &wear, why));
  check_ok(arc_wear_run(wear, def.distance, NULL, why));
  check_volumes(wear);
  arc_wear_destroy(&wear);
  arc_model_release(&wide);
}

/* Tests that the computed zones of a run are large enough for its contact, with much and with
 * little wear. */
static void test_zones_are_enough(void **state) {
  (void)state;
  random_start(51);
  for (int trial = 0; trial < 15; trial++) {
    arc_model_def md = arc_model_default();
    arc_wear_def def = arc_wear_default();
    arc_hertz hertz = {0};
    md.radius = random_in(10, 50);
    def.load = md.radius * random_in(20, 200);
    check_ok(arc_hertz_solve(md.radius, 1, def.load, md.material, &hertz, why));
    md.mesh.size = md.mesh.height = hertz.half_width / 4;
    md.mesh.far = md.radius / 5;
    def.stroke = hertz.half_width * random_in(0.3, 4);
    def.alpha = random_int(0, 4) / 4.0;
    def.increments = 10;
    def.jump = def.distance / (2 * def.stroke) / 20;
    /* little wear, or wear to a scar of up to three times the initial half width */
    const double scar = hertz.half_width * random_in(0, trial % 2 ? 3 : 0.2);
    def.k = pow(scar, 3) / (1.5 * md.radius * def.load * def.distance);
    arc_wear_zones(&def, &md, md.mesh.zone);
    for (int b = 0; b < ARC_BODIES; b++) md.mesh.zone[b] = fmin(md.mesh.zone[b], 1.6 * md.radius);
    arc_model *model = build_model(&md);
    arc_wear *wear = NULL;
    def.scheme = ARC_IMPLICIT; /* explicit steps would make the surfaces rough with so few steps */
    check_ok(arc_wear_create(model, &def, NULL, &wear, why));
    check_ok(arc_wear_run(wear, def.distance, NULL, why));
    check_volumes(wear);
    arc_wear_destroy(&wear);
    arc_model_release(&model);
  }
}

/* Tests that a run with k = 0 has no wear. */
static void test_no_wear(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  def.k = 0;
  arc_wear *wear = run(&def);
  const arc_wear_record *last = arc_wear_last(wear);
  assert_true(last->depth_cylinder == 0 && last->volume_plate == 0 && last->distance == 132);
  size_t count;
  assert_true(last->p_center == arc_wear_history(wear, &count)[0].p_center);
  arc_wear_destroy(&wear);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_volumes),
      cmocka_unit_test(test_volume_of_profile),
      cmocka_unit_test(test_thickness),
      cmocka_unit_test(test_choice),
      cmocka_unit_test(test_plate_under_long_strokes),
      cmocka_unit_test(test_hertz_forever),
      cmocka_unit_test(test_forced_sliding),
      cmocka_unit_test(test_one_cylinder),
      cmocka_unit_test(test_simple_rule),
      cmocka_unit_test(test_total_slip),
      cmocka_unit_test(test_frozen),
      cmocka_unit_test(test_step_size),
      cmocka_unit_test(test_symmetric),
      cmocka_unit_test(test_stability),
      cmocka_unit_test(test_stability_is_a_question),
      cmocka_unit_test(test_warnings),
      cmocka_unit_test(test_leaps),
      cmocka_unit_test(test_refused_numbers),
      cmocka_unit_test(test_refused_combinations),
      cmocka_unit_test(test_zone),
      cmocka_unit_test(test_zones_are_enough),
      cmocka_unit_test(test_no_wear),
  };
  return cmocka_run_group_tests_name("wear", tests, set_up, tear_down);
}

/* Tests of contact in three dimensions against closed forms, reference solutions of an
 * independent program, and the complementarity conditions. */
#include "space_shared.h"

static const double pi = 3.14159265358979323846;

/* --- half-spaces ------------------------------------------------------------------------------ */

/* Tests a ball of R = 10 mm under 10 N against Hertz theory: half width a = 0.0880442 mm, p0 =
 * 615.942 MPa, approach 7.75179e-4 mm. */
static void test_ball(void **state) {
  (void)state;
  const arc_halfspace_def def = ball(10, 0.0880442 / 23, 57);
  solved s = solve_space(&def, 10, 1e-6);
  check_share(s.extent.center, 615.942, 3e-4);
  check_share(s.approach, 7.75179e-4, 2e-4);
  check_share(s.extent.half_width, 0.0880442, 3e-3);
  check_share(s.extent.half_width_z, s.extent.half_width, 1e-6);
  check_share(s.extent.area, pi * 0.0880442 * 0.0880442, 0.02);
  check_near(s.extent.center_x, 0, 1e-9);
  free_solved(&s);
}

/* Tests that the error of the approach decreases with the cell size, although cells approximate
 * the edge of the contact by a staircase. */
static void test_order(void **state) {
  (void)state;
  double error[3];
  for (int k = 0; k < 3; k++) {
    const int n = (8 << k) * 5 / 2 + 1;
    const arc_halfspace_def def = ball(10, 0.0880442 / (8 << k), n);
    solved s = solve_space(&def, 10, 1e-7);
    error[k] = fabs(s.approach - 7.7517875e-4);
    free_solved(&s);
  }
  assert_true(error[1] < error[0] / 2 && error[2] < error[0] / 6);
  check_below(error[2], 7.75e-4 * 1.5e-4);
}

/* Tests an ellipsoid against Hertz theory: half widths a = 0.0683891 mm and b = 0.171021 mm, p0
 * = 816.46 MPa, approach 1.19891e-3 mm. */
static void test_ellipse(void **state) {
  (void)state;
  arc_halfspace_def def = ball(5, 0.006, 31);
  def.body[ARC_UPPER].radius_z = 20;
  def.nz = 71;
  solved s = solve_space(&def, 20, 1e-6);
  check_share(s.extent.center, 816.56, 5e-5); /* value of an independent program on this grid */
  check_share(s.approach, 1.19867e-3, 1e-5);
  check_share(s.extent.half_width, 0.0683891, 0.015);
  check_share(s.extent.half_width_z, 0.171021, 0.01);
  free_solved(&s);
}

static void test_hertz_ellipse(void **state) {
  (void)state;
  arc_hertz_ellipse e;
  check_ok(arc_hertz_ellipse_of(5, 20, steel_modulus, 20, &e, why));
  check_share(e.half_width, 0.0683891, 1e-6);
  check_share(e.half_width_z, 0.171021, 2e-6);
  check_share(e.p_max, 816.46, 1e-6);
  check_share(e.approach, 1.19891e-3, 3e-6);
  check_ok(arc_hertz_ellipse_of(12, 4, steel_modulus, 30, &e, why));
  check_share(e.half_width, 0.159133, 3e-6);
  check_share(e.half_width_z, 0.0768018, 1e-6);
  check_share(e.approach, 1.79245e-3, 3e-6);
  check_ok(arc_hertz_ellipse_of(10, 10, steel_modulus, 10, &e, why));
  check_share(e.half_width, 0.0880442, 1e-6);
  check_share(e.approach, 7.75179e-4, 1e-6);
  check_ok(arc_hertz_ellipse_of(10, 10.00001, steel_modulus, 10, &e, why));
  check_share(e.half_width, 0.0880442, 2e-6);
  check_refused(arc_hertz_ellipse_of(10, -1, 1, 1, &e, why), ARC_ARGUMENT, "radius_z");
}

static double cone_recess(void *context, double x, double z) {
  return *(double *)context * hypot(x, z);
}

/* Tests a cone of slope t against its closed form: approach pi a t / 2 with a = sqrt(2 P / (pi
 * E* t)). */
static void test_cone(void **state) {
  (void)state;
  double slope = 0.01;
  const double a = sqrt(2 * 10 / (pi * steel_modulus * slope));
  arc_halfspace_def def = ball(0, a * 2.2 / 81, 81);
  def.body[ARC_UPPER].recess = cone_recess;
  def.body[ARC_UPPER].context = &slope;
  solved s = solve_space(&def, 10, 1e-6);
  check_share(s.approach, pi / 2 * a * slope, 1e-4);
  check_share(s.extent.half_width, a, 3e-3);
  const int i = (int)lround(a / 2 / def.size_x) + 40;
  const double r = (i - 40) * def.size_x;
  check_share(s.p[i * 81 + 40], steel_modulus * slope / 2 * acosh(a / r), 2e-3);
  free_solved(&s);
}

static double punch_recess(void *context, double x, double z) {
  return hypot(x, z) <= *(double *)context ? 0 : 1;
}

/* Tests a flat punch of radius c against the closed form of the approach, P / (2 E* c) = 1.82e-3
 * mm. The computed approach converges from above with first order because cells approximate the
 * edge by a staircase. */
static void test_punch(void **state) {
  (void)state;
  static const double computed[2] = {1.83020e-3, 1.82612e-3};
  double c = 0.25;
  for (int k = 0; k < 2; k++) {
    const int n = k ? 81 : 41;
    arc_halfspace_def def = ball(0, 2.2 * c / n, n);
    def.body[ARC_UPPER].recess = punch_recess;
    def.body[ARC_UPPER].context = &c;
    solved s = solve_space(&def, 100, 1e-6);
    check_share(s.approach, computed[k], 1e-5);
    free_solved(&s);
  }
}

/* --- contacts of layers and of periodic surfaces ---------------------------------------------- */

/* Tests a rigid ball on a layer that is bonded to a rigid base: p0, contact radius and approach
 * against an independent program. */
static void test_layers(void **state) {
  (void)state;
  static const double row[3][5] = {{0.3, 1, 29.190, 0.4059, 0.012998},
                                   {0.3, 0.1, 64.59, 0.2994, 4.887e-3},
                                   {0.45, 1, 31.985, 0.3875, 0.011474}};
  for (int k = 0; k < 3; k++) {
    arc_halfspace_def def = ball(10, 1.1 / 81, 81);
    def.body[ARC_UPPER].material = (arc_material){.E = 1e13, .nu = 0.3};
    def.body[ARC_LOWER].material = (arc_material){.E = 1000, .nu = row[k][0]};
    def.body[ARC_LOWER].depth = row[k][1];
    solved s = solve_space(&def, 10, 1e-6);
    check_share(s.extent.center, row[k][2], 5e-4);
    check_share(sqrt(s.extent.area / pi), row[k][3], 5e-3);
    check_share(s.approach, row[k][4], 1e-4);
    free_solved(&s);
  }
}

/* Tests the recommended cell sizes for a ball on a half-space and on layers: cells of about an
 * eighth of the contact's half width. */
static void test_fit(void **state) {
  (void)state;
  static const double thickness[3] = {0, 1, 0.1}, half_width[3] = {0.0880442, 0.4059, 0.2994};
  for (int k = 0; k < 3; k++) {
    arc_halfspace_def def = ball(10, 1, 8);
    if (k > 0) {
      def.body[ARC_UPPER].material = (arc_material){.E = 1e13, .nu = 0.3};
      def.body[ARC_LOWER].material = (arc_material){.E = 1000, .nu = 0.3};
      def.body[ARC_LOWER].depth = thickness[k];
    }
    arc_halfspace_fit(&def, 10, 0, 0.5, 0, 8);
    check_share(def.size_x, half_width[k] / 8, 0.2);
    assert_true(def.nx * def.size_x > 2 * half_width[k] && def.nx % 2 == 1);
    assert_true((def.track - def.nx) * def.size_x >= 0.5 - 1e-9);
    arc_halfspace_fit(&def, 10, 0, 0.5, 0.05, 8);
    check_near(0.05 / def.size_x, round(0.05 / def.size_x), 1e-9);
  }
}

/* Tests two layers: a layer with the material of the base does not change the contact, and a
 * thin coating changes it little. */
static void test_coats(void **state) {
  (void)state;
  arc_halfspace_def def = ball(10, 0.0880442 / 10, 31);
  solved plain = solve_space(&def, 10, 1e-6);
  def.body[ARC_LOWER].layer[0] = (arc_layer){.thickness = 0.05, .material = def.body[0].material};
  solved same = solve_space(&def, 10, 1e-6);
  check_share(same.extent.center, plain.extent.center, 1e-5);
  check_share(same.approach, plain.approach, 1e-5);
  def.body[ARC_LOWER].layer[0].thickness = 0.003;
  def.body[ARC_LOWER].layer[0].material.E = 400e3;
  solved coated = solve_space(&def, 10, 1e-6);
  assert_true(coated.approach < plain.approach);
  check_share(coated.approach, plain.approach, 0.03);
  free_solved(&plain);
  free_solved(&same);
  free_solved(&coated);
}

static double wave_recess(void *context, double x, double z) {
  const double *w = context, q = 2 * pi / 0.1, shift = w[1];
  return w[0] * (1 - cos(q * (x + shift)) * cos(q * (z + shift)));
}

/* Tests waves of amplitude D and length l = 0.1 mm in both directions. The mean pressure for full
 * contact is p* = sqrt(2) pi E* D / l. The ratios of the contact area to the whole area are
 * compared with an independent program whose first cell is on a crest. */
static void test_waves(void **state) {
  (void)state;
  static const double share[6] = {.1, .2, .4, .6, .8, .9};
  static const double contact[6] = {.19397, .341431, .622437, .778198, .898804, .952026};
  double wave[2] = {1e-4, 0.05 / 128};
  const double full = sqrt(2) * pi * steel_modulus * wave[0] / 0.1;
  for (int k = 0; k < 6; k++) {
    arc_halfspace_def def = ball(0, 0.1 / 128, 128);
    def.body[ARC_UPPER].recess = wave_recess;
    def.body[ARC_UPPER].context = wave;
    def.periodic = 1;
    solved s = solve_space(&def, share[k] * full * 0.01, 1e-6);
    check_near(s.extent.area / 0.01, contact[k], 1e-3);
    const arc_halfspace_position aside = {.x = 0.01, .load = 1};
    check_refused(arc_halfspace_solve(s.h, NULL, &aside, NULL, s.p, &s.approach, NULL, why),
                  ARC_ARGUMENT, "periodic");
    free_solved(&s);
  }
}

/* Tests waves pressed to full contact: the pressure is the mean pressure plus a wave of the same
 * length. */
static void test_full_contact(void **state) {
  (void)state;
  double wave[2] = {1e-4, 0.05 / 64};
  const double full = sqrt(2) * pi * steel_modulus * wave[0] / 0.1;
  arc_halfspace_def def = ball(0, 0.1 / 64, 64);
  def.body[ARC_UPPER].recess = wave_recess;
  def.body[ARC_UPPER].context = wave;
  def.periodic = 1;
  solved s = solve_space(&def, 1.1 * full * 0.01, 1e-8);
  check_share(s.report.p_max, 2.1 * full, 1e-6);
  free_solved(&s);
}

/* --- random pairs ----------------------------------------------------------------------------- */

static double rough_recess(void *context, double x, double z) {
  const double *w = context;
  double y = 0;
  for (int k = 0; k < 12; k++)
    y += w[4 * k] * cos(w[4 * k + 1] * x + w[4 * k + 2] * z + w[4 * k + 3]);
  return y;
}

/* Checks the gaps and pressures of a solution for complementarity: no negative pressure, no
 * overlap, and no pressure across an open gap. */
static void check_complementary(const solved *s, double load, double x, double tolerance) {
  const arc_halfspace_def *d = arc_halfspace_definition(s->h);
  const int n = d->nx * d->nz;
  double *gap = make_values((size_t)n), overlap = 0, open = 0, size = s->approach;
  const arc_halfspace_position at = {.x = x, .load = load};
  check_ok(arc_halfspace_gaps(s->h, NULL, &at, s->p, s->approach, gap, why));
  for (int k = 0; k < n; k++) {
    assert_true(s->p[k] >= 0);
    overlap = fmax(overlap, -gap[k]);
    if (s->p[k] > 0) open = fmax(open, gap[k]);
  }
  for (int k = 0; k < n; k++)
    size = fmax(size, fabs(s->approach - arc_halfspace_recess(s->h, ARC_UPPER)[k] -
                           arc_halfspace_recess(s->h, ARC_LOWER)[k]) *
                          (s->p[k] > 0));
  check_below(overlap, tolerance * size);
  check_below(open, tolerance * size);
  free(gap);
}

static arc_halfspace_def random_pair(double waves[48], double *load) {
  const double rx = exp(random_in(log(0.5), log(500))), ratio = exp(random_in(-2, 2));
  arc_halfspace_def def = ball(rx, 0.01, 8);
  def.body[ARC_UPPER].radius_z = rx * ratio;
  def.body[ARC_UPPER].material.E = 200e3 * exp(random_in(-3.5, 3.5));
  def.body[ARC_LOWER].material.E = 200e3 * exp(random_in(-3.5, 3.5));
  def.body[ARC_LOWER].material.nu = random_in(0, 0.49);
  *load = exp(random_in(log(0.1), log(100)));
  arc_halfspace_fit(&def, *load, 0, 0, 0, random_in(5, 14));
  def.nx = def.nx * 5 / 3;
  def.nz = def.nz * 5 / 3;
  def.track = 0;
  if (random_int(0, 2) == 0) {
    def.body[ARC_LOWER].layer[0].material =
        (arc_material){.E = 200e3 * exp(random_in(-2, 2)), .nu = 0.3};
    def.body[ARC_LOWER].layer[0].thickness = def.size_x * exp(random_in(-1, 5));
    if (random_int(0, 1))
      def.body[ARC_LOWER].depth = def.body[ARC_LOWER].layer[0].thickness * random_in(1.1, 10);
  }
  if (random_int(0, 1)) {
    const double length = def.nx * def.size_x, rms = exp(random_in(log(1e-6), log(3e-4)));
    for (int k = 0; k < 12; k++) {
      waves[4 * k] = rms * random_in(0, 1);
      waves[4 * k + 1] = 2 * pi * random_in(-12, 12) / length;
      waves[4 * k + 2] = 2 * pi * random_in(-12, 12) / length;
      waves[4 * k + 3] = random_in(0, 6.3);
    }
    def.body[random_int(0, 1)].recess = rough_recess;
    def.body[ARC_UPPER].context = def.body[ARC_LOWER].context = waves;
  }
  return def;
}

/* Tests the complementarity conditions for random pairs of bodies. ARCHARD_PAIRS sets the number
 * of pairs (default 300). */
static void test_random_pairs(void **state) {
  (void)state;
  const char *wish = getenv("ARCHARD_PAIRS");
  const int pairs = wish ? atoi(wish) : 300;
  int most = 0, guarded = 0, wider = 0;
  long all = 0;
  random_start(20260);
  for (int k = 0; k < pairs; k++) {
    double waves[48], load;
    arc_halfspace_def def = random_pair(waves, &load);
    const arc_halfspace_position at = {.load = load};
    const arc_halfspace_options options = {.tolerance = 1e-7};
    solved s = {0};
    for (int tries = 0; tries < 4 && !s.p; tries++) {
      arc_error error = {ARC_OK, ""};
      s.h = make_space(&def);
      s.p = make_values((size_t)(def.nx * def.nz));
      const arc_status status =
          arc_halfspace_solve(s.h, NULL, &at, &options, s.p, &s.approach, &s.report, &error);
      if (status == ARC_OK) break;
      if (status != ARC_ZONE) fail_msg("pair %d: %s", k, error.message);
      free_solved(&s);
      def.nx += def.nx / 2;
      def.nz += def.nz / 2;
      wider++;
    }
    if (!s.p) fail_msg("pair %d: the contact does not fit in its window", k);
    check_complementary(&s, load, 0, 1e-6);
    check_share(sum_of(s.p, def.nx * def.nz) * def.size_x * def.size_z, load, 1e-12);
    most = s.report.applications > most ? s.report.applications : most;
    all += s.report.applications;
    guarded += s.report.guarded > 0;
    free_solved(&s);
  }
  print_message(
      "# %d pairs: %.1f applications on average, %d at most; %d guarded, %d windows widened\n",
      pairs, (double)all / pairs, most, guarded, wider);
}

/* refused input */

static void test_refused(void **state) {
  (void)state;
  arc_halfspace *h = NULL;
  arc_halfspace_def def = ball(10, 0.01, 31);
  def.size_x = 0;
  check_refused(arc_halfspace_create(&def, &h, why), ARC_ARGUMENT, "size_x");
  assert_null(h);
  def = ball(10, 0.01, 4);
  check_refused(arc_halfspace_create(&def, &h, why), ARC_ARGUMENT, "nx");
  def = ball(10, 0.01, 31);
  def.track = 36;
  check_refused(arc_halfspace_create(&def, &h, why), ARC_ARGUMENT, "track");
  def.track = 0;
  def.body[ARC_LOWER].layer[0] = (arc_layer){.thickness = 0.002, .material = def.body[0].material};
  check_refused(arc_halfspace_create(&def, &h, why), ARC_GEOMETRY, "layer");
  def = ball(10, 0.01, 31);
  def.body[ARC_UPPER].material.nu = 0.7;
  check_refused(arc_halfspace_create(&def, &h, why), ARC_ARGUMENT, "nu");
  def = ball(10, 0.01, 31);
  def.periodic = 1;
  check_refused(arc_halfspace_create(&def, &h, why), ARC_ARGUMENT, "periodic");
}

static int stop_at_once(void *context) {
  (void)context;
  return 1;
}

/* Tests that a failed call leaves the caller's arrays unchanged. */
static void test_failures(void **state) {
  (void)state;
  const arc_halfspace_def def = ball(10, 0.01, 15);
  arc_halfspace *h = make_space(&def);
  arc_halfspace_position at = {.load = 10};
  double p[15 * 15] = {7}, approach = 3;
  check_refused(arc_halfspace_solve(h, NULL, &at, NULL, p, &approach, NULL, why), ARC_ZONE, "edge");
  at.load = -1;
  check_refused(arc_halfspace_solve(h, NULL, &at, NULL, p, &approach, NULL, why), ARC_ARGUMENT,
                "load");
  at = (arc_halfspace_position){.load = 0.1, .x = 1};
  check_refused(arc_halfspace_solve(h, NULL, &at, NULL, p, &approach, NULL, why), ARC_ZONE,
                "position");
  at.x = 0;
  const arc_callbacks callbacks = {.stop = stop_at_once};
  const arc_halfspace_options options = {.callbacks = &callbacks};
  check_refused(arc_halfspace_solve(h, NULL, &at, &options, p, &approach, NULL, why), ARC_STOPPED,
                "stopped");
  assert_true(p[0] == 7 && approach == 3);
  arc_halfspace_destroy(&h);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_ball),         cmocka_unit_test(test_order),
      cmocka_unit_test(test_ellipse),      cmocka_unit_test(test_hertz_ellipse),
      cmocka_unit_test(test_cone),         cmocka_unit_test(test_punch),
      cmocka_unit_test(test_layers),       cmocka_unit_test(test_coats),
      cmocka_unit_test(test_fit),          cmocka_unit_test(test_waves),
      cmocka_unit_test(test_full_contact), cmocka_unit_test(test_random_pairs),
      cmocka_unit_test(test_refused),      cmocka_unit_test(test_failures),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

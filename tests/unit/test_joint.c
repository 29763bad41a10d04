/* Tests of a ball in a socket: exchange of head and cup, compliances, gaits, contacts and wear,
 * against an independent program and closed forms. */
#include "check.h"

#include "archard/joint.h"

static const double pi = 3.14159265358979323846;

static arc_joint_def metal(double size) {
  arc_joint_def def = arc_joint_default();
  def.size = size;
  return def;
}

/* Returns the definition of a liner 8 mm thick around a rigid head. */
static arc_joint_def liner(double size) {
  arc_joint_def def = metal(size);
  def.clearance = 0.1;
  def.core.E = 1e15;
  memset(def.cup, 0, sizeof def.cup);
  def.cup[0] = (arc_layer){.thickness = 8, .material = {.E = 1000, .nu = 0.4}};
  return def;
}

static arc_joint *make(const arc_joint_def *def) {
  arc_joint *j;
  arc_error error = {0};
  if (arc_joint_create(def, &j, &error) != ARC_OK) fail_msg("%s", error.message);
  return j;
}

static arc_joint_contact press(arc_joint *j, double load) {
  const double F[3] = {0, 0, load};
  arc_joint_contact c;
  arc_error error = {0};
  if (arc_joint_press(j, NULL, F, NULL, &c, &error) != ARC_OK) fail_msg("%s", error.message);
  return c;
}

static double deepest(const arc_joint *j, arc_body body) {
  const int n = 2 * arc_joint_rows(j) * arc_joint_rows(j);
  double most = 0;
  for (int i = 0; i < n; i++) most = fmax(most, arc_joint_depth(j, body)[i]);
  return 1000 * most;
}

/* Wears the joint up to `cycles` in updates of increasing length, and checks the volumes of both
 * bodies. */
static arc_joint_record wear_down(arc_joint *j, const arc_joint_wear_def *def, double cycles,
                                  int updates) {
  arc_joint_record r = {0};
  arc_error error = {0};
  for (int i = 1; i <= updates; i++) {
    const double to = cycles * pow((double)i / updates, 1.5);
    if (arc_joint_update(j, def, to - r.cycles, NULL, &r, &error) != ARC_OK)
      fail_msg("%s", error.message);
  }
  const double both = r.volume[ARC_UPPER] + r.volume[ARC_LOWER];
  check_share(both, r.loss, 1e-12);
  check_near(r.volume[ARC_UPPER], def->alpha * both, 1e-12 * both);
  return r;
}

enum { instants = 20, many = 60 };

static void walk(const char *name, int n, double angle, double load, arc_gait_instant *gait) {
  arc_error error;
  assert_int_equal(arc_gait_named(name, n, angle, load, gait, &error), ARC_OK);
}

/* Tests the symmetry of head and cup: if alpha, the rotation R and the load F are replaced by 1
 * - alpha, R' and R' F, both bodies exchange their results exactly. */
static void test_exchange(void **state) {
  (void)state;
  const arc_joint_def def = metal(3);
  arc_gait_instant gait[instants], turned[instants];
  walk("iso", instants, 0, 0, gait);
  for (int i = 0; i < instants; i++) {
    double back[3];
    for (int a = 0; a < 3; a++) {
      back[a] = turned[i].load[a] = 0;
      for (int b = 0; b < 3; b++) {
        turned[i].rotation[3 * a + b] = gait[i].rotation[3 * b + a];
        back[a] += gait[i].rotation[3 * b + a] * gait[i].omega[b];
        turned[i].load[a] += gait[i].rotation[3 * b + a] * gait[i].load[b];
      }
    }
    for (int a = 0; a < 3; a++) turned[i].omega[a] = -back[a];
  }
  const arc_joint_wear_def first = {.instants = instants,
                                    .instant = gait,
                                    .k = 3e-11,
                                    .alpha = 0.4},
                           second = {
                               .instants = instants, .instant = turned, .k = 3e-11, .alpha = 0.6};
  arc_joint *one = make(&def), *two = make(&def);
  const arc_joint_record a = wear_down(one, &first, 2e5, 8), b = wear_down(two, &second, 2e5, 8);
  printf("# cup, head %.4f %.4f and head, cup %.4f %.4f um; V %.6f %.6f\n", deepest(one, ARC_LOWER),
         deepest(one, ARC_UPPER), deepest(two, ARC_UPPER), deepest(two, ARC_LOWER), a.loss, b.loss);
  check_share(deepest(one, ARC_LOWER), deepest(two, ARC_UPPER), 0.01);
  check_share(deepest(one, ARC_UPPER), deepest(two, ARC_LOWER), 0.01);
  check_share(a.loss, b.loss, 1e-4);
  arc_joint_destroy(&one);
  arc_joint_destroy(&two);
}

static void test_compliance(void **state) {
  (void)state;
  static const int degree[] = {0, 1, 2, 5, 20, 100};
  static const double soft[] = {3.824768e-3, 3.922798e-3, 3.988175e-3,
                                3.575431e-3, 1.146332e-3, 2.339609e-4},
                      backed[] = {1.158088e-4, 1.160613e-3, 3.151624e-4,
                                  9.482454e-5, 5.528416e-6, 1.101072e-6},
                      head[] = {2.434783e-5, 0, 5.399488e-5, 2.082076e-5, 5.436391e-6, 1.103581e-6};
  const arc_joint_def pe = liner(2), mom = metal(2);
  for (int i = 0; i < 6; i++) {
    check_share(arc_joint_compliance(&pe, ARC_LOWER, degree[i]), soft[i], 1e-6);
    check_share(arc_joint_compliance(&mom, ARC_LOWER, degree[i]), backed[i], 1e-6);
    check_near(arc_joint_compliance(&mom, ARC_UPPER, degree[i]), head[i], 1e-6 * head[i]);
  }
  check_share(arc_joint_compliance(&mom, ARC_UPPER, 0), 14 * 0.4 / 230e3, 1e-10);
}

static void test_gaits(void **state) {
  (void)state;
  enum { n = 1000 };
  static const char *const name[] = {"iso", "prosim", "flexion", "rocking"};
  static const double angle[] = {0, 0, 21.5, 23}, track[] = {22.308, 22.779, 21.014, 34.370},
                      work[] = {28.239, 28.956, 42.03, 68.74};
  arc_gait_instant *gait = calloc(n, sizeof *gait);
  arc_error error;
  for (int i = 0; i < 4; i++) {
    assert_int_equal(arc_gait_named(name[i], n, angle[i], 2000, gait, &error), ARC_OK);
    check_share(arc_gait_track(n, gait, 14), track[i], 5e-5);
    check_share(arc_gait_work(n, gait, 14) / 1000, work[i], 2e-4);
  }
  free(gait);
  double open[9] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
  const double load[3] = {0, 0, 1};
  arc_gait_instant one;
  assert_int_equal(arc_gait_from_angles(1, open, load, "xyz", &one, &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "2 degrees"));
  assert_int_equal(arc_gait_from_angles(1, open, load, "xx", &one, &error), ARC_ARGUMENT);
}

static void test_static(void **state) {
  (void)state;
  static const double load[] = {300, 1500, 3000}, p[] = {3.878, 9.523, 14.738},
                      u[] = {0.114985, 0.138074, 0.158792}, angle[] = {26.56, 40.38, 47.81};
  const arc_joint_def def = liner(3);
  arc_joint *j = make(&def);
  for (int i = 0; i < 3; i++) {
    const arc_joint_contact c = press(j, load[i]);
    printf("# liner %g N: p %.4f u %.6f half angle %.2f, %d iterations\n", load[i], c.p_center,
           c.approach[2], c.half_angle, c.iterations);
    check_share(c.p_center, p[i], 2e-3);
    check_share(c.approach[2], u[i], 5e-4);
    check_share(c.half_angle, angle[i], 0.03);
    check_near(c.approach[0], 0, 1e-9);
  }
  arc_joint_destroy(&j);
}

static void test_metal(void **state) {
  (void)state;
  static const double load[] = {300, 3000}, p[] = {39.179, 49.451}, u[] = {0.0620361, 0.072366};
  const arc_joint_def def = metal(1);
  arc_joint *j = make(&def);
  for (int i = 0; i < 2; i++) {
    const arc_joint_contact c = press(j, load[i]);
    printf("# metal %g N: p %.4f u %.6f, %d iterations\n", load[i], c.p_max, c.approach[2],
           c.iterations);
    check_share(c.p_max, p[i], 3e-3);
    check_share(c.approach[2], u[i], 1e-3);
  }
  arc_joint_destroy(&j);
}

/* Tests a layer of Winkler springs under 3000 N against closed forms: p_max = 15.13737 MPa,
 * approach 0.1578969 mm, and an integral of p of 1.139244 times the load. */
static void test_springs(void **state) {
  (void)state;
  arc_joint_def def = liner(2);
  def.foundation = ARC_FOUNDATION_WINKLER;
  arc_joint *j = make(&def);
  const arc_joint_contact c = press(j, 3000);
  check_share(c.p_max, 15.13737, 1e-3);
  check_share(c.approach[2], 0.1578969, 1e-3);
  check_share(c.normal_force, 1.139244 * 3000, 1e-3);
  arc_joint_destroy(&j);
}

/* Tests that a load in a direction between the grid lines gives the same contact as a load along
 * the axis. */
static void test_turned_load(void **state) {
  (void)state;
  const arc_joint_def def = liner(3);
  arc_joint *j = make(&def);
  const arc_joint_contact straight = press(j, 2000);
  const double a = 15 * pi / 180, load[3] = {2000 * sin(a), 0, 2000 * cos(a)};
  arc_joint_contact c;
  arc_error error = {0};
  assert_int_equal(arc_joint_press(j, NULL, load, NULL, &c, &error), ARC_OK);
  check_share(c.p_max, straight.p_max, 5e-4);
  check_share(sqrt(pow(c.approach[0], 2) + pow(c.approach[2], 2)), straight.approach[2], 5e-4);
  arc_joint_destroy(&j);
}

/* Tests wear by a head that moves on a circle, so the sliding speed is constant, against an
 * independent program. */
static void test_rocking(void **state) {
  (void)state;
  const arc_joint_def def = liner(4);
  arc_gait_instant gait[many];
  walk("rocking", many, 23, 2000, gait);
  const arc_joint_wear_def wear = {.instants = many, .instant = gait, .k = 1e-9};
  arc_joint *j = make(&def);
  const arc_joint_record r = wear_down(j, &wear, 1e6, 14);
  const arc_joint_contact c = press(j, 2000);
  printf("# rocking: h %.3f um, V %.4f, p0 %.4f, %d iterations in %d solutions\n",
         deepest(j, ARC_LOWER), r.loss, c.p_center, r.iterations, r.solutions);
  check_share(r.loss, 80.219, 2e-3);
  check_share(deepest(j, ARC_LOWER), 198.43, 6e-3);
  check_share(c.p_center, 4.536, 0.012);
  double *share = calloc((size_t)(2 * arc_joint_rows(j) * arc_joint_rows(j)), sizeof *share);
  arc_joint_cross_shear(j, share);
  const int n = arc_joint_rows(j);
  check_near(share[n / 2 * 2 * n + n], 0.5, 5e-3);
  free(share);
  arc_joint_destroy(&j);
}

/* Tests the wear of both bodies of a metal joint in a million cycles of walking with alpha = 0.5
 * against an independent program with 20 updates. */
static void test_walk(void **state) {
  (void)state;
  const arc_joint_def def = metal(3);
  arc_gait_instant gait[instants];
  walk("iso", instants, 0, 0, gait);
  const arc_joint_wear_def wear = {.instants = instants, .instant = gait, .k = 3e-11, .alpha = 0.5};
  arc_joint *j = make(&def);
  const arc_joint_record r = wear_down(j, &wear, 1e6, 20);
  printf("# walk: cup %.4f head %.4f um, V %.5f mm3, %d iterations in %d solutions\n",
         deepest(j, ARC_LOWER), deepest(j, ARC_UPPER), r.loss, r.iterations, r.solutions);
  check_share(deepest(j, ARC_LOWER), 5.277, 6e-3);
  check_share(deepest(j, ARC_UPPER), 3.574, 8e-3);
  check_share(r.loss, 0.86456, 3e-3);
  arc_joint_destroy(&j);
}

/* Returns a wear coefficient that increases with the cross-shear `share`. test_cross_shear uses
 * it to test the cross-shear at the pole of a liner and the wear volume. */
static double sheared(void *context, double share, double p, double cycles) {
  (void)context, (void)p, (void)cycles;
  return 1e-9 * fmin(0.2 + 3.2 * share, 1);
}

static void test_cross_shear(void **state) {
  (void)state;
  arc_joint_def def = liner(4);
  def.foundation = ARC_FOUNDATION_WINKLER;
  arc_gait_instant gait[instants];
  walk("iso", instants, 0, 0, gait);
  const arc_joint_wear_def wear = {.instants = instants, .instant = gait, .k_function = sheared};
  arc_joint *j = make(&def);
  const int n = arc_joint_rows(j), pole = n / 2 * 2 * n + n;
  double *share = calloc((size_t)(2 * n * n), sizeof *share);
  wear_down(j, &wear, 1, 1);
  arc_joint_cross_shear(j, share);
  const double middle =
      (share[pole] + share[pole - 1] + share[pole - 2 * n] + share[pole - 2 * n - 1]) / 4;
  const arc_joint_record r = wear_down(j, &wear, 1e6, 20);
  printf("# cross-shear %.4f at the pole, h %.3f um, V %.4f\n", middle, deepest(j, ARC_LOWER),
         r.loss);
  check_near(middle, 0.1063, 2e-3);
  check_share(deepest(j, ARC_LOWER), 66.2, 0.015);
  check_share(r.loss, 16.70, 0.015);
  free(share);
  arc_joint_destroy(&j);
}

static void test_bad_input(void **state) {
  (void)state;
  arc_error error;
  arc_joint *j;
  arc_joint_def def = metal(3);
  def.clearance = 0;
  assert_int_equal(arc_joint_create(&def, &j, &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "cup.clearance"));
  def = metal(3);
  def.head[0] = (arc_layer){.thickness = 15, .material = {.E = 1e5, .nu = 0.3}};
  assert_int_equal(arc_joint_create(&def, &j, &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "head.layers"));
  assert_null(j);
  def = liner(4);
  j = make(&def);
  const double out[3] = {0, 0, -100};
  arc_joint_contact c;
  assert_int_equal(arc_joint_press(j, NULL, out, NULL, &c, &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "180 degrees"));
  arc_joint_destroy(&j);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_exchange),    cmocka_unit_test(test_compliance),
      cmocka_unit_test(test_gaits),       cmocka_unit_test(test_static),
      cmocka_unit_test(test_metal),       cmocka_unit_test(test_springs),
      cmocka_unit_test(test_turned_load), cmocka_unit_test(test_rocking),
      cmocka_unit_test(test_walk),        cmocka_unit_test(test_cross_shear),
      cmocka_unit_test(test_bad_input),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

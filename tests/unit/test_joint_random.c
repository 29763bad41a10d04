/* Tests of random joints: radii, clearances, layers, moduli from rubber to ceramics, inclined
 * cups, gaits and wear partition. Each run must have Archard's wear volumes. Contacts on unworn
 * and worn surfaces must satisfy balance and complementarity, which the test recomputes. For
 * more runs: ARCHARD_RUNS=500 build/tests/test_joint_random */
#include "check.h"

#include "core/sphere/sphere.h"

enum { instants = 8 };

typedef struct worst_case {
  double force, touching, overlap; /* largest errors: of forces relative to the load, of the overlap
                                    * relative to the largest displacement */
  double volume, share;            /* largest errors relative to the worn volume of both bodies */
  int runs, refused, springs, updates; /* refused: number of runs whose contact would extend
                                        * around the head */
} worst_case;

/* --- random definitions ----------------------------------------------------------------------- */

static double uniform(double low, double high) {
  static unsigned long long state = 29;
  state = state * 6364136223846793005ull + 1442695040888963407ull;
  return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

static double between(double low, double high) {
  return low * pow(high / low, uniform(0, 1));
}

static arc_material material(void) {
  return (arc_material){.E = between(100, 1e6), .nu = uniform(0, 0.47)};
}

static arc_joint_def definition(void) {
  arc_joint_def def = arc_joint_default();
  def.radius = between(5, 50);
  def.clearance = def.radius * between(3e-4, 3e-2);
  def.inclination = uniform(-45, 45);
  def.core = material();
  def.foundation = uniform(0, 1) < 0.8 ? ARC_FOUNDATION_ELASTIC : ARC_FOUNDATION_WINKLER;
  memset(def.cup, 0, sizeof def.cup);
  const int cup = 1 + (int)uniform(0, 4), head = (int)uniform(0, 3);
  for (int i = 0; i < cup; i++)
    def.cup[i] = (arc_layer){.thickness = def.radius * between(0.05, 2), .material = material()};
  for (int i = 0; i < head; i++)
    def.head[i] = (arc_layer){.thickness = def.radius * uniform(0.05, 0.4), .material = material()};
  return def;
}

/* Computes a built-in gait with its loads scaled to the largest load [N]. Directions and ratios
 * of the loads are unchanged. */
static void gait_of(double load, arc_gait_instant *gait) {
  static const char *const name[] = {"iso", "prosim", "flexion", "rocking"};
  const double turn = uniform(-0.3, 0.3);
  double most = 0;
  arc_error error;
  assert_int_equal(
      arc_gait_named(name[(int)uniform(0, 4)], instants, uniform(5, 40), 1, gait, &error), ARC_OK);
  for (int i = 0; i < instants; i++) most = fmax(most, gait[i].load[2]);
  for (int i = 0; i < instants; i++) {
    const double size = load * gait[i].load[2] / most;
    gait[i].load[0] = 0;
    gait[i].load[1] = size * sin(turn);
    gait[i].load[2] = size * cos(turn);
  }
}

/* --- conditions checked ----------------------------------------------------------------------- */

static void check_contact(arc_joint *j, const double load[3], const double approach[3],
                          worst_case *worst) {
  const int n = j->size * j->size;
  double *u = calloc((size_t)n, sizeof *u);
  double force[3] = {0}, most = 0, off = 0, size = 0;
  if (j->kernel)
    arc_sphere_kernel_apply(j->kernel, j->press, u);
  else
    for (int c = 0; c < n; c++) u[c] = j->press[c] / j->K;
  for (int c = 0; c < n; c++) most = fmax(most, fabs(u[c]));
  for (int c = 0; c < n; c++) {
    const double *normal = j->normal + 3 * (size_t)sphere_site(j, c);
    double gap = j->gap[c] + u[c];
    for (int a = 0; a < 3; a++) {
      gap -= approach[a] * normal[a];
      force[a] += j->press[c] * normal[a] * j->cell[c];
    }
    assert_true(j->press[c] >= 0);
    if (j->press[c] > 0)
      worst->touching = fmax(worst->touching, fabs(gap) / most);
    else
      worst->overlap = fmax(worst->overlap, -gap / most);
  }
  for (int a = 0; a < 3; a++) off += pow(force[a] - load[a], 2), size += pow(load[a], 2);
  worst->force = fmax(worst->force, sqrt(off / size));
  free(u);
}

/* Solves and checks one contact. Returns 0 if the contact would extend around the head. */
static int press(arc_joint *j, const arc_gait_instant *at, arc_joint_contact *c,
                 worst_case *worst) {
  arc_error error = {0};
  const arc_status status = arc_joint_press(j, at->rotation, at->load, NULL, c, &error);
  if (status != ARC_OK && status != ARC_ZONE) fail_msg("%s", error.message);
  if (status == ARC_OK) check_contact(j, at->load, c->approach, worst);
  return status == ARC_OK;
}

/* Returns a load [N] whose contact is narrower than 60 degrees on each side, and sets def->size
 * [degrees] to a cell size suitable for this contact. Returns 0 if even small loads give
 * contacts that extend around the head. */
static double fit(arc_joint_def *def) {
  arc_error error = {0};
  arc_joint *j;
  arc_joint_contact c;
  double load = def->radius * def->radius * between(0.1, 20);
  def->size = 5;
  assert_int_equal(arc_joint_create(def, &j, &error), ARC_OK);
  for (int i = 0; i < 20; i++, load /= 3) {
    const double F[3] = {0, 0, load};
    const arc_status status = arc_joint_press(j, NULL, F, NULL, &c, &error);
    if (status != ARC_OK && status != ARC_ZONE) fail_msg("%s", error.message);
    if (status == ARC_OK && c.half_angle < 60) break;
    c.half_angle = 0;
  }
  arc_joint_destroy(&j);
  def->size = fmax(0.75, fmin(5, c.half_angle / 6));
  return c.half_angle > 0 ? load : 0;
}

/* Wears the joint in four updates. Returns 0 if the worn contact would extend around the head;
 * the joint must then be unchanged. */
static int wear_down(arc_joint *j, const arc_joint_wear_def *wear, double cycles,
                     arc_joint_record *r) {
  const size_t bytes = (size_t)j->sites * sizeof(double);
  double *before = malloc(bytes);
  arc_status status = ARC_OK;
  arc_error error = {0};
  assert_non_null(before);
  for (int i = 1; i <= 4 && status == ARC_OK; i++) {
    const arc_joint_record was = *r;
    memcpy(before, j->h[ARC_LOWER], bytes);
    status = arc_joint_update(j, wear, cycles * pow(i / 4.0, 1.5) - r->cycles, NULL, r, &error);
    if (status == ARC_OK) continue;
    if (status != ARC_ZONE) fail_msg("%s", error.message);
    assert_memory_equal(&was, r, sizeof was);
    assert_memory_equal(before, j->h[ARC_LOWER], bytes);
  }
  free(before);
  return status == ARC_OK;
}

static int run_one(worst_case *worst) {
  arc_joint_def def = definition();
  arc_gait_instant gait[instants];
  arc_joint_contact c;
  arc_joint_record r = {0};
  arc_joint *j;
  const double load = fit(&def), cycles = 1e6;
  if (load == 0) return 0;
  gait_of(load, gait);
  assert_int_equal(arc_joint_create(&def, &j, NULL), ARC_OK);
  int fine = press(j, &gait[0], &c, worst);
  if (fine) {
    /* gives a wear depth of 0.1 to 10 times the elastic approach */
    const double sag = fmax(c.approach[2] - def.clearance, 0.01 * def.clearance);
    const double depth = fmin(between(0.1, 10) * sag, 0.02 * def.radius);
    const double corners[] = {0, 1, 0.5, uniform(0, 1)};
    const arc_joint_wear_def wear = {
        .instants = instants,
        .instant = gait,
        .alpha = corners[(int)uniform(0, 4)],
        .k = depth / (c.p_max * arc_gait_track(instants, gait, def.radius) * cycles)};
    fine = wear_down(j, &wear, cycles, &r) && press(j, &gait[instants / 2], &c, worst);
    const double both = r.volume[ARC_UPPER] + r.volume[ARC_LOWER];
    if (both > 0) {
      worst->volume = fmax(worst->volume, fabs(both / r.loss - 1));
      worst->share = fmax(worst->share, fabs(r.volume[ARC_UPPER] / both - wear.alpha));
    }
  }
  worst->springs += def.foundation == ARC_FOUNDATION_WINKLER;
  worst->updates += r.updates;
  arc_joint_destroy(&j);
  return fine;
}

static void test_random(void **state) {
  (void)state;
  const char *runs = getenv("ARCHARD_RUNS");
  const int count = runs ? atoi(runs) : all_tests() ? 60 : 8;
  worst_case worst = {0};
  while (worst.runs < count && worst.refused < 1 + count / 4) {
    const int fine = run_one(&worst);
    worst.runs += fine;
    worst.refused += !fine;
  }
  printf("# %d joints, %d of them on springs, %d refused, %d updates\n", worst.runs, worst.springs,
         worst.refused, worst.updates);
  printf("# force %.2g, gap under pressure %.2g, overlap elsewhere %.2g; volume %.2g, share %.2g\n",
         worst.force, worst.touching, worst.overlap, worst.volume, worst.share);
  assert_int_equal(worst.runs, count);
  check_below(worst.force, 1e-9);
  check_below(worst.touching, 1e-6);
  check_below(worst.overlap, 1e-6);
  check_below(worst.volume, 1e-12);
  check_below(worst.share, 1e-12);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_random)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Tests of increments with Coulomb friction: every increment of random histories of load and
 * motion satisfies the friction conditions, forces balance, and restored states continue with
 * identical bits. The tests use internal functions of contact. */
#include "check.h"

#include "core/base/dense.h"
#include "core/friction/friction.h"
#include "core/plane/solution.h"

/* --- a loading history ------------------------------------------------------------------------ */

typedef struct history {
  arc_shape *shape;
  contact_problem problem;
  tangential_compliance compliance;
  friction_workspace workspace;
  friction_state state, before;
  double mu, slope; /* mu: coefficient of friction; slope: largest slope of the surfaces */
} history;

static double scar(double x) {
  return fmax(0, 4e-3 * (1 - x * x / 0.09));
}

/* Wears the plate to a smooth scar of a random depth up to `share` times 4e-3 mm, and the
 * cylinder to half of it. */
static void wear_down(history *h, double share) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_profile profile = arc_shape_profile(h->shape, (arc_body)b);
    double *depth = calloc((size_t)profile.count, sizeof *depth);
    for (int i = 0; i < profile.count; i++)
      depth[i] = share * (b == ARC_PLATE ? 1 : 0.5) * scar(profile.x[i]);
    check_ok(arc_shape_wear(h->shape, (arc_body)b, depth, why));
    free(depth);
  }
}

static void begin(history *h, arc_model *model, double mu, double worn) {
  *h = (history){.mu = mu, .slope = 0.03 * worn};
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &h->shape, why));
  if (worn > 0) wear_down(h, worn);
  assert_int_equal(arc_contact_problem_create(&h->problem, model), ARC_OK);
  assert_int_equal(arc_tangential_create(&h->compliance, model), ARC_OK);
  assert_int_equal(arc_friction_workspace_create(&h->workspace, model), ARC_OK);
  assert_int_equal(arc_friction_create(&h->state, model, 0), ARC_OK);
  assert_int_equal(arc_friction_create(&h->before, model, 0), ARC_OK);
}

static void end(history *h) {
  arc_friction_free(&h->before);
  arc_friction_free(&h->state);
  arc_friction_workspace_free(&h->workspace);
  arc_tangential_free(&h->compliance);
  arc_contact_problem_free(&h->problem);
  arc_shape_destroy(&h->shape);
}

static void go(history *h, const friction_step *step) {
  const double pairing = step->by_force ? h->problem.x : step->x;
  arc_friction_copy(&h->before, &h->state);
  check_ok(arc_contact_problem_update(&h->problem, h->shape, pairing, why));
  check_ok(arc_friction_solve(&h->problem, &h->compliance, &h->workspace, step, &h->state, why));
}

/* --- conditions of an increment --------------------------------------------------------------- */

/* Checks the contact conditions with gaps recomputed from the matrices and the shape only. */
static void check_gaps(const history *h) {
  const contact_problem *p = &h->problem;
  const tangential_compliance *g = &h->compliance;
  const friction_workspace *w = &h->workspace;
  contact_problem plain;
  assert_int_equal(arc_contact_problem_create(&plain, h->shape->handle.model), ARC_OK);
  check_ok(arc_contact_problem_update(&plain, h->shape, p->x, why));
  for (int c = 0; c < p->count; c++) {
    const double m = p->slope[p->lo + c];
    double gap = plain.gap[c] + m * (h->state.x - p->x) - p->approach;
    for (int k = 0; k < p->count; k++)
      gap += p->a[dense_at(c, k, p->count)] * p->f[k] + g->nt[dense_at(c, k, p->count)] * w->t[k];
    assert_true(p->f[c] >= 0);
    assert_true(gap > -1e-13);
    if (p->f[c] > 0) check_near(gap, 0, 1e-13);
  }
  arc_contact_problem_free(&plain);
}

/* Checks the friction conditions with a slip recomputed from the displacements of both surfaces,
 * without the matrices. */
static void check_slip(history *h, double p0) {
  const contact_problem *p = &h->problem;
  double *room = calloc((size_t)(2 * p->nc + p->np), sizeof *room), *was = room, *is = was + p->nc;
  arc_tangential_relative(p, h->before.u, is + p->nc, was);
  arc_tangential_relative(p, h->state.u, is + p->nc, is);
  for (int c = 0; c < p->count; c++) {
    const int i = p->lo + c;
    const double t = h->state.t[i], bound = h->mu * h->state.f[i];
    const double up =
        h->before.line > 0 ? p->slope[i] * (h->state.approach - h->before.approach) : NAN;
    const double slip = h->state.x - h->before.x + up - (is[c] - was[c]);
    assert_true((fabs(t) - bound) / p->wc[i] <= 1e-10 * p0);
    if (!isnan(up)) check_near(h->state.slip[i], slip, 1e-13);
    if (fabs(t) < bound) assert_true(h->state.slip[i] == 0);
    assert_true(t * h->state.slip[i] >= -1e-14 * bound);
  }
  free(room);
}

static void check_resultants(history *h, const friction_step *step) {
  double sum[ARC_BODIES][2] = {{0}};
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = b == ARC_CYLINDER ? h->problem.nc : h->problem.np;
    double *force = calloc(2 * (size_t)n, sizeof *force);
    arc_friction_forces_on(&h->problem, &h->workspace, (arc_body)b, force);
    for (int i = 0; i < 2 * n; i++) sum[b][i / n] += force[i];
    free(force);
  }
  for (int d = 0; d < 2; d++)
    check_near(sum[ARC_CYLINDER][d] + sum[ARC_PLATE][d], 0, 1e-13 * step->line);
  check_near(sum[ARC_CYLINDER][1], step->line, 1e-11 * step->line);
  if (step->by_force) check_near(sum[ARC_CYLINDER][0], step->tangential, 1e-11 * step->line);
  check_near(h->state.tangential, sum[ARC_CYLINDER][0], 1e-12 * step->line);
}

static double largest_pressure(const contact_problem *p) {
  double center, largest;
  arc_contact_problem_peaks(p, &center, &largest);
  return largest;
}

static void check_increment(history *h, const friction_step *step) {
  check_gaps(h);
  check_slip(h, largest_pressure(&h->problem));
  check_resultants(h, step);
}

/* --- random histories ------------------------------------------------------------------------ */

enum { histories = 1000, length = 24 };

typedef struct tally {
  int increments, most, newton, over_10;
  long sweeps, sets;
} tally;

static void count(tally *t, const history *h) {
  t->increments++;
  t->sweeps += h->workspace.sweeps;
  t->sets += h->workspace.iterations;
  t->newton += h->workspace.newton;
  t->over_10 += h->workspace.sweeps > 10;
  if (h->workspace.sweeps > t->most) t->most = h->workspace.sweeps;
}

/* Returns a random step: a small or large motion, a force up to the friction limit, a changed
 * load or lift-off. */
static friction_step random_step(const history *h) {
  friction_step s = {.mu = h->mu, .line = random_in(20, 110), .x = h->state.x};
  const int kind = random_int(0, 9);
  if (random_int(0, 2) && h->state.line > 0) s.line = h->state.line;
  if (kind == 0) s.line = random_int(0, 1) ? 0 : s.line;
  if (kind >= 1 && kind <= 5) s.x += random_in(-1, 1) * 4e-3 * h->mu;
  if (kind == 6) s.x = random_in(-0.06, 0.06);
  if (kind < 7 || h->slope >= h->mu) return s;
  s.by_force = 1;
  s.tangential =
      random_in(-0.95, 0.95) * (h->mu - h->slope) * s.line; /* slopes transmit part of the force */
  return s;
}

static arc_model *random_model(int stiffer) {
  arc_model_def def = coarse_definition();
  const double ratio = exp(random_in(0, log(10)));
  def.material[stiffer].E *= sqrt(ratio);
  def.material[!stiffer].E /= sqrt(ratio);
  def.material[0].nu = random_in(0, 0.45);
  def.material[1].nu = random_in(0, 0.45);
  def.mesh.zone[ARC_PLATE] = def.mesh.zone[ARC_CYLINDER] = 1.2;
  return build_model(&def);
}

static void run_history(arc_model *model, double worn, tally *t) {
  history h;
  begin(&h, model, exp(random_in(log(0.05), log(1.2))), worn);
  for (int i = 0; i < length; i++) {
    const friction_step step = random_step(&h);
    go(&h, &step);
    if (step.line == 0) continue;
    check_increment(&h, &step);
    count(t, &h);
  }
  end(&h);
}

static void test_random_histories(void **state) {
  (void)state;
  static const double worn[] = {0, 0, 0.2, 1};
  enum { models = 10 };
  tally t = {0};
  random_start(11);
  for (int m = 0; m < models; m++) {
    arc_model *model = random_model(m % 2);
    for (int i = 0; i < histories / models; i++) run_history(model, worn[i % 4], &t);
    arc_model_release(&model);
  }
  printf("# %d increments of %d histories: %.2f sweeps each, %.2f sets, %d at most, %d over 10, %d "
         "by the coupled iteration\n",
         t.increments, histories, (double)t.sweeps / t.increments, (double)t.sets / t.increments,
         t.most, t.over_10, t.newton);
  assert_true(t.increments > 20 * histories);
}

typedef struct ways {
  int most, bracketed;
} ways;

/* Compares two solutions of one increment: by the default method, and by sweeps alone. For a given
 * force the sweeps use bracketing to compute the plate's position. */
static void compare_ways(history *quick, history *slow, ways *found) {
  const friction_step step = random_step(quick);
  go(quick, &step);
  go(slow, &step);
  if (step.line == 0) return;
  check_increment(slow, &step);
  assert_false(slow->workspace.newton);
  if (slow->workspace.sweeps > found->most) found->most = slow->workspace.sweeps;
  found->bracketed += slow->workspace.bracketed;
  assert_int_equal(slow->workspace.bracketed, step.by_force);
  for (int c = 0; c < quick->state.nc; c++) {
    check_near(slow->state.f[c], quick->state.f[c], 1e-7 * step.line);
    check_near(slow->state.t[c], quick->state.t[c], 1e-7 * step.line);
  }
}

static void run_ways(arc_model *model, double worn, ways *found) {
  history quick, slow;
  const double mu = exp(random_in(log(0.05), log(1.2)));
  begin(&quick, model, mu, worn);
  begin(&slow, model, mu, worn);
  slow.workspace.sweeps_before_newton = 1 << 20;
  slow.workspace.by_force = 0;
  for (int k = 0; k < length; k++) compare_ways(&quick, &slow, found);
  end(&slow);
  end(&quick);
}

/* Tests that sweeps without the coupled Newton iteration, and bracketing for a given force, give
 * the same results as the default method. */
static void test_ways_to_solve(void **state) {
  (void)state;
  static const double worn[] = {0, 0.2, 1};
  ways found = {0};
  random_start(5);
  for (int m = 0; m < 3; m++) {
    arc_model *model = random_model(m % 2);
    for (int i = 0; i < 30; i++) run_ways(model, worn[i % 3], &found);
    arc_model_release(&model);
  }
  printf("# sweeps alone: %d at most, %d increments by bracketing\n", found.most, found.bracketed);
}

/* --- single increments ----------------------------------------------------------------------- */

static arc_model *coarse; /* built once, for all tests */

static int set_up(void **state) {
  (void)state;
  const arc_model_def def = coarse_definition();
  return arc_model_build(&def, &coarse, NULL) == ARC_OK ? 0 : -1;
}

static int tear_down(void **state) {
  (void)state;
  arc_model_release(&coarse);
  return 0;
}

/* Presses the bodies, moves the plate to and fro, and ends in partial slip on worn surfaces. */
static void play(history *h, int first, int last) {
  static const double x[] = {0, 1.5e-3, -1e-3, 0, 5e-4, 0.03, 0.0285};
  static const double force[] = {0, 0, 0, 8, 0, 0, 0};
  for (int i = first; i < last; i++) {
    const friction_step step = {h->mu, 100, force[i] != 0, x[i], force[i]};
    go(h, &step);
    check_increment(h, &step);
  }
}

enum { played = 7 };

/* Tests that the result without friction is identical bit by bit to the result of the
 * frictionless solver. */
static void test_no_friction(void **state) {
  (void)state;
  history h;
  contact_problem plain;
  begin(&h, coarse, 0, 1);
  assert_int_equal(arc_contact_problem_create(&plain, coarse), ARC_OK);
  for (int i = 0; i < 4; i++) {
    const friction_step step = {.line = 60 + 20 * i, .x = 0.03 * i};
    go(&h, &step);
    check_ok(arc_contact_problem_update(&plain, h.shape, step.x, why));
    check_ok(arc_contact_problem_solve(&plain, step.line, why));
    assert_memory_equal(h.problem.f, plain.f, (size_t)plain.count * sizeof(double));
    assert_true(h.problem.approach == plain.approach);
    for (int k = 0; k < plain.count; k++) assert_true(h.workspace.t[k] == 0);
  }
  arc_contact_problem_free(&plain);
  end(&h);
}

static void check_same(const friction_state *a, const friction_state *b) {
  assert_true(a->x == b->x && a->approach == b->approach && a->line == b->line);
  assert_true(a->tangential == b->tangential && a->energy == b->energy && a->between == b->between);
  assert_memory_equal(a->f, b->f, arc_friction_bytes(a));
}

/* Tests that a state copied to another problem continues with identical bits. */
static void test_copied(void **state) {
  (void)state;
  history one, two;
  begin(&one, coarse, 0.6, 0.5);
  begin(&two, coarse, 0.6, 0.5);
  play(&one, 0, 3);
  arc_friction_copy(&two.state, &one.state);
  check_ok(arc_contact_problem_update(&two.problem, two.shape, one.problem.x, why));
  play(&one, 3, played);
  play(&two, 3, played);
  check_same(&one.state, &two.state);
  end(&two);
  end(&one);
}

/* Tests that a refused step leaves the state unchanged. */
static void test_refused(void **state) {
  (void)state;
  history h;
  begin(&h, coarse, 0.3, 0);
  play(&h, 0, 2);
  arc_friction_copy(&h.before, &h.state);
  const friction_step far[] = {{0.3, 100, 1, 0, 30.001}, {0.3, 0, 1, 0, 1}, {0.3, 1e5, 0, 0, 0}};
  const arc_status wanted[] = {ARC_ARGUMENT, ARC_ARGUMENT, ARC_ZONE};
  const char *const words[] = {"friction does not carry", "friction does not carry", "zone"};
  for (int i = 0; i < 3; i++) {
    check_ok(arc_contact_problem_update(&h.problem, h.shape, h.problem.x, why));
    check_refused(
        arc_friction_solve(&h.problem, &h.compliance, &h.workspace, &far[i], &h.state, why),
        wanted[i], words[i]);
    check_same(&h.state, &h.before);
  }
  end(&h);
}

/* Tests that after lift-off and a new load the slip starts at zero and the dissipated energy
 * does not decrease. */
static void test_lifted(void **state) {
  (void)state;
  history h;
  begin(&h, coarse, 0.6, 0);
  play(&h, 0, 3);
  const double energy = h.state.energy;
  assert_true(energy > 0);
  go(&h, &(friction_step){.mu = 0.6, .x = 5e-3});
  assert_true(h.state.line == 0 && h.state.tangential == 0 && h.state.x == 5e-3);
  const friction_step again = {.mu = 0.6, .line = 100, .x = 5e-3};
  go(&h, &again);
  check_increment(&h, &again);
  check_near(h.state.tangential, 0, 0.05);
  assert_true(h.state.energy >= energy);
  end(&h);
}

/* Tests displacements that are recomputed from the forces after wear: they equal the
 * displacements by the matrices of the worn shape, so sticking points have no slip. */
static void test_displaced(void **state) {
  (void)state;
  history h;
  begin(&h, coarse, 0.6, 0.5);
  play(&h, 0, 2);
  wear_down(&h, 0.1);
  check_ok(arc_contact_problem_update(&h.problem, h.shape, h.problem.x, why));
  arc_tangential_update(&h.compliance, &h.problem, h.workspace.work);
  arc_tangential_displace(&h.problem, h.compliance.flat, h.state.f, h.state.t, h.state.u,
                          h.workspace.work);
  const contact_problem *p = &h.problem;
  double *r = calloc((size_t)(p->nc + p->np), sizeof *r);
  arc_tangential_relative(p, h.state.u, r + p->nc, r);
  for (int c = 0; c < p->count; c++) {
    double wanted = 0;
    for (int k = 0; k < p->count; k++)
      wanted += h.compliance.nt[dense_at(k, c, p->count)] * h.state.f[p->lo + k] +
                h.compliance.tt[dense_at(k, c, p->count)] * h.state.t[p->lo + k];
    check_near(r[c], wanted, 1e-15);
  }
  free(r);
  end(&h);
}

/* Tests that shear forces alternating from node to node displace the surface by as much as
 * alternating normal forces do. The element matrix alone would give about half. For distant
 * nodes the compliance is the element matrix without correction. */
static void test_alternating(void **state) {
  (void)state;
  history h;
  begin(&h, coarse, 0.6, 0);
  play(&h, 0, 1);
  const contact_problem *p = &h.problem;
  const compliance *c = shape_compliance(&h.shape->side[ARC_CYLINDER]);
  const int mid = p->count / 2, far = 2 * ARC_SHEAR_REACH;
  double shear = 0, press = 0, elements = 0;
  static const double force[] = {1, -4, 6, -4, 1};
  for (int k = 0; k < 5; k++) {
    const int at = mid - 2 + k;
    shear += force[k] * h.compliance.tt[dense_at(mid, at, p->count)];
    press += force[k] * p->a[dense_at(mid, at, p->count)];
    elements += force[k] * c->xx[dense_at(p->lo + mid, p->lo + at, c->n)];
  }
  check_near(shear, press, 0.01 * press);
  assert_true(2 * elements < 0.6 * press);
  assert_true(compliance_shear(c, mid, mid + far) == c->xx[dense_at(mid, mid + far, c->n)]);
  assert_true(compliance_shear(c, mid, mid + 3) == compliance_shear(c, mid + 3, mid));
  end(&h);
}

/* Tests the energy balance of a closed cycle: the work of the force over the plate's path equals
 * the energy dissipated at the nodes. The total energy also has a part between the nodes, which
 * exists even if no node slips. */
static void test_between(void **state) {
  (void)state;
  history h;
  begin(&h, coarse, 0.6, 0);
  go(&h, &(friction_step){.mu = 0, .line = 100});
  double start[2] = {0}, area = 0;
  for (int i = 1; i <= 200; i++) {
    /* turning points of the force: 40, -40, 40 N/mm */
    const double force = i <= 40 ? i : i <= 120 ? 80 - i : i - 160;
    if (i == 41) start[0] = h.state.energy, start[1] = h.state.between;
    go(&h, &(friction_step){.mu = 0.6, .line = 100, .by_force = 1, .tangential = force});
    if (i > 40) area += (h.state.x - h.before.x) * (h.state.tangential + h.before.tangential) / 2;
    if (i == 4) assert_true(h.state.energy > 0 && h.state.energy == h.state.between);
  }
  const double energy = h.state.energy - start[0], between = h.state.between - start[1];
  check_near(energy, 3.2635e-3, 0.04 * 3.2635e-3); /* dissipated energy of elastic half-planes; the
                                                    * nodes alone give 27 % less */
  check_near(area, energy - between, 1e-3 * energy);
  end(&h);
}

/* Tests the signs of forces and slips. Pressing equal bodies gives no shear. A plate pushed to
 * +x has a positive force and slips along +x at the edges; in gross slip to -x the force is
 * negative. */
static void test_signs(void **state) {
  (void)state;
  history h;
  begin(&h, coarse, 0.6, 0);
  go(&h, &(friction_step){.mu = 0.6, .line = 100});
  for (int i = 0; i < h.state.nc; i++) check_near(h.state.t[i], 0, 0.1);
  go(&h, &(friction_step){.mu = 0.6, .line = 100, .x = 1.5e-3});
  assert_true(h.state.tangential > 20 && h.state.tangential < 60);
  for (int i = 0; i < h.state.nc; i++)
    if (h.state.f[i] > 0) assert_true(h.state.slip[i] >= 0 && h.state.t[i] > 0);
  go(&h, &(friction_step){.mu = 0.6, .line = 100, .x = 0.01});
  check_near(h.state.tangential, 60, 1e-10);
  go(&h, &(friction_step){.mu = 0.6, .line = 100, .x = -0.01});
  check_near(h.state.tangential, -60, 1e-10);
  end(&h);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_no_friction),      cmocka_unit_test(test_copied),
      cmocka_unit_test(test_refused),          cmocka_unit_test(test_lifted),
      cmocka_unit_test(test_displaced),        cmocka_unit_test(test_alternating),
      cmocka_unit_test(test_between),          cmocka_unit_test(test_signs),
      cmocka_unit_test(test_random_histories), cmocka_unit_test(test_ways_to_solve),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}

/* Increments of Coulomb friction: every one is checked against its conditions, over random
 * histories of load and motion; forces balance; states carry on to the same bits. Leans on the
 * inside of contact. */
#include "check.h"

#include "core/base/dense.h"
#include "core/contact/friction.h"
#include "core/contact/solution.h"

/* --- a history --------------------------------------------------------------------------------- */

typedef struct history {
  arc_shape *shape;
  pose pose;
  grip grip;
  friction_state state, before;
  double mu, slope; /* steepest of the surfaces */
} history;

static double scar(double x) {
  return fmax(0, 4e-3 * (1 - x * x / 0.09));
}

/* Worn by a smooth scar, or not; the other body half as much. */
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
  assert_int_equal(arc_pose_create(&h->pose, model), ARC_OK);
  assert_int_equal(arc_grip_create(&h->grip, model), ARC_OK);
  assert_int_equal(arc_friction_create(&h->state, model, 0), ARC_OK);
  assert_int_equal(arc_friction_create(&h->before, model, 0), ARC_OK);
}

static void end(history *h) {
  arc_friction_free(&h->before);
  arc_friction_free(&h->state);
  arc_grip_free(&h->grip);
  arc_pose_free(&h->pose);
  arc_shape_destroy(&h->shape);
}

static void go(history *h, const friction_step *step) {
  const double pairing = step->by_force ? h->pose.x : step->x;
  arc_friction_copy(&h->before, &h->state);
  check_ok(arc_pose_update(&h->pose, h->shape, pairing, why));
  check_ok(arc_friction_solve(&h->pose, &h->grip, step, &h->state, why));
}

/* --- its conditions ---------------------------------------------------------------------------- */

/* Gaps by the matrices and the gaps of the shape alone. */
static void check_gaps(const history *h) {
  const pose *p = &h->pose;
  const grip *g = &h->grip;
  pose plain;
  assert_int_equal(arc_pose_create(&plain, h->shape->model), ARC_OK);
  check_ok(arc_pose_update(&plain, h->shape, p->x, why));
  for (int c = 0; c < p->count; c++) {
    const double m = p->slope[p->lo + c];
    double gap = plain.gap[c] + m * (h->state.x - p->x) - p->approach;
    for (int k = 0; k < p->count; k++)
      gap += p->a[dense_at(c, k, p->count)] * p->f[k] + g->nt[dense_at(c, k, p->count)] * g->t[k];
    assert_true(p->f[c] >= 0);
    assert_true(gap > -1e-13);
    if (p->f[c] > 0) check_near(gap, 0, 1e-13);
  }
  arc_pose_free(&plain);
}

/* Slip from where the points of both surfaces have gone, not from the matrices. */
static void check_slip(history *h, double p0) {
  const pose *p = &h->pose;
  double *room = calloc((size_t)(2 * p->nc + p->np), sizeof *room), *was = room, *is = was + p->nc;
  arc_grip_relative(p, h->before.u, is + p->nc, was);
  arc_grip_relative(p, h->state.u, is + p->nc, is);
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
    const int n = b == ARC_CYLINDER ? h->pose.nc : h->pose.np;
    double *force = calloc(2 * (size_t)n, sizeof *force);
    arc_friction_forces_on(&h->pose, &h->grip, (arc_body)b, force);
    for (int i = 0; i < 2 * n; i++) sum[b][i / n] += force[i];
    free(force);
  }
  for (int d = 0; d < 2; d++)
    check_near(sum[ARC_CYLINDER][d] + sum[ARC_PLATE][d], 0, 1e-13 * step->line);
  check_near(sum[ARC_CYLINDER][1], step->line, 1e-11 * step->line);
  if (step->by_force) check_near(sum[ARC_CYLINDER][0], step->tangential, 1e-11 * step->line);
  check_near(h->state.tangential, sum[ARC_CYLINDER][0], 1e-12 * step->line);
}

static double largest_pressure(const pose *p) {
  double center, largest;
  arc_pose_peaks(p, &center, &largest);
  return largest;
}

static void check_increment(history *h, const friction_step *step) {
  check_gaps(h);
  check_slip(h, largest_pressure(&h->pose));
  check_resultants(h, step);
}

/* --- random histories -------------------------------------------------------------------------- */

enum { histories = 1000, length = 24 };

typedef struct tally {
  int increments, most, newton, over_10;
  long sweeps, sets;
} tally;

static void count(tally *t, const history *h) {
  t->increments++;
  t->sweeps += h->grip.sweeps;
  t->sets += h->grip.iterations;
  t->newton += h->grip.newton;
  t->over_10 += h->grip.sweeps > 10;
  if (h->grip.sweeps > t->most) t->most = h->grip.sweeps;
}

/* Small and large motions, forces up to what friction carries, other loads, lifting off. */
static friction_step random_step(const history *h) {
  friction_step s = {.mu = h->mu, .line = random_in(20, 110), .x = h->state.x};
  const int kind = random_int(0, 9);
  if (random_int(0, 2) && h->state.line > 0) s.line = h->state.line;
  if (kind == 0) s.line = random_int(0, 1) ? 0 : s.line;
  if (kind >= 1 && kind <= 5) s.x += random_in(-1, 1) * 4e-3 * h->mu;
  if (kind == 6) s.x = random_in(-0.06, 0.06);
  if (kind < 7 || h->slope >= h->mu) return s;
  s.by_force = 1;
  s.tangential = random_in(-0.95, 0.95) * (h->mu - h->slope) * s.line; /* slopes bear some of it */
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

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_random_histories),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

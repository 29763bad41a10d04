/* Tests of stick and slip under loads that change, against Jaeger's sums over layers of load,
 * which are exact at nu = 0. */
#include "space_rubbing.h"

/* The shear of a round contact at nu = 0 as a sum over layers of load X (Jaeger): q = integral of
 * s(X) dp/dX dX with |s| <= mu. Here p is the pressure under the load X, and s is constant within a
 * layer. The sum is exact for any path of load and force. */
typedef struct layers {
  double mu, approach; /* approach under 1 N [mm] */
  double load[64], s[64];
  int count; /* number of layers; layer k extends from load[k - 1] (0 for the first layer) to
              * load[k] */
} layers;

static double approach_at(const layers *j, double load) {
  return j->approach * cbrt(load * load);
}

static double force_below(const layers *j, double load) {
  double sum = 0, from = 0;
  for (int k = 0; k < j->count && from < load; from = j->load[k++])
    sum += j->s[k] * (fmin(load, j->load[k]) - from);
  return sum;
}

static double motion_of(const layers *j) {
  double sum = 0;
  for (int k = 0; k < j->count; k++)
    sum += j->s[k] * (approach_at(j, j->load[k]) - (k > 0 ? approach_at(j, j->load[k - 1]) : 0));
  return sum;
}

/* Returns the elastic energy of the shear [N mm]. */
static double elastic_energy(const layers *j) {
  double sum = 0, from = 0, below = 0;
  for (int k = 0; k < j->count; from = j->load[k++]) {
    const double to = j->load[k], s = j->s[k], start = below - s * from;
    /* adds the integral of s (start + s Y) over the approach under the load Y, whose derivative
     * is proportional to Y^(-1/3) */
    sum += s * (start * (approach_at(j, to) - approach_at(j, from)) +
                s * 0.4 * (to * approach_at(j, to) - from * approach_at(j, from)));
    below += s * (to - from);
  }
  return sum;
}

static void add_layer(layers *j, double below, double load, double s) {
  while (j->count > 0 && (j->count > 1 ? j->load[j->count - 2] : 0) >= below) j->count--;
  if (j->count > 0 && j->load[j->count - 1] > below) j->load[j->count - 1] = below;
  assert_true(j->count < 64);
  j->load[j->count] = load;
  j->s[j->count++] = s;
}

/* Returns the load [N] below which the layers keep their shear when the layers above slip with
 * the shear s. */
static double kept(const layers *j, double load, double force, double s) {
  const double before = j->count > 0 ? j->load[j->count - 1] : 0;
  double low = 0, high = fmin(before, load);
  for (int k = 0; k < 100; k++) {
    const double middle = (low + high) / 2, all = force_below(j, middle) + s * (load - middle);
    if ((all - force) * s > 0)
      low = middle;
    else
      high = middle;
  }
  return low;
}

static void go(layers *j, double load, double force) {
  const double before = j->count > 0 ? j->load[j->count - 1] : 0;
  const double change = force - force_below(j, fmin(before, load)), rise = load - before;
  if (rise > 0 && fabs(change) <= j->mu * rise) {
    add_layer(j, before, load, change / rise);
    return;
  }
  const double s = change > 0 ? j->mu : -j->mu;
  add_layer(j, kept(j, load, force, s), load, s);
}

/* Follows a straight leg of load and force from `from` to `to`. Returns the work of friction [N
 * mm], which is the work of the force minus the increase of the elastic energy. */
static double follow(layers *j, const double from[2], const double to[2]) {
  enum { parts = 400 };
  const layers start = *j;
  double sum = 0, force = from[1], xi = motion_of(j);
  for (int k = 1; k <= parts; k++) {
    const double share = (double)k / parts, now = from[1] + share * (to[1] - from[1]);
    *j = start;
    go(j, from[0] + share * (to[0] - from[0]), now);
    sum += (now + force) / 2 * (motion_of(j) - xi);
    force = now;
    xi = motion_of(j);
  }
  return sum - (elastic_energy(j) - elastic_energy(&start));
}

/* Returns the contact of a ball of R = 10 mm at nu = 0 with friction 0.5. The cell size is
 * `share` times the contact half width under 10 N. */
static rubbing jaeger(int cells, double share, layers *j) {
  arc_halfspace_def def = ball(10, 1, cells);
  def.body[0].material = def.body[1].material = elastic(200e3, 0);
  def.size_x = def.size_z = share * cbrt(3 * 10 * 10.0 / (4 * 100e3));
  rubbing r = {.h = make_space(&def)};
  r.to = (arc_halfspace_increment){.friction = 0.5};
  check_ok(arc_halfspace_friction_begin(r.h, &r.s, why));
  const double one = cbrt(0.75 * 10 / 100e3);
  *j = (layers){.mu = 0.5, .approach = one * one / 10};
  return r;
}

/* Moves the contact from the last load and force to new values in equal increments; with
 * increments = 0 the library chooses the number of increments. */
static void leg(rubbing *r, double load, double force, int increments) {
  const double from = r->to.position.load;
  r->to.by_force[0] = r->to.by_force[1] = 1;
  r->to.position.load = load;
  r->to.force[0] = force;
  const arc_halfspace_leg path = {.to = r->to, .load = from, .increments = increments};
  check_ok(arc_halfspace_follow(r->h, NULL, &path, NULL, &r->s, NULL, &r->effort, why));
}

/* Tests paths of load and force against published displacements. If load and force grow in
 * proportion, the contact sticks, even in one increment. */
static void test_grown(void **state) {
  (void)state;
  static const double path[4][3] = {
      {10, 3, 1.8867e-4}, {7, 3, 2.3648e-4}, {10, 3, 2.3648e-4}, {10, 4, 2.9353e-4}};
  layers j;
  rubbing r = jaeger(41, 2.8 / 41, &j);
  leg(&r, 10, 0, 1);
  go(&j, 10, 0);
  for (int k = 0; k < 4; k++) {
    go(&j, path[k][0], path[k][1]);
    check_share(motion_of(&j), path[k][2], 1e-4);
    leg(&r, path[k][0], path[k][1], 1);
    check_share(r.s.xi[0], path[k][2], 1e-3);
  }
  end(&r);
  for (int n = 1; n <= 4; n *= 4) {
    r = jaeger(41, 2.8 / 41, &j);
    leg(&r, 5, 0, 1);
    leg(&r, 10, 2.4, n);
    go(&j, 5, 0);
    go(&j, 10, 2.4);
    check_share(r.s.xi[0], motion_of(&j), 2e-4);
    end(&r);
    r = jaeger(41, 2.8 / 41, &j);
    leg(&r, 10, 4, n); /* starts at zero load and zero force */
    go(&j, 10, 4);
    check_share(r.s.xi[0], motion_of(&j), 3e-4);
    assert_true(r.s.energy <= 1e-9);
    end(&r);
  }
}

/* Computes six random legs with 28 cells in the half width. off[0] receives the error of the motion
 * relative to the largest motion, off[1] the relative error of the work. */
static void random_layers(double off[2], arc_halfspace_effort *effort) {
  enum { legs = 6 };
  layers j;
  rubbing r = jaeger(79, 2.8 / 79, &j);
  double now[2] = {random_in(4, 16), 0}, work = 0, largest = 0;
  leg(&r, now[0], 0, 1);
  go(&j, now[0], 0);
  off[0] = 0;
  for (int k = 0; k < legs; k++) {
    const double load = random_in(4, 16), to[2] = {load, random_in(-0.475, 0.475) * load};
    work += follow(&j, now, to);
    leg(&r, to[0], to[1], 0);
    memcpy(now, to, sizeof now);
    largest = fmax(largest, fabs(motion_of(&j)));
    off[0] = fmax(off[0], fabs(r.s.xi[0] - motion_of(&j)));
  }
  off[0] /= largest;
  off[1] = fabs(r.s.energy / work - 1);
  effort->increments += r.effort.increments;
  effort->unresolved += r.effort.unresolved;
  effort->flipping += r.effort.flipping;
  effort->unfinished += r.effort.unfinished;
  end(&r);
}

/* Tests motion and work of friction on random paths against Jaeger's sums. The error of the work
 * is of second order in the increments. SPACE_LAYERS sets the number of paths. */
static void test_jaeger(void **state) {
  (void)state;
  const char *wish = getenv("SPACE_LAYERS");
  const int paths = wish ? atoi(wish) : all_tests() ? 4 : 2;
  double motion = 0, work = 0, sum = 0, off[2];
  arc_halfspace_effort all = {0};
  random_start(1897);
  for (int i = 0; i < paths; i++) {
    random_layers(off, &all);
    motion = fmax(motion, off[0]);
    work = fmax(work, off[1]);
    sum += off[1] / paths;
  }
  printf("# %d paths of load and force: motion off by %.2g, work by %.2g on average, %.2g at most; "
         "%d increments\n",
         paths, motion, sum, work, all.increments);
  check_below(motion, 1e-3);
  check_below(work, 0.015);
  printf("# %d flipping, %d unfinished, %d unresolved\n", all.flipping, all.unfinished,
         all.unresolved);
  check_below(all.flipping + all.unfinished + all.unresolved, 1 + all.increments / 100.0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_grown), cmocka_unit_test(test_jaeger)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}

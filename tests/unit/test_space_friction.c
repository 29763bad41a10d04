/* Tests of stick and slip in three dimensions: influence coefficients, closed forms of Mindlin,
 * of Vermeulen and Johnson and of Spence, symmetries, and random paths. */
#include "space_rubbing.h"

#include "core/numeric/convolution.h"
#include "core/space/cerruti.h"
#include "core/space/stick_zone.h"

static const double pi = 3.14159265358979323846;

/* --- kernels ---------------------------------------------------------------------------------- */

static double lag_value(const void *context, int row, int column) {
  const lag_parity parity = *(const lag_parity *)context;
  if ((parity & ODD_ROWS && row == 0) || (parity & ODD_COLUMNS && column == 0)) return 0;
  return 1 / (1.0 + row + 0.3 * column * column);
}

static double direct(lag_parity parity, const double *p, int rows, int columns, int i, int j) {
  double sum = 0;
  for (int k = 0; k < rows; k++)
    for (int l = 0; l < columns; l++) {
      const int sign =
          (parity & ODD_ROWS && k > i ? -1 : 1) * (parity & ODD_COLUMNS && l > j ? -1 : 1);
      sum += sign * lag_value(&parity, abs(i - k), abs(j - l)) * p[k * columns + l];
    }
  return sum;
}

/* Checks that a convolution computed in parts, with a workspace of its own for each part, has the
 * bits of the convolution u. */
static void check_parts(const convolution *c, convolution_work *shared, const double *p,
                        const double *u, int cells) {
  double *again = calloc((size_t)cells, sizeof *again);
  assert_non_null(again);
  for (int stage = 0; stage < 3; stage++)
    for (int part = arc_convolution_parts(c, stage) - 1; part >= 0; part--) {
      convolution_work *own = arc_convolution_work(c);
      arc_convolution_part(c, shared, own, stage, part, p, again);
      arc_convolution_work_free(&own);
    }
  assert_memory_equal(again, u, (size_t)cells * sizeof *u);
  free(again);
}

/* Tests convolutions with kernels of all parities against direct summation, and a pair of fields
 * against separate fields. */
static void test_parity(void **state) {
  (void)state;
  enum { rows = 9, columns = 14, cells = rows * columns };
  random_start(7);
  convolution *c[4];
  double p[2][cells], u[2][cells];
  for (int k = 0; k < cells; k++) p[0][k] = random_in(-1, 1), p[1][k] = random_in(-1, 1);
  for (int k = 0; k < 4; k++) {
    const lag_parity parity = (lag_parity)k;
    check_ok(arc_convolution_create(rows, columns, parity, lag_value, &parity, &c[k], why));
    convolution_work *work = arc_convolution_work(c[k]);
    arc_convolution_apply(c[k], work, p[0], u[0]);
    for (int i = 0; i < rows; i++)
      for (int j = 0; j < columns; j++)
        check_near(u[0][i * columns + j], direct(parity, p[0], rows, columns, i, j), 1e-12);
    check_parts(c[k], work, p[0], u[0], cells);
    arc_convolution_work_free(&work);
  }
  const convolution *const three[3] = {c[EVEN_LAGS], c[ODD_BOTH], c[EVEN_LAGS]};
  convolution_work *work[2] = {arc_convolution_work(c[0]), arc_convolution_work(c[0])};
  arc_convolution_apply_pair(three, work, columns, (const double *const[2]){p[0], p[1]},
                             (double *const[2]){u[0], u[1]});
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < columns; j++)
      for (int f = 0; f < 2; f++)
        check_near(u[f][i * columns + j],
                   direct(EVEN_LAGS, p[f], rows, columns, i, j) +
                       direct(ODD_BOTH, p[1 - f], rows, columns, i, j),
                   1e-12);
  for (int f = 0; f < 2; f++) arc_convolution_work_free(&work[f]);
  for (int k = 0; k < 4; k++) arc_convolution_destroy(&c[k]);
}

/* Tests the influence coefficients of loaded rectangles against integration by the midpoint
 * rule. */
static void test_rectangles(void **state) {
  (void)state;
  enum { points = 200 };
  static const double at[4][2] = {{0.7, 0.2}, {-0.5, 1.1}, {2, -3}, {0, 0.9}};
  const double a = 0.2, b = 0.3, part = 4 * a * b / (points * points);
  for (int k = 0; k < 4; k++) {
    double got[3], sum[4] = {0};
    for (int i = 0; i < points; i++)
      for (int j = 0; j < points; j++) {
        const double x = at[k][0] + a * (2 * (i + 0.5) / points - 1),
                     z = at[k][1] + b * (2 * (j + 0.5) / points - 1), r = hypot(x, z);
        sum[0] += part * x * x / (r * r * r);
        sum[1] += part * x * z / (r * r * r);
        sum[2] += part * z * z / (r * r * r);
        sum[3] += part * x / (r * r);
      }
    arc_cerruti_integrals(at[k][0], at[k][1], a, b, got);
    for (int i = 0; i < 3; i++) check_near(got[i], sum[i], 1e-5);
    check_near(arc_cerruti_couple(at[k][0], at[k][1], a, b), sum[3], 1e-5);
  }
}

/* --- contacts --------------------------------------------------------------------------------- */

/* Increases the tangential force to (x, z) in equal increments. */
static void pull(rubbing *r, double x, double z, int increments) {
  const double from[2] = {r->s.force[0], r->s.force[1]};
  r->to.by_force[0] = r->to.by_force[1] = 1;
  r->work = 0;
  for (int i = 1; i <= increments; i++) {
    const double share = (double)i / increments;
    r->to.force[0] = from[0] + share * (x - from[0]);
    r->to.force[1] = from[1] + share * (z - from[1]);
    slide(r);
  }
}

static void move(rubbing *r, double x, double z) {
  r->to.by_force[0] = r->to.by_force[1] = 0;
  r->to.xi[0] = x;
  r->to.xi[1] = z;
  r->work = 0;
  slide(r);
}

static double stick_area(const rubbing *r) {
  const arc_halfspace_def *d = arc_halfspace_definition(r->h);
  return sum_of(r->s.stick, d->nx * d->nz) * d->size_x * d->size_z;
}

/* Checks that the shear is within the friction bound and that slip has the direction of the
 * shear. */
static void check_coulomb(const rubbing *r, double scale) {
  const arc_halfspace_def *d = arc_halfspace_definition(r->h);
  for (int k = 0; k < d->nx * d->nz; k++) {
    const double q = hypot(r->s.q[0][k], r->s.q[1][k]), bound = r->to.friction * r->s.pressure[k];
    check_below(q - bound, 1e-8 * scale + 1e-300);
    if (r->s.stick[k] == 0)
      check_below(-(r->s.q[0][k] * r->s.moved[0][k] + r->s.q[1][k] * r->s.moved[1][k]),
                  1e-9 * bound + 1e-300);
  }
}

/* Presses a ball of R = 10 mm by 10 N with friction 0.5 and returns the contact. The window is
 * 2.3 contact half widths wide and has `cells` cells along each side; `a` receives the half
 * width [mm]. */
static rubbing mindlin(double nu, int cells, double *a) {
  arc_halfspace_def def = ball(10, 1, cells);
  def.body[0].material = def.body[1].material = elastic(200e3, nu);
  *a = cbrt(3 * 10 * 10.0 / (4 * 200e3 / (2 * (1 - nu * nu))));
  def.size_x = def.size_z = 2.3 * *a / cells;
  return press(&def, 10, 0.5);
}

/* Tests the displacement, stick radius and dissipated work of a force cycle against Mindlin. At
 * nu = 0.3 the shear across the motion reduces the work by 0.42 %. */
static void test_mindlin(void **state) {
  (void)state;
  static const double share[4] = {0.2, 0.4, 0.7, 0.95};
  for (int k = 0; k < 5; k++) {
    const double nu = k < 4 ? 0 : 0.3, f = k < 4 ? share[k] : 0.6, P = 10, mu = 0.5;
    double a;
    rubbing r = mindlin(nu, 65, &a);
    const double S = 4 * (2 - nu) * (1 + nu) / 200e3, c = cbrt(1 - f);
    const double xi = 3 * mu * P / (16 * a) * S * (1 - c * c);
    const double loop = 0.9 * mu * mu * P * P / a * S * (1 - pow(c, 5) - 5 * f / 6 * (1 + c * c));
    pull(&r, f * mu * P, 0, 2);
    check_share(r.s.xi[0], xi, k < 4 ? 5e-5 : 1e-3);
    check_near(sqrt(stick_area(&r) / pi), c * a, 2.3 * a / 65 / 2);
    pull(&r, -f * mu * P, 0, 2);
    check_share(r.s.xi[0], -xi, k < 4 ? 5e-5 : 1e-3);
    check_share(2 * r.work, k < 4 ? loop : loop * (1 - 0.0042), k < 4 ? 4e-3 : 5e-4);
    check_near(r.s.force[0], -f * mu * P, 1e-5);
    check_near(r.s.force[1], 0, 1e-9);
    check_coulomb(&r, 600);
    assert_int_equal(r.effort.flipping, 0);
    end(&r);
  }
}

/* Tests that the same contact in a wider window has the same displacement, shear and slip, also
 * at cells outside the contact. In the wider window convolutions use boxes, parts of the window
 * that contain all loaded cells. */
static void test_wide_window(void **state) {
  (void)state;
  enum { few = 33, many = 101, beyond = (many - few) / 2 };
  double a;
  rubbing narrow = mindlin(0.3, few, &a);
  arc_halfspace_def def = *arc_halfspace_definition(narrow.h);
  def.nx = def.nz = many;
  rubbing wide = press(&def, 10, 0.5);
  pull(&narrow, 2, 1, 2);
  pull(&wide, 2, 1, 2);
  const double slid = hypot(wide.s.xi[0], wide.s.xi[1]);
  for (int c = 0; c < 2; c++) {
    check_share(wide.s.xi[c], narrow.s.xi[c], 1e-6);
    for (int i = 0; i < few; i++)
      for (int k = 0; k < few; k++) {
        const int at = i * few + k, same = (i + beyond) * many + k + beyond;
        check_near(wide.s.q[c][same], narrow.s.q[c][at], 1e-3);
        check_near(wide.s.slip[c][same], narrow.s.slip[c][at], 1e-5 * slid);
      }
  }
  end(&narrow);
  end(&wide);
}

/* Tests an elliptical contact at nu = 0 with motion along either axis against the closed form of
 * Vermeulen and Johnson. */
static void test_ellipse(void **state) {
  (void)state;
  for (int along = 0; along < 2; along++) {
    arc_halfspace_def def = ball(5, 0.006, 29);
    def.body[0].material = def.body[1].material = elastic(200e3, 0);
    def.body[ARC_UPPER].radius_z = 20;
    def.size_x = def.size_z = 0.0713 / 11.3;
    def.nz = 67;
    rubbing r = press(&def, 20, 0.5);
    pull(&r, along == 0 ? 6 : 0, along == 0 ? 0 : 6, 2);
    check_share(r.s.xi[along], 2.9180e-4, 2e-4);
    check_near(r.s.xi[1 - along], 0, 1e-9);
    pull(&r, along == 0 ? -6 : 0, along == 0 ? 0 : -6, 2);
    check_share(2 * r.work, 3.4945e-4, 5e-3);
    end(&r);
  }
}

/* Returns the ratio k of stick radius to contact radius under a normal load alone, from Spence's
 * equation ln((1 + k) / (1 - k)) / (2 k) = mu / beta K'(k). */
static double spence(double mu_over_beta) {
  double low = 1e-6, high = 1 - 1e-12;
  for (int i = 0; i < 100; i++) {
    const double k = (low + high) / 2;
    double a = 1, b = k; /* K'(k) = pi / (2 agm(1, k)) */
    for (int j = 0; j < 20; j++) {
      const double mean = (a + b) / 2;
      b = sqrt(a * b);
      a = mean;
    }
    if (log((1 + k) / (1 - k)) / (2 * k) < mu_over_beta * pi / (2 * a))
      low = k;
    else
      high = k;
  }
  return low;
}

/* Returns the relative error of the stick radius against Spence's equation. The contact radius
 * grows in equal steps, and the pressures are those of a contact without friction, as Spence
 * assumes. */
static double spence_error(arc_material hard, arc_material soft, double mu, int cells, int steps) {
  arc_halfspace_def def = ball(10, 1, cells);
  def.body[ARC_UPPER].material = hard;
  def.body[ARC_LOWER].material = soft;
  double yield[2], couple[2]; /* (1 - nu) / G and (1 - 2 nu) / G of each body */
  for (int b = 0; b < 2; b++) {
    const arc_material m = def.body[b].material;
    yield[b] = 2 * (1 + m.nu) * (1 - m.nu) / m.E;
    couple[b] = 2 * (1 + m.nu) * (1 - 2 * m.nu) / m.E;
  }
  const double beta = fabs(couple[1] - couple[0]) / (2 * (yield[0] + yield[1]));
  const double a = cbrt(3 * 10 * 10 * (yield[0] + yield[1]) / (2 * 4));
  def.size_x = def.size_z = 2.3 * a / cells;
  rubbing r = {.h = make_space(&def)};
  check_ok(arc_halfspace_friction_begin(r.h, &r.s, why));
  double *p = make_values((size_t)(cells * cells));
  for (int i = 1; i <= steps; i++) {
    r.to = (arc_halfspace_increment){
        .friction = mu, .position.load = 10 * pow((double)i / steps, 3), .pressure = p};
    double approach;
    check_ok(arc_halfspace_solve(r.h, NULL, &r.to.position, NULL, p, &approach, NULL, why));
    slide(&r);
  }
  const double error = sqrt(stick_area(&r) / pi) / a / spence(mu / beta) - 1;
  print_message("# beta %.4f, mu %g, %d cells: sticks to %.4f of the radius (%+.2f %%)\n", beta, mu,
                cells, spence(mu / beta) * (1 + error), 100 * error);
  free(p);
  end(&r);
  return error;
}

/* Tests the stick radius of steel on PEEK and of a rigid ball on a body of nu = 0.2. The stick zone
 * consists of whole cells. Eight cells change its radius by 0.4 % on a grid of 65 x 65 cells, so
 * the mean error over five cell sizes is checked, too. */
static void test_spence(void **state) {
  (void)state;
  const arc_material steel = elastic(200e3, 0.3), peek = elastic(3600, 0.4);
  double mean[2] = {0, 0};
  for (int cells = 61; cells <= 69; cells += 2) {
    const double error[2] = {spence_error(steel, peek, 0.1, cells, 64),
                             spence_error(elastic(1e12, 0.3), elastic(1000, 0.2), 0.3, cells, 64)};
    for (int i = 0; i < 2; i++) {
      check_near(error[i], 0, 7e-3);
      mean[i] += error[i] / 5;
    }
  }
  check_near(mean[0], 0, 3e-3);
  check_near(mean[1], 0, 3e-3);
  if (all_tests()) check_near(spence_error(steel, peek, 0.1, 129, 96), 0, 3e-3);
}

/* --- symmetries ------------------------------------------------------------------------------- */

/* Computes a path of forces and motions for the given pair of bodies. The path can be rotated by
 * quarter turns (`turned`) or mirrored. */
static rubbing along_path(const arc_halfspace_def *def, int turned, int mirrored) {
  static const double force[2][2] = {{1.5, 0.4}, {-2, 1}};
  const double sign = mirrored ? -1 : 1;
  rubbing r = press(def, 10, 0.4);
  for (int k = 0; k < 2; k++)
    pull(&r, turned ? force[k][1] : sign * force[k][0], turned ? force[k][0] : force[k][1], 2);
  const double to[2] = {sign * 5e-4, 2e-4};
  move(&r, turned ? to[1] : to[0], turned ? to[0] : to[1]);
  return r;
}

static void check_same(const rubbing *a, const rubbing *b, int turned, int mirrored,
                       int exchanged) {
  const int n = arc_halfspace_definition(a->h)->nx;
  const double sign = mirrored ? -1 : 1;
  check_share(b->s.energy, a->s.energy, 1e-6);
  check_share(b->s.force[turned], sign * a->s.force[0], 1e-6);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      const int x = mirrored || exchanged ? n - 1 - i : i, z = exchanged ? n - 1 - j : j;
      const int k = turned ? z * n + x : x * n + z;
      check_near(b->s.pressure[k], a->s.pressure[i * n + j], 1e-2);
      check_near(b->s.q[turned][k], sign * a->s.q[0][i * n + j], 2e-2);
      check_near(b->s.q[1 - turned][k], a->s.q[1][i * n + j], 2e-2);
    }
}

/* Tests that results are symmetric under exchange of x and z, under mirroring in x, and under
 * exchange of the bodies. For exchanged bodies the problem is rotated by half a turn and the
 * forces are the same. */
static void test_symmetries(void **state) {
  (void)state;
  arc_halfspace_def def = ball(10, 0.0095, 25);
  def.body[ARC_LOWER].material = elastic(3600, 0.4);
  def.size_x = def.size_z = 0.03;
  rubbing plain = along_path(&def, 0, 0), turned = along_path(&def, 1, 0),
          mirrored = along_path(&def, 0, 1);
  check_same(&plain, &turned, 1, 0, 0);
  check_same(&plain, &mirrored, 0, 1, 0);
  arc_halfspace_def other = def;
  other.body[ARC_LOWER] = def.body[ARC_UPPER];
  other.body[ARC_UPPER] = def.body[ARC_LOWER];
  rubbing exchanged = along_path(&other, 0, 0);
  check_same(&plain, &exchanged, 0, 0, 1);
  check_coulomb(&plain, 100);
  end(&plain);
  end(&turned);
  end(&mirrored);
  end(&exchanged);
}

/* Tests that in a round contact of like bodies a path along z gives the same results as along x,
 * within the tolerance of the solver. */
static void test_round(void **state) {
  (void)state;
  static const double force[] = {3, -2, 4, 0, -4.5, 1};
  double a;
  rubbing along[2];
  for (int axis = 0; axis < 2; axis++) {
    rubbing *r = &along[axis];
    *r = mindlin(0.3, 33, &a);
    r->options.tolerance = 1e-9;
    for (size_t i = 0; i < sizeof force / sizeof *force; i++)
      pull(r, axis == 0 ? force[i] : 0, axis == 1 ? force[i] : 0, 1);
  }
  check_share(along[1].s.xi[1], along[0].s.xi[0], 1e-9);
  check_share(along[1].s.energy, along[0].s.energy, 1e-9);
  for (int axis = 0; axis < 2; axis++) end(&along[axis]);
}

/* --- random paths ----------------------------------------------------------------------------- */

/* Returns a contact of two random bodies with a ratio of moduli up to ten and friction 0.05 to
 * 1.2. */
static rubbing random_contact(double *stuck) {
  const double ratio = exp(random_in(-log(10), log(10))), mu = exp(random_in(log(0.05), log(1.2)));
  arc_halfspace_def def = ball(10, 1, 17);
  def.body[0].material = elastic(200e3, random_in(0, 0.49));
  def.body[1].material = elastic(200e3 * ratio, random_in(0, 0.49));
  double compliance = 0;
  for (int b = 0; b < ARC_BODIES; b++) compliance += 1 / arc_material_E_star(def.body[b].material);
  const double a = cbrt(0.75 * 10 * 10 * compliance);
  def.size_x = def.size_z = 3.1 * a / 17;
  *stuck = mu * 10 * compliance / a;
  return press(&def, 10 * random_in(0.5, 1), mu);
}

/* Computes one random leg with constant or changed load, to a motion or a force in any
 * direction. Returns the number of increments. */
static int random_leg(rubbing *r, double stuck) {
  const double before = r->to.position.load, force = hypot(r->s.force[0], r->s.force[1]);
  const int forced = random_int(0, 1), parts = random_int(1, 4);
  double load = random_int(0, 1) ? before : random_in(3, 19);
  if (forced && force >= 0.98 * r->to.friction * load) load = before;
  const double limit = forced ? 0.97 * r->to.friction * fmin(load, before) : 2 * stuck;
  const double size = random_in(0, limit), angle = random_in(0, 2 * pi);
  const double goal[2] = {size * cos(angle), size * sin(angle)};
  double from[2];
  for (int i = 0; i < 2; i++) from[i] = forced ? r->s.force[i] : r->s.xi[i];
  r->to.by_force[0] = r->to.by_force[1] = forced;
  for (int k = 1; k <= parts; k++) {
    const double share = (double)k / parts;
    for (int i = 0; i < 2; i++)
      r->to.xi[i] = r->to.force[i] = from[i] + share * (goal[i] - from[i]);
    r->to.position.load = before + share * (load - before);
    slide(r);
    check_coulomb(r, 1);
  }
  return parts;
}

/* Tests that every increment of random paths satisfies Coulomb's conditions and has converged.
 * SPACE_PATHS sets the number of paths. */
static void test_random_paths(void **state) {
  (void)state;
  const char *wish = getenv("SPACE_PATHS");
  const int paths = wish ? atoi(wish) : 25;
  arc_halfspace_effort all = {0};
  int increments = 0;
  random_start(28);
  for (int k = 0; k < paths; k++) {
    double stuck;
    rubbing r = random_contact(&stuck);
    for (int leg = 0; leg < 5; leg++) increments += random_leg(&r, stuck);
    assert_true(r.s.energy >= 0);
    all.sweeps += r.effort.sweeps;
    all.iterations += r.effort.iterations;
    all.flipping += r.effort.flipping;
    all.unfinished += r.effort.unfinished;
    end(&r);
  }
  printf("# %d paths, %d increments: %d sweeps, %d steps of conjugate gradients, %d with flipping "
         "cells, %d unfinished\n",
         paths, increments, all.sweeps, all.iterations, all.flipping, all.unfinished);
  assert_true(100 * all.flipping <= increments);
  assert_int_equal(all.unfinished, 0);
}

/* Tests that a failed increment leaves the state unchanged and that layers and periodic windows
 * are refused. */
static void test_refused(void **state) {
  (void)state;
  double a;
  rubbing r = mindlin(0.3, 21, &a);
  pull(&r, 2, 0, 1);
  const double xi = r.s.xi[0], q = r.s.q[0][21 * 10 + 10];
  r.to.force[0] = 5.1;
  check_refused(arc_halfspace_slide(r.h, NULL, &r.to, NULL, &r.s, NULL, why), ARC_ARGUMENT,
                "tangential");
  assert_true(r.s.xi[0] == xi && r.s.q[0][21 * 10 + 10] == q);
  end(&r);
  arc_halfspace_def def = ball(10, 0.01, 21);
  def.body[ARC_LOWER].depth = 1;
  arc_halfspace *h = make_space(&def);
  arc_halfspace_friction s;
  const arc_halfspace_increment to = {.friction = 0.5, .position = {.load = 1}};
  check_ok(arc_halfspace_friction_begin(h, &s, why));
  check_refused(arc_halfspace_slide(h, NULL, &to, NULL, &s, NULL, why), ARC_ARGUMENT, "friction");
  arc_halfspace_friction_end(&s);
  arc_halfspace_destroy(&h);
}

/* --- cells of stick zones --------------------------------------------------------------------- */

/* Tests that the cells fitted to stick zones scale with the zones, are the same for exchanged axes,
 * and are at most a sixth smaller than the given size. */
static void test_stick_zone(void **state) {
  (void)state;
  random_start(11);
  for (int k = 0; k < 20; k++) {
    const double x = random_in(8, 40), z = random_in(8, 40), annulus = random_in(3, 8);
    const double cell = arc_stick_zone_cell(1, x, z, annulus);
    assert_true(cell <= 1 && cell >= 5.0 / 6);
    assert_true(arc_stick_zone_cell(1, z, x, annulus) == cell);
    assert_true(arc_stick_zone_cell(0.25, 0.25 * x, 0.25 * z, 0.25 * annulus) == 0.25 * cell);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_stick_zone),   cmocka_unit_test(test_parity),
      cmocka_unit_test(test_rectangles),   cmocka_unit_test(test_mindlin),
      cmocka_unit_test(test_wide_window),  cmocka_unit_test(test_ellipse),
      cmocka_unit_test(test_spence),       cmocka_unit_test(test_symmetries),
      cmocka_unit_test(test_random_paths), cmocka_unit_test(test_round),
      cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

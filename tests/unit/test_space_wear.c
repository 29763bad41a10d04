/* Tests of wear in three dimensions: histories against an independent program and closed forms,
 * volumes, symmetries, and stability of explicit steps. */
#include "space_shared.h"

static const double pi = 3.14159265358979323846;

/* Returns the definition of a wear run with a ball of R = 10 mm, cells of dx and a track long
 * enough for the stroke. */
static history_def reciprocating(double load, double dx, int n, double alpha, double stroke,
                                 double distance) {
  history_def d = {.space = ball(10, dx, n), .load = load, .k = 1e-8, .alpha = alpha};
  d.stroke = stroke;
  d.distance = distance;
  d.increments = stroke > 0 ? (int)lround(stroke / dx) : 0;
  d.space.track = n + 2 * (int)ceil(stroke / 2 / dx - 1e-9);
  d.steps = 24;
  d.first = 16;
  return d;
}

/* Checks the wear volume k P d, the share alpha of the upper body, and the symmetry of both
 * surfaces, which is exact in x and within 1e-9 in z. */
static void check_history(const history *w, const history_def *d) {
  const double volume = d->k * d->load * d->distance;
  check_near(volume_of(w, ARC_UPPER), d->alpha * volume, 1e-12 * volume);
  check_near(volume_of(w, ARC_LOWER), (1 - d->alpha) * volume, 1e-12 * volume);
  for (int b = 0; b < ARC_BODIES; b++) {
    const int nz = d->space.nz, rows = arc_halfspace_sites(w->h, (arc_body)b) / nz;
    const double most = largest_of(w->depth[b], rows * nz);
    for (int i = 0; i < rows; i++)
      for (int j = 0; j < nz; j++) {
        const double here = w->depth[b][i * nz + j];
        if (d->increments > 0) assert_true(here == w->depth[b][(rows - 1 - i) * nz + j]);
        check_near(here, w->depth[b][i * nz + nz - 1 - j], 1e-9 * most);
      }
  }
}

/* --- tables ----------------------------------------------------------------------------------- */

typedef struct row {
  double alpha, stroke, upper, lower, share; /* stroke and depths [mm], and the relative
                                              * tolerance of the depths */
} row;

/* Checks the first two rows of a table; with tests/run -a, all rows. */
static void check_rows(const row *rows, int count, double load, double dx, int n, double distance) {
  if (!all_tests()) count = 2;
  for (int k = 0; k < count; k++) {
    history_def d = reciprocating(load, dx, n, rows[k].alpha, rows[k].stroke, distance);
    if (rows[k].alpha == 1) d.increments = 0;
    history w = run_history(&d);
    check_history(&w, &d);
    print_message("# P %g stroke %g alpha %g: %.6g %.6g, reference %.6g %.6g\n", load,
                  rows[k].stroke, rows[k].alpha, depth_of(&w, ARC_UPPER), depth_of(&w, ARC_LOWER),
                  rows[k].upper, rows[k].lower);
    check_share(depth_of(&w, ARC_UPPER), rows[k].upper, rows[k].share);
    check_share(depth_of(&w, ARC_LOWER), rows[k].lower, rows[k].share);
    free_history(&w);
  }
}

/* Tests depths by a ball under 10 N over 1320 mm with short strokes against an independent
 * program with the same cells. */
static void test_short_strokes(void **state) {
  (void)state;
  static const row rows[] = {{0, .04, 0, 1.97333e-3, 3e-4},
                             {.5, .04, 1.01401e-3, 9.8532e-4, 3e-4},
                             {.25, .04, 5.1384e-4, 1.47537e-3, 3e-4},
                             {.75, .04, 1.50853e-3, 4.9526e-4, 3e-4},
                             {1, 0, 2.00459e-3, 0, 3e-4}};
  check_rows(rows, 5, 10, 0.01, 49, 1320);
}

static void test_long_strokes(void **state) {
  (void)state;
  static const row rows[] = {{0, 1, 0, 7.3231e-4, 1e-3}, {.5, 1, 1.31788e-3, 2.8773e-4, 1e-3}};
  check_rows(rows, 2, 10, 0.01, 49, 1320);
}

/* Tests depths by a ball under 30 N over 3000 mm against an independent program. */
static void test_deep_scars(void **state) {
  (void)state;
  static const row rows[] = {{1, 0, 5.2699e-3, 0, 3e-4},
                             {.5, .12, 2.7963e-3, 2.3964e-3, 3e-4},
                             {0, .12, 0, 5.0166e-3, 3e-4},
                             {.5, .36, 3.1105e-3, 1.8247e-3, 3e-4},
                             {0, .36, 0, 4.3539e-3, 3e-4}};
  check_rows(rows, 5, 30, 0.015, 53, 3000);
}

/* Tests that the depths converge with second order in the cell size. */
static void test_order(void **state) {
  (void)state;
  double depth[3];
  for (int k = 0; k < 3; k++) {
    const int fine = 4 << k, n = 5 * fine + 1;
    const double dx = 0.0880442 / fine;
    history_def d = reciprocating(10, dx, n, 0.5, 0.0880442, 600);
    d.space.track = n + fine;
    history w = run_history(&d);
    depth[k] = depth_of(&w, ARC_UPPER);
    free_history(&w);
  }
  print_message("# depths at a/4, a/8, a/16: %.6g %.6g %.6g\n", depth[0], depth[1], depth[2]);
  check_share(depth[1], depth[2], 3e-3);
  assert_true(fabs(depth[1] - depth[2]) < fabs(depth[0] - depth[1]) / 2.5);
}

/* Tests the scar of a ball that wears alone, a cap with V = pi R h^2 and c^2 = 2 R h. */
static void test_cap(void **state) {
  (void)state;
  history_def d = reciprocating(10, 0.02, 81, 1, 0, 20000);
  history w = run_history(&d);
  const double h = sqrt(2e-3 / (pi * 10));
  check_share(depth_of(&w, ARC_UPPER), h, 6e-3);
  const arc_halfspace_extent scar = arc_halfspace_scar(w.h, ARC_UPPER, w.depth[ARC_UPPER], 0.01);
  check_share(scar.half_width, sqrt(2 * 10 * h), 0.02);
  check_share(scar.half_width_z, scar.half_width, 1e-6);
  free_history(&w);
}

/* --- steps ------------------------------------------------------------------------------------ */

/* Tests equal steps from the unworn ball, including a single step of 3000 mm, against 48 graded
 * steps. */
static void test_any_step(void **state) {
  (void)state;
  static const double share[3] = {0.35, 0.03, 1e-3};
  history_def d = reciprocating(30, 0.015, 53, 0.5, 0.12, 3000);
  d.steps = 48;
  history graded = run_history(&d);
  d.first = 0;
  for (int k = 0; k < 3; k++) {
    d.steps = k == 0 ? 1 : k == 1 ? 2 : 8;
    history w = run_history(&d);
    print_message("# %d equal steps: %.5g of %.5g\n", d.steps, depth_of(&w, ARC_UPPER),
                  depth_of(&graded, ARC_UPPER));
    check_history(&w, &d);
    check_share(depth_of(&w, ARC_UPPER), depth_of(&graded, ARC_UPPER), share[k]);
    free_history(&w);
  }
  free_history(&graded);
}

/* Returns the amplitude of the ripple [mm] after explicit Euler steps whose length is `share`
 * times the stability limit 1.168 dx / (k E*). */
static double ripple_after(double share, int steps) {
  history_def d = reciprocating(10, 0.01, 49, 1, 0, 0);
  history w = make_history(&d);
  const double length = share * 1.168 * 0.01 / (d.k * steel_modulus);
  const double *const depth[ARC_BODIES] = {w.depth[0], w.depth[1]};
  const arc_halfspace_options options = {.warm = 1};
  for (int s = 0; s < steps; s++) {
    check_ok(
        arc_halfspace_rate(w.h, depth, w.position, 1, &options, w.pressure, w.known, NULL, why));
    for (int k = 0; k < 49 * 49; k++) w.depth[0][k] += d.k * length * w.known[0][k];
  }
  static const double difference[5] = {1, -4, 6, -4, 1};
  double ripple = 0;
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 5; j++)
      ripple += difference[i] * difference[j] * w.depth[0][(22 + i) * 49 + 22 + j] / 256;
  free_history(&w);
  return fabs(ripple);
}

static void test_explicit_limit(void **state) {
  (void)state;
  const double smooth = ripple_after(0.95, 62), rough = ripple_after(1.05, 62);
  print_message("# ripple below and above the limit: %g %g mm\n", smooth, rough);
  assert_true(rough > 20 * smooth);
}

static int stop_at_once(void *context) {
  (void)context;
  return 1;
}

/* Tests the largest eigenvalue for a single contact: 2 / eigenvalue equals the stability limit
 * 1.168 dx / (k E*). */
static void test_eigenvalue(void **state) {
  (void)state;
  history_def d = reciprocating(10, 0.005, 49, 1, 0, 0);
  history w = make_history(&d);
  const double *const depth[ARC_BODIES] = {w.depth[0], w.depth[1]};
  check_ok(arc_halfspace_rate(w.h, depth, w.position, 1, NULL, w.pressure, w.known, NULL, why));
  const arc_halfspace_wear wear = {.c = {d.k, 0}};
  double eigenvalue;
  check_ok(arc_halfspace_eigenvalue(w.h, &wear, w.position, 1, w.pressure, NULL, &eigenvalue, why));
  check_share(2 / eigenvalue, 1.168 * 0.005 / (d.k * steel_modulus), 0.03);
  const arc_callbacks stop = {.stop = stop_at_once};
  check_refused(
      arc_halfspace_eigenvalue(w.h, &wear, w.position, 1, w.pressure, &stop, &eigenvalue, why),
      ARC_STOPPED, "stopped");
  free_history(&w);
}

/* --- exchange of bodies, grooves, wear factors ------------------------------------------------ */

/* Computes one stage with the ball as the upper body at x = -2 .. 3 cells, or with the same ball
 * as the lower body, moving in the opposite direction. Writes the depths of the ball and of the
 * flat. */
static void stage_of(int below, double *upper, double *lower) {
  enum { small = 41, large = 51 };
  const double dx = 0.0880442 / 8;
  arc_halfspace_def def = ball(10, dx, small);
  arc_halfspace_position position[6];
  def.track = large;
  if (below) {
    def.body[ARC_UPPER].radius_x = def.body[ARC_UPPER].radius_z = 0;
    def.body[ARC_LOWER].radius_x = def.body[ARC_LOWER].radius_z = 10;
    def.nx = large;
    def.track = large + 10;
  }
  for (int k = 0; k < 6; k++)
    position[k] = (arc_halfspace_position){
        .x = (below ? -1 : 1) * (k - 2) * dx, .load = 10 + k, .weight = 0.5 + 0.1 * k};
  arc_halfspace *h = make_space(&def);
  const arc_halfspace_wear wear = {.c = {below ? 7e-7 : 3e-7, below ? 3e-7 : 7e-7}};
  const arc_halfspace_options options = {.tolerance = 1e-8};
  double *p = make_values((size_t)(6 * def.nx * def.nz));
  double *depth[ARC_BODIES] = {make_values((size_t)(def.nx * def.nz)),
                               make_values((size_t)(def.track * def.nz))};
  check_ok(arc_halfspace_stage(h, NULL, &wear, position, 6, &options, p, depth, NULL, why));
  for (int i = 0; i < small; i++)
    for (int j = 0; j < small; j++)
      upper[i * small + j] = below ? depth[1][(i + 10) * small + j] : depth[0][i * small + j];
  memcpy(lower, depth[below ? 0 : 1], large * small * sizeof *lower);
  free(depth[0]);
  free(depth[1]);
  free(p);
  arc_halfspace_destroy(&h);
}

/* Tests that exchanging the bodies exchanges their depths. */
static void test_exchange(void **state) {
  (void)state;
  static double upper[2][41 * 41], lower[2][51 * 41];
  for (int k = 0; k < 2; k++) stage_of(k, upper[k], lower[k]);
  const double most = largest_of(lower[0], 51 * 41);
  assert_true(most > 1e-4);
  for (int k = 0; k < 41 * 41; k++) check_near(upper[1][k], upper[0][k], 1e-6 * most);
  for (int k = 0; k < 51 * 41; k++) check_near(lower[1][k], lower[0][k], 1e-6 * most);
}

/* Tests a stroke of eleven contact widths, computed with one position and a groove, against a
 * computation with all positions. */
static void test_groove(void **state) {
  (void)state;
  static const double upper[3] = {0, 1.31788e-3, 1.68647e-3},
                      lower[3] = {7.3231e-4, 2.8773e-4, 1.3841e-4};
  for (int k = 0; k < 3; k++) {
    history_def d = reciprocating(10, 0.01, 49, k * 0.5 - (k == 2) * 0.25, 0, 1320);
    d.space.track = 0;
    d.space.groove = 1;
    history w = run_history(&d);
    check_history(&w, &d);
    print_message("# groove, alpha %g: %.5g %.5g, all positions %.5g %.5g\n", d.alpha,
                  depth_of(&w, ARC_UPPER), depth_of(&w, ARC_LOWER), upper[k], lower[k]);
    check_share(depth_of(&w, ARC_UPPER), upper[k], 5e-3);
    check_share(depth_of(&w, ARC_LOWER), lower[k], 0.03);
    free_history(&w);
  }
}

/* Tests positions between cell centres: the volumes are exact and the depths almost unchanged. */
static void test_fractions(void **state) {
  (void)state;
  double depth[2][ARC_BODIES];
  for (int k = 0; k < 2; k++) {
    const double stroke = 0.12;
    history_def d = reciprocating(30, 0.015, 53, 0.5, stroke, 500);
    if (k) {
      d.space.size_x = d.space.size_z = 0.0147;
      d.space.track = 53 + 10;
    }
    history w = run_history(&d);
    check_history(&w, &d);
    for (int b = 0; b < ARC_BODIES; b++) depth[k][b] = depth_of(&w, (arc_body)b);
    free_history(&w);
  }
  for (int b = 0; b < ARC_BODIES; b++) check_share(depth[1][b], depth[0][b], 3e-3);
}

/* Tests that doubling the wear factor of a body equals doubling its wear coefficient. */
static void test_factors(void **state) {
  (void)state;
  enum { n = 41, rows = 49 };
  arc_halfspace_def def = ball(10, 0.0880442 / 8, n);
  def.track = rows;
  static double factor[rows * n], depth[2][2][rows * n];
  arc_halfspace *h = make_space(&def);
  arc_halfspace_position position[3];
  for (int k = 0; k < 3; k++)
    position[k] = (arc_halfspace_position){.x = (k - 1) * 4 * def.size_x, .load = 10, .weight = 1};
  for (int k = 0; k < rows * n; k++) factor[k] = 2;
  for (int k = 0; k < 2; k++) {
    const arc_halfspace_wear wear = {.c = {2e-7, k ? 4e-7 : 2e-7},
                                     .factor = {NULL, k ? NULL : factor}};
    double *const to[ARC_BODIES] = {depth[k][0], depth[k][1]};
    check_ok(arc_halfspace_stage(h, NULL, &wear, position, 3, NULL, NULL, to, NULL, why));
  }
  for (int k = 0; k < rows * n; k++) check_near(depth[0][1][k], depth[1][1][k], 1e-15);
  arc_halfspace_destroy(&h);
}

/* --- worker threads, larger windows, failed stages -------------------------------------------- */

static void test_workers(void **state) {
  (void)state;
  history_def d = reciprocating(10, 0.0110055, 43, 0.5, 0.0880442, 600);
  d.steps = 6;
  d.increments = 7; /* 7 increments: positions are between the cell centres */
  d.space.track = 43 + 10;
  history one = run_history(&d);
  d.space.workers = 4;
  history four = run_history(&d);
  for (int b = 0; b < ARC_BODIES; b++)
    assert_memory_equal(one.depth[b], four.depth[b],
                        (size_t)arc_halfspace_sites(one.h, (arc_body)b) * sizeof(double));
  const double *const depth[ARC_BODIES] = {one.depth[0], one.depth[1]};
  check_ok(arc_halfspace_rate(one.h, depth, one.position, one.count, NULL, one.pressure, one.known,
                              NULL, why));
  check_ok(arc_halfspace_rate(four.h, depth, one.position, one.count, NULL, four.pressure,
                              four.known, NULL, why));
  assert_memory_equal(one.pressure, four.pressure, (size_t)one.count * 43 * 43 * sizeof(double));
  assert_memory_equal(one.known[1], four.known[1], 53 * 43 * sizeof(double));
  check_ok(arc_halfspace_sum(four.h, one.position, one.count, one.pressure, ARC_LOWER, four.half[1],
                             why));
  for (int k = 0; k < 53 * 43; k++) check_near(four.half[1][k], one.known[1][k], 1e-9);
  free_history(&one);
  free_history(&four);
}

/* Tests that depths are copied to larger windows and keep their volume on finer cells. */
static void test_regrow(void **state) {
  (void)state;
  history_def d = reciprocating(10, 0.01, 41, 0.5, 0.04, 200);
  d.steps = 4;
  history w = run_history(&d);
  const double *const depth[ARC_BODIES] = {w.depth[0], w.depth[1]};
  for (int k = 0; k < 2; k++) {
    history_def e = reciprocating(10, k ? 0.006 : 0.01, k ? 81 : 61, 0.5, 0.04, 200);
    e.increments = 4;
    history grown = make_history(&e);
    check_ok(arc_halfspace_regrow(w.h, depth, grown.h, grown.depth, why));
    for (int b = 0; b < ARC_BODIES; b++)
      check_share(volume_of(&grown, (arc_body)b), volume_of(&w, (arc_body)b), 1e-12);
    check_share(depth_of(&grown, ARC_UPPER), depth_of(&w, ARC_UPPER), k ? 0.01 : 1e-15);
    const double *const back[ARC_BODIES] = {grown.depth[0], grown.depth[1]};
    if (k == 0) check_ok(arc_halfspace_regrow(grown.h, back, w.h, w.known, why));
    free_history(&grown);
  }
  assert_memory_equal(w.known[1], w.depth[1], 45 * 41 * sizeof(double));
  history_def small = reciprocating(10, 0.01, 15, 0.5, 0.04, 200);
  history narrow = make_history(&small);
  check_refused(arc_halfspace_regrow(w.h, depth, narrow.h, narrow.depth, why), ARC_ZONE, "worn");
  free_history(&narrow);
  free_history(&w);
}

/* Tests that a failed stage leaves depths and pressures unchanged. */
static void test_failures(void **state) {
  (void)state;
  history_def d = reciprocating(10, 0.01, 25, 0.5, 0.04, 5000);
  history w = make_history(&d);
  const arc_halfspace_wear wear = {.c = {1e-4, 1e-4}}, wrong = {.c = {-1, 0}};
  const double *const known[ARC_BODIES] = {w.depth[0], w.depth[1]};
  w.pressure[5] = 7;
  check_refused(arc_halfspace_stage(w.h, known, &wear, w.position, w.count, NULL, w.pressure,
                                    w.depth, NULL, why),
                ARC_ZONE, "window");
  check_refused(arc_halfspace_stage(w.h, known, &wrong, w.position, w.count, NULL, w.pressure,
                                    w.depth, NULL, why),
                ARC_ARGUMENT, "'c'");
  w.position[1].weight = 0;
  check_refused(arc_halfspace_stage(w.h, known, &wear, w.position, w.count, NULL, w.pressure,
                                    w.depth, NULL, why),
                ARC_ARGUMENT, "weight");
  assert_true(w.pressure[5] == 7 && largest_of(w.depth[1], 29 * 25) == 0);
  free_history(&w);
}

/* Tests volumes and symmetry for random radii, moduli, strokes, alpha and step lengths.
 * ARCHARD_HISTORIES sets the number of histories (default 12). */
static void test_random_histories(void **state) {
  (void)state;
  const char *wish = getenv("ARCHARD_HISTORIES");
  const int histories = wish ? atoi(wish) : 12;
  long guarded = 0, stages = 0, applications = 0;
  random_start(727);
  for (int k = 0; k < histories; k++) {
    const double radius = exp(random_in(log(0.5), log(500))), stiffness = exp(random_in(-3, 3));
    history_def d = {.space = ball(radius, 0.01, 8), .load = exp(random_in(log(0.5), log(50)))};
    d.space.body[ARC_UPPER].radius_z = radius * exp(random_in(-1, 1));
    d.space.body[ARC_UPPER].material.E *= stiffness;
    d.space.body[ARC_LOWER].material.nu = random_in(0, 0.49);
    arc_halfspace_fit(&d.space, d.load, 0, 0, 0, 6);
    const double a = 6 * d.space.size_x, volume = random_in(0, 12) * pow(a, 4) / radius;
    d.alpha = random_int(0, 4) / 4.0;
    d.stroke = random_in(0, 8) * a;
    d.increments = random_int(0, 3) ? (int)ceil(d.stroke / a * random_in(1, 4)) : 0;
    d.k = 1e-8;
    d.distance = volume / (d.k * d.load);
    arc_halfspace_fit(&d.space, d.load, 4 * volume, d.stroke, 0, 6);
    d.space.track += 2; /* positions between cell centres need one more cell on either side */
    d.space.groove = d.increments == 0 && random_int(0, 1) ? d.stroke + a : 0;
    d.steps = random_int(1, 4);
    history w = run_history(&d);
    check_history(&w, &d);
    guarded += w.guarded > 0;
    stages += w.stages;
    applications += w.applications;
    free_history(&w);
  }
  print_message("# %d histories: %.1f applications a stage, %ld with the fallback\n", histories,
                (double)applications / (double)stages, guarded);
}

/* --- below the surface ------------------------------------------------------------------------ */

/* Tests stresses below a ball against Hertz theory: the largest von Mises stress is 0.620 p0 at the
 * depth 0.48 a, and the radial stress at the centre of the surface is -(1 + 2 nu) / 2 p0. */
static void test_stress(void **state) {
  (void)state;
  enum { n = 41, middle = (n * n - 1) / 2 };
  const double a = 0.0880442, p0 = 615.942;
  const arc_halfspace_def def = ball(10, 2.4 * a / n, n);
  solved s = solve_space(&def, 10, 1e-6);
  double *stress = make_values(6 * n * n), most = 0, deepest = 0;
  for (int k = 0; k <= 40; k++) {
    const double y = -k * 0.02 * a;
    check_ok(arc_halfspace_stress(s.h, s.p, 0.3, y, stress, why));
    const double x = stress[middle], down = stress[n * n + middle], z = stress[2 * n * n + middle];
    const double mises =
        sqrt(((x - down) * (x - down) + (down - z) * (down - z) + (z - x) * (z - x)) / 2);
    check_share(down, -p0 / (1 + y * y / a / a), 3e-3);
    check_near(x, -p0 * (1.3 * (1 + y / a * (k ? atan(-a / y) : 0)) - 0.5 / (1 + y * y / a / a)),
               4e-3 * p0);
    check_near(x, z, 1e-6 * p0);
    if (mises > most) deepest = -y;
    most = fmax(most, mises);
  }
  check_near(most / p0, 0.620, 0.003);
  check_near(deepest / a, 0.48, 0.021);
  check_refused(arc_halfspace_stress(s.h, s.p, 0.3, 0.1, stress, why), ARC_ARGUMENT, "'y'");
  free(stress);
  free_solved(&s);
}

/* Tests the balance of forces along x and y on thin horizontal slabs of each cell column. */
static void test_equilibrium(void **state) {
  (void)state;
  enum { n = 64 };
  arc_halfspace_def def = ball(10, 0.0880442 / 10, n);
  def.body[ARC_UPPER].radius_z = 25;
  solved s = solve_space(&def, 10, 1e-6);
  double *above = make_values(6 * n * n), *below = make_values(6 * n * n), worst = 0;
  const double dy = 0.002, y = -0.03;
  check_ok(arc_halfspace_stress(s.h, s.p, 0.3, y + dy / 2, above, why));
  check_ok(arc_halfspace_stress(s.h, s.p, 0.3, y - dy / 2, below, why));
  for (int i = 8; i < n - 8; i++)
    for (int j = 8; j < n - 8; j++) {
      const int k = i * n + j;
      const double *const planes[2] = {above, below};
      double force[2] = {0};
      for (int m = 0; m < 2; m++) {
        const double *t = planes[m];
        const double *xx = t, *yy = t + n * n, *xy = t + 3 * n * n, *yz = t + 4 * n * n,
                     *xz = t + 5 * n * n, sign = m ? -1 : 1;
        force[0] +=
            (xx[k + n] - xx[k - n] + xz[k + 1] - xz[k - 1]) / (4 * def.size_x) + sign * xy[k] / dy;
        force[1] +=
            (xy[k + n] - xy[k - n] + yz[k + 1] - yz[k - 1]) / (4 * def.size_x) + sign * yy[k] / dy;
      }
      worst = fmax(worst, fmax(fabs(force[0]), fabs(force[1])));
    }
  /* tolerance relative to p0 / a */
  check_below(worst, 0.03 * largest_of(s.p, n * n) / 0.0880442);
  free(above);
  free(below);
  free_solved(&s);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_short_strokes),
      cmocka_unit_test(test_long_strokes),
      cmocka_unit_test(test_deep_scars),
      cmocka_unit_test(test_order),
      cmocka_unit_test(test_cap),
      cmocka_unit_test(test_any_step),
      cmocka_unit_test(test_explicit_limit),
      cmocka_unit_test(test_eigenvalue),
      cmocka_unit_test(test_exchange),
      cmocka_unit_test(test_groove),
      cmocka_unit_test(test_fractions),
      cmocka_unit_test(test_factors),
      cmocka_unit_test(test_workers),
      cmocka_unit_test(test_regrow),
      cmocka_unit_test(test_failures),
      cmocka_unit_test(test_stress),
      cmocka_unit_test(test_random_histories),
      cmocka_unit_test(test_equilibrium),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

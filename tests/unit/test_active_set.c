/* Tests of the active-set solver: three rigid unknowns per block, cells of different area,
 * coupled blocks, and the fallback method. */
#include "check.h"

#include "core/numeric/active_set.h"
#include "core/numeric/active_work.h"

enum { side = 9, n = side * side, blocks = 2, modes = 3 };

/* A dense compliance matrix whose entries decrease with the distance and which is self-adjoint
 * with respect to the cell areas. */
static double kernel[n][n], area[n], mode[modes][n], gap[blocks][n], load[blocks][modes];

static void set_up_problem(void) {
  for (int k = 0; k < n; k++) {
    const double x = k / side - 4.0, z = k % side - 4.0;
    area[k] = 1 + 0.03 * x;
    mode[0][k] = 1;
    mode[1][k] = x;
    mode[2][k] = z;
    for (int b = 0; b < blocks; b++) gap[b][k] = (0.2 + 0.1 * b) * (x * x + 0.7 * z * z);
  }
  for (int k = 0; k < n; k++)
    for (int l = 0; l < n; l++)
      kernel[k][l] = area[l] / (0.4 + hypot(mode[1][k] - mode[1][l], mode[2][k] - mode[2][l]));
  for (int b = 0; b < blocks; b++) {
    load[b][0] = 8 + b;
    load[b][1] = 3;
    load[b][2] = -2;
  }
}

static arc_status apply(void *context, const double *p, double *u) {
  const double coupling = *(double *)context;
  for (int b = 0; b < blocks; b++)
    for (int k = 0; k < n; k++) {
      double sum = coupling * p[(1 - b) * n + k];
      for (int l = 0; l < n; l++) sum += kernel[k][l] * p[b * n + l];
      u[b * n + k] = sum;
    }
  return ARC_OK;
}

static void check_solution(const double *p, const double *delta, const double *g, double coupling) {
  double u[blocks * n];
  apply(&coupling, p, u);
  for (int b = 0; b < blocks; b++) {
    double carried[modes] = {0};
    for (int k = 0; k < n; k++) {
      double open = u[b * n + k] + gap[b][k];
      for (int m = 0; m < modes; m++) {
        open -= delta[b * modes + m] * mode[m][k];
        carried[m] += area[k] * mode[m][k] * p[b * n + k];
      }
      check_near(g[b * n + k], open, 1e-9);
      assert_true(p[b * n + k] >= 0 && open > -1e-6);
      if (p[b * n + k] > 0) check_near(open, 0, 1e-6);
    }
    for (int m = 0; m < modes; m++) check_near(carried[m], load[b][m], 1e-9);
  }
}

static void solve(double coupling, int guarded, double *p) {
  const active_problem problem = {.blocks = blocks,
                                  .cells = n,
                                  .modes = modes,
                                  .gap = gap[0],
                                  .area = area,
                                  .mode = mode[0],
                                  .load = load[0],
                                  .apply = apply,
                                  .context = &coupling,
                                  .tolerance = 1e-8};
  active_work *work = arc_active_work_create(blocks, n, modes, 0);
  active_count count = {0};
  double delta[blocks * modes];
  assert_non_null(work);
  for (int k = 0; k < blocks * n; k++) p[k] = 1;
  if (guarded) {
    pass s = {.problem = &problem, .w = work, .p = p};
    check_ok(arc_active_guard(&s, &count, why));
    assert_true(count.guarded > 0);
  } else {
    check_ok(arc_active_set_solve(&problem, work, p, delta, &count, why));
    assert_true(count.guarded == 0 && count.sets > 0);
    check_solution(p, delta, arc_active_set_gaps(work), coupling);
  }
  arc_active_work_destroy(&work);
}

/* Tests that loads and both moments of each block are balanced, with separate and with coupled
 * blocks, while some cells are open. */
static void test_three_modes(void **state) {
  (void)state;
  double p[blocks * n];
  for (int k = 0; k < 2; k++) {
    int open = 0;
    solve(k * 0.3, 0, p);
    for (int c = 0; c < blocks * n; c++) open += p[c] == 0;
    assert_true(open > 10 && open < blocks * n - 10);
  }
}

/* Tests that the fallback method gives the same pressures as the main method. */
static void test_fallback(void **state) {
  (void)state;
  double p[blocks * n], q[blocks * n];
  solve(0.3, 0, p);
  solve(0.3, 1, q);
  for (int c = 0; c < blocks * n; c++) check_near(q[c], p[c], 1e-5);
}

/* Tests that a problem with fewer cells than rigid unknowns is refused: such cells cannot carry
 * a load. */
static void test_singular(void **state) {
  (void)state;
  double p[blocks * n] = {0}, delta[blocks * modes], coupling = 0;
  const active_problem problem = {.blocks = blocks,
                                  .cells = n,
                                  .modes = modes,
                                  .gap = gap[0],
                                  .area = area,
                                  .mode = mode[0],
                                  .load = load[0],
                                  .apply = apply,
                                  .context = &coupling,
                                  .tolerance = 1e-8};
  active_work *work = arc_active_work_create(blocks, n, modes, 0);
  active_count count = {0};
  p[40] = p[n + 40] = 1;
  check_refused(arc_active_set_solve(&problem, work, p, delta, &count, why), ARC_NUMERIC, "carry");
  arc_active_work_destroy(&work);
}

int main(void) {
  set_up_problem();
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_three_modes),
      cmocka_unit_test(test_fallback),
      cmocka_unit_test(test_singular),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

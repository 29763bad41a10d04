/* Tests of the complementarity solver for contact on random matrices against an enumeration of
 * all active sets: cold and warm start, Newton and fallback method, degenerate problems. The
 * file includes lcp.c, whose fallback is static. */
#include "check.h"

#include "core/contact/lcp.c"

enum { most = 80 };

/* Returns a contact problem of n candidate nodes in which only the fields used by lcp.c are
 * allocated. */
static contact_problem room(int n) {
  contact_problem p = {.nc = n, .np = n, .count = n};
  p.set = calloc((size_t)n, sizeof(int));
  p.a = calloc((size_t)(n * n), sizeof(double));
  p.factor = calloc((size_t)(n * n), sizeof(double));
  p.gap = calloc((size_t)n, sizeof(double));
  p.f = calloc((size_t)n, sizeof(double));
  p.open = calloc((size_t)n, sizeof(double));
  p.ones = calloc((size_t)n, sizeof(double));
  p.joined = calloc(2 * (size_t)n, sizeof(int));
  p.made = p.joined + n;
  p.down = malloc((size_t)n * sizeof(double));
  for (int k = 0; k < n; k++) p.down[k] = 1;
  p.step = calloc(2 * (size_t)n, sizeof(double));
  return p;
}

static void room_free(contact_problem *p) {
  free(p->set);
  free(p->joined);
  free(p->a);
  free(p->factor);
  free(p->gap);
  free(p->f);
  free(p->open);
  free(p->ones);
  free(p->down);
  free(p->step);
}

/* Sets the matrix to A = G G' + ridge I with a random matrix G [n x rank]. A is positive
 * definite without special structure; a low rank and a small ridge make it ill-conditioned. */
static void random_matrix(contact_problem *p, int rank, double ridge) {
  const int n = p->count;
  double *g = malloc((size_t)(n * rank) * sizeof *g);
  for (int k = 0; k < n * rank; k++) g[k] = random_in(-1, 1);
  for (int r = 0; r < n; r++)
    for (int c = 0; c <= r; c++) {
      double sum = r == c ? ridge : 0;
      for (int k = 0; k < rank; k++) sum += g[r * rank + k] * g[c * rank + k];
      p->a[dense_at(r, c, n)] = p->a[dense_at(c, r, n)] = sum;
    }
  free(g);
  p->factored = 0;
}

/* Fills the problem with integer data, which cause ties: gaps and forces that are exactly zero. */
static void whole_numbers(contact_problem *p) {
  const int n = p->count;
  memset(p->a, 0, (size_t)(n * n) * sizeof(double));
  for (int r = 0; r < n; r++) {
    for (int c = 0; c < r; c++)
      p->a[dense_at(r, c, n)] = p->a[dense_at(c, r, n)] = random_int(-1, 1);
    p->a[dense_at(r, r, n)] = n;
    p->gap[r] = random_int(0, 2);
  }
  p->factored = 0;
}

static void random_gaps(contact_problem *p, double high) {
  for (int k = 0; k < p->count; k++) p->gap[k] = random_in(0, high);
}

/* Returns the largest violation of the conditions f >= 0, g >= 0, f g = 0 and sum f = load, in
 * units of force. */
static double defect(const contact_problem *p, double load, const double *f, double approach) {
  double worst = 0, sum = 0, size = fabs(load);
  for (int k = 0; k < p->count; k++) size = fmax(size, fabs(f[k]));
  for (int r = 0; r < p->count; r++) {
    double gap = p->gap[r] - approach, scale = fabs(p->gap[r]) + fabs(approach);
    for (int c = 0; c < p->count; c++) {
      gap += p->a[dense_at(r, c, p->count)] * f[c];
      scale += fabs(p->a[dense_at(r, c, p->count)] * f[c]);
    }
    sum += f[r];
    worst = fmax(worst, -f[r] / size);
    worst = fmax(worst, f[r] > 0 ? fabs(gap) / scale : -gap / scale);
  }
  return fmax(worst, fabs(sum - load) / size);
}

static void check_solution(const contact_problem *p, double load) {
  check_below(defect(p, load, p->f, p->approach), 1e-9);
  for (int s = 1; s < p->active; s++) assert_true(p->set[s] > p->set[s - 1]);
}

/* Computes the forces f and the approach for one active set, by Gauss elimination on the matrix
 * [A -1; 1' 0]. */
static int solve_set(const contact_problem *p, unsigned set, double load, double *f,
                     double *approach) {
  double m[9 * 9], x[9];
  int list[8], pivots[9], n = 0;
  for (int k = 0; k < p->count; k++)
    if (set & (1u << k)) list[n++] = k;
  for (int r = 0; r < n; r++) {
    for (int c = 0; c < n; c++)
      m[dense_at(r, c, n + 1)] = p->a[dense_at(list[r], list[c], p->count)];
    m[dense_at(r, n, n + 1)] = -1;
    m[dense_at(n, r, n + 1)] = 1;
    x[r] = -p->gap[list[r]];
  }
  m[dense_at(n, n, n + 1)] = 0;
  x[n] = load;
  if (arc_dense_factor(n + 1, m, pivots)) return 0;
  arc_dense_factor_solve(n + 1, 1, m, pivots, x);
  memset(f, 0, 8 * sizeof *f);
  for (int r = 0; r < n; r++) f[list[r]] = x[r];
  *approach = x[n];
  return 1;
}

static void try_all_sets(const contact_problem *p, double load, double *best, double *approach) {
  double least = INFINITY;
  for (unsigned set = 1; set < 1u << p->count; set++) {
    double f[8], at;
    if (!solve_set(p, set, load, f, &at)) continue;
    const double miss = defect(p, load, f, at);
    if (miss >= least) continue;
    least = miss;
    memcpy(best, f, sizeof f);
    *approach = at;
  }
  check_below(least, 1e-9);
}

/* --- tests ------------------------------------------------------------------------------------ */

static void test_against_all_sets(void **state) {
  (void)state;
  random_start(31);
  for (int trial = 0; trial < 400; trial++) {
    contact_problem p = room(random_int(1, 8));
    const double load = exp(random_in(-5, 3));
    random_matrix(&p, p.count, 0.1);
    random_gaps(&p, 3);
    double f[8], approach = 0;
    try_all_sets(&p, load, f, &approach);
    assert_int_equal(arc_lcp_solve(&p, load), ARC_OK);
    check_near(p.approach, approach, 1e-9 * (1 + fabs(approach)));
    for (int k = 0; k < p.count; k++) check_near(p.f[k], f[k], 1e-8 * load);
    room_free(&p);
  }
}

/* Tests that starts from zero, from the last solution and from random active sets give the same
 * solution. */
static void test_warm_start(void **state) {
  (void)state;
  random_start(32);
  for (int trial = 0; trial < 200; trial++) {
    contact_problem p = room(random_int(2, most));
    double first[most];
    random_matrix(&p, p.count, 1e-2);
    random_gaps(&p, 5);
    assert_int_equal(arc_lcp_solve(&p, 2), ARC_OK);
    check_solution(&p, 2);
    memcpy(first, p.f, (size_t)p.count * sizeof *first);
    assert_int_equal(arc_lcp_solve(&p, 2), ARC_OK);
    assert_int_equal(p.iterations, 1);
    for (int k = 0; k < p.count; k++) check_near(p.f[k], first[k], 1e-12);
    p.active = 0;
    p.factored = 0;
    for (int k = 0; k < p.count; k++)
      if (random_in(0, 1) < 0.5) p.set[p.active++] = k;
    assert_int_equal(arc_lcp_solve(&p, 2), ARC_OK);
    check_solution(&p, 2);
    for (int k = 0; k < p.count; k++) check_near(p.f[k], first[k], 1e-9);
    room_free(&p);
  }
}

/* Tests the fallback method on ill-conditioned matrices, for which the Newton method sometimes
 * cycles. At least one such case is required. */
static void test_newton_gives_up(void **state) {
  (void)state;
  random_start(33);
  int gave_up = 0;
  for (int trial = 0; trial < 300; trial++) {
    contact_problem p = room(most);
    random_matrix(&p, most / 5, 1e-4);
    random_gaps(&p, 1);
    double *fs = p.step;
    gave_up += newton(&p, 1, fs) == 0;
    p.active = 0;
    p.factored = 0;
    assert_int_equal(arc_lcp_solve(&p, 1), ARC_OK);
    check_solution(&p, 1);
    room_free(&p);
  }
  print_message("# Newton gave up in %d of 300\n", gave_up);
  assert_true(gave_up > 0);
}

static void test_fallback_alone(void **state) {
  (void)state;
  random_start(34);
  for (int trial = 0; trial < 300; trial++) {
    contact_problem p = room(random_int(1, most));
    random_matrix(&p, 1 + p.count / random_int(1, 5), exp(random_in(-9, 2)));
    random_gaps(&p, exp(random_in(-3, 3)));
    const double load = exp(random_in(-5, 5));
    double *fs = p.step;
    assert_int_equal(descend(&p, load, fs), 1);
    check_solution(&p, load);
    check_below(p.iterations, 20.0 * p.count + 20);
    room_free(&p);
  }
}

/* Tests degenerate problems with ties: gaps and forces that are exactly zero. */
static void test_degenerate(void **state) {
  (void)state;
  random_start(35);
  for (int trial = 0; trial < 2000; trial++) {
    contact_problem p = room(random_int(1, 12));
    whole_numbers(&p);
    const double load = random_int(1, 4);
    double *fs = p.step;
    assert_int_equal(descend(&p, load, fs), 1);
    check_solution(&p, load);
    p.active = 0;
    p.factored = 0;
    p.iterations = 0;
    assert_int_equal(arc_lcp_solve(&p, load), ARC_OK);
    check_solution(&p, load);
    room_free(&p);
  }
}

/* Tests a sequence of changing gaps that resembles a wear run: each solution starts from the
 * last active set. */
static void test_path(void **state) {
  (void)state;
  random_start(36);
  contact_problem p = room(most);
  random_matrix(&p, p.count, 1);
  random_gaps(&p, 5);
  for (int step = 0; step < 300; step++) {
    for (int k = 0; k < p.count; k++) p.gap[k] = fmax(0, p.gap[k] + random_in(-0.1, 0.1));
    assert_int_equal(arc_lcp_solve(&p, 3), ARC_OK);
    check_solution(&p, 3);
  }
  room_free(&p);
}

static void test_not_definite(void **state) {
  (void)state;
  contact_problem p = room(2);
  p.a[0] = p.a[3] = 1;
  p.a[1] = p.a[2] = 2;
  assert_int_equal(arc_lcp_solve(&p, 1), ARC_NUMERIC);
  room_free(&p);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_against_all_sets), cmocka_unit_test(test_warm_start),
      cmocka_unit_test(test_newton_gives_up),  cmocka_unit_test(test_fallback_alone),
      cmocka_unit_test(test_degenerate),       cmocka_unit_test(test_path),
      cmocka_unit_test(test_not_definite),
  };
  return cmocka_run_group_tests_name("lcp", tests, NULL, NULL);
}

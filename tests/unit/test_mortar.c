/* Tests of the mortar coupling matrix B: rows of B sum to one and reproduce linear functions,
 * and forces and moments balance, at any position of the plate and on worn surfaces. The tests
 * use internal functions of contact. */
#include "check.h"

#include "core/base/dense.h"
#include "core/contact/contact_problem.h"

static arc_shape *make_shape(arc_model *model) {
  arc_shape *shape = NULL;
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
  return shape;
}

/* Returns a model whose plate zone is so wide that the cylinder can slide far on it. */
static arc_model *make_model(void) {
  arc_model_def def = coarse_definition();
  def.mesh.zone[ARC_PLATE] = 1.9;
  return build_model(&def);
}

static contact_problem place(const arc_shape *shape, double x) {
  contact_problem p;
  assert_int_equal(arc_contact_problem_create(&p, arc_shape_model(shape)), ARC_OK);
  check_ok(arc_contact_problem_couple(&p, shape, x, why));
  return p;
}

static double cylinder_x(const arc_shape *shape, const contact_problem *p, int k) {
  return shape->side[ARC_CYLINDER].settled[2 * (p->lo + k)];
}

static double plate_x(const arc_shape *shape, const contact_problem *p, int l) {
  return shape->side[ARC_PLATE].settled[2 * l] + p->x;
}

/* Checks B 1 = 1 and B x = x for the mortar matrix B. */
static void check_rows(const arc_shape *shape, const contact_problem *p) {
  double *v = calloc((size_t)(p->np + p->nc), sizeof *v), *at_cylinder = v + p->np;
  for (int l = 0; l < p->np; l++) v[l] = 1;
  arc_contact_problem_to_cylinder(p, v, at_cylinder);
  for (int k = 0; k < p->count; k++) check_near(at_cylinder[p->lo + k], 1, 1e-13);
  for (int l = 0; l < p->np; l++) v[l] = plate_x(shape, p, l);
  arc_contact_problem_to_cylinder(p, v, at_cylinder);
  for (int k = 0; k < p->count; k++)
    check_near(at_cylinder[p->lo + k], cylinder_x(shape, p, k), 1e-13);
  free(v);
}

/* Checks that forces on the cylinder are transferred to the plate with the same sum and the same
 * moment. */
static void check_balance(const arc_shape *shape, const contact_problem *p) {
  double *f = calloc((size_t)(p->np + p->nc), sizeof *f), *on_plate = f + p->nc;
  double sum[2] = {0}, moment[2] = {0}, size = 0;
  for (int k = 0; k < p->count; k++) {
    const double force = random_in(0, 10);
    f[p->lo + k] = force;
    sum[0] += force;
    moment[0] += force * cylinder_x(shape, p, k);
    size += fabs(force);
  }
  arc_contact_problem_to_plate(p, f, on_plate);
  for (int l = 0; l < p->np; l++) {
    sum[1] += on_plate[l];
    moment[1] += on_plate[l] * plate_x(shape, p, l);
  }
  check_near(sum[1], sum[0], 1e-13 * size);
  check_near(moment[1], moment[0], 1e-13 * size);
  free(f);
}

/* Checks the forces of a solution on worn surfaces: their sums along x and y, and their
 * directions along the plate's normals. */
static void check_forces(const arc_shape *shape, double x) {
  contact_problem p;
  assert_int_equal(arc_contact_problem_create(&p, arc_shape_model(shape)), ARC_OK);
  check_ok(arc_contact_problem_update(&p, shape, x, why));
  check_ok(arc_contact_problem_solve(&p, 100, why));
  double *c = calloc((size_t)(2 * p.nc + 2 * p.np), sizeof *c), *l = c + 2 * p.nc;
  double sum[ARC_BODIES][2] = {{0}}, along_x = 0;
  arc_contact_problem_forces_on(&p, ARC_CYLINDER, c);
  arc_contact_problem_forces_on(&p, ARC_PLATE, l);
  for (int d = 0; d < 2; d++) {
    for (int i = 0; i < p.nc; i++) sum[ARC_CYLINDER][d] += c[d * p.nc + i];
    for (int i = 0; i < p.np; i++) sum[ARC_PLATE][d] += l[d * p.np + i];
  }
  for (int i = 0; i < p.nc; i++) along_x += fabs(c[i]);
  assert_true(along_x > 0.01); /* without forces along x their balance would be trivial */
  check_near(sum[ARC_CYLINDER][0], -sum[ARC_PLATE][0], 1e-11);
  check_near(sum[ARC_CYLINDER][1], 100, 1e-10);
  check_near(sum[ARC_PLATE][1], -100, 1e-10);
  for (int k = 0; k < p.count; k++)
    check_near(c[p.lo + k], -p.slope[p.lo + k] * p.f[k], 1e-13 * 100);
  free(c);
  arc_contact_problem_free(&p);
}

/* Checks (B v)'f = v'(B'f): the transfers of displacements and of forces use the same matrix. */
static void check_adjoint(const contact_problem *p) {
  double *v = calloc((size_t)(2 * p->np + 2 * p->nc), sizeof *v);
  double *bv = v + p->np, *f = bv + p->nc, *bf = f + p->nc, one = 0, other = 0;
  for (int l = 0; l < p->np; l++) v[l] = random_in(-1, 1);
  for (int k = 0; k < p->count; k++) f[p->lo + k] = random_in(-1, 1);
  arc_contact_problem_to_cylinder(p, v, bv);
  arc_contact_problem_to_plate(p, f, bf);
  for (int i = 0; i < p->nc; i++) one += bv[i] * f[i];
  for (int l = 0; l < p->np; l++) other += bf[l] * v[l];
  check_near(one, other, 1e-12);
  free(v);
}

static void check_at(const arc_shape *shape, double x) {
  contact_problem p = place(shape, x);
  assert_true(p.count >= 3 && p.lo >= 1 && p.lo + p.count <= p.nc - 1);
  check_rows(shape, &p);
  check_balance(shape, &p);
  check_adjoint(&p);
  arc_contact_problem_free(&p);
}

static void test_random_positions(void **state) {
  (void)state;
  random_start(21);
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model);
  for (int trial = 0; trial < 200; trial++) check_at(shape, random_in(-1.3, 1.3));
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Tests plate positions with nodes opposite to each other, and positions half an element off. */
static void test_special_positions(void **state) {
  (void)state;
  random_start(22);
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model);
  for (int i = -20; i <= 20; i++) check_at(shape, i * 0.02);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Tests a groove with slopes up to 0.15, where pressures act along the normals of the groove. */
static void test_slopes(void **state) {
  (void)state;
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model);
  const arc_mesh *m = arc_model_mesh(model, ARC_PLATE);
  double *depth = malloc((size_t)m->surface * sizeof *depth);
  for (int i = 0; i < m->surface; i++) {
    const double at = m->xy[2 * m->surface_node[i]] / 0.3;
    depth[i] = fabs(at) < 1 ? 0.02 * (1 - at * at) : 0;
  }
  check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
  const shape_side *plate = &shape->side[ARC_PLATE];
  double steepest = 0;
  for (int i = 0; i < plate->n; i++) steepest = fmax(steepest, shape_compliance(plate)->slope[i]);
  assert_true(steepest > 0.1 && steepest < 0.15);
  for (int i = -3; i <= 3; i++) check_forces(shape, 0.033 * i);
  free(depth);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Tests that depths corrected by arc_shape_conserve reduce the area of the polygon by exactly the
 * area of the depths. */
static void test_conserve(void **state) {
  (void)state;
  random_start(25);
  arc_model *model = make_model();
  for (int geometry = ARC_MOVING; geometry <= ARC_FROZEN; geometry++) {
    arc_shape *shape = NULL;
    check_ok(arc_shape_create(model, (arc_geometry)geometry, 0.1, &shape, why));
    const shape_side *side = &shape->side[ARC_CYLINDER];
    double *depth = calloc((size_t)side->n, sizeof *depth), wanted = 0, lost = 0;
    for (int pass = 0; pass < 5; pass++) {
      for (int i = 1; i + 1 < side->n; i++) {
        depth[i] = 2e-3 * exp(-pow(side->x0[i] / 0.2, 2));
        wanted += depth[i] * arc_shape_span(shape, ARC_CYLINDER, i);
      }
      arc_shape_conserve(shape, ARC_CYLINDER, depth);
      check_ok(arc_shape_wear(shape, ARC_CYLINDER, depth, why));
    }
    const arc_mesh *m = arc_model_mesh(model, ARC_CYLINDER);
    for (int i = 0; i + 1 < side->n; i++) {
      const double *a = &side->xy[2 * i], *b = a + 2;
      const double *a0 = &m->xy[2 * m->surface_node[i]], *b0 = &m->xy[2 * m->surface_node[i + 1]];
      lost += (b[0] - a[0]) * (b[1] + a[1]) / 2 - (b0[0] - a0[0]) * (b0[1] + a0[1]) / 2;
    }
    check_share(lost, wanted, 1e-12);
    free(depth);
    arc_shape_destroy(&shape);
  }
  arc_model_release(&model);
}

static void test_worn(void **state) {
  (void)state;
  random_start(23);
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model);
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = arc_model_mesh(model, (arc_body)b)->surface;
    double *depth = malloc((size_t)n * sizeof *depth);
    for (int pass = 0; pass < 4; pass++) {
      for (int i = 0; i < n; i++) depth[i] = random_in(0, 0.006);
      check_ok(arc_shape_wear(shape, (arc_body)b, depth, why));
    }
    free(depth);
  }
  for (int trial = 0; trial < 100; trial++) check_at(shape, random_in(-1.2, 1.2));
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Tests B with each plate node below a cylinder node: at x = 0 on flat surfaces with equal nodes
 * B is the identity. */
static void test_matching_nodes(void **state) {
  (void)state;
  arc_model_def def = coarse_definition();
  def.radius =
      2000; /* with this radius the x coordinates of both bodies' nodes differ by at most 1e-7 mm */
  def.mesh.far = 200;
  arc_model *model = build_model(&def);
  arc_shape *shape = make_shape(model);
  contact_problem p = place(shape, 0);
  for (int k = 0; k < p.count; k++)
    for (int q = 0; q < p.width; q++) {
      if (p.first[k] + q >= p.np) continue;
      const double apart = plate_x(shape, &p, p.first[k] + q) - cylinder_x(shape, &p, k);
      check_near(p.b[k * p.width + q], fabs(apart) < 1e-3 ? 1 : 0, 1e-4);
    }
  arc_contact_problem_free(&p);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Tests that the contact matrix is exactly symmetric. */
static void test_matrix(void **state) {
  (void)state;
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model);
  contact_problem p = place(shape, 0.0123);
  arc_contact_problem_assemble(&p, shape);
  for (int r = 0; r < p.count; r++)
    for (int c = 0; c < r; c++)
      assert_true(p.a[dense_at(r, c, p.count)] == p.a[dense_at(c, r, p.count)]);
  arc_contact_problem_free(&p);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

static void test_apart(void **state) {
  (void)state;
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model);
  contact_problem p;
  assert_int_equal(arc_contact_problem_create(&p, model), ARC_OK);
  for (int side = -1; side <= 1; side += 2) {
    check_refused(arc_contact_problem_couple(&p, shape, side * 1.5, why), ARC_ZONE,
                  "do not overlap");
    check_refused(arc_contact_problem_couple(&p, shape, side * 100, why), ARC_ZONE,
                  "do not overlap");
  }
  check_ok(arc_contact_problem_couple(&p, shape, 0, why));
  check_rows(shape, &p);
  arc_contact_problem_free(&p);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Checks that an updated contact problem equals a new one for the same shape and position, bit
 * by bit. */
static void check_fresh(const contact_problem *p, const arc_shape *shape, double x) {
  contact_problem fresh;
  assert_int_equal(arc_contact_problem_create(&fresh, arc_shape_model(shape)), ARC_OK);
  check_ok(arc_contact_problem_update(&fresh, shape, x, why));
  const size_t n = (size_t)p->count;
  assert_int_equal(p->lo, fresh.lo);
  assert_int_equal(p->count, fresh.count);
  assert_memory_equal(p->first, fresh.first, n * sizeof *p->first);
  assert_memory_equal(p->a, fresh.a, n * n * sizeof *p->a);
  assert_memory_equal(p->gap, fresh.gap, n * sizeof *p->gap);
  arc_contact_problem_free(&fresh);
}

/* Tests that a contact problem is updated correctly after changes of its shape, of copies of the
 * shape and of the plate's position, even after a position that was refused. */
static void test_update(void **state) {
  (void)state;
  random_start(24);
  arc_model *model = make_model();
  arc_shape *shape = make_shape(model), *copy = NULL;
  const int n = arc_model_mesh(model, ARC_PLATE)->surface;
  double *depth = malloc((size_t)n * sizeof *depth);
  contact_problem p;
  assert_int_equal(arc_contact_problem_create(&p, model), ARC_OK);
  check_ok(arc_contact_problem_update(&p, shape, 0.1, why));
  for (int pass = 0; pass < 3; pass++) {
    for (int i = 0; i < n; i++) depth[i] = random_in(0, 0.004);
    check_ok(arc_shape_clone(shape, &copy, why));
    check_ok(arc_shape_wear(copy, ARC_PLATE, depth, why));
    check_ok(arc_contact_problem_update(&p, copy, 0.1, why));
    check_fresh(&p, copy, 0.1);
    arc_shape_destroy(&copy);
  }
  check_ok(arc_contact_problem_update(&p, shape, 0.1, why));
  check_fresh(&p, shape, 0.1);
  check_refused(arc_contact_problem_update(&p, shape, 1.5, why), ARC_ZONE, "do not overlap");
  check_refused(arc_contact_problem_update(&p, shape, 1.5, why), ARC_ZONE, "do not overlap");
  check_ok(arc_contact_problem_update(&p, shape, -0.2, why));
  check_fresh(&p, shape, -0.2);
  arc_contact_problem_free(&p);
  free(depth);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_random_positions),
      cmocka_unit_test(test_special_positions),
      cmocka_unit_test(test_worn),
      cmocka_unit_test(test_slopes),
      cmocka_unit_test(test_conserve),
      cmocka_unit_test(test_matching_nodes),
      cmocka_unit_test(test_matrix),
      cmocka_unit_test(test_apart),
      cmocka_unit_test(test_update),
  };
  return cmocka_run_group_tests_name("mortar", tests, NULL, NULL);
}

/* Tests of elements of revolution and of plane stress: constant strains, rigid motions, curved
 * fields at the axis, and no locking near nu = 1/2. */
#include "check.h"

#include "core/base/dense.h"
#include "core/elastic/element.h"

static const arc_material steel = {.E = 200e3, .nu = 0.3};
static const double pi = 3.14159265358979323846;

static double largest(const double *value, int count) {
  double most = 0;
  for (int k = 0; k < count; k++) most = fmax(most, fabs(value[k]));
  return most;
}

static element random_ring(int trial) {
  static const double unit[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  element e = {.corners = trial % 3 == 0 ? 3 : 4,
               .kind = trial % 3 == 2 ? ARC_CPE4I : ARC_CPE4,
               .revolved = {1, trial % 2 == 0 ? 0 : 20}};
  const double turn =
      trial % 2 == 0 ? 0 : random_in(0, 6.3); /* elements with the axis at x = 0 are not rotated */
  for (int c = 0; c < e.corners; c++) {
    const double x = 0.3 + unit[c][0] + random_in(-0.2, 0.2), y = unit[c][1] + random_in(-0.2, 0.2);
    e.xy[c][0] = cos(turn) * x - sin(turn) * y;
    e.xy[c][1] = -2 + sin(turn) * x + cos(turn) * y;
  }
  return e;
}

/* Tests that only a translation along the axis needs no force and that the stiffness is
 * symmetric. */
static void test_rigid(void **state) {
  (void)state;
  random_start(17);
  for (int trial = 0; trial < 300; trial++) {
    const element e = random_ring(trial);
    const int n = 2 * e.corners;
    double k[64];
    arc_element_stiffness(&e, arc_elasticity_of(steel), k);
    const double stiff = largest(k, n * n);
    for (int r = 0; r < n; r++) {
      double along = 0;
      for (int c = 1; c < n; c += 2) along += k[r * n + c];
      check_near(along, 0, 1e-12 * stiff);
      for (int c = 0; c < r; c++) check_near(k[r * n + c], k[c * n + r], 1e-13 * stiff);
    }
    for (int r = 1; r < n; r += 2)
      for (int c = 1; c < n; c += 2) k[r * n + c] += stiff;
    assert_int_equal(arc_dense_cholesky(n, k, n), 0);
  }
}

/* Checks the field u_x = a r, u_y = b y on the graded plate mesh: inner nodes have no force, the
 * stresses agree with the strains a, b, a, and the nodal forces on top equal the pressure times the
 * areas of the nodes. */
static void check_constant(arc_element kind, double axis) {
  const double a = 2e-4, b = -7e-4;
  arc_mesh_def def = arc_mesh_default();
  arc_mesh *m = NULL;
  check_ok(arc_mesh_build(&def, ARC_PLATE, 10, &m, why));
  const elasticity d = arc_elasticity_of(steel);
  double *residual = calloc(2 * (size_t)m->nodes, sizeof *residual), scale = 0;
  for (int e = 0; e < m->elements; e++) {
    const int *corner = &m->element[4 * e];
    element el = arc_element_at(m->xy, corner, kind);
    el.revolved = (revolution){1, axis};
    double u[8], stress[3], k[64];
    const int n = 2 * el.corners;
    for (int c = 0; c < el.corners; c++) {
      u[2 * c] = a * (axis + el.xy[c][0]);
      u[2 * c + 1] = b * el.xy[c][1];
    }
    arc_element_stress(&el, d, u, stress);
    check_near(stress[0], d.c11 * a + d.c12 * (a + b), 1e-9 * d.c11);
    check_near(stress[1], d.c11 * b + 2 * d.c12 * a, 1e-9 * d.c11);
    check_near(stress[2], 0, 1e-9 * d.c11);
    arc_element_stiffness(&el, d, k);
    for (int r = 0; r < n; r++)
      for (int c = 0; c < n; c++) {
        residual[2 * corner[r / 2] + r % 2] += k[r * n + c] * u[c];
        scale = fmax(scale, fabs(k[r * n + c] * u[c]));
      }
  }
  const revolution turned = {1, axis};
  const double pressure = -(d.c11 * b + 2 * d.c12 * a);
  for (int i = 1; i + 1 < m->surface; i++) {
    const double x[2] = {m->xy[2 * m->surface_node[i - 1]], m->xy[2 * m->surface_node[i + 1]]};
    const double area =
        (arc_revolution_area(&turned, x[1]) - arc_revolution_area(&turned, x[0])) / 2;
    check_near(residual[2 * m->surface_node[i] + 1], -pressure * area, 1e-11 * scale);
  }
  for (int k = 0; k < m->outline; k++)
    residual[2 * m->outline_node[k]] = residual[2 * m->outline_node[k] + 1] = 0;
  assert_true(largest(residual, 2 * m->nodes) <= 1e-11 * scale);
  free(residual);
  arc_mesh_destroy(&m);
}

static void test_constant_strain(void **state) {
  (void)state;
  for (int kind = ARC_CPE4; kind <= ARC_CPE4I; kind++) {
    check_constant((arc_element)kind, 0);
    check_constant((arc_element)kind, 30);
  }
}

/* Tests the volume of a ring of triangular section against Pappus' theorem, and the change of
 * this volume. */
static void test_swelling(void **state) {
  (void)state;
  const element e = {.corners = 3, .xy = {{0, 0}, {3, 0}, {0, 2}}, .revolved = {1, 4}};
  double gradient[6], change = 0;
  check_near(arc_triangle_swelling(&e, gradient), 2 * pi * 5 * 3, 1e-11);
  for (int c = 0; c < 3; c++)
    change += gradient[2 * c] * (4 + e.xy[c][0]) + gradient[2 * c + 1] * e.xy[c][1];
  check_near(change, 3 * 2 * pi * 5 * 3, 1e-10);
}

/* Tests the energy of the field u_y = r^2 with the shear strain 2 r in a column of elements at
 * the axis: the energy is exact. Linear shape functions without correction would give an eighth
 * less. */
static void test_curved_at_axis(void **state) {
  (void)state;
  const element e = {
      .corners = 4, .kind = ARC_CPE4, .xy = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, .revolved = {1, 0}};
  const elasticity d = arc_elasticity_of(steel);
  double k[64], energy = 0;
  arc_element_stiffness(&e, d, k);
  for (int r = 1; r < 8; r += 2)
    for (int c = 1; c < 8; c += 2)
      energy +=
          k[8 * r + c] * e.xy[r / 2][0] * e.xy[r / 2][0] * e.xy[c / 2][0] * e.xy[c / 2][0] / 2;
  const double exact = d.c33 / 2 * pi * 4 * 16 / 4; /* over half a turn: volume pi r dr dy, shear
                                                     * strain 2 r */
  check_near(energy, exact, 1e-9 * exact);
}

/* Returns the energy of a change of shape at constant volume, u_x = r y and u_y = -y^2. Bilinear
 * functions represent this field only with volume changes in the corners; the energy must not
 * increase without limit as nu approaches 1/2. */
static double shape_energy(arc_element kind, double nu) {
  const element e = {
      .corners = 4, .kind = kind, .xy = {{0, -1}, {2, -1}, {2, 1}, {0, 1}}, .revolved = {1, 0}};
  double k[64], u[8], energy = 0;
  arc_element_stiffness(&e, arc_elasticity_of((arc_material){.E = 1, .nu = nu}), k);
  for (int c = 0; c < 4; c++) {
    u[2 * c] = e.xy[c][0] * e.xy[c][1];
    u[2 * c + 1] = -e.xy[c][1] * e.xy[c][1];
  }
  for (int r = 0; r < 8; r++)
    for (int c = 0; c < 8; c++) energy += k[8 * r + c] * u[r] * u[c] / 2;
  return energy;
}

static void test_no_locking(void **state) {
  (void)state;
  const double shared = shape_energy(ARC_CPE4I, 0.4999) / shape_energy(ARC_CPE4I, 0.3);
  const double full = shape_energy(ARC_CPE4, 0.4999) / shape_energy(ARC_CPE4, 0.3);
  assert_true(shared < 1.2);
  assert_true(full > 100);
}

/* Tests thin plates in plane stress: a free strip has the modulus E, and the shear modulus is G. */
static void test_plane_stress(void **state) {
  (void)state;
  const elasticity d = arc_elasticity_in(ARC_PLANE_STRESS, steel);
  check_near(d.c11 - d.c12 * d.c12 / d.c11, steel.E, 1e-9 * steel.E);
  check_near(d.c12 / d.c11, steel.nu, 1e-15);
  check_near(d.c33, arc_elasticity_of(steel).c33, 1e-9);
  const elasticity strain = arc_elasticity_in(ARC_PLANE_STRAIN, steel),
                   same = arc_elasticity_of(steel);
  assert_memory_equal(&strain, &same, sizeof same);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_rigid),      cmocka_unit_test(test_constant_strain),
      cmocka_unit_test(test_swelling),   cmocka_unit_test(test_curved_at_axis),
      cmocka_unit_test(test_no_locking), cmocka_unit_test(test_plane_stress),
  };
  return cmocka_run_group_tests_name("revolved", tests, NULL, NULL);
}

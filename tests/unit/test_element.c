/* Tests of elements: patch tests on distorted patches and whole bodies, rigid motions, symmetry,
 * positive definiteness, and bending. */
#include "check.h"

#include "core/base/dense.h"
#include "core/elastic/element.h"

static const arc_material steel = {.E = 200e3, .nu = 0.3};

/* Computes a linear displacement field with all strains and a rotation. */
static void linear_field(const double *xy, double *u) {
  u[0] = 3e-4 + 1.1e-3 * xy[0] - 0.7e-3 * xy[1];
  u[1] = -2e-4 + 0.4e-3 * xy[0] - 1.9e-3 * xy[1];
}

static void linear_stress(elasticity d, double stress[3]) {
  const double exx = 1.1e-3, eyy = -1.9e-3, gxy = -0.7e-3 + 0.4e-3;
  stress[0] = d.c11 * exx + d.c12 * eyy;
  stress[1] = d.c12 * exx + d.c11 * eyy;
  stress[2] = d.c33 * gxy;
}

/* Returns a random convex element whose size is about one. */
static element random_element(int corners, arc_element kind) {
  static const double unit[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  element e = {.corners = corners, .kind = kind};
  const double wide = random_in(0.3, 3), slant = random_in(-0.8, 0.8), turn = random_in(0, 6.3);
  for (int c = 0; c < corners; c++) {
    const double x = wide * (unit[c][0] + random_in(-0.2, 0.2)) + slant * unit[c][1];
    const double y = unit[c][1] + random_in(-0.2, 0.2);
    e.xy[c][0] = 5 + cos(turn) * x - sin(turn) * y;
    e.xy[c][1] = -2 + sin(turn) * x + cos(turn) * y;
  }
  return e;
}

static element random_kind(int which) {
  return random_element(which == 0 ? 3 : 4, which == 2 ? ARC_CPE4I : ARC_CPE4);
}

static elasticity random_elasticity(void) {
  return arc_elasticity_of((arc_material){.E = exp(random_in(0, 13)), .nu = random_in(-0.9, 0.49)});
}

static double largest(const double *value, int count) {
  double most = 0;
  for (int k = 0; k < count; k++) most = fmax(most, fabs(value[k]));
  return most;
}

/* Computes the nodal forces f = K u. Returns the largest entry of |K| |u|, the scale of rounding
 * errors. */
static double forces(const element *e, elasticity d, const double *u, double *f) {
  const int n = 2 * e->corners;
  double k[64], scale = 0;
  arc_element_stiffness(e, d, k);
  for (int r = 0; r < n; r++) {
    double sum = 0, size = 0;
    for (int c = 0; c < n; c++) {
      sum += k[r * n + c] * u[c];
      size += fabs(k[r * n + c] * u[c]);
    }
    f[r] = sum;
    scale = fmax(scale, size);
  }
  return scale;
}

/* --- single elements -------------------------------------------------------------------------- */

static void test_symmetric(void **state) {
  (void)state;
  random_start(7);
  for (int trial = 0; trial < 300; trial++) {
    const element e = random_kind(trial % 3);
    const int n = 2 * e.corners;
    double k[64];
    arc_element_stiffness(&e, random_elasticity(), k);
    for (int r = 0; r < n; r++)
      for (int c = 0; c < r; c++) check_near(k[r * n + c], k[c * n + r], 1e-13 * largest(k, n * n));
  }
}

/* Tests that rigid motions need no force and that all other motions need energy: K plus the
 * rigid modes is positive definite. */
static void test_rigid_motions(void **state) {
  (void)state;
  random_start(8);
  for (int trial = 0; trial < 300; trial++) {
    const element e = random_kind(trial % 3);
    const elasticity d = random_elasticity();
    const int n = 2 * e.corners;
    double k[64], mode[3][8], f[8];
    for (int c = 0; c < e.corners; c++) {
      mode[0][2 * c] = 1, mode[0][2 * c + 1] = 0;
      mode[1][2 * c] = 0, mode[1][2 * c + 1] = 1;
      mode[2][2 * c] = -e.xy[c][1], mode[2][2 * c + 1] = e.xy[c][0];
    }
    arc_element_stiffness(&e, d, k);
    const double stiff = largest(k, n * n);
    for (int m = 0; m < 3; m++) {
      const double scale = forces(&e, d, mode[m], f);
      assert_true(largest(f, n) <= 1e-12 * scale);
      for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) k[r * n + c] += stiff * mode[m][r] * mode[m][c];
    }
    assert_int_equal(arc_dense_cholesky(n, k, n), 0);
  }
}

/* Tests a field of constant strain: the stress is exact, and the nodal forces equal the boundary
 * integral of the tractions. */
static void test_constant_strain(void **state) {
  (void)state;
  random_start(9);
  for (int trial = 0; trial < 300; trial++) {
    const element e = random_kind(trial % 3);
    const elasticity d = random_elasticity();
    double u[8], f[8], stress[3], exact[3];
    for (int c = 0; c < e.corners; c++) linear_field(e.xy[c], &u[2 * c]);
    linear_stress(d, exact);
    arc_element_stress(&e, d, u, stress);
    const double scale = forces(&e, d, u, f);
    for (int s = 0; s < 3; s++) check_near(stress[s], exact[s], 1e-12 * d.c11);
    for (int c = 0; c < e.corners; c++) {
      const double *p = e.xy[(c + e.corners - 1) % e.corners], *q = e.xy[(c + 1) % e.corners];
      const double nx = (q[1] - p[1]) / 2, ny = (p[0] - q[0]) / 2;
      check_near(f[2 * c], exact[0] * nx + exact[2] * ny, 1e-12 * scale);
      check_near(f[2 * c + 1], exact[2] * nx + exact[1] * ny, 1e-12 * scale);
    }
  }
}

/* Returns the strain energy of the element divided by the exact energy for a bent rectangle,
 * u = (x y, -x^2 / 2 - nu / (1 - nu) y^2 / 2). CPE4I has the exact energy for every aspect ratio;
 * the error of CPE4 increases with the aspect ratio. */
static double bending_energy_ratio(arc_element kind, double half_length) {
  const double half_height = 1, nu = steel.nu;
  element e = {.corners = 4,
               .kind = kind,
               .xy = {{-half_length, -half_height},
                      {half_length, -half_height},
                      {half_length, half_height},
                      {-half_length, half_height}}};
  double u[8], f[8], energy = 0;
  for (int c = 0; c < 4; c++) {
    const double x = e.xy[c][0], y = e.xy[c][1];
    u[2 * c] = x * y;
    u[2 * c + 1] = -x * x / 2 - nu / (1 - nu) * y * y / 2;
  }
  forces(&e, arc_elasticity_of(steel), u, f);
  for (int k = 0; k < 8; k++) energy += u[k] * f[k] / 2;
  const double exact = arc_material_E_star(steel) / 2 * (2 * half_length) * 8 / 12;
  return energy / exact;
}

static void test_bending(void **state) {
  (void)state;
  for (double length = 1; length < 20; length *= 2) {
    check_near(bending_energy_ratio(ARC_CPE4I, length), 1, 1e-12);
    /* parasitic shear increases the ratio of energies by G / E* times the square of the aspect
     * ratio */
    const double nu = steel.nu, shear = (1 - nu) / 2 * length * length;
    const double plane = (1 - nu) * (1 - nu) / (1 - 2 * nu);
    check_near(bending_energy_ratio(ARC_CPE4, length), plane + shear, 1e-9 * shear);
  }
}

/* Tests that "auto" means the CPE4 element of the reference paper up to nu = 0.4 and CPE4I
 * above, and that an element chosen by the user is not changed. */
static void test_kind_for_nu(void **state) {
  (void)state;
  for (double nu = -0.9; nu < 0.5; nu += 0.05) {
    assert_int_equal(arc_element_for(ARC_ELEMENT_AUTO, nu), nu > 0.4 ? ARC_CPE4I : ARC_CPE4);
    assert_int_equal(arc_element_for(ARC_CPE4, nu), ARC_CPE4);
    assert_int_equal(arc_element_for(ARC_CPE4I, nu), ARC_CPE4I);
  }
  assert_int_equal(arc_element_for(ARC_ELEMENT_AUTO, 0.4), ARC_CPE4);
}

/* Tests that the deviatoric stiffness of a triangle plus the square of its change of area equals
 * the whole stiffness. */
static void test_volume_apart(void **state) {
  (void)state;
  random_start(10);
  for (int trial = 0; trial < 300; trial++) {
    const element e = random_kind(0);
    const elasticity d = random_elasticity();
    double whole[64], shape[64], swelling[6];
    arc_element_stiffness(&e, d, whole);
    arc_element_stiffness(&e, arc_elasticity_deviatoric(d), shape);
    const double area = arc_triangle_swelling(&e, swelling), bulk = arc_elasticity_bulk(d);
    const double(*p)[2] = e.xy, ax = p[1][0] - p[0][0], ay = p[1][1] - p[0][1];
    check_near(area, (ax * (p[2][1] - p[0][1]) - ay * (p[2][0] - p[0][0])) / 2, 1e-12 * area);
    for (int r = 0; r < 36; r++)
      check_near(shape[r] + bulk / area * swelling[r / 6] * swelling[r % 6], whole[r],
                 1e-12 * largest(whole, 36));
    check_near(arc_elasticity_bulk(arc_elasticity_of((arc_material){.E = 210e3, .nu = 0.45})),
               210e3 / 0.3, 1e-6);
  }
}

/* --- patches ---------------------------------------------------------------------------------- */

/* The standard patch: a rectangle of five quadrilaterals around a rotated one, or of ten
 * triangles. The outer nodes follow a linear field; the test checks that the four free inner
 * nodes follow the same field. */
static const double patch_xy[16] = {0,    0,    0.24, 0,    0.24, 0.12, 0,    0.12,
                                    0.04, 0.02, 0.18, 0.03, 0.16, 0.08, 0.08, 0.08};
static const int patch_quad[5][4] = {
    {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};

static void add_patch_element(const int corner[4], arc_element kind, elasticity d, double *k) {
  const element e = arc_element_at(patch_xy, corner, kind);
  const int n = 2 * e.corners;
  double own[64];
  arc_element_stiffness(&e, d, own);
  for (int r = 0; r < n; r++)
    for (int c = 0; c < n; c++)
      k[dense_at(2 * corner[r / 2] + r % 2, 2 * corner[c / 2] + c % 2, 16)] += own[r * n + c];
}

static void assemble_patch(int which, elasticity d, double *k) {
  memset(k, 0, 256 * sizeof *k);
  for (int e = 0; e < 5; e++) {
    const int *q = patch_quad[e];
    if (which == 0) {
      add_patch_element((int[]){q[0], q[1], q[2], -1}, ARC_CPE4, d, k);
      add_patch_element((int[]){q[0], q[2], q[3], -1}, ARC_CPE4, d, k);
    } else {
      add_patch_element(q, which == 2 ? ARC_CPE4I : ARC_CPE4, d, k);
    }
  }
}

static void test_patch(void **state) {
  (void)state;
  for (int which = 0; which < 3; which++) {
    const elasticity d = arc_elasticity_of(steel);
    double k[256], inner[64], u[16], x[8] = {0};
    assemble_patch(which, d, k);
    for (int n = 0; n < 8; n++) linear_field(&patch_xy[2 * n], &u[2 * n]);
    for (int r = 0; r < 8; r++) {
      for (int c = 0; c < 8; c++) x[r] -= k[dense_at(8 + r, c, 16)] * u[c];
      for (int c = 0; c < 8; c++) inner[dense_at(r, c, 8)] = k[dense_at(8 + r, 8 + c, 16)];
    }
    assert_int_equal(arc_dense_cholesky(8, inner, 8), 0);
    arc_dense_cholesky_solve(8, 1, inner, 8, x, 8);
    for (int r = 0; r < 8; r++) check_near(x[r], u[8 + r], 1e-12 * largest(u, 16));
  }
}

/* Checks a linear field on a whole graded mesh, including triangles at hanging nodes: inner
 * nodes have no force, and every element has the same stress. */
static void check_body_patch(arc_body body, arc_element kind) {
  arc_mesh_def def = arc_mesh_default();
  def.element = kind;
  arc_mesh *m = NULL;
  check_ok(arc_mesh_build(&def, body, 10, &m, why));
  const elasticity d = arc_elasticity_of(steel);
  double *residual = calloc(2 * (size_t)m->nodes, sizeof *residual), scale = 0, exact[3];
  linear_stress(d, exact);
  for (int e = 0; e < m->elements; e++) {
    const int *corner = &m->element[4 * e];
    const element el = arc_element_at(m->xy, corner, kind);
    double u[8], f[8], stress[3];
    for (int c = 0; c < el.corners; c++) linear_field(el.xy[c], &u[2 * c]);
    forces(&el, d, u, f);
    arc_element_stress(&el, d, u, stress);
    for (int c = 0; c < 2 * el.corners; c++) residual[2 * corner[c / 2] + c % 2] += f[c];
    scale = fmax(scale, largest(f, 2 * el.corners));
    for (int s = 0; s < 3; s++) check_near(stress[s], exact[s], 1e-10 * d.c11 * 1e-3);
  }
  for (int k = 0; k < m->outline; k++)
    residual[2 * m->outline_node[k]] = residual[2 * m->outline_node[k] + 1] = 0;
  assert_true(largest(residual, 2 * m->nodes) <= 1e-12 * scale);
  free(residual);
  arc_mesh_destroy(&m);
}

static void test_body_patch(void **state) {
  (void)state;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int kind = ARC_CPE4; kind <= ARC_CPE4I; kind++)
      check_body_patch((arc_body)b, (arc_element)kind);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_symmetric),       cmocka_unit_test(test_rigid_motions),
      cmocka_unit_test(test_constant_strain), cmocka_unit_test(test_bending),
      cmocka_unit_test(test_kind_for_nu),     cmocka_unit_test(test_volume_apart),
      cmocka_unit_test(test_patch),           cmocka_unit_test(test_body_patch),
  };
  return cmocka_run_group_tests_name("element", tests, NULL, NULL);
}

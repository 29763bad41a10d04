/* Tests of nodal stresses: they are exact for linear stresses, inside and on the boundary, they
 * are symmetric, and they reproduce given boundary tractions. The tests use internal functions
 * of contact. */
#include "check.h"

#include "core/contact/contact_problem.h"
#include "core/plane/recovery.h"

typedef struct recovered {
  const elastic_body *body;
  const arc_mesh *mesh;
  double *u, *p, *q, *stress;
} recovered;

static recovered start(const arc_model *model, arc_body which) {
  const elastic_body *body = arc_model_body(model, which);
  const size_t n = (size_t)body->mesh->nodes, surface = (size_t)body->mesh->surface;
  double *u = calloc(5 * n + 2 * surface, sizeof *u);
  return (recovered){body, body->mesh, u, u + 5 * n, u + 5 * n + surface, u + 2 * n};
}

static void finish(recovered *r) {
  free(r->u);
}

static void recover(recovered *r) {
  const surface_traction traction = {.normal = r->p, .tangential = r->q, .load = r->p};
  assert_int_equal(arc_recover_stresses(r->body, r->mesh->xy, r->u, &traction, r->stress), ARC_OK);
}

static arc_model *model_with(arc_element kind, double nu) {
  arc_model_def def = arc_model_default();
  def.mesh.element = kind;
  for (int b = 0; b < ARC_BODIES; b++) def.material[b] = (arc_material){.E = 1000, .nu = nu};
  return build_model(&def);
}

/* Returns true for nodes of the wear box at some distance from its sides, where the stresses do not
 * depend on the rest of the boundary. */
static int is_judged(const arc_mesh *m, int box) {
  const int column = box / (m->rows + 1);
  return column >= 6 && column < m->surface - 6;
}

/* Tests constant stresses in the plate under compression, stretching and shear: sigma_xx = s,
 * sigma_yy = -p, sigma_xy = q. The plate's outward normal is y; a positive tangential traction q
 * acts toward larger x. */
static void test_constant(void **state) {
  (void)state;
  random_start(21);
  for (int trial = 0; trial < 6; trial++) {
    arc_model *model = model_with(trial % 2 ? ARC_CPE4 : ARC_CPE4I, random_in(0, 0.499));
    recovered r = start(model, ARC_PLATE);
    const elasticity d = r.body->d;
    const double p = random_in(1, 3), s = random_in(-3, 3), q = random_in(-3, 3);
    const double det = d.c11 * d.c11 - d.c12 * d.c12;
    const double exx = (d.c11 * s + d.c12 * p) / det, eyy = (-d.c12 * s - d.c11 * p) / det;
    for (int n = 0; n < r.mesh->nodes; n++) {
      r.u[2 * n] = exx * r.mesh->xy[2 * n] + q / d.c33 * r.mesh->xy[2 * n + 1];
      r.u[2 * n + 1] = eyy * r.mesh->xy[2 * n + 1];
    }
    for (int i = 0; i < r.mesh->surface; i++) r.p[i] = p, r.q[i] = q;
    recover(&r);
    for (int k = 0; k < r.mesh->surface * (r.mesh->rows + 1); k++) {
      const double *stress = &r.stress[3 * r.mesh->box_node[k]];
      if (!is_judged(r.mesh, k)) continue;
      check_near(stress[0], s, 1e-9 * d.c11);
      check_near(stress[1], -p, 1e-9 * d.c11);
      check_near(stress[2], q, 1e-9 * d.c11);
    }
    finish(&r);
    arc_model_release(&model);
  }
}

/* Tests bending, ux = x y, uy = -x^2 / 2 - nu / (1 - nu) y^2 / 2, for which sigma_xx = E* y and all
 * other stresses and the pressure are 0. Stresses at the centres of elements of equal size are
 * exact. */
static void test_bending(void **state) {
  (void)state;
  arc_model *model = model_with(ARC_CPE4, 0.3);
  recovered r = start(model, ARC_PLATE);
  const double modulus = arc_material_E_star(r.body->material);
  for (int n = 0; n < r.mesh->nodes; n++) {
    const double x = r.mesh->xy[2 * n], y = r.mesh->xy[2 * n + 1];
    r.u[2 * n] = x * y;
    r.u[2 * n + 1] = -x * x / 2 - 0.3 / 0.7 * y * y / 2;
  }
  recover(&r);
  for (int k = 0; k < r.mesh->surface * (r.mesh->rows + 1); k++) {
    const int n = r.mesh->box_node[k];
    if (!is_judged(r.mesh, k)) continue;
    check_near(r.stress[3 * n], modulus * r.mesh->xy[2 * n + 1], 1e-9 * modulus);
    check_near(r.stress[3 * n + 1], 0, 1e-9 * modulus);
    check_near(r.stress[3 * n + 2], 0, 1e-9 * modulus);
  }
  finish(&r);
  arc_model_release(&model);
}

static int mirror_of(const arc_mesh *m, int node) {
  for (int n = 0; n < m->nodes; n++)
    if (m->xy[2 * n] == -m->xy[2 * node] && m->xy[2 * n + 1] == m->xy[2 * node + 1]) return n;
  fail();
  return -1;
}

/* Returns the tolerance of the stress at surface node i relative to the pressure [MPa]. Near an
 * end of the contact the tolerance is larger because there the pressure is corrected by a
 * square-root law. */
static double room_at(const arc_contact *contact, arc_pressure pressure, int i) {
  const arc_contact_result c = arc_contact_get(contact);
  const double x = pressure.x[i], width = 1.01 * (pressure.x[i + 1] - x);
  const double off = fmin(fabs(x - c.left), fabs(x - c.right));
  return c.p_max * (off < width ? 0.15 : off < 2 * width ? 0.01 : 1e-6);
}

/* Checks the stresses of a contact: the tractions at every surface node and the mirror symmetry. */
static void check_contact(const arc_contact *contact, arc_body body) {
  const arc_mesh *m = arc_model_mesh(arc_contact_model(contact), body);
  const arc_pressure pressure = arc_contact_pressure(contact, body);
  const double most = arc_contact_get(contact).p_max;
  arc_field *f = NULL;
  check_ok(arc_contact_field(contact, body, &f, why));
  for (int i = 1; i + 1 < m->surface; i++) {
    const int n = m->surface_node[i], a = m->surface_node[i - 1], b = m->surface_node[i + 1];
    const double dx = f->x[b] - f->x[a], dy = f->y[b] - f->y[a], l = hypot(dx, dy);
    const double nx = -dy / l, ny = dx / l;
    const double tx = f->sxx[n] * nx + f->sxy[n] * ny, ty = f->sxy[n] * nx + f->syy[n] * ny;
    check_near(ty * nx - tx * ny, 0, 1e-6 * most);
    check_near(tx * nx + ty * ny, -pressure.p[i], room_at(contact, pressure, i));
  }
  for (int n = 0; n < m->nodes; n += 7) {
    const int other = mirror_of(m, n);
    check_near(f->sxx[n], f->sxx[other], 1e-8 * most);
    check_near(f->mises[n], f->mises[other], 1e-8 * most);
    check_near(f->sxy[n], -f->sxy[other], 1e-8 * most);
  }
  arc_field_destroy(&f);
}

static void test_tractions(void **state) {
  (void)state;
  for (double nu = 0.3; nu < 0.5; nu += 0.1999) {
    arc_model *model = model_with(ARC_ELEMENT_AUTO, nu);
    arc_shape *shape = NULL;
    arc_contact *contact = NULL;
    arc_contact_def def = arc_contact_default();
    def.load = 0.5;
    check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
    check_ok(arc_contact_solve(shape, &def, NULL, &contact, why));
    for (int b = 0; b < ARC_BODIES; b++) check_contact(contact, (arc_body)b);
    arc_contact_destroy(&contact);
    arc_shape_destroy(&shape);
    arc_model_release(&model);
  }
}

/* Tests the correction of pressure and shear near the contact ends. The exact pressure is (1 + d
 * / 9) sqrt(d) at the distance d from the end. Values changed within two elements of an end are
 * restored; at a kink, which has no square-root law, they are unchanged. */
static void test_edges(void **state) {
  (void)state;
  enum { n = 20 };
  const double width = 0.5;
  for (int right = 0; right < 2; right++) {
    const double end = right ? 7.3 : 2.2;
    double x[n], exact[n], p[n], q[n], kept[n];
    contact_edge edge = {
        .x = end, .width = width, .smooth = 1, .out = right ? 1 : -1, .c = {1, 1 / 9.0}};
    for (int i = 0; i < n; i++) {
      x[i] = width * i;
      const double d = edge.out * (end - x[i]);
      exact[i] = d > 0 ? (1 + d / 9) * sqrt(d) : 0;
      kept[i] = p[i] = fabs(d) < 2 * width ? 0.3 : exact[i];
      q[i] = -0.2 * p[i];
    }
    arc_edge_sharpen(&edge, n, x, 1, p);
    arc_edge_sharpen(&edge, n, x, -0.2, q);
    for (int i = 0; i < n; i++) check_near(p[i], exact[i], 1e-13);
    for (int i = 0; i < n; i++) check_near(q[i], -0.2 * exact[i], 1e-13);
    edge.smooth = 0;
    arc_edge_sharpen(&edge, n, x, 1, kept);
    for (int i = 0; i < n; i++)
      assert_true(kept[i] == (fabs(edge.x - x[i]) < 2 * width ? 0.3 : exact[i]));
  }
}

/* Returns the cusp 2 (1 - s / 9) sqrt(s) at the distance s outside the edge and 0 inside. The sign
 * is the sign of the direction `out`, +1 or -1. */
static double cusp(const contact_edge *edge, double x) {
  const double s = fmax(0, edge->out * (x - edge->x));
  return 2 * edge->out * (1 - s / 9) * sqrt(s);
}

/* Tests the correction of nodal values near a cusp: the value of the cusp at a node minus the
 * weighted mean of its averages over both adjacent elements, for unevenly spaced nodes. */
static void test_cusp(void **state) {
  (void)state;
  enum { n = 20, steps = 20000 };
  for (int right = 0; right < 2; right++) {
    const contact_edge edge = {
        .x = 4.7, .width = 0.5, .smooth = 1, .out = right ? 1 : -1, .c = {1, 1 / 9.0}};
    double x[n], got[n] = {0}, mean[n - 1] = {0};
    for (int i = 0; i < n; i++) x[i] = 0.5 * i + 0.05 * (i % 3);
    arc_edge_add_cusp(&edge, n, x, 3, got);
    for (int i = 0; i + 1 < n; i++)
      for (int k = 0; k < steps; k++)
        mean[i] += cusp(&edge, x[i] + (x[i + 1] - x[i]) * (k + 0.5) / steps) / steps;
    for (int i = 1; i + 1 < n; i++) {
      const double a = x[i] - x[i - 1], b = x[i + 1] - x[i];
      const double missed = cusp(&edge, x[i]) - (mean[i - 1] * b + mean[i] * a) / (a + b);
      check_near(got[i], fabs(x[i] - edge.x) > 2 ? 0 : 3 * missed, 1e-5);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_constant),  cmocka_unit_test(test_bending),
      cmocka_unit_test(test_tractions), cmocka_unit_test(test_edges),
      cmocka_unit_test(test_cusp),
  };
  return cmocka_run_group_tests_name("recovery", tests, NULL, NULL);
}

/* Tests condensed bodies against a direct solution on the whole mesh: unworn bodies, worn bodies,
 * and displacements of nodes inside the bodies. The tests use internal functions of the folders
 * elastic and contact to read the matrices. */
#include "check.h"

#include "core/base/dense.h"
#include "core/contact/shape.h"

/* A whole body with the nodes `xy` and its factored stiffness matrix. unknown[node] is the index
 * of the node's x displacement, or -1 if the node is fixed. */
typedef struct whole {
  const elastic_body *body;
  int n, *unknown;
  factor *k;
} whole;

static int *number_free(const arc_mesh *m, int *count) {
  int *unknown = calloc((size_t)m->nodes, sizeof *unknown);
  for (int k = 0; k < m->fixed; k++) unknown[m->fixed_node[k]] = -1;
  *count = 0;
  for (int n = 0; n < m->nodes; n++)
    if (unknown[n] == 0) unknown[n] = *count, *count += 2;
  return unknown;
}

static void add_entry(const whole *w, sparse_entries *entries, int row, int column, double value) {
  const int i = w->unknown[row / 2], j = w->unknown[column / 2];
  if (i >= 0 && j >= 0 && i + row % 2 >= j + column % 2)
    assert_int_equal(arc_sparse_add(entries, i + row % 2, j + column % 2, value), ARC_OK);
}

/* Adds the stiffness of a group of triangles against changes of their total area. A group consists
 * of the triangles with the same first corner on one side of the body. This function searches for
 * them, so it does not depend on the order of the elements. */
static void add_dilatation(const whole *w, const double *xy, int e, sparse_entries *entries) {
  const arc_mesh *m = w->body->mesh;
  int unknown[64], count = 0;
  double area = 0, change[64], own[6];
  for (int t = e; t < m->elements; t += 2) {
    const int *corner = &m->element[4 * t];
    if (corner[3] >= 0 || corner[0] != m->element[4 * e]) continue;
    const element el = arc_element_at(xy, corner, ARC_CPE4);
    area += arc_triangle_swelling(&el, own);
    for (int k = 0; k < 6; k++) {
      unknown[count] = 2 * corner[k / 2] + k % 2;
      change[count++] = own[k];
    }
  }
  const double bulk = w->body->material.E / (3 * (1 - 2 * w->body->material.nu)) / area;
  for (int r = 0; r < count; r++)
    for (int c = 0; c < count; c++)
      add_entry(w, entries, unknown[r], unknown[c], bulk * change[r] * change[c]);
}

static int starts_cell(const arc_mesh *m, int e) {
  for (int t = e - 2; t >= 0; t -= 2)
    if (m->element[4 * t + 3] < 0 && m->element[4 * t] == m->element[4 * e]) return 0;
  return 1;
}

static whole assemble(const elastic_body *b, const double *xy) {
  const arc_mesh *m = b->mesh;
  whole w = {.body = b};
  w.unknown = number_free(m, &w.n);
  sparse_entries entries = {0};
  for (int e = 0; e < m->elements; e++) {
    const int *corner = &m->element[4 * e];
    const element el = arc_element_at(xy, corner, m->def.element);
    const int n = 2 * el.corners, shared = el.corners == 3 && m->def.element == ARC_CPE4I;
    double k[64];
    arc_element_stiffness(&el, shared ? arc_elasticity_deviatoric(b->d) : b->d, k);
    for (int r = 0; r < n; r++)
      for (int c = 0; c < n; c++)
        add_entry(&w, &entries, 2 * corner[r / 2] + r % 2, 2 * corner[c / 2] + c % 2, k[r * n + c]);
    if (shared && starts_cell(m, e)) add_dilatation(&w, xy, e, &entries);
  }
  check_ok(arc_factor_create(w.n, 0, &entries, &w.k, why));
  arc_sparse_free(&entries);
  return w;
}

static void whole_free(whole *w) {
  arc_factor_destroy(&w->k);
  free(w->unknown);
}

/* Computes the displacements u [n] due to a unit force along x (direction 0) or y (direction 1)
 * at the surface node s. */
static void push(const whole *w, int s, int direction, double *u) {
  memset(u, 0, (size_t)w->n * sizeof *u);
  u[w->unknown[w->body->mesh->surface_node[s]] + direction] = 1;
  check_ok(arc_factor_solve(w->k, u, why));
}

/* Compares the condensed compliance with the direct solution, to 1e-10 of the largest entry, and
 * checks that the compliance is symmetric. */
static void check_compliance(const whole *w, const compliance *c) {
  const arc_mesh *m = w->body->mesh;
  assert_int_equal(c->n, m->surface);
  double *u = malloc((size_t)w->n * sizeof *u), most = 0;
  for (int s = 0; s < c->n; s++) most = fmax(most, c->yy[dense_at(s, s, c->n)]);
  for (int s = 0; s < c->n; s++)
    for (int direction = 0; direction < 2; direction++) {
      const double *along_x = direction ? c->xy : c->xx, *along_y = direction ? c->yy : c->yx;
      const double *own = direction ? c->yy : c->xx;
      push(w, s, direction, u);
      for (int r = 0; r < c->n; r++) {
        const double *direct = &u[w->unknown[m->surface_node[r]]];
        check_near(along_x[dense_at(r, s, c->n)], direct[0], 1e-10 * most);
        check_near(along_y[dense_at(r, s, c->n)], direct[1], 1e-10 * most);
        check_near(own[dense_at(r, s, c->n)], own[dense_at(s, r, c->n)], 1e-12 * most);
      }
    }
  free(u);
}

static arc_model_def definition(arc_element kind, int rows) {
  arc_model_def def = coarse_definition();
  def.mesh.element = kind;
  def.mesh.rows = rows;
  def.material[ARC_PLATE] = (arc_material){.E = 70e3, .nu = 0.33};
  return def;
}

static void test_unworn(void **state) {
  (void)state;
  for (int kind = ARC_CPE4; kind <= ARC_CPE4I; kind++)
    for (int rows = 1; rows <= 5; rows += 2) {
      const arc_model_def def = definition((arc_element)kind, rows);
      arc_model *model = build_model(&def);
      for (int b = 0; b < ARC_BODIES; b++) {
        const elastic_body *body = arc_model_body(model, (arc_body)b);
        whole w = assemble(body, body->mesh->xy);
        check_compliance(&w, &body->unworn);
        whole_free(&w);
      }
      arc_model_release(&model);
    }
}

/* Tests that the condensed compliance is positive definite, so every contact problem has exactly
 * one solution. */
static void test_definite(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  for (int b = 0; b < ARC_BODIES; b++) {
    const compliance *c = &arc_model_body(model, (arc_body)b)->unworn;
    const size_t bytes = (size_t)c->n * (size_t)c->n * sizeof(double);
    double *copy = malloc(bytes);
    memcpy(copy, c->yy, bytes);
    assert_int_equal(arc_dense_cholesky(c->n, copy, c->n), 0);
    free(copy);
  }
  arc_model_release(&model);
}

/* Tests that mirrored forces give mirrored displacements. */
static void test_mirror(void **state) {
  (void)state;
  arc_model *model = default_model();
  for (int b = 0; b < ARC_BODIES; b++) {
    const compliance *c = &arc_model_body(model, (arc_body)b)->unworn;
    const int last = c->n - 1;
    const double most = c->yy[dense_at(last / 2, last / 2, c->n)];
    for (int r = 0; r < c->n; r++)
      for (int s = 0; s < c->n; s++) {
        check_near(c->yy[dense_at(r, s, c->n)], c->yy[dense_at(last - r, last - s, c->n)],
                   1e-11 * most);
        check_near(c->xy[dense_at(r, s, c->n)], -c->xy[dense_at(last - r, last - s, c->n)],
                   1e-11 * most);
      }
  }
  arc_model_release(&model);
}

/* Wears a body to a rough, asymmetric scar with a depth of up to half the wear box. The wear is
 * zero at the sides of the box, where elements outside the box share nodes with it. */
static void wear_at_random(arc_shape *shape, arc_body body) {
  const arc_mesh *m = arc_model_mesh(arc_shape_model(shape), body);
  const double most = 0.1 * m->rows * m->def.height;
  double *depth = malloc((size_t)m->surface * sizeof *depth);
  for (int pass = 0; pass < 4; pass++) {
    for (int i = 0; i < m->surface; i++)
      depth[i] = i == 0 || i == m->surface - 1 ? 0 : most * random_in(0.2, 1);
    check_ok(arc_shape_wear(shape, body, depth, why));
  }
  free(depth);
}

static void test_worn(void **state) {
  (void)state;
  random_start(11);
  for (int kind = ARC_CPE4; kind <= ARC_CPE4I; kind++) {
    const arc_model_def def = definition((arc_element)kind, 3);
    arc_model *model = build_model(&def);
    arc_shape *shape = NULL;
    check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
    for (int b = 0; b < ARC_BODIES; b++) {
      const elastic_body *body = arc_model_body(model, (arc_body)b);
      double *xy = malloc(2 * (size_t)body->mesh->nodes * sizeof *xy);
      wear_at_random(shape, (arc_body)b);
      arc_shape_nodes(shape, (arc_body)b, xy);
      assert_true(arc_mesh_quality(body->mesh, xy).smallest_jacobian > 0);
      whole w = assemble(body, xy);
      assert_true(shape->side[b].own.n > 0);
      check_compliance(&w, shape_compliance(&shape->side[b]));
      whole_free(&w);
      free(xy);
    }
    arc_shape_destroy(&shape);
    arc_model_release(&model);
  }
}

/* Tests when the compliance is recomputed: never with frozen geometry, and with moving geometry
 * only if the wear exceeds `refresh`. */
static void test_refresh(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  const arc_mesh *m = arc_model_mesh(model, ARC_PLATE);
  double *depth = malloc((size_t)m->surface * sizeof *depth);
  for (int i = 0; i < m->surface; i++) depth[i] = 0.04 * m->def.height;
  static const double refresh[] = {0, 0.05, 0.1, 0.5};
  static const int after_one[] = {1, 0, 0, 0}, after_two[] = {1, 1, 0, 0};
  for (int k = 0; k < 4; k++)
    for (int geometry = ARC_MOVING; geometry <= ARC_FROZEN; geometry++) {
      arc_shape *shape = NULL;
      check_ok(arc_shape_create(model, (arc_geometry)geometry, refresh[k], &shape, why));
      check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
      const int moving = geometry == ARC_MOVING;
      assert_int_equal(shape->side[ARC_PLATE].own.n > 0, moving && after_one[k]);
      check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
      assert_int_equal(shape->side[ARC_PLATE].own.n > 0, moving && after_two[k]);
      assert_int_equal(shape->side[ARC_CYLINDER].own.n, 0);
      arc_shape_destroy(&shape);
    }
  free(depth);
  arc_model_release(&model);
}

/* Tests the update of the compliance between condensations. The update is of first order, so the
 * remaining error is a small part of the change at the nodes. */
static void test_drift(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_mesh *m = arc_model_mesh(model, (arc_body)b);
    const int n = m->surface;
    double *depth = calloc((size_t)n, sizeof *depth);
    for (int i = n / 4; i < n - n / 4; i++)
      depth[i] = 0.1 * m->def.height * sin(3.14159265358979 * (i - n / 4) / (n - 1 - 2 * (n / 4)));
    arc_shape *exact = NULL, *followed = NULL;
    check_ok(arc_shape_create(model, ARC_MOVING, 0, &exact, why));
    check_ok(arc_shape_create(model, ARC_MOVING, 10, &followed, why));
    check_ok(arc_shape_wear(exact, (arc_body)b, depth, why));
    check_ok(arc_shape_wear(followed, (arc_body)b, depth, why));
    const shape_side *side = &followed->side[b];
    const double *now = shape_compliance(&exact->side[b])->yy;
    const double *then = shape_compliance(side)->yy;
    assert_true(side->compliance_changed && side->own.n == 0 && !exact->side[b].compliance_changed);
    double change = 0, left = 0;
    for (int i = n / 4; i < n - n / 4; i++) {
      const double difference = now[i * n + i] - then[i * n + i];
      change = fmax(change, fabs(difference));
      left = fmax(left, fabs(difference -
                             side->compliance_change[i * ARC_THINNING_SPAN + ARC_THINNING_REACH]));
    }
    print_message("%s: drift %g, left %g mm2/N\n", arc_body_name((arc_body)b), change, left);
    assert_true(change > 0 && left < 0.2 * change);
    arc_shape_destroy(&exact);
    arc_shape_destroy(&followed);
    free(depth);
  }
  arc_model_release(&model);
}

/* Compares the displacements inside the body, computed by back-substitution, with a solution on
 * the whole mesh under the same forces. */
static void check_field(const arc_contact *contact, const arc_shape *shape, arc_body b) {
  const elastic_body *body = arc_model_body(arc_shape_model(shape), b);
  const arc_mesh *m = body->mesh;
  const arc_pressure pressure = arc_contact_pressure(contact, b);
  double *xy = malloc(2 * (size_t)m->nodes * sizeof *xy), most = 0;
  arc_shape_nodes(shape, b, xy);
  whole w = assemble(body, xy);
  double *u = calloc((size_t)w.n, sizeof *u);
  for (int s = 0; s < m->surface; s++) {
    u[w.unknown[m->surface_node[s]]] = pressure.fx[s];
    u[w.unknown[m->surface_node[s]] + 1] = (b == ARC_CYLINDER ? 1 : -1) * pressure.f[s];
  }
  check_ok(arc_factor_solve(w.k, u, why));
  for (int k = 0; k < w.n; k++) most = fmax(most, fabs(u[k]));
  arc_field *field = NULL;
  check_ok(arc_contact_field(contact, b, &field, why));
  for (int n = 0; n < m->nodes; n++) {
    const int at = w.unknown[n];
    check_near(field->ux[n], at < 0 ? 0 : u[at], 1e-10 * most);
    check_near(field->uy[n], at < 0 ? 0 : u[at + 1], 1e-10 * most);
  }
  arc_field_destroy(&field);
  whole_free(&w);
  free(u);
  free(xy);
}

static void test_inside(void **state) {
  (void)state;
  random_start(12);
  arc_model *model = coarse_model();
  arc_shape *shape = NULL;
  arc_contact *contact = NULL;
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
  for (int worn = 0; worn < 2; worn++) {
    if (worn) wear_at_random(shape, ARC_PLATE);
    check_ok(
        arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.05}, NULL, &contact, why));
    check_field(contact, shape, ARC_CYLINDER);
    check_field(contact, shape, ARC_PLATE);
    arc_contact_destroy(&contact);
  }
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* Tests that a matrix without supports gives an error instead of a solution. */
static void test_not_definite(void **state) {
  (void)state;
  sparse_entries entries = {0};
  for (int i = 0; i < 3; i++) {
    assert_int_equal(arc_sparse_add(&entries, i, i, i == 2 ? -1 : 1), ARC_OK);
  }
  factor *f = NULL;
  check_refused(arc_factor_create(3, 0, &entries, &f, why), ARC_NUMERIC, "not positive definite");
  assert_null(f);
  arc_sparse_free(&entries);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_unworn),  cmocka_unit_test(test_definite),
      cmocka_unit_test(test_mirror),  cmocka_unit_test(test_worn),
      cmocka_unit_test(test_refresh), cmocka_unit_test(test_drift),
      cmocka_unit_test(test_inside),  cmocka_unit_test(test_not_definite),
  };
  return cmocka_run_group_tests_name("condense", tests, NULL, NULL);
}

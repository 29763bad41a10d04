/* Tests of the meshes of both bodies: exact mirror symmetry, positive Jacobians, wear box, node
 * sets, outline, quality, random definitions, and refused definitions. */
#include "check.h"

static const double pi = 3.14159265358979323846;

static arc_mesh *build(const arc_mesh_def *def, arc_body body, double radius) {
  arc_mesh *mesh = NULL;
  check_ok(arc_mesh_build(def, body, radius, &mesh, why));
  return mesh;
}

/* --- mirror images ---------------------------------------------------------------------------- */

static const double *sorted_xy;

static int compare_positions(const void *a, const void *b) {
  const double *p = &sorted_xy[2 * *(const int *)a], *q = &sorted_xy[2 * *(const int *)b];
  if (p[1] != q[1]) return p[1] < q[1] ? -1 : 1;
  return (p[0] > q[0]) - (p[0] < q[0]);
}

static int compare_ints(const void *a, const void *b) {
  return (*(const int *)a > *(const int *)b) - (*(const int *)a < *(const int *)b);
}

static int compare_elements(const void *a, const void *b) {
  return memcmp(a, b, 4 * sizeof(int));
}

/* Returns for each node n the node twin[n] at exactly (-x, y); the test fails if a node has
 * none. Nodes of one height are sorted by x, so the k-th node from the left must mirror the k-th
 * from the right. */
static int *find_twins(const arc_mesh *m) {
  int *order = malloc((size_t)m->nodes * sizeof(int)),
      *twin = malloc((size_t)m->nodes * sizeof(int));
  for (int n = 0; n < m->nodes; n++) order[n] = n;
  sorted_xy = m->xy;
  qsort(order, (size_t)m->nodes, sizeof(int), compare_positions);
  for (int first = 0, end; first < m->nodes; first = end) {
    for (end = first; end < m->nodes && m->xy[2 * order[end] + 1] == m->xy[2 * order[first] + 1];)
      end++;
    for (int k = first; k < end; k++) {
      const int n = order[k], t = order[first + end - 1 - k];
      assert_true(m->xy[2 * n] == -m->xy[2 * t]);
      twin[n] = t;
    }
  }
  free(order);
  return twin;
}

/* Returns the corners of all elements, mapped by `map` if it is not NULL. The corners of each
 * element are sorted, then the elements. */
static int *canonical(const arc_mesh *m, const int *map) {
  int *list = malloc(4 * (size_t)m->elements * sizeof(int));
  for (int e = 0; e < m->elements; e++) {
    int *c = &list[4 * e];
    for (int k = 0; k < 4; k++) {
      const int n = m->element[4 * e + k];
      c[k] = n < 0 || !map ? n : map[n];
    }
    qsort(c, 4, sizeof(int), compare_ints);
  }
  qsort(list, (size_t)m->elements, 4 * sizeof(int), compare_elements);
  return list;
}

static void check_mirror(const arc_mesh *m) {
  int *twin = find_twins(m);
  int *own = canonical(m, NULL), *mirrored = canonical(m, twin);
  assert_memory_equal(own, mirrored, 4 * (size_t)m->elements * sizeof(int));
  for (int c = 0; c < m->surface; c++)
    assert_int_equal(twin[m->surface_node[c]], m->surface_node[m->surface - 1 - c]);
  free(own);
  free(mirrored);
  free(twin);
}

/* --- the wear box ----------------------------------------------------------------------------- */

static void check_counts(const arc_mesh *m) {
  int triangles = 0;
  for (int e = 0; e < m->elements; e++) {
    triangles += m->element[4 * e + 3] < 0;
    for (int c = 0; c < 4; c++) {
      const int n = m->element[4 * e + c];
      assert_true(n < m->nodes && (n >= 0 || (c == 3 && n == -1)));
    }
  }
  assert_int_equal(triangles, m->triangles);
  assert_int_equal(m->quads + m->triangles, m->elements);
  assert_int_equal(m->box_elements, (m->surface - 1) * m->rows);
}

static int has_corner(const int *element, int node) {
  return element[0] == node || element[1] == node || element[2] == node || element[3] == node;
}

/* Checks that each element (column, row) of the wear box is a quadrilateral of four box nodes. */
static void check_box_elements(const arc_mesh *m) {
  const int high = m->rows + 1;
  for (int column = 0; column + 1 < m->surface; column++)
    for (int row = 0; row < m->rows; row++) {
      const int *e = &m->element[4 * (column * m->rows + row)];
      for (int k = 0; k < 4; k++)
        assert_true(has_corner(e, m->box_node[(column + k % 2) * high + row + k / 2]));
    }
}

static void check_surface(const arc_mesh *m) {
  assert_int_equal(m->surface % 2, 1);
  const int middle = m->surface / 2;
  const double *apex = &m->xy[2 * m->surface_node[middle]];
  assert_true(apex[0] == 0 && apex[1] == 0);
  for (int c = 0; c < m->surface; c++) {
    const double *at = &m->xy[2 * m->surface_node[c]];
    assert_int_equal(m->box_node[c * (m->rows + 1)], m->surface_node[c]);
    const double arc = (c - middle) * m->def.size;
    if (m->body == ARC_PLATE) {
      check_near(at[0], arc, 1e-12 * m->radius);
      assert_true(at[1] == 0);
    } else {
      check_near(at[0], m->radius * sin(arc / m->radius), 1e-12 * m->radius);
      check_near(hypot(at[0], at[1] - m->radius), m->radius, 1e-12 * m->radius);
    }
  }
  const double width = (m->surface - 1) * m->def.size;
  assert_true(width >= m->def.zone[m->body] * (1 - 1e-9));
  assert_true(width < m->def.zone[m->body] + 2 * m->def.size * (1 + 1e-9));
}

/* Checks that the rows of the wear box have the distance `height` along the normal. */
static void check_rows(const arc_mesh *m) {
  for (int c = 0; c < m->surface; c++)
    for (int row = 0; row < m->rows; row++) {
      const int *node = &m->box_node[c * (m->rows + 1) + row];
      const double *p = &m->xy[2 * node[0]], *q = &m->xy[2 * node[1]];
      check_near(hypot(p[0] - q[0], p[1] - q[1]), m->def.height, 1e-9 * m->radius);
      assert_true(m->body == ARC_PLATE ? q[1] < p[1] : q[1] > p[1]);
    }
}

/* --- node sets and outline -------------------------------------------------------------------- */

static void check_fixed(const arc_mesh *m) {
  const double base = m->body == ARC_PLATE ? -m->radius : m->radius;
  int expected = 0;
  for (int n = 0; n < m->nodes; n++) expected += m->xy[2 * n + 1] == base;
  assert_int_equal(m->fixed, expected);
  double left = 0, right = 0;
  for (int k = 0; k < m->fixed; k++) {
    const double *at = &m->xy[2 * m->fixed_node[k]];
    assert_true(at[1] == base);
    left = fmin(left, at[0]);
    right = fmax(right, at[0]);
  }
  check_near(left, -m->radius, 1e-12 * m->radius);
  check_near(right, m->radius, 1e-12 * m->radius);
}

static double area_of(const arc_mesh *m, const int *corner, int corners) {
  double area = 0;
  for (int c = 0; c < corners; c++) {
    const double *p = &m->xy[2 * corner[c]], *q = &m->xy[2 * corner[(c + 1) % corners]];
    area += (p[0] * q[1] - q[0] * p[1]) / 2;
  }
  return area;
}

/* Checks that the outline is closed, counter-clockwise and contains each node once. Its area
 * must equal the area of the elements and of the body. */
static void check_outline(const arc_mesh *m) {
  char *seen = calloc((size_t)m->nodes, 1);
  for (int k = 0; k < m->outline; k++) assert_int_equal(seen[m->outline_node[k]]++, 0);
  free(seen);
  double elements = 0;
  for (int e = 0; e < m->elements; e++)
    elements += area_of(m, &m->element[4 * e], m->element[4 * e + 3] < 0 ? 3 : 4);
  const double inside = area_of(m, m->outline_node, m->outline);
  assert_true(inside > 0);
  check_share(elements, inside, 1e-11);
  if (m->body == ARC_PLATE) check_share(inside, 2 * m->radius * m->radius, 1e-11);
}

static void check_quality(const arc_mesh *m) {
  const arc_quality q = arc_mesh_quality(m, NULL);
  assert_true(q.smallest_jacobian > 0 && q.jacobian_ratio > 0 && q.jacobian_ratio <= 1);
  assert_true(q.smallest_angle > 0 && q.largest_angle < 180 && q.aspect >= 1);
}

static void check_all(const arc_mesh *m) {
  check_mirror(m);
  check_counts(m);
  check_box_elements(m);
  check_surface(m);
  check_rows(m);
  check_fixed(m);
  check_outline(m);
  check_quality(m);
}

/* --- tests ------------------------------------------------------------------------------------ */

static void test_default(void **state) {
  (void)state;
  const arc_mesh_def def = arc_mesh_default();
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_mesh *m = build(&def, (arc_body)b, 10);
    check_all(m);
    assert_int_equal(m->surface, b == ARC_CYLINDER ? 51 : 61);
    assert_int_equal(m->rows, 3);
    arc_mesh_destroy(&m);
    assert_null(m);
    arc_mesh_destroy(&m);
  }
}

/* Tests the element quality of the default mesh. The smallest angles are at the centre of the
 * half cylinder's fan of elements. */
static void test_default_quality(void **state) {
  (void)state;
  const arc_mesh_def def = arc_mesh_default();
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_mesh *m = build(&def, (arc_body)b, 10);
    const arc_quality q = arc_mesh_quality(m, NULL);
    print_message("# %s: %d nodes, angles %.1f to %.1f, aspect %.2f, Jacobian ratio %.3f\n",
                  arc_body_name((arc_body)b), m->nodes, q.smallest_angle, q.largest_angle, q.aspect,
                  q.jacobian_ratio);
    assert_true(q.smallest_angle > 14 && q.largest_angle < 120);
    assert_true(q.aspect < 4 && q.jacobian_ratio > 0.5);
    arc_mesh_destroy(&m);
  }
}

/* Tests that the area of the half disc converges with second order in the element size at its
 * rim. */
static void test_half_disc_area(void **state) {
  (void)state;
  arc_mesh_def def = arc_mesh_default();
  double miss[2];
  for (int k = 0; k < 2; k++) {
    def.far = k ? 0.5 : 1;
    arc_mesh *m = build(&def, ARC_CYLINDER, 10);
    miss[k] = pi * 50 - area_of(m, m->outline_node, m->outline);
    arc_mesh_destroy(&m);
  }
  assert_true(miss[0] > 0 && miss[1] > 0);
  check_below(miss[0], 0.005 * pi * 50);
  check_below(miss[1], 0.5 * miss[0]);
}

static double longest_edge(const arc_mesh *m, const int *corner) {
  const int corners = corner[3] < 0 ? 3 : 4;
  double longest = 0;
  for (int c = 0; c < corners; c++) {
    const double *p = &m->xy[2 * corner[c]], *q = &m->xy[2 * corner[(c + 1) % corners]];
    longest = fmax(longest, hypot(p[0] - q[0], p[1] - q[1]));
  }
  return longest;
}

/* Tests that no element is much larger than `far`. Diagonals of closing triangles, and stretching
 * to a whole number of cells, result in up to twice this size. The fan at the half cylinder's
 * centre is excluded. */
static void test_far_size(void **state) {
  (void)state;
  static const double far[] = {0.3, 1, 2.5};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int k = 0; k < 3; k++) {
      arc_mesh_def def = arc_mesh_default();
      def.far = far[k];
      arc_mesh *m = build(&def, (arc_body)b, 10);
      for (int e = 0; e < m->elements; e++) {
        const double *at = &m->xy[2 * m->element[4 * e + 2]];
        const int in_fan = b == ARC_CYLINDER && hypot(at[0], at[1] - 10) < 2;
        if (!in_fan) check_below(longest_edge(m, &m->element[4 * e]), 2 * far[k]);
      }
      arc_mesh_destroy(&m);
    }
}

/* Tests that the same definition gives a mesh with identical bits. */
static void test_deterministic(void **state) {
  (void)state;
  const arc_mesh_def def = arc_mesh_default();
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_mesh *one = build(&def, (arc_body)b, 10), *two = build(&def, (arc_body)b, 10);
    assert_int_equal(one->nodes, two->nodes);
    assert_memory_equal(one->xy, two->xy, 2 * (size_t)one->nodes * sizeof(double));
    assert_memory_equal(one->element, two->element, 4 * (size_t)one->elements * sizeof(int));
    arc_mesh_destroy(&one);
    arc_mesh_destroy(&two);
  }
}

/* Returns a random definition in the allowed range, limited to meshes that are quick to build. */
static arc_mesh_def random_definition(double radius) {
  arc_mesh_def def = arc_mesh_default();
  def.size = radius * exp(random_in(log(2e-3), log(0.1)));
  def.height = fmin(radius / 10, def.size * exp(random_in(log(0.1), log(10))));
  const double least = fmax(def.size, def.height);
  def.far = least * exp(random_in(0, log(radius / least)));
  def.far = fmax(def.far, radius / 60);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double narrowest = 4 * def.size;
    def.zone[b] = narrowest * exp(random_in(0, log(1.6 * radius / narrowest)));
    while (def.zone[b] * def.zone[b] > 4e4 * def.size * def.height) def.zone[b] *= 0.7;
    def.zone[b] = fmax(def.zone[b], narrowest);
  }
  const int most = (int)fmin(8, radius / 4 / def.height);
  def.rows = random_int(1, most);
  def.far = fmax(def.far, least);
  return def;
}

static void test_random(void **state) {
  (void)state;
  random_start(20240611);
  for (int trial = 0; trial < 150; trial++) {
    const double radius = exp(random_in(log(0.5), log(200)));
    const arc_mesh_def def = random_definition(radius);
    const arc_body body = trial % 2 ? ARC_PLATE : ARC_CYLINDER;
    arc_mesh *m = NULL;
    arc_error why = {ARC_OK, ""};
    if (arc_mesh_build(&def, body, radius, &m, &why) != ARC_OK) {
      print_error("trial %d: %s radius %.17g size %.17g height %.17g far %.17g zone %.17g rows %d: "
                  "%s\n",
                  trial, arc_body_name(body), radius, def.size, def.height, def.far, def.zone[body],
                  def.rows, why.message);
      fail();
    }
    check_all(m);
    arc_mesh_destroy(&m);
  }
}

/* --- refusals --------------------------------------------------------------------------------- */

static void refuse(const arc_mesh_def *def, double radius, arc_status status, const char *part) {
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_mesh *m = (arc_mesh *)def;
    check_refused(arc_mesh_build(def, (arc_body)b, radius, &m, why), status, part);
    assert_null(m);
  }
}

static void test_refused_lengths(void **state) {
  (void)state;
  static const double bad[] = {0, -0.02, NAN, INFINITY, -INFINITY, 11};
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    arc_mesh_def def = arc_mesh_default();
    def.size = bad[k];
    refuse(&def, 10, ARC_ARGUMENT, "mesh.size");
    def = arc_mesh_default();
    def.height = bad[k];
    refuse(&def, 10, ARC_ARGUMENT, "mesh.height");
    def = arc_mesh_default();
    def.far = bad[k];
    refuse(&def, 10, ARC_ARGUMENT, "mesh.far");
    def = arc_mesh_default();
    if (bad[k] != 11) refuse(&def, bad[k], ARC_ARGUMENT, "radius");
  }
  arc_mesh_def def = arc_mesh_default();
  def.far = 0.01;
  refuse(&def, 10, ARC_ARGUMENT, "mesh.far");
  def = arc_mesh_default();
  def.size = 0.001;
  refuse(&def, 10, ARC_ARGUMENT, "mesh.height");
}

static void test_refused_zones(void **state) {
  (void)state;
  static const double bad[] = {0, -1, NAN, INFINITY, 0.079, 16.1};
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    arc_mesh_def def = arc_mesh_default();
    def.zone[ARC_CYLINDER] = def.zone[ARC_PLATE] = bad[k];
    arc_mesh *m;
    check_refused(arc_mesh_build(&def, ARC_CYLINDER, 10, &m, why), ARC_ZONE, "mesh.zone.cylinder");
    check_refused(arc_mesh_build(&def, ARC_PLATE, 10, &m, why), ARC_ZONE, "mesh.zone.plate");
  }
}

static void test_refused_rows(void **state) {
  (void)state;
  static const int bad[] = {0, -1, INT32_MIN, 101, INT32_MAX};
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    arc_mesh_def def = arc_mesh_default();
    def.rows = bad[k];
    refuse(&def, 10, ARC_ARGUMENT, "mesh.rows");
  }
}

/* Tests that a mesh too large for memory is refused before any allocation. */
static void test_refused_too_fine(void **state) {
  (void)state;
  arc_mesh_def def = arc_mesh_default();
  def.size = def.height = 1e-5;
  refuse(&def, 10, ARC_ARGUMENT, "mesh.size");
  def = arc_mesh_default();
  def.size = def.height = def.far = 1e-3;
  refuse(&def, 10, ARC_ARGUMENT, "elements");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_default),         cmocka_unit_test(test_default_quality),
      cmocka_unit_test(test_half_disc_area),  cmocka_unit_test(test_far_size),
      cmocka_unit_test(test_deterministic),   cmocka_unit_test(test_random),
      cmocka_unit_test(test_refused_lengths), cmocka_unit_test(test_refused_zones),
      cmocka_unit_test(test_refused_rows),    cmocka_unit_test(test_refused_too_fine),
  };
  return cmocka_run_group_tests_name("mesh", tests, NULL, NULL);
}

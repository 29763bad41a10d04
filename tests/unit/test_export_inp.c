/* Tests of exported input decks of CalculiX, which are read back and compared with all their
 * digits. */
#include "export_shared.h"

/* Reads a number and checks that it has at most 20 characters, the limit of CalculiX. */
static double read_short(FILE *file) {
  char text[64];
  assert_int_equal(fscanf(file, " , %63[^,\n]", text), 1);
  assert_true(strlen(text) <= 20);
  return strtod(text, NULL);
}

/* Checks the node lines of one face of a body: their numbers and coordinates. */
static void check_deck_nodes(FILE *file, int nodes, const double *xy, double shift, double z,
                             int first) {
  for (int n = 0; n < nodes; n++) {
    int id;
    assert_int_equal(fscanf(file, " %d", &id), 1);
    assert_int_equal(id, n + first);
    const double x = xy[2 * n] + shift, y = xy[2 * n + 1];
    assert_true(fabs(read_short(file) - x) <= 1e-12 * fabs(x));
    assert_true(fabs(read_short(file) - y) <= 1e-12 * fabs(y));
    assert_true(read_short(file) == z);
  }
}

/* Checks the elements and their corners with the given offsets. With layer > 0, each element is
 * a solid with a second face, whose node numbers are higher by `layer`. */
static void check_deck_elements(FILE *file, const arc_mesh *m, int node, int element, int layer) {
  for (int corners = 4; corners >= 3; corners--) {
    find_line(file, "*ELEMENT, TYPE=");
    const char *plane = corners == 3 ? "CPE3," : "CPE4", *solid = corners == 3 ? "C3D6," : "C3D8";
    assert_non_null(strstr(line, layer ? solid : plane));
    for (int e = 0; e < m->elements; e++) {
      const int *c = &m->element[4 * e];
      if (arc_mesh_corners(m, e) != corners) continue;
      int got;
      assert_int_equal(fscanf(file, " %d", &got), 1);
      assert_int_equal(got, e + element);
      for (int k = 0; k < (layer ? 2 : 1) * corners; k++) {
        assert_int_equal(fscanf(file, " , %d", &got), 1);
        assert_int_equal(got, c[k % corners] + node + (k < corners ? 0 : layer));
      }
    }
  }
}

static void check_deck_set(FILE *file, const int *list, int count, int offset, int layer) {
  find_line(file, "*NSET, NSET=");
  for (int k = 0; k < (layer ? 2 : 1) * count; k++) {
    int got;
    assert_int_equal(fscanf(file, " %d ,", &got), 1);
    assert_int_equal(got, list[k % count] + offset + (k < count ? 0 : layer));
  }
}

/* Checks that every face of the contact surface connects two neighbouring nodes of the surface. */
static void check_deck_surface(FILE *file, const arc_mesh *m, int element, int first_face) {
  find_line(file, "*SURFACE, NAME=");
  for (int k = 0; k + 1 < m->surface; k++) {
    int e, face;
    assert_int_equal(fscanf(file, " %d , S%d", &e, &face), 2);
    assert_in_range(face - first_face, 0, 3);
    const int *c = &m->element[4 * (e - element)];
    const int p = c[face - first_face], q = c[(face - first_face + 1) % 4];
    assert_int_equal(p + q, m->surface_node[k] + m->surface_node[k + 1]);
  }
}

static void check_deck_body(FILE *file, const arc_contact *contact, const arc_mesh *m, int node,
                            int element, int layer) {
  double *xy = calloc(2 * (size_t)m->nodes, sizeof *xy);
  arc_shape_nodes(arc_contact_shape(contact), m->body, xy);
  const double shift = m->body == ARC_PLATE ? 0.1 : 0;
  find_line(file, "*NODE, NSET=");
  check_deck_nodes(file, m->nodes, xy, shift, 0, node);
  check_deck_nodes(file, m->nodes, xy, shift, 1, node + layer);
  free(xy);
  check_deck_elements(file, m, node, element, layer);
  check_deck_set(file, m->surface_node, m->surface, node, layer);
  check_deck_set(file, m->fixed_node, m->fixed, node, layer);
  check_deck_surface(file, m, element, 3);
  double E, nu;
  find_line(file, "*ELASTIC");
  assert_int_equal(fscanf(file, " %lf , %lf", &E, &nu), 2);
  assert_true(E == 200e3 && nu == 0.3);
}

static void test_deck(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  arc_contact *contact = solve_worn(model);
  const arc_mesh *c = arc_model_mesh(model, ARC_CYLINDER), *p = arc_model_mesh(model, ARC_PLATE);
  const char *path = in_folder("a.inp");
  check_ok(arc_export_inp(path, contact, why));
  FILE *file = fopen(path, "r");
  const int layer = c->nodes + p->nodes;
  check_deck_body(file, contact, c, 1, 1, layer);
  check_deck_body(file, contact, p, 1 + c->nodes, 1 + c->elements, layer);
  int equations = 0, base = 0, dof = 0;
  double load = 0;
  while (fgets(line, sizeof line, file) && strncmp(line, "*SURFACE INT", 12) != 0)
    equations += strncmp(line, "*EQUATION", 9) == 0;
  assert_int_equal(equations, 2 * p->fixed);
  find_line(file, "*CLOAD");
  assert_int_equal(fscanf(file, " base, %d, %lf", &dof, &load), 2);
  assert_true(dof == 2 && load == 100);
  rewind(file);
  find_line(file, "*NODE, NSET=base");
  assert_int_equal(fscanf(file, " %d", &base), 1);
  assert_int_equal(base, 2 * layer + 1);
  fclose(file);
  arc_contact_destroy(&contact);
  arc_model_release(&model);
}

static void test_mesh_deck(void **state) {
  (void)state;
  arc_mesh_def def = coarse_definition().mesh;
  def.element = ARC_CPE4I;
  arc_mesh *m = NULL;
  check_ok(arc_mesh_build(&def, ARC_PLATE, 10, &m, why));
  const char *path = in_folder("b.inp");
  check_ok(arc_export_mesh_inp(path, m, why));
  FILE *file = fopen(path, "r");
  find_line(file, "*NODE, NSET=");
  check_deck_nodes(file, m->nodes, m->xy, 0, 0, 1);
  check_deck_elements(file, m, 1, 1, 0);
  check_deck_surface(file, m, 1, 1);
  rewind(file);
  find_line(file, "*ELEMENT, TYPE=CPE4I,");
  fclose(file);
  arc_mesh_destroy(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_deck),
      cmocka_unit_test(test_mesh_deck),
  };
  return cmocka_run_group_tests_name("input decks", tests, make_folder, remove_folder);
}

/* Tests of exported VTK files, in the legacy and the XML format, which are read back and
 * compared bit by bit. */
#include "export_shared.h"

/* --- legacy ----------------------------------------------------------------------------------- */

static void check_numbers(FILE *file, const double *expected, int count, int stride) {
  for (int k = 0; k < count; k++) {
    double value = NAN;
    assert_int_equal(fscanf(file, " %lf", &value), 1);
    assert_true(value == expected[k * stride]);
  }
}

static void check_grid(FILE *file, const arc_mesh *m, const arc_field *field) {
  int count, numbers;
  find_line(file, "DATASET UNSTRUCTURED_GRID");
  find_line(file, "POINTS");
  assert_int_equal(sscanf(line, "POINTS %d double", &count), 1);
  assert_int_equal(count, m->nodes);
  const double zero = 0;
  for (int n = 0; n < m->nodes; n++) {
    check_numbers(file, field ? &field->x[n] : &m->xy[2 * n], 1, 1);
    check_numbers(file, field ? &field->y[n] : &m->xy[2 * n + 1], 1, 1);
    check_numbers(file, &zero, 1, 1);
  }
  find_line(file, "CELLS");
  assert_int_equal(sscanf(line, "CELLS %d %d", &count, &numbers), 2);
  assert_int_equal(count, m->elements);
  assert_int_equal(numbers, 5 * m->quads + 4 * m->triangles);
  for (int e = 0; e < m->elements; e++) {
    const int *c = &m->element[4 * e], corners = arc_mesh_corners(m, e);
    int got;
    assert_int_equal(fscanf(file, " %d", &got), 1);
    assert_int_equal(got, corners);
    for (int k = 0; k < corners; k++) {
      assert_int_equal(fscanf(file, " %d", &got), 1);
      assert_int_equal(got, c[k]);
    }
  }
  find_line(file, "CELL_TYPES");
  for (int e = 0; e < m->elements; e++) {
    int got;
    assert_int_equal(fscanf(file, " %d", &got), 1);
    assert_int_equal(got, m->element[4 * e + 3] < 0 ? 5 : 9);
  }
}

static arc_field *solve_field(arc_model *model, arc_body body) {
  arc_shape *shape = NULL;
  arc_contact *contact = NULL;
  arc_field *field = NULL;
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
  check_ok(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.1}, NULL, &contact, why));
  check_ok(arc_contact_field(contact, body, &field, why));
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
  return field;
}

static void test_vtk(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  for (int b = 0; b < ARC_BODIES; b++)
    for (int with_field = 0; with_field < 2; with_field++) {
      const arc_mesh *m = arc_model_mesh(model, (arc_body)b);
      arc_field *f = with_field ? solve_field(model, (arc_body)b) : NULL;
      const char *path = in_folder("a.vtk");
      check_ok(arc_export_vtk(path, m, f, why));
      FILE *file = fopen(path, "r");
      check_grid(file, m, f);
      if (f) {
        find_line(file, "VECTORS displacement");
        for (int n = 0; n < f->nodes; n++) {
          const double u[3] = {f->ux[n], f->uy[n], 0};
          check_numbers(file, u, 3, 1);
        }
        static const char *const names[] = {"sxx",   "syy",       "szz",  "sxy",
                                            "mises", "principal", "shear"};
        const double *const columns[] = {f->sxx,   f->syy,       f->szz,  f->sxy,
                                         f->mises, f->principal, f->shear};
        for (int c = 0; c < 7; c++) {
          find_line(file, "SCALARS");
          assert_int_equal(strncmp(line + 8, names[c], strlen(names[c])), 0);
          find_line(file, "LOOKUP_TABLE");
          check_numbers(file, columns[c], f->nodes, 1);
        }
      }
      fclose(file);
      arc_field_destroy(&f);
    }
  arc_model_release(&model);
}

static void test_foreign_field(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  arc_field *field = solve_field(model, ARC_PLATE);
  const int before = files_in_folder();
  check_refused(
      arc_export_vtk(in_folder("foreign.vtk"), arc_model_mesh(model, ARC_CYLINDER), field, why),
      ARC_ARGUMENT, "field");
  assert_int_equal(files_in_folder(), before);
  arc_field_destroy(&field);
  arc_model_release(&model);
}

/* --- XML VTK ---------------------------------------------------------------------------------- */

static char *read_whole(const char *path, size_t *size) {
  FILE *file = fopen(path, "rb");
  assert_non_null(file);
  fseek(file, 0, SEEK_END);
  *size = (size_t)ftell(file);
  rewind(file);
  char *text = calloc(*size + 1, 1);
  assert_int_equal(fread(text, 1, *size, file), *size);
  fclose(file);
  return text;
}

/* Returns the data of the array with this name, at the offset in its header. Writes the number of
 * bytes to *bytes. */
static const void *array_bytes(const char *text, const char *name, uint64_t *bytes) {
  char start[80];
  snprintf(start, sizeof start, "Name=\"%s\"", name);
  const char *described = strstr(text, start);
  assert_non_null(described);
  unsigned long long offset = 0;
  assert_int_equal(sscanf(strstr(described, "offset="), "offset=\"%llu\"", &offset), 1);
  const char *data = strstr(text, "encoding=\"raw\">\n_") + strlen("encoding=\"raw\">\n_") + offset;
  memcpy(bytes, data, sizeof *bytes);
  return data + sizeof *bytes;
}

static void check_array(const char *text, const char *name, const void *expected, size_t bytes) {
  uint64_t count;
  const void *data = array_bytes(text, name, &count);
  assert_int_equal(count, bytes);
  assert_memory_equal(data, expected, bytes);
}

static void check_cells(const char *text, const arc_mesh *m) {
  uint64_t bytes;
  const char *offsets = array_bytes(text, "offsets", &bytes),
             *corners = array_bytes(text, "connectivity", &bytes),
             *types = array_bytes(text, "types", &bytes);
  int at = 0;
  for (int e = 0; e < m->elements; e++) {
    int32_t end, corner;
    memcpy(&end, offsets + 4 * e, sizeof end);
    const int n = arc_mesh_corners(m, e);
    assert_int_equal(end - at, n);
    assert_int_equal(types[e], n == 3 ? 5 : 9);
    for (int k = 0; k < n; k++) {
      memcpy(&corner, corners + 4 * (at + k), sizeof corner);
      assert_int_equal(corner, m->element[4 * e + k]);
    }
    at = end;
  }
}

/* Checks that the values of a surface column are written at the nodes of the surface and that
 * all other nodes have the value 0. */
static void check_surface(const char *text, const char *name, const arc_mesh *m,
                          const double *expected) {
  double *all = calloc((size_t)m->nodes, sizeof *all), sum = 0;
  for (int i = 0; i < m->surface; i++) sum += all[m->surface_node[i]] = expected[i];
  assert_true(sum > 0);
  check_array(text, name, all, (size_t)m->nodes * sizeof *all);
  free(all);
}

static void check_worn_vtu(const char *text, const arc_contact *contact, const arc_mesh *m) {
  arc_field *f = NULL;
  check_ok(arc_contact_field(contact, m->body, &f, why));
  const double time = 0.1;
  const size_t bytes = (size_t)m->nodes * sizeof(double);
  check_array(text, "TimeValue", &time, sizeof time);
#define CHECK_STRESS(name, unit, text_) check_array(text, #name, f->name, bytes);
  ARC_FIELD_STRESSES(CHECK_STRESS)
  double *points = calloc(3 * (size_t)m->nodes, sizeof *points);
  for (int n = 0; n < m->nodes; n++) points[3 * n] = f->x[n], points[3 * n + 1] = f->y[n];
  check_array(text, "Points", points, 3 * bytes);
  for (int n = 0; n < m->nodes; n++) points[3 * n] = f->ux[n], points[3 * n + 1] = f->uy[n];
  check_array(text, "displacement", points, 3 * bytes);
  check_surface(text, "pressure", m, arc_contact_pressure(contact, m->body).p);
  if (m->body == ARC_PLATE)
    check_surface(text, "wear_depth", m,
                  arc_shape_profile(arc_contact_shape(contact), ARC_PLATE).h);
  free(points);
  arc_field_destroy(&f);
}

static void test_vtu(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  arc_contact *contact = solve_worn(model);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int with_contact = 0; with_contact < 2; with_contact++) {
      const arc_mesh *m = arc_model_mesh(model, (arc_body)b);
      const char *path = in_folder("a.vtu");
      check_ok(arc_export_vtu(path, m, with_contact ? contact : NULL, 0.1, why));
      size_t size;
      char *text = read_whole(path, &size), piece[80];
      snprintf(piece, sizeof piece, "NumberOfPoints=\"%d\" NumberOfCells=\"%d\"", m->nodes,
               m->elements);
      assert_non_null(strstr(text, piece));
      static const char end[] = "\n</AppendedData>\n</VTKFile>\n";
      assert_string_equal(text + size - strlen(end), end);
      check_cells(text, m);
      assert_int_equal(!!strstr(text, "mises"), with_contact);
      if (with_contact) check_worn_vtu(text, contact, m);
      free(text);
    }
  arc_contact_destroy(&contact);
  arc_model_release(&model);
}

static void test_foreign_contact(void **state) {
  (void)state;
  arc_model_def def = coarse_definition();
  def.radius = 11;
  arc_model *model = coarse_model(), *other = NULL;
  check_ok(arc_model_build(&def, &other, why));
  arc_contact *contact = solve_worn(other);
  const int before = files_in_folder();
  check_refused(
      arc_export_vtu(in_folder("c.vtu"), arc_model_mesh(model, ARC_PLATE), contact, 0, why),
      ARC_ARGUMENT, "contact");
  assert_int_equal(files_in_folder(), before);
  arc_contact_destroy(&contact);
  arc_model_release(&other);
  arc_model_release(&model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_vtk),
      cmocka_unit_test(test_foreign_field),
      cmocka_unit_test(test_vtu),
      cmocka_unit_test(test_foreign_contact),
  };
  return cmocka_run_group_tests_name("VTK", tests, make_folder, remove_folder);
}

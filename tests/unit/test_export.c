/* Files for other tools, read back to the bit; a write that fails leaves no file, and one that was
 * there before stays. */
#include "check.h"

#include <dirent.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "archard/export.h"

static char folder[] = "/tmp/archard-export-XXXXXX";

static const char *in_folder(const char *name) {
  static char path[300];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

static int set_up(void **state) {
  (void)state;
  signal(SIGXFSZ, SIG_IGN);
  return mkdtemp(folder) ? 0 : -1;
}

static int tear_down(void **state) {
  (void)state;
  char command[80];
  snprintf(command, sizeof command, "rm -rf %s", folder);
  return system(command);
}

static int files_in_folder(void) {
  DIR *dir = opendir(folder);
  int count = 0;
  for (struct dirent *entry; (entry = readdir(dir));) count += entry->d_name[0] != '.';
  closedir(dir);
  return count;
}

static void write_text(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
}

/* Reads on to the line that begins with `start`; fails where there is none. The line is in `line`.
 */
static char line[400];

static void find_line(FILE *file, const char *start) {
  while (fgets(line, sizeof line, file))
    if (strncmp(line, start, strlen(start)) == 0) return;
  print_error("no line '%s'\n", start);
  fail();
}

static void check_numbers(FILE *file, const double *expected, int count, int stride) {
  for (int k = 0; k < count; k++) {
    double value = NAN;
    assert_int_equal(fscanf(file, " %lf", &value), 1);
    assert_true(value == expected[k * stride]);
  }
}

/* --- CSV -------------------------------------------------------------------------------------- */

static void test_csv(void **state) {
  (void)state;
  static const double x[] = {0.1, -1.0 / 3, 1e-300, 6.02e23}, y[] = {NAN, -NAN, INFINITY, -0.0};
  static const char *const names[] = {"x", "y"};
  static const double *const data[] = {x, y};
  const char *path = in_folder("a.csv");
  check_ok(arc_export_csv(path, 2, names, NULL, data, 4, why));
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  assert_non_null(fgets(line, sizeof line, file));
  assert_string_equal(line, "x,y\n");
  for (int r = 0; r < 4; r++) {
    assert_non_null(fgets(line, sizeof line, file));
    char *rest;
    const double a = strtod(line, &rest);
    assert_true(a == x[r] && *rest == ',');
    if (r < 2) assert_string_equal(rest, ",nan\n");
    const double b = strtod(rest + 1, &rest);
    assert_true(r < 2 ? isnan(b) : b == y[r]);
    assert_string_equal(rest, "\n");
  }
  assert_null(fgets(line, sizeof line, file));
  fclose(file);
}

static void test_empty_csv(void **state) {
  (void)state;
  static const char *const names[] = {"only"};
  static const double *const data[] = {NULL};
  const char *path = in_folder("b.csv");
  check_ok(arc_export_csv(path, 1, names, NULL, data, 0, why));
  struct stat info;
  assert_int_equal(stat(path, &info), 0);
  assert_int_equal(info.st_size, 5);
}

/* --- VTK -------------------------------------------------------------------------------------- */

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
    const int *c = &m->element[4 * e], corners = c[3] < 0 ? 3 : 4;
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

/* The bytes of the array of that name, and how many, as its description says. */
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
    const int n = m->element[4 * e + 3] < 0 ? 3 : 4;
    assert_int_equal(end - at, n);
    assert_int_equal(types[e], n == 3 ? 5 : 9);
    for (int k = 0; k < n; k++) {
      memcpy(&corner, corners + 4 * (at + k), sizeof corner);
      assert_int_equal(corner, m->element[4 * e + k]);
    }
    at = end;
  }
}

static arc_contact *solve_worn(arc_model *model) {
  arc_shape *shape = NULL;
  arc_contact *contact = NULL;
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
  const int n = arc_model_mesh(model, ARC_PLATE)->surface;
  double *depth = calloc((size_t)n, sizeof *depth);
  for (int i = n / 3; i < n - n / 3; i++) depth[i] = 1e-4 / 3;
  check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
  check_ok(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.1}, NULL, &contact, why));
  arc_shape_destroy(&shape);
  free(depth);
  return contact;
}

/* Surface columns stand at the surface's nodes. */
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

/* --- input decks ------------------------------------------------------------------------------ */

/* CalculiX reads 20 characters of a number. */
static double read_short(FILE *file) {
  char text[64];
  assert_int_equal(fscanf(file, " , %63[^,\n]", text), 1);
  assert_true(strlen(text) <= 20);
  return strtod(text, NULL);
}

/* Nodes of one face of a body. */
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

/* Elements with their corners at the given offset; `layer` > 0: a second face of each. */
static void check_deck_elements(FILE *file, const arc_mesh *m, int node, int element, int layer) {
  for (int corners = 4; corners >= 3; corners--) {
    find_line(file, "*ELEMENT, TYPE=");
    const char *plane = corners == 3 ? "CPE3," : "CPE4", *solid = corners == 3 ? "C3D6," : "C3D8";
    assert_non_null(strstr(line, layer ? solid : plane));
    for (int e = 0; e < m->elements; e++) {
      const int *c = &m->element[4 * e];
      if ((c[3] < 0 ? 3 : 4) != corners) continue;
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

/* Every face of the contact surface lies between two neighbours of the candidate nodes. */
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

/* --- failures --------------------------------------------------------------------------------- */

typedef arc_status (*writer)(const char *path, arc_model *model, arc_error *error);

static arc_status write_csv(const char *path, arc_model *model, arc_error *error) {
  static double column[20000];
  static const char *const names[] = {"x"};
  static const double *const data[] = {column};
  (void)model;
  return arc_export_csv(path, 1, names, NULL, data, 20000, error);
}

static arc_status write_vtk(const char *path, arc_model *model, arc_error *error) {
  return arc_export_vtk(path, arc_model_mesh(model, ARC_PLATE), NULL, error);
}

static arc_status write_vtu(const char *path, arc_model *model, arc_error *error) {
  return arc_export_vtu(path, arc_model_mesh(model, ARC_PLATE), NULL, 0, error);
}

static arc_status write_inp(const char *path, arc_model *model, arc_error *error) {
  arc_contact *contact = solve_worn(model);
  const arc_status status = arc_export_inp(path, contact, error);
  arc_contact_destroy(&contact);
  return status;
}

static arc_status write_mesh_inp(const char *path, arc_model *model, arc_error *error) {
  return arc_export_mesh_inp(path, arc_model_mesh(model, ARC_PLATE), error);
}

static const writer writers[] = {write_csv, write_vtk, write_vtu, write_inp, write_mesh_inp};
enum { writer_count = sizeof writers / sizeof *writers };

static void limit_files(rlim_t bytes) {
  struct rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  setrlimit(RLIMIT_FSIZE, &limit);
}

/* The disk is full after some bytes: no new file, the old one as it was. */
static void test_full_disk(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  const int before = files_in_folder();
  for (int w = 0; w < writer_count; w++)
    for (rlim_t bytes = 0; bytes < 20000; bytes += 4999) {
      const char *path = in_folder("full");
      limit_files(bytes);
      arc_error why = {ARC_OK, ""};
      const arc_status status = writers[w](path, model, &why);
      limit_files(RLIM_INFINITY);
      assert_int_equal(status, ARC_IO);
      assert_non_null(strstr(why.message, path));
      assert_non_null(strstr(why.message, "File too large"));
      assert_int_equal(files_in_folder(), before);
    }
  write_text(in_folder("old"), "kept");
  limit_files(1000);
  const arc_status status = write_vtk(in_folder("old"), model, NULL);
  limit_files(RLIM_INFINITY);
  assert_int_equal(status, ARC_IO);
  FILE *file = fopen(in_folder("old"), "r");
  assert_non_null(fgets(line, sizeof line, file));
  assert_string_equal(line, "kept");
  fclose(file);
  assert_int_equal(files_in_folder(), before + 1);
  arc_model_release(&model);
}

/* No such folder, and a folder where the file should be. */
static void test_no_place(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  mkdir(in_folder("taken"), 0700);
  const int before = files_in_folder();
  for (int w = 0; w < writer_count; w++) {
    check_refused(writers[w](in_folder("nowhere/file"), model, why), ARC_IO, "No such file");
    check_refused(writers[w](in_folder("taken"), model, why), ARC_IO, "taken");
  }
  assert_int_equal(files_in_folder(), before);
  arc_model_release(&model);
}

/* A file that was there is replaced as a whole. */
static void test_replaced(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  for (int w = 0; w < writer_count; w++) {
    struct stat fresh, again;
    check_ok(writers[w](in_folder("fresh"), model, why));
    write_text(in_folder("again"), "something else");
    check_ok(writers[w](in_folder("again"), model, why));
    stat(in_folder("fresh"), &fresh);
    stat(in_folder("again"), &again);
    assert_int_equal(fresh.st_size, again.st_size);
  }
  arc_model_release(&model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_csv),       cmocka_unit_test(test_empty_csv),
      cmocka_unit_test(test_vtk),       cmocka_unit_test(test_foreign_field),
      cmocka_unit_test(test_vtu),       cmocka_unit_test(test_foreign_contact),
      cmocka_unit_test(test_deck),      cmocka_unit_test(test_mesh_deck),
      cmocka_unit_test(test_full_disk), cmocka_unit_test(test_no_place),
      cmocka_unit_test(test_replaced),
  };
  return cmocka_run_group_tests_name("export", tests, set_up, tear_down);
}

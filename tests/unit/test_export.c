/* Files for other tools, read back to the bit; a write that fails leaves no file, and one that was
 * there before stays. */
#include "check.h"

#include <dirent.h>
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
  check_ok(arc_export_csv(path, 2, names, data, 4, why));
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
  check_ok(arc_export_csv(path, 1, names, data, 0, why));
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

/* --- input decks ------------------------------------------------------------------------------ */

/* Nodes and elements of one body at the given offsets, both 1-based. */
static void check_deck_mesh(FILE *file, const arc_mesh *m, int node, int element) {
  find_line(file, "*NODE, NSET=");
  for (int n = 0; n < m->nodes; n++) {
    int id;
    double x, y, z;
    assert_int_equal(fscanf(file, " %d , %lf , %lf , %lf", &id, &x, &y, &z), 4);
    assert_int_equal(id, n + node);
    assert_true(x == m->xy[2 * n] && y == m->xy[2 * n + 1] && z == 0);
  }
  for (int corners = 4; corners >= 3; corners--) {
    find_line(file, "*ELEMENT, TYPE=CPE");
    assert_int_equal(line[18] - '0', corners);
    for (int e = 0; e < m->elements; e++) {
      const int *c = &m->element[4 * e];
      if ((c[3] < 0 ? 3 : 4) != corners) continue;
      int got;
      assert_int_equal(fscanf(file, " %d", &got), 1);
      assert_int_equal(got, e + element);
      for (int k = 0; k < corners; k++) {
        assert_int_equal(fscanf(file, " , %d", &got), 1);
        assert_int_equal(got, c[k] + node);
      }
    }
  }
}

static void check_deck_set(FILE *file, const char *start, const int *list, int count, int offset) {
  find_line(file, start);
  for (int k = 0; k < count; k++) {
    int got;
    assert_int_equal(fscanf(file, " %d ,", &got), 1);
    assert_int_equal(got, list[k] + offset);
  }
}

/* Every face of the contact surface lies between two neighbours of the candidate nodes. */
static void check_deck_surface(FILE *file, const arc_mesh *m, int element) {
  find_line(file, "*SURFACE, NAME=");
  for (int k = 0; k + 1 < m->surface; k++) {
    int e, face;
    assert_int_equal(fscanf(file, " %d , S%d", &e, &face), 2);
    assert_true(face >= 1 && face <= 4);
    const int *c = &m->element[4 * (e - element)];
    const int p = c[face - 1], q = c[face % 4];
    assert_int_equal(p + q, m->surface_node[k] + m->surface_node[k + 1]);
  }
}

static void test_deck(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  const char *path = in_folder("a.inp");
  check_ok(arc_export_inp(path, model, why));
  FILE *file = fopen(path, "r");
  int node = 1, element = 1;
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_mesh *m = arc_model_mesh(model, (arc_body)b);
    check_deck_mesh(file, m, node, element);
    check_deck_set(file, "*NSET, NSET=", m->surface_node, m->surface, node);
    check_deck_set(file, "*NSET, NSET=", m->fixed_node, m->fixed, node);
    find_line(file, "*ELSET, ELSET=");
    check_deck_surface(file, m, element);
    double E, nu;
    find_line(file, "*ELASTIC");
    assert_int_equal(fscanf(file, " %lf , %lf", &E, &nu), 2);
    assert_true(E == 200e3 && nu == 0.3);
    node += m->nodes;
    element += m->elements;
  }
  fclose(file);
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
  check_deck_mesh(file, m, 1, 1);
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
  return arc_export_csv(path, 1, names, data, 20000, error);
}

static arc_status write_vtk(const char *path, arc_model *model, arc_error *error) {
  return arc_export_vtk(path, arc_model_mesh(model, ARC_PLATE), NULL, error);
}

static arc_status write_inp(const char *path, arc_model *model, arc_error *error) {
  return arc_export_inp(path, model, error);
}

static arc_status write_mesh_inp(const char *path, arc_model *model, arc_error *error) {
  return arc_export_mesh_inp(path, arc_model_mesh(model, ARC_PLATE), error);
}

static const writer writers[] = {write_csv, write_vtk, write_inp, write_mesh_inp};
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
      cmocka_unit_test(test_deck),      cmocka_unit_test(test_mesh_deck),
      cmocka_unit_test(test_full_disk), cmocka_unit_test(test_no_place),
      cmocka_unit_test(test_replaced),
  };
  return cmocka_run_group_tests_name("export", tests, set_up, tear_down);
}

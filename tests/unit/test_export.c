/* Tests of failures of all export formats: a failed write creates no new file and does not
 * change an existing one. */
#include "export_shared.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

static void write_text(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
}

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

/* Tests a full disk: no new file remains, and the old file is unchanged. */
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

/* Tests writing into a missing folder and onto a folder that has the name of the file. */
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

/* Tests that an existing file is replaced as a whole. */
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

static int set_up(void **state) {
  signal(SIGXFSZ, SIG_IGN);
  return make_folder(state);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_full_disk),
      cmocka_unit_test(test_no_place),
      cmocka_unit_test(test_replaced),
  };
  return cmocka_run_group_tests_name("export", tests, set_up, remove_folder);
}

/* Tests of exported comma-separated columns, which are read back and compared bit by bit. */
#include "export_shared.h"

#include <sys/stat.h>

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

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_csv),
      cmocka_unit_test(test_empty_csv),
  };
  return cmocka_run_group_tests_name("CSV", tests, make_folder, remove_folder);
}

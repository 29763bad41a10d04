/* Tests of status codes, error messages, and the functions of measure.h. */
#include "archard/measure.h"
#include "check.h"

static const arc_status all[] = {
#define LISTED(name, value, text) ARC_##name,
    ARC_STATUS_LIST(LISTED)
#undef LISTED
};
enum { count = sizeof all / sizeof *all };

static void test_texts(void **state) {
  (void)state;
  assert_string_equal(arc_status_text(ARC_OK), "success");
  assert_string_equal(arc_status_text(ARC_MEMORY), "out of memory");
  assert_string_equal(arc_status_name(ARC_MEMORY), "MEMORY");
  for (int i = 0; i < count; i++)
    for (int k = 0; k < i; k++) {
      assert_int_not_equal(all[i], all[k]);
      assert_string_not_equal(arc_status_text(all[i]), arc_status_text(all[k]));
      assert_string_not_equal(arc_status_name(all[i]), arc_status_name(all[k]));
    }
}

static void test_unknown_status(void **state) {
  (void)state;
  assert_string_equal(arc_status_text((arc_status)99), "unknown status");
  assert_string_equal(arc_status_name((arc_status)99), "UNKNOWN");
}

static void test_signs(void **state) {
  (void)state;
  assert_int_equal(ARC_OK, 0);
  assert_true(ARC_STOPPED > 0 && ARC_NOT_CONVERGED > 0 && ARC_CALLBACK > 0);
  assert_true(ARC_ARGUMENT < 0 && ARC_MEMORY < 0 && ARC_ZONE < 0 && ARC_IO < 0);
}

static void test_fail(void **state) {
  (void)state;
  arc_error error = {ARC_OK, "before"};
  assert_int_equal(arc_fail(&error, ARC_ZONE, "%s = %g mm", "stroke", 0.5), ARC_ZONE);
  assert_int_equal(error.status, ARC_ZONE);
  assert_string_equal(error.message, "stroke = 0.5 mm");
  assert_int_equal(arc_fail(NULL, ARC_IO, "nobody listens"), ARC_IO);
}

static void assert_shown(const char *text, const char *expected) {
  char shown[60];
  arc_show_text(text, shown, sizeof shown);
  assert_string_equal(shown, expected);
}

static void test_show_text(void **state) {
  (void)state;
  assert_shown("plain, 5 \xc2\xb5m, \xe2\x86\x92, \xf0\x9f\x99\x82\ttab\nline",
               "plain, 5 \xc2\xb5m, \xe2\x86\x92, \xf0\x9f\x99\x82\ttab\nline");
  assert_shown("\x1b[2J\r\x7f", "\\x1b[2J\\x0d\\x7f");
  assert_shown("\xc2\x9b"
               "2J",
               "\\xc2\\x9b2J");
  assert_shown("a\xe2\x80\xaez",
               "a\\xe2\\x80\\xaez"); /* U+202E, which reverses the order of the following text */
  assert_shown("\xe2\x81\xa6\xd8\x9c\xe2\x80", "\\xe2\\x81\\xa6\\xd8\\x9c\\xe2\\x80");
  assert_shown("\xe2\x80\x93\xd8\x9b", "\xe2\x80\x93\xd8\x9b");
  assert_shown("\x9b\xff\xc3", "\\x9b\\xff\\xc3");
  assert_shown("\xe2\x86", "\\xe2\\x86");
  char few[6];
  arc_show_text("ab\x1b", few, sizeof few);
  assert_string_equal(few, "ab");
  arc_show_text("\x1b", few, sizeof few);
  assert_string_equal(few, "\\x1b");
  arc_error error = {0};
  arc_fail(&error, ARC_IO, "%s: gone", "a\x1b");
  assert_string_equal(error.message, "a\\x1b: gone");
}

static void test_long_message(void **state) {
  (void)state;
  struct {
    arc_error error;
    char guard[8];
  } held;
  memset(&held, 'x', sizeof held);
  char longer[2000];
  memset(longer, 'a', sizeof longer - 1);
  longer[sizeof longer - 1] = '\0';
  arc_fail(&held.error, ARC_ARGUMENT, "%s", longer);
  assert_int_equal(strlen(held.error.message), sizeof held.error.message - 1);
  assert_memory_equal(held.guard, "xxxxxxxx", 8);
}

static void test_one_thread(void **state) {
  (void)state;
  const char *first = arc_single_threaded(), *second = arc_single_threaded();
  assert_ptr_equal(first, second);
}

/* --- measures --------------------------------------------------------------------------------- */

static void test_interpolate(void **state) {
  (void)state;
  static const double x[] = {0, 1, 3}, y[] = {2, 4, 0};
  assert_true(arc_measure_interpolate(x, y, 3, 0.5, -1) == 3);
  assert_true(arc_measure_interpolate(x, y, 3, 1, -1) == 4);
  assert_true(arc_measure_interpolate(x, y, 3, 2, -1) == 2);
  assert_true(arc_measure_interpolate(x, y, 3, 3, -1) == 0);
  assert_true(arc_measure_interpolate(x, y, 3, 3.5, -1) == -1);
  assert_true(arc_measure_interpolate(x, y, 3, -0.5, -1) == -1);
  assert_true(arc_measure_interpolate(x, y, 1, 0, -1) == 2);
  assert_true(arc_measure_interpolate(NULL, NULL, 0, 0, -1) == -1);
}

/* Tests the sawtooth measure: a cubic has no sawtooth part, and the amplitude 0.5 of a sawtooth
 * added to the cubic is measured exactly. */
static void test_sawtooth(void **state) {
  (void)state;
  double x[21], y[21];
  for (int i = 0; i < 21; i++) x[i] = i - 10, y[i] = x[i] * x[i] * (x[i] + 2);
  check_near(arc_measure_sawtooth(x, y, 21, -10, 10), 0, 1e-12);
  for (int i = 0; i < 21; i++) y[i] += i % 2 ? 0.5 : -0.5;
  check_near(arc_measure_sawtooth(x, y, 21, -10, 10), 0.5, 1e-12);
  check_near(arc_measure_sawtooth(x, y, 21, -1, 1), 0.5, 1e-12);
  assert_true(arc_measure_sawtooth(x, y, 21, 11, 12) == 0);
  assert_true(arc_measure_sawtooth(x, y, 3, -10, 10) == 0);
}

static void test_partition(void **state) {
  (void)state;
  static const double xc[] = {-1, 1}, hc[] = {3, 3}, xp[] = {-2, -1, 0, 2}, hp[] = {0, 1, 0, 2};
  const arc_depths cylinder = {2, xc, hc}, plate = {4, xp, hp};
  double sum[4], x[4], share[4];
  assert_true(arc_depth_partition(1, 3) == 0.25);
  assert_true(isnan(arc_depth_partition(0, 0)));
  arc_measure_combined(cylinder, plate, sum);
  assert_true(sum[0] == 0 && sum[1] == 4 && sum[2] == 3 && sum[3] == 2);
  assert_int_equal(arc_measure_local_partition(cylinder, plate, x, share), 3);
  assert_true(x[0] == -1 && x[1] == 0 && x[2] == 2);
  assert_true(share[0] == 0.75 && share[1] == 1 && share[2] == 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_texts),      cmocka_unit_test(test_unknown_status),
      cmocka_unit_test(test_signs),      cmocka_unit_test(test_fail),
      cmocka_unit_test(test_show_text),  cmocka_unit_test(test_long_message),
      cmocka_unit_test(test_one_thread), cmocka_unit_test(test_interpolate),
      cmocka_unit_test(test_sawtooth),   cmocka_unit_test(test_partition),
  };
  return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}

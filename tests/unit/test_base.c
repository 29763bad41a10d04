/* Statuses and error messages. */
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

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_texts),        cmocka_unit_test(test_unknown_status),
      cmocka_unit_test(test_signs),        cmocka_unit_test(test_fail),
      cmocka_unit_test(test_long_message), cmocka_unit_test(test_one_thread),
  };
  return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}

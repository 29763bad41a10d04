/* Common parts of the unit tests: cmocka, a random generator that prints its seed, comparisons
 * of numbers and a small model. All functions are static because each test program is compiled
 * from one file. */
#ifndef TESTS_CHECK_H
#define TESTS_CHECK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "archard/wear.h"

#define UNUSED __attribute__((unused))

/* Returns true in a run of all tests (tests/run -a), which includes long ones. */
UNUSED static int all_tests(void) {
  const char *all = getenv("ARCHARD_ALL");
  return all && *all;
}

/* --- random numbers --------------------------------------------------------------------------- */

static uint64_t random_state = 1;

/* Seeds the random generator with ARCHARD_SEED if this variable is set, otherwise with `usual`,
 * and prints the seed. */
UNUSED static void random_start(uint64_t usual) {
  const char *wish = getenv("ARCHARD_SEED");
  random_state = wish ? strtoull(wish, NULL, 10) : usual;
  printf("# seed %llu\n", (unsigned long long)random_state);
  if (random_state == 0) random_state = 1;
}

/* Returns a uniform random number in [low, high), by xorshift64*. */
UNUSED static double random_in(double low, double high) {
  random_state ^= random_state >> 12;
  random_state ^= random_state << 25;
  random_state ^= random_state >> 27;
  const uint64_t bits = random_state * 2685821657736338717ull;
  return low + (high - low) * ((double)(bits >> 11) / 9007199254740992.0);
}

UNUSED static int random_int(int low, int high) {
  return low + (int)random_in(0, high - low + 1);
}

/* --- comparisons ------------------------------------------------------------------------------ */

/* Checks |got - expected| <= tolerance; a failure prints both numbers. */
#define check_near(got, expected, tolerance)                                                       \
  check_near_at(got, expected, tolerance, #got, __FILE__, __LINE__)

UNUSED static void check_near_at(double got, double expected, double tolerance, const char *what,
                                 const char *file, int line) {
  if (fabs(got - expected) <= tolerance) return;
  print_error("%s: got %.17g, expected %.17g within %g\n", what, got, expected, tolerance);
  _fail(file, line);
}

/* Checks |got - expected| <= share * |expected|; a failure prints both numbers. */
#define check_share(got, expected, share)                                                          \
  check_near_at(got, expected, (share)*fabs((double)(expected)), #got, __FILE__, __LINE__)

#define check_below(got, limit) check_below_at(got, limit, #got, __FILE__, __LINE__)

UNUSED static void check_below_at(double got, double limit, const char *what, const char *file,
                                  int line) {
  if (got < limit) return;
  print_error("%s: got %.17g, expected below %g\n", what, got, limit);
  _fail(file, line);
}

#define check_ok(call)                                                                             \
  do {                                                                                             \
    arc_error check_error = {ARC_OK, ""};                                                          \
    arc_error *const why = &check_error;                                                           \
    const arc_status check_status = (call);                                                        \
    if (check_status != ARC_OK) {                                                                  \
      print_error("%s: %s: %s\n", #call, arc_status_name(check_status), check_error.message);      \
      _fail(__FILE__, __LINE__);                                                                   \
    }                                                                                              \
  } while (0)

/* Checks that the call (with `why` as its error) fails with status `wanted` and a message that
 * contains `part`. */
#define check_refused(call, wanted, part)                                                          \
  do {                                                                                             \
    arc_error check_error = {ARC_OK, ""};                                                          \
    arc_error *const why = &check_error;                                                           \
    const arc_status check_status = (call);                                                        \
    if (check_status != (wanted) || check_error.status != (wanted) ||                              \
        !strstr(check_error.message, part)) {                                                      \
      print_error("%s: expected %s with '%s', got %s: %s\n", #call, arc_status_name(wanted), part, \
                  arc_status_name(check_status), check_error.message);                             \
      _fail(__FILE__, __LINE__);                                                                   \
    }                                                                                              \
  } while (0)

/* Replaces each of `count` numbers in turn by its wrong value, and checks that the call fails with
 * ARC_NUMERIC and that the message contains the part listed for this number. */
#define check_spoilt(call, count, numbers, wrong, parts)                                           \
  for (int spoilt = 0; spoilt < (count); spoilt++) {                                               \
    const double right = *(numbers)[spoilt];                                                       \
    *(numbers)[spoilt] = (wrong)[spoilt];                                                          \
    check_refused(call, ARC_NUMERIC, (parts)[spoilt]);                                             \
    *(numbers)[spoilt] = right;                                                                    \
  }

/* --- models ----------------------------------------------------------------------------------- */

/* Returns the definition of a coarse model that is built in milliseconds and is meant for loads
 * up to 100 N. */
UNUSED static arc_model_def coarse_definition(void) {
  arc_model_def def = arc_model_default();
  def.mesh.size = 0.04;
  def.mesh.height = 0.05;
  def.mesh.far = 2;
  return def;
}

UNUSED static arc_model *build_model(const arc_model_def *def) {
  arc_model *model = NULL;
  check_ok(arc_model_build(def, &model, why));
  return model;
}

UNUSED static arc_model *coarse_model(void) {
  const arc_model_def def = coarse_definition();
  return build_model(&def);
}

UNUSED static arc_model *default_model(void) {
  const arc_model_def def = arc_model_default();
  return build_model(&def);
}

#endif

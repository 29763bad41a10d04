/* Tests of wear laws: the properties in the table row of a law agree with the law's formula.
 * Step lengths depend on these properties, so a wrong property would give wrong results. */
#include "check.h"

typedef struct law {
  const char *name, *text;
  unsigned properties;
  double (*factor)(const arc_wear_def *d, double p), (*growth)(const arc_wear_def *d, double p);
} law;

#define FUNCTIONS(name, word, properties, text, factor, growth)                                    \
  static double factor_##name(const arc_wear_def *d, double p) {                                   \
    (void)d, (void)p;                                                                              \
    return factor;                                                                                 \
  }                                                                                                \
  static double growth_##name(const arc_wear_def *d, double p) {                                   \
    (void)d, (void)p;                                                                              \
    return growth;                                                                                 \
  }
ARC_LAW_LIST(FUNCTIONS)
#define ROW(name, word, properties, text, factor, growth)                                          \
  {word, text, properties, factor_##name, growth_##name},
static const law laws[] = {ARC_LAW_LIST(ROW)};
enum { count = sizeof laws / sizeof *laws };

static int is_parameter(const arc_setting *s) {
  return strncmp(s->name, "law_", 4) == 0;
}

/* Changes a number: multiplies it by `factor`, or sets a number that is 0 to 100 times the factor.
 */
static void vary(const arc_setting *s, arc_wear_def *d, double factor) {
  double *value = arc_setting_member(s, d);
  assert_int_equal(s->kind, ARC_NUMBER);
  *value = *value == 0 ? 100 * factor : *value * factor;
}

typedef int (*seen_fn)(const law *l, const arc_wear_def *d, double p);

/* Returns true if seen(law, definition, p) is true at some pressure p from 1e-3 to 1e4 MPa, a range
 * far wider than the pressures of contacts. */
static int at_any_pressure(const law *l, const arc_wear_def *d, seen_fn seen) {
  for (double p = 1e-3; p < 1e4; p *= 1.01)
    if (seen(l, d, p)) return 1;
  return 0;
}

/* Returns true if `seen` is true at any pressure, with the default parameters or with one
 * parameter varied by 2 or 2/3. */
static int at_any(const law *l, seen_fn seen) {
  const arc_wear_def usual = arc_wear_default();
  int found = at_any_pressure(l, &usual, seen);
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    for (int twice = 0; twice < 2 && is_parameter(s); twice++) {
      arc_wear_def d = usual;
      vary(s, &d, twice ? 2 : 2 / 3.0);
      assert_int_equal(arc_settings_check(arc_wear_settings, "", &d, NULL), ARC_OK);
      found |= at_any_pressure(l, &d, seen);
    }
  return found;
}

/* --- properties at a pressure ----- */

static int is_not_archards(const law *l, const arc_wear_def *d, double p) {
  return l->factor(d, p) != 1 || l->growth(d, p) != 1;
}

/* Returns true if the factor is discontinuous near p: its difference over an interval does not
 * decrease with the interval. */
static int jumps(const law *l, const arc_wear_def *d, double p) {
  double low = p, high = 1.01 * p;
  for (int i = 0; i < 40; i++) {
    const double middle = (low + high) / 2, f = l->factor(d, middle);
    if (fabs(f - l->factor(d, low)) > fabs(l->factor(d, high) - f))
      high = middle;
    else
      low = middle;
  }
  return fabs(l->factor(d, high) - l->factor(d, low)) > 1e-6 * l->factor(d, 2 * p);
}

/* Returns the logarithmic slope of p times the factor, over a small interval on one side. */
static double slope(const law *l, const arc_wear_def *d, double p, double side) {
  const double to = p * (1 + side);
  return log(to * l->factor(d, to) / (p * l->factor(d, p))) / log1p(side);
}

/* Returns true if the exponent stated by the law differs from the slope of the formula at a
 * pressure where the factor is smooth. */
static int grows_otherwise(const law *l, const arc_wear_def *d, double p) {
  const double left = slope(l, d, p, -1e-5), right = slope(l, d, p, 1e-5);
  if (!(l->factor(d, p) > 0) || !(fabs(left - right) < 1e-2)) return 0;
  return fabs((left + right) / 2 - l->growth(d, p)) > 1e-4;
}

static const arc_setting *changed;

static int depends_on_changed(const law *l, const arc_wear_def *d, double p) {
  arc_wear_def other = *d;
  vary(changed, &other, 1.5);
  return l->factor(d, p) != l->factor(&other, p) || l->growth(d, p) != l->growth(&other, p);
}

/* --- tests --- */

static void is_as_told(const law *l, const char *what, int seen, int told) {
  if (!seen == !told) return;
  fail_msg("law \"%s\": by its formulas %s is %s, by its table row %s", l->name, what,
           seen ? "true" : "false", told ? "true" : "false");
}

static void test_properties(void **state) {
  (void)state;
  for (const law *l = laws; l < laws + count; l++) {
    const unsigned has = l->properties;
    assert_int_equal(has, arc_law_properties[l - laws]);
    is_as_told(l, "ARC_LAW_LINEAR", !at_any(l, is_not_archards) && !(has & ARC_LAW_OF_SHEAR),
               has & ARC_LAW_LINEAR);
    is_as_told(l, "ARC_LAW_JUMPS", at_any(l, jumps), has & ARC_LAW_JUMPS);
  }
}

static void test_growth(void **state) {
  (void)state;
  for (const law *l = laws; l < laws + count; l++)
    is_as_told(l, "a growth other than d ln(p factor) / d ln p", at_any(l, grows_otherwise), 0);
}

/* Tests that the help text of each law lists the settings of this law, and that these settings are
 * named law_... */
static void test_parameters(void **state) {
  (void)state;
  int parameters = 0;
  for (changed = arc_wear_settings; changed->name; changed++) {
    parameters += is_parameter(changed);
    for (const law *l = laws; l < laws + count && changed->kind == ARC_NUMBER; l++)
      is_as_told(l, changed->name, at_any(l, depends_on_changed),
                 is_parameter(changed) && strstr(l->text, changed->name) != NULL);
  }
  assert_true(parameters >= 2);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_properties),
      cmocka_unit_test(test_growth),
      cmocka_unit_test(test_parameters),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Tests of contact solutions: Hertz theory, balance, symmetry, position of the plate, worn
 * shapes, stresses, and refused input. */
#include "check.h"

static arc_model *steel; /* the default model, built once */

static int set_up(void **state) {
  (void)state;
  const arc_model_def def = arc_model_default();
  return arc_model_build(&def, &steel, NULL) == ARC_OK ? 0 : -1;
}

static int tear_down(void **state) {
  (void)state;
  arc_model_release(&steel);
  return steel != NULL;
}

static arc_shape *unworn(arc_model *model) {
  arc_shape *shape = NULL;
  check_ok(arc_shape_create(model, ARC_MOVING, 0.005, &shape, why));
  return shape;
}

static arc_contact *solve(const arc_shape *shape, double load, double x) {
  arc_contact *contact = NULL;
  check_ok(arc_contact_solve(shape, &(arc_contact_def){.load = load, .x = x}, NULL, &contact, why));
  return contact;
}

static arc_hertz hertz_of(const arc_model *model, double load) {
  const arc_model_def *def = arc_model_definition(model);
  arc_hertz hertz = {0};
  check_ok(arc_hertz_solve(def->radius, def->thickness, load, def->material, &hertz, why));
  return hertz;
}

static double sum_of(const double *value, int count) {
  double sum = 0;
  for (int k = 0; k < count; k++) sum += value[k];
  return sum;
}

/* --- Hertz ------------------------------------------------------------------------------------ */

static void test_hertz_formula(void **state) {
  (void)state;
  const arc_hertz hertz = hertz_of(steel, 100);
  check_near(hertz.half_width, 0.107641, 5e-7);
  check_near(hertz.p_max, 591.431, 5e-4);
  check_near(hertz.E_star, 109890.1, 0.05);
}

static void test_hertz_refused(void **state) {
  (void)state;
  static const double bad[] = {0, -1, NAN, INFINITY};
  const arc_material material[ARC_BODIES] = {arc_material_default(), arc_material_default()};
  arc_hertz hertz;
  for (int k = 0; k < 4; k++) {
    check_refused(arc_hertz_solve(bad[k], 1, 100, material, &hertz, why), ARC_ARGUMENT, "radius");
    check_refused(arc_hertz_solve(10, bad[k], 100, material, &hertz, why), ARC_ARGUMENT,
                  "thickness");
    check_refused(arc_hertz_solve(10, 1, bad[k], material, &hertz, why), ARC_ARGUMENT, "load");
    const arc_material soft[ARC_BODIES] = {{.E = bad[k], .nu = 0.3}, material[1]};
    check_refused(arc_hertz_solve(10, 1, 100, soft, &hertz, why), ARC_ARGUMENT, "E'");
  }
  const arc_material fluid[ARC_BODIES] = {material[0], {.E = 200e3, .nu = 0.5}};
  check_refused(arc_hertz_solve(10, 1, 100, fluid, &hertz, why), ARC_ARGUMENT, "nu'");
}

/* Tests the pressure profile against Hertz theory for loads of 75 to 200 N, with five to eight
 * nodes in contact on each side. */
static void test_hertz_profile(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  for (double load = 75; load <= 200; load += 25) {
    const arc_hertz hertz = hertz_of(steel, load);
    arc_contact *contact = solve(shape, load, 0);
    const arc_contact_result r = arc_contact_get(contact);
    check_share(r.half_width, hertz.half_width, 0.03);
    for (int b = 0; b < ARC_BODIES; b++) {
      const arc_pressure p = arc_contact_pressure(contact, (arc_body)b);
      for (int i = 0; i < p.count; i++) {
        const double at = p.x[i] / hertz.half_width;
        const double exact = fabs(at) < 1 ? hertz.p_max * sqrt(1 - at * at) : 0;
        check_near(p.p[i], exact, (fabs(at) < 0.7 ? 0.02 : 0.15) * hertz.p_max);
      }
    }
    arc_contact_destroy(&contact);
  }
  arc_shape_destroy(&shape);
}

/* --- invariants ------------------------------------------------------------------------------- */

static void check_balance(const arc_contact *contact) {
  const arc_contact_result r = arc_contact_get(contact);
  const arc_contact_def *def = arc_contact_definition(contact);
  const double line = def->load / arc_model_definition(arc_contact_model(contact))->thickness;
  double moment[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_pressure p = arc_contact_pressure(contact, (arc_body)b);
    check_share(sum_of(p.f, p.count), line, 1e-10);
    for (int i = 0; i < p.count; i++) {
      assert_true(p.p[i] >= 0 && p.f[i] >= 0);
      moment[b] += p.f[i] * p.x[i];
    }
  }
  assert_true(r.p_max >= r.p_center && r.left < r.right && r.half_width > 0);
  check_near(r.half_width, (r.right - r.left) / 2, 1e-15);
}

static void test_balance(void **state) {
  (void)state;
  random_start(41);
  arc_shape *shape = unworn(steel);
  for (int trial = 0; trial < 60; trial++) {
    arc_contact *contact = solve(shape, random_in(1, 300), random_in(-0.3, 0.3));
    check_balance(contact);
    arc_contact_destroy(&contact);
  }
  arc_shape_destroy(&shape);
}

/* Tests the balance of loads with gaps of 300 mm: the load must be balanced although rounding
 * errors of 6e-14 mm in these gaps are equivalent to 4e-9 N at a node. */
static void test_balance_far_away(void **state) {
  (void)state;
  static const double x[] = {-1, 0, 1}, h[] = {303, 300, 304}, load[] = {100, 3, 0.02};
  double depth[4000];
  arc_shape *shape = NULL;
  check_ok(arc_shape_create(steel, ARC_FROZEN, 0, &shape, why));
  check_ok(
      arc_shape_sample(shape, ARC_PLATE, (arc_depths){.x = x, .h = h, .count = 3}, depth, why));
  depth[0] = 0; /* a depth common to all nodes would only change the approach */
  check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
  for (int k = 0; k < 3; k++) {
    arc_contact *contact = solve(shape, load[k], 0);
    check_ok(arc_contact_validate(contact, why));
    const arc_pressure p = arc_contact_pressure(contact, ARC_PLATE);
    check_share(sum_of(p.f, p.count), load[k], 1e-12);
    arc_contact_destroy(&contact);
  }
  arc_shape_destroy(&shape);
}

static void test_symmetry(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  arc_contact *contact = solve(shape, 100, 0);
  const arc_contact_result r = arc_contact_get(contact);
  check_near(r.left, -r.right, 1e-9 * r.right);
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_pressure p = arc_contact_pressure(contact, (arc_body)b);
    for (int i = 0; i < p.count; i++) check_near(p.p[i], p.p[p.count - 1 - i], 1e-9 * r.p_max);
  }
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
}

/* Tests that a plate moved to the right and a plate moved to the left have mirrored solutions. */
static void test_mirrored_positions(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  for (int k = 1; k <= 7; k++) {
    arc_contact *right = solve(shape, 100, 0.013 * k), *left = solve(shape, 100, -0.013 * k);
    const arc_contact_result r = arc_contact_get(right), l = arc_contact_get(left);
    check_share(r.p_center, l.p_center, 1e-9);
    check_near(r.left, -l.right, 1e-9 * r.right);
    check_share(r.approach, l.approach, 1e-9);
    for (int b = 0; b < ARC_BODIES; b++) {
      const arc_pressure p = arc_contact_pressure(right, (arc_body)b);
      const arc_pressure q = arc_contact_pressure(left, (arc_body)b);
      for (int i = 0; i < p.count; i++) check_near(p.p[i], q.p[p.count - 1 - i], 1e-9 * r.p_max);
    }
    arc_contact_destroy(&right);
    arc_contact_destroy(&left);
  }
  arc_shape_destroy(&shape);
}

/* Tests that the position of a flat plate changes the centre pressure by less than 1 %. The change
 * is caused by the positions of the plate's nodes. */
static void test_position(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  arc_contact *centre = solve(shape, 100, 0);
  const double expected = arc_contact_get(centre).p_center;
  for (double x = -0.3; x < 0.3; x += 0.0437) {
    arc_contact *moved = solve(shape, 100, x);
    check_share(arc_contact_get(moved).p_center, expected, 0.01);
    arc_contact_destroy(&moved);
  }
  arc_contact_destroy(&centre);
  arc_shape_destroy(&shape);
}

/* Tests two scaling laws: twice the thickness with twice the load gives the same contact, and
 * moduli and load multiplied by k give the same contact. */
static void test_scaling(void **state) {
  (void)state;
  arc_model_def def = coarse_definition();
  arc_model *one = build_model(&def);
  def.thickness = 2.5;
  arc_model *thick = build_model(&def);
  def.thickness = 1;
  def.material[0].E *= 3;
  def.material[1].E *= 3;
  arc_model *stiff = build_model(&def);
  arc_shape *shape[3] = {unworn(one), unworn(thick), unworn(stiff)};
  static const double load[3] = {100, 250, 300}, factor[3] = {1, 1, 3};
  double p_first = 0, width_first = 0;
  for (int k = 0; k < 3; k++) {
    arc_contact *contact = solve(shape[k], load[k], 0.02);
    const arc_contact_result r = arc_contact_get(contact);
    check_balance(contact);
    if (k == 0) p_first = r.p_max, width_first = r.half_width;
    check_share(r.p_max, factor[k] * p_first, 1e-9);
    check_share(r.half_width, width_first, 1e-9);
    arc_contact_destroy(&contact);
    arc_shape_destroy(&shape[k]);
  }
  arc_model_release(&one);
  arc_model_release(&thick);
  arc_model_release(&stiff);
}

/* --- worn shapes ------------------------------------------------------------------------------ */

/* Wears one body to a parabolic scar of depth h0 (1 - (x/w)^2) with h0 = `deepest` and w =
 * `half`. */
static void wear_scar(arc_shape *shape, arc_body body, double deepest, double half) {
  const arc_profile profile = arc_shape_profile(shape, body);
  double *depth = calloc((size_t)profile.count, sizeof *depth);
  for (int i = 0; i < profile.count; i++)
    depth[i] = fmax(0, deepest * (1 - pow(profile.x[i] / half, 2)));
  check_ok(arc_shape_wear(shape, body, depth, why));
  free(depth);
}

/* Tests worn shapes against Hertz theory: wear of either body that is equivalent to three times
 * the cylinder's radius gives the Hertz contact of that radius. */
static void test_other_radius(void **state) {
  (void)state;
  const double half = 0.45, deepest = half * half / 2 * (1 / 10.0 - 1 / 30.0);
  const arc_model_def *def = arc_model_definition(steel);
  arc_hertz hertz;
  check_ok(arc_hertz_solve(30, 1, 100, def->material, &hertz, why));
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_shape *shape = unworn(steel);
    wear_scar(shape, (arc_body)b, deepest, half);
    arc_contact *contact = solve(shape, 100, 0);
    check_share(arc_contact_get(contact).p_center, hertz.p_max, 0.02);
    check_share(arc_contact_get(contact).half_width, hertz.half_width, 0.02);
    check_balance(contact);
    arc_contact_destroy(&contact);
    arc_shape_destroy(&shape);
  }
}

/* Tests that a contact solution does not change when its shape is worn afterwards. */
static void test_keeps_its_shape(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  arc_contact *contact = solve(shape, 100, 0);
  const double before = arc_contact_get(contact).p_center;
  arc_field *first = NULL, *second = NULL;
  check_ok(arc_contact_field(contact, ARC_CYLINDER, &first, why));
  wear_scar(shape, ARC_CYLINDER, 2e-3, 0.3);
  arc_shape_destroy(&shape);
  check_ok(arc_contact_field(contact, ARC_CYLINDER, &second, why));
  assert_true(arc_contact_get(contact).p_center == before);
  assert_memory_equal(first->mises, second->mises, (size_t)first->nodes * sizeof(double));
  arc_field_destroy(&first);
  arc_field_destroy(&second);
  arc_contact_destroy(&contact);
}

/* Tests the wear depth along the normal, the sum of depth vectors from several calls, and the
 * positions of the worn nodes. */
static void test_profile(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  for (int b = 0; b < ARC_BODIES; b++) {
    wear_scar(shape, (arc_body)b, 1e-3, 0.3);
    wear_scar(shape, (arc_body)b, 1e-3, 0.3);
    check_near(arc_shape_depth(shape, (arc_body)b), 2e-3, 1e-15);
    check_share(arc_shape_vector_depth(shape, (arc_body)b), 2e-3, 1e-4);
    const arc_profile profile = arc_shape_profile(shape, (arc_body)b);
    const arc_mesh *mesh = arc_model_mesh(steel, (arc_body)b);
    for (int i = 0; i < profile.count; i++) {
      const double *node = &mesh->xy[2 * mesh->surface_node[i]];
      const double moved = (b == ARC_CYLINDER ? 1 : -1) * (profile.y[i] - node[1]);
      assert_true(profile.x[i] == node[0]);
      check_near(moved, profile.h[i], 2e-3 * 2e-3);
    }
  }
  arc_shape_destroy(&shape);
}

static void test_even_wear(void **state) {
  (void)state;
  arc_error error = {0};
  arc_shape *shape = unworn(steel);
  arc_contact *contact = solve(shape, 100, 0);
  const arc_contact_result before = arc_contact_get(contact);
  arc_contact_destroy(&contact);
  assert_int_equal(arc_shape_wear_evenly(shape, ARC_PLATE, 0.5, &error), ARC_OK);
  contact = solve(shape, 100, 0);
  assert_true(arc_contact_get(contact).p_center == before.p_center);
  assert_true(arc_shape_depth(shape, ARC_PLATE) == 0.5);
  assert_true(arc_shape_vector_depth(shape, ARC_PLATE) == 0.5);
  assert_true(arc_shape_profile(shape, ARC_PLATE).y[0] == -0.5);
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
}

/* Tests that wear deeper than the wear box is refused and leaves the shape unchanged. */
static void test_box_used_up(void **state) {
  (void)state;
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_shape *shape = unworn(steel);
    const arc_profile profile = arc_shape_profile(shape, (arc_body)b);
    const size_t bytes = (size_t)profile.count * sizeof(double);
    double *depth = calloc((size_t)profile.count, sizeof *depth), *y = malloc(bytes);
    memcpy(y, profile.y, bytes);
    depth[profile.count / 2] = 0.07;
    check_refused(arc_shape_wear(shape, (arc_body)b, depth, why), ARC_GEOMETRY,
                  arc_body_name((arc_body)b));
    assert_memory_equal(arc_shape_profile(shape, (arc_body)b).y, y, bytes);
    assert_true(arc_shape_depth(shape, (arc_body)b) == 0);
    free(depth);
    free(y);
    arc_shape_destroy(&shape);
  }
}

/* --- stresses --------------------------------------------------------------------------------- */

/* Tests the stresses on the axis of both bodies against Hertz theory, to 2 % of the maximum
 * pressure from the second element row on. */
static void test_axis_stresses(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  arc_contact *contact = solve(shape, 100, 0);
  const arc_hertz hertz = hertz_of(steel, 100);
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_field *field = NULL;
    check_ok(arc_contact_field(contact, (arc_body)b, &field, why));
    double shear = 0;
    for (int n = 0; n < field->nodes; n++) {
      const double z = fabs(field->y[n]) / hertz.half_width, root = sqrt(1 + z * z);
      shear = fmax(shear, field->shear[n]);
      if (field->x[n] != 0 || z < 0.4 || z > 3) continue;
      const double across = -hertz.p_max * ((1 + 2 * z * z) / root - 2 * z);
      const double down = -hertz.p_max / root;
      check_near(field->sxx[n], across, 0.02 * hertz.p_max);
      check_near(field->syy[n], down, 0.02 * hertz.p_max);
      check_near(field->szz[n], 0.3 * (field->sxx[n] + field->syy[n]), 1e-9 * hertz.p_max);
      check_near(field->sxy[n], 0, 1e-6 * hertz.p_max);
    }
    check_share(shear, 0.3003 * hertz.p_max, 0.02);
    arc_field_destroy(&field);
  }
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
}

/* --- refusals --------------------------------------------------------------------------------- */

static void test_refused(void **state) {
  (void)state;
  arc_shape *shape = unworn(steel);
  static const double bad[] = {0, -1, NAN, INFINITY};
  for (int k = 0; k < 4; k++) {
    arc_contact *contact = (arc_contact *)shape;
    check_refused(
        arc_contact_solve(shape, &(arc_contact_def){.load = bad[k], .x = 0}, NULL, &contact, why),
        ARC_ARGUMENT, "load");
    assert_null(contact);
  }
  arc_contact *contact;
  check_refused(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = NAN}, NULL, &contact, why),
      ARC_ARGUMENT, "x'");
  check_refused(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = INFINITY}, NULL, &contact, why),
      ARC_ARGUMENT, "x'");
  check_refused(
      arc_contact_solve(shape, &(arc_contact_def){.load = 5000, .x = 0}, NULL, &contact, why),
      ARC_ZONE, "mesh.zone.cylinder");
  check_refused(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.6}, NULL, &contact, why),
      ARC_ZONE, "mesh.zone.plate");
  check_refused(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = -0.6}, NULL, &contact, why),
      ARC_ZONE, "mesh.zone.plate");
  check_refused(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 5}, NULL, &contact, why),
      ARC_ZONE, "mesh.zone.plate");
  assert_null(contact);
  arc_shape_destroy(&shape);
  check_refused(arc_shape_create(steel, ARC_MOVING, -1, &shape, why), ARC_ARGUMENT, "refresh");
  assert_null(shape);
}

static void test_models_refused(void **state) {
  (void)state;
  static const double bad[] = {0, -1, NAN, INFINITY};
  for (int k = 0; k < 4; k++) {
    arc_model *model;
    arc_model_def def = arc_model_default();
    def.thickness = bad[k];
    check_refused(arc_model_build(&def, &model, why), ARC_ARGUMENT, "thickness");
    def = arc_model_default();
    def.material[ARC_PLATE].E = bad[k];
    check_refused(arc_model_build(&def, &model, why), ARC_ARGUMENT, "plate.E");
    def = arc_model_default();
    def.radius = bad[k];
    check_refused(arc_model_build(&def, &model, why), ARC_ARGUMENT, "radius");
    assert_null(model);
  }
  arc_model *model;
  arc_model_def def = arc_model_default();
  def.material[ARC_CYLINDER].nu = 0.5;
  check_refused(arc_model_build(&def, &model, why), ARC_ARGUMENT, "cylinder.nu");
  def.material[ARC_CYLINDER].nu = -1;
  check_refused(arc_model_build(&def, &model, why), ARC_ARGUMENT, "cylinder.nu");
}

/* Tests that a shape keeps a reference to its model, and a contact to the model of its shape. */
static void test_ownership(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  arc_shape *shape = unworn(model);
  arc_contact *contact = solve(shape, 100, 0);
  arc_model_release(&model);
  assert_null(model);
  arc_shape_destroy(&shape);
  assert_null(shape);
  arc_field *field = NULL;
  check_ok(arc_contact_field(contact, ARC_PLATE, &field, why));
  arc_field_destroy(&field);
  arc_contact_destroy(&contact);
  assert_null(contact);
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
  arc_field_destroy(&field);
  arc_model_release(&model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_hertz_formula),
      cmocka_unit_test(test_hertz_refused),
      cmocka_unit_test(test_hertz_profile),
      cmocka_unit_test(test_balance),
      cmocka_unit_test(test_balance_far_away),
      cmocka_unit_test(test_symmetry),
      cmocka_unit_test(test_mirrored_positions),
      cmocka_unit_test(test_position),
      cmocka_unit_test(test_scaling),
      cmocka_unit_test(test_other_radius),
      cmocka_unit_test(test_keeps_its_shape),
      cmocka_unit_test(test_profile),
      cmocka_unit_test(test_even_wear),
      cmocka_unit_test(test_box_used_up),
      cmocka_unit_test(test_axis_stresses),
      cmocka_unit_test(test_refused),
      cmocka_unit_test(test_models_refused),
      cmocka_unit_test(test_ownership),
  };
  return cmocka_run_group_tests_name("contact", tests, set_up, tear_down);
}

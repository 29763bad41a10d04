/* Tests of memory exhaustion: the n-th allocation fails, for every n until the call succeeds
 * before its n-th allocation. Each call must return ARC_MEMORY or succeed without the memory,
 * leave existing data unchanged, and free its own memory. The linker replaces malloc and related
 * functions by wrappers; CHOLMOD uses the same wrappers. */
#include "runs.h"

#if __has_include(<suitesparse/SuiteSparse_config.h>)
#include <suitesparse/SuiteSparse_config.h>
#else
#include <SuiteSparse_config.h>
#endif
#include <unistd.h>

#include "archard/export.h"
#include "archard/space.h"

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void __real_free(void *block);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void __wrap_free(void *block);

static long until_failure = -1; /* number of allocations that will still succeed; negative: all
                                 * allocations succeed */
static long live;               /* number of allocated blocks not yet freed */

static int fails_now(void) {
  return until_failure >= 0 && until_failure-- == 0;
}

static void *counted(void *block) {
  live += block != NULL;
  return block;
}

void *__wrap_malloc(size_t size) {
  return fails_now() ? NULL : counted(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size) {
  return fails_now() ? NULL : counted(__real_calloc(count, size));
}

void *__wrap_realloc(void *old, size_t size) {
  if (fails_now()) return NULL;
  void *block = __real_realloc(old, size);
  live += block && !old;
  return block;
}

void __wrap_free(void *block) {
  live -= block != NULL;
  __real_free(block);
}

static void wrap_cholmod(void) {
  SuiteSparse_config.malloc_func = __wrap_malloc;
  SuiteSparse_config.calloc_func = __wrap_calloc;
  SuiteSparse_config.realloc_func = __wrap_realloc;
  SuiteSparse_config.free_func = __wrap_free;
}

/* Objects that the tested calls use. */
static arc_model *model;
static arc_shape *shape;
static arc_contact *contact, *rough;
static arc_wear *wear;
static arc_wear_def definition;

static int set_up_all(void **state) {
  if (set_up(state) != 0) return -1;
  model = arc_model_retain(coarse);
  definition = quick(0.11, 0.5);
  definition.increments = 4;
  definition.refresh = 0;
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
  double *depth = calloc(200, sizeof *depth);
  depth[12] = depth[13] = 1e-3;
  check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
  free(depth);
  check_ok(arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0}, NULL, &contact, why));
  check_ok(arc_contact_solve(shape, &(arc_contact_def){.load = 100, .friction = 0.5}, NULL, &rough,
                             why));
  check_ok(arc_wear_create(model, &definition, NULL, &wear, why));
  check_ok(arc_wear_step(wear, NULL, why));
  return 0;
}

static int tear_down_all(void **state) {
  arc_contact_destroy(&contact);
  arc_contact_destroy(&rough);
  arc_shape_destroy(&shape);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
  tear_down(state);
  return live != 0;
}

/* A call that creates an object, and the call that frees this object. */
typedef struct maker {
  const char *name;
  arc_status (*make)(void **made, arc_error *error);
  void (*unmake)(void **made);
} maker;

static arc_status make_mesh(void **made, arc_error *error) {
  const arc_mesh_def def = coarse_definition().mesh;
  return arc_mesh_build(&def, ARC_CYLINDER, 10, (arc_mesh **)made, error);
}
static void unmake_mesh(void **made) {
  arc_mesh_destroy((arc_mesh **)made);
}

static arc_status make_model(void **made, arc_error *error) {
  arc_model_def def = coarse_definition();
  def.mesh.size = 0.2;
  def.mesh.height = 0.25;
  def.mesh.far = 5;
  return arc_model_build(&def, (arc_model **)made, error);
}
static void unmake_model(void **made) {
  arc_model_release((arc_model **)made);
}

static arc_status make_shape(void **made, arc_error *error) {
  return arc_shape_create(model, ARC_MOVING, 0, (arc_shape **)made, error);
}
static arc_status make_copy(void **made, arc_error *error) {
  return arc_shape_clone(shape, (arc_shape **)made, error);
}
static arc_status make_restored(void **made, arc_error *error) {
  arc_array state[ARC_SHAPE_STATE];
  arc_shape_state(shape, state);
  return arc_shape_restore(model, ARC_MOVING, 0, state, ARC_SHAPE_STATE, (arc_shape **)made, error);
}
static void unmake_shape(void **made) {
  arc_shape_destroy((arc_shape **)made);
}

static arc_status make_contact(void **made, arc_error *error) {
  return arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.05}, NULL,
                           (arc_contact **)made, error);
}
static arc_status make_motion(void **made, arc_error *error) {
  arc_motion_def motion = arc_contact_motion(rough);
  motion.x = 1e-3;
  return arc_contact_move(rough, &motion, NULL, (arc_contact **)made, error);
}
static arc_status make_wear_contact(void **made, arc_error *error) {
  return arc_wear_contact(wear, (arc_contact **)made, error);
}
static void unmake_contact(void **made) {
  arc_contact_destroy((arc_contact **)made);
}

static arc_status make_field(void **made, arc_error *error) {
  return arc_contact_field(contact, ARC_PLATE, (arc_field **)made, error);
}
static void unmake_field(void **made) {
  arc_field_destroy((arc_field **)made);
}

static arc_status make_wear(void **made, arc_error *error) {
  return arc_wear_create(model, &definition, shape, (arc_wear **)made, error);
}
static arc_status make_wear_copy(void **made, arc_error *error) {
  return arc_wear_clone(wear, (arc_wear **)made, error);
}
static void unmake_wear(void **made) {
  arc_wear_destroy((arc_wear **)made);
}

static arc_status make_halfspace(void **made, arc_error *error) {
  arc_halfspace_def def = arc_halfspace_default();
  def.nx = def.nz = 21;
  def.track = 23;
  def.body[ARC_LOWER].layer[0] = (arc_layer){.thickness = 0.1, .material = def.body[0].material};
  return arc_halfspace_create(&def, (arc_halfspace **)made, error);
}
static void unmake_halfspace(void **made) {
  arc_halfspace_destroy((arc_halfspace **)made);
}
/* Calls all functions of a half-space. */
static arc_status use_halfspace(arc_halfspace *h, arc_error *error) {
  enum { cells = 21 * 21, sites = 23 * 21 };
  static double depth[2][sites], rate[2][sites], pressure[3 * cells], stress[6 * cells];
  const arc_halfspace_position position[3] = {{-0.015, 5, 1}, {0, 5, 1}, {0.02, 5, 1}};
  const arc_halfspace_wear rubs = {.c = {1e-7, 1e-7}};
  double *const to[2] = {depth[0], depth[1]}, *const rates[2] = {rate[0], rate[1]}, value;
  arc_status status =
      arc_halfspace_stage(h, NULL, &rubs, position, 3, NULL, pressure, to, NULL, error);
  const double *const from[2] = {depth[0], depth[1]};
  if (status == ARC_OK)
    status = arc_halfspace_rate(h, from, position, 3, NULL, pressure, rates, NULL, error);
  if (status == ARC_OK)
    status = arc_halfspace_eigenvalue(h, &rubs, position, 3, pressure, NULL, &value, error);
  if (status == ARC_OK)
    status = arc_halfspace_solve(h, from, position, NULL, pressure, &value, NULL, error);
  if (status == ARC_OK) status = arc_halfspace_stress(h, pressure, 0.3, -0.1, stress, error);
  return status;
}
static arc_status make_halfspace_wear(void **made, arc_error *error) {
  arc_status status = make_halfspace(made, error);
  if (status == ARC_OK) status = use_halfspace(*made, error);
  if (status != ARC_OK) unmake_halfspace(made);
  return status;
}

static const maker makers[] = {
    {"arc_mesh_build", make_mesh, unmake_mesh},
    {"arc_model_build", make_model, unmake_model},
    {"arc_shape_create", make_shape, unmake_shape},
    {"arc_shape_clone", make_copy, unmake_shape},
    {"arc_shape_restore", make_restored, unmake_shape},
    {"arc_contact_solve", make_contact, unmake_contact},
    {"arc_contact_move", make_motion, unmake_contact},
    {"arc_wear_contact", make_wear_contact, unmake_contact},
    {"arc_contact_field", make_field, unmake_field},
    {"arc_wear_create", make_wear, unmake_wear},
    {"arc_wear_clone", make_wear_copy, unmake_wear},
    {"arc_halfspace_create", make_halfspace, unmake_halfspace},
    {"arc_halfspace_stage and others", make_halfspace_wear, unmake_halfspace},
};

/* Checks that a failed call leaves no memory allocated. The workspace of the shared model is
 * allocated by the first call and may be freed by a failed call. */
static void try_maker(const maker *m) {
  void *made = NULL;
  check_ok(m->make(&made, why));
  m->unmake(&made);
  const long before = live;
  long n = 0;
  for (int met = 1; met; n++) {
    arc_error error = {ARC_OK, ""};
    made = &made;
    until_failure = n;
    const arc_status status = m->make(&made, &error);
    met = until_failure < 0;
    until_failure = -1;
    if (status != ARC_OK) {
      const int as_told = met && status == ARC_MEMORY && error.status == ARC_MEMORY && !made &&
                          strstr(error.message, "out of memory");
      if (!as_told)
        print_error("%s, allocation %ld: %s %s\n", m->name, n, arc_status_name(status),
                    error.message);
      assert_true(as_told);
    }
    m->unmake(&made);
    if (live > before) print_error("%s, allocation %ld: %ld left\n", m->name, n, live - before);
    assert_true(live <= before);
  }
  assert_int_equal(live, before);
  print_message("# %s: %ld allocations\n", m->name, n - 1);
}

static void test_makers(void **state) {
  (void)state;
  for (size_t k = 0; k < sizeof makers / sizeof *makers; k++) try_maker(&makers[k]);
}

/* Tests that a failed call of arc_shape_wear leaves the shape unchanged. */
static void test_shape_wear(void **state) {
  (void)state;
  double *depth = calloc(200, sizeof *depth);
  depth[14] = 1e-3;
  arc_shape *copy = NULL;
  check_ok(arc_shape_clone(shape, &copy, why));
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_status status = ARC_MEMORY;
    for (long n = 0; status != ARC_OK; n++) {
      until_failure = n;
      status = arc_shape_wear(copy, (arc_body)b, depth, NULL);
      until_failure = -1;
      if (status == ARC_OK) break;
      assert_int_equal(status, ARC_MEMORY);
      check_same_shape(copy, shape);
    }
    arc_shape_destroy(&copy);
    check_ok(arc_shape_clone(shape, &copy, why));
  }
  arc_shape_destroy(&copy);
  free(depth);
}

typedef arc_status (*wear_call)(arc_wear *run);

static arc_status step(arc_wear *run) {
  return arc_wear_step(run, NULL, NULL);
}
static arc_status stability(arc_wear *run) {
  double eigenvalue;
  return arc_wear_stability(run, NULL, &eigenvalue, NULL);
}

/* Checks that a failed step leaves the run unchanged and that the run then continues with
 * identical results. */
static void check_run_survives(const arc_wear_def *def, wear_call call) {
  arc_wear *whole = start(def), *run_ = start(def), *before = NULL;
  for (int steps = 0; steps < 2; steps++) {
    check_ok(arc_wear_step(whole, NULL, why));
    check_ok(arc_wear_clone(run_, &before, why));
    arc_status status = ARC_MEMORY;
    for (long n = 0; status != ARC_OK; n++) {
      until_failure = n;
      status = call(run_);
      until_failure = -1;
      assert_true(status == ARC_OK || status == ARC_MEMORY);
      if (status != ARC_OK) check_same(run_, before);
    }
    if (call != step) check_ok(arc_wear_step(run_, NULL, why));
    check_same(run_, whole);
    arc_wear_destroy(&before);
  }
  arc_wear_destroy(&whole);
  arc_wear_destroy(&run_);
}

static void test_steps(void **state) {
  (void)state;
  static const double strokes[] = {0.11, 20}, alphas[] = {0, 0.5, 1};
  for (int s = 0; s < 2; s++)
    for (int a = 0; a < 3; a++) {
      arc_wear_def def = quick(strokes[s], alphas[a]);
      def.increments = 4;
      def.refresh = 0;
      check_run_survives(&def, step);
      check_run_survives(&def, stability);
    }
}

/* Tests that a failed implicit step does not change the run. */
static void test_implicit_steps(void **state) {
  (void)state;
  arc_wear_def def = quick(0.11, 0.5);
  def.increments = 4;
  def.scheme = ARC_IMPLICIT;
  check_run_survives(&def, step);
}

static arc_status write_deck(const char *path) {
  return arc_export_inp(path, contact, NULL);
}

static arc_status write_grid(const char *path) {
  return arc_export_vtu(path, arc_model_mesh(model, ARC_PLATE), contact, 0, NULL);
}

/* Tests a file writer with exhausted memory: a failed call creates no file. The writer may free
 * the memory of a matrix factor and allocate it again. */
static void check_writer(arc_status (*writer)(const char *path)) {
  char path[64];
  snprintf(path, sizeof path, "/tmp/archard-oom-%ld", (long)getpid());
  assert_int_equal(writer(path), ARC_OK);
  const long before = live;
  arc_status status = ARC_MEMORY;
  for (long n = 0; status != ARC_OK; n++) {
    remove(path);
    until_failure = n;
    status = writer(path);
    until_failure = -1;
    assert_true(status == ARC_OK || (status == ARC_MEMORY && access(path, F_OK) != 0));
    assert_true(live <= before);
  }
  assert_int_equal(remove(path), 0);
}

static void test_export(void **state) {
  (void)state;
  check_writer(write_deck);
  check_writer(write_grid);
}

int main(void) {
  wrap_cholmod();
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_makers), cmocka_unit_test(test_shape_wear),
      cmocka_unit_test(test_steps),  cmocka_unit_test(test_implicit_steps),
      cmocka_unit_test(test_export),
  };
  return cmocka_run_group_tests_name("oom", tests, set_up_all, tear_down_all);
}

/* Tests of run files with runs on imported meshes: the file contains the mesh, runs continue
 * with identical bits, several cases share one mesh text, and meshes in untrusted files are
 * checked like any mesh file. */
#include "mesh_text.h"
#include "store_sql.h"

#include "archard/export.h"
#include "store/store.h"

/* --- a run on an imported mesh ---------------------------------------------------------------- */

/* Returns the text of a Gmsh file with coarse meshes of both bodies. The cylinder has a thin
 * coating. */
static char *coated_text(void) {
  arc_error error = {0};
  arc_model_def def = arc_model_default();
  arc_model *own;
  char *text;
  def.mesh.size = def.mesh.height = 0.05;
  def.body[ARC_UPPER].layer[0] = (arc_layer){.thickness = 5e-4, .material = {.E = 4e5, .nu = 0.3}};
  must(arc_model_build(&def, &own, &error), &error);
  const arc_mesh *mesh[ARC_BODIES] = {arc_model_mesh(own, ARC_UPPER),
                                      arc_model_mesh(own, ARC_LOWER)};
  must(arc_export_msh_text(&text, mesh, &error), &error);
  arc_model_release(&own);
  return text;
}

static arc_model *given_model(const char *text) {
  arc_error error = {0};
  arc_mesh *mesh[ARC_BODIES];
  arc_model *model;
  arc_model_def def = arc_model_default();
  arc_body_def *upper = &def.body[ARC_UPPER];
  upper->kind = ARC_SOLID_GMSH;
  snprintf(upper->name, sizeof upper->name, "roller");
  snprintf(upper->layer[0].name, sizeof upper->layer[0].name, "layer1");
  upper->layer[0].material = (arc_material){.E = 4e5, .nu = 0.3, .k = 5e-9};
  def.material[ARC_UPPER].k = 2e-8;
  def.material[ARC_LOWER].k = 1e-8;
  must(arc_mesh_parse_msh("text", text, strlen(text), mesh, &error), &error);
  must(arc_model_build_given(&def, mesh, NULL, &model, &error), &error);
  return model;
}

static arc_wear *given_run(arc_model *model, double distance) {
  arc_error error = {0};
  arc_wear *wear;
  arc_wear_def def = arc_wear_default();
  def.geometry = ARC_FROZEN;
  def.distance = 330;
  def.increments = 20;
  def.jump = 100;
  assert_true(arc_wear_def_of_bodies(&def, arc_model_definition(model)));
  must(arc_wear_create(model, &def, NULL, &wear, &error), &error);
  must(arc_wear_run(wear, distance, NULL, &error), &error);
  return wear;
}

static int make_good(void **state) {
  if (make_folder(state) != 0) return -1;
  char *text = coated_text();
  arc_model *model = given_model(text);
  arc_wear *wear = given_run(model, 66);
  save_as("good", 1, wear);
  free(text);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
  return 0;
}

/* --- identical bits --------------------------------------------------------------------------- */

static void test_goes_on(void **state) {
  (void)state;
  arc_error error = {0};
  char *text = coated_text();
  arc_model *model = given_model(text), *again;
  arc_wear *whole = given_run(model, 330), *stored = restored("good", 1, &again);
  assert_true(arc_model_is_given(again));
  assert_string_equal(arc_model_definition(again)->body[ARC_UPPER].layer[0].name, "layer1");
  must(arc_wear_run(stored, 330, NULL, &error), &error);
  assert_true(arc_wear_last(stored)->depth_cylinder > 5e-4); /* the wear is deeper than the
                                                              * coating */
  assert_same_runs(stored, whole);
  free(text);
  arc_wear_destroy(&whole);
  arc_wear_destroy(&stored);
  arc_model_release(&model);
  arc_model_release(&again);
}

/* --- one text for all cases ------------------------------------------------------------------- */

static int number_of(const char *name, const char *sql) {
  sqlite3 *db;
  sqlite3_stmt *s;
  assert_int_equal(sqlite3_open(in_folder(name), &db), SQLITE_OK);
  assert_int_equal(sqlite3_prepare_v2(db, sql, -1, &s, NULL), SQLITE_OK);
  assert_int_equal(sqlite3_step(s), SQLITE_ROW);
  const int number = sqlite3_column_int(s, 0);
  sqlite3_finalize(s);
  sqlite3_close(db);
  return number;
}

static void make_study(const char *name, int cases) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_CREATE);
  for (int id = 1; id <= cases; id++) must(arc_store_add(store, id, "case", &error), &error);
  arc_store_close(&store);
}

static void finish(const char *name, int id, const arc_wear *wear) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_WRITE);
  save_run(store, id, wear);
  must(arc_store_mark(store, id, ARC_CASE_DONE, NULL, 1, &error), &error);
  arc_store_close(&store);
}

/* Tests that cases share the text of their mesh and that merging a shard also copies the text. */
static void test_shared(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model;
  arc_wear *wear = restored("good", 1, &model);
  make_study("whole", 2);
  make_study("share", 2);
  for (int id = 1; id <= 2; id++) finish("share", id, wear);
  assert_int_equal(number_of("share", "SELECT count(*) FROM texts"), 1);
  arc_store *store = opened("whole", ARC_STORE_WRITE);
  must(arc_store_merge(store, in_folder("share"), &error), &error);
  must(arc_store_check(store, &error), &error);
  arc_store_close(&store);
  for (int id = 1; id <= 2; id++) {
    arc_model *merged;
    arc_wear *there = restored("whole", id, &merged);
    assert_same_runs(there, wear);
    arc_wear_destroy(&there);
    arc_model_release(&merged);
  }
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

static int keep_text(void *context, const arc_value *value) {
  if (value->kind == ARC_VALUE_TEXT) snprintf(context, 2000, "%s", value->text);
  return 0;
}

/* Tests that any text is read back unchanged, even a text that looks like the name of another
 * text. */
static void test_texts(void **state) {
  (void)state;
  arc_error error = {0};
  static char words[1500], back[2000];
  memset(words, 'x', sizeof words - 1);
  const char *const texts[] = {"short", "text:0123456789abcdef", "text:", words};
  make_study("texts", 1);
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    const arc_value value = {.kind = ARC_VALUE_TEXT, .name = "a", .text = texts[i]};
    arc_store *store = opened("texts", ARC_STORE_WRITE);
    must(arc_store_set_values(store, 1, ARC_SETTINGS, &value, 1, &error), &error);
    must(arc_store_values(store, 1, ARC_SETTINGS, keep_text, back, &error), &error);
    assert_string_equal(back, texts[i]);
    arc_store_close(&store);
  }
  assert_int_equal(number_of("texts", "SELECT count(*) FROM texts"), 3);
}

/* --- untrusted files -------------------------------------------------------------------------- */

static void set_mesh(const char *name, const char *value) {
  sqlite3 *db;
  sqlite3_stmt *s;
  assert_int_equal(sqlite3_open(in_folder(name), &db), SQLITE_OK);
  assert_int_equal(sqlite3_prepare_v2(db,
                                      "UPDATE definition SET value = ?1 WHERE name = 'model.msh'",
                                      -1, &s, NULL),
                   SQLITE_OK);
  sqlite3_bind_text(s, 1, value, -1, SQLITE_STATIC);
  assert_int_equal(sqlite3_step(s), SQLITE_DONE);
  sqlite3_finalize(s);
  sqlite3_close(db);
}

/* Copies the good file and replaces its mesh by another mesh text. */
static void change_mesh(const char *name, const char *text) {
  arc_error error = {0};
  char of_text[ARC_TEXT_NAME];
  copy_good(name);
  arc_store *store = opened(name, ARC_STORE_WRITE);
  must(arc_store_put_text(store, text, of_text, &error), &error);
  arc_store_close(&store);
  set_mesh(name, of_text[0] ? of_text : text);
  seal(name);
}

/* Tests every kind of broken mesh in a run file. */
static void test_broken_meshes(void **state) {
  (void)state;
  static const struct {
    const char *file, *words;
  } broken[] = {
      {"flipped", "is flipped"},
      {"crack", "coincide at"},
      {"gap", "are apart by 0.25 mm"},
      {"overlap", "overlap by 0.25 mm"},
      {"no-upper", "no physical group 'upper'"},
      {"node-twice", "two nodes have the number"},
      {"unknown-node", "which does not exist"},
      {"element-twice", "overlap at node"},
      {"two-pieces", "is in pieces"},
      {"contact-fixed", "is both in"},
      {"fixed-no-edge", "is not an edge of an element"},
      {"binary", "the file is binary"},
      {"huge-nodes", "expected a number of nodes"},
      {"truncated", "the file ends"},
      {"nan", "three finite coordinates"},
      {"good-41", "field 'upper.materials'"}, /* a valid mesh of another run */
      {"good-materials", "field 'upper.materials'"},
  };
  for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
    size_t count;
    char *text = mesh_text(broken[i].file, &count);
    change_mesh("broken", text);
    assert_damaged("broken", broken[i].words);
    free(text);
  }
}

/* Tests a valid mesh whose number of surface nodes differs from the number in the stored state. */
static void test_other_surface(void **state) {
  (void)state;
  size_t count;
  char *text = mesh_text("good-materials", &count);
  char *one = strstr(text, "upper.steel"), *two = strstr(text, "upper.bronze");
  memcpy(one, "upper\"     ", strlen("upper.steel"));
  memcpy(two, "upper.layer1", strlen("upper.bronze"));
  change_mesh("other", text);
  assert_damaged("other", "numbers 'h'");
  free(text);
}

static void test_texts_of_strangers(void **state) {
  (void)state;
  arc_error error = {0};
  static const char *const wrong[] = {
      "DELETE FROM texts", "UPDATE texts SET text = replace(text, '0', '1')",
      "UPDATE texts SET text = NULL", "UPDATE texts SET text = x'00'",
      "UPDATE texts SET name = 'text:0000000000000000'"};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    copy_good("text");
    run_sql("text", "PRAGMA foreign_keys = OFF; CREATE TABLE t (name, text); INSERT INTO t SELECT "
                    "* FROM texts; DROP TABLE texts; ALTER TABLE t RENAME TO texts");
    run_sql("text", wrong[i]);
    assert_damaged("text", "text");
    if (i == 0) continue; /* without the mesh text this case is unreadable, but the file is valid */
    arc_store *store = opened("text", ARC_STORE_READ);
    assert_int_equal(arc_store_check(store, &error), ARC_FORMAT);
    arc_store_close(&store);
  }
}

static void test_values_of_strangers(void **state) {
  (void)state;
  static const struct {
    const char *value, *words;
  } wrong[] = {{"'text:'", "text"},       {"1.5", "model.msh"},
               {"1", "model.msh"},        {"NULL", "model.msh"},
               {"x'00'", "model.msh"},    {"zeroblob(16)", "model.msh"},
               {"''", "no section"},      {"'$MeshFormat'", "has no mesh"},
               {"'steel'", "has no mesh"}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    char sql[200];
    copy_good("value");
    snprintf(sql, sizeof sql, "UPDATE definition SET value = %s WHERE name = 'model.msh'",
             wrong[i].value);
    run_sql("value", sql);
    seal("value");
    assert_damaged("value", wrong[i].words);
  }
}

/* Tests definitions with fields that are not allowed for an imported mesh, and a definition
 * without its mesh: reading the run is refused. */
static void test_definitions_of_strangers(void **state) {
  (void)state;
#define SET(name, value) "UPDATE definition SET value = " value " WHERE name = '" name "'"
  static const struct {
    const char *sql, *words;
  } wrong[] = {
      {"DELETE FROM definition WHERE name = 'model.msh'", "field 'upper'"},
      {SET("model.upper.layer1.name", "'other'"), "field 'upper.materials'"},
      {SET("model.upper.layer1.name", "'a name that is much too long to be one'"), "layer1.name"},
      {"DELETE FROM definition WHERE name = 'model.upper.layer1.name'", "field 'upper.materials'"},
      {SET("model.upper.layer1.thickness", "0.1") "; " SET("model.upper.layer1.name", "''"),
       "field 'upper.layers'"},
      {SET("model.upper.layer1.material.E", "-1.0"), "upper.layer1.material.E"},
      {SET("model.lower.kind", "'ring'"), "inner"},
      {SET("model.geometry", "'axisymmetric'") "; " SET("model.thickness", "2.0"), "thickness"},
      {SET("geometry", "'moving'"), "geometry"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    copy_good("definition");
    run_sql("definition", wrong[i].sql);
    seal("definition");
    assert_damaged("definition", wrong[i].words);
  }
}

int main(void) {
  arc_single_threaded();
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_goes_on),
      cmocka_unit_test(test_shared),
      cmocka_unit_test(test_texts),
      cmocka_unit_test(test_broken_meshes),
      cmocka_unit_test(test_other_surface),
      cmocka_unit_test(test_texts_of_strangers),
      cmocka_unit_test(test_values_of_strangers),
      cmocka_unit_test(test_definitions_of_strangers),
  };
  return cmocka_run_group_tests_name("store_mesh", tests, make_good, remove_folder);
}

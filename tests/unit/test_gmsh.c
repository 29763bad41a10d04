/* Tests of meshes from Gmsh files: valid files of both format versions, identical bits after
 * writing and reading, error messages for broken files, and no memory leaks. */
#include "check.h"
#include "mesh_text.h"

#include "archard/export.h"

#include <unistd.h>

static const char folder[] = "tests/files/msh";

static const char *path_of(const char *name) {
  static char path[100];
  snprintf(path, sizeof path, "%s/%s.msh", folder, name);
  return path;
}

static void forget(arc_mesh *mesh[ARC_BODIES]) {
  for (int b = 0; b < ARC_BODIES; b++) arc_mesh_destroy(&mesh[b]);
}

/* --- valid files ------------------------------------------------------------------------------ */

/* Tests that the files of both format versions give the same pair of meshes: the parabola x^2 /
 * 20 on four edges above a flat. */
static void test_both_versions(void **state) {
  (void)state;
  static const char *const names[] = {"good-41", "good-22"};
  for (int v = 0; v < 2; v++) {
    arc_mesh *mesh[ARC_BODIES];
    check_ok(arc_mesh_read_msh(path_of(names[v]), mesh, why));
    for (int b = 0; b < ARC_BODIES; b++) {
      const arc_mesh *m = mesh[b];
      assert_int_equal(m->body, b);
      assert_int_equal(m->nodes, 10);
      assert_int_equal(m->elements, 4);
      assert_int_equal(m->quads, 4);
      assert_int_equal(m->rows, 0);
      assert_int_equal(m->box_elements, 0);
      assert_int_equal(m->surface, 5);
      assert_int_equal(m->fixed, 5);
      assert_int_equal(m->outline, 10);
      check_near(m->def.zone[b], 4, 0);
      check_near(m->def.size, 1, 0);
      for (int i = 0; i < 5; i++) check_near(m->xy[2 * m->surface_node[i]], i - 2, 0);
    }
    /* the polygon through five points of a parabola of radius 10 is slightly flatter */
    check_share(mesh[ARC_CYLINDER]->radius, 10, 0.01);
    forget(mesh);
  }
}

static void test_materials(void **state) {
  (void)state;
  arc_mesh *mesh[ARC_BODIES];
  check_ok(arc_mesh_read_msh(path_of("good-materials"), mesh, why));
  const arc_mesh *m = mesh[ARC_CYLINDER];
  assert_int_equal(m->materials, 2);
  assert_int_equal(mesh[ARC_PLATE]->materials, 0);
  assert_null(mesh[ARC_PLATE]->material);
  for (int e = 0; e < m->elements; e++) {
    const double x = m->xy[2 * m->element[4 * e]];
    assert_string_equal(m->material_name[m->material[e]], x < 0 ? "steel" : "bronze");
  }
  const arc_model_def def = arc_model_default();
  arc_model *model;
  check_refused(
      arc_model_build_given(&def, mesh, NULL, &model, why), ARC_ARGUMENT,
      "field 'upper.materials': expected a material for each name in the mesh, 'steel', 'bronze', "
      "got none for 'steel'");
  assert_null(mesh[ARC_CYLINDER]); /* the caller no longer owns the mesh, even if the call fails */
}

/* --- writing and reading ---------------------------------------------------------------------- */

static void check_same(const arc_mesh *got, const arc_mesh *expected) {
  assert_int_equal(got->nodes, expected->nodes);
  assert_int_equal(got->elements, expected->elements);
  assert_int_equal(got->quads, expected->quads);
  assert_int_equal(got->surface, expected->surface);
  assert_int_equal(got->fixed, expected->fixed);
  assert_int_equal(got->outline, expected->outline);
  for (int k = 0; k < 2 * got->nodes; k++) /* compared by value: a zero may change its sign */
    assert_true(got->xy[k] == expected->xy[k]);
  assert_memory_equal(got->surface_node, expected->surface_node,
                      (size_t)got->surface * sizeof(int));
  assert_memory_equal(got->fixed_node, expected->fixed_node, (size_t)got->fixed * sizeof(int));
  assert_memory_equal(got->element, expected->element, 4 * (size_t)got->elements * sizeof(int));
}

static const char *temporary(void) {
  static char path[60];
  snprintf(path, sizeof path, "/tmp/archard-msh-%ld.msh", (long)getpid());
  return path;
}

static void write_model(const arc_model *model) {
  const arc_mesh *both[ARC_BODIES] = {arc_model_mesh(model, ARC_CYLINDER),
                                      arc_model_mesh(model, ARC_PLATE)};
  check_ok(arc_export_msh(temporary(), both, why));
}

static void test_round_trip(void **state) {
  (void)state;
  arc_model *model = default_model();
  arc_mesh *mesh[ARC_BODIES];
  write_model(model);
  check_ok(arc_mesh_read_msh(temporary(), mesh, why));
  for (int b = 0; b < ARC_BODIES; b++) check_same(mesh[b], arc_model_mesh(model, (arc_body)b));
  check_share(mesh[ARC_PLATE]->radius, 10, 1e-3);
  forget(mesh);
  remove(temporary());
  arc_model_release(&model);
}

static void test_one_body(void **state) {
  (void)state;
  arc_model *model = coarse_model();
  arc_mesh *mesh[ARC_BODIES];
  const arc_mesh *plate[ARC_BODIES] = {NULL, arc_model_mesh(model, ARC_PLATE)};
  check_ok(arc_export_msh(temporary(), plate, why));
  check_refused(arc_mesh_read_msh(temporary(), mesh, why), ARC_GEOMETRY,
                "no physical group 'upper' of surfaces; found: 'lower.contact' (curves)");
  remove(temporary());
  arc_model_release(&model);
}

/* --- meshes as texts -------------------------------------------------------------------------- */

static char *text_of(arc_mesh *const mesh[ARC_BODIES]) {
  const arc_mesh *both[ARC_BODIES] = {mesh[0], mesh[1]};
  char *text;
  check_ok(arc_export_msh_text(&text, both, why));
  return text;
}

static void check_same_materials(const arc_mesh *got, const arc_mesh *expected) {
  assert_int_equal(got->materials, expected->materials);
  for (int e = 0; e < got->elements && got->materials > 0; e++) {
    const int a = got->material[e], b = expected->material[e];
    assert_int_equal(a < 0, b < 0);
    if (a >= 0) assert_string_equal(got->material_name[a], expected->material_name[b]);
  }
}

/* Tests that the text written for a mesh gives the same mesh and again the same text. */
static void test_text(void **state) {
  (void)state;
  static const char *const names[] = {"tests/files/msh/good-41.msh", "tests/files/msh/good-22.msh",
                                      "tests/files/msh/good-materials.msh",
                                      "tests/files/msh/good-inlay.msh", "examples/gmsh_pair.msh"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    arc_mesh *first[ARC_BODIES], *second[ARC_BODIES];
    check_ok(arc_mesh_read_msh(names[i], first, why));
    char *text = text_of(first);
    check_ok(arc_mesh_parse_msh("text", text, strlen(text), second, why));
    for (int b = 0; b < ARC_BODIES; b++) {
      check_same(second[b], first[b]);
      check_same_materials(second[b], first[b]);
      assert_true(second[b]->radius == first[b]->radius);
    }
    char *again = text_of(second);
    assert_string_equal(again, text);
    free(again);
    free(text);
    forget(first);
    forget(second);
  }
}

static void test_bad_text(void **state) {
  (void)state;
  arc_mesh *mesh[ARC_BODIES];
  check_refused(arc_mesh_parse_msh("the text", "$MeshFormat\n4.1 0 8", 19, mesh, why), ARC_FORMAT,
                "the text, line 2: the file ends before $EndMeshFormat");
  assert_null(mesh[ARC_PLATE]);
}

/* --- models from mesh files ------------------------------------------------------------------- */

static arc_model *read_model(const arc_model_def *def, const char *path) {
  arc_mesh *mesh[ARC_BODIES];
  arc_model *model = NULL;
  check_ok(arc_mesh_read_msh(path, mesh, why));
  check_ok(arc_model_build_given(def, mesh, NULL, &model, why));
  assert_null(mesh[ARC_CYLINDER]);
  assert_null(mesh[ARC_PLATE]);
  return model;
}

static arc_wear *frozen_run(arc_model *model) {
  arc_wear_def def = arc_wear_default();
  def.geometry = ARC_FROZEN;
  def.stroke = 0.2;
  def.distance = 200;
  arc_wear *wear = NULL;
  check_ok(arc_wear_create(model, &def, NULL, &wear, why));
  check_ok(arc_wear_run(wear, def.distance, NULL, why));
  return wear;
}

/* Tests that the pair of the reference paper, read from a file, gives the same run with frozen
 * geometry as the built-in mesh. */
static void test_same_run(void **state) {
  (void)state;
  arc_model *own = default_model();
  write_model(own);
  arc_model *read = read_model(arc_model_definition(own), temporary());
  assert_true(arc_model_is_given(read));
  assert_false(arc_model_is_given(own));
  arc_wear *a = frozen_run(own), *b = frozen_run(read);
  const arc_wear_record *p = arc_wear_last(a), *q = arc_wear_last(b);
  assert_true(p->depth_cylinder > 0);
#define SAME(column, unit, range, rule, text)                                                      \
  if (!isnan(p->column)) check_near(q->column, p->column, 1e-9 * fabs(p->column) + 1e-15);
  ARC_WEAR_COLUMNS(SAME)
  arc_wear_destroy(&a);
  arc_wear_destroy(&b);
  remove(temporary());
  arc_model_release(&own);
  arc_model_release(&read);
}

static void test_moving_refused(void **state) {
  (void)state;
  const arc_model_def def = arc_model_default();
  arc_model *model = read_model(&def, path_of("good-41"));
  arc_shape *shape;
  check_refused(arc_shape_create(model, ARC_MOVING, 0, &shape, why), ARC_ARGUMENT,
                "field 'geometry': expected \"frozen\" on an imported mesh, got \"moving\"");
  check_ok(arc_shape_create(model, ARC_FROZEN, 0, &shape, why));
  arc_shape_destroy(&shape);
  arc_model_release(&model);
}

/* --- broken files ----------------------------------------------------------------------------- */

static const struct broken {
  const char *name, *part; /* `part` must occur in the error message */
} broken[] = {
    {"no-upper", "no physical group 'upper' of surfaces; found: 'upper.contact' (curves)"},
    {"no-lower-contact", "no physical group 'lower.contact' of curves; found:"},
    {"no-upper-fixed", "no physical group 'upper.fixed'"},
    {"fixed-no-edge", "line 5 of 'upper.fixed' at (-2, 2) mm is not an edge of an element"},
    {"fixed-surface", "expected curves in the group 'upper.fixed', got surfaces"},
    {"flipped", "element 18 of 'upper' at (-0.5, 1.0125) mm is flipped"},
    {"folded", "element 18 of 'upper' at (-0.5, 1.0125) mm is folded or not convex"},
    {"flat", "is degenerate at a corner"},
    {"same-corner", "has the same corner twice"},
    {"crack", "of 'upper' coincide at (0, "},
    {"material-name", "expected a material after 'upper.', a word of letters, digits and _ that"},
    {"materials-twice", "surface 3 has two materials, 'bronze' and 'steel'"},
    {"materials-many", "expected at most 4 materials of 'upper', got more"},
    {"gap", "the bodies are apart by 0.25 mm at x = 0 mm"},
    {"overlap", "the bodies overlap by 0.25 mm at x = 0 mm"},
    {"apart-along-x", "do not face each other: 'upper' from x = 48 to 52 mm"},
    {"shared-node", "node 3 at (0, 0) mm belongs to both bodies"},
    {"contact-in-pieces", "'upper.contact' is in pieces: expected one curve, got one that begins "
                          "at (-2, 0.2) mm and another at (0, 0) mm"},
    {"contact-inside", "line 2 of 'upper.contact' at (-1, 0.05) mm is not an edge on the boundary"},
    {"contact-upright", "overhangs: a contact surface has one y for each x"},
    {"contact-behind", "the surface of 'upper' faces down"},
    {"contact-fixed", "node 5 at (2, 0.2) mm is both in 'upper.contact' and in 'upper.fixed'"},
    {"contact-short", "expected from 5 to 5000 nodes on 'upper.contact', got 3"},
    {"unknown-node", "element 7 refers to node 99, which does not exist"},
    {"element-twice", "elements 21 and 25 of 'lower' overlap at node"},
    {"two-pieces", "'upper' is in pieces: node 31 at (5, 0) mm is not connected"},
    {"not-plane", "expected all nodes in the plane z = 0, got node 8 at (0, 2, 0.5) mm"},
    {"second-order", "element 18 of 'upper' is of second or higher order (type 16 of Gmsh)"},
    {"second-order-22", "mesh with -order 1"},
    {"binary", "line 2: the file is binary; save it as text"},
    {"version-40", "expected version 4.1 or 2.2, got '4 0 8'"},
    {"huge-nodes", "expected a number of nodes from 0 to 4000000, got '9000000000000000000"},
    {"many-nodes", "line 45: expected the number of a node, got '0.2 0'"},
    {"many-elements", "the blocks contain 2999976 fewer elements than their count"},
    {"truncated", "the file ends after"},
    {"truncated-elements", "expected the nodes of an element, got 'nothing'"},
    {"no-elements", "the file has no section $Elements"},
    {"not-a-number", "three finite coordinates of a node, got 'zero'"},
    {"nan", "three finite coordinates of a node, got "},
    {"node-twice", "two nodes have the number 19"},
    {"garbage", "expected a section such as $Nodes"},
    {"empty", "the file has no section $MeshFormat"},
    {"no-format", "expected $MeshFormat at the beginning"},
    {"nodes-twice", "a second section $Nodes"},
    {"unclosed", "expected $EndNodes, got '$Elements'"},
    {"bad-name", "expected dimension, number and name of a group"},
    {"wrong-dimension", "elements of type 3 do not have dimension 1"},
};

static void test_broken(void **state) {
  (void)state;
  for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
    arc_mesh *mesh[ARC_BODIES];
    arc_error error = {ARC_OK, ""};
    size_t length = 0;
    char *text = mesh_text(broken[i].name, &length);
    const arc_status status = arc_mesh_parse_msh(broken[i].name, text, length, mesh, &error);
    free(text);
    if ((status != ARC_FORMAT && status != ARC_GEOMETRY) || !strstr(error.message, broken[i].part))
      fail_msg("%s: expected '%s', got %s: %s", broken[i].name, broken[i].part,
               arc_status_name(status), error.message);
    assert_null(mesh[ARC_CYLINDER]);
    assert_null(mesh[ARC_PLATE]);
  }
}

static void test_no_file(void **state) {
  (void)state;
  arc_mesh *mesh[ARC_BODIES];
  check_refused(arc_mesh_read_msh("/nowhere/pair.msh", mesh, why), ARC_IO,
                "cannot read /nowhere/pair.msh");
  check_refused(arc_mesh_read_msh("/tmp", mesh, why), ARC_IO, "cannot read /tmp");
}

/* --- random changes --------------------------------------------------------------------------- */

static size_t read_text(const char *path, char *text, size_t room) {
  FILE *file = fopen(path, "rb");
  assert_non_null(file);
  const size_t length = fread(text, 1, room, file);
  fclose(file);
  return length;
}

/* Changes some characters of a valid file or truncates the file. Returns the new length. */
static size_t spoil(char *text, size_t length) {
  static const char others[] = "0123456789 -.$\"\nE\0";
  for (int k = random_int(1, 2); k > 0; k--)
    text[random_int(0, (int)length - 1)] = others[random_int(0, (int)sizeof others - 2)];
  return random_int(0, 9) ? length : (size_t)random_int(0, (int)length);
}

/* Tests that every randomly changed file is read or refused with a message. Sanitizers detect
 * errors in memory access. */
static void test_random(void **state) {
  (void)state;
  char good[2][4096], text[4096];
  const size_t length[] = {read_text(path_of("good-41"), good[0], sizeof good[0]),
                           read_text(path_of("good-22"), good[1], sizeof good[1])};
  int refused = 0, accepted = 0;
  random_start(20);
  for (int trial = 0; trial < 3000; trial++) {
    const int v = trial % 2;
    memcpy(text, good[v], length[v]);
    const size_t count = spoil(text, length[v]);
    FILE *file = fopen(temporary(), "wb");
    assert_non_null(file);
    fwrite(text, 1, count, file);
    fclose(file);
    arc_mesh *mesh[ARC_BODIES];
    arc_error error = {ARC_OK, ""};
    if (arc_mesh_read_msh(temporary(), mesh, &error) == ARC_OK) {
      accepted++;
      assert_true(arc_mesh_quality(mesh[ARC_CYLINDER], NULL).smallest_jacobian > 0);
      forget(mesh);
    } else {
      refused++;
      assert_true(strlen(error.message) > 10);
      assert_null(mesh[ARC_PLATE]);
    }
  }
  remove(temporary());
  printf("# %d refused, %d accepted\n", refused, accepted);
  assert_true(refused > 1000 && accepted > 50);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_both_versions), cmocka_unit_test(test_materials),
      cmocka_unit_test(test_round_trip),    cmocka_unit_test(test_one_body),
      cmocka_unit_test(test_text),          cmocka_unit_test(test_bad_text),
      cmocka_unit_test(test_same_run),      cmocka_unit_test(test_moving_refused),
      cmocka_unit_test(test_broken),        cmocka_unit_test(test_no_file),
      cmocka_unit_test(test_random),
  };
  return cmocka_run_group_tests_name("gmsh", tests, NULL, NULL);
}

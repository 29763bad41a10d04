/* Writes input decks: one mesh with its sets for a preprocessor, or the complete contact problem
 * for CalculiX. Node and element numbers start at 1; the numbers of the plate follow the numbers
 * of the cylinder. The complete problem is a slab of one layer of solid elements, fixed along z
 * on both faces, which is equivalent to plane strain. CalculiX also expands plane elements to
 * such slabs, but it has no plane elements with incompatible modes. */
#include "core/elastic/model.h"
#include "core/export/output.h"
#include "core/mesh/body_shape.h"

#include <stdlib.h>
#include <string.h>

typedef struct numbering {
  int node, element; /* numbers of the first node and element of a body */
  int layer; /* difference between the node numbers of the slab's two faces; 0: plane elements */
} numbering;

/* --- numbers ---------------------------------------------------------------------------------- */

/* Largest length of a number in characters. CalculiX reads 20 characters and ignores the rest, even
 * an exponent. A number with 13 digits, a sign, a point and any exponent is not longer. */
enum { DECK_WIDTH = 20 };

static arc_number_text number(double value) {
  arc_number_text result = arc_number_to_text(value);
  for (int digits = 16; strlen(result.text) > DECK_WIDTH; digits--)
    snprintf(result.text, sizeof result.text, "%.*g", digits, value);
  return result;
}

/* --- one body --------------------------------------------------------------------------------- */

static void write_nodes(FILE *out, int count, const double *xy, double shift, double z, int first) {
  for (int n = 0; n < count; n++)
    fprintf(out, "%d, %s, %s, %s\n", n + first, number(xy[2 * n] + shift).text,
            number(xy[2 * n + 1]).text, number(z).text);
}

static const char *element_type(const arc_mesh *m, int corners, int solid) {
  if (!solid) return arc_mesh_element(m, corners);
  if (corners == 3) return "C3D6";
  return m->def.element == ARC_CPE4I ? "C3D8I" : "C3D8";
}

/* Returns true if a node is in the deck. In decks of bodies of revolution x is the radius, so only
 * nodes on the right side of the axis are included. */
static int is_written(const arc_mesh *m, int node) {
  return m->space != ARC_AXISYMMETRIC || m->axis + m->xy[2 * node] >= 0;
}

static int element_is_written(const arc_mesh *m, const int *corner) {
  for (int k = 0; k < 4 && corner[k] >= 0; k++)
    if (!is_written(m, corner[k])) return 0;
  return 1;
}

/* Returns the first column of the wear box that is in the deck. */
static int first_column(const arc_mesh *m) {
  int column = 0;
  while (!is_written(m, m->surface_node[column])) column++;
  return column;
}

static void write_elements(FILE *out, const arc_mesh *m, numbering at, const char *name) {
  for (int corners = 4; corners >= 3; corners--) {
    fprintf(out, "*ELEMENT, TYPE=%s, ELSET=%s\n", element_type(m, corners, at.layer), name);
    for (int e = 0; e < m->elements; e++) {
      const int *c = &m->element[4 * e];
      if (arc_mesh_corners(m, e) != corners || !element_is_written(m, c)) continue;
      fprintf(out, "%d", e + at.element);
      for (int k = 0; k < corners; k++) fprintf(out, ", %d", c[k] + at.node);
      for (int k = 0; k < corners && at.layer; k++) fprintf(out, ", %d", c[k] + at.node + at.layer);
      fputc('\n', out);
    }
  }
}

static void write_set(FILE *out, const arc_mesh *m, const char *name, const int *list, int count,
                      numbering at) {
  fprintf(out, "*NSET, NSET=%s-%s\n", arc_body_name(m->body), name);
  for (int layer = 0; layer <= at.layer; layer += at.layer ? at.layer : 1) {
    int written = 0;
    for (int k = 0; k < count; k++) {
      if (!is_written(m, list[k])) continue;
      if (written > 0) fputs(written % 12 == 0 ? "\n" : ", ", out);
      fprintf(out, "%d", list[k] + at.node + layer);
      written++;
    }
    fputc('\n', out);
  }
}

/* Writes the contact surface, which consists of the top faces of the wear box. Faces are
 * identified by their two surface nodes. The first two faces of a solid element are on the faces
 * of the slab. */
static void write_surface(FILE *out, const arc_mesh *m, numbering at, const char *name) {
  fprintf(out, "*SURFACE, NAME=%s-contact, TYPE=ELEMENT\n", name);
  for (int column = first_column(m); column + 1 < m->surface; column++) {
    const int e = column * m->rows, a = m->surface_node[column], b = m->surface_node[column + 1];
    const int *c = &m->element[4 * e];
    for (int k = 0; k < 4; k++) {
      const int p = c[k], q = c[(k + 1) % 4];
      if ((p == a && q == b) || (p == b && q == a))
        fprintf(out, "%d, S%d\n", e + at.element, k + (at.layer ? 3 : 1));
    }
  }
}

/* Writes the elements and sets of a body. */
static void write_body(FILE *out, const arc_mesh *m, numbering at) {
  const char *name = arc_body_name(m->body);
  write_elements(out, m, at, name);
  write_set(out, m, "surface", m->surface_node, m->surface, at);
  write_set(out, m, "fixed", m->fixed_node, m->fixed, at);
  fprintf(out, "*ELSET, ELSET=%s-wear-box, GENERATE\n%d, %d, 1\n", name,
          at.element + first_column(m) * m->rows, at.element + m->box_elements - 1);
  write_surface(out, m, at, name);
}

/* Returns an error for a mesh without a wear box, because the contact surface of the deck
 * consists of faces of the box. */
static arc_status check_box(const arc_mesh *mesh, arc_error *error) {
  if (mesh->rows > 0) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "expected a mesh generated by archard, got an imported mesh, which "
                  "has no wear box for the contact surface of the deck");
}

arc_status arc_export_mesh_inp(const char *path, const arc_mesh *mesh, arc_error *error) {
  output_file file;
  arc_status status = check_box(mesh, error);
  if (status == ARC_OK) status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  const char *name = arc_body_name(mesh->body);
  fprintf(file.stream, "*HEADING\narchard: %s, units mm\n*NODE, NSET=%s\n", name, name);
  write_nodes(file.stream, mesh->nodes, mesh->xy, mesh->axis, 0, 1);
  write_body(file.stream, mesh, (numbering){1, 1, 0});
  return arc_output_close(&file, error);
}

/* --- the complete problem --------------------------------------------------------------------- */

typedef struct deck {
  FILE *out;
  const arc_contact *contact;
  arc_model *model;
  const arc_model_def *def;
  double *xy; /* coordinates of nodes [mm]; the array has space for the larger body */
  int nodes;  /* number of nodes on one face of the slab */
} deck;

static const arc_mesh *mesh_of(const deck *d, int body) {
  return arc_model_mesh(d->model, (arc_body)body);
}

/* Returns the number of the node that represents the plate's rigid base. It follows the numbers
 * of all other nodes. */
static int base_node(const deck *d) {
  return 2 * d->nodes + 1;
}

static void write_heading(const deck *d) {
  const arc_contact_def *def = arc_contact_definition(d->contact);
  fprintf(d->out, "*HEADING\narchard: %s on %s, units mm, N, MPa\n",
          arc_model_body_name(d->def, ARC_UPPER), arc_model_body_name(d->def, ARC_LOWER));
  fprintf(d->out, "** load %s N, plate at x = %s mm; a slab fixed along z: plane strain\n",
          number(def->load).text, number(def->x).text);
}

static void write_material(FILE *out, const char *name, arc_material material) {
  fprintf(out, "*MATERIAL, NAME=%s\n*ELASTIC\n%s, %s\n", name, number(material.E).text,
          number(material.nu).text);
  fprintf(out, "*SOLID SECTION, ELSET=%s, MATERIAL=%s\n", name, name);
}

/* Writes one element set with its material for each layer, and one for the body's material below
 * all layers. */
static void write_layers(const deck *d, const arc_mesh *m, numbering at) {
  const arc_body_def *solid = &d->def->body[m->body];
  const int layers = arc_body_layers(solid);
  for (int l = 0; l <= layers; l++) {
    char name[40];
    snprintf(name, sizeof name, l < layers ? "%s-layer-%d" : "%s-base", arc_body_name(m->body),
             l + 1);
    fprintf(d->out, "*ELSET, ELSET=%s\n", name);
    for (int e = 0; e < m->elements; e++)
      if (m->layer[e] == l) fprintf(d->out, "%d\n", e + at.element);
    write_material(d->out, name, arc_body_layer_material(solid, l, d->def->material[m->body]));
  }
}

/* Computes the coordinates of all worn nodes, with the body at its position in the contact. */
static void place_nodes(const deck *d, const arc_mesh *m) {
  const placing to = arc_chart_placing(&arc_model_body(d->model, m->body)->chart, m->body,
                                       arc_contact_definition(d->contact)->x, 0);
  arc_shape_nodes(arc_contact_shape(d->contact), m->body, d->xy);
  arc_placing_points(&to, m->nodes, d->xy);
}

static void write_solid(const deck *d, int body, numbering at) {
  const arc_mesh *m = mesh_of(d, body);
  const char *name = arc_body_name(m->body);
  place_nodes(d, m);
  fprintf(d->out, "*NODE, NSET=%s\n", name);
  write_nodes(d->out, m->nodes, d->xy, 0, 0, at.node);
  write_nodes(d->out, m->nodes, d->xy, 0, d->def->thickness, at.node + at.layer);
  write_body(d->out, m, at);
  if (arc_body_layers(&d->def->body[body]) > 0)
    write_layers(d, m, at);
  else
    write_material(d->out, name, d->def->material[body]);
}

/* Writes the rigid base of the plate, which can move along y. */
static void write_base(const deck *d) {
  const arc_mesh *m = mesh_of(d, ARC_PLATE);
  const int first = mesh_of(d, ARC_CYLINDER)->nodes + 1;
  fprintf(d->out, "*NODE, NSET=base\n%d, 0, %s, 0\n", base_node(d), number(-d->def->radius).text);
  for (int k = 0; k < 2 * m->fixed; k++)
    fprintf(d->out, "*EQUATION\n2\n%d, 2, 1, %d, 2, -1\n",
            m->fixed_node[k / 2] + first + k % 2 * d->nodes, base_node(d));
}

/* Returns the penalty stiffness [N/mm3]. With this stiffness the overlap of the bodies is, for any
 * element size, a small part of the gap at the edge of the contact. */
static double penalty(const deck *d) {
  return 20 * arc_contact_modulus(d->def->geometry, d->def->material) / d->def->mesh.size;
}

static void write_contact(const deck *d) {
  fprintf(d->out, "*SURFACE INTERACTION, NAME=frictionless\n");
  fprintf(d->out, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n%s\n", number(penalty(d)).text);
  fprintf(d->out, "*CONTACT PAIR, INTERACTION=frictionless, TYPE=SURFACE TO SURFACE\n"
                  "plate-contact, cylinder-contact\n");
}

/* Fixes the support of a body along x: the whole set of fixed nodes or, for a "free" support,
 * only the nodes in its middle. */
static void hold_sideways(const deck *d, const arc_mesh *m, int first) {
  if (m->solid.hold != ARC_HOLD_FREE) {
    fprintf(d->out, "%s-fixed, 1, 1\n", arc_body_name(m->body));
    return;
  }
  for (int k = 0; k < m->fixed; k++)
    for (int face = 0; face < 2; face++)
      if (arc_body_holds_sideways(&m->solid, m->xy[2 * m->fixed_node[k]]))
        fprintf(d->out, "%d, 1, 1\n", m->fixed_node[k] + first + face * d->nodes);
}

static void write_supports(const deck *d) {
  const arc_mesh *upper = mesh_of(d, ARC_CYLINDER), *lower = mesh_of(d, ARC_PLATE);
  fprintf(d->out, "cylinder, 3, 3\nplate, 3, 3\ncylinder-fixed, 2, 2\n");
  hold_sideways(d, upper, 1);
  hold_sideways(d, lower, upper->nodes + 1);
}

/* Writes the load steps. The bodies do not touch at first and could not support a load. The first
 * step therefore prescribes the approach of the contact under this load. */
static void write_steps(const deck *d) {
  fprintf(d->out, "*STEP, INC=200\n*STATIC\n1, 1\n*BOUNDARY\n");
  write_supports(d);
  fprintf(d->out, "base, 2, 2, %s\n*END STEP\n", number(arc_contact_get(d->contact).approach).text);
  fprintf(d->out, "*STEP, INC=200\n*STATIC\n1, 1\n*BOUNDARY, OP=NEW\n");
  write_supports(d);
  fprintf(d->out, "*CLOAD\nbase, 2, %s\n", number(arc_contact_definition(d->contact)->load).text);
  fprintf(d->out, "*NODE FILE\nU\n*EL FILE\nS\n*CONTACT FILE\nCDIS, CSTR\n"
                  "*NODE PRINT, NSET=base\nU\n"
                  "*NODE PRINT, NSET=cylinder-fixed, TOTALS=ONLY\nRF\n*END STEP\n");
}

static void write_deck(const deck *d) {
  numbering at = {1, 1, d->nodes};
  write_heading(d);
  for (int body = 0; body < ARC_BODIES; body++) {
    write_solid(d, body, at);
    at.node += mesh_of(d, body)->nodes;
    at.element += mesh_of(d, body)->elements;
  }
  write_base(d);
  write_contact(d);
  write_steps(d);
}

static arc_status check_space(const arc_model_def *def, arc_error *error) {
  if (def->geometry == ARC_PLANE_STRAIN) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'geometry': expected \"plane strain\" for a deck of both bodies, which is a "
      "slab fixed along z, got \"%s\"; m.mesh.plate:write(path) writes a single mesh",
      arc_space_names[def->geometry]);
}

arc_status arc_export_inp(const char *path, const arc_contact *contact, arc_error *error) {
  deck d = {.contact = contact, .model = arc_contact_model(contact)};
  d.def = arc_model_definition(d.model);
  arc_status status = check_space(d.def, error);
  const double angle = arc_contact_definition(contact)->load_angle;
  if (status == ARC_OK && angle != 0)
    status = arc_fail(error, ARC_ARGUMENT,
                      "field 'load_angle': expected 0 for an input deck, whose base moves along y, "
                      "got %g degrees",
                      angle);
  for (int body = 0; status == ARC_OK && body < ARC_BODIES; body++) {
    status = check_box(mesh_of(&d, body), error);
    d.nodes += mesh_of(&d, body)->nodes;
  }
  if (status != ARC_OK) return status;
  d.xy = malloc(2 * (size_t)d.nodes * sizeof *d.xy);
  if (!d.xy) return arc_fail(error, ARC_MEMORY, "out of memory for writing %s", path);
  output_file file;
  status = arc_output_open(&file, path, error);
  if (status == ARC_OK) {
    d.out = file.stream;
    write_deck(&d);
    status = arc_output_close(&file, error);
  }
  free(d.xy);
  return status;
}

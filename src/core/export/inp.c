/* Abaqus and CalculiX input deck: both bodies as one mesh with sets, surfaces and materials. The
 * plate's nodes and elements follow the cylinder's; numbers start at 1. */
#include "core/export/file.h"

typedef struct numbering {
  int node, element; /* added to 0-based numbers */
} numbering;

static void write_mesh(FILE *out, const arc_mesh *m, numbering at, const char *name) {
  fprintf(out, "*NODE, NSET=%s\n", name);
  for (int n = 0; n < m->nodes; n++)
    fprintf(out, "%d, %s, %s, 0\n", n + at.node, arc_number_to_text(m->xy[2 * n]).text,
            arc_number_to_text(m->xy[2 * n + 1]).text);
  for (int corners = 4; corners >= 3; corners--) {
    const char *type = corners == 3 ? "CPE3" : m->def.element == ARC_CPE4I ? "CPE4I" : "CPE4";
    fprintf(out, "*ELEMENT, TYPE=%s, ELSET=%s\n", type, name);
    for (int e = 0; e < m->elements; e++) {
      const int *c = &m->element[4 * e];
      if ((c[3] < 0 ? 3 : 4) != corners) continue;
      fprintf(out, "%d", e + at.element);
      for (int k = 0; k < corners; k++) fprintf(out, ", %d", c[k] + at.node);
      fputc('\n', out);
    }
  }
}

static void write_set(FILE *out, const char *kind, const char *body, const char *name,
                      const int *list, int count, int offset) {
  fprintf(out, "*%s=%s-%s\n", kind, body, name);
  for (int k = 0; k < count; k++)
    fprintf(out, "%d%s", list[k] + offset, k % 12 == 11 || k + 1 == count ? "\n" : ", ");
}

/* The face of each top element of the wear box that lies on the surface: the one between surface
 * nodes. */
static void write_surface(FILE *out, const arc_mesh *m, numbering at, const char *name) {
  fprintf(out, "*SURFACE, NAME=%s-contact, TYPE=ELEMENT\n", name);
  for (int column = 0; column + 1 < m->surface; column++) {
    const int e = column * m->rows, a = m->surface_node[column], b = m->surface_node[column + 1];
    const int *c = &m->element[4 * e];
    for (int k = 0; k < 4; k++) {
      const int p = c[k], q = c[(k + 1) % 4];
      if ((p == a && q == b) || (p == b && q == a))
        fprintf(out, "%d, S%d\n", e + at.element, k + 1);
    }
  }
}

static void write_section(FILE *out, const arc_model_def *def, arc_body body, const char *name) {
  const arc_material m = def->material[body];
  fprintf(out, "*MATERIAL, NAME=%s\n*ELASTIC\n%s, %s\n", name, arc_number_to_text(m.E).text,
          arc_number_to_text(m.nu).text);
  fprintf(out, "*SOLID SECTION, ELSET=%s, MATERIAL=%s\n%s\n", name, name,
          arc_number_to_text(def->thickness).text);
}

/* Everything of one body but its material. */
static void write_body(FILE *out, const arc_mesh *m, numbering at) {
  const char *name = arc_body_name(m->body);
  write_mesh(out, m, at, name);
  write_set(out, "NSET, NSET", name, "surface", m->surface_node, m->surface, at.node);
  write_set(out, "NSET, NSET", name, "fixed", m->fixed_node, m->fixed, at.node);
  fprintf(out, "*ELSET, ELSET=%s-wear-box, GENERATE\n%d, %d, 1\n", name, at.element,
          at.element + m->box_elements - 1);
  write_surface(out, m, at, name);
}

arc_status arc_export_mesh_inp(const char *path, const arc_mesh *mesh, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  fprintf(file.stream, "*HEADING\narchard: %s, units mm\n", arc_body_name(mesh->body));
  write_body(file.stream, mesh, (numbering){1, 1});
  return arc_output_close(&file, error);
}

arc_status arc_export_inp(const char *path, const arc_model *model, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  fprintf(file.stream, "*HEADING\narchard: half cylinder on a plate, units mm, N, MPa\n");
  numbering at = {1, 1};
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_mesh *m = arc_model_mesh(model, (arc_body)b);
    write_body(file.stream, m, at);
    write_section(file.stream, arc_model_definition(model), (arc_body)b, arc_body_name(m->body));
    at = (numbering){at.node + m->nodes, at.element + m->elements};
  }
  return arc_output_close(&file, error);
}

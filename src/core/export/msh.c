/* Gmsh files (4.1, text) of both bodies, with the physical groups that arc_mesh_read_msh reads. */
#include "core/export/output.h"

#include <math.h>
#include <stdlib.h>

enum { MSH_LINE = 1, MSH_TRIANGLE = 2, MSH_QUAD = 3, CURVES = 2 };

static const char *const role_names[] = {"upper", "lower"};
static const char *const curve_names[] = {"contact", "fixed"};

/* What is written: surface b + 1 is body b, curves 2 b + 1 and 2 b + 2 its contact and its fixed
 * part. Groups have the numbers of what they hold. */
typedef struct msh_output {
  FILE *out;
  const arc_mesh *mesh[ARC_BODIES]; /* NULL: left out */
  char *fixed[ARC_BODIES];          /* [nodes] whether it is fixed */
  int lines[ARC_BODIES][CURVES];    /* of each curve */
  int nodes, elements, bodies;      /* all that are written */
} msh_output;

/* --- the curves ------------------------------------------------------------------------------- */

/* Counts the lines of a curve, and writes them where a number for the first is given. */
typedef struct line_sink {
  FILE *out;
  int *tag; /* NULL: counted alone */
  int first, count;
} line_sink;

static void add_line(line_sink *s, int from, int to) {
  if (s->tag) fprintf(s->out, "%d %d %d\n", (*s->tag)++, from + s->first, to + s->first);
  s->count++;
}

static void add_contact(const arc_mesh *m, line_sink *s) {
  for (int i = 1; i < m->surface; i++) add_line(s, m->surface_node[i - 1], m->surface_node[i]);
}

/* Edges between fixed nodes, wherever they are. */
static void add_fixed(const arc_mesh *m, const char *fixed, line_sink *s) {
  for (int e = 0; e < m->elements; e++) {
    const int *c = &m->element[4 * e], corners = arc_mesh_corners(m, e);
    for (int k = 0; k < corners; k++)
      if (fixed[c[k]] && fixed[c[(k + 1) % corners]]) add_line(s, c[k], c[(k + 1) % corners]);
  }
}

static void add_curve(const msh_output *o, int body, int curve, line_sink *s) {
  if (curve == 0)
    add_contact(o->mesh[body], s);
  else
    add_fixed(o->mesh[body], o->fixed[body], s);
}

static arc_status find_curves(msh_output *o, int body, arc_error *error) {
  const arc_mesh *m = o->mesh[body];
  o->fixed[body] = calloc((size_t)m->nodes, 1);
  if (!o->fixed[body]) return arc_fail(error, ARC_MEMORY, "out of memory for writing a mesh");
  for (int k = 0; k < m->fixed; k++) o->fixed[body][m->fixed_node[k]] = 1;
  for (int curve = 0; curve < CURVES; curve++) {
    line_sink counted = {0};
    add_curve(o, body, curve, &counted);
    o->elements += o->lines[body][curve] = counted.count;
  }
  o->nodes += m->nodes;
  o->elements += m->elements;
  o->bodies++;
  return ARC_OK;
}

/* --- sections --------------------------------------------------------------------------------- */

static void write_names(const msh_output *o) {
  fprintf(o->out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  fprintf(o->out, "$PhysicalNames\n%d\n", (CURVES + 1) * o->bodies);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int curve = 0; curve < CURVES && o->mesh[b]; curve++)
      fprintf(o->out, "1 %d \"%s.%s\"\n", CURVES * b + curve + 1, role_names[b],
              curve_names[curve]);
  for (int b = 0; b < ARC_BODIES; b++)
    if (o->mesh[b]) fprintf(o->out, "2 %d \"%s\"\n", b + 1, role_names[b]);
  fprintf(o->out, "$EndPhysicalNames\n");
}

/* Number and extent, which is that of the whole body for its curves too. */
static void write_extent(const msh_output *o, int tag, int body) {
  const double *xy = o->mesh[body]->xy;
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (int k = 0; k < 2 * o->mesh[body]->nodes; k++) {
    low[k % 2] = fmin(low[k % 2], xy[k]);
    high[k % 2] = fmax(high[k % 2], xy[k]);
  }
  fprintf(o->out, "%d %s %s 0 %s %s 0 1 %d 0\n", tag, arc_number_to_text(low[0]).text,
          arc_number_to_text(low[1]).text, arc_number_to_text(high[0]).text,
          arc_number_to_text(high[1]).text, tag);
}

static void write_entities(const msh_output *o) {
  fprintf(o->out, "$Entities\n0 %d %d 0\n", CURVES * o->bodies, o->bodies);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int curve = 0; curve < CURVES && o->mesh[b]; curve++)
      write_extent(o, CURVES * b + curve + 1, b);
  for (int b = 0; b < ARC_BODIES; b++)
    if (o->mesh[b]) write_extent(o, b + 1, b);
  fprintf(o->out, "$EndEntities\n");
}

static void write_nodes(const msh_output *o) {
  fprintf(o->out, "$Nodes\n%d %d 1 %d\n", o->bodies, o->nodes, o->nodes);
  for (int b = 0, first = 1; b < ARC_BODIES; b++) {
    if (!o->mesh[b]) continue;
    const int count = o->mesh[b]->nodes;
    fprintf(o->out, "2 %d 0 %d\n", b + 1, count);
    for (int n = 0; n < count; n++) fprintf(o->out, "%d\n", first + n);
    for (int n = 0; n < count; n++)
      fprintf(o->out, "%s %s 0\n", arc_number_to_text(o->mesh[b]->xy[2 * n]).text,
              arc_number_to_text(o->mesh[b]->xy[2 * n + 1]).text);
    first += count;
  }
  fprintf(o->out, "$EndNodes\n");
}

static void write_curve(const msh_output *o, int body, int curve, int first, int *tag) {
  line_sink written = {.out = o->out, .tag = tag, .first = first};
  fprintf(o->out, "1 %d %d %d\n", CURVES * body + curve + 1, MSH_LINE, o->lines[body][curve]);
  add_curve(o, body, curve, &written);
}

static void write_surface(const msh_output *o, int body, int corners, int first, int *tag) {
  const arc_mesh *m = o->mesh[body];
  const int count = corners == 4 ? m->quads : m->triangles;
  if (count == 0) return;
  fprintf(o->out, "2 %d %d %d\n", body + 1, corners == 4 ? MSH_QUAD : MSH_TRIANGLE, count);
  for (int e = 0; e < m->elements; e++) {
    const int *c = &m->element[4 * e];
    if (arc_mesh_corners(m, e) != corners) continue;
    fprintf(o->out, "%d", (*tag)++);
    for (int k = 0; k < corners; k++) fprintf(o->out, " %d", c[k] + first);
    fputc('\n', o->out);
  }
}

static void write_elements(const msh_output *o) {
  int tag = 1, blocks = 0;
  for (int b = 0; b < ARC_BODIES; b++)
    if (o->mesh[b]) blocks += CURVES + (o->mesh[b]->quads > 0) + (o->mesh[b]->triangles > 0);
  fprintf(o->out, "$Elements\n%d %d 1 %d\n", blocks, o->elements, o->elements);
  for (int b = 0, first = 1; b < ARC_BODIES; b++) {
    if (!o->mesh[b]) continue;
    for (int curve = 0; curve < CURVES; curve++) write_curve(o, b, curve, first, &tag);
    for (int corners = 4; corners >= 3; corners--) write_surface(o, b, corners, first, &tag);
    first += o->mesh[b]->nodes;
  }
  fprintf(o->out, "$EndElements\n");
}

/* --- files ------------------------------------------------------------------------------------ */

static arc_status write_file(const char *path, msh_output *o, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  o->out = file.stream;
  write_names(o);
  write_entities(o);
  write_nodes(o);
  write_elements(o);
  return arc_output_close(&file, error);
}

arc_status arc_export_msh(const char *path, const arc_mesh *const mesh[ARC_BODIES],
                          arc_error *error) {
  msh_output o = {0};
  arc_status status = ARC_OK;
  for (int b = 0; status == ARC_OK && b < ARC_BODIES; b++) {
    if (!(o.mesh[b] = mesh[b])) continue;
    status = find_curves(&o, b, error);
  }
  if (status == ARC_OK) status = write_file(path, &o, error);
  for (int b = 0; b < ARC_BODIES; b++) free(o.fixed[b]);
  return status;
}

/* Writes Gmsh files (version 4.1, text) of both bodies, with the physical groups that
 * arc_mesh_read_msh requires. */
#include "core/export/output.h"

#include <math.h>
#include <stdlib.h>

enum { MSH_LINE = 1, MSH_TRIANGLE = 2, MSH_QUAD = 3, CURVES = 2 };

static const char *const role_names[] = {"upper", "lower"};
static const char *const curve_names[] = {"contact", "fixed"};

/* A surface in the file, which is the part of a body with one material. */
typedef struct msh_part {
  int body, material; /* material -1: the body's own material, which has no name */
} msh_part;
enum { PARTS = ARC_BODIES * (ARC_MESH_MATERIALS + 1) };

/* Data of the file. The entities are numbered as follows: surface p + 1 is part p; curve 2 b + 1
 * is the contact curve and curve 2 b + 2 the fixed curve of body b. Physical groups have the
 * same numbers as their entities. */
typedef struct msh_output {
  FILE *out;
  const arc_mesh *mesh[ARC_BODIES]; /* meshes of the bodies; NULL: the body is not written */
  char *fixed[ARC_BODIES];          /* for each node of a body: 1 if the node is fixed */
  int lines[ARC_BODIES][CURVES];    /* number of line elements of each curve */
  msh_part part[PARTS];
  int parts, nodes, elements, bodies; /* numbers of written entities */
} msh_output;

/* --- the surfaces ----------------------------------------------------------------------------- */

/* Returns the index of the material of element e, or -1 for the body's own material. In generated
 * meshes the layers count as materials. */
static int material_of(const arc_mesh *m, int e) {
  if (m->material) return m->material[e];
  return m->layer && m->layer[e] < arc_body_layers(&m->solid) ? m->layer[e] : -1;
}

static int part_of(const msh_output *o, int body, int material) {
  int p = 0;
  while (p < o->parts && (o->part[p].body != body || o->part[p].material != material)) p++;
  return p;
}

/* Lists the parts of a body in the order of its materials. Named materials without elements are
 * included. */
static void find_parts(msh_output *o, int body) {
  const arc_mesh *m = o->mesh[body];
  for (int material = -1; material < ARC_MESH_MATERIALS; material++) {
    int e = 0;
    while (e < m->elements && material_of(m, e) != material) e++;
    if (e < m->elements || (material >= 0 && material < m->materials))
      o->part[o->parts++] = (msh_part){body, material};
  }
}

static void write_part_name(const msh_output *o, const msh_part *p) {
  const arc_mesh *m = o->mesh[p->body];
  fputs(role_names[p->body], o->out);
  if (p->material >= 0 && m->material)
    fprintf(o->out, ".%s", m->material_name[p->material]);
  else if (p->material >= 0)
    fprintf(o->out, ".layer%d", p->material + 1);
}

/* --- the curves ------------------------------------------------------------------------------- */

/* Data for counting or writing the line elements of a curve. `tag` points to the number of the
 * next element. */
typedef struct line_sink {
  FILE *out;
  int *tag; /* NULL: the line elements are only counted */
  int first, count;
} line_sink;

static void add_line(line_sink *s, int from, int to) {
  if (s->tag) fprintf(s->out, "%d %d %d\n", (*s->tag)++, from + s->first, to + s->first);
  s->count++;
}

static void add_contact(const arc_mesh *m, line_sink *s) {
  for (int i = 1; i < m->surface; i++) add_line(s, m->surface_node[i - 1], m->surface_node[i]);
}

/* Adds all edges of elements whose two nodes are fixed. */
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
  find_parts(o, body);
  o->nodes += m->nodes;
  o->elements += m->elements;
  o->bodies++;
  return ARC_OK;
}

/* --- sections --------------------------------------------------------------------------------- */

static void write_names(const msh_output *o) {
  fprintf(o->out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  fprintf(o->out, "$PhysicalNames\n%d\n", CURVES * o->bodies + o->parts);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int curve = 0; curve < CURVES && o->mesh[b]; curve++)
      fprintf(o->out, "1 %d \"%s.%s\"\n", CURVES * b + curve + 1, role_names[b],
              curve_names[curve]);
  for (int p = 0; p < o->parts; p++) {
    fprintf(o->out, "2 %d \"", p + 1);
    write_part_name(o, &o->part[p]);
    fprintf(o->out, "\"\n");
  }
  fprintf(o->out, "$EndPhysicalNames\n");
}

/* Writes the number of an entity. Its extent in the file is the extent of its body. */
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
  fprintf(o->out, "$Entities\n0 %d %d 0\n", CURVES * o->bodies, o->parts);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int curve = 0; curve < CURVES && o->mesh[b]; curve++)
      write_extent(o, CURVES * b + curve + 1, b);
  for (int p = 0; p < o->parts; p++) write_extent(o, p + 1, o->part[p].body);
  fprintf(o->out, "$EndEntities\n");
}

static int first_part(const msh_output *o, int body) {
  int p = 0;
  while (o->part[p].body != body) p++;
  return p;
}

static void write_nodes(const msh_output *o) {
  fprintf(o->out, "$Nodes\n%d %d 1 %d\n", o->bodies, o->nodes, o->nodes);
  for (int b = 0, first = 1; b < ARC_BODIES; b++) {
    if (!o->mesh[b]) continue;
    const int count = o->mesh[b]->nodes;
    fprintf(o->out, "2 %d 0 %d\n", first_part(o, b) + 1, count);
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

/* Returns the index after the last element of the block that begins at element e. The elements of a
 * block have the same type and material. Blocks preserve the order of the elements, so that sums
 * over the elements are identical for a mesh that is read from the file. */
static int block_end(const arc_mesh *m, int e) {
  const int corners = arc_mesh_corners(m, e), material = material_of(m, e);
  while (e < m->elements && arc_mesh_corners(m, e) == corners && material_of(m, e) == material) e++;
  return e;
}

static int count_blocks(const arc_mesh *m) {
  int blocks = 0;
  for (int e = 0; e < m->elements; e = block_end(m, e)) blocks++;
  return blocks;
}

static void write_element(FILE *out, const arc_mesh *m, int e, int first, int tag) {
  fprintf(out, "%d", tag);
  for (int k = 0; k < arc_mesh_corners(m, e); k++)
    fprintf(out, " %d", m->element[4 * e + k] + first);
  fputc('\n', out);
}

static void write_blocks(const msh_output *o, int body, int first, int *tag) {
  const arc_mesh *m = o->mesh[body];
  for (int e = 0, end; e < m->elements; e = end) {
    end = block_end(m, e);
    fprintf(o->out, "2 %d %d %d\n", part_of(o, body, material_of(m, e)) + 1,
            arc_mesh_corners(m, e) == 4 ? MSH_QUAD : MSH_TRIANGLE, end - e);
    for (int k = e; k < end; k++) write_element(o->out, m, k, first, (*tag)++);
  }
}

static void write_elements(const msh_output *o) {
  int tag = 1, blocks = 0;
  for (int b = 0; b < ARC_BODIES; b++)
    if (o->mesh[b]) blocks += CURVES + count_blocks(o->mesh[b]);
  fprintf(o->out, "$Elements\n%d %d 1 %d\n", blocks, o->elements, o->elements);
  for (int b = 0, first = 1; b < ARC_BODIES; b++) {
    if (!o->mesh[b]) continue;
    for (int curve = 0; curve < CURVES; curve++) write_curve(o, b, curve, first, &tag);
    write_blocks(o, b, first, &tag);
    first += o->mesh[b]->nodes;
  }
  fprintf(o->out, "$EndElements\n");
}

/* --- files ------------------------------------------------------------------------------------ */

static void write_all(const msh_output *o) {
  write_names(o);
  write_entities(o);
  write_nodes(o);
  write_elements(o);
}

static arc_status write_file(const char *path, msh_output *o, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  o->out = file.stream;
  write_all(o);
  return arc_output_close(&file, error);
}

static arc_status write_text(char **text, msh_output *o, arc_error *error) {
  size_t length;
  o->out = open_memstream(text, &length);
  if (o->out) write_all(o);
  const int whole = o->out && !ferror(o->out);
  if (o->out && fclose(o->out) == 0 && whole) return ARC_OK;
  free(*text);
  *text = NULL;
  return arc_fail(error, ARC_MEMORY, "out of memory for writing a mesh");
}

/* Collects the data of the file. The caller frees the data with end(), also after an error. */
static arc_status begin(msh_output *o, const arc_mesh *const mesh[ARC_BODIES], arc_error *error) {
  arc_status status = ARC_OK;
  for (int b = 0; status == ARC_OK && b < ARC_BODIES; b++)
    if ((o->mesh[b] = mesh[b])) status = find_curves(o, b, error);
  return status;
}

static void end(msh_output *o) {
  for (int b = 0; b < ARC_BODIES; b++) free(o->fixed[b]);
}

arc_status arc_export_msh(const char *path, const arc_mesh *const mesh[ARC_BODIES],
                          arc_error *error) {
  msh_output o = {0};
  arc_status status = begin(&o, mesh, error);
  if (status == ARC_OK) status = write_file(path, &o, error);
  end(&o);
  return status;
}

arc_status arc_export_msh_text(char **text, const arc_mesh *const mesh[ARC_BODIES],
                               arc_error *error) {
  msh_output o = {0};
  *text = NULL;
  arc_status status = begin(&o, mesh, error);
  if (status == ARC_OK) status = write_text(text, &o, error);
  end(&o);
  return status;
}

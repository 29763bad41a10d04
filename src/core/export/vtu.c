/* Writes VTK unstructured grids in XML. The binary data follow the XML description. The data of
 * each array begin with the size of the array in bytes. */
#include "core/export/output.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { VTK_TRIANGLE = 5, VTK_QUAD = 9 };

typedef enum section { FIELD_DATA, POINT_DATA, CELL_DATA, POINTS, CELLS, SECTIONS } section;
static const char *const section_names[] = {"FieldData", "PointData", "CellData", "Points",
                                            "Cells"};

typedef enum number_type { FLOAT64, INT32, UINT8 } number_type;
static const char *const type_names[] = {"Float64", "Int32", "UInt8"};
static const size_t type_sizes[] = {sizeof(double), sizeof(int32_t), sizeof(uint8_t)};

typedef struct array {
  section section;
  const char *name, *unit;
  number_type type;
  int components;
  size_t tuples;
  void *data;
} array;

/* Largest number of arrays in a file: points, time, displacement, layers, three arrays that
 * describe the cells, stresses, and surface values. */
#define AND_ONE(name, unit, text) +1
enum { MOST_ARRAYS = 7 ARC_FIELD_STRESSES(AND_ONE) ARC_SURFACE_COLUMNS(AND_ONE) };

typedef struct grid {
  const arc_mesh *mesh;
  const arc_contact *contact; /* NULL: only the mesh is written */
  array list[MOST_ARRAYS];    /* arrays of the file, sorted by section */
  int count;
  int failed; /* 1: an allocation failed */
} grid;

static void grid_free(grid *g) {
  for (int i = 0; i < g->count; i++) free(g->list[i].data);
}

/* Adds an array of zeros to the grid. Returns the address of the values, or NULL if memory is
 * exhausted. */
static void *add(grid *g, array a) {
  a.data = calloc(a.tuples * (size_t)a.components, type_sizes[a.type]);
  if (a.data)
    g->list[g->count++] = a;
  else
    g->failed = 1;
  return a.data;
}

static double *add_numbers(grid *g, const char *name, const char *unit, int components) {
  return add(g, (array){.section = POINT_DATA,
                        .name = name,
                        .unit = unit,
                        .components = components,
                        .tuples = (size_t)g->mesh->nodes});
}

/* --- arrays at the nodes ---------------------------------------------------------------------- */

static void add_scalar(grid *g, const char *name, const char *unit, const double *value) {
  double *to = add_numbers(g, name, unit, 1);
  if (to) memcpy(to, value, (size_t)g->mesh->nodes * sizeof *to);
}

static void add_displacement(grid *g, const arc_field *f) {
  double *to = add_numbers(g, "displacement", "mm", 3);
  for (int n = 0; to && n < f->nodes; n++) {
    to[3 * n] = f->ux[n];
    to[3 * n + 1] = f->uy[n];
  }
}

static void add_on_surface(grid *g, const char *name, const char *unit, const double *value) {
  double *to = add_numbers(g, name, unit, 1);
  for (int i = 0; to && i < g->mesh->surface; i++) to[g->mesh->surface_node[i]] = value[i];
}

static void add_results(grid *g, const arc_field *f) {
  const double *wear_depth = arc_shape_profile(arc_contact_shape(g->contact), g->mesh->body).h;
  const double *pressure = arc_contact_pressure(g->contact, g->mesh->body).p;
  add_displacement(g, f);
#define ADD_STRESS(name, unit, text)  add_scalar(g, #name, unit, f->name);
#define ADD_SURFACE(name, unit, text) add_on_surface(g, #name, unit, name);
  ARC_FIELD_STRESSES(ADD_STRESS)
  ARC_SURFACE_COLUMNS(ADD_SURFACE)
}

/* --- the grid --------------------------------------------------------------------------------- */

static void add_points(grid *g, const arc_field *f) {
  const size_t nodes = (size_t)g->mesh->nodes;
  double *to = add(
      g,
      (array){.section = POINTS, .name = "Points", .unit = "mm", .components = 3, .tuples = nodes});
  for (size_t n = 0; to && n < nodes; n++) {
    to[3 * n] = f ? f->x[n] : g->mesh->xy[2 * n];
    to[3 * n + 1] = f ? f->y[n] : g->mesh->xy[2 * n + 1];
  }
}

/* Adds an array with the layer of each element (1: the layer at the surface) or, for an imported
 * mesh, with its material. Elements below all layers have the highest number. */
static void add_layers(grid *g) {
  const arc_mesh *m = g->mesh;
  if (!m->layer || arc_body_layers(&m->solid) == 0) return;
  int32_t *layer = add(g, (array){.section = CELL_DATA,
                                  .name = "layer",
                                  .type = INT32,
                                  .components = 1,
                                  .tuples = (size_t)m->elements});
  for (int e = 0; layer && e < m->elements; e++) layer[e] = m->layer[e] + 1;
}

static void add_cells(grid *g) {
  const arc_mesh *m = g->mesh;
  array a = {.section = CELLS, .name = "connectivity", .type = INT32, .components = 1};
  a.tuples = (size_t)(4 * m->quads + 3 * m->triangles);
  int32_t *corner = add(g, a);
  a.name = "offsets";
  a.tuples = (size_t)m->elements;
  int32_t *offset = add(g, a);
  a.name = "types";
  a.type = UINT8;
  uint8_t *type = add(g, a);
  int32_t end = 0;
  for (int e = 0; !g->failed && e < m->elements; e++) {
    const int corners = arc_mesh_corners(m, e);
    for (int c = 0; c < corners; c++) corner[end++] = m->element[4 * e + c];
    offset[e] = end;
    type[e] = corners == 3 ? VTK_TRIANGLE : VTK_QUAD;
  }
}

static void add_time(grid *g, double time) {
  double *to =
      add(g, (array){.section = FIELD_DATA, .name = "TimeValue", .components = 1, .tuples = 1});
  if (to) *to = time;
}

/* --- the file --------------------------------------------------------------------------------- */

static uint64_t bytes_of(const array *a) {
  return a->tuples * (uint64_t)a->components * type_sizes[a->type];
}

static void describe(FILE *out, const array *a, uint64_t offset) {
  fprintf(out, "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\"", type_names[a->type],
          a->name, a->components);
  if (a->section == FIELD_DATA) fprintf(out, " NumberOfTuples=\"%zu\"", a->tuples);
  fprintf(out, " format=\"appended\" offset=\"%llu\"", (unsigned long long)offset);
  if (a->unit)
    fprintf(out,
            "><InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">%s</InformationKey>"
            "</DataArray>\n",
            a->unit);
  else
    fprintf(out, "/>\n");
}

/* Writes the descriptions of all arrays of a section. Offsets [bytes] are counted from the
 * character `_` before the data. */
static void describe_section(FILE *out, const grid *g, section part) {
  uint64_t offset = 0;
  fprintf(out, "<%s>\n", section_names[part]);
  for (int i = 0; i < g->count; i++) {
    if (g->list[i].section == part) describe(out, &g->list[i], offset);
    offset += sizeof offset + bytes_of(&g->list[i]);
  }
  fprintf(out, "</%s>\n", section_names[part]);
}

static void write_grid(FILE *out, const grid *g) {
  const uint16_t one = 1;
  fprintf(out,
          "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
          "byte_order=\"%s\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
          *(const uint8_t *)&one ? "LittleEndian" : "BigEndian");
  describe_section(out, g, FIELD_DATA);
  fprintf(out, "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n", g->mesh->nodes,
          g->mesh->elements);
  for (section part = POINT_DATA; part < SECTIONS; part++) describe_section(out, g, part);
  fprintf(out, "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
  for (int i = 0; i < g->count; i++) {
    const uint64_t bytes = bytes_of(&g->list[i]);
    fwrite(&bytes, sizeof bytes, 1, out);
    fwrite(g->list[i].data, 1, (size_t)bytes, out);
  }
  fprintf(out, "\n</AppendedData>\n</VTKFile>\n");
}

static arc_status write_file(const char *path, const grid *g, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  write_grid(file.stream, g);
  return arc_output_close(&file, error);
}

arc_status arc_export_vtu(const char *path, const arc_mesh *mesh, const arc_contact *contact,
                          double time, arc_error *error) {
  grid g = {.mesh = mesh, .contact = contact};
  arc_field *field = NULL;
  arc_status status = ARC_OK;
  if (contact && arc_model_mesh(arc_contact_model(contact), mesh->body) != mesh)
    return arc_fail(error, ARC_ARGUMENT,
                    "contact: expected a contact on this mesh, got a contact on another mesh");
  if (contact) status = arc_contact_field(contact, mesh->body, &field, error);
  if (field) {
    add_time(&g, time);
    add_results(&g, field);
  }
  add_layers(&g);
  add_points(&g, field);
  add_cells(&g);
  if (status == ARC_OK && g.failed)
    status = arc_fail(error, ARC_MEMORY, "out of memory for writing %s", path);
  if (status == ARC_OK) status = write_file(path, &g, error);
  grid_free(&g);
  arc_field_destroy(&field);
  return status;
}

/* Writes legacy VTK text files: an unstructured grid with displacements and stresses at its
 * nodes. */
#include "core/export/output.h"

enum { vtk_triangle = 5, vtk_quad = 9 };

static void write_vector(FILE *out, double x, double y) {
  fprintf(out, "%s %s 0\n", arc_number_to_text(x).text, arc_number_to_text(y).text);
}

static void write_grid(FILE *out, const arc_mesh *mesh, const double *x, const double *y) {
  fprintf(out, "# vtk DataFile Version 3.0\narchard: %s, lengths in mm, stresses in MPa\nASCII\n",
          arc_body_name(mesh->body));
  fprintf(out, "DATASET UNSTRUCTURED_GRID\nPOINTS %d double\n", mesh->nodes);
  for (int n = 0; n < mesh->nodes; n++)
    write_vector(out, x ? x[n] : mesh->xy[2 * n], y ? y[n] : mesh->xy[2 * n + 1]);
  fprintf(out, "CELLS %d %d\n", mesh->elements, 5 * mesh->quads + 4 * mesh->triangles);
  for (int e = 0; e < mesh->elements; e++) {
    const int *c = &mesh->element[4 * e];
    if (arc_mesh_corners(mesh, e) == 3)
      fprintf(out, "3 %d %d %d\n", c[0], c[1], c[2]);
    else
      fprintf(out, "4 %d %d %d %d\n", c[0], c[1], c[2], c[3]);
  }
  fprintf(out, "CELL_TYPES %d\n", mesh->elements);
  for (int e = 0; e < mesh->elements; e++)
    fprintf(out, "%d\n", arc_mesh_corners(mesh, e) == 3 ? vtk_triangle : vtk_quad);
}

static void write_scalar(FILE *out, const char *name, int count, const double *value) {
  fprintf(out, "SCALARS %s double 1\nLOOKUP_TABLE default\n", name);
  for (int n = 0; n < count; n++) fprintf(out, "%s\n", arc_number_to_text(value[n]).text);
}

static void write_field(FILE *out, const arc_field *f) {
  fprintf(out, "POINT_DATA %d\nVECTORS displacement double\n", f->nodes);
  for (int n = 0; n < f->nodes; n++) write_vector(out, f->ux[n], f->uy[n]);
#define SCALAR(name, unit, text) write_scalar(out, #name, f->nodes, f->name);
  ARC_FIELD_STRESSES(SCALAR)
}

arc_status arc_export_vtk(const char *path, const arc_mesh *mesh, const arc_field *field,
                          arc_error *error) {
  output_file file;
  if (field && field->nodes != mesh->nodes)
    return arc_fail(error, ARC_ARGUMENT, "field: expected %d nodes as in the mesh, got %d",
                    mesh->nodes, field->nodes);
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  write_grid(file.stream, mesh, field ? field->x : NULL, field ? field->y : NULL);
  if (field) write_field(file.stream, field);
  return arc_output_close(&file, error);
}

/* archard/export.h - files for other tools. Each writes to a temporary file beside `path` and
 * renames it, so that a failure (ARC_IO, the message names the file and the reason) leaves no half
 * file.
 */
#ifndef ARCHARD_EXPORT_H
#define ARCHARD_EXPORT_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Columns of `rows` doubles with a header line of names, each with its unit behind it as in
 * "distance [mm]". `units` may be NULL or hold NULL or "": none. */
arc_status arc_export_csv(const char *path, size_t columns, const char *const names[],
                          const char *const units[], const double *const data[], size_t rows,
                          arc_error *error);

/* Legacy VTK text of one body's mesh, or of a field on it (field may be NULL). */
arc_status arc_export_vtk(const char *path, const arc_mesh *mesh, const arc_field *field,
                          arc_error *error);

/* What stands at the nodes of a body in a .vtu file, and nowhere but on its candidate surface; 0
 * elsewhere. X(name, unit, text). */
#define ARC_SURFACE_COLUMNS(X)                                                                     \
  X(wear_depth, "mm", "wear depth, scalar sum along the normals")                                  \
  X(pressure, "MPa", "contact pressure")

/* A VTK unstructured grid (.vtu: XML, numbers to the bit in binary behind it) of one body;
 * with a contact whose model has that mesh also its displacements, the columns of
 * ARC_FIELD_STRESSES and those of ARC_SURFACE_COLUMNS, nodes as worn. `time` is written as
 * TimeValue with a contact. Bodies with layers have the number of each element's, from 1, as layer.
 * Arrays carry their units. Also errors of arc_contact_field. */
arc_status arc_export_vtu(const char *path, const arc_mesh *mesh, const arc_contact *contact,
                          double time, arc_error *error);

/* Input deck of the whole problem of a contact, as worn, in the keywords that Abaqus and CalculiX
 * share: slabs one element thick (C3D8, C3D8I for CPE4I, C3D6 for triangles), the supports, the
 * contact pair (linear penalty), a step that brings the bodies together by the approach and one
 * that loads the plate's base, output requests. CalculiX runs it as it is. Numbers take at most 20
 * characters, to 5e-13. Triangles stand apart there, each with its own dilatation: near nu = 1/2
 * they are stiffer than those of the model. */
arc_status arc_export_inp(const char *path, const arc_contact *contact, arc_error *error);

/* One body's mesh alone, in plane elements: nodes, elements, surface, boundary sets. */
arc_status arc_export_mesh_inp(const char *path, const arc_mesh *mesh, arc_error *error);

/* A Gmsh file (4.1, text, mm) of both bodies, or of one (NULL: left out), with the physical groups
 * that arc_mesh_read_msh reads: "upper" is the cylinder, "lower" the plate, "upper.NAME" what is of
 * a named material, "upper.layer1" the first of a body's own layers. Numbers read back to the bit,
 * nodes and elements in their order. */
arc_status arc_export_msh(const char *path, const arc_mesh *const mesh[ARC_BODIES],
                          arc_error *error);
/* The same as a text, to be freed with free(); NULL on failure, ARC_MEMORY. */
arc_status arc_export_msh_text(char **text, const arc_mesh *const mesh[ARC_BODIES],
                               arc_error *error);

/* A text of `length` bytes as it is. */
arc_status arc_export_text(const char *path, const char *text, size_t length, arc_error *error);

/* The shortest text that reads back to the same bits: 0.3, not 0.29999999999999999. NaN and zero
 * have no sign. All files have their numbers so. */
typedef struct arc_number_text {
  char text[32];
} arc_number_text;
arc_number_text arc_number_to_text(double value);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

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

/* Columns of `rows` doubles with a header line of names. */
arc_status arc_export_csv(const char *path, size_t columns, const char *const names[],
                          const double *const data[], size_t rows, arc_error *error);

/* Legacy VTK text of one body's mesh, or of a field on it (field may be NULL). */
arc_status arc_export_vtk(const char *path, const arc_mesh *mesh, const arc_field *field,
                          arc_error *error);

/* Abaqus/CalculiX input deck of both meshes: nodes, elements, surfaces, boundary sets, materials.
 */
arc_status arc_export_inp(const char *path, const arc_model *model, arc_error *error);

/* The same of one body alone: nodes, elements, surface, boundary sets. */
arc_status arc_export_mesh_inp(const char *path, const arc_mesh *mesh, arc_error *error);

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

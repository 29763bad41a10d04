/* archard/export.h - writes results to files for other programs. All functions write a temporary
 * file beside `path` and rename it when it is complete, so on failure an old file is unchanged.
 * ARC_IO: the message has the file and the reason. */
#ifndef ARCHARD_EXPORT_H
#define ARCHARD_EXPORT_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Writes a CSV file with a header line of names and units, such as "distance [mm]", and columns of
 * `rows` numbers. `units`, or any of its items, may be NULL or "". */
arc_status arc_export_csv(const char *path, size_t columns, const char *const names[],
                          const char *const units[], const double *const data[], size_t rows,
                          arc_error *error);

/* Writes the mesh of one body as legacy VTK text, with the displacements and stresses of `field`
 * (if not NULL). */
arc_status arc_export_vtk(const char *path, const arc_mesh *mesh, const arc_field *field,
                          arc_error *error);

/* Surface values X(name, unit, text) at the nodes in a .vtu file. The values are 0 outside the
 * candidate surface. */
#define ARC_SURFACE_COLUMNS(X)                                                                     \
  X(wear_depth, "mm", "wear depth: sum over all updates of the depths along the normals")          \
  X(pressure, "MPa", "contact pressure")

/* Writes a VTK unstructured grid (.vtu, XML with appended binary data) of one body. With a contact
 * on this mesh the file also has displacements, ARC_FIELD_STRESSES, ARC_SURFACE_COLUMNS on the worn
 * nodes, and `time` as TimeValue. For bodies with layers the file also has the layer number of each
 * element, from 1. Each array has its unit as an attribute. Errors: also those of
 * arc_contact_field. */
arc_status arc_export_vtu(const char *path, const arc_mesh *mesh, const arc_contact *contact,
                          double time, arc_error *error);

/* Writes an input deck of a contact on the worn surfaces, in the format of Abaqus. CalculiX runs
 * the deck unchanged. The bodies are slabs one element thick (C3D8, C3D8I for CPE4I, C3D6 for
 * triangles) with supports and a contact pair (linear penalty). The first step prescribes the
 * approach as a displacement, the second step the load on the plate's base. The deck requests
 * displacements, stresses and contact results. Numbers have at most 20 characters and are accurate
 * to 5e-13. In the deck each triangle has its own dilatation, so near nu = 1/2 the deck is stiffer
 * than the model. */
arc_status arc_export_inp(const char *path, const arc_contact *contact, arc_error *error);

/* Writes the mesh of one body as an Abaqus input file of plane elements. The file has the contact
 * surface, and sets of the surface nodes, the fixed nodes and the elements of the wear box.
 * ARC_ARGUMENT: the mesh is imported. */
arc_status arc_export_mesh_inp(const char *path, const arc_mesh *mesh, arc_error *error);

/* Writes a Gmsh file (text, version 4.1, in mm) of both bodies, or of one body if the other pointer
 * is NULL. The file has the physical groups that arc_mesh_read_msh reads: "upper", "lower",
 * "upper.NAME" for a named material, "upper.layer1" for the first layer. Coordinates are exact to
 * the bit, and the order of nodes and elements is kept. */
arc_status arc_export_msh(const char *path, const arc_mesh *const mesh[ARC_BODIES],
                          arc_error *error);
/* Stores in *text the text that arc_export_msh writes to a file. The caller frees it with free().
 * On failure *text is NULL. Errors: ARC_MEMORY. */
arc_status arc_export_msh_text(char **text, const arc_mesh *const mesh[ARC_BODIES],
                               arc_error *error);

/* Writes a text of `length` bytes to a file. */
arc_status arc_export_text(const char *path, const char *text, size_t length, arc_error *error);

/* A number as text. arc_number_to_text returns the shortest text that is read back as exactly the
 * same number, such as 0.3 instead of 0.29999999999999999. NaN and zero are written without a sign.
 * All exported files use this function. */
typedef struct arc_number_text {
  char text[32];
} arc_number_text;
arc_number_text arc_number_to_text(double value);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

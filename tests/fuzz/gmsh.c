/* Fuzz target for untrusted Gmsh files: every file must give meshes or an error with a message. */
#include "fuzz.h"

#include "archard/model.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  arc_mesh *mesh[ARC_BODIES] = {NULL, NULL};
  arc_error error = {0};
  const char *path = as_file(data, size, ".msh");
  const arc_status status = arc_mesh_read_msh(path, mesh, &error);
  if (status != ARC_OK && !error.message[0]) FOUND("an error without a message");
  for (int body = 0; body < ARC_BODIES; body++) arc_mesh_destroy(&mesh[body]);
  return 0;
}

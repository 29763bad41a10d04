/* Checks the surfaces of a run in plane models: depths, worn meshes and contact. */
#include "core/plane/cycle.h"

#include <math.h>
#include <stdlib.h>

/* --- surfaces and meshes ---------------------------------------------------------------------- */

static arc_status check_surface(const arc_wear *w, arc_body body, arc_error *error) {
  const arc_profile p = arc_shape_profile(arc_wear_shape(w), body);
  for (int i = 0; i < p.count; i++)
    if (!(p.h[i] >= 0) || !isfinite(p.h[i]) || !isfinite(p.y[i]))
      return arc_fail(error, ARC_NUMERIC,
                      "surface: expected a depth >= 0 and a finite height, got depth %g mm, height "
                      "%g mm at x = %g mm of the %s",
                      p.h[i], p.y[i], p.x[i], arc_body_name(body));
  return ARC_OK;
}

static arc_status check_mesh(const arc_wear *w, arc_body body, arc_error *error) {
  const arc_mesh *mesh = arc_model_mesh(arc_wear_model(w), body);
  if (mesh->rows == 0)
    return ARC_OK; /* a mesh without a wear box does not deform with the wear; its worn nodes are
                      only used for output */
  double *xy = malloc(2 * (size_t)mesh->nodes * sizeof *xy);
  if (!xy) return arc_fail(error, ARC_MEMORY, "out of memory to validate a run");
  arc_shape_nodes(arc_wear_shape(w), body, xy);
  const double smallest = arc_mesh_quality(mesh, xy).smallest_jacobian;
  free(xy);
  if (smallest > 0) return ARC_OK;
  return arc_fail(error, ARC_NUMERIC,
                  "mesh: expected positive Jacobians, got %g mm2 in the worn %s", smallest,
                  arc_body_name(body));
}

static arc_status check_contact(const arc_wear *w, arc_error *error) {
  arc_contact *contact;
  arc_status status = arc_wear_contact(w, &contact, error);
  if (status == ARC_OK) status = arc_contact_validate(contact, error);
  arc_contact_destroy(&contact);
  return status;
}

arc_status arc_plane_validate(const arc_wear *w, arc_error *error) {
  arc_status status = ARC_OK;
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) {
    status = check_surface(w, (arc_body)b, error);
    if (status == ARC_OK && w->def.geometry == ARC_MOVING)
      status = check_mesh(w, (arc_body)b, error);
  }
  return status == ARC_OK ? check_contact(w, error) : status;
}

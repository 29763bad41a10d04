/* Models of half-spaces: what a definition may be, its bodies, its cells. */
#include "core/space/space_kind.h"

#include "core/base/callbacks.h"
#include "core/elastic/pair.h"

#include <math.h>
#include <stdlib.h>

static const double usual_cells = 8; /* over the unworn contact's half width */

/* --- checks ------------------------------------------------------------------------------------
 */

static arc_status refuse(arc_error *error, const char *field, const char *expected) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': with geometry = \"3-D\" expected %s", field,
                  expected);
}

static arc_status check_body(const arc_model_def *def, arc_body body, arc_error *error) {
  const arc_body_def solid = arc_model_solid(def, body), *own = &def->body[body];
  const int lower = body == ARC_LOWER;
  if (!arc_body_is_spatial(&solid) && !arc_body_is_flat(&solid))
    return refuse(error, arc_model_role_name(body), "a body.ball{} or a body.block{}");
  if (own->height > 0 || own->width > 0)
    return refuse(error, lower ? "lower.height" : "upper.height",
                  "a block without width and height: a half-space, which may have layers");
  for (int l = 0; l < arc_body_layers(own); l++)
    if (own->layer[l].material.k > 0)
      return refuse(error, lower ? "lower.layers" : "upper.layers",
                    "layers without k of their own: bodies wear by one coefficient");
  return ARC_OK;
}

static arc_status check_sizes(const arc_model_def *def, arc_error *error) {
  const arc_mesh_def *mesh = &def->mesh;
  const arc_mesh_def usual = arc_mesh_default();
  if (def->thickness != 1) return refuse(error, "thickness", "none: bodies have none");
  if (def->axis != 0) return refuse(error, "axis", "none");
  if (mesh->height > 0) return refuse(error, "mesh.height", "none: cells lie on the surface");
  if (mesh->far > 0) return refuse(error, "mesh.far", "none: cells lie on the surface");
  if (mesh->rows != usual.rows && mesh->rows != 0)
    return refuse(error, "mesh.rows", "none: cells lie on the surface");
  if (mesh->element != ARC_ELEMENT_AUTO)
    return refuse(error, "mesh.element", "none: half-spaces have cells, no elements");
  if (mesh->zone[ARC_UPPER] > 0 || mesh->zone[ARC_LOWER] > 0)
    return refuse(error, "mesh.zone", "none: windows grow by themselves");
  return ARC_OK;
}

arc_status arc_space_check_model(const arc_model_def *def, arc_error *error) {
  arc_status status = arc_settings_check(arc_model_settings, "", def, error);
  if (status == ARC_OK) status = check_sizes(def, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = check_body(def, (arc_body)b, error);
  const arc_body_def upper = arc_model_solid(def, ARC_UPPER),
                     lower = arc_model_solid(def, ARC_LOWER);
  if (status == ARC_OK && arc_body_is_flat(&upper) && arc_body_is_flat(&lower))
    return refuse(error, "upper", "a body.ball{} on one side");
  return status;
}

/* --- models ------------------------------------------------------------------------------------
 */

arc_status arc_space_build(const arc_model_def *def, const arc_callbacks *callbacks,
                           arc_model **result, arc_error *error) {
  (void)callbacks;
  *result = NULL;
  const arc_status status = arc_space_check_model(def, error);
  if (status != ARC_OK) return status;
  arc_model *model = calloc(1, sizeof *model);
  if (!model) return arc_fail(error, ARC_MEMORY, "out of memory for a model");
  *model = (arc_model){.kind = arc_kind_of(def), .references = 1, .def = *def};
  *result = model;
  return ARC_OK;
}

void arc_space_end_model(arc_model *model) {
  free(model);
}

size_t arc_space_model_bytes(const arc_model *model) {
  return sizeof *model;
}

/* --- bodies and cells --------------------------------------------------------------------------
 */

arc_halfspace_def arc_space_bodies(const arc_model_def *def) {
  arc_halfspace_def d = {.size_x = 0};
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_body_def solid = arc_model_solid(def, (arc_body)b);
    d.body[b].material = def->material[b];
    for (int l = 0; l < ARC_MOST_LAYERS; l++) d.body[b].layer[l] = solid.layer[l];
    if (!arc_body_is_spatial(&solid)) continue;
    d.body[b].radius_x = solid.radius;
    d.body[b].radius_z = solid.radius_z;
  }
  return d;
}

arc_hertz_ellipse arc_space_hertz(const arc_model_def *def, double load) {
  const arc_halfspace_def d = arc_space_bodies(def);
  arc_hertz_ellipse hertz = {0, 0, 0, 0};
  double x = 0, z = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    if (d.body[b].radius_x > 0) x += 1 / d.body[b].radius_x;
    if (d.body[b].radius_z > 0) z += 1 / d.body[b].radius_z;
  }
  arc_hertz_ellipse_of(1 / x, 1 / z, arc_contact_modulus(def->geometry, def->material), load,
                       &hertz, NULL);
  return hertz;
}

double arc_space_cell(const arc_model_def *def, double load) {
  if (def->mesh.size > 0) return def->mesh.size;
  const arc_hertz_ellipse hertz = arc_space_hertz(def, load);
  const double finer = def->mesh.fineness > 0 ? def->mesh.fineness : 1;
  return fmin(hertz.half_width, hertz.half_width_z) / (usual_cells * finer);
}

void arc_space_fit(const arc_model_def *def, double load, double volume, double stroke,
                   double increment, arc_halfspace_def *cells) {
  const arc_hertz_ellipse hertz = arc_space_hertz(def, load);
  const double least = fmin(hertz.half_width, hertz.half_width_z);
  *cells = arc_space_bodies(def);
  arc_halfspace_fit(cells, load, volume, stroke, increment, least / arc_space_cell(def, load));
}

void arc_space_warn(const arc_model_def *def, const arc_halfspace_def *cells, double half_width,
                    const arc_callbacks *callbacks) {
  static const double small = 0.2; /* contact over radius: slopes no longer count as small */
  const double fewest = 4;         /* cells in the half width */
  double least = INFINITY;
  for (int b = 0; b < ARC_BODIES; b++)
    if (cells->body[b].radius_x > 0) least = fmin(least, cells->body[b].radius_x);
  if (half_width > small * least)
    arc_warn(callbacks,
             "the contact's half width %.3g mm is %.2g of the radius %.3g mm: half-spaces hold up "
             "to %g of it, beyond that pressures and depths are estimates",
             half_width, half_width / least, least, small);
  if (half_width < fewest * cells->size_x)
    arc_warn(callbacks,
             "the contact's half width %.3g mm has fewer than %g cells of %.3g mm: use mesh.size = "
             "\"auto\" or a smaller one",
             half_width, fewest, cells->size_x);
  (void)def;
}

/* Checks imported meshes against the definition of a model, and sets the values of the definition
 * that follow from the meshes. */
#include "core/elastic/imported_mesh.h"
#include "core/elastic/chart.h"
#include "core/elastic/pair.h"

#include "core/pair/kind.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- materials by name ------------------------------------------------------------------------ */

static int find_layer(const arc_body_def *solid, const char *name) {
  const int layers = arc_body_layers(solid);
  for (int l = 0; l < layers; l++)
    if (strcmp(solid->layer[l].name, name) == 0) return l;
  return -1;
}

static int has_name(const arc_mesh *mesh, const char *name) {
  for (int m = 0; m < mesh->materials; m++)
    if (strcmp(mesh->material_name[m], name) == 0) return 1;
  return 0;
}

static const char *list_names(const arc_mesh *mesh, char text[200]) {
  int n = snprintf(text, 200, "%s", mesh->materials > 0 ? "" : "none");
  for (int m = 0; m < mesh->materials; m++)
    n += snprintf(text + n, (size_t)(200 - n), "%s'%s'", m > 0 ? ", " : "", mesh->material_name[m]);
  return text;
}
_Static_assert(ARC_MESH_MATERIALS *(ARC_TEXT_SIZE + 4) < 200,
               "a list of the material names of a mesh must fit into 200 characters");

/* Checks that every layer is a named material of the mesh. */
static arc_status check_layer(const arc_layer *layer, const arc_mesh *mesh, arc_error *error) {
  const char *role = arc_model_role_name(mesh->body);
  char names[200];
  if (!layer->name[0])
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%s.layers': an imported mesh contains its layers; expected "
                    "'%s.materials' with the names in the mesh: %s",
                    role, role, list_names(mesh, names));
  if (has_name(mesh, layer->name)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%s.materials': expected the names in the mesh, %s, got '%s'", role,
                  list_names(mesh, names), layer->name);
}

static arc_status check_materials(const arc_model_def *def, const arc_mesh *mesh,
                                  arc_error *error) {
  const arc_body_def *solid = &def->body[mesh->body];
  char names[200];
  for (int l = 0; l < arc_body_layers(solid); l++) {
    const arc_status status = check_layer(&solid->layer[l], mesh, error);
    if (status != ARC_OK) return status;
  }
  for (int m = 0; m < mesh->materials; m++)
    if (find_layer(solid, mesh->material_name[m]) < 0)
      return arc_fail(
          error, ARC_ARGUMENT,
          "field '%s.materials': expected a material for each name in the mesh, %s, got none "
          "for '%s'",
          arc_model_role_name(mesh->body), list_names(mesh, names), mesh->material_name[m]);
  return ARC_OK;
}

arc_status arc_given_refuse(const arc_model_def *def, arc_error *error) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const char *role = arc_model_role_name((arc_body)b);
    if (def->body[b].kind == ARC_SOLID_GMSH)
      return arc_fail(
          error, ARC_ARGUMENT,
          "field '%s': expected mesh = \"FILE.msh\" beside body.gmsh{}, because the file defines "
          "the shape of the body",
          role);
    for (int l = 0; l < arc_body_layers(&def->body[b]); l++)
      if (def->body[b].layer[l].name[0])
        return arc_fail(error, ARC_ARGUMENT,
                        "field '%s.materials': expected layers = { { thickness=, material= } }; "
                        "materials need a mesh file with named parts",
                        role);
  }
  return ARC_OK;
}

arc_status arc_given_layers(arc_mesh *mesh, const arc_body_def *solid, arc_error *error) {
  mesh->layer = malloc((size_t)mesh->elements * sizeof(int));
  if (!mesh->layer) return arc_fail(error, ARC_MEMORY, "out of memory for an imported mesh");
  for (int e = 0; e < mesh->elements; e++) {
    const int material = mesh->material ? mesh->material[e] : -1;
    mesh->layer[e] =
        material < 0 ? arc_body_layers(solid) : find_layer(solid, mesh->material_name[material]);
  }
  return ARC_OK;
}

static double area_of(const arc_mesh *mesh, int e) {
  const int *c = &mesh->element[4 * e], corners = arc_mesh_corners(mesh, e);
  double twice = 0;
  for (int k = 0; k < corners; k++) {
    const double *p = &mesh->xy[2 * c[k]], *q = &mesh->xy[2 * c[(k + 1) % corners]];
    twice += p[0] * q[1] - q[0] * p[1];
  }
  return twice / 2;
}

/* Returns the bulk material of a mesh: the unnamed material if any element consists of it,
 * otherwise the named material with the largest area. */
static arc_material bulk_of(const arc_model_def *def, const arc_mesh *mesh) {
  const arc_body_def *solid = &def->body[mesh->body];
  double area[ARC_MESH_MATERIALS] = {0};
  int most = 0;
  for (int e = 0; e < mesh->elements; e++) {
    if (!mesh->material || mesh->material[e] < 0) return def->material[mesh->body];
    area[mesh->material[e]] += area_of(mesh, e);
  }
  for (int m = 1; m < mesh->materials; m++)
    if (area[m] > area[most]) most = m;
  const int layer = find_layer(solid, mesh->material_name[most]);
  return layer < 0 ? def->material[mesh->body] : solid->layer[layer].material;
}

/* --- shapes ----------------------------------------------------------------------------------- */

/* Checks that no element crosses the axis x = 0. */
static arc_status check_across(const arc_mesh *mesh, double width, arc_error *error) {
  for (int e = 0; e < mesh->elements; e++) {
    const int *c = &mesh->element[4 * e], corners = arc_mesh_corners(mesh, e);
    double least = INFINITY, most = -INFINITY;
    for (int k = 0; k < corners; k++) {
      least = fmin(least, mesh->xy[2 * c[k]]);
      most = fmax(most, mesh->xy[2 * c[k]]);
    }
    if (least < -1e-9 * width && most > 1e-9 * width)
      return arc_fail(error, ARC_ARGUMENT,
                      "mesh of the %s: expected mesh lines along the axis x = 0, got an element "
                      "from x = %g to %g mm at y = %g mm",
                      arc_body_name(mesh->body), least, most, mesh->xy[2 * c[0] + 1]);
  }
  return ARC_OK;
}

/* Checks that a body of revolution is on one side of its axis, or symmetric about it. */
static arc_status check_side(const arc_model_def *def, const arc_mesh *mesh, arc_error *error) {
  double least = INFINITY, most = -INFINITY;
  if (def->geometry != ARC_AXISYMMETRIC) return ARC_OK;
  for (int n = 0; n < mesh->nodes; n++) {
    least = fmin(least, mesh->xy[2 * n]);
    most = fmax(most, mesh->xy[2 * n]);
  }
  if (def->axis > 0 && least < -def->axis)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'axis': expected at least %g mm, as the mesh of the %s extends so far "
                    "towards the axis, got %g mm",
                    -least, arc_body_name(mesh->body), def->axis);
  if (def->axis > 0) return ARC_OK;
  if (fabs(least + most) <= 1e-6 * (most - least)) return check_across(mesh, most - least, error);
  return arc_fail(error, ARC_ARGUMENT,
                  "mesh of the %s: expected both halves of the section about the axis x = 0, got x "
                  "from %g to %g mm",
                  arc_body_name(mesh->body), least, most);
}

/* Checks for a hole that the surface nodes of a mesh are near the arc of the given radius,
 * because the chart follows this arc. */
static arc_status check_arc(const arc_model_def *def, const arc_mesh *mesh, arc_error *error) {
  static const double most = 0.05; /* largest distance of a node from the arc, divided by the
                                      radius */
  const chart c = arc_chart_of(def);
  const arc_body_def solid = arc_model_solid(def, mesh->body);
  const double radius = fabs(arc_body_radius(&solid));
  for (int i = 0; c.polar && i < mesh->surface; i++) {
    const double *at = &mesh->xy[2 * mesh->surface_node[i]];
    const double r = hypot(at[0], c.side * at[1] - radius);
    if (!(fabs(r - radius) <= most * radius))
      return arc_fail(error, ARC_ARGUMENT,
                      "mesh of the %s: expected contact nodes within 5 %% of the radius %g mm of "
                      "'%s', got one at %g mm, (%g, %g) mm",
                      arc_body_name(mesh->body), radius, arc_model_role_name(mesh->body), r, at[0],
                      at[1]);
  }
  return ARC_OK;
}

/* --- the definition ------------------------------------------------------------------------ */

/* Returns the definition with the element sizes, zones and bulk materials of the imported
 * meshes. */
static arc_model_def fit_to(const arc_model_def *def, arc_mesh *const given[ARC_BODIES]) {
  arc_model_def fit = *def;
  const arc_mesh_def *upper = &given[ARC_CYLINDER]->def, *lower = &given[ARC_PLATE]->def;
  fit.mesh.size = fit.mesh.height = fmin(upper->size, lower->size);
  fit.mesh.far = fmax(upper->far, lower->far);
  fit.mesh.fineness = 0; /* 0: the element sizes are not chosen from the contact */
  for (int b = 0; b < ARC_BODIES; b++) {
    fit.mesh.zone[b] = given[b]->def.zone[b];
    fit.material[b] = bulk_of(def, given[b]);
  }
  return fit;
}

arc_status arc_given_settle(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                            arc_model_def *settled, arc_error *error) {
  *settled = fit_to(def, given);
  arc_status status = arc_settings_check(arc_model_settings, "", settled, error);
  if (status == ARC_OK && !arc_kind_of(def->geometry)->mesh)
    status = arc_fail(error, ARC_ARGUMENT, "field 'geometry': bodies in \"%s\" have no meshes",
                      arc_space_names[def->geometry]);
  if (status == ARC_OK) status = arc_model_check_given_pair(settled, error);
  for (int b = 0; status == ARC_OK && b < ARC_BODIES; b++) {
    status = arc_given_check_shape(def, (arc_body)b, error);
    if (status == ARC_OK) status = check_materials(def, given[b], error);
    if (status == ARC_OK) status = check_side(settled, given[b], error);
    if (status == ARC_OK) status = check_arc(settled, given[b], error);
  }
  return status;
}

arc_status arc_model_check_given(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                                 arc_error *error) {
  arc_model_def settled;
  return arc_given_settle(def, given, &settled, error);
}

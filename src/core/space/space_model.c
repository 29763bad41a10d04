/* Models of half-spaces: checks of the definition, and creation of the bodies and their cells. */
#include "core/space/space_kind.h"

#include "core/base/callbacks.h"
#include "core/elastic/pair.h"
#include "core/space/halfspace.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static const double usual_cells = 8;       /* cells in the half width of the unworn contact */
static const double widest_of_layer = 3.5; /* largest default cell size divided by the thickness of
                                              the thinnest layer; the user may choose up to 4 */

typedef struct space_model {
  arc_model handle;
  double *series[ARC_BODIES]; /* copies of the coordinates and heights of maps */
} space_model;

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status refuse(arc_error *error, const char *field, const char *expected) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': with geometry = \"3-D\" expected %s", field,
                  expected);
}

static arc_status check_body(const arc_model_def *def, arc_body body, arc_error *error) {
  const arc_body_def solid = arc_model_solid(def, body), *own = &def->body[body];
  if (!arc_body_is_spatial(&solid) && !arc_body_is_flat(&solid))
    return refuse(
        error, arc_model_role_name(body),
        "a body.ball{}, body.map{} or body.block{} (a flat pin is a map with rounded edges, a ball "
        "in its socket a joint{})");
  if (own->width > 0)
    return refuse(error, body == ARC_LOWER ? "lower.width" : "upper.width",
                  "none: blocks have no width");
  if (own->height > 0 && arc_body_interface(own, arc_body_layers(own) - 1) >= own->height)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%s.height': expected more than the %g mm of its layers, got %g mm",
                    arc_model_role_name(body), arc_body_interface(own, arc_body_layers(own) - 1),
                    own->height);
  return ARC_OK;
}

static arc_status check_sizes(const arc_model_def *def, arc_error *error) {
  const arc_mesh_def *mesh = &def->mesh;
  const arc_mesh_def usual = arc_mesh_default();
  if (def->thickness != 1)
    return refuse(error, "thickness",
                  "none: bodies in 3-D have no "
                  "thickness");
  if (def->axis != 0) return refuse(error, "axis", "none");
  if (mesh->height > 0) return refuse(error, "mesh.height", "none: cells lie on the surface");
  if (mesh->far > 0) return refuse(error, "mesh.far", "none: cells lie on the surface");
  if (mesh->rows != usual.rows && mesh->rows != 0)
    return refuse(error, "mesh.rows", "none: cells lie on the surface");
  if (mesh->element != ARC_ELEMENT_AUTO)
    return refuse(error, "mesh.element", "none: half-spaces have cells, no elements");
  if (mesh->zone[ARC_UPPER] > 0 || mesh->zone[ARC_LOWER] > 0)
    return refuse(error, "mesh.zone", "none: windows are enlarged automatically");
  return ARC_OK;
}

/* Computes the curvatures of a body along x and z [1/mm]. For a map they are the curvatures of
 * the best-fitting parabola. */
static void body_curvatures(const arc_model_def *def, arc_body body, double *x, double *z) {
  const arc_body_def solid = arc_model_solid(def, body);
  *x = *z = 0;
  if (!arc_body_is_spatial(&solid)) return;
  if (arc_body_is_map(&solid)) arc_body_map_curvature(&solid, x, z);
  if (solid.radius > 0) *x += 1 / solid.radius;
  if (solid.radius_z > 0) *z += 1 / solid.radius_z;
}

/* Computes the relative curvatures of the pair along x and z [1/mm]. */
static void find_curvatures(const arc_model_def *def, double *x, double *z) {
  *x = *z = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    double of_x, of_z;
    body_curvatures(def, (arc_body)b, &of_x, &of_z);
    *x += of_x;
    *z += of_z;
  }
}

double arc_space_lower_share(const arc_model_def *def, int turned) {
  double x, z, lower_x, lower_z;
  find_curvatures(def, &x, &z);
  body_curvatures(def, ARC_LOWER, &lower_x, &lower_z);
  const double share = turned ? lower_z / z : lower_x / x;
  return fmax(0, fmin(1, share));
}

/* Returns the largest curvature along each axis [1/mm]: of a body, or the relative curvature. */
static void largest_curvatures(const arc_model_def *def, double *x, double *z) {
  find_curvatures(def, x, z);
  for (int b = 0; b < ARC_BODIES; b++) {
    double of_x, of_z;
    body_curvatures(def, (arc_body)b, &of_x, &of_z);
    *x = fmax(*x, fabs(of_x));
    *z = fmax(*z, fabs(of_z));
  }
}

static arc_status check_curvature(const arc_model_def *def, arc_error *error) {
  static const double conformal = 0.1; /* smallest accepted ratio of the relative curvature to the
                                          largest curvature of a body */
  double x, z, most_x, most_z;
  find_curvatures(def, &x, &z);
  largest_curvatures(def, &most_x, &most_z);
  if (x > 0 && z > 0 && fmax(x, z) < conformal * fmax(most_x, most_z))
    return arc_fail(error, ARC_GEOMETRY,
                    "field 'upper': with geometry = \"3-D\" expected radii that differ by at least "
                    "a tenth of the "
                    "larger one; for a ball in a socket of nearly the same radius use joint{}");
  if (x > 0 && z > 0) return ARC_OK;
  return arc_fail(error, ARC_GEOMETRY,
                  "field 'upper': with geometry = \"3-D\" expected surfaces between which the gap "
                  "grows on all sides, got relative radii of %g mm along x and %g mm along z; "
                  "give a map the radius of its ball, or subtract its form (t:level)",
                  1 / x, 1 / z);
}

arc_status arc_space_check_model(const arc_model_def *def, arc_error *error) {
  arc_status status = arc_settings_check(arc_model_settings, "", def, error);
  if (status == ARC_OK) status = check_sizes(def, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = check_body(def, (arc_body)b, error);
  const arc_body_def upper = arc_model_solid(def, ARC_UPPER),
                     lower = arc_model_solid(def, ARC_LOWER);
  if (status == ARC_OK && arc_body_is_flat(&upper) && arc_body_is_flat(&lower))
    return refuse(error, "upper", "a body.ball{} or body.map{} on one side");
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) {
    const arc_body_def solid = arc_model_solid(def, (arc_body)b);
    if (arc_body_is_map(&solid))
      status = arc_body_check(&solid, b == ARC_UPPER ? "upper." : "lower.", error);
  }
  if (status != ARC_OK) return status;
  return def->periodic ? arc_space_check_periodic(def, error) : check_curvature(def, error);
}

/* --- models ----------------------------------------------------------------------------------- */

arc_status arc_space_build(const arc_model_def *def, const arc_callbacks *callbacks,
                           arc_model **result, arc_error *error) {
  (void)callbacks;
  *result = NULL;
  const arc_status status = arc_space_check_model(def, error);
  if (status != ARC_OK) return status;
  space_model *model = calloc(1, sizeof *model);
  if (!model) return arc_fail(error, ARC_MEMORY, "out of memory for a model");
  model->handle = (arc_model){.kind = arc_kind_of(def->geometry), .references = 1, .def = *def};
  *result = &model->handle;
  arc_status kept = ARC_OK;
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_body_keep_series(&model->handle.def.body[b], &model->series[b]) != ARC_OK)
      kept = ARC_MEMORY;
  if (kept == ARC_OK) return ARC_OK;
  arc_space_end_model(*result);
  *result = NULL;
  return arc_fail(error, ARC_MEMORY, "out of memory for a map");
}

void arc_space_end_model(arc_model *model) {
  space_model *m = (space_model *)(void *)model;
  for (int b = 0; b < ARC_BODIES; b++) free(m->series[b]);
  free(m);
}

size_t arc_space_model_bytes(const arc_model *model) {
  size_t points = 0;
  for (int b = 0; b < ARC_BODIES; b++) points += (size_t)model->def.body[b].y_series.count;
  return sizeof(space_model) + 2 * points * sizeof(double);
}

/* --- bodies and cells ------------------------------------------------------------------------- */

/* Returns the recess of a map at x and z (an arc_recess_fn). The context is the body's
 * definition. */
static double recess_of(void *context, double x, double z) {
  return -arc_body_map_height(context, x, z);
}

arc_halfspace_def arc_space_bodies(const arc_model_def *def) {
  arc_halfspace_def d = {.periodic = def->periodic == ARC_ON};
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_body_def solid = arc_model_solid(def, (arc_body)b);
    d.body[b].material = def->material[b];
    for (int l = 0; l < ARC_MOST_LAYERS; l++) d.body[b].layer[l] = solid.layer[l];
    d.body[b].depth = def->body[b].height; /* distance from the surface to a rigid base */
    if (!arc_body_is_spatial(&solid)) continue;
    d.body[b].radius_x = solid.radius;
    d.body[b].radius_z = solid.radius_z;
    if (!arc_body_is_map(&solid)) continue;
    d.body[b].recess = def->periodic ? arc_space_period_height : recess_of;
    d.body[b].context = (void *)(uintptr_t)&def->body[b];
  }
  return d;
}

arc_hertz_ellipse arc_space_hertz(const arc_model_def *def, double load) {
  arc_hertz_ellipse hertz = {0, 0, 0, 0};
  double x, z;
  if (def->periodic) return arc_space_period(def, load);
  find_curvatures(def, &x, &z);
  const arc_halfspace_def bodies = arc_space_bodies(def);
  arc_space_estimate(&bodies, 1 / x, 1 / z, load, &hertz);
  return hertz;
}

double arc_space_cell(const arc_model_def *def, double load) {
  if (def->mesh.size > 0) return def->mesh.size;
  if (def->periodic) return arc_space_period_step(def);
  const arc_hertz_ellipse hertz = arc_space_hertz(def, load);
  const double finer = def->mesh.fineness > 0 ? def->mesh.fineness : 1;
  const double size = fmin(hertz.half_width, hertz.half_width_z) / usual_cells;
  const arc_halfspace_def bodies = arc_space_bodies(def);
  const double thinnest = arc_space_thinnest(&bodies);
  return (thinnest > 0 ? fmin(size, widest_of_layer * thinnest) : size) / finer;
}

void arc_space_fit(const arc_model_def *def, int turned, double load, double volume, double stroke,
                   double increment, arc_halfspace_def *cells) {
  if (def->periodic) {
    *cells = arc_space_bodies(def);
    arc_space_period_cells(def, turned, cells);
    return;
  }
  const arc_hertz_ellipse hertz = arc_space_hertz(def, load);
  const double least = fmin(hertz.half_width, hertz.half_width_z);
  arc_halfspace_def smooth = arc_space_bodies(def);
  double x, z;
  find_curvatures(def, &x, &z);
  smooth.turned = turned;
  smooth.body[ARC_UPPER].radius_x = 1 / x;
  smooth.body[ARC_UPPER].radius_z = 1 / z;
  smooth.body[ARC_LOWER].radius_x = smooth.body[ARC_LOWER].radius_z = 0;
  arc_halfspace_fit(&smooth, load, volume, stroke, increment, least / arc_space_cell(def, load));
  *cells = arc_space_bodies(def);
  cells->size_x = smooth.size_x;
  cells->size_z = smooth.size_z;
  cells->nx = smooth.nx;
  cells->nz = smooth.nz;
  cells->track = smooth.track;
  cells->turned = turned;
  arc_space_limit(def, cells);
}

/* Returns the largest odd number of cells whose centres lie within `half` [mm] of 0, but at
 * least 9. */
static int cells_within(double half, double size) {
  return 2 * (int)fmax(4, fmin(floor(half / size + 1e-9), 1e6)) + 1;
}

void arc_space_limit(const arc_model_def *def, arc_halfspace_def *cells) {
  if (def->periodic) return;
  const int beyond = cells->track > 0 ? cells->track - cells->nx : 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    double half_x, half_z, step;
    if (!arc_body_is_map(&def->body[b])) continue;
    arc_body_map_extent(&def->body[b], &half_x, &half_z, &step);
    double along = cells->turned ? half_z : half_x, across = cells->turned ? half_x : half_z;
    if (b == ARC_LOWER && cells->groove == 0) along -= beyond / 2 * cells->size_x;
    cells->nx = (int)fmin(cells->nx, cells_within(along, cells->size_x));
    cells->nz = (int)fmin(cells->nz, cells_within(across, cells->size_z));
  }
  if (cells->groove == 0) cells->track = cells->nx + beyond;
}

/* Limits the new window to the maps of the bodies. Returns ARC_ZONE if neither it nor the track is
 * larger than before. */
static arc_status check_larger(const arc_model_def *def, arc_halfspace_def before,
                               arc_halfspace_def *cells, arc_error *error) {
  arc_space_limit(def, cells);
  if (cells->nx >= before.nx && cells->nz >= before.nz &&
      (cells->nx > before.nx || cells->nz > before.nz || cells->track > before.track))
    return ARC_OK;
  return arc_fail(error, ARC_ZONE,
                  "the contact reaches the end of the part of a map that is symmetric about x = z "
                  "= 0, %.3g x %.3g mm at any position: expected a larger map with its centre "
                  "there (t:center()), or less load, stroke or distance",
                  before.nx * before.size_x, before.nz * before.size_z);
}

arc_status arc_space_widen(const arc_model_def *def, int part, arc_halfspace_def *cells,
                           arc_error *error) {
  const arc_halfspace_def before = *cells;
  const int beyond = cells->track > 0 ? cells->track - cells->nx : 0;
  cells->nx += 2 * (cells->nx / part + 2);
  cells->nz += 2 * (cells->nz / part + 2);
  if (cells->groove == 0) cells->track = cells->nx + beyond;
  return check_larger(def, before, cells, error);
}

arc_status arc_space_extend_cells(const arc_model_def *def, int rows, int beyond,
                                  arc_halfspace_def *cells, arc_error *error) {
  const arc_halfspace_def before = *cells;
  cells->nx += rows;
  cells->track = cells->nx + beyond;
  return check_larger(def, before, cells, error);
}

int arc_space_warn_steep(const arc_model_def *def, double half_x, double half_z,
                         const arc_callbacks *callbacks) {
  static const double small =
      0.2; /* ratio of half width to radius above which slopes are no longer small */
  double x, z;
  if (def->periodic) return 0;
  largest_curvatures(def, &x, &z);
  const int along = half_x * x >= half_z * z;
  const double half = along ? half_x : half_z, curvature = along ? x : z;
  if (!(half * curvature > small)) return 0;
  if (callbacks)
    arc_warn(callbacks,
             "the contact's half width %.3g mm along %s is %.2g of the radius %.3g mm: half-spaces "
             "are accurate up to %g of it, and beyond that pressures and depths are estimates",
             half, along ? "x" : "z", half * curvature, 1 / curvature, small);
  return 1;
}

void arc_space_warn(const arc_model_def *def, const arc_halfspace_def *cells, double half_width,
                    double half_z, const arc_callbacks *callbacks) {
  const double fewest = 4;          /* smallest number of cells in the half width */
  static const double coarse = 1.5; /* largest ratio of the cell width to the step of a map */
  if (def->periodic) return;
  arc_space_warn_steep(def, half_width, half_z, callbacks);
  if (half_width < fewest * cells->size_x)
    arc_warn(callbacks,
             "the contact's half width %.3g mm has fewer than %g cells of %.3g mm: use mesh.size = "
             "\"auto\" or a smaller one",
             half_width, fewest, cells->size_x);
  for (int b = 0; b < ARC_BODIES; b++) {
    double x, z, step;
    if (!arc_body_is_map(&def->body[b])) continue;
    arc_body_map_extent(&def->body[b], &x, &z, &step);
    if (cells->size_x > coarse * step)
      arc_warn(callbacks,
               "cells of %.3g mm are wider than the steps of the %s body's map, %.3g mm: finer "
               "roughness is neglected; use a smaller mesh.size",
               cells->size_x, arc_model_role_name((arc_body)b), step);
  }
}

/* Functions of the pair kind "plane": two meshed bodies whose contact is a line of nodes. */
#include "core/base/callbacks.h"
#include "core/base/carve.h"
#include "core/pair/units.h"
#include "core/plane/newton.h"
#include "core/plane/solution.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- data of a run */

static arc_status begin(arc_wear *w) {
  plane_cycle *own = w->own = calloc(1, sizeof *own);
  if (!own) return ARC_MEMORY;
  w->nc = arc_model_mesh(w->model, ARC_CYLINDER)->surface;
  w->np = arc_model_mesh(w->model, ARC_PLATE)->surface;
  const size_t n = (size_t)(w->nc + w->np);
  const carve_part parts[] = {{&own->slip, 4 * n},
                              {&own->down, n},
                              {&own->width, n},
                              {&own->plate, (size_t)w->np},
                              {&own->below, (size_t)w->nc}};
  if (!ARC_CARVE(parts)) return ARC_MEMORY;
  if (arc_path_create(&own->path, w->model, arc_wear_has_friction(&w->def)) != ARC_OK)
    return ARC_MEMORY;
  return arc_contact_problem_create(&own->reference, w->model);
}

static void end(arc_wear *w) {
  plane_cycle *own = w->own;
  if (!own) return;
  arc_path_free(&own->path);
  arc_contact_problem_free(&own->reference);
  free(own->slip);
  free(own);
  w->own = NULL;
}

static size_t bytes(const arc_wear *w) {
  const plane_cycle *own = w->own;
  const wear_path *path = &own->path;
  const size_t n = (size_t)(w->nc + w->np), problems = (size_t)path->problems;
  size_t sum = (problems + 1) * arc_contact_problem_bytes(&own->reference) +
               22 * n * sizeof(double) + 2 * arc_shape_bytes(w->shape);
  if (path->compliance) sum += problems * arc_tangential_bytes(&path->compliance[0]);
  if (path->has_friction) sum += arc_friction_workspace_bytes(&path->workspace);
  return sum + (w->start.tangent ? arc_tangent_bytes(w) : 0);
}

/* --- checks of positions */

/* Stores the indices of the extreme points of a block: the smallest and the largest position of the
 * plate, of the load, and of the load relative to the plate. Returns the number of indices, which
 * is 2 if the load angle is always 0. */
enum { ENDS = 6 };
static int find_ends(const wear_block *block, double radius, int end[ENDS]) {
  int turns = 0;
  memset(end, 0, ENDS * sizeof *end);
  for (int i = 0; i < block->count; i++) {
    const double under = radius * block->angle[i];
    const double at[] = {block->x[i], under, under - block->x[i]};
    turns = turns || under != 0;
    for (int k = 0; k < ENDS; k++) {
      const double best = radius * block->angle[end[k]];
      const double then[] = {block->x[end[k]], best, best - block->x[end[k]]};
      if (k % 2 ? at[k / 2] > then[k / 2] : at[k / 2] < then[k / 2]) end[k] = i;
    }
  }
  return turns ? ENDS : 2;
}

/* Composes the error message for zones that are wider than the bodies allow. Returns ARC_ZONE. */
static arc_status refuse_zones(const arc_model_def *def, const double zone[ARC_BODIES],
                               const arc_error *why, arc_error *error) {
  const double degrees = 0.5 * arc_model_widest_zone(def, ARC_PLATE) / arc_model_arc_length(def, 1);
  char angle[100] = "", doubt[120];
  if (arc_model_is_hole(def))
    snprintf(angle, sizeof angle,
             ": %.0f degrees to either side for the contact during the rotation", degrees);
  arc_units_doubt(def, doubt, sizeof doubt);
  return arc_fail(error, ARC_ZONE,
                  "%s (this run needs zones of %.6g and %.6g mm, larger than the bodies allow, "
                  "%.6g and %.6g mm%s%s)",
                  why->message, zone[ARC_CYLINDER], zone[ARC_PLATE],
                  arc_model_widest_zone(def, ARC_CYLINDER), arc_model_widest_zone(def, ARC_PLATE),
                  angle, doubt);
}

/* Reports an error at an extreme point of a path. If a zone is too narrow, the message includes
 * the required widths. */
static arc_status refuse_reach(const arc_wear *w, const arc_error *why, arc_error *error) {
  if (why->status != ARC_ZONE) return arc_fail(error, why->status, "%s", why->message);
  const arc_model_def *def = arc_model_definition(w->model);
  double zone[ARC_BODIES];
  arc_wear_zones(&w->def, def, zone);
  for (int b = 0; b < ARC_BODIES; b++)
    if (zone[b] > arc_model_widest_zone(def, (arc_body)b))
      return refuse_zones(def, zone, why, error);
  return arc_fail(error, ARC_ZONE,
                  "%s (this run needs mesh.zone = {cylinder = %.2f, plate = %.2f} mm)",
                  why->message, zone[ARC_CYLINDER], zone[ARC_PLATE]);
}

/* Checks for a new run that the zones contain the contact at the extreme positions. */
static arc_status check_reach(arc_wear *w, arc_error *error) {
  const arc_wear_record unworn = {0};
  arc_error why = {0};
  for (int b = 0; b < w->blocks && w->manner.procedure == ARC_SP; b++) {
    int end[ENDS];
    const double radius = arc_model_body(w->model, ARC_UPPER)->chart.radius;
    const int ends = find_ends(&w->block[b], radius, end);
    for (int e = 0; e < ends; e++) {
      const wear_window point = {.block = &w->block[b],
                                 .shape = w->shape,
                                 .first = end[e],
                                 .last = end[e],
                                 .state = &unworn};
      if (arc_wear_probe(w, &point, &why) != ARC_OK) return refuse_reach(w, &why, error);
    }
  }
  return ARC_OK;
}

/* --- functions of the kind -------------------------------------------------------------------- */

static arc_status start_shape(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                              arc_shape **shape, arc_error *error) {
  arc_status status;
  *shape = NULL;
  if (start && arc_shape_model(start) != model)
    return arc_fail(error, ARC_ARGUMENT, "worn: the starting shape belongs to another model");
  if (start)
    status = arc_shape_clone(start, shape, error);
  else
    status = arc_shape_create(model, def->geometry, def->refresh, shape, error);
  if (status == ARC_OK) status = arc_shape_set_geometry(*shape, def->geometry, def->refresh, error);
  if (status == ARC_OK) arc_shape_set_corrections(*shape, def->corrections);
  if (status != ARC_OK) arc_shape_destroy(shape);
  return status;
}

static wear_sites sites(const arc_shape *shape, arc_body body) {
  const shape_side *side = &shape->side[body];
  return (wear_sites){side->n, side->x0, side->h, NULL};
}

static double area(const arc_shape *shape, arc_body body, int i) {
  return arc_shape_width(&shape->side[body], i);
}

static void warn(const arc_wear *w, int unworn, const arc_callbacks *callbacks) {
  double mu;
  if (unworn) arc_model_warn(w->model, w->def.load, arc_wear_last(w)->half_width, callbacks);
  arc_plane_warn_leaps(w, callbacks);
  if (unworn && arc_wear_friction(w, arc_wear_last(w), &mu, NULL) == ARC_OK)
    arc_friction_warn(w->model, mu, "wear", callbacks);
}

/* Warns if the slip zones are narrower than two elements. Returns true after a warning. The
 * volumes after 10000 cycles had errors of 9 to 35 % with 0.5 to 1.6 elements in a slip zone,
 * and of 3 to 8 % with 3 to 4 elements. The errors of the energies were twice as large. */
static int warn_of_rim(const arc_wear *w, double size, const arc_callbacks *callbacks) {
  static const double enough = 5, few = 2;
  const arc_wear_record *now = arc_wear_last(w);
  const double rim = fmax(0, now->half_width - now->stick_width / 2);
  if (now->gross != 0 || now->stick_width == 0 || rim >= few * size) return 0;
  arc_warn(
      callbacks,
      "the surfaces slip over %.2g mm at either edge of the contact, %.2g elements of %.2g mm: "
      "volumes and energies may be off by a third; mesh.size = %.2g resolves the slip zones",
      rim, rim / size, size, fmax(rim, size / 4) / enough);
  return 1;
}

/* Warns if exposed layers are narrower than three elements. Returns true after a warning. A coating
 * that wears ten times more slowly than its base caused errors of the pressure in the centre of up
 * to 8.5 % with 1.5 to 2 elements, and of 3 % with 3. */
static int warn_of_layers(const arc_wear *w, double size, const arc_callbacks *callbacks) {
  static const double few_in_layer = 3, becomes_narrower = 2;
  const double width = arc_wear_exposed_width(w);
  if (width >= few_in_layer * size) return 0;
  arc_warn(
      callbacks,
      "a layer is worn through, and %.2g mm of it carry load at either edge of the scar, %.2g "
      "elements of %.2g mm: pressures may be off by 10 %%; mesh.size = %.2g resolves the layer",
      width, width / size, size, width / few_in_layer / becomes_narrower);
  return 1;
}

/* Warns if a body has worn to a flat whose radius has too few elements. Returns true after a
 * warning. The load acts on the rings of the nodes in contact, so that the pressure drops by twice
 * the size over the radius when a node enters the contact, half of it on either side of the true
 * pressure. */
static int warn_of_flat(const arc_wear *w, double size, const arc_callbacks *callbacks) {
  static const double much = 0.03;
  const double off = size / arc_wear_last(w)->half_width;
  const int ball = arc_model_definition(w->model)->geometry == ARC_AXISYMMETRIC;
  if (!ball || off < much || !arc_wear_is_uniform(w)) return 0;
  arc_warn(callbacks,
           "the contact has worn flat, and its edge moves from node to node: pressures scatter by "
           "about %.2g %%, and by three times as much while a node enters the contact; volumes are "
           "exact; a larger mesh.fineness or a smaller mesh.size reduces this",
           100 * off);
  return 1;
}

static int warn_late(const arc_wear *w, int given, const arc_callbacks *callbacks) {
  if (given) return given;
  const shape_side *side = &w->shape->side[ARC_CYLINDER];
  const double size = arc_shape_width(side, side->n / 2);
  return warn_of_rim(w, size, callbacks) || warn_of_layers(w, size, callbacks) ||
         warn_of_flat(w, arc_model_definition(w->model)->mesh.size, callbacks);
}

static int must_grow(const arc_wear *w, arc_error *why) {
  const int deeper = arc_wear_layer_rows(w) > 0;
  if (!deeper && !arc_wear_must_refine(w)) return 0;
  arc_fail(why, ARC_GEOMETRY, "%s",
           deeper ? "the plate's layers end below its wear box"
                  : "exposed layers are narrower than the elements");
  return 1;
}

static void report_mesh(const arc_wear *before, const arc_wear *now,
                        const arc_callbacks *callbacks) {
  arc_wear_report_meshes(before, now, "the user changed the mesh", callbacks);
}

static arc_status contact(const arc_wear *w, arc_contact **result, arc_error *error) {
  arc_contact_def def = arc_contact_default();
  def.load = w->def.load;
  def.load_angle = w->def.load_angle;
  return arc_contact_solve(w->shape, &def, NULL, result, error);
}

static const arc_growth growth = {
    .must_grow = must_grow,
    .has_outgrown = arc_wear_has_outgrown,
    .can_grow = arc_wear_can_grow,
    .grow = arc_wear_grow,
    .remesh = arc_wear_remesh,
    .resolve = arc_wear_resolve,
    .report = arc_wear_report_growth,
    .report_mesh = report_mesh,
    .refuse = arc_wear_refuse,
};

const arc_kind arc_plane_kind = {
    .name = "plane",
    .elastic = 1,
    .check_model = arc_elastic_check,
    .build = arc_elastic_build,
    .end_model = arc_elastic_destroy,
    .model_bytes = arc_elastic_bytes,
    .mesh = arc_elastic_mesh,
    .prefers_implicit = arc_plane_prefers_implicit,
    .check = arc_plane_check,
    .manner = arc_plane_manner,
    .increments = arc_wear_def_increments,
    .parts = arc_loading_increments,
    .reach = arc_wear_reach,
    .begin = begin,
    .end = end,
    .bytes = bytes,
    .check_reach = check_reach,
    .warn = warn,
    .warn_late = warn_late,
    .surfaces = start_shape,
    .unworn = arc_meshed_create,
    .copy = arc_meshed_copy,
    .discard = arc_meshed_discard,
    .sites = sites,
    .area = area,
    .profile = arc_meshed_profile,
    .deepest = arc_meshed_depth,
    .through_layers = arc_wear_into_layers,
    .add_volumes = arc_plane_add_volumes,
    .look_ahead = arc_plane_look_ahead,
    .wear = arc_plane_wear,
    .measure = arc_plane_measure,
    .rate = arc_wear_evaluate,
    .ripple = arc_plane_ripple,
    .loop = arc_wear_fret_loop,
    .tangent = arc_tangent_create,
    .end_tangent = arc_tangent_free,
    .eigenvalue = arc_tangent_eigenvalue,
    .begin_stages = arc_newton_begin,
    .start = arc_newton_start,
    .stage = arc_newton_solve,
    .error = arc_newton_error,
    .end_stages = arc_newton_end,
    .natural_depth = arc_plane_natural_depth,
    .even_k_integral = arc_plane_even_k_integral,
    .layer_k_integral = arc_plane_layer_k_integral,
    .open_share = arc_plane_open_share,
    .growth = &growth,
    .solve = arc_plane_solve,
    .move = arc_plane_move,
    .end_contact = arc_plane_end_contact,
    .contact_bytes = arc_plane_contact_bytes,
    .show_contact = arc_plane_show_contact,
    .contact = contact,
    .show = arc_plane_show,
    .save = arc_plane_save,
    .load = arc_plane_load,
    .roughness = arc_plane_roughness,
    .validate = arc_plane_validate,
};

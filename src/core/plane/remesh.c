/* Remeshing of runs that outgrow their meshes. Both bodies are meshed again, wider, deeper or
 * coarser, and the worn surfaces are interpolated. The new meshes depend only on the state of
 * the run, so a stored run that is continued has the same meshes. */
#include "core/base/callbacks.h"
#include "core/elastic/contact_estimate.h"
#include "core/plane/cycle.h"

#include <math.h>
#include <string.h>

/* `wider` is the increase of both zones, divided by the width of the cylinder's zone. The depth
 * of the wear box is multiplied by `deeper`. */
static const double wider = 1, deeper = 2;

/* Automatic element sizes change by the factor `ratio`, the square root of 2. */
static const double ratio = 1.41421356237309504880;

/* Automatic element sizes grow with the contact. They become larger by `ratio` if a contact has
 * `rich` times as many elements as an unworn contact. In the case of a ring that wears a block to
 * 25 half widths, the depth differs from the rigid limit by 0.02 % with rich = 4 and by 0.05 % with
 * rich = 3. With elements of size h, a transfer to larger elements loses the fraction h^2/(8 b^2)
 * of the area of a scar of half width b, which is 0.04 % (0.12 % for sizes doubled at once).
 * Scaling of the depths restores this area.
 *
 * Where the bodies conform to each other, the pressure is nearly uniform up to kinks at the edges.
 * Its error is then that of the contact's width, which changes from node to node. Such contacts
 * have `full` times as many elements: a cylinder that wears alone to ten half widths has errors of
 * the centre pressure of 1.1 % with full = 2, and of 2.3 % with full = 1. */
static const double rich = 4, full = 2;

/* --- checks of the present mesh */

/* Returns the half width [mm] of the part of a surface that is deeper than 1 % of the largest
 * depth. */
static double worn_half(const arc_wear *w, arc_body b) {
  static const double edge = 0.01; /* depth at the edge of this part, relative to the largest
                                      depth */
  const shape_side *side = &w->shape->side[b];
  const double least = edge * arc_shape_depth(w->shape, b);
  double half = 0;
  for (int i = 0; i < side->n; i++)
    if (side->h[i] > least) half = fmax(half, fabs(side->settled[2 * i]));
  return half;
}

/* Returns true if the contact has grown gradually to the edge of its zone. Returns false after a
 * sudden increase, which is due to a step that is too long; a larger mesh would hide this error. */
static int has_grown_into_zone(const arc_wear *w) {
  static const double share = 0.4; /* smallest ratio of the contact's extent to the zone width
                                      that counts as grown to the edge */
  const arc_mesh_def *mesh = &arc_model_definition(w->model)->mesh;
  const arc_wear_record *last = arc_wear_last(w);
  double most[ARC_BODIES] = {last->half_width, last->half_width};
  const double radius = arc_model_body(w->model, ARC_UPPER)->chart.radius;
  for (int b = 0; b < w->blocks; b++)
    for (int i = 0; i < w->block[b].count; i++) {
      const double under = radius * w->block[b].angle[i], x = w->block[b].problem_x[i];
      most[ARC_CYLINDER] = fmax(most[ARC_CYLINDER], last->half_width + fabs(under));
      most[ARC_PLATE] = fmax(most[ARC_PLATE], last->half_width + fabs(under - x));
    }
  for (int b = 0; b < ARC_BODIES && !w->manner.even; b++)
    most[b] = fmax(most[b], worn_half(w, (arc_body)b));
  return 2 * most[ARC_CYLINDER] > share * mesh->zone[ARC_CYLINDER] ||
         2 * most[ARC_PLATE] > share * mesh->zone[ARC_PLATE];
}

/* Returns true if the wear that changes the shape of a body is deeper than `share` times the
 * depth of the wear box. */
static int is_deep(const arc_wear *w, double share) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const shape_side *side = &w->shape->side[b];
    const double depth = arc_shape_depth(w->shape, (arc_body)b) - side->even;
    if (depth > share * arc_shape_box_depth(side)) return 1;
  }
  return 0;
}

/* Returns the width [mm] of the surface on each side of a scar whose wear depth is between `from`
 * and `to`. Depths are linear between nodes. */
static double width_between(const shape_side *side, double from, double to) {
  double width = 0;
  for (int i = 0; i + 1 < side->n; i++) {
    const double a = fmin(side->h[i], side->h[i + 1]), b = fmax(side->h[i], side->h[i + 1]);
    const double dx = side->settled[2 * (i + 1)] - side->settled[2 * i];
    if (b > a) width += dx * fmax(0, fmin(b, to) - fmax(a, from)) / (b - a);
  }
  return width / 2;
}

/* Returns true if layer j of a body wears more slowly than the material below. */
static int wears_slowly(const arc_model_def *def, int b, int j) {
  const arc_body_def *body = &def->body[b];
  return arc_body_layer_material(body, j, def->material[b]).k <
         arc_body_layer_material(body, j + 1, def->material[b]).k;
}

double arc_wear_exposed_width(const arc_wear *w) {
  const arc_model_def *def = arc_model_definition(w->model);
  double least = INFINITY;
  for (int b = 0; b < ARC_BODIES; b++) {
    double above = 0;
    for (int j = 0; j < arc_body_layers(&def->body[b]); j++) {
      const double below = arc_body_interface(&def->body[b], j);
      const double width = width_between(&w->shape->side[b], above, below);
      const int through = arc_shape_depth(w->shape, (arc_body)b) > below;
      if (width > 0 && through && wears_slowly(def, b, j)) least = fmin(least, width);
      above = below;
    }
  }
  return least;
}

/* Returns the largest element size [mm] that resolves the exposed layers, but not less than the
 * smallest automatic size. */
static double exposed_layer_size(const arc_wear *w) {
  static const double exposed = 1.5; /* least number of elements in an exposed layer */
  const arc_mesh_def *mesh = &arc_model_definition(w->model)->mesh;
  const double zone = fmax(mesh->zone[ARC_CYLINDER], mesh->zone[ARC_PLATE]);
  return fmax(arc_wear_exposed_width(w) / exposed, arc_wear_least_size(zone));
}

/* Returns true if exposed layers have become too narrow for the elements of an automatic mesh. */
static int is_coarse(const arc_wear *w, const arc_mesh_def *mesh) {
  return mesh->fineness > 0 && mesh->size * mesh->fineness > exposed_layer_size(w);
}

int arc_wear_must_refine(const arc_wear *w) {
  return !arc_model_is_given(w->model) && is_coarse(w, &arc_model_definition(w->model)->mesh);
}

/* Limits of the wear depth divided by the depth of the wear box. Above `deep` the run has outgrown
 * its box. Above `soon_deep` every new mesh has a deeper box. */
static const double deep = 1 / 3.0, soon_deep = 1 / 6.0;

int arc_wear_layer_rows(const arc_wear *w) {
  return w->manner.even && w->def.track == 0 ? arc_shape_layer_rows(w->shape, ARC_PLATE) : 0;
}

int arc_wear_has_outgrown(const arc_wear *w, arc_status why) {
  return (why == ARC_ZONE && has_grown_into_zone(w)) ||
         (why == ARC_GEOMETRY &&
          (is_deep(w, deep) || arc_wear_layer_rows(w) > 0 || arc_wear_must_refine(w)));
}

int arc_wear_can_grow(const arc_wear *w) {
  const arc_model_def *def = arc_model_definition(w->model);
  double needed[ARC_BODIES];
  arc_wear_zones(&w->def, def, needed);
  for (int b = 0; b < ARC_BODIES; b++)
    if (needed[b] > arc_model_widest_zone(def, (arc_body)b)) return 0;
  return 1;
}

/* --- sizes of the new meshes */

static void widen(const arc_wear *w, arc_model_def *def) {
  double needed[ARC_BODIES];
  arc_wear_zones(&w->def, def, needed);
  const double more = wider * def->mesh.zone[ARC_CYLINDER];
  for (int b = 0; b < ARC_BODIES; b++) {
    needed[b] = fmax(needed[b], def->mesh.zone[b] + more);
    def->mesh.zone[b] = 0;
  }
  arc_model_fit_zones(def, needed);
}

static void set_rows(arc_model_def *def, double rows) {
  const double most = floor(arc_model_deepest_box(def) / def->mesh.height);
  def->mesh.rows = (int)fmin(fmin(ceil(rows - 1e-9), ARC_SHAPE_MOST_ROWS), most);
}

/* Returns the element size [mm] with which an unworn contact with equally wide edges would be
 * meshed. The edges of a flat body with rounded edges are the parts of the contact beside its flat
 * face; those of other bodies are as wide as half of the contact. */
static double edge_size(const arc_wear *w) {
  const contact_estimate unworn = arc_model_estimate(arc_model_definition(w->model), w->def.load);
  const double edge = arc_wear_last(w)->half_width - unworn.flat / 2;
  return arc_model_size_for(fmax(unworn.edge, edge));
}

int arc_wear_is_uniform(const arc_wear *w) {
  static const double uniform = 0.97;
  const arc_model_def *def = arc_model_definition(w->model);
  const arc_wear_record *now = arc_wear_last(w);
  const int ball = def->geometry == ARC_AXISYMMETRIC;
  if (ball && def->axis > 0) return 0;
  const double across = ball ? acos(-1) * now->half_width : 2 * w->manner.thickness;
  return w->def.load > uniform * now->p_center * now->half_width * across;
}

/* Returns how many times as many elements as an unworn contact has are in a worn one. Bodies of
 * revolution with uniform pressure would need elements of a third of the size throughout, and many
 * times the time, for the same error as in the plane; a warning gives their error. */
static double richness(const arc_wear *w) {
  const int plane = arc_model_definition(w->model)->geometry != ARC_AXISYMMETRIC;
  return plane && arc_wear_is_uniform(w) ? rich * full : rich;
}

static void scale_size(arc_model_def *def, double by) {
  def->mesh.size *= by;
  def->mesh.height *= by;
  set_rows(def, def->mesh.rows / by);
}

static void refine(const arc_wear *w, arc_model_def *def) {
  while (is_coarse(w, &def->mesh)) scale_size(def, 1 / ratio);
}

/* Exposed layers become narrower as the scar grows. Their elements therefore have a reserve. */
static void coarsen(const arc_wear *w, arc_model_def *def) {
  const double fitted = arc_model_size_for(arc_wear_last(w)->half_width) / richness(w);
  const double soon = sqrt(sqrt(ratio)); /* a slightly earlier change to larger elements avoids
                                            another remeshing */
  const double edges = edge_size(w) / ratio, layers = exposed_layer_size(w) / (ratio * ratio);
  const double most = fmin(soon * fmin(fmin(fitted, arc_wear_rim_size(w) / 2), edges), layers);
  while (def->mesh.fineness > 0 && def->mesh.size * def->mesh.fineness <= most)
    scale_size(def, ratio);
}

static void deepen(const arc_wear *w, arc_model_def *def) {
  set_rows(def, fmax(deeper * def->mesh.rows, arc_wear_layer_rows(w)));
}

static arc_model_def grown(const arc_wear *w, arc_status why) {
  arc_model_def def = *arc_model_definition(w->model);
  if (why == ARC_ZONE) widen(w, &def);
  coarsen(w, &def);
  refine(w, &def);
  const int deepens = why == ARC_GEOMETRY && !arc_wear_must_refine(w);
  if (deepens || is_deep(w, soon_deep)) deepen(w, &def);
  return def;
}

/* --- transfer to new meshes ------------------------------------------------------------------- */

static arc_status take_over(const arc_wear *w, arc_model *model, arc_wear **result,
                            arc_error *error) {
  arc_shape *shape = NULL;
  size_t records;
  const arc_wear_record *history = arc_wear_history(w, &records);
  arc_status status = arc_shape_create(model, w->def.geometry, w->def.refresh, &shape, error);
  if (status == ARC_OK) status = arc_shape_remap(w->shape, shape, error);
  if (status == ARC_OK)
    status = arc_wear_restore(model, &w->def, shape, history, records, result, error);
  arc_shape_destroy(&shape);
  return status;
}

/* Copies the run to a model of the same bodies with other meshes. */
static arc_status go_onto(const arc_wear *w, const arc_model_def *def,
                          const arc_callbacks *callbacks, arc_wear **result, arc_error *error) {
  arc_model *model = NULL;
  *result = NULL;
  arc_status status = arc_model_build_with_callbacks(def, callbacks, &model, error);
  if (status == ARC_OK) status = take_over(w, model, result, error);
  arc_model_release(&model);
  if (status != ARC_OK) return status;
  (*result)->warned = w->warned;
  (*result)->late = w->late;
  return status;
}

static int like(const arc_mesh_def *a, const arc_mesh_def *b) {
  return a->size == b->size && a->rows == b->rows &&
         a->zone[ARC_CYLINDER] == b->zone[ARC_CYLINDER] && a->zone[ARC_PLATE] == b->zone[ARC_PLATE];
}

arc_status arc_wear_grow(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                         arc_wear **result, arc_error *error) {
  const arc_mesh_def *now = &arc_model_definition(w->model)->mesh;
  const arc_model_def def = grown(w, why);
  *result = NULL;
  if (arc_model_is_given(w->model))
    return arc_fail(error, why,
                    "an imported mesh cannot be enlarged: make its contact curves longer");
  if (like(now, &def.mesh))
    return arc_fail(
        error, why,
        "no larger mesh fits into the bodies: the zones can be at most %g mm (cylinder) "
        "and %g mm (plate) wide, the wear boxes at most %g mm deep",
        arc_model_widest_zone(&def, ARC_CYLINDER), arc_model_widest_zone(&def, ARC_PLATE),
        arc_model_deepest_box(&def));
  return go_onto(w, &def, callbacks, result, error);
}

void arc_wear_report_meshes(const arc_wear *before, const arc_wear *now, const char *why,
                            const arc_callbacks *callbacks) {
  const arc_mesh_def *mesh = &arc_model_definition(now->model)->mesh;
  arc_warn(callbacks,
           "after %.6g mm %s: both bodies have new meshes from this distance on, elements %.4g x "
           "%.4g mm "
           "in %d rows, zones %.4g and %.4g mm",
           arc_wear_last(before)->distance, why, mesh->size, mesh->height, mesh->rows,
           mesh->zone[ARC_CYLINDER], mesh->zone[ARC_PLATE]);
}

void arc_wear_report_growth(const arc_wear *before, const arc_wear *now,
                            const arc_callbacks *callbacks) {
  const arc_mesh_def *old = &arc_model_definition(before->model)->mesh;
  const arc_mesh_def *mesh = &arc_model_definition(now->model)->mesh;
  const char *why = "the wear outgrows its mesh";
  if (old->fineness > 0 && mesh->size != old->size) return; /* automatic sizes are not reported */
  if (arc_wear_layer_rows(before) > 0) why = "layers that wear evenly enter the wear box";
  if (mesh->zone[ARC_PLATE] > old->zone[ARC_PLATE]) why = "the contact outgrows its mesh";
  arc_wear_report_meshes(before, now, why, callbacks);
}

arc_status arc_wear_refuse(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                           arc_error *error) {
  const int differs = strcmp(why->message, trouble->message) != 0;
  if (trouble->message[0] && differs)
    return arc_fail(error, why->status, "%.250s; %.250s", why->message, trouble->message);
  if (why->status != ARC_ZONE || !differs) return arc_fail(error, why->status, "%s", why->message);
  const arc_model_def def = grown(w, why->status);
  return arc_fail(error, why->status,
                  "%.300s; its last step changed the surfaces too much: use shorter steps, jump = "
                  "\"auto\", or mesh.zone = { cylinder = %.4g, plate = %.4g }",
                  why->message, def.mesh.zone[ARC_CYLINDER], def.mesh.zone[ARC_PLATE]);
}

/* Returns the definition of the run's model with a mesh that the user chose, and with zones that
 * are wide enough for the run. */
static arc_model_def remeshed(const arc_wear *w, const arc_mesh_def *mesh) {
  arc_model_def def = *arc_model_definition(w->model);
  const double depth = def.mesh.rows * def.mesh.height;
  double needed[ARC_BODIES];
  def.mesh = *mesh;
  if (mesh->rows == 0) def.mesh.rows = 1; /* a temporary value, because 0 rows are an error */
  arc_model_fit(&def, w->def.load);
  if (mesh->rows == 0)
    def.mesh.rows = (int)fmin(ARC_SHAPE_MOST_ROWS, ceil(depth / def.mesh.height - 1e-9));
  arc_wear_zones(&w->def, &def, needed);
  arc_model_fit_zones(&def, needed);
  return def;
}

arc_status arc_wear_remesh(const arc_wear *w, const arc_mesh_def *mesh,
                           const arc_callbacks *callbacks, arc_wear **result, arc_error *error) {
  const arc_model_def def = remeshed(w, mesh);
  *result = NULL;
  if (arc_model_is_given(w->model))
    return arc_fail(error, ARC_ARGUMENT, "field 'mesh': an imported mesh cannot be changed");
  return go_onto(w, &def, callbacks, result, error);
}

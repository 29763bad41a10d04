/* Removes the wear of an update from the surfaces, and limits the length of an update. */
#include "core/plane/cycle.h"

#include <math.h>

static int any_depth(const double *depth, int n) {
  for (int i = 0; i < n; i++)
    if (depth[i] != 0) return 1;
  return 0;
}

/* Converts depths computed with the largest wear coefficient to depths with the coefficients of the
 * layers. For a track, the mean depth over the contact width is converted. */
static void go_through_layers(const arc_wear *w, const arc_shape *shape,
                              const arc_wear_record *record, wear_depths *depth) {
  const double wide = w->def.track > 0 ? 2 * record->half_width : 1;
  arc_wear_into_layers(shape, depth->node[ARC_CYLINDER]);
  const int middle =
      shape->side[ARC_PLATE].n / 2; /* a uniformly worn plate has the same layers at all nodes */
  if (depth->even > 0)
    depth->even = wide * arc_wear_through_layers(shape, ARC_PLATE, middle, record->depth_plate,
                                                 depth->even / wide);
}

static void add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                        arc_wear_record *record) {
  const double thickness = w->manner.thickness;
  double sum[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < shape->side[b].n; i++)
      sum[b] += depth->node[b][i] * arc_shape_span(shape, (arc_body)b, i);
  record->volume_cylinder += sum[ARC_CYLINDER] * thickness;
  record->volume_plate += (sum[ARC_PLATE] + depth->even * arc_plane_even_width(w)) * thickness;
}

void arc_plane_add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                           arc_wear_record *record) {
  add_volumes(w, shape, depth, record);
  if (w->def.track > 0) record->depth_plate = arc_plane_depth(w, shape, record);
}

/* Sets the compliance to its value in the middle of the update. The error due to the change of the
 * compliance is then of second order. In tests with the compliance at the start of the update and a
 * tolerance of 0.1 %, the depths of the body that wears less had errors of 0.15 %. */
arc_status arc_plane_look_ahead(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                                arc_error *error) {
  arc_status status = ARC_OK;
  if (w->def.geometry == ARC_FROZEN) return ARC_OK;
  arc_wear_into_layers(shape, depth->node[ARC_CYLINDER]);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    if (any_depth(depth->node[b], shape->side[b].n))
      status = arc_shape_look_ahead(shape, (arc_body)b, depth->node[b], error);
  return status;
}

arc_status arc_plane_wear(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                          arc_wear_record *record, arc_error *error) {
  go_through_layers(w, shape, record, depth);
  add_volumes(w, shape, depth, record);
  for (int b = 0; b < ARC_BODIES; b++) {
    if (!any_depth(depth->node[b], shape->side[b].n)) continue;
    arc_shape_conserve(shape, (arc_body)b, depth->node[b]);
    const arc_status status = arc_shape_wear(shape, (arc_body)b, depth->node[b], error);
    if (status != ARC_OK) return status;
  }
  if (depth->even != 0 && w->def.track == 0)
    return arc_shape_wear_evenly(shape, ARC_PLATE, depth->even, error);
  return ARC_OK;
}

/* --- limits of an update ---------------------------------------------------------------------- */

static int has_layers(const arc_model_def *d) {
  return arc_body_layers(&d->body[ARC_CYLINDER]) > 0 || arc_body_layers(&d->body[ARC_PLATE]) > 0;
}

/* Returns the contact modulus of the unworn contact [MPa], including the effect of layers. */
static double felt_modulus(const arc_wear *w) {
  const arc_model_def *d = arc_model_definition(w->model);
  if (!has_layers(d)) return arc_contact_modulus(d->geometry, d->material);
  return arc_model_apparent_modulus(w->model, 1 / w->history[0].half_width);
}

/* Returns the scale of elastic displacements [mm]: the height a^2 / 2R of the cylinder's surface
 * at the edge of the unworn contact. It equals 2 L / (pi t E*) for any radius R, so it can be
 * used for all shapes. */
double arc_plane_natural_depth(const arc_wear *w) {
  const arc_model_def *d = arc_model_definition(w->model);
  if (d->geometry != ARC_PLANE_STRAIN || has_layers(d))
    return 2 * arc_model_line(d, w->def.load) / (acos(-1) * felt_modulus(w));
  const double radius = arc_model_relative_radius(d);
  arc_hertz hertz = {0};
  arc_hertz_solve(isfinite(radius) ? radius : d->radius, d->thickness, w->def.load, d->material,
                  &hertz, NULL);
  return hertz.half_width * hertz.half_width / (2 * (isfinite(radius) ? radius : d->radius));
}

/* Returns the mean pressure [MPa] that causes uniform wear: the load divided by the area of the
 * plate or track. With Archard's law, the uniform depth is this pressure times the integral of k
 * over the sliding distance. */
static double even_pressure(const arc_wear *w) {
  const double across = w->def.track > 0 ? 2 * arc_wear_last(w)->half_width : w->manner.thickness;
  return w->def.load / (arc_plane_even_width(w) * across);
}

/* Returns the integral of k over the sliding distance [mm/MPa] that causes a given depth of
 * uniform wear [mm] under the mean pressure. The layer at the surface may have its own wear
 * coefficient. */
double arc_plane_even_k_integral(const arc_wear *w, double depth) {
  const int middle = w->np / 2;
  const double gone = arc_wear_last(w)->depth_plate - w->shape->side[ARC_PLATE].h[middle];
  const double share = arc_wear_layer_share(w->shape, ARC_PLATE, middle, fmax(0, gone));
  return share > 0 ? depth / (share * even_pressure(w)) : INFINITY;
}

/* --- layers ----------------------------------------------------------------------------------- */

static double even_layer_k_integral(const arc_wear *w) {
  static const double layer_share = 0.05; /* largest fraction of a layer that an update may
                                             remove */
  const elastic_body *plate = w->shape->side[ARC_PLATE].body;
  if (!w->manner.even || w->def.geometry == ARC_FROZEN) return INFINITY;
  double from = 0, end = 0;
  for (int n = 0; end <= arc_wear_last(w)->depth_plate; n++) {
    from = end;
    end = arc_body_stratum(plate, w->np / 2, n).end;
  }
  return isfinite(end) ? arc_plane_even_k_integral(w, layer_share * (end - from)) : INFINITY;
}

/* Returns the index of the exposed layer at a node. */
static int open_layer(const shape_side *side, int i) {
  int n = 0;
  while (arc_body_stratum(side->body, i, n).end <= side->h[i]) n++;
  return arc_body_stratum(side->body, i, n).layer;
}

/* Returns the difference between the compliances of the exposed layer and of the body's material
 * below all layers, per mm of depth [1/MPa]. The result is the largest absolute difference at a
 * worn node or, before any wear, at any node. */
static double softness(const arc_wear *w, arc_body body) {
  const shape_side *side = &w->shape->side[body];
  const elastic_body *b = side->body;
  double most = 0;
  if (arc_body_layers(&b->mesh->solid) == 0) return most;
  for (int i = 0; i < side->n; i++)
    if (side->h[i] > 0 || w->records == 1)
      most = fmax(most, fabs(1 / b->layer[open_layer(side, i)].c22 - 1 / b->d.c22));
  return most;
}

/* Returns the longest update that the changing stiffness of layers allows, as an integral of k over
 * the sliding distance. An update uses the stiffness at its start. The stiffness changes as layers
 * become thinner, and the mean error is half of this change. */
static double scar_layer_k_integral(const arc_wear *w) {
  static const double felt = 0.01; /* accepted relative change of the pressure by an update */
  const double soft = fmax(softness(w, ARC_CYLINDER), softness(w, ARC_PLATE));
  if (w->def.geometry == ARC_FROZEN || soft == 0) return INFINITY;
  const double p = arc_wear_last(w)->p_center;
  const double depth = felt * w->history[0].half_width / (felt_modulus(w) * soft);
  return p > 0 ? depth / p : INFINITY;
}

/* Returns the wear coefficient of the exposed layers divided by the largest wear coefficient of
 * the body. The result is the maximum over all worn nodes or, before any wear, over all nodes. */
static double open_share(const arc_wear *w, arc_body body) {
  const shape_side *side = &w->shape->side[body];
  double most = 0;
  for (int i = 0; i < side->n; i++)
    if (side->h[i] > 0 || w->records == 1)
      most = fmax(most, arc_wear_layer_share(w->shape, body, i, 0));
  return most;
}

/* Returns the wear coefficient at the deepest node, divided by the largest wear coefficient of
 * the body. Before any wear the middle node represents all nodes. For uniform wear the depth in
 * the record is used. */
double arc_plane_open_share(const arc_wear *w, arc_body body) {
  const shape_side *side = &w->shape->side[body];
  const arc_wear_record *now = arc_wear_last(w);
  const double depth = body == ARC_CYLINDER ? now->depth_cylinder : now->depth_plate;
  int deepest = side->n / 2;
  for (int i = 0; i < side->n; i++)
    if (side->h[i] > side->h[deepest]) deepest = i;
  return arc_wear_layer_share(w->shape, body, deepest, fmax(0, depth - side->h[deepest]));
}

/* Returns the largest mean pressure on a point of the plate over the sliding distance [MPa]. If the
 * stroke is wider than the contact, the whole load passes over each point once per stroke. */
static double pressure_on_plate(const arc_wear *w) {
  const arc_wear_record *now = arc_wear_last(w);
  const double travel = w->manner.rests ? 0 : arc_wear_travel(w);
  const double passing = arc_model_line(arc_model_definition(w->model), w->def.load);
  return travel * now->p_center > passing ? passing / travel : now->p_center;
}

/* Returns the longest update that the changing compliance of a scar allows, as an integral of k
 * over the sliding distance. If the scar becomes deeper by dh, the elastic displacement u = p b / E
 * (pressure p, half width b) changes by about u dh / b. Relative to the depth h this is an error of
 * p dh / (E h). With the compliance in the middle of the update, the error is of second order. */
static double scar_k_integral(const arc_wear *w) {
  static const double late = 5;     /* accepted error of first order, divided by the tolerance */
  static const double deeper = 0.1; /* largest increase of the depth in an update, divided by the
                                       half width */
  const arc_wear_record *now = arc_wear_last(w);
  const int no_scar = w->manner.even && now->alpha == 0;
  if (w->def.geometry == ARC_FROZEN || no_scar || !(now->p_center > 0)) return INFINITY;
  const double tolerance = w->def.tolerance > 0 ? w->def.tolerance : ARC_USUAL_TOLERANCE;
  const double h = fmax(arc_plane_natural_depth(w), now->depth_cylinder + now->depth_plate);
  const double depth =
      fmin(late * tolerance * h * felt_modulus(w) / now->p_center, deeper * now->half_width);
  const double rate = now->alpha * open_share(w, ARC_CYLINDER) * now->p_center +
                      (1 - now->alpha) * open_share(w, ARC_PLATE) * pressure_on_plate(w);
  return rate > 0 ? depth / rate : INFINITY;
}

double arc_plane_layer_k_integral(const arc_wear *w, int scars) {
  const double even = even_layer_k_integral(w);
  return scars ? fmin(even, fmin(scar_layer_k_integral(w), scar_k_integral(w))) : even;
}

/* Computes the results after each update from the reference problem, in which the plate is at x
 * = 0 under the nominal load. */
#include "archard/measure.h"
#include "core/plane/cycle.h"

#include <math.h>

int arc_plane_stays_as_it_is(const arc_wear_def *d, const arc_model_def *model) {
  return d->alpha == 0 && !d->alpha_function && d->alpha_series.count == 0 &&
         arc_model_is_hertzian(model) && (arc_law_properties[d->law] & ARC_LAW_LINEAR) &&
         !d->local_factor && arc_wear_over_plate(d, model) &&
         arc_wear_choose_procedure(d, model) == ARC_NSP;
}

double arc_plane_even_width(const arc_wear *w) {
  if (w->def.track > 0) return 2 * acos(-1) * w->def.track;
  return arc_model_width(arc_model_definition(w->model));
}

double arc_plane_depth(const arc_wear *w, const arc_shape *shape, const arc_wear_record *record) {
  if (w->def.track == 0) return arc_shape_depth(shape, ARC_PLATE);
  return record->volume_plate / (arc_plane_even_width(w) * 2 * record->half_width);
}

/* Returns true if the contact is still the Hertz contact of the unworn surfaces. */
static int stays_hertzian(const arc_wear *w, const arc_shape *shape) {
  return arc_plane_stays_as_it_is(&w->def, arc_model_definition(w->model)) &&
         arc_shape_depth(shape, ARC_CYLINDER) == 0;
}

/* Solves the reference problem on a shape: the plate at x = 0 under the nominal load. */
static arc_status solve_reference(arc_wear *w, const arc_shape *shape, arc_error *error) {
  const double line = w->def.load / arc_model_definition(w->model)->thickness;
  arc_contact_problem_set_angle(&plane_of(w)->reference, arc_radians(w->def.load_angle));
  const arc_status status = arc_contact_problem_update(&plane_of(w)->reference, shape, 0, error);
  return status == ARC_OK ? arc_contact_problem_solve(&plane_of(w)->reference, line, error)
                          : status;
}

static arc_status measure_contact(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                                  arc_error *error) {
  const arc_model_def *def = arc_model_definition(w->model);
  if (stays_hertzian(w, shape)) {
    const arc_hertz hertz = arc_model_hertz(def, w->def.load);
    record->p_center = record->p_max = hertz.p_max;
    record->half_width = hertz.half_width;
    return ARC_OK;
  }
  const arc_status status = solve_reference(w, shape, error);
  if (status != ARC_OK) return status;
  const contact_problem *p = &plane_of(w)->reference;
  double edges[2];
  arc_contact_problem_edges(p, shape, edges);
  record->half_width = (edges[1] - edges[0]) / 2;
  arc_contact_problem_peaks(p, &record->p_center, &record->p_max);
  record->solutions += 1;
  return ARC_OK;
}

arc_status arc_plane_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                             arc_error *error) {
  const arc_status status = measure_contact(w, shape, record, error);
  if (status != ARC_OK) return status;
  if (w->def.blocks == 0 || record->p_peak == 0)
    record->p_peak = fmax(record->p_peak, record->p_max);
  record->load_reference = w->def.load;
  record->box_rows = arc_model_definition(w->model)->mesh.rows;
  record->elements = arc_model_mesh(w->model, ARC_CYLINDER)->elements +
                     arc_model_mesh(w->model, ARC_PLATE)->elements;
  record->depth_cylinder = arc_shape_depth(shape, ARC_CYLINDER);
  record->depth_plate = arc_plane_depth(w, shape, record);
  record->depth_partition = arc_depth_partition(record->depth_cylinder, record->depth_plate);
  return ARC_OK;
}

double arc_plane_ripple(const arc_wear *w, const arc_shape *shape,
                        const arc_wear_record *measured) {
  static const double middle =
      0.8; /* averaged part of the half width, which excludes the steep edges */
  if (stays_hertzian(w, shape)) return 0;
  return arc_contact_problem_ripple(&plane_of(w)->reference, shape, middle * measured->half_width);
}

double arc_plane_roughness(const arc_wear *w, arc_body body) {
  const arc_profile profile = arc_shape_profile(w->shape, body);
  const double deepest = arc_shape_depth(w->shape, body);
  const double reach = 0.8 * arc_wear_last(w)->half_width; /* half width of the averaged part in the
                                                              middle of the contact [mm] */
  const double at = arc_model_arc_length(arc_model_definition(w->model), w->def.load_angle);
  const double saw =
      arc_measure_sawtooth(profile.x, profile.h, (size_t)profile.count, at - reach, at + reach);
  return deepest > 0 ? saw / deepest : 0;
}

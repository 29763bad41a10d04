/* The contact object: solves a contact problem and computes its results. */
#include "core/base/callbacks.h"
#include "core/plane/solution.h"
#include "core/elastic/contact_estimate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ARC_SETTING_OF arc_contact_def
const arc_setting arc_contact_settings[] = {
    ARC_CONTACT_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_WHOLE, ARC_SETTING_CHOICE,
                         ARC_SETTING_OTHER){.name = NULL},
};
#undef ARC_SETTING_OF

arc_contact_def arc_contact_default(void) {
  arc_contact_def def;
  arc_settings_default(arc_contact_settings, &def);
  return def;
}

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
}

static arc_status allocate(arc_contact *c) {
  if (arc_contact_problem_create(&c->problem, c->handle.shape->handle.model) != ARC_OK)
    return ARC_MEMORY;
  for (int b = 0; b < ARC_BODIES; b++) {
    const size_t n = (size_t)c->handle.shape->side[b].n;
    c->count[b] = (int)n;
    c->x[b] = calloc(6 * n, sizeof(double));
    if (!c->x[b]) return ARC_MEMORY;
    c->p[b] = c->x[b] + n;
    c->f[b] = c->p[b] + n;
    c->force[b] = c->f[b] + n;
    c->q[b] = c->force[b] + 2 * n;
  }
  if (!c->has_friction) return ARC_OK;
  if (arc_tangential_create(&c->compliance, c->handle.shape->handle.model) != ARC_OK)
    return ARC_MEMORY;
  if (arc_friction_workspace_create(&c->workspace, c->handle.shape->handle.model) != ARC_OK)
    return ARC_MEMORY;
  return arc_friction_create(&c->state, c->handle.shape->handle.model, c->handle.def.x);
}

static void read_pressures(arc_contact *c) {
  arc_contact_problem_pressures(&c->problem, c->p[ARC_CYLINDER], c->p[ARC_PLATE]);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *width = b == ARC_CYLINDER ? c->problem.wc : c->problem.wp;
    for (int i = 0; i < c->count[b]; i++) {
      c->x[b][i] = c->handle.shape->side[b].xy[2 * i] + (b == ARC_PLATE ? c->problem.x : 0);
      c->f[b][i] = c->p[b][i] * width[i];
    }
    arc_contact_problem_forces_on(&c->problem, (arc_body)b, c->force[b]);
  }
}

/* Computes the shear tractions of both bodies [MPa], and the nodal forces including shear. */
static void read_shear(arc_contact *c) {
  if (!c->has_friction) return;
  memcpy(c->q[ARC_CYLINDER], c->state.t, (size_t)c->problem.nc * sizeof(double));
  arc_contact_problem_to_plate(&c->problem, c->state.t, c->q[ARC_PLATE]);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *width = b == ARC_CYLINDER ? c->problem.wc : c->problem.wp;
    for (int i = 0; i < c->count[b]; i++) c->q[b][i] /= width[i];
    arc_friction_forces_on(&c->problem, &c->workspace, (arc_body)b, c->force[b]);
  }
}

/* Returns the sum of the forces along x on the cylinder [N/mm]. */
static double driving_force(const arc_contact *c) {
  double sum = 0;
  for (int i = 0; i < c->count[ARC_CYLINDER]; i++) sum += c->force[ARC_CYLINDER][i];
  return sum;
}

/* Returns the sum of the normal forces on the candidate nodes [N/mm]. */
static double normal_force(const arc_contact *c) {
  double sum = 0;
  for (int k = 0; k < c->problem.count; k++) sum += c->problem.f[k];
  return sum;
}

static void read_result(arc_contact *c) {
  const double thickness = arc_model_definition(c->handle.shape->handle.model)->thickness;
  double edges[2], center, largest;
  arc_contact_problem_edges(&c->problem, c->handle.shape, edges);
  arc_contact_problem_peaks(&c->problem, &center, &largest);
  c->handle.result = (arc_contact_result){
      .p_center = center,
      .p_max = largest,
      .p_average = arc_contact_problem_average(&c->problem, c->handle.shape, c->handle.def.average),
      .left = edges[0],
      .right = edges[1],
      .half_width = (edges[1] - edges[0]) / 2,
      .normal_force = thickness * normal_force(c),
      .approach = c->problem.approach,
      .tangential = thickness * driving_force(c),
      .energy = thickness * c->state.energy,
      .iterations = c->has_friction ? c->iterations : c->problem.iterations};
}

/* Rejects settings that break the rotational symmetry of bodies of revolution. */
static arc_status check_revolved(const arc_model *model, const arc_contact_def *def,
                                 arc_error *error) {
  if (arc_model_definition(model)->geometry != ARC_AXISYMMETRIC) return ARC_OK;
  if (def->x != 0)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'x': expected 0 mm for bodies of revolution, which share an axis, got %g", def->x);
  if (def->friction > 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'friction': expected 0 for bodies of revolution: shear along x is not "
                    "axisymmetric, got %g",
                    def->friction);
  return ARC_OK;
}

arc_status arc_contact_create(const arc_shape *shape, const arc_contact_def *def,
                              arc_contact **result, arc_error *error) {
  arc_contact *c = calloc(1, sizeof *c);
  *result = c;
  if (!c) return out_of_memory(error);
  c->handle.def = *def;
  c->has_friction = def->friction > 0;
  if (c->has_friction && arc_model_body(shape->handle.model, ARC_UPPER)->chart.polar)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'friction': expected 0 in a hole, where shear carries a part of the load, got %g",
        def->friction);
  if (def->load_angle != 0 && !arc_model_body(shape->handle.model, ARC_UPPER)->chart.polar)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'load_angle': expected 0 (other angles only in a hole), got %g degrees",
                    def->load_angle);
  arc_status status = check_revolved(shape->handle.model, def, error);
  if (status == ARC_OK) status = arc_shape_clone(shape, &c->handle.shape, error);
  if (status == ARC_OK) arc_shape_set_corrections(c->handle.shape, def->corrections);
  if (status == ARC_OK && (status = allocate(c)) != ARC_OK) out_of_memory(error);
  return status;
}

/* Computes all results of the solved problem: pressures, shear and the summary. */
static void read_all(arc_contact *c) {
  read_pressures(c);
  read_shear(c);
  read_result(c);
}

void arc_contact_zones(const arc_contact_def *def, const arc_model_def *model,
                       double zone[ARC_BODIES]) {
  const double under = arc_model_arc_length(model, def->load_angle);
  const contact_estimate e = arc_model_estimate(model, def->load);
  arc_zone_for(fabs(under - def->x) + fabs(e.at), e.half_width + e.edge, model->mesh.size, zone);
  zone[ARC_UPPER] += 2 * (fabs(under) + fabs(e.at));
}

/* Rounds a zone width [mm] up to three significant digits, or down if the result would exceed
 * `widest`. */
static double round_zone(double zone, double widest) {
  const double unit = pow(10, floor(log10(zone)) - 2), up = ceil(zone / unit - 1e-9) * unit;
  return up <= widest ? up : floor(widest / unit) * unit;
}

/* Returns true if the middle of the contact is outside the zone of the plate, even if this zone had
 * its largest possible width. */
static int is_off(const arc_contact *c) {
  const arc_model_def *model = arc_model_definition(c->handle.shape->handle.model);
  if (arc_model_body(c->handle.shape->handle.model, ARC_UPPER)->chart.polar) return 0;
  return 2 * fabs(c->problem.x) >= arc_model_widest_zone(model, ARC_PLATE);
}

static arc_status explain_position(const arc_contact *c, arc_error *error) {
  const arc_model_def *model = arc_model_definition(c->handle.shape->handle.model);
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'x': expected less than %g mm to either side, half the widest zone of the "
                  "plate, got %g mm",
                  arc_model_widest_zone(model, ARC_PLATE) / 2, c->problem.x);
}

/* Computes the widths [mm] of the zones that a contact needs. If no automatic zone is wider than
 * the present one, the present widths are doubled. Returns 0 if no zone becomes wider, or if a body
 * is too narrow for the contact plus two elements on either side. */
static int find_zones(const arc_contact_def *def, const arc_model_def *model,
                      double zone[ARC_BODIES]) {
  const double contact = 2 * arc_model_half_width(model, def->load) + 4 * model->mesh.size;
  const double *now = model->mesh.zone;
  int more = 0;
  arc_contact_zones(def, model, zone);
  const int wider = zone[ARC_UPPER] > now[ARC_UPPER] || zone[ARC_LOWER] > now[ARC_LOWER];
  for (int b = 0; b < ARC_BODIES; b++) {
    const double widest = arc_model_widest_zone(model, (arc_body)b);
    if (contact > widest) return 0;
    zone[b] = round_zone(fmax(zone[b], (wider ? 1 : 2) * now[b]), widest);
    more |= zone[b] > now[b];
  }
  return more;
}

/* Composes the error message for a contact that extends beyond the zones. Returns ARC_ZONE or
 * ARC_ARGUMENT. */
static arc_status explain_zones(const arc_contact *c, arc_error *error) {
  const arc_model_def *model = arc_model_definition(c->handle.shape->handle.model);
  if (!error || arc_model_is_given(c->handle.shape->handle.model)) return ARC_ZONE;
  if (is_off(c)) return explain_position(c, error);
  const arc_error why = *error;
  double zone[ARC_BODIES];
  arc_contact_def here = c->handle.def;
  here.x = c->problem.x;
  if (!find_zones(&here, model, zone))
    return arc_fail(error, ARC_ZONE,
                    "%s; the bodies are too small for this contact: the zones can be at most %g mm "
                    "(cylinder) and %g mm (plate) wide",
                    why.message, arc_model_widest_zone(model, ARC_CYLINDER),
                    arc_model_widest_zone(model, ARC_PLATE));
  return arc_fail(error, ARC_ZONE,
                  "%s (this contact needs mesh.zone = {cylinder = %.3g, plate = %.3g} mm)",
                  why.message, zone[ARC_CYLINDER], zone[ARC_PLATE]);
}

/* Returns the load [N] if both bodies are unworn, otherwise 0. */
static double unworn_load(const arc_contact *c) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_shape_depth(c->handle.shape, (arc_body)b) > 0) return 0;
  return c->handle.def.load;
}

arc_status arc_contact_finish(arc_contact **contact, arc_status status,
                              const arc_callbacks *callbacks, arc_error *error) {
  if (status == ARC_OK) {
    read_all(*contact);
    arc_model_warn((*contact)->handle.shape->handle.model, unworn_load(*contact),
                   (*contact)->handle.result.half_width, callbacks);
  }
#ifdef ARC_CHECKS
  arc_error broken;
  if (status == ARC_OK && arc_contact_validate(*contact, &broken) == ARC_NUMERIC)
    status = arc_fail(error, ARC_NUMERIC, "%s", broken.message);
#else
  (void)error;
#endif
  if (status == ARC_ZONE) status = explain_zones(*contact, error);
  if (status != ARC_OK) {
    arc_plane_end_contact(*contact);
    *contact = NULL;
  }
  return status;
}

void arc_friction_warn(const arc_model *model, double mu, const char *who,
                       const arc_callbacks *callbacks) {
  static const double unique = 0.4;
  const arc_model_def *def = arc_model_definition(model);
  const double beta = fabs(arc_contact_mismatch(def->geometry, def->material));
  if (mu * beta > unique)
    arc_warn(callbacks,
             "%s: friction %.3g times Dundurs' beta %.3g is above %g: there may be several "
             "solutions, and the result depends on the motion",
             who, mu, beta, unique);
}

arc_status arc_plane_solve(const arc_shape *shape, const arc_contact_def *def,
                           const arc_callbacks *callbacks, arc_contact **result, arc_error *error) {
  arc_status status = arc_settings_check(arc_contact_settings, "", def, error);
  if (status != ARC_OK) return status;
  status = arc_contact_create(shape, def, result, error);
  arc_contact *c = *result;
  if (status == ARC_OK) arc_contact_problem_set_angle(&c->problem, arc_radians(def->load_angle));
  if (status == ARC_OK)
    status = arc_contact_problem_update(&c->problem, c->handle.shape, def->x, error);
  if (status == ARC_OK && c->has_friction) status = arc_contact_press(c, error);
  if (status == ARC_OK && !c->has_friction)
    status = arc_contact_problem_solve(&c->problem, contact_line(c), error);
  if (status == ARC_OK)
    arc_friction_warn(c->handle.shape->handle.model, c->handle.def.friction, "contact", callbacks);
  return arc_contact_finish(result, status, callbacks, error);
}

void arc_plane_end_contact(arc_contact *c) {
  if (!c) return;
  arc_contact_problem_free(&c->problem);
  arc_tangential_free(&c->compliance);
  arc_friction_workspace_free(&c->workspace);
  arc_friction_free(&c->state);
  for (int b = 0; b < ARC_BODIES; b++) free(c->x[b]);
  arc_shape_destroy(&c->handle.shape);
  free(c);
}

size_t arc_plane_contact_bytes(const arc_contact *c) {
  const size_t nodes = (size_t)(c->count[ARC_CYLINDER] + c->count[ARC_PLATE]);
  return sizeof *c + arc_shape_bytes(c->handle.shape) + arc_contact_problem_bytes(&c->problem) +
         6 * nodes * sizeof(double) +
         (c->has_friction
              ? arc_tangential_bytes(&c->compliance) + arc_friction_workspace_bytes(&c->workspace)
              : 0) +
         (c->has_friction ? arc_friction_bytes(&c->state) : 0);
}

arc_pressure arc_contact_pressure(const arc_contact *c, arc_body body) {
  return (arc_pressure){c->count[body], c->x[body], c->p[body], c->f[body], c->force[body]};
}

arc_shear arc_contact_shear(const arc_contact *c, arc_body body) {
  return (arc_shear){c->count[body], c->x[body], c->q[body]};
}

const double *arc_contact_slip(const arc_contact *c, int *count) {
  *count = c->count[ARC_CYLINDER];
  return c->state.slip_path;
}

arc_status arc_plane_show_contact(const arc_contact *c, arc_array **surfaces, size_t *count,
                                  arc_error *error) {
  enum { X, P, NAMES };
  static const char *const names[] = {"x", "p"};
  arc_array list[ARC_BODIES * NAMES];
  for (int i = 0; i < ARC_BODIES * NAMES; i++) {
    const int b = i / NAMES;
    list[i] = (arc_array){names[i % NAMES],
                          (arc_body)b,
                          0,
                          0,
                          {(size_t)c->count[b], 1},
                          i % NAMES == X ? c->x[b] : c->p[b]};
  }
  *surfaces = arc_arrays_copy(list, ARC_BODIES * NAMES);
  if (!*surfaces) return out_of_memory(error);
  *count = ARC_BODIES * NAMES;
  return ARC_OK;
}

/* Solves contacts of half-spaces, and measures the reference configuration of a run. */
#include "core/space/halfspace.h"
#include "core/space/space_kind.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- contacts --------------------------------------------------------------------------------- */

void arc_space_end_contact(arc_contact *contact) {
  space_contact *c = (space_contact *)(void *)contact;
  arc_space_discard(&c->handle.shape);
  arc_halfspace_friction_end(&c->rubbing);
  arc_halfspace_friction_end(&c->coarser);
  free(c->pressure);
  free(c);
}

size_t arc_space_contact_bytes(const arc_contact *contact) {
  const space_contact *c = (const space_contact *)(const void *)contact;
  const space_shape *s = space_shape_of(c->handle.shape);
  const int fields = c->rubbing.pressure ? 19 : 3;
  return sizeof *c +
         (size_t)(fields * space_sites(s, ARC_UPPER) + space_sites(s, ARC_LOWER)) * sizeof(double);
}

static arc_status check(const arc_contact_def *def, arc_error *error) {
  const arc_status status = arc_settings_check(arc_contact_settings, "", def, error);
  if (status != ARC_OK) return status;
  if (def->load_angle != 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'load_angle': expected 0 (other angles only in a hole), got %g degrees",
                    def->load_angle);
  return ARC_OK;
}

static arc_status solve_at(const space_shape *s, double x, double load,
                           const arc_callbacks *callbacks, double *pressure, double *approach,
                           arc_halfspace_report *report, arc_error *error) {
  const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
  const arc_halfspace_position position = {.x = x, .load = load, .weight = 1};
  const arc_halfspace_options options = {.callbacks = callbacks};
  return arc_halfspace_solve(s->grid->h, depth, &position, &options, pressure, approach, report,
                             error);
}

void arc_space_read_result(space_contact *c, double approach, int iterations) {
  const space_shape *s = space_shape_of(c->handle.shape);
  const arc_halfspace_extent e = arc_halfspace_contact_extent(s->grid->h, c->pressure);
  c->handle.result = (arc_contact_result){.p_center = e.center,
                                          .p_max = e.largest,
                                          .p_average = e.largest,
                                          .half_width = e.half_width,
                                          .half_width_z = e.half_width_z,
                                          .area = e.area,
                                          .left = e.center_x - e.half_width,
                                          .right = e.center_x + e.half_width,
                                          .normal_force = c->handle.def.load,
                                          .approach = approach,
                                          .iterations = iterations};
}

static arc_status solve_contact(space_contact *c, const arc_callbacks *callbacks,
                                arc_error *error) {
  const space_shape *s = space_shape_of(c->handle.shape);
  const size_t cells = (size_t)space_sites(s, ARC_UPPER);
  arc_halfspace_report report = {0};
  double approach = 0;
  c->pressure = calloc(cells, sizeof *c->pressure);
  if (!c->pressure) return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
  const arc_status status = solve_at(s, c->handle.def.x, c->handle.def.load, callbacks, c->pressure,
                                     &approach, &report, error);
  if (status != ARC_OK) return status;
  arc_space_read_result(c, approach, report.iterations);
  return ARC_OK;
}

/* Enlarges the grid of a contact: the track, if it is too short for position x [mm]; else the
 * window along x, if the contact may move with a lower body that is not flat; else the window in
 * both directions. Error: ARC_ZONE if a map is too small. */
static arc_status enlarge(const space_contact *c, double x, arc_halfspace_def *cells,
                          arc_error *error) {
  const space_shape *s = space_shape_of(c->handle.shape);
  const arc_model_def *model = arc_model_definition(arc_shape_model(c->handle.shape));
  const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
  const int flat = arc_space_is_flat(s->grid->h, depth, ARC_LOWER);
  const int ahead = 2 * arc_space_whole_cells(fabs(x) / cells->size_x);
  const int track = (int)fmax(cells->track, cells->nx);
  if (cells->groove > 0) return arc_space_widen(model, 4, cells, error);
  if (track < cells->nx + ahead) return arc_space_extend_cells(model, 0, ahead, cells, error);
  if (!flat && cells->nx < cells->nz + ahead)
    return arc_space_extend_cells(model, cells->nz + ahead - cells->nx, track - cells->nx, cells,
                                  error);
  return arc_space_widen(model, 4, cells, error);
}

arc_status arc_space_widen_contact(space_contact *c, double x, arc_error *error) {
  const space_shape *s = space_shape_of(c->handle.shape);
  arc_halfspace_def cells = *arc_halfspace_definition(s->grid->h);
  space_shape *larger;
  arc_status status = enlarge(c, x, &cells, error);
  if (status == ARC_OK) status = arc_space_regrow(s, &cells, &larger, error);
  if (status != ARC_OK) return status;
  arc_halfspace_friction *const states[] = {&c->rubbing, &c->coarser};
  for (int i = 0; i < 2 && states[i]->pressure && status == ARC_OK; i++) {
    arc_halfspace_friction wide;
    status = arc_halfspace_friction_widen(s->grid->h, states[i], larger->grid->h, &wide, error);
    if (status != ARC_OK) break;
    arc_halfspace_friction_end(states[i]);
    *states[i] = wide;
  }
  if (status != ARC_OK) {
    arc_space_discard((arc_shape **)(void *)&larger);
    return status;
  }
  arc_space_discard(&c->handle.shape);
  c->handle.shape = (arc_shape *)(void *)larger;
  free(c->pressure);
  c->pressure = NULL;
  return ARC_OK;
}

/* Solves the contact. The window of the shape may have been made for another load, so it is
 * enlarged if necessary. */
static arc_status solve_in_larger_windows(space_contact *c, const arc_callbacks *callbacks,
                                          arc_error *error) {
  enum { most_tries = 12 };
  arc_status status = solve_contact(c, callbacks, error);
  for (int i = 0; i < most_tries && status == ARC_ZONE; i++) {
    status = arc_space_widen_contact(c, c->handle.def.x, error);
    if (status == ARC_OK) status = solve_contact(c, callbacks, error);
  }
  return status;
}

/* Returns true if both bodies are unworn, so that new cells can be chosen for the load. */
static int is_unworn(const space_shape *s) {
  const int n = space_sites(s, ARC_UPPER) + space_sites(s, ARC_LOWER);
  for (int i = 0; i < n; i++)
    if (s->depth[ARC_UPPER][i] != 0) return 0;
  return 1;
}

/* Gives warnings and stores the contact in *result, or frees the contact after an error. Returns
 * `status`. */
static arc_status finish(space_contact *c, arc_status status, const arc_callbacks *callbacks,
                         arc_contact **result) {
  if (status == ARC_OK) {
    const space_shape *s = space_shape_of(c->handle.shape);
    *result = (arc_contact *)(void *)c;
    arc_space_warn(arc_model_definition(arc_shape_model(c->handle.shape)),
                   arc_halfspace_definition(s->grid->h), c->handle.result.half_width,
                   c->handle.result.half_width_z, callbacks);
  } else if (c) {
    arc_space_end_contact((arc_contact *)(void *)c);
  }
  return status;
}

/* Copies a contact. If memory for the contact itself is not available, *copy is NULL. */
static arc_status copy_contact(const space_contact *from, space_contact **copy, arc_error *error) {
  const arc_halfspace *h = space_shape_of(from->handle.shape)->grid->h;
  space_contact *c = *copy = calloc(1, sizeof *c);
  if (!c) return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
  c->handle.def = from->handle.def;
  c->handle.result = from->handle.result;
  c->origin = from->origin;
  arc_status status = arc_space_copy(from->handle.shape, &c->handle.shape, error);
  if (status != ARC_OK) return status;
  status = arc_halfspace_friction_copy(h, &from->rubbing, &c->rubbing, error);
  return status == ARC_OK ? arc_halfspace_friction_copy(h, &from->coarser, &c->coarser, error)
                          : status;
}

arc_status arc_space_solve(const arc_shape *shape, const arc_contact_def *def,
                           const arc_callbacks *callbacks, arc_contact **result, arc_error *error) {
  arc_model *model = arc_shape_model(shape);
  const arc_model_def *md = arc_model_definition(model);
  arc_status status = check(def, error);
  if (status != ARC_OK) return status;
  space_contact *c = calloc(1, sizeof *c);
  if (!c) return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
  const int unworn = is_unworn(space_shape_of(shape));
  if (!unworn && space_turned(space_shape_of(shape)) && (def->x != 0 || def->friction > 0)) {
    free(c);
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%s': expected 0 on surfaces that were worn along z, got %g",
                    def->x != 0 ? "x" : "friction", def->x != 0 ? def->x : def->friction);
  }
  c->handle.def = *def;
  if (unworn) {
    arc_halfspace_def cells;
    if (def->friction > 0)
      arc_space_fit_friction(md, def->load, &cells);
    else
      arc_space_fit(md, 0, def->load, 0, 2 * fabs(def->x), fabs(def->x), &cells);
    status = arc_space_create(model, &cells, (space_shape **)(void *)&c->handle.shape, error);
  } else {
    status = arc_space_copy(shape, &c->handle.shape, error);
  }
  if (status == ARC_OK)
    status = def->friction > 0 ? arc_space_press(c, callbacks, error)
                               : solve_in_larger_windows(c, callbacks, error);
  return finish(c, status, callbacks, result);
}

/* Moves the lower body. With friction the motion continues from the present position; without
 * friction the contact depends only on the new position. */
arc_status arc_space_move(const arc_contact *from, const arc_motion_def *motion,
                          const arc_callbacks *callbacks, arc_contact **contact, arc_error *error) {
  const space_contact *before = (const space_contact *)(const void *)from;
  arc_contact_def def = *arc_contact_definition(from);
  if (before->rubbing.pressure) {
    space_contact *c = NULL;
    arc_status status = copy_contact(before, &c, error);
    if (status == ARC_OK) status = arc_space_rub(c, motion, callbacks, error);
    return finish(c, status, callbacks, contact);
  }
  if (motion->by_force || motion->by_force_z || motion->z != 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%s': expected none, as the contact has no friction "
                    "(contact{ friction = 0.3 } has), got %g",
                    motion->by_force     ? "tangential"
                    : motion->by_force_z ? "tangential_z"
                                         : "z",
                    motion->by_force     ? motion->tangential
                    : motion->by_force_z ? motion->tangential_z
                                         : motion->z);
  def.x = motion->x;
  if (motion->load > 0) def.load = motion->load;
  return arc_contact_solve(arc_contact_shape(from), &def, callbacks, contact, error);
}

/* --- stresses below the surface --------------------------------------------------------------- */

arc_status arc_space_contact_stress(const arc_contact *contact, arc_body body, double y,
                                    double *stress, arc_error *error) {
  const space_contact *c = (const space_contact *)(const void *)contact;
  const arc_halfspace *h = space_shape_of(c->handle.shape)->grid->h;
  const arc_halfspace_body *b = &arc_halfspace_definition(h)->body[body];
  if (b->layer[0].thickness > 0 || b->depth > 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "stresses below the %s: expected a homogeneous half-space, got one with layers "
                    "or a rigid base",
                    arc_body_name(body));
  if (c->rubbing.pressure)
    return arc_fail(error, ARC_ARGUMENT,
                    "stresses in 3-D: expected a contact without friction, got one with friction: "
                    "stresses caused by shear are not computed");
  if (space_turned(space_shape_of(c->handle.shape)))
    return arc_fail(error, ARC_ARGUMENT,
                    "stresses of surfaces that were worn along z are not "
                    "computed");
  return arc_halfspace_stress(h, c->pressure, b->material.nu, y, stress, error);
}

/* --- conversion to arrays --------------------------------------------------------------------- */

enum { X, Z, H, Y, P, NAMES };
static const char *const names[] = {"x", "z", "h", "y", "p"};

/* Computes values [NAMES][sites]: the quantities listed in `names` at all sites of one body. The
 * lower body has the pressures of the window at its present position `at` [mm]. */
static void fill(const space_shape *s, int b, const double *pressure, double at, double *values) {
  const arc_halfspace_def *d = arc_halfspace_definition(s->grid->h);
  const int n = space_sites(s, b), rows = n / d->nz;
  const int ahead = d->groove > 0 ? 0 : (rows - d->nx) / 2 - (int)round(at / d->size_x);
  const double *recess = arc_halfspace_recess(s->grid->h, (arc_body)b);
  for (int i = 0; i < n; i++) {
    const double inside = recess[i] + s->depth[b][i];
    const int row = i / d->nz - (b == ARC_LOWER ? ahead : 0);
    const int to = d->turned ? i % d->nz * rows + i / d->nz : i; /* z varies fastest */
    values[X * n + to] = s->grid->x[b][i];
    values[Z * n + to] = s->grid->z[b][i];
    values[H * n + to] = s->depth[b][i];
    values[Y * n + to] = b == ARC_UPPER ? inside : -inside;
    values[P * n + to] = row >= 0 && row < d->nx ? fmax(0, pressure[row * d->nz + i % d->nz]) : 0;
  }
}

/* Number of result arrays that only contacts with friction have, for the upper body. */
enum { FRICTION_ARRAYS = 6 };

/* Returns the arrays of a solved contact whose names are in `wanted`, and the arrays `more`
 * [FRICTION_ARRAYS] unless `more` is NULL. */
static arc_status show(const space_shape *s, const double *pressure, double at, double update,
                       double distance, const int *wanted, int count, const arc_array *more,
                       arc_array **result, size_t *arrays, arc_error *error) {
  const size_t n[] = {(size_t)space_sites(s, ARC_UPPER), (size_t)space_sites(s, ARC_LOWER)};
  double *values = malloc(NAMES * (n[0] + n[1]) * sizeof *values);
  arc_array list[ARC_BODIES * NAMES + FRICTION_ARRAYS];
  const int extra = more ? FRICTION_ARRAYS : 0, all = ARC_BODIES * count + extra;
  *result = NULL;
  if (values) {
    double *of[] = {values, values + NAMES * n[0]};
    for (int b = 0; b < ARC_BODIES; b++) fill(s, b, pressure, at, of[b]);
    for (int i = 0; i < extra; i++) list[count + i] = more[i];
    for (int i = 0; i < ARC_BODIES * count; i++) {
      const int b = i / count, name = wanted[i % count];
      list[b == ARC_UPPER ? i : i + extra] = (arc_array){
          names[name], (arc_body)b, update, distance, {n[b], 1}, of[b] + (size_t)name * n[b]};
    }
    *result = arc_arrays_copy(list, (size_t)all);
  }
  free(values);
  if (!*result) return arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a contact");
  *arrays = (size_t)all;
  return ARC_OK;
}

arc_status arc_space_show_contact(const arc_contact *contact, arc_array **surfaces, size_t *count,
                                  arc_error *error) {
  static const int wanted[] = {X, Z, P};
  const space_contact *c = (const space_contact *)(const void *)contact;
  const space_shape *s = space_shape_of(c->handle.shape);
  const arc_halfspace_friction *f = &c->rubbing;
  const size_t n = (size_t)space_sites(s, ARC_UPPER);
  if (!f->pressure)
    return show(s, c->pressure, c->handle.def.x, 0, 0, wanted, 3, NULL, surfaces, count, error);
  double *size = malloc(2 * n * sizeof *size);
  if (!size) return arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a contact");
  arc_space_sizes(c, size, size + n);
  const arc_array more[FRICTION_ARRAYS] = {
      {"q", ARC_UPPER, 0, 0, {n, 1}, f->q[0]},     {"qz", ARC_UPPER, 0, 0, {n, 1}, f->q[1]},
      {"shear", ARC_UPPER, 0, 0, {n, 1}, size},    {"s", ARC_UPPER, 0, 0, {n, 1}, f->slip[0]},
      {"sz", ARC_UPPER, 0, 0, {n, 1}, f->slip[1]}, {"slip", ARC_UPPER, 0, 0, {n, 1}, size + n}};
  const arc_status status =
      show(s, c->pressure, c->origin + f->travel[0], 0, 0, wanted, 3, more, surfaces, count, error);
  free(size);
  return status;
}

arc_status arc_space_show(const arc_wear *w, arc_array **surfaces, size_t *count,
                          arc_error *error) {
  static const int wanted[] = {X, Z, H, Y, P};
  const arc_wear_record *last = arc_wear_last(w);
  const space_shape *s = space_shape_of(w->shape);
  arc_halfspace_report report;
  double approach;
  *surfaces = NULL;
  *count = 0;
  double *pressure = calloc((size_t)w->nc, sizeof *pressure);
  if (!pressure) return arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a run");
  arc_status status = solve_at(s, 0, w->def.load, NULL, pressure, &approach, &report, error);
  if (status == ARC_OK)
    status = show(s, pressure, 0, last->update, last->distance, wanted, NAMES, NULL, surfaces,
                  count, error);
  free(pressure);
  return status;
}

/* --- the reference configuration -------------------------------------------------------------- */

static double deepest(const space_shape *s, int b) {
  double most = 0;
  for (int i = 0; i < space_sites(s, b); i++) most = fmax(most, s->depth[b][i]);
  return most;
}

arc_status arc_space_hold_load(const space_shape *s, double load, arc_error *error) {
  arc_halfspace_report report;
  double approach, *pressure = calloc((size_t)space_sites(s, ARC_UPPER), sizeof *pressure);
  if (!pressure) return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
  const arc_status status = solve_at(s, 0, load, NULL, pressure, &approach, &report, error);
  free(pressure);
  return status;
}

arc_status arc_space_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                             arc_error *error) {
  const space_shape *s = space_shape_of(shape);
  const arc_halfspace_def *d = arc_halfspace_definition(s->grid->h);
  arc_halfspace_report report;
  double approach, *pressure = calloc((size_t)space_sites(s, ARC_UPPER), sizeof *pressure);
  if (!pressure) return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
  const arc_status status = solve_at(s, 0, w->def.load, NULL, pressure, &approach, &report, error);
  if (status == ARC_OK) {
    const arc_halfspace_extent e = arc_halfspace_contact_extent(s->grid->h, pressure);
    record->p_center = e.center;
    record->p_max = e.largest;
    record->half_width = e.half_width;
    record->half_width_z = e.half_width_z;
    record->area = e.area;
    record->solutions += 1;
    record->load_reference = w->def.load;
    record->elements = (double)d->nx * d->nz;
    record->depth_cylinder = deepest(s, ARC_UPPER);
    record->depth_plate = deepest(s, ARC_LOWER);
    record->depth_partition = arc_depth_partition(record->depth_cylinder, record->depth_plate);
    if (w->def.blocks == 0 || record->p_peak == 0)
      record->p_peak = fmax(record->p_peak, record->p_max);
  }
  free(pressure);
  return status;
}

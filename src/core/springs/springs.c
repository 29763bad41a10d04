/* Kind of pair: a rigid ball and a rigid flat, each with a layer of independent springs (Winkler
 * foundation). The sites form a square grid about x = z = 0. The contact does not move; the
 * flat is assumed to slide by less than the contact's width. At each site the pressure p = K
 * (approach - recess - depths) wears both bodies. `recess` is the height of the unworn ball
 * above its lowest point. K = 1 / (t / M_upper + t / M_lower) is the stiffness of both layers
 * [MPa/mm], where t is the thickness of each layer and M = E (1 - nu) / ((1 + nu) (1 - 2 nu)).
 * For unworn surfaces load = pi R K approach^2.
 *
 * This file is an example of a kind of pair. Other files refer to it only in the table of kinds
 * and the list of geometries. */
#include "archard/measure.h"
#include "core/base/carve.h"
#include "core/pair/model.h"
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct springs {
  arc_model handle;
  int row, count;     /* number of sites in a row along x, and number of all sites */
  double area, K;     /* area of a site [mm2]; stiffness [MPa/mm] */
  double *x, *recess; /* x and recess of each site [mm], row by row; middle row: z = 0 */
} springs;

typedef struct spring_surfaces {
  shape_handle handle;
  double *h[ARC_BODIES], *y[ARC_BODIES], *p; /* depth, height [mm]; pressure [MPa] */
} spring_surfaces;

static const springs *model_of(const arc_model *model) {
  return (const springs *)model;
}
static const spring_surfaces *on(const arc_shape *shape) {
  return (const spring_surfaces *)(const void *)shape;
}
static const springs *under(const arc_shape *shape) {
  return model_of(arc_shape_model(shape));
}
static arc_status no_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for springs");
}

/* --- the model -------------------------------------------------------------------------------- */

static double modulus(const arc_material m) {
  return m.E * (1 - m.nu) / ((1 + m.nu) * (1 - 2 * m.nu));
}

static arc_status check_model(const arc_model_def *def, arc_error *error) {
  const arc_status status = arc_settings_check(arc_model_settings, "", def, error);
  if (status == ARC_OK && def->periodic)
    return arc_fail(error, ARC_ARGUMENT, "field 'periodic': springs are not periodic");
  if (status != ARC_OK || arc_model_is_hertzian(def)) return status;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'geometry': springs are only for a ball and a flat without layers");
}

static size_t model_bytes(const arc_model *model) {
  return sizeof(springs) + 2 * (size_t)model_of(model)->count * sizeof(double);
}

static void end_model(arc_model *model) {
  free(((springs *)model)->x);
  free(model);
}

static arc_status build(const arc_model_def *def, const arc_callbacks *callbacks,
                        arc_model **result, arc_error *error) {
  (void)callbacks;
  *result = NULL;
  const arc_status status = check_model(def, error);
  springs *s = status == ARC_OK ? calloc(1, sizeof *s) : NULL;
  if (!s) return status == ARC_OK ? no_memory(error) : status;
  s->handle = (arc_model){.kind = arc_kind_of(def->geometry), .references = 1, .def = *def};
  arc_mesh_def *mesh = &s->handle.def.mesh;
  if (mesh->size == 0) mesh->size = 0.02;
  if (mesh->zone[ARC_LOWER] == 0) mesh->zone[ARC_LOWER] = 60 * mesh->size;
  s->K = 1 / (def->thickness / modulus(def->material[ARC_UPPER]) +
              def->thickness / modulus(def->material[ARC_LOWER]));
  const int half = (int)fmin(500, ceil(mesh->zone[ARC_LOWER] / mesh->size / 2 - 1e-9));
  s->row = 2 * half + 1;
  s->count = s->row * s->row;
  s->area = mesh->size * mesh->size;
  const size_t n = (size_t)s->count;
  const carve_part parts[] = {{&s->x, n}, {&s->recess, n}};
  if (!ARC_CARVE(parts)) {
    free(s);
    return no_memory(error);
  }
  for (int i = 0; i < s->count; i++) {
    s->x[i] = (i % s->row - half) * mesh->size;
    const double z = (i / s->row - half) * mesh->size;
    s->recess[i] = (s->x[i] * s->x[i] + z * z) / (2 * def->radius);
  }
  *result = &s->handle;
  return ARC_OK;
}

/* --- one contact ------------------------------------------------------------------------------ */

/* Computes the pressures p under a load [N] with the compliance `a` [mm/MPa]. At each site a p =
 * approach - gap if this difference is positive, otherwise p = 0. Newton's method starts from a
 * larger approach. On input p contains the gaps of the unloaded surfaces. */
static arc_status press(const springs *s, double a, double load, double *p, arc_error *error) {
  const double total = load * a / s->area;
  double approach = 0;
  for (int i = 0; i < s->count; i++) approach = fmax(approach, p[i]);
  approach += total / s->count;
  for (int active = s->count + 2, now = s->count + 1; now < active;) {
    double sum = total;
    active = now;
    now = 0;
    for (int i = 0; i < s->count; i++)
      if (p[i] < approach) sum += p[i], now++;
    approach = sum / now;
  }
  for (int i = 0; i < s->count; i++) {
    p[i] = fmax(0, (approach - p[i]) / a);
    const int at = i % s->row, edge = at == 0 || at == s->row - 1;
    if (p[i] > 0 && (edge || i < s->row || i >= s->count - s->row))
      return arc_fail(
          error, ARC_ZONE,
          "the contact reaches the edge of the springs: mesh.zone = %g mm is too narrow",
          s->handle.def.mesh.zone[ARC_LOWER]);
  }
  return ARC_OK;
}

/* Computes the gaps of the unloaded surfaces at all sites after further wear of both bodies by
 * `depth` (NULL: no further wear). */
static void gaps(const arc_shape *shape, const double *depth, double *gap) {
  const springs *s = under(shape);
  const spring_surfaces *f = on(shape);
  for (int i = 0; i < s->count; i++) {
    gap[i] = s->recess[i] + f->h[ARC_UPPER][i] + f->h[ARC_LOWER][i];
    if (depth) gap[i] += depth[i] + depth[s->count + i];
  }
}

/* --- surfaces --------------------------------------------------------------------------------- */

static void discard(arc_shape **shape) {
  spring_surfaces *f = (spring_surfaces *)(void *)*shape;
  if (!f) return;
  free(f->h[0]);
  arc_model_release(&f->handle.model);
  free(f);
  *shape = NULL;
}

/* Computes the heights of both surfaces. y points upwards and is 0 at the lowest point of the
 * unworn ball and on the unworn flat. */
static void read_heights(const springs *s, spring_surfaces *f) {
  for (int i = 0; i < s->count; i++) {
    f->y[ARC_UPPER][i] = s->recess[i] + f->h[ARC_UPPER][i];
    f->y[ARC_LOWER][i] = -f->h[ARC_LOWER][i];
  }
}

static arc_status create(arc_model *model, const double *const h[ARC_BODIES], arc_shape **shape,
                         arc_error *error) {
  const springs *s = model_of(model);
  const size_t n = (size_t)s->count;
  spring_surfaces *f = calloc(1, sizeof *f);
  *shape = (arc_shape *)(void *)f;
  if (!f) return no_memory(error);
  const carve_part parts[] = {
      {&f->h[0], n}, {&f->h[1], n}, {&f->y[0], n}, {&f->y[1], n}, {&f->p, n}};
  f->handle.model = arc_model_retain(model);
  if (!ARC_CARVE(parts)) {
    discard(shape);
    return no_memory(error);
  }
  for (int b = 0; b < ARC_BODIES && h; b++) memcpy(f->h[b], h[b], n * sizeof(double));
  read_heights(s, f);
  return ARC_OK;
}

static arc_status copy(const arc_shape *shape, arc_shape **result, arc_error *error) {
  const double *const h[] = {on(shape)->h[0], on(shape)->h[1]};
  return create(arc_shape_model(shape), h, result, error);
}

static arc_status surfaces(arc_model *model, const arc_wear_def *def, const arc_shape *from,
                           arc_shape **shape, arc_error *error) {
  (void)def;
  return from ? copy(from, shape, error) : create(model, NULL, shape, error);
}

static wear_sites sites(const arc_shape *shape, arc_body body) {
  return (wear_sites){under(shape)->count, under(shape)->x, on(shape)->h[body], NULL};
}

static double area(const arc_shape *shape, arc_body body, int i) {
  (void)body, (void)i;
  return under(shape)->area;
}

static arc_profile profile(const arc_shape *shape, arc_body body) {
  const springs *s = under(shape);
  const int first = s->row * (s->row / 2);
  const double *x = s->x + first, *h = on(shape)->h[body] + first;
  return (arc_profile){s->row, x, h, on(shape)->y[body] + first, x, h};
}

static double deepest(const arc_shape *shape, arc_body body) {
  double most = 0;
  for (int i = 0; i < under(shape)->count; i++) most = fmax(most, on(shape)->h[body][i]);
  return most;
}

static void add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                        arc_wear_record *record) {
  double *const volume[] = {&record->volume_cylinder, &record->volume_plate};
  (void)w;
  for (int b = 0; b < ARC_BODIES; b++) {
    double sum = 0;
    for (int i = 0; i < under(shape)->count; i++) sum += depth->node[b][i];
    *volume[b] += sum * under(shape)->area;
  }
}

static arc_status wear(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                       arc_wear_record *record, arc_error *error) {
  spring_surfaces *f = (spring_surfaces *)(void *)shape;
  (void)error;
  add_volumes(w, shape, depth, record);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < under(shape)->count; i++) f->h[b][i] += depth->node[b][i];
  read_heights(under(shape), f);
  return ARC_OK;
}

static arc_status measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                          arc_error *error) {
  const springs *s = under(shape);
  double *p = on(shape)->p;
  int touching = 0;
  gaps(shape, NULL, p);
  const arc_status status = press(s, 1 / s->K, w->def.load, p, error);
  if (status != ARC_OK) return status;
  record->p_center = p[s->count / 2];
  record->p_max = 0;
  for (int i = 0; i < s->count; i++) {
    record->p_max = fmax(record->p_max, p[i]);
    touching += p[i] > 0;
  }
  record->p_peak = fmax(record->p_peak, record->p_max);
  record->half_width = sqrt(touching * s->area / acos(-1));
  record->load_reference = w->def.load;
  record->elements = 2 * s->count;
  record->solutions += 1;
  record->depth_cylinder = deepest(shape, ARC_UPPER);
  record->depth_plate = deepest(shape, ARC_LOWER);
  record->depth_partition = arc_depth_partition(record->depth_cylinder, record->depth_plate);
  return ARC_OK;
}

/* --- definitions and runs --------------------------------------------------------------------- */

static arc_status refuse(const char *field, const char *why, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': on springs expected %s", field, why);
}

static arc_status check(const arc_wear_def *d, const arc_model_def *model, arc_error *error) {
  if (arc_wear_has_friction(d)) return refuse("friction", "0", error);
  if (d->slip != ARC_SLIP_RIGID) return refuse("slip", "\"rigid\"", error);
  if (d->track > 0 || d->spin > 0) return refuse("track and spin", "none", error);
  if (d->procedure == ARC_NSP) return refuse("procedure", "\"SP\"", error);
  if (d->blocks == 0 && d->stroke >= model->radius)
    return refuse("stroke", "less than the radius", error);
  if (d->scheme != ARC_IMPLICIT) return ARC_OK;
  if (d->local_factor) return refuse("local_factor", "none with scheme = \"implicit\"", error);
  if (!(arc_law_properties[d->law] & ARC_LAW_LINEAR))
    return refuse("law", "\"archard\" with scheme = \"implicit\"", error);
  for (int b = 0; b < d->blocks; b++)
    for (int i = 1; i < d->loading[b].count; i++)
      if (d->loading[b].load[i] != d->loading[b].load[0])
        return refuse("loading",
                      "the same load in all increments of a block if scheme = \"implicit\"", error);
  return ARC_OK;
}

static wear_manner manner(const arc_wear_def *def, const arc_model_def *model) {
  (void)model;
  return (wear_manner){.procedure = ARC_SP,
                       .strokes = 2,
                       .stroke = def->stroke,
                       .modulus = 1,
                       .thickness = 1,
                       .rests = 1};
}

static arc_status begin(arc_wear *w) {
  w->nc = w->np = model_of(w->model)->count;
  w->own = calloc(2 * (size_t)w->nc, sizeof(double)); /* pressures, then local factors */
  return w->own ? ARC_OK : ARC_MEMORY;
}

static void end(arc_wear *w) {
  free(w->own);
}

static arc_status check_reach(arc_wear *w, arc_error *error) {
  gaps(w->shape, NULL, w->own);
  return press(model_of(w->model), 1 / model_of(w->model)->K, w->def.load, w->own, error);
}

/* --- the cycle -------------------------------------------------------------------------------- */

/* Returns the weight of point `at` in the wear of a window: the part of the sliding distance
 * that the point represents [mm]. */
static double weight(const arc_wear *w, const wear_window *window, int at) {
  const wear_block *b = window->block;
  const double before = at > window->first ? fabs(b->x[at] - b->x[at - 1]) : 0;
  const double after = at < window->last ? fabs(b->x[at + 1] - b->x[at]) : 0;
  return b->repeat * (w->def.rule == ARC_TRAPEZOID ? (before + after) / 2 : before);
}

/* The Jacobian -d rate / d depth at a constant approach is diagonal. Only its largest entry is
 * stored. */
typedef struct spring_tangent {
  double value;
} spring_tangent;

static arc_status add_point(arc_wear *w, const wear_window *window, double share, wear_rate *rate,
                            arc_error *error) {
  const springs *s = model_of(w->model);
  double *p = w->own, *factor = p + s->count, steepest = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    const int local = w->def.local_factor && window->state;
    const wear_sites on = w->kind->sites(w->shape, (arc_body)b);
    arc_status status = ARC_OK;
    if (local) status = arc_wear_local(w, window->state, (arc_body)b, &on, p, factor, error);
    if (status != ARC_OK) return status;
    for (int i = 0; i < s->count; i++) {
      const double q = (local ? factor[i] : 1) * arc_wear_law(w, p[i]);
      rate->node[b][i] += share * q;
      rate->peak = fmax(rate->peak, p[i]);
      if (window->tangent && p[i] > 0) steepest = fmax(steepest, arc_wear_law_slope(w, p[i], q));
    }
  }
  if (window->tangent)
    ((spring_tangent *)(void *)window->tangent)->value += share * s->K * steepest;
  return ARC_OK;
}

static arc_status rate_of(arc_wear *w, const wear_window *window, wear_progress *progress,
                          wear_rate *rate, arc_error *error) {
  const springs *s = model_of(w->model);
  arc_status status = ARC_OK;
  arc_wear_rate_clear(rate, w->nc + w->np);
  if (window->tangent) ((spring_tangent *)(void *)window->tangent)->value = 0;
  for (int at = window->first; at <= window->last && status == ARC_OK; at++) {
    const double load = window->block->line[at];
    if (load == 0) continue;
    gaps(window->shape, window->depth, w->own);
    status = press(s, 1 / s->K, load, w->own, error);
    progress->solutions++;
    if (status == ARC_OK) status = add_point(w, window, weight(w, window, at), rate, error);
  }
  return status;
}

static wear_tangent *tangent(const arc_wear *w) {
  (void)w;
  return (wear_tangent *)calloc(1, sizeof(spring_tangent));
}

static void end_tangent(wear_tangent **t) {
  free(*t);
  *t = NULL;
}

static double eigenvalue(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *t,
                         const arc_callbacks *callbacks) {
  (void)w, (void)callbacks;
  return (k[ARC_UPPER] + k[ARC_LOWER]) * ((const spring_tangent *)(const void *)t)->value;
}

/* --- stages of implicit steps ----------------------------------------------------------------- */

/* Solves a stage of h cycles. The wear depth per pressure in h cycles is added to the compliance
 * of the springs. */
static arc_status stage(wear_stage *s, double h, double *rate) {
  const arc_wear *w = s->run;
  const springs *m = model_of(w->model);
  double *p = w->own, sliding = 0, soft = 1 / m->K;
  for (int at = s->window.first; at <= s->window.last; at++) sliding += weight(w, &s->window, at);
  for (int b = 0; b < ARC_BODIES; b++) soft += h * s->k[b] * sliding;
  gaps(s->window.shape, s->known, p);
  const double load = s->window.block->line[s->window.first];
  const arc_status status = press(m, soft, load, p, &s->error);
  s->progress->solutions++;
  s->last = (wear_rate){.peak = 0};
  for (int i = 0; i < m->count && status == ARC_OK; i++) {
    s->last.peak = fmax(s->last.peak, p[i]);
    for (int b = 0, at = i; b < ARC_BODIES; b++, at += m->count) {
      rate[at] = s->k[b] * sliding * p[i];
      s->z[at] = s->worn[at] = s->known[at] + h * rate[at];
    }
  }
  return status;
}

static arc_status start(wear_stage *s, double *rate) {
  return stage(s, 0, rate);
}

static double stage_error(wear_stage *s, double h, double *defect) {
  const springs *m = model_of(s->run->model);
  double soft = 1 / m->K, sliding = 0, most = 0;
  for (int at = s->window.first; at <= s->window.last; at++)
    sliding += weight(s->run, &s->window, at);
  for (int b = 0; b < ARC_BODIES; b++) soft += h * s->k[b] * sliding;
  for (int i = 0; i < m->count; i++) {
    const double change = (defect[i] + defect[m->count + i]) / (soft * m->K);
    for (int at = i; at < 2 * m->count; at += m->count) defect[at] /= soft * m->K;
    most = fmax(most, fabs(change * m->K));
  }
  return s->last.peak > 0 ? most / s->last.peak : 0;
}

static double natural_depth(const arc_wear *w) {
  const springs *s = model_of(w->model);
  return sqrt(w->def.load / (acos(-1) * s->handle.def.radius * s->K));
}

/* --- results and storage ---------------------------------------------------------------------- */

/* Creates arrays of the positions, depths, heights and pressures of both bodies on the middle
 * row of sites. */
static arc_status show(const arc_wear *w, arc_array **arrays, size_t *count, arc_error *error) {
  enum { names = 4 };
  const springs *s = model_of(w->model);
  const arc_wear_record *last = arc_wear_last(w);
  const double *p = on(w->shape)->p;
  arc_array list[ARC_BODIES * names];
  gaps(w->shape, NULL, on(w->shape)->p);
  *arrays = NULL;
  *count = 0;
  const arc_status status = press(s, 1 / s->K, w->def.load, on(w->shape)->p, error);
  if (status != ARC_OK) return status;
  for (int i = 0; i < ARC_BODIES * names; i++) {
    const arc_body body = (arc_body)(i / names);
    const arc_profile line = profile(w->shape, body);
    const double *const values[names] = {line.x, line.h, line.y, p + s->row * (s->row / 2)};
    list[i] = (arc_array){arc_surface_names[i % names],
                          body,
                          last->update,
                          last->distance,
                          {(size_t)s->row, 1},
                          values[i % names]};
  }
  *arrays = arc_arrays_copy(list, ARC_BODIES * names);
  *count = *arrays ? ARC_BODIES * names : 0;
  return *arrays ? ARC_OK : no_memory(error);
}

static arc_array *save(const arc_shape *shape, size_t *count) {
  const size_t n = (size_t)under(shape)->count;
  const arc_array list[] = {{"h", ARC_UPPER, 0, 0, {n, 1}, on(shape)->h[ARC_UPPER]},
                            {"h", ARC_LOWER, 0, 0, {n, 1}, on(shape)->h[ARC_LOWER]}};
  *count = 2;
  return arc_arrays_copy(list, 2);
}

static arc_status load(arc_model *model, const arc_wear_def *def, const arc_array *state,
                       size_t count, arc_shape **shape, arc_error *error) {
  const double *h[ARC_BODIES];
  (void)def;
  *shape = NULL;
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_array *found = arc_array_find(state, count, (arc_body)b, "h");
    if (!found || arc_array_count(found) != (size_t)model_of(model)->count)
      return arc_fail(error, ARC_ARGUMENT, "the %s's state: expected %d depths",
                      arc_body_name((arc_body)b), model_of(model)->count);
    h[b] = found->values;
    for (int i = 0; i < model_of(model)->count; i++)
      if (!(h[b][i] >= 0 && h[b][i] < 1e6))
        return arc_fail(error, ARC_ARGUMENT, "the %s's state: expected depths in mm, got %g",
                        arc_body_name((arc_body)b), h[b][i]);
  }
  return create(model, h, shape, error);
}

/* clang-format off */
const arc_kind arc_springs_kind = {
    .name = "springs",
    .check_model = check_model, .build = build, .end_model = end_model,
    .model_bytes = model_bytes, .check = check, .manner = manner, .begin = begin, .end = end,
    .check_reach = check_reach, .surfaces = surfaces, .copy = copy, .discard = discard,
    .sites = sites, .area = area, .profile = profile, .deepest = deepest,
    .add_volumes = add_volumes, .wear = wear, .measure = measure, .rate = rate_of,
    .tangent = tangent, .end_tangent = end_tangent, .eigenvalue = eigenvalue, .start = start,
    .stage = stage, .error = stage_error, .natural_depth = natural_depth, .show = show,
    .save = save, .load = load,
};
/* clang-format on */

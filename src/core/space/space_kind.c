/* Implements half-spaces as a kind of pair: the table of functions of this kind, and the short
 * functions. */
#include "core/space/space_kind.h"

#include "core/base/callbacks.h"

#include <math.h>

/* --- runs ------------------------------------------------------------------------------------- */

static arc_status begin(arc_wear *w) {
  const space_shape *s = space_shape_of(w->shape);
  w->nc = space_sites(s, ARC_UPPER);
  w->np = space_sites(s, ARC_LOWER);
  return ARC_OK;
}

static void end(arc_wear *w) {
  (void)w;
}

static size_t bytes(const arc_wear *w) {
  const arc_halfspace_def *d = arc_halfspace_definition(space_shape_of(w->shape)->grid->h);
  return (size_t)arc_halfspace_bytes(d, 2) + arc_space_tangent_bytes(w);
}

/* Rejects a stroke that is not along the axis of the cells, and a track whose radius is at most the
 * width of the contact. */
static arc_status check_reach(arc_wear *w, arc_error *error) {
  const int turned = w->def.slide == ARC_SLIDE_Z;
  const arc_wear_record *last = w->records > 0 ? arc_wear_last(w) : NULL;
  if (space_turned(space_shape_of(w->shape)) != turned)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'slide': in 3-D expected \"%s\", along which these surfaces were worn",
                    arc_slide_names[!turned]);
  if (w->def.track == 0 || !last || w->def.track > 2 * last->half_width) return ARC_OK;
  return arc_fail(error, ARC_GEOMETRY,
                  "field 'track': expected more than the contact's width %g mm, got %g mm",
                  2 * last->half_width, w->def.track);
}

static void warn(const arc_wear *w, int unworn, const arc_callbacks *callbacks) {
  const arc_halfspace_def *d = arc_halfspace_definition(space_shape_of(w->shape)->grid->h);
  const arc_model_def *model = arc_model_definition(w->model);
  const arc_wear_record *last = arc_wear_last(w);
  if (unworn) arc_space_warn(model, d, last->half_width, last->half_width_z, callbacks);
  if (unworn) arc_space_warn_slip(&w->def, model, d->size_x, callbacks);
}

enum { SHORT = 1, TOO_SHORT = 2, STEEP = 4 }; /* warnings of warn_late */

/* Warns if the stroke is shorter than three contact widths, and again if it is shorter than two,
 * because a groove is computed without its ends. */
static int warn_short(const arc_wear *w, int given, const arc_callbacks *callbacks) {
  static const double enough = 3, least = 2;
  const arc_halfspace_def *d = arc_halfspace_definition(space_shape_of(w->shape)->grid->h);
  const arc_wear_record *last = arc_wear_last(w);
  const double along = space_along(space_shape_of(w->shape), last->half_width, last->half_width_z);
  const double widths = d->groove / (2 * along);
  if (d->groove == 0 || w->def.track > 0 || d->periodic || widths >= enough) return given;
  const int now = widths < least ? SHORT | TOO_SHORT : SHORT;
  if ((given | now) != given)
    arc_warn(callbacks,
             "procedure \"NSP\" treats the track as an endless groove, and the stroke is only %.2g "
             "contact widths now: below %g widths the errors of depths exceed 3 %%, below %g they "
             "are 15 %% and more; use \"SP\"",
             widths, enough, least);
  return given | now;
}

/* Warns of limits of the half-spaces that wear has crossed. */
static int warn_late(const arc_wear *w, int given, const arc_callbacks *callbacks) {
  const arc_model_def *model = arc_model_definition(w->model);
  const arc_wear_record *first = w->history, *last = arc_wear_last(w);
  given = warn_short(w, given, callbacks);
  if (given & STEEP || arc_space_warn_steep(model, first->half_width, first->half_width_z, NULL))
    return given;
  return arc_space_warn_steep(model, last->half_width, last->half_width_z, callbacks)
             ? given | STEEP
             : given;
}

/* --- surfaces --------------------------------------------------------------------------------- */

/* Creates unworn surfaces with cells for the default load. A contact under another load chooses new
 * cells. */
static arc_status unworn(arc_model *model, arc_geometry geometry, double refresh, arc_shape **shape,
                         arc_error *error) {
  arc_halfspace_def cells;
  (void)geometry;
  (void)refresh;
  arc_space_fit(arc_model_definition(model), 0, arc_contact_default().load, 0, 0, 0, &cells);
  return arc_space_create(model, &cells, (space_shape **)(void *)shape, error);
}

static wear_sites sites(const arc_shape *shape, arc_body body) {
  const space_shape *s = space_shape_of(shape);
  return (wear_sites){space_sites(s, (int)body), s->grid->x[body], s->depth[body],
                      s->grid->z[body]};
}

/* Returns the profile along the motion in the middle of the body, in arrays that belong to the
 * shape. */
static arc_profile profile(const arc_shape *shape, arc_body body) {
  const space_shape *s = space_shape_of(shape);
  const arc_halfspace_def *d = arc_halfspace_definition(s->grid->h);
  const int nz = d->nz, rows = space_sites(s, (int)body) / nz;
  const double *recess = arc_halfspace_recess(s->grid->h, body);
  double *x = s->line[body], *h = x + rows, *y = h + rows;
  for (int i = 0; i < rows; i++) {
    const int at = i * nz + nz / 2;
    x[i] = d->turned ? s->grid->z[body][at] : s->grid->x[body][at];
    h[i] = s->depth[body][at];
    y[i] = (body == ARC_UPPER ? 1 : -1) * (recess[at] + h[i]);
  }
  return (arc_profile){.count = rows, .x = x, .h = h, .y = y, .worn_x = x, .way = h};
}

static double area(const arc_shape *shape, arc_body body, int i) {
  (void)i;
  return arc_halfspace_site_area(space_shape_of(shape)->grid->h, body);
}

static double deepest(const arc_shape *shape, arc_body body) {
  const wear_sites on = sites(shape, body);
  double most = 0;
  for (int i = 0; i < on.count; i++) most = fmax(most, on.h[i]);
  return most;
}

static void add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                        arc_wear_record *record) {
  double sum[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < sites_of(w, b); i++) sum[b] += depth->node[b][i];
  record->volume_cylinder += sum[ARC_UPPER] * area(shape, ARC_UPPER, 0);
  record->volume_plate += sum[ARC_LOWER] * area(shape, ARC_LOWER, 0);
}

static arc_status wear(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                       arc_wear_record *record, arc_error *error) {
  space_shape *s = (space_shape *)(void *)shape;
  (void)error;
  arc_space_through_layers(shape, depth->node[ARC_UPPER]);
  add_volumes(w, shape, depth, record);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < sites_of(w, b); i++) s->depth[b][i] += depth->node[b][i];
  return ARC_OK;
}

/* --- step lengths */

static double natural_depth(const arc_wear *w) {
  return arc_space_hertz(arc_model_definition(w->model), w->def.load).approach / 2;
}

/* --- growth of the window --------------------------------------------------------------------- */

static int must_grow(const arc_wear *w, arc_error *why) {
  arc_halfspace_def coarser;
  if (!arc_space_coarsen(w, &coarser)) return 0;
  arc_fail(why, ARC_ZONE, "the contact has become too wide for its cells");
  return 1;
}

static int has_outgrown(const arc_wear *w, arc_status why) {
  (void)w;
  return why == ARC_ZONE;
}

static int can_grow(const arc_wear *w) {
  (void)w;
  return 1;
}

static arc_status grow(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                       arc_wear **result, arc_error *error) {
  const space_shape *s = space_shape_of(w->shape);
  arc_halfspace_def cells;
  space_shape *larger = NULL;
  (void)why;
  (void)callbacks;
  *result = NULL;
  arc_status status = arc_space_coarsen(w, &cells)
                          ? ARC_OK
                          : arc_space_widen(arc_model_definition(w->model), 8, &cells, error);
  if (status == ARC_OK) status = arc_space_regrow(s, &cells, &larger, error);
  if (status != ARC_OK) return status;
  arc_shape *shape = (arc_shape *)(void *)larger;
  status = arc_wear_restore(w->model, &w->def, shape, w->history, w->records, result, error);
  arc_space_discard(&shape);
  return status;
}

static arc_status remesh(const arc_wear *w, const arc_mesh_def *mesh,
                         const arc_callbacks *callbacks, arc_wear **result, arc_error *error) {
  (void)w;
  (void)mesh;
  (void)callbacks;
  *result = NULL;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'mesh': cells of a run in 3-D cannot be changed; make a new run");
}

static void report_nothing(const arc_wear *before, const arc_wear *now,
                           const arc_callbacks *callbacks) {
  (void)before;
  (void)now;
  (void)callbacks;
}

static arc_status refuse(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                         arc_error *error) {
  (void)w;
  const int room = trouble->message[0] != '\0';
  return arc_fail(error, why->status, "%s%s%s%s", why->message, room ? " (" : "", trouble->message,
                  room ? ")" : "");
}

/* --- results */

static arc_status contact(const arc_wear *w, arc_contact **result, arc_error *error) {
  arc_contact_def def = arc_contact_default();
  def.load = w->def.load;
  return arc_contact_solve(w->shape, &def, NULL, result, error);
}

/* Returns the amplitude of the sawtooth (oscillation from point to point) in the wear depth along
 * the body's middle line in the direction of motion, divided by the body's largest depth. */
static double roughness(const arc_wear *w, arc_body body) {
  const arc_profile line = profile(w->shape, body);
  const arc_wear_record *last = arc_wear_last(w);
  const double most = deepest(w->shape, body);
  const double reach =
      0.8 * space_along(space_shape_of(w->shape), last->half_width, last->half_width_z);
  const double saw = arc_measure_sawtooth(line.x, line.h, (size_t)line.count, -reach, reach);
  return most > 0 ? saw / most : 0;
}

static arc_status validate(const arc_wear *w, arc_error *error) {
  arc_contact *solved;
  for (int b = 0; b < ARC_BODIES; b++) {
    const wear_sites on = sites(w->shape, (arc_body)b);
    for (int i = 0; i < on.count; i++)
      if (!isfinite(on.h[i]))
        return arc_fail(error, ARC_NUMERIC, "surface: depth %d of the %s is not finite: %g", i,
                        arc_body_name((arc_body)b), on.h[i]);
  }
  const arc_status status = contact(w, &solved, error);
  if (status == ARC_OK) arc_contact_destroy(&solved);
  return status;
}

static const arc_growth growth = {
    .must_grow = must_grow,
    .has_outgrown = has_outgrown,
    .can_grow = can_grow,
    .grow = grow,
    .remesh = remesh,
    .report = report_nothing,
    .report_mesh = report_nothing,
    .refuse = refuse,
};

const arc_kind arc_space_kind = {
    .name = "space",
    .elastic = 1,
    .maps = 1,
    .check_model = arc_space_check_model,
    .build = arc_space_build,
    .end_model = arc_space_end_model,
    .model_bytes = arc_space_model_bytes,
    .prefers_implicit = arc_space_prefers_implicit,
    .check = arc_space_check,
    .manner = arc_space_manner,
    .increments = arc_space_increments,
    .parts = arc_space_parts,
    .reach = arc_space_reach,
    .begin = begin,
    .end = end,
    .bytes = bytes,
    .check_reach = check_reach,
    .warn = warn,
    .warn_late = warn_late,
    .surfaces = arc_space_surfaces,
    .unworn = unworn,
    .copy = arc_space_copy,
    .discard = arc_space_discard,
    .sites = sites,
    .area = area,
    .profile = profile,
    .deepest = deepest,
    .through_layers = arc_space_through_layers,
    .add_volumes = add_volumes,
    .wear = wear,
    .measure = arc_space_measure,
    .rate = arc_space_rate,
    .loop = arc_space_loop,
    .tangent = arc_space_tangent,
    .end_tangent = arc_space_end_tangent,
    .eigenvalue = arc_space_eigenvalue,
    .begin_stages = arc_space_begin_stages,
    .start = arc_space_start,
    .stage = arc_space_stage,
    .error = arc_space_error,
    .end_stages = arc_space_end_stages,
    .natural_depth = natural_depth,
    .open_share = arc_space_open_share,
    .growth = &growth,
    .solve = arc_space_solve,
    .move = arc_space_move,
    .end_contact = arc_space_end_contact,
    .contact_bytes = arc_space_contact_bytes,
    .show_contact = arc_space_show_contact,
    .contact = contact,
    .show = arc_space_show,
    .save = arc_space_save,
    .load = arc_space_load,
    .roughness = roughness,
    .validate = validate,
};

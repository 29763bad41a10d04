/* Computes increments of a contact with friction. The solution alternates between the pressures at
 * fixed shear and the shear at fixed pressures until both converge. For equal materials one pass
 * suffices. */
#include "core/space/entering.h"
#include "core/space/stick_slip.h"
#include "core/space/stroke.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- states ----------------------------------------------------------------------------------- */

enum { FIELDS = 8 };

static void place_fields(arc_halfspace_friction *s, double *block, size_t n) {
  s->pressure = block;
  for (size_t i = 0; i < 2; i++) {
    s->q[i] = block + (1 + i) * n;
    s->slip[i] = block + (3 + i) * n;
    s->moved[i] = block + (5 + i) * n;
  }
  s->stick = block + 7 * n;
}

arc_status arc_halfspace_friction_begin(const arc_halfspace *h, arc_halfspace_friction *state,
                                        arc_error *error) {
  const size_t n = (size_t)h->cells;
  double *block = calloc(FIELDS * n, sizeof *block);
  *state = (arc_halfspace_friction){.pressure = block};
  if (!block) return arc_fail(error, ARC_MEMORY, "out of memory for a contact with friction");
  place_fields(state, block, n);
  return ARC_OK;
}

arc_status arc_halfspace_friction_copy(const arc_halfspace *h, const arc_halfspace_friction *from,
                                       arc_halfspace_friction *copy, arc_error *error) {
  const size_t n = (size_t)h->cells;
  const arc_status status = arc_halfspace_friction_begin(h, copy, error);
  if (status != ARC_OK) return status;
  double *block = copy->pressure;
  *copy = *from;
  place_fields(copy, block, n);
  memcpy(block, from->pressure, FIELDS * n * sizeof *block);
  return ARC_OK;
}

void arc_halfspace_friction_end(arc_halfspace_friction *state) {
  free(state->pressure);
  *state = (arc_halfspace_friction){.pressure = NULL};
}

/* Computes the slip [2][window] of a state from its motion, shear and pressures. */
static void find_slip(const arc_halfspace *h, const double *pressure, const double *const q[2],
                      const double xi[2], double *const slip[2]) {
  arc_cerruti_shear(h, q, slip);
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < h->cells; k++) slip[i][k] = xi[i] - slip[i][k];
  arc_cerruti_add_slip(h, pressure, slip);
}

arc_status arc_halfspace_friction_widen(const arc_halfspace *from,
                                        const arc_halfspace_friction *state, arc_halfspace *to,
                                        arc_halfspace_friction *wide, arc_error *error) {
  const arc_halfspace_def *a = &from->def, *b = &to->def;
  const int rows = (b->nx - a->nx) / 2, columns = (b->nz - a->nz) / 2;
  const space_shear_kernels *kernels;
  arc_halfspace_friction made;
  arc_status status = arc_cerruti_kernels(to, &kernels, error);
  if (status == ARC_OK) status = arc_halfspace_friction_begin(to, &made, error);
  if (status != ARC_OK) return status;
  double *block = made.pressure;
  made = *state;
  place_fields(&made, block, (size_t)to->cells);
  for (int f = 0; f < FIELDS; f++)
    for (int i = 0; i < a->nx; i++)
      memcpy(block + (size_t)f * (size_t)to->cells + (size_t)(i + rows) * (size_t)b->nz + columns,
             state->pressure + (size_t)f * (size_t)from->cells + (size_t)i * (size_t)a->nz,
             (size_t)a->nz * sizeof *block);
  find_slip(to, made.pressure, (const double *const[2]){made.q[0], made.q[1]}, made.xi, made.slip);
  *wide = made;
  return ARC_OK;
}

/* --- one increment ---------------------------------------------------------------------------- */

/* Sites with less than this fraction of the largest pressure carry no shear. */
static const double carrying = 1e-6;

typedef struct increment {
  arc_halfspace *h;
  const double *const *depth;
  const arc_halfspace_increment *to;
  arc_halfspace_options options;
  const arc_halfspace_friction *from;
  double *pressure, *before, *gap, *bound, *known[2], *held[2]; /* [window] each; one allocation */
  double *share; /* [window] fraction of the motion for which a site was not in contact */
  arc_halfspace_position at; /* position and load at the end of the increment */
  double
      travel[2]; /* travel (see arc_halfspace_friction) assumed for the end of the increment [mm] */
  double motion[2];       /* assumed motion of the increment, to which `share` refers [mm] */
  double last[2], was[2]; /* previous assumed motion, and the motion computed with it [mm] */
  double approach, tolerance;
  stick_slip_work w;
} increment;

static arc_status take(increment *s, arc_error *error) {
  const arc_halfspace_friction *guess = s->to->guess ? s->to->guess : s->from;
  double **const field[] = {&s->pressure, &s->before,  &s->gap,     &s->bound, &s->known[0],
                            &s->known[1], &s->held[0], &s->held[1], &s->share};
  const size_t n = (size_t)s->h->cells, fields = sizeof field / sizeof *field;
  double *block = calloc(fields * n, sizeof *block);
  if (!block) return arc_fail(error, ARC_MEMORY, "out of memory for a contact with friction");
  for (size_t f = 0; f < fields; f++) *field[f] = block + f * n;
  const arc_status status = arc_stick_slip_begin(&s->w, (int)n, error);
  if (status != ARC_OK) return status;
  memcpy(s->pressure, s->to->pressure ? s->to->pressure : guess->pressure, n * sizeof(double));
  s->approach = s->from->approach;
  for (int i = 0; i < 2; i++) {
    memcpy(s->w.q[i], guess->q[i], n * sizeof(double));
    s->w.xi[i] = s->to->by_force[i] ? guess->xi[i] : s->to->xi[i];
    s->motion[i] = s->w.xi[i] - s->from->xi[i];
    s->travel[i] = s->from->travel[i];
  }
  s->at = s->to->position;
  for (size_t k = 0; k < n; k++) s->w.state[k] = guess->stick[k] > 0 ? SHEAR_STICK : SHEAR_SLIP;
  return ARC_OK;
}

static double largest(const double *value, int n) {
  double most = 0;
  for (int k = 0; k < n; k++) most = fmax(most, value[k]);
  return most;
}

/* Solves for the pressures at fixed shear. Sets *change to the largest change of a pressure,
 * divided by the largest pressure. */
static arc_status press(increment *s, double *change, arc_error *error) {
  const size_t n = (size_t)s->h->cells;
  double p = 0;
  memcpy(s->before, s->pressure, n * sizeof *s->before);
  memset(s->gap, 0, n * sizeof *s->gap);
  arc_cerruti_add_gap(s->h, (const double *const[2]){s->held[0], s->held[1]}, s->gap);
  s->options.gap = s->gap;
  s->options.warm = 1;
  const arc_status status = arc_halfspace_solve(s->h, s->depth, &s->at, &s->options, s->pressure,
                                                &s->approach, NULL, error);
  *change = 0;
  for (size_t k = 0; k < n && status == ARC_OK; k++) {
    p = fmax(p, s->pressure[k]);
    *change = fmax(*change, fabs(s->pressure[k] - s->before[k]));
  }
  if (p > 0) *change /= p;
  return status;
}

/* Returns the motion along axis i before site k entered the contact [mm]; 0 for a site without
 * pressure. */
static double motion_before(const increment *s, int i, int k) {
  return s->pressure[k] > 0 ? s->share[k] * s->motion[i] : 0;
}

/* Solves for the shear at fixed pressures. */
static arc_status shear(increment *s, arc_halfspace_effort *effort, arc_error *error) {
  const int n = s->h->cells;
  const double least = carrying * largest(s->pressure, n);
  stick_slip_count count = {0};
  for (int k = 0; k < n; k++)
    s->bound[k] = s->pressure[k] > least ? s->to->friction * s->pressure[k] : 0;
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < n; k++) s->known[i][k] = -s->from->slip[i][k] - motion_before(s, i, k);
  arc_cerruti_add_slip(s->h, s->pressure, s->known);
  const stick_slip_problem problem = {.h = s->h,
                                      .bound = s->bound,
                                      .known = {s->known[0], s->known[1]},
                                      .by_force = {s->to->by_force[0], s->to->by_force[1]},
                                      .force = {s->to->force[0], s->to->force[1]},
                                      .tolerance = s->tolerance,
                                      .callbacks = s->options.callbacks};
  const arc_status status = arc_stick_slip_solve(&problem, &s->w, &count, error);
  effort->sets += count.sets;
  effort->iterations += count.iterations;
  effort->applications += count.applications;
  effort->flipping += count.flipping;
  return status;
}

/* Updates the shear that the next pressure solution uses. After many sweeps the update is
 * relaxed, which avoids oscillation. */
static void hold(increment *s, double share) {
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < s->h->cells; k++) s->held[i][k] += share * (s->w.q[i][k] - s->held[i][k]);
}

/* --- sites that enter or leave the contact ---------------------------------------------------- */

static arc_status find_entering(increment *s, int *entering, arc_error *error) {
  *entering = 0;
  if (s->to->friction == 0) return ARC_OK;
  const arc_halfspace_friction *f = s->from;
  const space_traction before = {f->pressure, {f->q[0], f->q[1]}};
  const space_traction after = {s->pressure, {s->held[0], s->held[1]}};
  return arc_space_entering(s->h, s->depth, &s->at, &before, &after, s->gap, s->share, entering,
                            error);
}

/* Returns the next estimate, by the secant method, of the motion at which assumed and computed
 * motion are equal. The computed motion increases more slowly than the assumed motion. */
static double secant(double motion, double gives, double last, double gave) {
  static const double steepest = 0.9;
  const double slope = motion != last ? (gives - gave) / (motion - last) : 0;
  return motion + (gives - motion) / (1 - fmax(0, fmin(slope, steepest)));
}

/* Compares the assumed motion of an increment with the motion computed under a force. Returns 1 if
 * they agree. Otherwise stores a better estimate and returns 0. */
static int follow_motion(increment *s, int pass) {
  static const double settled = 1e-5;
  double off = 0, gave[2], size = 0;
  for (int i = 0; i < 2; i++) {
    gave[i] = s->w.xi[i] - s->from->xi[i];
    off = fmax(off, fabs(gave[i] - s->motion[i]));
    size = fmax(size, fabs(gave[i]));
  }
  if (off <= settled * (size + s->to->friction * fabs(s->approach))) return 1;
  for (int i = 0; i < 2; i++) {
    const double next = pass > 0 ? secant(s->motion[i], gave[i], s->last[i], s->was[i]) : gave[i];
    s->last[i] = s->motion[i];
    s->was[i] = gave[i];
    s->motion[i] = next;
  }
  return 0;
}

/* --- alternation ------------------------------------------------------------------------------ */

/* Solves for the shear if the pressures do not depend on it, for example between like bodies. */
static arc_status shear_alone(increment *s, arc_halfspace_effort *effort, arc_error *error) {
  enum { most_passes = 30 };
  int entering;
  arc_status status = find_entering(s, &entering, error);
  for (int k = 0; k < most_passes && status == ARC_OK; k++) {
    status = shear(s, effort, error);
    if (status != ARC_OK || !entering || follow_motion(s, k)) return status;
  }
  if (status == ARC_OK) effort->unfinished++;
  return status;
}

/* Solves once for the pressures, unless they are given, and then once for the shear. */
static arc_status one_sweep(increment *s, arc_halfspace_effort *effort, arc_error *error) {
  double change;
  arc_status status = ARC_OK;
  if (!s->to->pressure) {
    hold(s, 1);
    status = press(s, &change, error);
    effort->sweeps++;
  }
  return status == ARC_OK ? shear_alone(s, effort, error) : status;
}

/* Returns true if the pressures depend on the shear. */
static int depends_on_shear(const arc_halfspace *h, const arc_halfspace_increment *to) {
  return !to->pressure && h->shear->couple[0] != NULL;
}

/* Returns the relaxation factor of the change of shear in a sweep. */
static double relaxation(int sweep) {
  enum { plain_sweeps = 15 };
  static const double relaxed = 0.7;
  return sweep <= plain_sweeps ? 1 : relaxed;
}

static arc_status sweep(increment *s, arc_halfspace_effort *effort, arc_error *error) {
  enum { most_sweeps = 80 };
  static const double settled = 1e-6;
  int known = 0;
  if (!depends_on_shear(s->h, s->to)) return one_sweep(s, effort, error);
  for (int k = 0; k < most_sweeps; k++) {
    double change;
    int entering = 0;
    hold(s, relaxation(k));
    arc_status status = press(s, &change, error);
    effort->sweeps++;
    if (status != ARC_OK) return status;
    if (k > 0 && change <= settled * relaxation(k) && known) { /* pressures and shear agree */
      memcpy(s->pressure, s->before, (size_t)s->h->cells * sizeof *s->pressure);
      return ARC_OK;
    }
    status = find_entering(s, &entering, error);
    if (status == ARC_OK) status = shear(s, effort, error);
    if (status != ARC_OK) return status;
    known = !entering || follow_motion(s, k);
  }
  effort->unfinished++;
  return ARC_OK;
}

/* --- travel ----------------------------------------------------------------------------------- */

/* Returns the slip of site k along axis i in the increment [mm], including the motion before the
 * site was in contact. */
static double slip_of(const increment *s, int i, int k) {
  const double before = motion_before(s, i, k);
  return s->w.state[k] == SHEAR_STICK ? before : before + s->w.slip[i][k];
}

/* Computes the travel at the end of the increment from the slip of the site that slips least. */
static void find_travel(const increment *s, double travel[2]) {
  double least = INFINITY;
  for (int k = 0; k < s->h->cells; k++) {
    const double slip[2] = {slip_of(s, 0, k), slip_of(s, 1, k)}, size = hypot(slip[0], slip[1]);
    if (!(s->pressure[k] > 0 && size < least)) continue;
    least = size;
    for (int i = 0; i < 2; i++) travel[i] = s->from->travel[i] + slip[i];
  }
}

/* Solves an increment. The lower surface moves by the travel along x, which the solution
 * determines. Unless this surface is flat, the solution is repeated until the assumed and the
 * computed travel agree. Error: ARC_ZONE if the track is too short for the travel. */
static arc_status sweep_and_follow(increment *s, arc_halfspace_effort *effort, arc_error *error) {
  enum { most_passes = 20 };
  static const double settled = 1e-4; /* largest accepted error of the travel, in cells */
  stroke_place place;
  if (!s->to->follows) return sweep(s, effort, error);
  const int flat = arc_space_is_flat(s->h, s->depth, ARC_LOWER);
  for (int pass = 0; pass < most_passes; pass++) {
    double travel[2] = {s->travel[0], s->travel[1]};
    s->at.x = s->to->position.x + s->travel[0];
    effort->farthest = fmax(effort->farthest, fabs(s->at.x));
    const arc_status status = sweep(s, effort, error);
    if (status != ARC_OK) return status;
    find_travel(s, travel);
    const double off = fabs(travel[0] - s->travel[0]);
    memcpy(s->travel, travel, sizeof s->travel);
    if (!flat && off > settled * s->h->def.size_x) continue;
    const double end = s->to->position.x + s->travel[0];
    effort->farthest = fmax(effort->farthest, fabs(end));
    return arc_stroke_place(s->h, end, &place, error);
  }
  effort->unfinished++;
  return ARC_OK;
}

/* --- result ----------------------------------------------------------------------------------- */

double arc_space_work_at(double friction, double before, const arc_halfspace_friction *state,
                         int k) {
  if (state->stick[k] > 0) return 0;
  const double mean = friction * (before + state->pressure[k]) / 2;
  return mean * hypot(state->moved[0][k], state->moved[1][k]);
}

/* Returns the fraction of the slip w.slip during which site k was in contact. It is 1 for a site
 * that enters, because w.slip excludes the slip before the entry. */
static double in_contact(const increment *s, int k) {
  return s->pressure[k] > 0 ? 1 : 1 - s->share[k];
}

static void store(const increment *s, arc_halfspace_friction *state) {
  const int n = s->h->cells;
  const double area = s->h->def.size_x * s->h->def.size_z;
  double sum = 0;
  for (int i = 0; i < 2; i++) {
    state->xi[i] = s->w.xi[i];
    state->travel[i] = s->travel[i];
    state->force[i] = 0;
    for (int k = 0; k < n; k++) {
      state->q[i][k] = s->w.q[i][k];
      state->force[i] += area * s->w.q[i][k];
      state->moved[i][k] = s->w.slip[i][k] * in_contact(s, k);
      state->slip[i][k] += s->w.slip[i][k] + motion_before(s, i, k);
    }
  }
  for (int k = 0; k < n; k++) {
    const double before = state->pressure[k];
    state->stick[k] = s->w.state[k] == SHEAR_STICK;
    state->pressure[k] = s->pressure[k];
    sum += arc_space_work_at(s->to->friction, before, state, k);
  }
  state->work = area * sum;
  state->energy += state->work;
  state->approach = s->approach;
}

arc_status arc_halfspace_slide(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_increment *to,
                               const arc_halfspace_options *options, arc_halfspace_friction *state,
                               arc_halfspace_effort *effort, arc_error *error) {
  static const double finer = 0.1, usual = 1e-5;
  const space_shear_kernels *kernels;
  arc_halfspace_effort ignored = {0};
  increment s = {.h = h, .depth = depth, .to = to, .from = state};
  arc_status status = arc_cerruti_kernels(h, &kernels, error);
  if (status != ARC_OK) return status;
  if (options) s.options = *options;
  if (!(s.options.tolerance > 0) || depends_on_shear(h, to)) s.options.tolerance = usual;
  s.tolerance = finer * s.options.tolerance;
  status = take(&s, error);
  if (status == ARC_OK) status = sweep_and_follow(&s, effort ? effort : &ignored, error);
  if (status == ARC_OK) store(&s, state);
  arc_stick_slip_end(&s.w);
  free(s.pressure);
  return status;
}

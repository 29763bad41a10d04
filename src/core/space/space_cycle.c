/* Computes the wear of half-spaces in a part of a cycle (wear_window), from one contact solution
 * for each position. */
#include "core/space/cerruti.h"
#include "core/space/space_kind.h"

#include "core/base/carve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- positions -------------------------------------------------------------------------------- */

/* Returns the sliding distance between two points of the cycle [mm]. */
static double sliding_between(const wear_block *b, int from, int to) {
  double sum = 0;
  for (int i = from + 1; i <= to; i++) sum += fabs(b->x[i] - b->x[i - 1]);
  return sum;
}

/* Returns the weight of a point of the cycle, whose neighbours are `step` points away: the sliding
 * distance assigned to the point [mm]. */
static double weight_of(const arc_wear *w, const wear_window *v, int at, int step) {
  const double before = at > v->first ? sliding_between(v->block, at - step, at) : 0,
               after = at < v->last ? sliding_between(v->block, at, at + step) : 0;
  const double sliding = w->def.rule == ARC_TRAPEZOID ? (before + after) / 2 : before;
  return v->block->repeat * sliding;
}

/* Adds a point of the cycle to the path. Points at the same position under the same load share
 * one contact solution. */
static void add_position(space_path *path, double x, double load, double weight) {
  int at = 0;
  while (at < path->count && (path->position[at].x != x || path->position[at].load != load)) at++;
  if (at == path->count) {
    path->position[at] = (arc_halfspace_position){.x = x, .load = load, .weight = 0};
    path->count++;
  }
  path->position[at].weight += weight;
}

/* Adds the points of a cycle with friction. Between unlike bodies each point has its own position,
 * because the shear and thus the pressure depend on the history. The cycle ends at its first
 * position. All increments have equal weights, because their slip is part of the solution. */
static void add_rubbing(const wear_block *b, int unlike, space_path *path) {
  const double weight = b->sliding / (b->count - 1);
  for (int at = 0; at < b->count; at++) {
    int j = 0;
    const double x = b->problem_x[at], load = b->line[at];
    while (j < path->count && (path->position[j].x != x || path->position[j].load != load)) j++;
    if (unlike) j = at + 1 < b->count ? at : 0;
    if (j == path->count)
      path->position[path->count++] = (arc_halfspace_position){.x = x, .load = load};
    path->of[at] = j;
    path->position[j].weight += at > 0 && at + 1 < b->count ? weight : weight / 2;
  }
}

static arc_status rub(const wear_window *v, space_path *path, arc_error *error) {
  const space_shape *s = space_shape_of(v->shape);
  const int unlike = arc_cerruti_unlike(arc_halfspace_definition(s->grid->h)) != 0;
  const size_t cells = (size_t)space_sites(s, ARC_UPPER);
  path->of = malloc((size_t)v->block->count * sizeof *path->of);
  path->guess = calloc((size_t)v->block->count, sizeof *path->guess);
  path->guesses = path->guess ? v->block->count : 0;
  if (path->of) add_rubbing(v->block, unlike, path);
  const size_t all = (size_t)path->count * cells;
  path->slip = calloc(all + 1, sizeof *path->slip);
  if (unlike) path->gap = calloc(all + 1, sizeof *path->gap);
  if (path->of && path->guess && path->slip && (path->gap || !unlike)) return ARC_OK;
  arc_space_end_path(path);
  return arc_fail(error, ARC_MEMORY, "out of memory for a cycle with friction");
}

const arc_halfspace_friction *arc_space_guess_at(const space_path *path, int at) {
  return path->guess[at].pressure ? &path->guess[at] : NULL;
}

void arc_space_remember(space_path *path, int at, const arc_halfspace_friction *state, int cells) {
  arc_halfspace_friction *guess = &path->guess[at];
  const size_t n = (size_t)cells;
  if (!guess->pressure) {
    double *block = malloc(4 * n * sizeof *block);
    if (!block) return;
    *guess = (arc_halfspace_friction){
        .pressure = block, .q = {block + n, block + 2 * n}, .stick = block + 3 * n};
  }
  memcpy(guess->pressure, state->pressure, n * sizeof *guess->pressure);
  memcpy(guess->stick, state->stick, n * sizeof *guess->stick);
  for (int i = 0; i < 2; i++) {
    memcpy(guess->q[i], state->q[i], n * sizeof *guess->q[i]);
    guess->xi[i] = state->xi[i];
  }
}

void arc_space_forget(space_path *path) {
  for (int at = 0; at < path->guesses; at++) arc_halfspace_friction_end(&path->guess[at]);
}

void arc_space_end_path(space_path *path) {
  free(path->position);
  free(path->of);
  free(path->slip);
  free(path->gap);
  arc_space_forget(path);
  free(path->guess);
  *path = (space_path){.count = 0};
}

arc_status arc_space_path(const arc_wear *w, const wear_window *v, space_path *path,
                          arc_error *error) {
  const size_t points = (size_t)(v->last - v->first) + 1;
  *path = (space_path){.position = malloc(points * sizeof *path->position)};
  if (!path->position) return arc_fail(error, ARC_MEMORY, "out of memory for a cycle");
  if (arc_wear_has_friction(&w->def)) return rub(v, path, error);
  const int each = arc_space_increments_per_cell(w, v->block),
            step = v->first % each == 0 && v->last % each == 0 ? each : 1;
  for (int at = v->first; at <= v->last; at += step) {
    const double weight = weight_of(w, v, at, step), load = v->block->line[at];
    const double x = w->manner.rests ? 0 : v->block->x[at];
    if (weight > 0 && load > 0) add_position(path, x, load, weight);
  }
  return ARC_OK;
}

/* --- the wear --------------------------------------------------------------------------------- */

/* Data for the tangent (linearisation) of the wear rate: shape, positions and pressures. */
typedef struct space_tangent {
  space_grid *grid; /* NULL before the first use */
  space_path path;
  double *pressure;           /* [count][window] */
  double *factor[ARC_BODIES]; /* [sites] derivative of the wear work with respect to pressure, both
                                 bodies in one block; NULL: 1 */
} space_tangent;

static void empty(space_tangent *t) {
  arc_space_let_go(&t->grid);
  arc_space_end_path(&t->path);
  free(t->pressure);
  free(t->factor[ARC_UPPER]);
  *t = (space_tangent){.grid = NULL};
}

/* Returns the depths of a shape, plus the trial depths `more` unless `more` is NULL. The caller
 * frees *owned. */
static const double *depths_of(const space_shape *s, const double *more, double **owned) {
  const size_t n = (size_t)(space_sites(s, ARC_UPPER) + space_sites(s, ARC_LOWER));
  *owned = NULL;
  if (!more) return s->depth[ARC_UPPER];
  double *sum = *owned = malloc(n * sizeof *sum);
  for (size_t i = 0; i < n && sum; i++) sum[i] = s->depth[ARC_UPPER][i] + more[i];
  return sum;
}

static arc_status solve(const space_shape *s, const space_path *path,
                        const double *const depth[ARC_BODIES], wear_progress *progress,
                        double *pressure, wear_rate *rate, arc_error *error) {
  double *const to[] = {rate->node[ARC_UPPER], rate->node[ARC_LOWER]};
  const arc_halfspace_options options = {.callbacks = progress->callbacks, .gap = path->gap};
  arc_halfspace_report report = {0};
  const arc_status status = arc_halfspace_rate(s->grid->h, depth, path->position, path->count,
                                               &options, pressure, to, &report, error);
  progress->solutions += path->count;
  rate->peak = report.p_max;
  rate->pressed = 0;
  for (int j = 0; j < path->count; j++)
    rate->pressed += path->position[j].weight * path->position[j].load;
  return status;
}

arc_status arc_space_solve_path(arc_wear *w, const wear_window *v,
                                const double *const depth[ARC_BODIES], space_path *path,
                                wear_progress *progress, double *pressure, wear_rate *rate,
                                arc_error *error) {
  enum { most_passes = 40 };
  static const double settled = 1e-4;
  const space_shape *s = space_shape_of(v->shape);
  for (int pass = 0; pass < most_passes; pass++) {
    arc_status status = solve(s, path, depth, progress, pressure, rate, error);
    if (status == ARC_OK && path->slip)
      status = arc_space_slip(w, v, depth, path, pressure, progress, rate, error);
    if (status != ARC_OK || path->unsteady <= settled) return status;
  }
  return arc_fail(error, ARC_NOT_CONVERGED, "pressures and shear did not converge in %d iterations",
                  most_passes);
}

/* Replaces the sums of weighted pressures by the wear work, which includes the wear law and local
 * factors. */
static arc_status add_law(arc_wear *w, const wear_window *v, space_tangent *t, wear_rate *rate,
                          arc_error *error) {
  const space_shape *s = space_shape_of(v->shape);
  const carve_part parts[] = {{&t->factor[ARC_UPPER], (size_t)w->nc},
                              {&t->factor[ARC_LOWER], (size_t)w->np}};
  arc_status status = ARC_OK;
  if (arc_space_is_linear(w, v->state)) return ARC_OK;
  if (!ARC_CARVE(parts)) return arc_fail(error, ARC_MEMORY, "out of memory for a cycle");
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = arc_space_linearise(w, v->state, s, &t->path, t->pressure, v->mu, (arc_body)b,
                                 rate->node[b], t->factor[b], error);
  return status;
}

arc_status arc_space_rate(arc_wear *w, const wear_window *v, wear_progress *progress,
                          wear_rate *rate, arc_error *error) {
  const space_shape *s = space_shape_of(v->shape);
  const size_t cells = (size_t)space_sites(s, ARC_UPPER);
  space_tangent held = {.grid = NULL},
                *t = v->tangent ? (space_tangent *)(void *)v->tangent : &held;
  double *owned = NULL;
  empty(t);
  arc_wear_rate_clear(rate, w->nc + w->np);
  arc_status status = arc_space_path(w, v, &t->path, error);
  if (status != ARC_OK || t->path.count == 0) return status;
  t->pressure = malloc((size_t)t->path.count * cells * sizeof *t->pressure);
  const double *depth = depths_of(s, v->depth, &owned);
  if (t->pressure && depth) {
    const double *const worn[] = {depth, depth + cells};
    status = arc_space_solve_path(w, v, worn, &t->path, progress, t->pressure, rate, error);
  } else {
    status = arc_fail(error, ARC_MEMORY, "out of memory for a cycle");
  }
  if (status == ARC_OK) status = add_law(w, v, t, rate, error);
  free(owned);
  if (v->tangent && status == ARC_OK)
    t->grid = arc_space_hold(s->grid);
  else
    empty(t);
  return status;
}

/* --- the tangent ------------------------------------------------------------------------------ */

wear_tangent *arc_space_tangent(const arc_wear *w) {
  (void)w;
  return calloc(1, sizeof(space_tangent));
}

void arc_space_end_tangent(wear_tangent **tangent) {
  if (*tangent) empty((space_tangent *)(void *)*tangent);
  free(*tangent);
  *tangent = NULL;
}

size_t arc_space_tangent_bytes(const arc_wear *w) {
  const space_tangent *t = (const space_tangent *)(const void *)w->start.tangent;
  if (!t) return 0;
  return sizeof *t + (size_t)t->path.count * (size_t)w->nc * sizeof(double);
}

/* Returns an upper bound of the largest eigenvalue of the linearised wear equations where this
 * eigenvalue is not computed by iteration. The bound is the eigenvalue of a chessboard pattern of
 * wear on an infinite surface. The compliance to this pattern is 0.584 times the cell size divided
 * by E*. */
static double bound(const arc_wear *w, const double k[ARC_BODIES], const space_tangent *t) {
  const arc_halfspace_def *d = arc_halfspace_definition(t->grid->h);
  double sliding = 0, most[ARC_BODIES] = {0};
  for (int j = 0; j < t->path.count; j++) sliding += t->path.position[j].weight;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < sites_of(w, b); i++)
      most[b] = fmax(most[b], t->factor[b] ? t->factor[b][i] : 1);
  return (k[ARC_UPPER] * most[ARC_UPPER] + k[ARC_LOWER] * most[ARC_LOWER]) * sliding * 1 /
         (arc_space_surface_compliance(d) * 0.584 * fmin(d->size_x, d->size_z));
}

double arc_space_eigenvalue(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent,
                            const arc_callbacks *callbacks) {
  const space_tangent *t = (const space_tangent *)(const void *)tangent;
  const arc_halfspace_wear wear = {.c = {k[ARC_UPPER], k[ARC_LOWER]},
                                   .factor = {t->factor[ARC_UPPER], t->factor[ARC_LOWER]}};
  double value = 0;
  if (t->path.count == 0) return 0;
  const arc_status status = arc_halfspace_eigenvalue(
      t->grid->h, &wear, t->path.position, t->path.count, t->pressure, callbacks, &value, NULL);
  return status == ARC_OK ? value : bound(w, k, t);
}

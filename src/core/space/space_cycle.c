/* The wear of a window of a cycle on half-spaces: its positions, each a contact. */
#include "core/space/space_kind.h"

#include "core/base/carve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- positions ---------------------------------------------------------------------------------
 */

static double step_to(const wear_block *b, int at) {
  return fabs(b->x[at] - b->x[at - 1]);
}

/* Sliding distance of a point [mm]. */
static double weight_of(const arc_wear *w, const wear_window *v, int at) {
  const double before = at > v->first ? step_to(v->block, at) : 0,
               after = at < v->last ? step_to(v->block, at + 1) : 0;
  const double way = w->def.rule == ARC_TRAPEZOID ? (before + after) / 2 : before;
  return v->block->repeat * way;
}

/* Points at one position under one load are one contact. */
static void add_position(space_path *path, double x, double load, double weight) {
  int at = 0;
  while (at < path->count && (path->position[at].x != x || path->position[at].load != load)) at++;
  if (at == path->count) {
    path->position[at] = (arc_halfspace_position){.x = x, .load = load, .weight = 0};
    path->count++;
  }
  path->position[at].weight += weight;
}

arc_status arc_space_path(const arc_wear *w, const wear_window *v, space_path *path,
                          arc_error *error) {
  const size_t points = (size_t)(v->last - v->first) + 1;
  *path = (space_path){0, malloc(points * sizeof *path->position)};
  if (!path->position) return arc_fail(error, ARC_MEMORY, "out of memory for a cycle");
  for (int at = v->first; at <= v->last; at++) {
    const double weight = weight_of(w, v, at), load = v->block->line[at];
    const double x = w->manner.rests ? 0 : v->block->x[at];
    if (weight > 0 && load > 0) add_position(path, x, load, weight);
  }
  return ARC_OK;
}

/* --- the wear ----------------------------------------------------------------------------------
 */

/* A tangent, with its shape and pressures. */
typedef struct space_tangent {
  space_grid *grid; /* NULL: none yet */
  space_path path;
  double *pressure;           /* [count][window] */
  double *factor[ARC_BODIES]; /* [sites] growth of the wear with p; NULL: 1; one block */
} space_tangent;

static void empty(space_tangent *t) {
  arc_space_let_go(&t->grid);
  free(t->path.position);
  free(t->pressure);
  free(t->factor[ARC_UPPER]);
  *t = (space_tangent){.grid = NULL};
}

/* Depths of a shape plus those of a trial, if any. */
static const double *depths_of(const space_shape *s, const double *more, double **owned) {
  const size_t n = (size_t)(space_sites(s, ARC_UPPER) + space_sites(s, ARC_LOWER));
  *owned = NULL;
  if (!more) return s->depth[ARC_UPPER];
  double *sum = *owned = malloc(n * sizeof *sum);
  for (size_t i = 0; i < n && sum; i++) sum[i] = s->depth[ARC_UPPER][i] + more[i];
  return sum;
}

static arc_status solve(const space_shape *s, const space_path *path, const double *depth,
                        wear_watch *watch, double *pressure, wear_rate *rate, arc_error *error) {
  const double *const worn[] = {depth, depth + space_sites(s, ARC_UPPER)};
  double *const to[] = {rate->node[ARC_UPPER], rate->node[ARC_LOWER]};
  const arc_halfspace_options options = {.callbacks = watch->callbacks};
  arc_halfspace_report report = {0};
  const arc_status status = arc_halfspace_rate(s->grid->h, worn, path->position, path->count,
                                               &options, pressure, to, &report, error);
  watch->solutions += path->count;
  rate->peak = report.p_max;
  for (int j = 0; j < path->count; j++)
    rate->pressed += path->position[j].weight * path->position[j].load;
  return status;
}

/* Of laws and local factors, in place of the sums of pressure. */
static arc_status add_law(arc_wear *w, const wear_window *v, space_tangent *t, wear_rate *rate,
                          arc_error *error) {
  const space_shape *s = space_shape_of(v->shape);
  const carve_part parts[] = {{&t->factor[ARC_UPPER], (size_t)w->nc},
                              {&t->factor[ARC_LOWER], (size_t)w->np}};
  arc_status status = ARC_OK;
  if (arc_space_is_linear(w, v->state)) return ARC_OK;
  if (!ARC_CARVE(parts)) return arc_fail(error, ARC_MEMORY, "out of memory for a cycle");
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = arc_space_linearise(w, v->state, s, &t->path, t->pressure, (arc_body)b, rate->node[b],
                                 t->factor[b], error);
  return status;
}

arc_status arc_space_rate(arc_wear *w, const wear_window *v, wear_watch *watch, wear_rate *rate,
                          arc_error *error) {
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
  if (t->pressure && depth)
    status = solve(s, &t->path, depth, watch, t->pressure, rate, error);
  else
    status = arc_fail(error, ARC_MEMORY, "out of memory for a cycle");
  if (status == ARC_OK) status = add_law(w, v, t, rate, error);
  free(owned);
  if (v->tangent && status == ARC_OK)
    t->grid = arc_space_hold(s->grid);
  else
    empty(t);
  return status;
}

/* --- its growth --------------------------------------------------------------------------------
 */

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

/* Where no iteration can be made: that of a chessboard of wear on an infinite surface, whose
 * compliance is 0.584 cells over E*. */
static double bound(const arc_wear *w, const double k[ARC_BODIES], const space_tangent *t) {
  const arc_halfspace_def *d = arc_halfspace_definition(t->grid->h);
  double sliding = 0, most[ARC_BODIES] = {0};
  for (int j = 0; j < t->path.count; j++) sliding += t->path.position[j].weight;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < sites_of(w, b); i++)
      most[b] = fmax(most[b], t->factor[b] ? t->factor[b][i] : 1);
  return (k[ARC_UPPER] * most[ARC_UPPER] + k[ARC_LOWER] * most[ARC_LOWER]) * sliding *
         w->manner.modulus / (0.584 * fmin(d->size_x, d->size_z));
}

double arc_space_eigenvalue(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent) {
  const space_tangent *t = (const space_tangent *)(const void *)tangent;
  const arc_halfspace_wear wear = {.c = {k[ARC_UPPER], k[ARC_LOWER]},
                                   .factor = {t->factor[ARC_UPPER], t->factor[ARC_LOWER]}};
  double value = 0;
  if (t->path.count == 0) return 0;
  const arc_status status = arc_halfspace_eigenvalue(t->grid->h, &wear, t->path.position,
                                                     t->path.count, t->pressure, &value, NULL);
  return status == ARC_OK ? value : bound(w, k, t);
}

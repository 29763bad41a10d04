/* The wear of a cycle, or of a part of it, on a given shape: contact at every point of the path,
 * integrated by Eq. (4) or (5), as often as the block says (Eqs. 22, 26 and 27). */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void arc_wear_leave_block(arc_wear *w) {
  for (int i = 0; w->pose && i < w->poses; i++) arc_pose_free(&w->pose[i]);
  free(w->pose);
  w->pose = NULL;
  w->poses = 0;
}

arc_status arc_wear_enter_block(arc_wear *w, int block, arc_error *error) {
  if (block == w->current && w->pose) return ARC_OK;
  arc_wear_leave_block(w);
  const int n = w->block[block].poses;
  w->pose = calloc((size_t)n, sizeof *w->pose);
  arc_status status = w->pose ? ARC_OK : ARC_MEMORY;
  for (; w->poses < n && status == ARC_OK; w->poses++)
    status = arc_pose_create(&w->pose[w->poses], w->model);
  if (status != ARC_OK) {
    arc_wear_leave_block(w);
    return arc_fail(error, ARC_MEMORY, "out of memory for %d contact poses", n);
  }
  w->current = block;
  return ARC_OK;
}

/* Initial gaps deeper by the trial's depths along the normals, of which `down` is the vertical
 * share. */
static void deepen(pose *p, const wear_trial *trial) {
  double *plate = p->work, *below = plate + p->np;
  for (int l = 0; l < p->np; l++) plate[l] = trial->depth[ARC_PLATE][l] * trial->down[ARC_PLATE][l];
  arc_pose_to_cylinder(p, plate, below);
  for (int k = 0; k < p->count; k++) {
    const int i = p->lo + k;
    p->gap[k] += trial->depth[ARC_CYLINDER][i] * trial->down[ARC_CYLINDER][i] + below[i];
  }
}

/* Elastic part of the relative displacement at the nodes of both bodies: the other body's value
 * comes through B. */
static void relative_displacements(const pose *p, const arc_shape *shape, wear_point *point) {
  double *uc = point->u[ARC_CYLINDER], *up = point->u[ARC_PLATE];
  arc_pose_tangential(p, shape, uc, up);
  double *weighted = p->work, *plate_at_cylinder = weighted + p->nc;
  double *cylinder_at_plate = plate_at_cylinder + p->nc;
  arc_pose_to_cylinder(p, up, plate_at_cylinder);
  for (int i = 0; i < p->nc; i++) weighted[i] = uc[i] * p->wc[i];
  arc_pose_to_plate(p, weighted, cylinder_at_plate);
  for (int l = 0; l < p->np; l++) up[l] -= cylinder_at_plate[l] / p->wp[l];
  for (int i = 0; i < p->nc; i++) uc[i] = plate_at_cylinder[i] - uc[i];
}

static void clear_point(const arc_wear *w, wear_point *point) {
  memset(point->p[0], 0, (size_t)(3 * (w->nc + w->np)) * sizeof(double));
}

/* Solves point `at` of the current block into `point`. */
static arc_status solve_point(arc_wear *w, const arc_shape *shape, const wear_window *window,
                              int at, wear_point *point, int *solutions, arc_error *error) {
  const wear_block *block = &w->block[w->current];
  clear_point(w, point);
  if (block->line[at] == 0) return ARC_OK; /* lifted off */
  const int index = block->place[at];
  const double x = w->procedure == ARC_NSP ? 0 : block->x[at];
  pose *p = &w->pose[index];
  arc_status status = arc_pose_update(p, shape, x, error);
  if (status != ARC_OK) return status;
  if (window->trial) deepen(p, window->trial);
  if ((status = arc_pose_solve(p, block->line[at], error)) != ARC_OK) return status;
  *solutions += 1;
  arc_pose_pressures(p, point->p[ARC_CYLINDER], point->p[ARC_PLATE]);
  if (w->def.slip == ARC_SLIP_TOTAL) relative_displacements(p, shape, point);
  return arc_wear_local(w, window->state, point, error);
}

/* NSP under a steady load: the next point is the last one again. */
static int same_as_before(const arc_wear *w, const wear_window *window, int at) {
  const wear_block *block = &w->block[w->current];
  return w->procedure == ARC_NSP && at > window->first && block->line[at] == block->line[at - 1];
}

static void copy_point(const arc_wear *w, const wear_point *from, wear_point *to) {
  memcpy(to->p[0], from->p[0], (size_t)(3 * (w->nc + w->np)) * sizeof(double));
}

static void add_increment(arc_wear *w, const wear_point *before, const wear_point *now,
                          double rigid) {
  const double repeat = w->block[w->current].repeat;
  const int mean = w->def.rule == ARC_TRAPEZOID, total = w->def.slip == ARC_SLIP_TOTAL;
  for (int b = 0; b < ARC_BODIES; b++) {
    double *rate = w->rate.node[b];
    for (int i = 0; i < w->shape->side[b].n; i++) {
      const double q = mean ? (now->q[b][i] + before->q[b][i]) / 2 : now->q[b][i];
      const double slip = total ? fabs(rigid + now->u[b][i] - before->u[b][i]) : fabs(rigid);
      rate[i] += repeat * q * slip;
    }
  }
}

/* Share of point `at` in the integral over the window [mm of sliding]. */
static double weight(const arc_wear *w, const wear_window *window, int at) {
  const wear_block *b = &w->block[w->current];
  const double before = at > window->first ? fabs(b->x[at] - b->x[at - 1]) : 0;
  const double after = at < window->last ? fabs(b->x[at + 1] - b->x[at]) : 0;
  return b->repeat * (w->def.rule == ARC_TRAPEZOID ? (before + after) / 2 : before);
}

/* Eq. (27): under a stroke over the whole plate each of its nodes passes under the whole profile;
 * with Archard's law the integral of p is the load. */
static void add_even(arc_wear *w, const wear_point *point) {
  const shape_side *plate = &w->shape->side[ARC_PLATE];
  for (int l = 0; l < plate->n; l++)
    w->rate.even += point->q[ARC_PLATE][l] * arc_shape_width(plate, l);
}

static arc_status add_to_jacobian(const arc_wear *w, const wear_window *window, int at,
                                  const wear_point *point) {
  const wear_block *block = &w->block[w->current];
  const double share = weight(w, window, at);
  if (!window->jacobian || share == 0 || block->line[at] == 0) return ARC_OK;
  return arc_wear_add_jacobian(w, &w->pose[block->place[at]], point, share,
                               window->trial ? window->trial->down : NULL, window->jacobian);
}

arc_status arc_wear_probe(arc_wear *w, const wear_window *window, int *solutions,
                          arc_error *error) {
  return solve_point(w, w->shape, window, window->first, &w->point[0], solutions, error);
}

arc_status arc_wear_evaluate(arc_wear *w, const arc_shape *shape, const wear_window *window,
                             arc_stop_fn stop, void *context, int *solutions, arc_error *error) {
  const wear_block *block = &w->block[w->current];
  const size_t n = (size_t)(w->nc + w->np);
  memset(w->rate.node[0], 0, n * sizeof(double));
  w->rate.even = 0;
  if (window->jacobian) memset(window->jacobian, 0, n * n * sizeof(double));
  for (int at = window->first; at <= window->last; at++) {
    wear_point *now = &w->point[at % 2], *before = &w->point[(at + 1) % 2];
    arc_status status = ARC_OK;
    if (stop && stop(context)) return arc_fail(error, ARC_STOPPED, "stopped on request");
    if (same_as_before(w, window, at))
      copy_point(w, before, now);
    else if (!(window->chained && at == window->first))
      status = solve_point(w, shape, window, at, now, solutions, error);
    if (status == ARC_OK && add_to_jacobian(w, window, at, now) != ARC_OK)
      status = arc_fail(error, ARC_MEMORY, "out of memory for the wear's Jacobian");
    if (status != ARC_OK) return status;
    if (at > window->first)
      add_increment(w, before, now, block->x[at] - block->x[at - 1]);
    else if (w->over_plate && w->procedure == ARC_NSP)
      add_even(w, now);
  }
  return ARC_OK;
}

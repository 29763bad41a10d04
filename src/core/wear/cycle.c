/* The wear of one cycle: contact at every increment of a half cycle (SP, Eq. 22), or once (NSP,
 * Eqs. 26 and 27). */
#include "core/wear/run.h"

#include <math.h>
#include <string.h>

double wear_position(const arc_wear *w, int i) {
  if (w->poses == 1) return 0;
  /* symmetric to the bit: i and its mirror give the same number */
  const int last = w->poses - 1;
  return w->def.stroke * (2 * i - last) / (2.0 * last);
}

arc_status wear_prepare_pose(arc_wear *w, int index, const arc_shape *shape, arc_error *error) {
  pose *p = index < w->poses ? &w->pose[index] : &w->reference;
  long *known = &w->condensed[index];
  const double x = index < w->poses ? wear_position(w, index) : 0;
  if (*known != shape->condensed) {
    const arc_status status = pose_place(p, shape, x, error);
    if (status != ARC_OK) return status;
    pose_stiffen(p, shape);
    *known = shape->condensed;
  }
  pose_measure(p, shape);
  return ARC_OK;
}

static double line_load(const arc_wear *w) {
  return w->def.load / arc_model_definition(w->model)->thickness;
}

/* Pressures and elastic tangential displacements of one increment. */
typedef struct increment {
  double *p[ARC_BODIES],
      *u[ARC_BODIES]; /* u: elastic displacement of plate against cylinder at the body's nodes */
} increment;

static increment increment_in(double *work, int nc, int np) {
  return (increment){{work, work + nc}, {work + nc + np, work + 2 * nc + np}};
}

/* Elastic part of the relative displacement at the nodes of both bodies: the other body's value
 * comes through B. */
static void relative_displacements(const pose *p, const arc_shape *shape, increment *now) {
  double *uc = now->u[ARC_CYLINDER], *up = now->u[ARC_PLATE];
  double *across = p->work + 2 * (p->nc + p->np);
  pose_tangential(p, shape, uc, up);
  double *plate_at_cylinder = across, *cylinder_at_plate = across + p->nc;
  pose_to_cylinder(p, up, plate_at_cylinder);
  for (int i = 0; i < p->nc; i++) p->work[i] = uc[i] * p->wc[i];
  pose_to_plate(p, p->work, cylinder_at_plate);
  for (int l = 0; l < p->np; l++) up[l] -= cylinder_at_plate[l] / p->wp[l];
  for (int i = 0; i < p->nc; i++) uc[i] = plate_at_cylinder[i] - uc[i];
}

static void add_increment(const arc_wear *w, const increment *before, const increment *now,
                          double rigid) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = w->shape->side[b].n;
    double *rate = w->rate.node[b];
    for (int i = 0; i < n; i++) {
      const double p =
          w->def.rule == ARC_TRAPEZOID ? (now->p[b][i] + before->p[b][i]) / 2 : now->p[b][i];
      const double slip =
          w->def.slip == ARC_SLIP_TOTAL ? fabs(rigid + now->u[b][i] - before->u[b][i]) : rigid;
      rate[i] += w->strokes * p * slip;
    }
  }
}

static arc_status solve_increment(arc_wear *w, int i, increment *now, arc_error *error) {
  arc_status status = wear_prepare_pose(w, i, w->shape, error);
  if (status == ARC_OK) status = pose_solve(&w->pose[i], line_load(w), error);
  if (status != ARC_OK) return status;
  pose_pressures(&w->pose[i], now->p[ARC_CYLINDER], now->p[ARC_PLATE]);
  if (w->def.slip == ARC_SLIP_TOTAL) relative_displacements(&w->pose[i], w->shape, now);
  return ARC_OK;
}

/* Half a cycle, from -s/2 to s/2. */
static arc_status sliding_cycle(arc_wear *w, arc_stop_fn stop, void *context, arc_error *error) {
  const int nc = w->reference.nc, np = w->reference.np;
  increment even = increment_in(w->work, nc, np);
  increment odd = increment_in(w->work + 2 * (nc + np), nc, np);
  for (int i = 0; i < w->poses; i++) {
    if (stop && stop(context)) return arc_fail(error, ARC_STOPPED, "stopped on request");
    increment *now = i % 2 ? &odd : &even, *before = i % 2 ? &even : &odd;
    const arc_status status = solve_increment(w, i, now, error);
    if (status != ARC_OK) return status;
    if (i > 0) add_increment(w, before, now, wear_position(w, i) - wear_position(w, i - 1));
  }
  return ARC_OK;
}

/* One solution; the plate slides past at constant pressure. Its elastic displacements do not
 * change: total slip is the rigid one (Eq. 25). */
static arc_status still_cycle(arc_wear *w, arc_stop_fn stop, void *context, arc_error *error) {
  if (stop && stop(context)) return arc_fail(error, ARC_STOPPED, "stopped on request");
  increment now = increment_in(w->work, w->reference.nc, w->reference.np);
  const arc_status status = solve_increment(w, 0, &now, error);
  if (status != ARC_OK) return status;
  for (int i = 0; i < w->reference.nc; i++)
    w->rate.node[ARC_CYLINDER][i] = w->strokes * now.p[ARC_CYLINDER][i] * w->def.stroke;
  /* Eq. (27): each plate node passes under the whole profile; the integral of p is the load, to
   * rounding */
  for (int l = 0; l < w->reference.np && w->over_plate; l++)
    w->rate.even += now.p[ARC_PLATE][l] * w->pose[0].wp[l];
  return ARC_OK;
}

arc_status wear_cycle(arc_wear *w, arc_stop_fn stop, void *context, arc_error *error) {
  for (int b = 0; b < ARC_BODIES; b++)
    memset(w->rate.node[b], 0, (size_t)w->shape->side[b].n * sizeof(double));
  w->rate.even = 0;
  if (w->procedure == ARC_SP) return sliding_cycle(w, stop, context, error);
  if (w->def.alpha == 0 &&
      w->over_plate) { /* nothing that touches changes: Hertz, no solution needed */
    w->rate.even = line_load(w);
    return ARC_OK;
  }
  return still_cycle(w, stop, context, error);
}

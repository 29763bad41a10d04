/* Implicit updates: the wear uses the pressures of the geometry it ends in (order 1, backward
 * Euler), or of its start, of a stage on the way and of its end (order 2, TR-BDF2, L-stable). The
 * nodes that enter the contact within a step set its length: they take all their wear from the last
 * stages. TR-BDF2 exaggerates their pressures least among the methods of its kind. Leans on
 * newton.c. */
#include "core/wear/newton.h"
#include "core/base/dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Steps share the tolerance: at order 2 the errors of the first ones fade as the pressure flattens.
 * Found on the twenty cases of the paper, at 20, 10 and 5 um. */
static const double share_per_step = 0.5;
/* The pressure may be off by so many tolerances, of the largest one. */
static const double pressure_share = 30;
static const double gamma2 = 0.29289321881345247560; /* 1 - 1 / sqrt(2) */

/* A stage's coefficient of friction; it is asked for before any stage, as what is asked leaves no
 * depths. */
static arc_status friction_at(newton *s, double share, double *mu) {
  *mu = s->window.mu;
  return arc_wear_friction_on_the_way(s->w, &s->dose, share, mu, &s->error);
}

/* Backward Euler; its error, to s->residual, by comparison with the trapezoid. */
static arc_status first_order(newton *s, double cycles, wear_depths *depth) {
  double *defect = s->residual;
  memset(s->known, 0, (size_t)s->n * sizeof(double));
  memcpy(s->rate[2], s->rate[0], (size_t)s->n * sizeof(double));
  arc_status status = friction_at(s, 1, &s->window.mu);
  if (status == ARC_OK) status = arc_newton_solve(s, cycles, s->rate[2]);
  for (int i = 0; i < s->n && status == ARC_OK; i++)
    defect[i] = cycles * (s->rate[2][i] - s->rate[0][i]) / 2;
  depth->energy = cycles * s->energy;
  return status;
}

/* The trapezoid to 2 gamma, then BDF2 to the end; the error by comparison with the quadrature
 * through the start and both stages. */
static arc_status second_order(newton *s, double cycles, wear_depths *depth) {
  const double g = gamma2, h = g * cycles, c = 2 * g, part = (1 - g) / 2;
  const double b1 = 1 / (6 * c * (1 - c)), b2 = (1 / 3.0 - c / 2) / (1 - c), b0 = 1 - b1 - b2;
  const size_t bytes = (size_t)s->n * sizeof(double);
  double *defect = s->residual, mu[2];
  arc_status status = friction_at(s, c, &mu[0]);
  if (status == ARC_OK) status = friction_at(s, 1, &mu[1]);
  if (status != ARC_OK) return status;
  depth->energy = cycles * part * s->energy;
  for (int i = 0; i < s->n; i++) s->known[i] = h * s->rate[0][i];
  memcpy(s->rate[1], s->rate[0], bytes);
  s->window.mu = mu[0];
  status = arc_newton_solve(s, h, s->rate[1]);
  if (status != ARC_OK) return status;
  depth->energy += cycles * part * s->energy;
  for (int i = 0; i < s->n; i++) s->known[i] = cycles * part * (s->rate[0][i] + s->rate[1][i]);
  memcpy(s->rate[2], s->rate[1], bytes);
  s->window.mu = mu[1];
  status = arc_newton_solve(s, h, s->rate[2]);
  for (int i = 0; i < s->n && status == ARC_OK; i++)
    defect[i] = cycles * ((b0 - part) * s->rate[0][i] + (b1 - part) * s->rate[1][i] +
                          (b2 - g) * s->rate[2][i]);
  depth->energy += h * s->energy;
  return status;
}

/* --- the error --- */

/* Largest error of one body's depths, where they count, over the deepest. */
static double depth_error(const newton *s, arc_body b, const double *off) {
  static const double counts = 0.05; /* of the deepest node */
  const shape_side *side = &s->window.shape->side[b];
  double deepest = 0, largest = 0;
  for (int i = 0; i < side->n; i++) deepest = fmax(deepest, side->h[i] + s->trial.depth[b][i]);
  for (int i = 0; i < side->n; i++)
    if (side->h[i] + s->trial.depth[b][i] > counts * deepest) largest = fmax(largest, fabs(off[i]));
  return deepest > 0 ? largest / deepest : 0;
}

/* Largest change of a pose's pressures with depths that are off, over the largest pressure. */
static double pressure_error(newton *s, pose *p, const double *off) {
  double *gap = s->packed, sum = 0, total = 0, largest = 0, peak = 0;
  arc_pose_to_cylinder(p, off + s->w->nc, p->work);
  for (int k = 0; k < p->active; k++) {
    const int i = p->lo + p->set[k];
    gap[k] = off[i] + p->work[i];
  }
  arc_dense_cholesky_solve(p->active, 1, p->factor, p->active, gap, p->active);
  for (int k = 0; k < p->active; k++) {
    const double down = p->down[p->set[k]];
    sum += down * gap[k], total += down * p->ones[k];
  }
  for (int k = 0; k < p->active; k++) {
    const double width = p->wc[p->lo + p->set[k]];
    largest = fmax(largest, fabs(gap[k] - sum / total * p->ones[k]) / width);
    peak = fmax(peak, p->f[p->set[k]] / width);
  }
  return peak > 0 ? largest / peak : 0;
}

/* Of the poses at the ends and in the middle of the path: those at hand, of the last solution. */
static double largest_pressure_error(newton *s, const double *off) {
  const wear_block *block = s->w->path.block;
  const int first = s->window.first, last = s->window.last;
  const int points[] = {first, first + (last - first) / 2, last};
  double largest = 0;
  for (int i = 0; i < 3; i++) {
    pose *p = &s->w->path.pose[block->place[points[i]]];
    if (block->line[points[i]] > 0 && p->active > 0 && !arc_lcp_factorise(p))
      largest = fmax(largest, pressure_error(s, p, off));
  }
  return largest;
}

/* The estimated error over what is allowed. Stiff ripples, which the step damps, are filtered out
 * first. */
static double share_of_tolerance(newton *s, double h, double *defect) {
  const double tolerance = s->w->def.tolerance;
  if (tolerance == 0 || arc_newton_direction(s, h, defect) != ARC_OK) return 0;
  for (int i = 0; i < s->n; i++) defect[i] *= arc_newton_share(s, i);
  const double depth =
      fmax(depth_error(s, ARC_CYLINDER, defect), depth_error(s, ARC_PLATE, defect + s->w->nc));
  const double pressure = largest_pressure_error(s, defect);
  return fmax(depth / (share_per_step * tolerance), pressure / (pressure_share * tolerance));
}

static arc_status run(newton *s, wear_depths *depth) {
  const double cycles = s->dose.cycles;
  arc_status status = arc_newton_evaluate(s, s->rate[0], 1); /* z = 0: at the start */
  if (status != ARC_OK) return status;
  const int first = s->w->def.order == 1;
  status = first ? first_order(s, cycles, depth) : second_order(s, cycles, depth);
  if (status != ARC_OK) return status;
  depth->error = share_of_tolerance(s, first ? cycles : gamma2 * cycles, s->residual);
  memcpy(depth->node[0], s->z, (size_t)s->n * sizeof(double));
  return ARC_OK;
}

/* Normal force over the sliding [N/mm mm]: what the depths say where they tell it, as the rest of
 * the step is not solved for once more; else that of the last evaluation. */
static double pressed_of(const newton *s, const wear_depths *depth) {
  const arc_wear_def *d = &s->w->def;
  const int b = s->dose.k[ARC_CYLINDER] > 0 ? ARC_CYLINDER : ARC_PLATE;
  if (!(arc_law_properties[d->law] & ARC_LAW_LINEAR) || d->local_factor || !(s->dose.k[b] > 0))
    return s->dose.cycles * s->pressed;
  double sum = 0;
  for (int i = 0; i < s->window.shape->side[b].n; i++)
    sum += depth->node[b][i] * arc_shape_span(s->window.shape, (arc_body)b, i);
  return sum / s->dose.k[b];
}

static arc_status tell(const newton *s, arc_status status, arc_error *error) {
  if (status != ARC_NOT_CONVERGED) {
    if (status != ARC_OK && error) *error = s->error;
    return status;
  }
  const char *why = s->error.message;
  return arc_fail(error, status, "the implicit step did not converge for %g cycles%s%s",
                  s->dose.cycles, why[0] ? "; on the way " : "", why);
}

arc_status arc_wear_implicit(arc_wear *w, const wear_window *window, const wear_dose *dose,
                             wear_watch *watch, wear_depths *depth, arc_error *error) {
  newton s = {.w = w, .window = *window, .watch = watch, .dose = *dose};
  s.n = w->nc + w->np;
  /* under even wear the plate's nodes do not move against each other */
  if (w->procedure == ARC_NSP) s.dose.k[ARC_PLATE] = 0;
  depth->error = 0;
  arc_status status = arc_newton_create(&s);
  if (status != ARC_OK)
    arc_fail(&s.error, status, "out of memory for an implicit step");
  else
    status = run(&s, depth);
  depth->even = wears_evenly(w) ? dose->cycles * dose->k[ARC_PLATE] * s.even : 0;
  depth->peak = s.peak;
  depth->pressed = status == ARC_OK ? pressed_of(&s, depth) : 0;
  arc_newton_free(&s);
  return tell(&s, status, error);
}

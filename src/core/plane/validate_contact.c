/* Checks the solution of a contact: the balance of forces, and the complementarity conditions
 * with gaps that are computed again from the contact matrix. */
#include "core/base/dense.h"
#include "core/plane/solution.h"

#include <assert.h>
#include <math.h>

/* Tolerance of rounding errors, relative to the largest number in the compared expression. */
static const double rounding = 1e-9;

/* Returns the component of the normal force on a node along the load [N/mm]. */
static double across(const arc_contact *c, arc_body body, int i) {
  const chart *on = &c->handle.shape->side[body].body->chart;
  if (on->polar) {
    double along[2], up[2];
    const double *f = c->force[body];
    arc_chart_axes(on, c->x[body][i] - on->radius * c->problem.angle, along, up);
    return (body == ARC_CYLINDER ? 1 : -1) * (up[1] * f[c->count[body] + i] + along[1] * f[i]);
  }
  const double y = c->force[body][c->count[body] + i];
  if (!c->has_friction) return c->f[body][i];
  return body == ARC_CYLINDER ? y : -y;
}

static arc_status check_forces(const arc_contact *c, arc_body body, arc_error *error) {
  const double load = contact_line(c);
  double sum = 0;
  for (int i = 0; i < c->count[body]; i++) {
    if (!(c->p[body][i] >= 0) || !isfinite(c->f[body][i]))
      return arc_fail(error, ARC_NUMERIC,
                      "contact: expected a pressure >= 0, got %g MPa at x = %g mm of the %s",
                      c->p[body][i], c->x[body][i], arc_body_name(body));
    sum += across(c, body, i);
  }
  if (fabs(sum - load) <= rounding * load) return ARC_OK;
  return arc_fail(error, ARC_NUMERIC,
                  "contact: the forces on the %s are %.17g N/mm, the load is %.17g N/mm",
                  arc_body_name(body), sum, load);
}

/* Checks that the sums of the normal forces on both bodies are equal. The coupling conserves the
 * magnitudes of normal forces exactly, but their directions only within rounding errors. */
static arc_status check_pressing(const arc_contact *c, arc_error *error) {
  double sum[ARC_BODIES] = {0};
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < c->count[b]; i++) sum[b] += c->f[b][i];
  if (fabs(sum[0] - sum[1]) <= rounding * sum[0]) return ARC_OK;
  return arc_fail(error, ARC_NUMERIC,
                  "contact: the loads on the two bodies differ, %.17g and "
                  "%.17g N/mm",
                  sum[0], sum[1]);
}

/* Returns the gap of a candidate in the deformed state, gap - approach + A f [mm]. */
static double gap_left(const contact_problem *p, int candidate) {
  double g = p->gap[candidate] - p->approach * p->down[candidate];
  for (int k = 0; k < p->count; k++) g += p->a[dense_at(candidate, k, p->count)] * p->f[k];
  return g;
}

static arc_status check_complementarity(const contact_problem *p, arc_error *error) {
  double most = fabs(p->approach);
  for (int k = 0; k < p->count; k++) most = fmax(most, fabs(p->gap[k]));
  for (int k = 0; k < p->count; k++) {
    const double g = gap_left(p, k);
    if (!(g >= -rounding * most) || !(p->f[k] >= 0) || (p->f[k] > 0 && g > rounding * most))
      return arc_fail(error, ARC_NUMERIC,
                      "contact: expected one of gap and force to be 0 and the other >= 0, got gap "
                      "%g mm and force %g N/mm at candidate %d of %d",
                      g, p->f[k], k, p->count);
  }
  return ARC_OK;
}

/* Checks three conditions of friction: |t| <= mu f; nodes with |t| < mu f do not slip; all other
 * nodes slip in the direction of the shear. */
static arc_status check_friction(const arc_contact *c, arc_error *error) {
  const contact_problem *p = &c->problem;
  const double mu = c->mu;
  for (int s = 0; s < p->active; s++) {
    const int k = p->set[s];
    const double t = c->workspace.t[k], bound = mu * p->f[k], slip = c->workspace.slip[k];
    if (!(fabs(t) <= bound * (1 + rounding)))
      return arc_fail(error, ARC_NUMERIC,
                      "contact: shear %g N/mm above the friction limit %g N/mm, at candidate %d", t,
                      bound, k);
    if (!isfinite(slip) || (slip != 0 && (fabs(t) < bound || t * slip < -rounding * bound)))
      return arc_fail(error, ARC_NUMERIC,
                      "contact: expected slip along the shear and only at the friction limit, got "
                      "slip %g mm under shear %g N/mm with the limit %g N/mm, at candidate %d",
                      slip, t, bound, k);
  }
  return ARC_OK;
}

arc_status arc_contact_validate(const arc_contact *c, arc_error *error) {
  assert(c->problem.count > 0 && c->problem.lo >= 0 &&
         c->problem.lo + c->problem.count <= c->problem.nc);
  arc_status status = check_forces(c, ARC_CYLINDER, error);
  const int polar = c->handle.shape->side[ARC_PLATE].body->chart.polar;
  if (status == ARC_OK)
    status = polar ? check_pressing(c, error) : check_forces(c, ARC_PLATE, error);
  if (status == ARC_OK) status = check_complementarity(&c->problem, error);
  return status == ARC_OK && c->has_friction ? check_friction(c, error) : status;
}

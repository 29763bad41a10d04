/* Stages of a contact at rest under one load. The wear in a stage acts like an additional
 * compliance of both bodies, so that wear and contact form one complementarity problem. For a
 * linear wear law its solution is exact for any length of the step. Other laws, layers and a
 * variable compliance require iterations. */
#include "core/base/dense.h"
#include "core/plane/newton.h"

#include <math.h>
#include <string.h>

enum { most_solutions = 25 };

int arc_stage_rests(const wear_stage *stage) {
  const wear_window *window = &stage->window;
  const wear_block *b = window->block;
  const arc_wear_def *d = &stage->run->def;
  if (b->problems != 1 || arc_wear_has_friction(d) || d->slip == ARC_SLIP_TOTAL ||
      stage->run->manner.closed)
    return 0;
  for (int i = window->first; i <= window->last; i++)
    if (b->line[i] != b->line[window->first] || b->angle[i] != b->angle[window->first] ||
        b->line[i] == 0)
      return 0;
  return 1;
}

/* Computes at each node the wear depth in h cycles per force [mm per N/mm], and the increase of
 * the gap per depth. */
static void find_wear_of_forces(newton *s, double h, const contact_problem *p) {
  const arc_wear *w = s->at->run;
  const wear_window *window = &s->at->window;
  const wear_point *point = &path_of(w)->point[window->last % 2];
  const double sliding = arc_wear_window_sliding(w, window), *down = plane_of(w)->down;
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *width = b == ARC_CYLINDER ? p->wc : p->wp;
    double *to = sites_from(w, s->per_force, b);
    for (int i = 0; i < sites_of(w, b); i++)
      to[i] = h * s->at->k[b] * sliding * arc_wear_law_slope(w, point->p[b][i], point->q[b][i]) *
              arc_wear_slope_share(w, window, (arc_body)b, i) / width[i];
  }
  for (int i = 0; i < s->n; i++) s->opening[i] = down[i] * arc_newton_share(s, i);
}

/* Returns the element (r, c) of B D B' for the candidates r and c. D is diagonal; `d` contains its
 * diagonal, one value per plate node. */
static double through_plate(const contact_problem *p, int r, int c, const double *d) {
  const int first = p->first[r] > p->first[c] ? p->first[r] : p->first[c];
  const int last = (p->first[r] < p->first[c] ? p->first[r] : p->first[c]) + p->width;
  double sum = 0;
  for (int l = first; l < last && l < p->np; l++)
    sum += p->b[r * p->width + l - p->first[r]] * d[l] * p->b[c * p->width + l - p->first[c]];
  return sum;
}

/* Stores the contact problem in s->with_wear, with the compliance due to wear added. */
static void soften(newton *s, const contact_problem *p) {
  contact_problem *with = &s->with_wear;
  const size_t count = (size_t)p->count;
  double *d = plane_of(s->at->run)->plate;
  for (int l = 0; l < p->np; l++) d[l] = s->per_force[p->nc + l] * s->opening[p->nc + l];
  memcpy(with->a, p->a, count * count * sizeof *p->a);
  for (int c = 0; c < p->count; c++) {
    with->a[dense_at(c, c, p->count)] += s->per_force[p->lo + c] * s->opening[p->lo + c];
    for (int r = 0; r < p->count; r++)
      with->a[dense_at(r, c, p->count)] += through_plate(p, r, c, d);
  }
  memcpy(with->down, p->down, count * sizeof *p->down);
  with->x = p->x;
  with->lo = p->lo;
  with->count = p->count;
  with->factored = 0;
}

/* Computes the wear depths of all nodes of both bodies due to the forces on the cylinder's nodes
 * [N/mm]. */
static void wear_of(const newton *s, const contact_problem *p, const double *force, double *depth) {
  arc_contact_problem_to_plate(p, force, depth + p->nc);
  for (int i = 0; i < p->nc; i++) depth[i] = force[i];
  for (int i = 0; i < s->n; i++) depth[i] *= s->per_force[i];
}

/* Adds to the gaps of the candidates [mm] the increase that is due to the wear depths of all nodes.
 */
static void add_gaps(const newton *s, const contact_problem *p, const double *depth, double *gap) {
  double *plate = plane_of(s->at->run)->plate, *below = plane_of(s->at->run)->below;
  for (int l = 0; l < p->np; l++) plate[l] = depth[p->nc + l] * s->opening[p->nc + l];
  arc_contact_problem_to_cylinder(p, plate, below);
  for (int k = 0; k < p->count; k++) {
    const int i = p->lo + k;
    gap[k] += depth[i] * s->opening[i] + below[i];
  }
}

/* Solves contact and wear together, linearised about the solved contact problem `p`. Sets `step`
 * to the change of the depths z. The next solution of the contact problem starts from the
 * resulting active set. */
static arc_status solve_together(newton *s, double line, contact_problem *p) {
  contact_problem *with = &s->with_wear;
  const size_t set = (size_t)p->active;
  arc_contact_problem_forces(p, s->force);
  wear_of(s, p, s->force, s->moved);
  for (int i = 0; i < s->n; i++) s->moved[i] = -s->residual[i] - s->moved[i];
  memcpy(with->gap, p->gap, (size_t)p->count * sizeof *p->gap);
  add_gaps(s, p, s->moved, with->gap);
  with->active = p->active;
  memcpy(with->set, p->set, set * sizeof *p->set);
  if (arc_lcp_solve(with, line) != ARC_OK) return arc_contact_problem_fail(with, &s->at->error);
  const arc_status status = arc_contact_problem_check_zone(with, &s->at->error);
  if (status != ARC_OK) return status;
  arc_contact_problem_forces(with, s->force);
  wear_of(s, p, s->force, s->step);
  for (int i = 0; i < s->n; i++) s->step[i] += s->moved[i];
  p->active = with->active;
  memcpy(p->set, with->set, (size_t)with->active * sizeof *p->set);
  return ARC_OK;
}

arc_status arc_stage_solve_rest(newton *s, double h, double *rate) {
  const wear_block *b = s->at->window.block;
  contact_problem *p = &path_of(s->at->run)->problem[0];
  for (int it = 0; it < most_solutions; it++) {
    const double size = arc_newton_residual(s, h, rate);
    if (it > 0 && size <= 0.1 * arc_newton_allowed(s)) return ARC_OK;
    find_wear_of_forces(s, h, p);
    soften(s, p);
    arc_status status = solve_together(s, b->line[s->at->window.first], p);
    for (int i = 0; i < s->n && status == ARC_OK; i++) s->at->z[i] += s->step[i];
    if (s->mirrored) arc_wear_symmetrise(s->at->run, s->at->z);
    if (status == ARC_OK) status = arc_newton_evaluate(s, rate, 0);
    if (status != ARC_OK) return status;
  }
  return ARC_NOT_CONVERGED;
}

double arc_stage_forces(contact_problem *p, double *gap) {
  const int n = p->active;
  double sum = 0, total = 0, beside = 0, most = 0, load = 0;
  arc_dense_cholesky_solve(n, 1, p->factor, n, gap, n);
  for (int k = 0; k < n; k++) {
    const double down = p->down[p->set[k]];
    sum += down * gap[k];
    total += down * p->ones[k];
  }
  for (int k = 0; k < n; k++) {
    gap[k] = sum / total * p->ones[k] - gap[k];
    beside += gap[k];
    load += p->f[p->set[k]];
    most = fmax(most, fabs(beside));
  }
  return load > 0 ? most / load : 0;
}

double arc_stage_rest_error(newton *s, double *defect) {
  contact_problem *with = &s->with_wear, *p = &path_of(s->at->run)->problem[0];
  double *gap = with->step;
  if (arc_lcp_factorise(with)) return -1;
  memset(gap, 0, (size_t)p->count * sizeof *gap);
  add_gaps(s, p, defect, gap);
  for (int k = 0; k < with->active; k++) gap[k] = gap[with->set[k]];
  const double shifted = arc_stage_forces(with, gap);
  memset(s->force, 0, (size_t)p->nc * sizeof *s->force);
  for (int k = 0; k < with->active; k++) s->force[p->lo + with->set[k]] = gap[k];
  wear_of(s, p, s->force, s->moved);
  for (int i = 0; i < s->n; i++) defect[i] = (defect[i] + s->moved[i]) * arc_newton_share(s, i);
  return shifted;
}

/* Computes the wear of a cycle, or of a part of a cycle, on a given shape. The wear at the
 * points of the path is integrated by Eq. (4) or (5) of the paper on alpha and multiplied by
 * wear_block.repeat (Eqs. 22, 26 and 27). */
#include "core/base/callbacks.h"
#include "core/plane/cycle.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Increases the initial gaps of a contact problem by the depths of a window, which are measured
 * along the normals. */
static void deepen(const arc_wear *w, const double *depth, contact_problem *p) {
  const double *down = plane_of(w)->down;
  double *plate = plane_of(w)->plate, *below = plane_of(w)->below;
  for (int l = 0; l < p->np; l++) plate[l] = depth[p->nc + l] * down[p->nc + l];
  arc_contact_problem_to_cylinder(p, plate, below);
  for (int k = 0; k < p->count; k++) {
    const int i = p->lo + k;
    p->gap[k] += depth[i] * down[i] + below[i];
  }
}

/* Computes the wear rates at the cylinder's nodes from pressure and slip by the wear law. The
 * plate has the same wear rates, because both bodies have the same pressure at a pair of points. */
static void apply_law(const arc_wear *w, const wear_window *window, const contact_problem *p,
                      wear_point *point) {
  double *qc = point->q[ARC_CYLINDER], *qp = point->q[ARC_PLATE];
  if ((arc_law_properties[w->def.law] & ARC_LAW_LINEAR) && w->def.spin == 0) {
    memcpy(qc, point->p[ARC_CYLINDER], (size_t)path_of(w)->nodes * sizeof *qc);
    return;
  }
  const shape_side *side = &window->shape->side[ARC_CYLINDER];
  for (int i = 0; i < p->nc; i++)
    qc[i] = arc_wear_law_rubbed(w, point->p[ARC_CYLINDER][i], window->mu) *
            arc_wear_spin_share(w, side, i);
  arc_contact_problem_transfer(p, qc, qp);
}

arc_status arc_wear_prepare(arc_wear *w, const wear_window *window, int at, arc_error *error) {
  const wear_block *block = path_of(w)->block;
  contact_problem *p = &path_of(w)->problem[block->problem_of[at]];
  arc_contact_problem_set_angle(p, block->angle[at]);
  const arc_status status =
      arc_contact_problem_update(p, window->shape, block->problem_x[at], error);
  if (status == ARC_OK && window->depth) deepen(w, window->depth, p);
  return status;
}

arc_status arc_wear_find_local_factors(const arc_wear *w, const arc_wear_record *state,
                                       wear_point *point, arc_error *error) {
  for (int b = 0; b < ARC_BODIES && w->def.local_factor; b++) {
    double *local = point->f[b], *q = point->q[b];
    const wear_sites on = w->kind->sites(w->shape, (arc_body)b);
    const arc_status status = arc_wear_local(w, state, (arc_body)b, &on, point->p[b], local, error);
    if (status != ARC_OK) return status;
    for (int i = 0; i < sites_of(w, b); i++) q[i] *= local[i];
  }
  return ARC_OK;
}

arc_status arc_wear_take(arc_wear *w, const wear_window *window, const contact_problem *p,
                         wear_point *point, arc_error *error) {
  arc_contact_problem_pressures(p, point->p[ARC_CYLINDER], point->p[ARC_PLATE]);
  apply_law(w, window, p, point);
  for (int b = 0; b < ARC_BODIES && w->def.slip == ARC_SLIP_TOTAL; b++)
    arc_contact_problem_tangential(p, window->shape, (arc_body)b, point->u[b]);
  return window->state ? arc_wear_find_local_factors(w, window->state, point, error) : ARC_OK;
}

void arc_wear_share(const arc_wear *w, const contact_problem *p, const wear_point *point,
                    const double *work, double *on, wear_rate *rate) {
  const double *added[ARC_BODIES] = {work, on};
  arc_contact_problem_transfer(p, work, on);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < w->shape->side[b].n; i++)
      rate->node[b][i] += added[b][i] * (w->def.local_factor ? point->f[b][i] : 1);
}

/* Solves the contact at point `at` of the present block and stores the result in `point`. */
static arc_status solve_point(arc_wear *w, const wear_window *window, int at,
                              wear_progress *progress, wear_point *point, arc_error *error) {
  const wear_block *block = path_of(w)->block;
  arc_path_clear(path_of(w), point);
  if (block->line[at] == 0) return ARC_OK; /* bodies are separated */
  contact_problem *p = &path_of(w)->problem[block->problem_of[at]];
  arc_status status = arc_wear_prepare(w, window, at, error);
  if (status == ARC_OK && at > window->first)
    arc_contact_problem_start_from(p, &path_of(w)->problem[block->problem_of[at - 1]]);
  if (status == ARC_OK) status = arc_contact_problem_solve(p, block->line[at], error);
  if (status != ARC_OK) return status;
  progress->solutions++;
  return arc_wear_take(w, window, p, point, error);
}

/* Returns true if the contact problem at point `at` of the path is the same as at the previous
 * point: the plate has one position (NSP, or sliding along z), and load and angle have not changed.
 */
static int same_as_before(const arc_wear *w, const wear_window *window, int at) {
  const double *line = path_of(w)->block->line, *angle = path_of(w)->block->angle;
  const int stays = w->manner.procedure == ARC_NSP || w->def.slide == ARC_SLIDE_Z;
  return stays && at > window->first && line[at] == line[at - 1] && angle[at] == angle[at - 1];
}

/* Stores the width [mm] of the surface cell of each node on the shape of a window. */
static void note_widths(const arc_wear *w, const wear_window *window) {
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < window->shape->side[b].n; i++)
      sites_from(w, plane_of(w)->width, b)[i] = arc_shape_width(&window->shape->side[b], i);
}

/* Adapts the last point of the previous window to the wear since then. The nodal forces,
 * pressure times width, remain the same. With elastic slip the contact problem is updated as
 * well, because it transfers work to the plate. */
static arc_status keep_forces(arc_wear *w, const wear_window *window, wear_point *point,
                              arc_error *error) {
  for (int b = 0; b < ARC_BODIES; b++) {
    double *width = sites_from(w, plane_of(w)->width, b);
    for (int i = 0; i < window->shape->side[b].n; i++) {
      const double now = arc_shape_width(&window->shape->side[b], i), share = width[i] / now;
      point->p[b][i] *= share;
      point->q[b][i] *= share;
      width[i] = now;
    }
  }
  const int meets = w->def.slip == ARC_SLIP_TOTAL && path_of(w)->block->line[window->first] > 0;
  return meets ? arc_wear_prepare(w, window, window->first, error) : ARC_OK;
}

/* Computes point `at` of a window. Solves the contact, copies an equal previous point, or adapts
 * the last point of the previous window. */
static arc_status reach_point(arc_wear *w, const wear_window *window, int at,
                              wear_progress *progress, arc_error *error) {
  wear_point *now = &path_of(w)->point[at % 2];
  const arc_status status = callbacks_check(progress->callbacks, error);
  if (status != ARC_OK) return status;
  if (window->chained && at == window->first) return keep_forces(w, window, now, error);
  if (!same_as_before(w, window, at)) return solve_point(w, window, at, progress, now, error);
  arc_path_copy(path_of(w), &path_of(w)->point[(at + 1) % 2], now);
  return ARC_OK;
}

/* Adds the wear of the increment that ends at point `at`, computed from the wear rates at both
 * ends. */
static void add_increment(const arc_wear *w, const wear_point point[2], int at, wear_rate *rate) {
  const wear_block *block = path_of(w)->block;
  const wear_point *now = &point[at % 2], *before = &point[(at + 1) % 2];
  if (w->def.slip == ARC_SLIP_TOTAL) {
    arc_wear_add_work(w, at, rate);
    return;
  }
  const double slip = fabs(block->x[at] - block->x[at - 1]);
  const int mean = w->def.rule == ARC_TRAPEZOID;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < w->shape->side[b].n; i++) {
      const double q = mean ? (now->q[b][i] + before->q[b][i]) / 2 : now->q[b][i];
      rate->node[b][i] += block->repeat * q * slip;
    }
}

/* On a slope the sliding distance is the distance of the plate times the cosine of the slope.
 * The projection of a surface cell on x is its length times the same cosine, and pressure times
 * the projected width is the force. Therefore the wear along the normal removes the area k force
 * |dx|. If the motion is out of the plane, every slope slides by the whole distance. In holes,
 * pressures refer to the area of the hole. For bodies of revolution, areas are projected onto x. */
double arc_wear_slope_share(const arc_wear *w, const wear_window *window, arc_body b, int i) {
  const shape_side *side = &window->shape->side[b];
  const chart *c = &side->body->chart;
  const int out = w->def.slide == ARC_SLIDE_Z && !c->revolved.on && !c->polar;
  if (window->shape->geometry == ARC_FROZEN || out) return 1;
  return arc_shape_width(side, i) / arc_shape_span(window->shape, b, i);
}

static void incline(const arc_wear *w, const wear_window *window, wear_rate *rate) {
  const int n = w->nc + w->np;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < window->shape->side[b].n; i++) {
      const double share = arc_wear_slope_share(w, window, (arc_body)b, i);
      const int row = b == ARC_CYLINDER ? i : w->nc + i;
      if (share == 1) continue;
      rate->node[b][i] *= share;
      for (int c = 0; c < n && window->tangent; c++)
        window->tangent->value[(size_t)row + (size_t)c * (size_t)n] *= share;
    }
}

/* Adds the uniform wear of the plate, Eq. (27) of the paper on alpha. In a stroke over the whole
 * plate, the whole pressure profile passes over each node of the plate. With Archard's law the
 * integral of the pressure is the load. */
static void add_even(const arc_wear *w, const wear_point *point, wear_rate *rate) {
  const shape_side *plate = &w->shape->side[ARC_PLATE];
  for (int l = 0; l < plate->n; l++)
    rate->even += point->q[ARC_PLATE][l] * arc_shape_width(plate, l);
}

/* Computes the uniform wear of the plate with total slip: the integral of the wear over the
 * plate's nodes, divided by the sliding distance. */
static void spread_work(const arc_wear *w, wear_rate *rate) {
  const shape_side *plate = &w->shape->side[ARC_PLATE];
  for (int l = 0; l < plate->n; l++)
    rate->even += rate->node[ARC_PLATE][l] * arc_shape_width(plate, l);
  rate->even /= path_of(w)->block->sliding;
}

/* Returns the weight [mm] of point `at` in the integral over the sliding distance of the window. */
static double weight(const arc_wear *w, const wear_window *window, int at) {
  const wear_block *b = path_of(w)->block;
  const double before = at > window->first ? fabs(b->x[at] - b->x[at - 1]) : 0;
  const double after = at < window->last ? fabs(b->x[at + 1] - b->x[at]) : 0;
  return b->repeat * (w->def.rule == ARC_TRAPEZOID ? (before + after) / 2 : before);
}

double arc_wear_window_sliding(const arc_wear *w, const wear_window *window) {
  double sum = 0;
  for (int at = window->first; at <= window->last; at++) sum += weight(w, window, at);
  return sum;
}

static void add_to_jacobian(const arc_wear *w, const wear_window *window, int at) {
  const wear_block *block = path_of(w)->block;
  const double share = weight(w, window, at);
  if (!window->tangent || block->line[at] == 0) return;
  arc_wear_jacobian_add(w, window, at, share, NULL);
}

/* Returns the normal force on the cylinder at point `point` of the path, per thickness [N/mm]. With
 * a spin, the force on each node is weighted by the slip of the node divided by the slip at the
 * reference radius. */
static double pressing(const arc_wear *w, const wear_window *window, const wear_point *point) {
  const shape_side *side = &window->shape->side[ARC_CYLINDER];
  double sum = 0;
  for (int i = 0; i < side->n; i++)
    sum += point->p[ARC_CYLINDER][i] * arc_shape_width(side, i) * arc_wear_spin_share(w, side, i);
  return sum;
}

/* Adds the normal force times the sliding distance of the increment that ends at point `at`. This
 * is necessary if the normal force differs from the load, as in rings, in holes and with a spin. */
static void add_pressing(const arc_wear *w, const wear_window *window, int at, wear_rate *rate) {
  const wear_block *b = path_of(w)->block;
  if (!w->manner.counts_forces) return;
  const double now = pressing(w, window, &path_of(w)->point[at % 2]);
  const int mean = w->def.rule == ARC_TRAPEZOID;
  const double before = mean ? pressing(w, window, &path_of(w)->point[(at + 1) % 2]) : now;
  rate->pressed += b->repeat * (now + before) / 2 * fabs(b->x[at] - b->x[at - 1]);
}

static void note_peak(const arc_wear *w, const wear_point *point, wear_rate *rate) {
  for (int i = 0; i < w->nc; i++) rate->peak = fmax(rate->peak, point->p[ARC_CYLINDER][i]);
}

arc_status arc_wear_probe(arc_wear *w, const wear_window *window, arc_error *error) {
  wear_progress unreported = {0};
  const arc_status status = arc_path_enter(path_of(w), window->block, w->model, error);
  if (status != ARC_OK) return status;
  return solve_point(w, window, window->first, &unreported, &path_of(w)->point[0], error);
}

/* Adds the wear of the mirror image of point `at`, computed with the local factors of the image.
 * Without local factors, the wear of the image is the mirror image of the wear of the point. */
static arc_status add_image(arc_wear *w, const wear_window *window, int at, wear_rate *images,
                            arc_error *error) {
  const wear_block *block = path_of(w)->block;
  wear_point law = path_of(w)->point[at % 2];
  for (int b = 0; b < ARC_BODIES; b++)
    law.q[b] = law.u[b]; /* u is workspace here, because it is
                            unused without elastic slip */
  if (block->line[at] > 0) apply_law(w, window, &path_of(w)->problem[block->problem_of[at]], &law);
  const arc_status status = arc_wear_reflect(w, window, at, &law, error);
  if (status == ARC_OK && at > window->first) add_increment(w, path_of(w)->image, at, images);
  return status;
}

/* Adds up the wear of a window point by point. Also adds up the wear of the mirror images if
 * `images` is not NULL. */
static arc_status integrate(arc_wear *w, const wear_window *window, wear_progress *progress,
                            wear_rate *rate, wear_rate *images, arc_error *error) {
  arc_wear_rate_clear(rate, w->nc + w->np);
  if (images) arc_wear_rate_clear(images, w->nc + w->np);
  if (window->tangent) arc_wear_jacobian_clear(window->tangent);
  for (int at = window->first; at <= window->last; at++) {
    arc_status status = reach_point(w, window, at, progress, error);
    if (status == ARC_OK && images) status = add_image(w, window, at, images, error);
    if (status != ARC_OK) return status;
    note_peak(w, &path_of(w)->point[at % 2], rate);
    add_to_jacobian(w, window, at);
    if (at > window->first) {
      add_increment(w, path_of(w)->point, at, rate);
      add_pressing(w, window, at, rate);
    } else if (w->manner.even && w->def.slip == ARC_SLIP_RIGID) {
      add_even(w, &path_of(w)->point[at % 2], rate);
    }
  }
  if (window->tangent) arc_wear_jacobian_finish(window->tangent);
  note_widths(w, window);
  return ARC_OK;
}

static arc_status integrate_half(arc_wear *w, const wear_window *window, wear_progress *progress,
                                 wear_rate *rate, arc_error *error) {
  wear_rate other = {.node = {plane_of(w)->slip, plane_of(w)->slip + w->nc}};
  wear_rate *images = arc_wear_has_local_factors(w, window) ? &other : NULL;
  wear_window half = *window;
  half.last = window->last / 2;
  const arc_status status = integrate(w, &half, progress, rate, images, error);
  if (status != ARC_OK) return status;
  arc_wear_add_mirror(w, window, images, rate);
  for (int at = half.last + 1; at <= window->last; at++)
    progress->solutions += path_of(w)->block->line[at] > 0; /* mirror images count as solutions */
  return ARC_OK;
}

arc_status arc_wear_evaluate(arc_wear *w, const wear_window *window, wear_progress *progress,
                             wear_rate *rate, arc_error *error) {
  assert(0 <= window->first && window->last < window->block->count);
  if (w->manner.closed) { /* in a run in closed form the wear depends on the load only */
    arc_wear_rate_clear(rate, w->nc + w->np);
    if (window->tangent) arc_wear_jacobian_clear(window->tangent);
    rate->even = window->block->line[0];
    return ARC_OK;
  }
  arc_status status = arc_path_enter(path_of(w), window->block, w->model, error);
  if (status != ARC_OK) return status;
  double *down = plane_of(w)->down;
  for (int b = 0; b < ARC_BODIES && window->depth; b++)
    arc_shape_downward(window->shape, (arc_body)b, sites_from(w, down, b));
  if (arc_wear_has_friction(&w->def))
    status = arc_wear_fret(w, window, progress, rate, error);
  else if (arc_wear_is_mirrored(w, window))
    status = integrate_half(w, window, progress, rate, error);
  else
    status = integrate(w, window, progress, rate, NULL, error);
  if (status != ARC_OK) return status;
  const int by_work = arc_wear_has_friction(&w->def) || w->def.slip == ARC_SLIP_TOTAL;
  if (w->manner.even && by_work) spread_work(w, rate);
  incline(w, window, rate);
  if (arc_wear_rests_mirrored(w, window)) arc_wear_symmetrise(w, rate->node[0]);
  return ARC_OK;
}

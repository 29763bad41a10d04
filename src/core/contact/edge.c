/* Where a contact ends, and the pressure next to its end. Leans on pose.c's solution.
 *
 * Between the last node in contact and the next one lies the edge. Where surfaces meet smoothly
 * there, as Hertz' do, pressure falls as c sqrt(d) towards it and the gap opens beyond it as
 * 4 c d^(3/2) / (3 E*), with c nearly linear in d. The gaps a few nodes outside then place the edge
 * to a twentieth of an element, which the last node's force, the sum of what its element gets,
 * cannot. At the kinks of scars neither law holds: the two c part, and what the last node and the
 * next one say is left. */
#include "core/contact/pose.h"

#include <math.h>

/* One end of the contact: nodes by steps from the last one in contact, positive outwards. */
typedef struct ending {
  const pose *p;
  const double *xy; /* of the cylinder's surface nodes */
  int last;         /* candidate */
  int out;          /* 1: right, -1: left */
  double E_star;
} ending;

static double place(const ending *e, int step) {
  return e->out * e->xy[2 * (e->p->lo + e->last + e->out * step)];
}

static double pressure(const ending *e, int step) {
  const int k = e->last + e->out * step;
  return e->p->f[k] / e->p->wc[e->p->lo + k];
}

static double gap(const ending *e, int step) {
  return e->p->open[e->last + e->out * step];
}

/* Between the last node in contact (pressure q at distance 0) and the next one (gap g at distance
 * h) both laws hold with one c. Solves for the distance. */
static double edge_between(const ending *e) {
  const double q = pressure(e, 0), g = gap(e, 1), h = place(e, 1) - place(e, 0);
  double low = 0, high = h;
  for (int i = 0; i < 60; i++) {
    const double d = (low + high) / 2;
    if (4 * q * pow(h - d, 1.5) > 3 * e->E_star * g * sqrt(d))
      low = d;
    else
      high = d;
  }
  return place(e, 0) + (low + high) / 2;
}

/* Where gap^(2/3) of three nodes outside comes down to zero, by the parabola through the places as
 * they depend on it. */
static double edge_from_gaps(const ending *e) {
  enum { first = 2, points = 3 };
  double at[points], opening[points];
  for (int i = 0; i < points; i++) {
    at[i] = place(e, first + i);
    opening[i] = cbrt(gap(e, first + i) * gap(e, first + i));
  }
  for (int span = 1; span < points; span++)
    for (int i = 0; i + span < points; i++)
      at[i] =
          (opening[i + span] * at[i] - opening[i] * at[i + 1]) / (opening[i + span] - opening[i]);
  return at[0];
}

/* The line through (x, y) at two places, at a third. */
static double line_at(double at, double xa, double ya, double xb, double yb) {
  return ya + (yb - ya) * (at - xa) / (xb - xa);
}

/* c at the edge as the pressures inside have it, over c as the gaps outside do. */
static double ratio_at(const ending *e, double edge) {
  double inside[2], outside[2];
  for (int i = 0; i < 2; i++) {
    inside[i] = pressure(e, -2 + i) / sqrt(edge - place(e, -2 + i));
    outside[i] = 3 * e->E_star * gap(e, 2 + i) / (4 * pow(place(e, 2 + i) - edge, 1.5));
  }
  return line_at(edge, place(e, -2), inside[0], place(e, -1), inside[1]) /
         line_at(edge, place(e, 2), outside[0], place(e, 3), outside[1]);
}

/* Whether there are nodes enough on both sides for the laws to be compared: on this half of the
 * contact. */
static int has_nodes(const ending *e) {
  enum { inside = 3, outside = 4, active = 7 };
  if (e->p->active < active) return 0;
  const int inner = e->last - e->out * inside, outer = e->last + e->out * outside;
  if (inner < 0 || inner >= e->p->count || outer < 0 || outer >= e->p->count) return 0;
  for (int step = -inside; step < 0; step++)
    if (!(pressure(e, step) > 0)) return 0;
  for (int step = 1; step < outside; step++)
    if (!(gap(e, step + 1) > gap(e, step) && gap(e, step) > 0)) return 0;
  return 1;
}

/* 1 where the two c agree as well as in unworn contacts, 0 where they are a third apart: measured
 * over worn contacts against finer meshes, the gaps place the edge better as long as they agree. */
static double smoothness(const ending *e, double edge) {
  static const double alike = 0.15, apart = 0.3;
  const double h = place(e, 1) - place(e, 0);
  if (!(edge > place(e, 0) - h / 2 && edge < place(e, 2) - h / 2)) return 0;
  const double off = fabs(ratio_at(e, edge) - 1);
  return fmax(0, fmin(1, (apart - off) / (apart - alike)));
}

contact_edge arc_pose_edge(const pose *p, const arc_shape *shape, int right) {
  const arc_model_def *def = arc_model_definition(shape->model);
  const ending e = {.p = p,
                    .xy = shape->side[ARC_CYLINDER].xy,
                    .last = right ? p->set[p->active - 1] : p->set[0],
                    .out = right ? 1 : -1,
                    .E_star = arc_contact_modulus(def->geometry, def->material)};
  contact_edge edge = {.out = e.out, .width = place(&e, 1) - place(&e, 0)};
  double x = edge_between(&e);
  if (has_nodes(&e)) {
    const double far = edge_from_gaps(&e);
    edge.smooth = smoothness(&e, far);
    if (edge.smooth > 0) x += edge.smooth * (far - x);
  }
  edge.x = e.out * x;
  return edge;
}

void arc_pose_edges(const pose *p, const arc_shape *shape, double edges[2]) {
  for (int side = 0; side < 2; side++) edges[side] = arc_pose_edge(p, shape, side).x;
}

/* The first node of x [n] at least `reach` inside the edge, or -1; the next inwards follows it by
 * -out. */
static int first_inside(const contact_edge *edge, int n, const double *x, double reach) {
  int i = edge->out > 0 ? n - 1 : 0;
  while (i >= 0 && i < n && edge->out * (edge->x - x[i]) < reach) i -= edge->out;
  return i >= 0 && i < n ? i : -1;
}

void arc_edge_sharpen(const contact_edge *edge, int n, const double *x, double *p) {
  const int a = first_inside(edge, n, x, edge->width), b = a - edge->out;
  if (edge->smooth == 0 || a < 0 || b < 0 || b >= n || !(p[a] > 0 && p[b] > 0)) return;
  const double ca = p[a] / sqrt(fabs(edge->x - x[a])), cb = p[b] / sqrt(fabs(edge->x - x[b]));
  for (int i = a + edge->out; i >= 0 && i < n; i += edge->out) {
    const double d = edge->out * (edge->x - x[i]);
    const double exact = d > 0 ? line_at(x[i], x[a], ca, x[b], cb) * sqrt(d) : 0;
    p[i] += edge->smooth * (exact - p[i]);
  }
}

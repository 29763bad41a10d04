/* Computes the edges of a contact, and the pressure next to them. In a smooth contact, such as
 * Hertz', the pressure falls as c sqrt(d) towards the edge, and the gap opens outside it as 4 c
 * d^(3/2) / (3 E*). Here d is the distance from the edge and E* the contact modulus. In a
 * half-plane both belong to one analytic function. If c is linear in d, this function has three
 * parameters: the edge, c at the edge, and the slope of c. They are fitted to nodal forces and gaps
 * a few nodes away, where elements are accurate. Values at nearer nodes depend on where the edge
 * lies between two nodes. The law does not apply to scars, whose surfaces have kinks; there the gap
 * outside the contact is extrapolated to 0. */
#include "core/base/dense.h"
#include "core/contact/contact_problem.h"

#include <math.h>
#include <string.h>

/* One end of the contact. Nodes are counted in steps from the last node in contact, positive
 * outwards. */
typedef struct ending {
  const contact_problem *p;
  const double *xy; /* [n] positions of the cylinder's surface nodes */
  int last;         /* last candidate in contact */
  int out;          /* 1: right end, -1: left end */
  double E_star;
} ending;

static double node_x(const ending *e, int step) {
  return e->out * e->xy[2 * (e->p->lo + e->last + e->out * step)];
}

static double pressure(const ending *e, int step) {
  const int k = e->last + e->out * step;
  return e->p->f[k] / e->p->wc[e->p->lo + k];
}

static double gap(const ending *e, int step) {
  return fmax(0, e->p->open[e->last + e->out * step]);
}

/* Square-root law of the pressure, c0 sqrt(d) + c1 d sqrt(d), at the distance d from the edge x. */
typedef struct edge_law {
  double x, c[2];
} edge_law;

/* Returns how much steeper the gap to the power 1/m is between the second and the third node
 * outside the contact than between the first and the second. It is 0 if the gap opens with the
 * power m. */
static double bend_of_power(const ending *e, double m) {
  double slope[2];
  for (int i = 0; i < 2; i++)
    slope[i] = (pow(gap(e, i + 2), 1 / m) - pow(gap(e, i + 1), 1 / m)) /
               (node_x(e, i + 2) - node_x(e, i + 1));
  return slope[1] - slope[0];
}

/* Returns the exponent m of the gap, which is proportional to d^m at the distance d from the edge:
 * 1 at the kink of a scar of stiff bodies, 3/2 where the surfaces are smooth, between them in other
 * worn contacts. */
static double find_power(const ending *e) {
  double low = 1, high = 1.5;
  if (e->last + 3 * e->out < 0 || e->last + 3 * e->out >= e->p->count) return high;
  for (int i = 0; i < 50; i++) {
    const double m = (low + high) / 2;
    if (bend_of_power(e, m) > 0)
      low = m;
    else
      high = m;
  }
  return (low + high) / 2;
}

/* Returns the position of the edge, where the gap is 0 if it is extrapolated from outside the
 * contact with its exponent. It is between the last node in contact and the next node. */
static double edge_between(const ending *e) {
  const double from = node_x(e, 0), next = node_x(e, 1);
  const int second = e->last + 2 * e->out;
  if (second < 0 || second >= e->p->count) return (from + next) / 2;
  const double m = find_power(e);
  const double g = pow(gap(e, 1), 1 / m), farther = pow(gap(e, 2), 1 / m);
  if (!(farther > g)) return from;
  return fmax(from, next - g * (node_x(e, 2) - next) / (farther - g));
}

/* --- the law ---------------------------------------------------------------------------------- */

/* Equation of the fit at one node. `value` is the pressure, or outside the contact the scaled gap
 * (see equation_outside). of_c and of_x are the derivatives of the residual (edge law minus
 * `value`) with respect to the parameters c and x. */
typedef struct equation {
  double of_c[2], of_x, value;
} equation;

/* Computes second differences of d^(3/2), d^(5/2) and d^(7/2), with the distance d from the edge.
 * Nodal pressures are means under hat functions, and therefore second differences of the double
 * integral of the pressure. */
static void find_differences(const ending *e, double edge, int step, double difference[3]) {
  double at[3], power[3][3];
  for (int i = 0; i < 3; i++) {
    at[i] = node_x(e, step - 1 + i);
    const double d = fmax(0, edge - at[i]);
    power[i][0] = d * sqrt(d);
    power[i][1] = power[i][0] * d;
    power[i][2] = power[i][1] * d;
  }
  const double left = at[1] - at[0], right = at[2] - at[1], scale = 2 / (left + right);
  for (int k = 0; k < 3; k++)
    difference[k] =
        scale * ((power[2][k] - power[1][k]) / right - (power[1][k] - power[0][k]) / left);
}

static equation equation_inside(const ending *e, const edge_law *law, int step) {
  double of[3];
  find_differences(e, law->x, step, of);
  return (equation){.of_c = {of[1] / 3.75, of[2] / 8.75},
                    .of_x = law->c[0] * of[0] / 1.5 + law->c[1] * of[1] / 2.5,
                    .value = pressure(e, step)};
}

/* Returns the equation of the gap g outside the contact as E* g / distance, which has the unit of a
 * pressure. */
static equation equation_outside(const ending *e, const edge_law *law, int step) {
  const double s = node_x(e, step) - law->x, root = sqrt(s), g = e->E_star * gap(e, step) / s;
  equation q = {.of_c = {4 * root / 3, -4 * s * root / 5}, .value = g};
  q.of_x = -2 * law->c[0] / (3 * root) + 6 * law->c[1] * root / 5 - g / s;
  return q;
}

/* Nodes used in the fit, in steps from the last node in contact: `first` to `last_inside` in
 * contact, `from` to `to` outside. */
typedef struct stencil {
  int first, from, to;
} stencil;

enum { last_inside = -2, unknowns = 3 };

/* Adds an equation to the normal equations for changes of c and x. Returns its residual. */
static double add_equation(const edge_law *law, const equation *q, double a[unknowns * unknowns],
                           double b[unknowns]) {
  const double row[unknowns] = {q->of_c[0], q->of_c[1], q->of_x};
  const double off = q->value - law->c[0] * row[0] - law->c[1] * row[1];
  for (int i = 0; i < unknowns; i++) {
    for (int j = 0; j < unknowns; j++) a[dense_at(i, j, unknowns)] += row[i] * row[j];
    b[i] += row[i] * off;
  }
  return off;
}

/* Sets up the normal equations at given parameters. Returns the root mean square of the
 * residuals. */
static double add_equations(const ending *e, const stencil *at, const edge_law *law,
                            double a[unknowns * unknowns], double b[unknowns]) {
  double sum = 0;
  int count = 0;
  for (int step = at->first; step <= at->to; step++) {
    if (step > last_inside && step < at->from) continue;
    const equation q = step < 0 ? equation_inside(e, law, step) : equation_outside(e, law, step);
    const double off = add_equation(law, &q, a, b);
    sum += off * off;
    count++;
  }
  return sqrt(sum / count);
}

/* Fits the edge law by Gauss-Newton least squares, beginning with the interpolated edge `start`.
 * Returns the residual divided by the pressure one element inside the edge; INFINITY without
 * convergence. */
static double fit_law(const ending *e, const stencil *at, double start, edge_law *law) {
  enum { most_iterations = 12 };
  const double h = node_x(e, 1) - node_x(e, 0);
  *law = (edge_law){.x = start, .c = {pressure(e, -2) / sqrt(start - node_x(e, -2)), 0}};
  for (int it = 0; it < most_iterations; it++) {
    double a[unknowns * unknowns] = {0}, b[unknowns] = {0};
    const double off = add_equations(e, at, law, a, b);
    if (arc_dense_cholesky(unknowns, a, unknowns)) return INFINITY;
    arc_dense_cholesky_solve(unknowns, 1, a, unknowns, b, unknowns);
    for (int i = 0; i < 2; i++) law->c[i] += b[i];
    law->x += b[2];
    if (!(law->x > node_x(e, 0) - h / 2 && law->x < node_x(e, 2) - h / 2)) return INFINITY;
    if (fabs(b[2]) < 1e-7 * h) return law->c[0] > 0 ? off / (law->c[0] * sqrt(h)) : INFINITY;
  }
  return INFINITY;
}

/* Returns true if all nodes of the fit exist, both in this half of the contact and outside the
 * contact, with positive pressures inside and increasing gaps outside. */
static int has_nodes(const ending *e, const stencil *at) {
  if (e->p->active < 1 - 2 * at->first) return 0;
  const int inner = e->last + e->out * (at->first - 1), outer = e->last + e->out * at->to;
  if (inner < 0 || inner >= e->p->count || outer < 0 || outer >= e->p->count) return 0;
  for (int step = at->first; step < 0; step++)
    if (!(pressure(e, step) > 0)) return 0;
  for (int step = 1; step < at->to; step++)
    if (!(gap(e, step + 1) > gap(e, step) && gap(e, step) > 0)) return 0;
  return 1;
}

/* Fits the edge law at nodes so far from the edge that the position of the edge between nodes has
 * no influence. If the law does not fit there, fits it at nearer nodes. Returns the weight of the
 * fitted edge: 1 if the law fits as well as in unworn contacts, 0 if it does not fit, and an
 * intermediate value between these limits. Tests with finer meshes of worn contacts showed that the
 * edge of a law that fits is more accurate than the extrapolated edge `start` if both are less than
 * `near` elements apart, and less accurate if they are more than `far` elements apart. */
static double find_law(const ending *e, double start, edge_law *law) {
  static const stencil stencils[] = {{-4, 3, 5}, {-3, 2, 3}};
  static const double holds = 0.018, fails = 0.024, near = 0.25, far = 0.4;
  double off = INFINITY;
  for (int s = 0; s < 2 && off > holds; s++)
    if (has_nodes(e, &stencils[s])) off = fit_law(e, &stencils[s], start, law);
  const double apart = fabs(law->x - start) / (node_x(e, 1) - node_x(e, 0));
  return fmax(0, fmin(1, (fails - off) / (fails - holds))) *
         fmax(0, fmin(1, (far - apart) / (far - near)));
}

contact_edge arc_contact_problem_edge(const contact_problem *p, const arc_shape *shape, int right) {
  ending e = {.p = p,
              .xy = shape->side[ARC_CYLINDER].xy,
              .last = right ? p->set[p->active - 1] : p->set[0],
              .out = right ? 1 : -1};
  contact_edge edge = {.out = e.out, .width = node_x(&e, 1) - node_x(&e, 0)};
  /* contact modulus with layers, for pressure waves about as long as the fitted range */
  e.E_star = arc_model_apparent_modulus(shape->handle.model, 1 / edge.width);
  const double between = edge_between(&e);
  edge_law law = {0};
  edge.smooth = shape_is_corrected(shape) ? find_law(&e, between, &law) : 0;
  double x = between;
  if (edge.smooth > 0) {
    x += edge.smooth * (law.x - between);
    memcpy(edge.c, law.c, sizeof edge.c);
  }
  edge.x = e.out * x;
  return edge;
}

void arc_contact_problem_edges(const contact_problem *p, const arc_shape *shape, double edges[2]) {
  for (int side = 0; side < 2; side++) edges[side] = arc_contact_problem_edge(p, shape, side).x;
}

void arc_edge_sharpen(const contact_edge *edge, int n, const double *x, double share, double *p) {
  static const double reach = 2; /* [elements] largest distance from the edge into the contact */
  for (int i = 0; i < n && edge->smooth > 0; i++) {
    const double d = edge->out * (edge->x - x[i]), root = sqrt(fmax(0, d));
    if (d > reach * edge->width) continue;
    p[i] += edge->smooth * (share * root * (edge->c[0] + edge->c[1] * d) - p[i]);
  }
}

/* Returns the stress along the surface of a half-plane [MPa] under a shear traction equal to the
 * pressure: 2 (c0 sqrt(s) - c1 s sqrt(s)) at the distance s outside the edge. Also computes the
 * integral of this stress. */
static double cusp_at(const contact_edge *edge, double x, double *integral) {
  const double s = fmax(0, edge->out * (x - edge->x)), root = sqrt(s);
  *integral = root * s * (edge->c[0] / 0.75 - edge->c[1] * s / 1.25);
  return 2 * edge->out * root * (edge->c[0] - edge->c[1] * s);
}

void arc_edge_add_cusp(const contact_edge *edge, int n, const double *x, double share,
                       double *cusp) {
  static const double reach = 4; /* [elements] at larger distances nodal means are accurate */
  for (int i = 1; i + 1 < n && edge->smooth > 0; i++) {
    const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
    double sum[3];
    if (fabs(x[i] - edge->x) > reach * edge->width) continue;
    cusp_at(edge, x[i - 1], &sum[0]);
    cusp_at(edge, x[i + 1], &sum[2]);
    const double point = cusp_at(edge, x[i], &sum[1]);
    const double before = (sum[1] - sum[0]) / left, after = (sum[2] - sum[1]) / right;
    cusp[i] += edge->smooth * share * (point - (before * right + after * left) / (left + right));
  }
}

/* Solves the linear problem of a Newton step for stick and slip by conjugate gradients,
 * preconditioned by the operator's diagonal. A projection keeps the resultant forces constant. */
#include "core/space/stick_slip.h"

#include <math.h>
#include <string.h>

/* The larger of two numbers. fmax, which also handles NaN, is not compiled inline. */
static double larger(double a, double b) {
  return a > b ? a : b;
}

static int cells_of(const stick_slip_problem *p) {
  return p->h->cells;
}

/* Computes the product of a symmetric matrix xx, xz, zz and a vector. */
static void times(const double matrix[3], double x, double z, double result[2]) {
  result[0] = matrix[0] * x + matrix[1] * z;
  result[1] = matrix[1] * x + matrix[2] * z;
}

static stick_slip_site site_of(const stick_slip_problem *p, const stick_slip_work *w, int k) {
  const double *self = p->h->shear->self;
  if (w->state[k] == SHEAR_STICK)
    return (stick_slip_site){k, {1, 0, 1}, {1 / self[0], 0, 1 / self[1]}, 0};
  const double t[2] = {w->tangent[0][k], w->tangent[1][k]};
  const double xx = t[0] * t[0], xz = t[0] * t[1], zz = t[1] * t[1];
  const double whole = self[0] * xx + self[1] * zz + w->diagonal[k];
  return (stick_slip_site){k, {xx, xz, zz}, {xx / whole, xz / whole, zz / whole}, w->diagonal[k]};
}

/* Lists the cells that carry shear; all other cells keep q = 0. */
static void list_sites(const stick_slip_problem *p, stick_slip_work *w) {
  w->sites = 0;
  for (int k = 0; k < cells_of(p); k++)
    if (w->state[k] != SHEAR_NONE) w->site[w->sites++] = site_of(p, w, k);
}

static double dot(const stick_slip_work *w, double *const a[2], double *const b[2]) {
  double sum = 0;
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    sum += a[0][k] * b[0][k] + a[1][k] * b[1][k];
  }
  return sum;
}

/* Data of the projection that does not change the given forces. A 2 x 2 matrix maps a motion to the
 * sums over the cells of M^-1 times this motion, with the operator's diagonal M; `inverse` is the
 * inverse of this matrix. */
typedef struct holding {
  double inverse[2][2];
  int singular;
} holding;

static holding find_holding(const stick_slip_problem *p, const stick_slip_work *w) {
  static const double unit[2][2] = {{1, 0}, {0, 1}};
  static const double least = 1e-9;
  double g[2][2] = {{0, 0}, {0, 0}};
  for (int s = 0; s < w->sites; s++)
    for (int i = 0; i < 2; i++) {
      double z[2];
      if (!p->by_force[i]) continue;
      times(w->site[s].inverse, unit[i][0], unit[i][1], z);
      for (int j = 0; j < 2; j++) g[i][j] += p->by_force[j] ? z[j] : 0;
    }
  holding h = {{{0, 0}, {0, 0}}, 0};
  if (p->by_force[0] && p->by_force[1]) {
    const double det = g[0][0] * g[1][1] - g[0][1] * g[1][0], trace = g[0][0] + g[1][1];
    h.singular = !(det > least * trace * trace);
    if (h.singular) return h;
    h.inverse[0][0] = g[1][1] / det;
    h.inverse[1][1] = g[0][0] / det;
    h.inverse[0][1] = h.inverse[1][0] = -g[0][1] / det;
    return h;
  }
  for (int i = 0; i < 2; i++)
    if (p->by_force[i]) {
      h.singular = !(g[i][i] > 0);
      h.inverse[i][i] = h.singular ? 0 : 1 / g[i][i];
    }
  return h;
}

/* Computes the motion for which the sums of M^-1 times the motion equal `sum`. */
static void motion_of(const holding *h, const double sum[2], double motion[2]) {
  for (int i = 0; i < 2; i++) motion[i] = h->inverse[i][0] * sum[0] + h->inverse[i][1] * sum[1];
}

/* Computes z = M^-1 (r - motion) from the residual r of all cells. The motion is the same for all
 * cells. Along an axis with a given force its value is such that the sum of z over the cells is 0;
 * along other axes it is 0. */
static void precondition(const stick_slip_work *w, const holding *h, double motion[2]) {
  double sum[2] = {0, 0};
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double z[2];
    times(w->site[s].inverse, w->r[0][k], w->r[1][k], z);
    sum[0] += z[0];
    sum[1] += z[1];
  }
  motion_of(h, sum, motion);
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double z[2];
    times(w->site[s].inverse, w->r[0][k] - motion[0], w->r[1][k] - motion[1], z);
    w->z[0][k] = z[0];
    w->z[1][k] = z[1];
  }
}

/* Computes a = C d + D d, projected onto the free directions, with the compliance C to shear and
 * the diagonal matrix D of w->diagonal at slipping cells. */
static void apply(const stick_slip_problem *p, stick_slip_work *w, stick_slip_count *count) {
  arc_cerruti_shear_in(p->h, &w->box, (const double *const[2]){w->d[0], w->d[1]}, w->a);
  count->applications++;
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double part[2];
    times(w->site[s].free, w->a[0][k], w->a[1][k], part);
    for (int i = 0; i < 2; i++) w->a[i][k] = part[i] + w->site[s].slip * w->d[i][k];
  }
}

static void step(stick_slip_work *w, double length) {
  for (int i = 0; i < 2; i++)
    for (int s = 0; s < w->sites; s++) {
      const int k = w->site[s].cell;
      w->q[i][k] += length * w->d[i][k];
      w->r[i][k] -= length * w->a[i][k];
    }
}

/* Changes q so that its sums over the cells equal the given forces. */
static void hold_forces(const stick_slip_problem *p, stick_slip_work *w, const holding *h,
                        stick_slip_count *count) {
  const double area = p->h->def.size_x * p->h->def.size_z;
  double lacking[2] = {0, 0}, motion[2];
  for (int i = 0; i < 2; i++) {
    if (!p->by_force[i]) continue;
    lacking[i] = p->force[i] / area;
    for (int s = 0; s < w->sites; s++) lacking[i] -= w->q[i][w->site[s].cell];
  }
  motion_of(h, lacking, motion);
  if (motion[0] == 0 && motion[1] == 0) return;
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double z[2];
    times(w->site[s].inverse, motion[0], motion[1], z);
    w->d[0][k] = z[0];
    w->d[1][k] = z[1];
  }
  apply(p, w, count);
  step(w, 1);
}

/* Returns the largest entry of the residual r minus the motion, in free directions. */
static double largest_residual(const stick_slip_work *w, const double motion[2]) {
  double most = 0;
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double part[2];
    times(w->site[s].free, w->r[0][k] - motion[0], w->r[1][k] - motion[1], part);
    most = larger(most, larger(fabs(part[0]), fabs(part[1])));
  }
  return most;
}

double arc_stick_slip_residual(const stick_slip_problem *p, const stick_slip_work *w) {
  double most = 0;
  for (int k = 0; k < cells_of(p); k++) {
    double part[2];
    if (w->state[k] == SHEAR_NONE) continue;
    const stick_slip_site at = site_of(p, w, k);
    times(at.free, w->slip[0][k], w->slip[1][k], part);
    most = larger(most, larger(fabs(part[0]), fabs(part[1])));
  }
  return most;
}

int arc_stick_slip_newton(const stick_slip_problem *p, stick_slip_work *w, double share,
                          double least, stick_slip_count *count) {
  enum { most_steps = 400 };
  const size_t bytes = (size_t)cells_of(p) * sizeof(double);
  list_sites(p, w);
  const holding h = find_holding(p, w);
  double motion[2], product = 0;
  if (h.singular) return 0;
  for (int i = 0; i < 2; i++) memset(w->d[i], 0, bytes);
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double part[2];
    times(w->site[s].free, w->slip[0][k], w->slip[1][k], part);
    w->r[0][k] = part[0];
    w->r[1][k] = part[1];
  }
  hold_forces(p, w, &h, count);
  precondition(w, &h, motion);
  const double wanted = fmax(least, share * largest_residual(w, motion));
  for (int i = 0; i < 2; i++) memset(w->d[i], 0, bytes);
  for (int k = 0; k < most_steps && largest_residual(w, motion) > wanted; k++) {
    const double before = product;
    product = dot(w, w->r, w->z);
    const double keep = before > 0 ? product / before : 0;
    for (int i = 0; i < 2; i++)
      for (int s = 0; s < w->sites; s++) {
        const int c = w->site[s].cell;
        w->d[i][c] = w->z[i][c] + keep * w->d[i][c];
      }
    apply(p, w, count);
    const double curvature = dot(w, w->d, w->a);
    if (!(curvature > 0)) break;
    step(w, product / curvature);
    precondition(w, &h, motion);
    count->iterations++;
  }
  for (int i = 0; i < 2; i++) w->xi[i] -= motion[i];
  return 1;
}

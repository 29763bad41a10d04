/* Solves the linear problem of a Newton step for stick and slip by conjugate gradients,
 * preconditioned by Fourier transforms. A projection keeps the resultant forces constant. */
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
  if (w->state[k] == SHEAR_STICK) return (stick_slip_site){k, {1, 0, 1}, 0, 1};
  const double t[2] = {w->tangent[0][k], w->tangent[1][k]};
  const double xx = t[0] * t[0], xz = t[0] * t[1], zz = t[1] * t[1];
  const double alone = self[0] * xx + self[1] * zz;
  return (stick_slip_site){k, {xx, xz, zz}, w->diagonal[k], sqrt(alone / (alone + w->diagonal[k]))};
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

/* Projects v onto the free directions of the cells and multiplies by their shares. */
static void project(const stick_slip_work *w, double *const v[2], double *const result[2]) {
  for (int s = 0; s < w->sites; s++) {
    const stick_slip_site *at = &w->site[s];
    const int k = at->cell;
    double part[2];
    times(at->free, v[0][k], v[1][k], part);
    for (int i = 0; i < 2; i++) result[i][k] = at->share * part[i];
  }
}

/* Computes z = M^-1 v: the approximate inverse of the compliance to shear between two projections.
 * Cells that slip have a larger diagonal than this compliance, and therefore smaller shares. */
static void inverse_times(const stick_slip_problem *p, const stick_slip_work *w, double *const v[2],
                          double *const z[2]) {
  for (int i = 0; i < 2; i++) memset(z[i], 0, (size_t)cells_of(p) * sizeof(double));
  project(w, v, z);
  arc_cerruti_precondition(p->h, &w->box, z);
  project(w, z, z);
}

static void sums_over_sites(const stick_slip_work *w, double *const v[2], double sum[2]) {
  sum[0] = sum[1] = 0;
  for (int s = 0; s < w->sites; s++)
    for (int i = 0; i < 2; i++) sum[i] += v[i][w->site[s].cell];
}

/* Data of the projection that does not change the given forces. A 2 x 2 matrix maps a motion to the
 * sums over the cells of M^-1 times this motion; `inverse` is the inverse of this matrix. */
typedef struct holding {
  double inverse[2][2];
  int singular;
} holding;

/* Computes the preconditioned unit motions w->y along the axes with given forces. */
static void find_motions(const stick_slip_problem *p, stick_slip_work *w) {
  for (int i = 0; i < 2; i++) {
    if (!p->by_force[i]) continue;
    for (int k = 0; k < cells_of(p); k++) {
      w->d[i][k] = 1;
      w->d[1 - i][k] = 0;
    }
    inverse_times(p, w, w->d, w->y[i]);
  }
}

static holding find_holding(const stick_slip_problem *p, stick_slip_work *w) {
  static const double least = 1e-9;
  double g[2][2] = {{0, 0}, {0, 0}};
  find_motions(p, w);
  for (int i = 0; i < 2; i++)
    if (p->by_force[i]) sums_over_sites(w, w->y[i], g[i]);
  holding h = {{{0, 0}, {0, 0}}, 0};
  if (p->by_force[0] && p->by_force[1]) {
    const double det = g[0][0] * g[1][1] - g[0][1] * g[1][0], trace = g[0][0] + g[1][1];
    h.singular = !(det > least * trace * trace);
    if (h.singular) return h;
    h.inverse[0][0] = g[1][1] / det;
    h.inverse[1][1] = g[0][0] / det;
    h.inverse[0][1] = h.inverse[1][0] = -(g[0][1] + g[1][0]) / 2 / det;
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

/* Adds a motion, preconditioned, to a vector. The motion is 0 along axes without a given force. */
static void add_motion(const stick_slip_work *w, const double motion[2], double *const to[2]) {
  for (int i = 0; i < 2; i++)
    for (int s = 0; s < w->sites && motion[i] != 0; s++) {
      const int k = w->site[s].cell;
      for (int j = 0; j < 2; j++) to[j][k] += motion[i] * w->y[i][j][k];
    }
}

/* Computes z = M^-1 (r - motion) from the residual r of all cells. The motion is the same for all
 * cells. Along an axis with a given force its value is such that the sum of z over the cells is 0;
 * along other axes it is 0. */
static void precondition(const stick_slip_problem *p, const stick_slip_work *w, const holding *h,
                         double motion[2]) {
  double sum[2];
  inverse_times(p, w, w->r, w->z);
  sums_over_sites(w, w->z, sum);
  motion_of(h, sum, motion);
  add_motion(w, (const double[2]){-motion[0], -motion[1]}, w->z);
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
  for (int j = 0; j < 2; j++) memset(w->d[j], 0, (size_t)cells_of(p) * sizeof(double));
  add_motion(w, motion, w->d);
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
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double part[2];
    times(w->site[s].free, w->slip[0][k], w->slip[1][k], part);
    w->r[0][k] = part[0];
    w->r[1][k] = part[1];
  }
  hold_forces(p, w, &h, count);
  precondition(p, w, &h, motion);
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
    precondition(p, w, &h, motion);
    count->iterations++;
  }
  for (int i = 0; i < 2; i++) w->xi[i] -= motion[i];
  return 1;
}

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

/* Replaces v by M^-1 v, where M^-1 is the approximate inverse of the compliance to shear between
 * two projections. Cells that slip have a larger diagonal than this compliance, and therefore
 * smaller shares. v must be 0 at cells without shear. */
static void inverse_times(const stick_slip_problem *p, const stick_slip_work *w,
                          double *const v[2]) {
  project(w, v, v);
  arc_cerruti_precondition(p->h, &w->box, v);
  project(w, v, v);
}

static void sums_over_sites(const stick_slip_work *w, double *const v[2], double sum[2]) {
  sum[0] = sum[1] = 0;
  for (int s = 0; s < w->sites; s++)
    for (int i = 0; i < 2; i++) sum[i] += v[i][w->site[s].cell];
}

/* --- given forces ----------------------------------------------------------------------------- */

/* Computes M^-1 times unit motions along the axes with given forces, and the sums g of the results
 * over the cells. */
static void find_motions(const stick_slip_problem *p, stick_slip_work *w, double g[2][2]) {
  for (int i = 0; i < 2; i++) {
    double *const *v = w->shape[i];
    g[i][0] = g[i][1] = 0;
    for (int j = 0; j < 2; j++) memset(v[j], 0, (size_t)cells_of(p) * sizeof(double));
    if (!p->by_force[i]) continue;
    for (int s = 0; s < w->sites; s++) v[i][w->site[s].cell] = 1;
    inverse_times(p, w, v);
    sums_over_sites(w, v, g[i]);
  }
}

/* Inverts g along the axes with given forces. Returns 0 if it is singular. */
static int invert(const stick_slip_problem *p, double g[2][2], double inverse[2][2]) {
  static const double least = 1e-9;
  for (int i = 0; i < 2; i++)
    if (!p->by_force[i]) {
      g[i][i] = 1;
      g[i][1 - i] = g[1 - i][i] = 0;
    }
  const double det = g[0][0] * g[1][1] - g[0][1] * g[1][0];
  if (!(g[0][0] > 0 && g[1][1] > 0 && det > least * g[0][0] * g[1][1])) return 0;
  inverse[0][0] = g[1][1] / det;
  inverse[1][1] = g[0][0] / det;
  inverse[0][1] = inverse[1][0] = -(g[0][1] + g[1][0]) / 2 / det;
  return 1;
}

/* Computes w->shape: changes of the shear in the free directions. The sums of shape[i] over the
 * cells are 1 along axis i and 0 along the other axis. Returns 0 if there is no such change. */
static int find_shapes(const stick_slip_problem *p, stick_slip_work *w) {
  double g[2][2], inverse[2][2];
  find_motions(p, w, g);
  if (!invert(p, g, inverse)) return 0;
  for (int s = 0; s < w->sites; s++)
    for (int j = 0, k = w->site[s].cell; j < 2; j++) {
      const double a = w->shape[0][j][k], b = w->shape[1][j][k];
      w->shape[0][j][k] = inverse[0][0] * a + inverse[0][1] * b;
      w->shape[1][j][k] = inverse[1][0] * a + inverse[1][1] * b;
    }
  return 1;
}

static void add_shapes(const stick_slip_problem *p, const stick_slip_work *w, const double sum[2],
                       double *const to[2]) {
  for (int i = 0; i < 2; i++)
    for (int s = 0; s < w->sites && p->by_force[i]; s++)
      for (int j = 0, k = w->site[s].cell; j < 2; j++) to[j][k] += sum[i] * w->shape[i][j][k];
}

/* Computes the motion that is contained in a residual: its mean, weighted by the shapes. The motion
 * is 0 along axes without a given force. */
static void motion_in(const stick_slip_problem *p, const stick_slip_work *w, double *const r[2],
                      double motion[2]) {
  for (int i = 0; i < 2; i++) motion[i] = p->by_force[i] ? dot(w, w->shape[i], r) : 0;
}

int arc_stick_slip_set_forces(const stick_slip_problem *p, stick_slip_work *w) {
  const double area = p->h->def.size_x * p->h->def.size_z;
  double sum[2];
  list_sites(p, w);
  if (!find_shapes(p, w)) return 0;
  sums_over_sites(w, w->q, sum);
  add_shapes(p, w, (const double[2]){p->force[0] / area - sum[0], p->force[1] / area - sum[1]},
             w->q);
  return 1;
}

void arc_stick_slip_move(const stick_slip_problem *p, stick_slip_work *w) {
  double motion[2];
  motion_in(p, w, w->slip, motion);
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < cells_of(p); k++) w->slip[i][k] -= motion[i];
    w->xi[i] -= motion[i];
  }
}

/* --- conjugate gradients ---------------------------------------------------------------------- */

/* Computes the motion contained in the residual r. Returns the largest entry of r minus the motion,
 * in free directions. */
static double residual_of(const stick_slip_problem *p, const stick_slip_work *w, double motion[2]) {
  double most = 0;
  motion_in(p, w, w->r, motion);
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double part[2];
    times(w->site[s].free, w->r[0][k] - motion[0], w->r[1][k] - motion[1], part);
    most = larger(most, larger(fabs(part[0]), fabs(part[1])));
  }
  return most;
}

/* Computes z = P M^-1 (r - motion). P v is v minus shapes, so that the sums of P v along axes with
 * given forces are 0. */
static void precondition(const stick_slip_problem *p, const stick_slip_work *w,
                         const double motion[2]) {
  double sum[2];
  for (int i = 0; i < 2; i++) {
    memset(w->z[i], 0, (size_t)cells_of(p) * sizeof(double));
    for (int s = 0; s < w->sites; s++)
      w->z[i][w->site[s].cell] = w->r[i][w->site[s].cell] - motion[i];
  }
  inverse_times(p, w, w->z);
  sums_over_sites(w, w->z, sum);
  add_shapes(p, w, (const double[2]){-sum[0], -sum[1]}, w->z);
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

double arc_stick_slip_residual(const stick_slip_problem *p, stick_slip_work *w) {
  double most = 0;
  list_sites(p, w);
  for (int s = 0; s < w->sites; s++) {
    const int k = w->site[s].cell;
    double part[2];
    times(w->site[s].free, w->slip[0][k], w->slip[1][k], part);
    for (int i = 0; i < 2; i++) {
      w->r[i][k] = part[i];
      most = larger(most, fabs(part[i]));
    }
  }
  return most;
}

/* Makes one step of conjugate gradients. `product` is the product of r and z of the previous step,
 * 0 at the first step. Returns 0 at the limit of rounding. */
static int descend(const stick_slip_problem *p, stick_slip_work *w, double *product,
                   stick_slip_count *count) {
  const double before = *product;
  *product = dot(w, w->r, w->z);
  const double keep = before > 0 ? *product / before : 0;
  for (int i = 0; i < 2; i++)
    for (int s = 0; s < w->sites; s++) {
      const int c = w->site[s].cell;
      w->d[i][c] = w->z[i][c] + keep * w->d[i][c];
    }
  apply(p, w, count);
  const double curvature = dot(w, w->d, w->a);
  if (!(curvature > 0)) return 0;
  step(w, *product / curvature);
  count->iterations++;
  return 1;
}

void arc_stick_slip_newton(const stick_slip_problem *p, stick_slip_work *w, double share,
                           double least, stick_slip_count *count) {
  enum { most_steps = 400 };
  double motion[2], product = 0, left = residual_of(p, w, motion);
  const double wanted = fmax(least, share * left);
  for (int i = 0; i < 2; i++) memset(w->d[i], 0, (size_t)cells_of(p) * sizeof(double));
  for (int k = 0; k < most_steps && left > wanted; k++) {
    precondition(p, w, motion);
    if (!descend(p, w, &product, count)) break;
    left = residual_of(p, w, motion);
  }
  for (int i = 0; i < 2; i++) w->xi[i] -= motion[i];
}

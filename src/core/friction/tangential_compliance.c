/* Computes the tangential part of the contact matrix, and displacements of both surfaces. Cylinder
 * nodes use the tangent of the opposite plate surface, perpendicular to the normals of mortar.c. */
#include "core/base/dense.h"
#include "core/base/wide.h"
#include "core/friction/friction.h"

#include <stdlib.h>
#include <string.h>

arc_status arc_tangential_create(tangential_compliance *g, const arc_model *model) {
  const size_t nc = (size_t)arc_model_mesh(model, ARC_CYLINDER)->surface;
  *g = (tangential_compliance){.nc = (int)nc, .np = arc_model_mesh(model, ARC_PLATE)->surface};
  g->nt = malloc(3 * nc * nc * sizeof(double));
  if (!g->nt) return ARC_MEMORY;
  g->tn = g->nt + nc * nc;
  g->tt = g->tn + nc * nc;
  return ARC_OK;
}

void arc_tangential_free(tangential_compliance *g) {
  free(g->nt);
  *g = (tangential_compliance){0};
}

size_t arc_tangential_bytes(const tangential_compliance *g) {
  return sizeof *g + 3 * (size_t)g->nc * (size_t)g->nc * sizeof(double);
}

/* --- matrices --------------------------------------------------------------------------------- */

/* Adds `weight` times the response to a unit shear force at node `at` of a body: gaps n and
 * tangential displacements t of the nodes first .. first + count - 1. Does not correct the
 * tangential compliance xx. */
ARC_WIDE static void respond_wide(const compliance *c, const double *slopes, int first, int count,
                                  int at, double weight, double *restrict n, double *restrict t) {
  const size_t from = dense_at(first, at, c->n);
  const double *xx = &c->xx[from], *xy = &c->xy[from], *yx = &c->yx[from], *yy = &c->yy[from];
  const double *slope = &slopes[first], m = slopes[at];
#pragma omp simd
  for (int l = 0; l < count; l++) {
    const double ux = xx[l] + m * xy[l], uy = yx[l] + m * yy[l];
    n[l] += weight * (uy - slope[l] * ux);
    t[l] += weight * (ux + slope[l] * uy);
  }
}

/* Returns the correction of the tangential compliance xx: the displacement of node l along the
 * surface under a unit shear force at node `at`, minus the displacement computed with xx. */
static double beyond_xx(const compliance *c, int l, int at) {
  return compliance_shear(c, l, at) - c->xx[dense_at(l, at, c->n)];
}

/* Adds the same response as respond_wide and, if `corrected` is true, the correction of the
 * tangential compliance xx for nodes near `at`. */
static void respond(const compliance *c, int corrected, const double *slopes, int first, int count,
                    int at, double weight, double *n, double *t) {
  respond_wide(c, slopes, first, count, at, weight, n, t);
  if (!corrected) return;
  for (int l = at - ARC_SHEAR_REACH; l <= at + ARC_SHEAR_REACH; l++) {
    if (l < first || l >= first + count) continue;
    const double ux = weight * beyond_xx(c, l, at);
    n[l - first] -= slopes[l] * ux;
    t[l - first] += ux;
  }
}

/* Computes the gaps ([0]) and the tangential displacements ([1]) due to a unit shear force at
 * candidate k: of the plate, by plate node, and of the cylinder, by candidate. */
static void pull_at(const contact_problem *p, int k, double *const plate[2],
                    double *const cylinder[2]) {
  const compliance *c = shape_compliance(&p->shape->side[ARC_PLATE]);
  const int corrected = shape_is_corrected(p->shape);
  memset(plate[0], 0, 2 * (size_t)(p->np + p->nc) * sizeof *plate[0]);
  for (int q = 0; q < p->width; q++) {
    const double weight = p->b[k * p->width + q];
    if (weight != 0)
      respond(c, corrected, c->slope, 0, p->np, p->first[k] + q, weight, plate[0], plate[1]);
  }
  respond(shape_compliance(&p->shape->side[ARC_CYLINDER]), corrected, p->slope, p->lo, p->count,
          p->lo + k, 1, cylinder[0], cylinder[1]);
}

static void fill_column(tangential_compliance *g, const contact_problem *p, int k, double *work) {
  double *plate[2] = {work, work + p->np}, *cylinder[2] = {plate[1] + p->np, NULL};
  cylinder[1] = cylinder[0] + p->nc;
  pull_at(p, k, plate, cylinder);
  for (int r = 0; r < p->count; r++) {
    const double *row = &p->b[r * p->width];
    double n = cylinder[0][r], t = cylinder[1][r];
    for (int q = 0; q < p->width; q++) {
      n += row[q] * plate[0][p->first[r] + q];
      t += row[q] * plate[1][p->first[r] + q];
    }
    g->nt[dense_at(r, k, p->count)] = g->tn[dense_at(k, r, p->count)] = n;
    if (r >= k) g->tt[dense_at(r, k, p->count)] = g->tt[dense_at(k, r, p->count)] = t;
  }
}

void arc_tangential_update(tangential_compliance *g, const contact_problem *p, double *work) {
  if (g->version == p->version && g->x == p->x) return;
  const compliance *plate = shape_compliance(&p->shape->side[ARC_PLATE]);
  g->count = p->count;
  for (int k = 0; k < p->count; k++) fill_column(g, p, k, work);
  g->flat = 1;
  for (int l = 0; l < p->np; l++) g->flat = g->flat && plate->slope[l] == 0;
  g->version = p->version;
  g->x = p->x;
}

/* Adds the product of matrix a [n x n] and vector x to y in rows from .. to - 1. Zeros at both ends
 * of x are skipped. */
static void add_middle(int n, int from, int to, const double *a, const double *x, double *y) {
  int first = 0, last = n;
  while (first < last && x[first] == 0) first++;
  while (last > first && x[last - 1] == 0) last--;
  arc_dense_add_columns(from, to, last - first, NULL, &a[dense_at(0, first, n)], n, &x[first], y);
}

void arc_tangential_gaps(const tangential_compliance *g, const double *t, double *result) {
  memset(result, 0, (size_t)g->count * sizeof *result);
  add_middle(g->count, 0, g->count, g->nt, t, result);
}

void arc_tangential_drag(const tangential_compliance *g, const double *f, int first, int last,
                         double *r) {
  memset(&r[first], 0, (size_t)(last - first) * sizeof *r);
  add_middle(g->count, first, last, g->tn, f, r);
}

void arc_tangential_drag_all(const tangential_compliance *g, const double *f, const double *t,
                             double *r) {
  arc_tangential_drag(g, f, 0, g->count, r);
  add_middle(g->count, 0, g->count, g->tt, t, r);
}

/* --- displacements ---------------------------------------------------------------------------- */

void arc_tangential_relative(const contact_problem *p, double *const u[ARC_BODIES], double *work,
                             double *r) {
  const double *slope = shape_compliance(&p->shape->side[ARC_PLATE])->slope;
  for (int l = 0; l < p->np; l++) work[l] = u[ARC_PLATE][l] + slope[l] * u[ARC_PLATE][p->np + l];
  for (int k = 0; k < p->count; k++) {
    const int i = p->lo + k;
    const double *row = &p->b[k * p->width], *from = &work[p->first[k]];
    double sum = u[ARC_CYLINDER][i] + p->slope[i] * u[ARC_CYLINDER][p->nc + i];
    for (int q = 0; q < p->width; q++) sum -= row[q] * from[q];
    r[k] = sum;
  }
}

/* Adds the correction of the tangential compliance xx to the displacements u of the nodes near k,
 * for a shear force at node k. */
static void add_beyond_xx(const compliance *c, int k, double shear, double *u) {
  for (int l = k - ARC_SHEAR_REACH; l <= k + ARC_SHEAR_REACH && shear != 0; l++)
    if (l >= 0 && l < c->n) u[l] += beyond_xx(c, l, k) * shear;
}

/* Computes the displacements u of the n nodes of a surface, first all along x, then all along y,
 * under the nodal forces f along the normals and t along the tangents. `slope` contains the slopes
 * of the surface at the nodes. If `flat` is true, only displacements along x are computed. If
 * `corrected` is true, they include the correction of the tangential compliance. `force` [2 n] is a
 * workspace. */
static void displace(const compliance *c, int corrected, const double *slope, int flat,
                     const double *f, const double *t, double *force, double *u) {
  double *fx = force, *fy = force + c->n;
  for (int k = 0; k < c->n; k++) {
    fx[k] = t[k] - slope[k] * f[k];
    fy[k] = f[k] + slope[k] * t[k];
  }
  memset(u, 0, 2 * (size_t)c->n * sizeof *u);
  add_middle(c->n, 0, c->n, c->xx, fx, u);
  add_middle(c->n, 0, c->n, c->xy, fy, u);
  for (int k = 0; k < c->n && corrected; k++) add_beyond_xx(c, k, fx[k], u);
  if (flat) return;
  add_middle(c->n, 0, c->n, c->yx, fx, u + c->n);
  add_middle(c->n, 0, c->n, c->yy, fy, u + c->n);
}

void arc_tangential_displace(const contact_problem *p, int flat, const double *f, const double *t,
                             double *const u[ARC_BODIES], double *work) {
  const compliance *cylinder = shape_compliance(&p->shape->side[ARC_CYLINDER]);
  const compliance *plate = shape_compliance(&p->shape->side[ARC_PLATE]);
  double *fp = work, *tp = work + p->np, *force = tp + p->np;
  displace(cylinder, shape_is_corrected(p->shape), p->slope, flat, f, t, force, u[ARC_CYLINDER]);
  arc_contact_problem_to_plate(p, f, fp);
  arc_contact_problem_to_plate(p, t, tp);
  for (int l = 0; l < p->np; l++) {
    fp[l] = -fp[l];
    tp[l] = -tp[l];
  }
  displace(plate, shape_is_corrected(p->shape), plate->slope, flat, fp, tp, force, u[ARC_PLATE]);
}

/* The tangential part of a pose's contact matrix, and displacements of both surfaces. Tangents go
 * with the normals of mortar.c: the plate's own at its nodes, the one it shows the cylinder there.
 */
#include "core/base/dense.h"
#include "core/contact/friction.h"

#include <stdlib.h>
#include <string.h>

arc_status arc_grip_create(grip *g, const arc_model *model) {
  const size_t nc = (size_t)arc_model_mesh(model, ARC_CYLINDER)->surface;
  *g = (grip){.nc = (int)nc, .np = arc_model_mesh(model, ARC_PLATE)->surface};
  g->nt = malloc(3 * nc * nc * sizeof(double));
  if (!g->nt) return ARC_MEMORY;
  g->tn = g->nt + nc * nc;
  g->tt = g->tn + nc * nc;
  return ARC_OK;
}

void arc_grip_free(grip *g) {
  free(g->nt);
  *g = (grip){0};
}

size_t arc_grip_bytes(const grip *g) {
  return sizeof *g + 3 * (size_t)g->nc * (size_t)g->nc * sizeof(double);
}

/* --- matrices --------------------------------------------------------------------------------- */

/* Response of a body between nodes r and c: the gap (n) and the tangential displacement (t) at r,
 * slope mr, under a unit of shear at c, slope mc. */
static void response(const compliance *c, size_t at, double mr, double mc, double *n, double *t) {
  const double ux = c->xx[at] + mc * c->xy[at], uy = c->yx[at] + mc * c->yy[at];
  *n += uy - mr * ux;
  *t += ux + mr * uy;
}

/* Adds what shear at candidate k does to the plate's surface, by plate node. */
static void pull_plate(const pose *p, const compliance *c, int k, double *n, double *t) {
  for (int q = 0; q < p->width; q++) {
    const double weight = p->b[k * p->width + q];
    const int from = p->first[k] + q;
    if (weight == 0) continue;
    for (int l = 0; l < p->np; l++) {
      double un = 0, ut = 0;
      response(c, dense_at(l, from, c->n), c->slope[l], c->slope[from], &un, &ut);
      n[l] += weight * un;
      t[l] += weight * ut;
    }
  }
}

static void fill_column(grip *g, const pose *p, int k, double *work) {
  const compliance *cylinder = shape_compliance(&p->shape->side[ARC_CYLINDER]);
  const compliance *plate = shape_compliance(&p->shape->side[ARC_PLATE]);
  double *n = work, *t = work + p->np;
  memset(n, 0, 2 * (size_t)p->np * sizeof *n);
  pull_plate(p, plate, k, n, t);
  for (int r = 0; r < p->count; r++) {
    const double *row = &p->b[r * p->width];
    double un = 0, ut = 0;
    response(cylinder, dense_at(p->lo + r, p->lo + k, cylinder->n), p->slope[p->lo + r],
             p->slope[p->lo + k], &un, &ut);
    for (int q = 0; q < p->width; q++) {
      un += row[q] * n[p->first[r] + q];
      ut += row[q] * t[p->first[r] + q];
    }
    g->nt[dense_at(r, k, p->count)] = g->tn[dense_at(k, r, p->count)] = un;
    if (r >= k) g->tt[dense_at(r, k, p->count)] = g->tt[dense_at(k, r, p->count)] = ut;
  }
}

void arc_grip_update(grip *g, const pose *p, double *work) {
  if (g->version == p->version && g->x == p->x) return;
  const compliance *plate = shape_compliance(&p->shape->side[ARC_PLATE]);
  g->count = p->count;
  for (int k = 0; k < p->count; k++) fill_column(g, p, k, work);
  g->flat = 1;
  for (int l = 0; l < p->np; l++) g->flat = g->flat && plate->slope[l] == 0;
  g->version = p->version;
  g->x = p->x;
}

/* y += a x [n x n], where x is zero but in the middle. */
static void add_middle(int n, const double *a, const double *x, double *y) {
  int first = 0, last = n;
  while (first < last && x[first] == 0) first++;
  while (last > first && x[last - 1] == 0) last--;
  arc_dense_add_columns(0, n, last - first, NULL, &a[dense_at(0, first, n)], n, &x[first], y);
}

void arc_grip_gaps(const grip *g, const double *t, double *result) {
  memset(result, 0, (size_t)g->count * sizeof *result);
  add_middle(g->count, g->nt, t, result);
}

void arc_grip_drag(const grip *g, const double *f, const double *t, double *r) {
  memset(r, 0, (size_t)g->count * sizeof *r);
  add_middle(g->count, g->tn, f, r);
  if (t) add_middle(g->count, g->tt, t, r);
}

/* --- displacements ---------------------------------------------------------------------------- */

void arc_grip_relative(const pose *p, double *const u[ARC_BODIES], double *work, double *r) {
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

/* u [2 n] under forces along normals (f) and tangents (t) with slopes; on flat surfaces only along
 * x, as nothing else is asked. force [2 n] is room. */
static void displace(const compliance *c, const double *slope, int flat, const double *f,
                     const double *t, double *force, double *u) {
  double *fx = force, *fy = force + c->n;
  for (int k = 0; k < c->n; k++) {
    fx[k] = t[k] - slope[k] * f[k];
    fy[k] = f[k] + slope[k] * t[k];
  }
  memset(u, 0, 2 * (size_t)c->n * sizeof *u);
  add_middle(c->n, c->xx, fx, u);
  add_middle(c->n, c->xy, fy, u);
  if (flat) return;
  add_middle(c->n, c->yx, fx, u + c->n);
  add_middle(c->n, c->yy, fy, u + c->n);
}

void arc_grip_displace(const pose *p, int flat, const double *f, const double *t,
                       double *const u[ARC_BODIES], double *work) {
  const compliance *cylinder = shape_compliance(&p->shape->side[ARC_CYLINDER]);
  const compliance *plate = shape_compliance(&p->shape->side[ARC_PLATE]);
  double *fp = work, *tp = work + p->np, *force = tp + p->np;
  displace(cylinder, p->slope, flat, f, t, force, u[ARC_CYLINDER]);
  arc_pose_to_plate(p, f, fp);
  arc_pose_to_plate(p, t, tp);
  for (int l = 0; l < p->np; l++) {
    fp[l] = -fp[l];
    tp[l] = -tp[l];
  }
  displace(plate, plate->slope, flat, fp, tp, force, u[ARC_PLATE]);
}

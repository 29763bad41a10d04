/* The wear of a cycle as a linear map of both surfaces' depths, from the active sets of its contact
 * solutions. */
#include "core/base/dense.h"
#include "core/wear/rate.h"

#include <stdlib.h>

/* What one pose contributes. With C = A^-1 - A^-1 1 1' A^-1 / (1' A^-1 1) on the active set (m
 * nodes) and B's rows there (plate nodes first .. first + span - 1), deeper surfaces h change the
 * forces by -C (h_c + B h_p). */
typedef struct influence {
  int m, first, span;
  double *c;   /* [m x m] C */
  double *b;   /* [m x span] B on the set */
  double *cb;  /* [m x span] C B */
  double *bcb; /* [span x span] B' C B */
} influence;

static arc_status influence_create(const pose *p, influence *f) {
  f->m = p->active;
  f->first = p->first[p->set[0]];
  f->span = 0;
  for (int s = 0; s < f->m; s++) {
    const int end = p->first[p->set[s]] + p->width - f->first;
    if (end > f->span) f->span = end;
  }
  if (f->first + f->span > p->np) f->span = p->np - f->first;
  const size_t m = (size_t)f->m, span = (size_t)f->span;
  f->c = calloc(m * m + 2 * m * span + span * span, sizeof(double));
  if (!f->c) return ARC_MEMORY;
  f->b = f->c + m * m;
  f->cb = f->b + m * span;
  f->bcb = f->cb + m * span;
  return ARC_OK;
}

static void fill_influence(const pose *p, influence *f) {
  const int m = f->m, span = f->span;
  double total = 0;
  for (int s = 0; s < m; s++) {
    f->c[dense_at(s, s, m)] = 1;
    total += p->ones[s];
    const int k = p->set[s];
    for (int q = 0; q < p->width && p->first[k] + q < p->np; q++)
      f->b[dense_at(s, p->first[k] + q - f->first, m)] = p->b[k * p->width + q];
  }
  arc_dense_cholesky_solve(m, m, p->factor, m, f->c, m);
  for (int j = 0; j < m; j++)
    for (int i = 0; i < m; i++) f->c[dense_at(i, j, m)] -= p->ones[i] * p->ones[j] / total;
  arc_dense_multiply(m, span, m, 1, f->c, m, f->b, m, 0, f->cb, m);
  arc_dense_multiply_transposed(span, span, m, 1, f->b, m, f->cb, m, 0, f->bcb, span);
}

/* share * dq/dp / width at a node: from a change of force to one of wear. */
static double row_scale(const arc_wear *w, const pose *p, const wear_point *point, arc_body b,
                        int node, double share) {
  const double width = b == ARC_CYLINDER ? p->wc[node] : p->wp[node];
  return share * arc_wear_law_slope(w, point->p[b][node], point->q[b][node]) / width;
}

static double column_scale(const double *const down[ARC_BODIES], arc_body b, int node) {
  return down ? down[b][node] : 1;
}

arc_status arc_wear_add_jacobian(const arc_wear *w, const pose *p, const wear_point *point,
                                 double share, const double *const down[ARC_BODIES],
                                 double *jacobian) {
  influence f;
  if (influence_create(p, &f) != ARC_OK) return ARC_MEMORY;
  fill_influence(p, &f);
  const int n = p->nc + p->np;
  for (int s = 0; s < f.m; s++) {
    const int node = p->lo + p->set[s];
    const double row = row_scale(w, p, point, ARC_CYLINDER, node, share);
    const double column = column_scale(down, ARC_CYLINDER, node);
    for (int t = 0; t < f.m; t++) {
      const int other = p->lo + p->set[t];
      jacobian[dense_at(node, other, n)] +=
          row * f.c[dense_at(s, t, f.m)] * column_scale(down, ARC_CYLINDER, other);
    }
    for (int t = 0; t < f.span; t++) {
      const int l = f.first + t;
      const double cb = f.cb[dense_at(s, t, f.m)];
      jacobian[dense_at(node, p->nc + l, n)] += row * cb * column_scale(down, ARC_PLATE, l);
      jacobian[dense_at(p->nc + l, node, n)] +=
          row_scale(w, p, point, ARC_PLATE, l, share) * cb * column;
    }
  }
  for (int s = 0; s < f.span; s++) {
    const double row = row_scale(w, p, point, ARC_PLATE, f.first + s, share);
    for (int t = 0; t < f.span; t++)
      jacobian[dense_at(p->nc + f.first + s, p->nc + f.first + t, n)] +=
          row * f.bcb[dense_at(s, t, f.span)] * column_scale(down, ARC_PLATE, f.first + t);
  }
  free(f.c);
  return ARC_OK;
}

/* Computes the compliance of a worn shape by a dense update of the stiffness
 *
 *   S = S_far + K_box(current nodes),
 *
 * where K_box = [K_ii K_ir; K_ri K_rr] is the stiffness of the wear box (i: inner, r: rim
 * unknowns). The compliance F consists of the blocks of S^-1 that belong to the surface. The
 * matrix E, with inner rows E_i and rim rows E_r, selects the surface unknowns, x and y of each
 * node in turn. With
 *
 *   X = K_ii^-1 K_ir,  Z = K_ii^-1 E_i,  T = K_rr + S_far - K_ri X = L L',  W = E_r - X' E_i,
 *
 * the results are
 *
 *   u_rim = T^-1 W f,  u_inner = K_ii^-1 (E_i f - K_ir u_rim),  F = E_i' Z + V' V,  V = L^-1 W.
 *
 * K_ii is a narrow band matrix, so most of the cost is in the factor of T, in V and in V' V.
 * Distant rim nodes have no influence on the surface; on wide boxes the columns of W and V
 * therefore begin with zeros. */
#include "core/elastic/condense.h"
#include "core/base/dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  together = ARC_DENSE_BAND_SIDES, /* number of right-hand sides of K_ii that are solved together */
  panel =
      64 /* number of columns of W that are processed together: two for each of 32 surface nodes */
};

typedef struct condensation {
  int ni, nr, ns;     /* numbers of inner unknowns, rim unknowns and surface nodes */
  double even;        /* uniform wear [mm] */
  double *band;       /* factor of the band matrix K_ii */
  double *side;       /* right-hand sides of K_ii; zero between calls */
  double *t;          /* lower triangle of the factor of T */
  double *w;          /* matrix W, one row per rim unknown and one column per surface unknown */
  int *first;         /* first nonzero row of each column of W */
  double *f;          /* lower triangle of E_i' Z, and later of F */
  sparse_entries rim; /* matrix K_ri */
} condensation;

static void condensation_free(condensation *c) {
  free(c->band);
  free(c->side);
  free(c->t);
  free(c->w);
  free(c->first);
  free(c->f);
  arc_sparse_free(&c->rim);
}

static arc_status condensation_create(const elastic_body *b, condensation *c) {
  *c = (condensation){.ni = 2 * b->inner, .nr = 2 * b->rim, .ns = b->mesh->surface};
  const size_t ni = (size_t)c->ni, nr = (size_t)c->nr, n = 2 * (size_t)c->ns;
  c->band = calloc((size_t)(b->band + 1) * ni, sizeof(double));
  c->side = calloc(ni * together, sizeof(double));
  c->t = malloc(nr * nr * sizeof(double));
  c->w = calloc(nr * n, sizeof(double));
  c->first = malloc(n * sizeof(int));
  c->f = calloc(n * n, sizeof(double));
  if (c->band && c->side && c->t && c->w && c->first && c->f) return ARC_OK;
  condensation_free(c);
  return ARC_MEMORY;
}

/* Returns the depth of a wear-box node below the unworn surface [mm]. */
static double depth_of(const elastic_body *b, const double *box_at, int k) {
  const double up = b->mesh->body == ARC_UPPER ? 1 : -1;
  return up * (box_at[2 * k + 1] - arc_body_top(b, k / (b->mesh->rows + 1))[1]);
}

/* Returns the elasticity of a wear-box element between two depths [mm]: the mean over the layers
 * inside the element, which act in series across the element and in parallel along it. With the
 * thickness fractions s of the layers and their constants c, the constants of the element are
 *
 *   1/c22 = sum s/c22   1/c33 = sum s/c33   c12 = c22 sum s c12/c22
 *   c11 = sum s (c11 - c12 c12/c22) + c12 c12/c22 */
static elasticity mix_layers(const elastic_body *b, double from, double to) {
  const int layers = arc_body_layers(&b->mesh->solid);
  double yields = 0, shears = 0, widens = 0, along = 0;
  for (int l = 0; l <= layers; l++) {
    const double top = l > 0 ? arc_body_interface(&b->mesh->solid, l - 1) : -INFINITY;
    const double end = l < layers ? arc_body_interface(&b->mesh->solid, l) : INFINITY;
    const double share = fmax(0, fmin(to, end) - fmax(from, top)) / (to - from);
    const elasticity *d = &b->layer[l];
    yields += share / d->c22;
    shears += share / d->c33;
    widens += share * d->c12 / d->c22;
    along += share * (d->c11 - d->c12 * d->c12 / d->c22);
  }
  return (elasticity){.c11 = along + widens * widens / yields,
                      .c12 = widens / yields,
                      .c33 = 1 / shears,
                      .c22 = 1 / yields,
                      .nu = b->d.nu};
}

/* Returns the elasticity of a wear-box element. The surface moves through the fixed layers; a
 * uniform wear `even` [mm] shifts the layers toward the surface. */
static elasticity box_elasticity(const elastic_body *b, const double *box_at, double even,
                                 const int corner[4]) {
  const int rows = b->mesh->rows + 1;
  double from = even, to = even;
  int least = corner[0] % rows;
  if (arc_body_layers(&b->mesh->solid) == 0) return b->d;
  for (int a = 1; a < 4; a++) least = corner[a] % rows < least ? corner[a] % rows : least;
  for (int a = 0; a < 4; a++) {
    const double depth = depth_of(b, box_at, corner[a]) / 2;
    if (corner[a] % rows == least)
      from += depth;
    else
      to += depth;
  }
  return mix_layers(b, from, to);
}

/* Adds the stiffness of one wear-box element. box_xy contains the positions of the box nodes in
 * space, box_at their positions in the chart. */
static arc_status add_box_element(const elastic_body *b, int e, const double *box_xy,
                                  const double *box_at, condensation *c) {
  int corner[4], inner[8], rim[8];
  for (int a = 0; a < 4; a++) corner[a] = b->node_box[b->mesh->element[4 * e + a]];
  const element el = arc_body_element(b, box_xy, corner);
  double k[64];
  arc_element_stiffness(&el, box_elasticity(b, box_at, c->even, corner), k);
  for (int r = 0; r < 8; r++) {
    const int at = corner[r / 2];
    inner[r] = b->box_inner[at] < 0 ? -1 : 2 * b->box_inner[at] + r % 2;
    rim[r] = b->box_rim[at] < 0 ? -1 : 2 * b->box_rim[at] + r % 2;
  }
  arc_status status = ARC_OK;
  for (int r = 0; r < 8; r++)
    for (int q = 0; q < 8 && status == ARC_OK; q++) {
      const double value = k[8 * r + q];
      if (inner[r] >= 0 && inner[q] >= 0) {
        if (inner[r] >= inner[q])
          c->band[(inner[r] - inner[q]) + inner[q] * (b->band + 1)] += value;
      } else if (rim[r] >= 0 && rim[q] >= 0) {
        c->t[dense_at(rim[r], rim[q], c->nr)] += value;
      } else if (rim[r] >= 0) {
        status = arc_sparse_add(&c->rim, rim[r], inner[q], value);
      }
    }
  return status;
}

/* Returns the index of surface unknown j among the inner unknowns, or -1 if it is a rim unknown. */
static int inner_unknown(const elastic_body *b, int j) {
  const int at = b->box_inner[j / 2 * (b->mesh->rows + 1)];
  return at < 0 ? -1 : 2 * at + j % 2;
}

/* Returns the index of surface unknown j among the rim unknowns, or -1 if it is an inner
 * unknown. */
static int rim_unknown(const elastic_body *b, int j) {
  const int at = b->box_rim[j / 2 * (b->mesh->rows + 1)];
  return at < 0 ? -1 : 2 * at + j % 2;
}

/* Range of rows, from `from` to `to` - 1, in which the right-hand sides of K_ii are not zero. */
typedef struct reach {
  int from, to;
} reach;

static void note(reach *r, int row) {
  if (row < r->from) r->from = row;
  if (row >= r->to) r->to = row + 1;
}

static int holds(const reach *r, int row) {
  return r->from <= row && row < r->to;
}

static void solve_sides(const elastic_body *b, condensation *c, reach *r) {
  if (r->from < r->to) arc_dense_band_solve(c->ni, b->band, c->band, c->side, &r->from, &r->to);
}

static void clear_sides(condensation *c, const reach *r) {
  if (r->from < r->to)
    memset(&c->side[together * r->from], 0,
           (size_t)(together * (r->to - r->from)) * sizeof(double));
}

/* Subtracts the multiple `times` of x from `to`, for the first n right-hand sides. Up to `together`
 * right-hand sides are solved at once. */
static void subtract(int n, double times, const double *x, double *to) {
  for (int k = 0; k < together && k < n; k++) to[k] -= times * x[k];
}

/* Computes the columns q .. q + together - 1 of X. Subtracts K_ri X from T, row by row below the
 * diagonal, and subtracts X' E_i from W. */
static void reduce_rim(const elastic_body *b, condensation *c, int q) {
  reach r = {c->ni, 0};
  for (size_t k = 0; k < c->rim.count; k++) {
    if (c->rim.row[k] < q || c->rim.row[k] >= q + together) continue;
    c->side[together * c->rim.column[k] + c->rim.row[k] - q] += c->rim.value[k];
    note(&r, c->rim.column[k]);
  }
  solve_sides(b, c, &r);
  for (size_t k = 0; k < c->rim.count; k++)
    if (c->rim.row[k] < q + together && holds(&r, c->rim.column[k]))
      subtract(c->nr - q, c->rim.value[k], &c->side[together * c->rim.column[k]],
               &c->t[dense_at(q, c->rim.row[k], c->nr)]);
  for (int j = 0; j < 2 * c->ns; j++) {
    const int at = inner_unknown(b, j);
    if (at < 0 || !holds(&r, at)) continue;
    subtract(c->nr - q, 1, &c->side[together * at], &c->w[dense_at(q, j, c->nr)]);
    if (q < c->first[j]) c->first[j] = q;
  }
  clear_sides(c, &r);
}

/* Adds E_r to W, for the surface unknowns that are rim unknowns. */
static void fill_rim_of_w(const elastic_body *b, condensation *c) {
  for (int j = 0; j < 2 * c->ns; j++) {
    c->first[j] = rim_unknown(b, j) < 0 ? c->nr : rim_unknown(b, j);
    if (rim_unknown(b, j) >= 0) c->w[dense_at(rim_unknown(b, j), j, c->nr)] = 1;
  }
}

static arc_status factorise(const elastic_body *b, condensation *c, arc_error *error) {
  int bad = arc_dense_band_cholesky(c->ni, b->band, c->band);
  if (!bad) {
    fill_rim_of_w(b, c);
    for (int q = 0; q < c->nr; q += together) reduce_rim(b, c, q);
    bad = arc_dense_cholesky(c->nr, c->t, c->nr);
  }
  if (!bad) return ARC_OK;
  return arc_fail(error, ARC_NUMERIC, "the %s's wear box is not positive definite at row %d",
                  arc_body_name(b->mesh->body), bad);
}

static arc_status condense_in_space(const elastic_body *b, const double *box_xy,
                                    const double *box_at, double even, condensation *c,
                                    arc_error *error) {
  const char *name = arc_body_name(b->mesh->body);
  if (condensation_create(b, c) != ARC_OK)
    return arc_fail(error, ARC_MEMORY, "out of memory for the %s's wear box", name);
  c->even = even;
  memcpy(c->t, b->s_far, (size_t)c->nr * (size_t)c->nr * sizeof(double));
  arc_status status = ARC_OK;
  for (int e = 0; e < b->mesh->box_elements && status == ARC_OK; e++)
    status = add_box_element(b, e, box_xy, box_at, c);
  if (status != ARC_OK)
    arc_fail(error, status, "out of memory for the %s's wear box", name);
  else
    status = factorise(b, c, error);
  if (status != ARC_OK) condensation_free(c);
  return status;
}

static arc_status condense(const elastic_body *b, const double *box_at, double even,
                           condensation *c, arc_error *error) {
  if (!b->chart.polar) return condense_in_space(b, box_at, box_at, even, c, error);
  double *box_xy = malloc(2 * (size_t)b->box_count * sizeof *box_xy);
  if (!box_xy)
    return arc_fail(error, ARC_MEMORY, "out of memory for the %s's wear box",
                    arc_body_name(b->mesh->body));
  arc_chart_to_space(&b->chart, b->box_count, box_at, box_xy);
  const arc_status status = condense_in_space(b, box_xy, box_at, even, c, error);
  free(box_xy);
  return status;
}

/* Computes the columns q .. q + together - 1 of E_i' Z, and adds their transposes to rows of the
 * lower triangle of F. */
static void add_z(const elastic_body *b, condensation *c, int q) {
  const int n = 2 * c->ns;
  reach r = {c->ni, 0};
  for (int j = q; j < q + together && j < n; j++) {
    const int at = inner_unknown(b, j);
    if (at < 0) continue;
    c->side[together * at + j - q] = 1;
    note(&r, at);
  }
  solve_sides(b, c, &r);
  for (int j = 0; j < q + together && j < n; j++) {
    const int at = inner_unknown(b, j);
    if (at >= 0 && holds(&r, at))
      subtract(n - q, -1, &c->side[together * at], &c->f[dense_at(q, j, n)]);
  }
  clear_sides(c, &r);
}

/* Returns the first nonzero row of the `count` columns of W from column j on. */
static int first_of_panel(const condensation *c, int j, int count) {
  int first = c->nr;
  for (int k = j; k < j + count; k++)
    if (c->first[k] < first) first = c->first[k];
  return first;
}

/* Replaces the panel of W from column j on by V = L^-1 W. Adds the products V' V of this panel
 * with itself and with the previous panels to F. */
static void add_panel(condensation *c, int j) {
  const int n = 2 * c->ns, count = n - j < panel ? n - j : panel;
  const int start = first_of_panel(c, j, count);
  arc_dense_forward(c->nr - start, count, &c->t[dense_at(start, start, c->nr)], c->nr,
                    &c->w[dense_at(start, j, c->nr)], c->nr);
  for (int i = 0; i < j; i += panel) {
    const int before = first_of_panel(c, i, panel), first = start > before ? start : before;
    arc_dense_multiply_transposed(count, panel, c->nr - first, 1, &c->w[dense_at(first, j, c->nr)],
                                  c->nr, &c->w[dense_at(first, i, c->nr)], c->nr, 1,
                                  &c->f[dense_at(j, i, n)], n);
  }
  arc_dense_add_square(count, c->nr - start, &c->w[dense_at(start, j, c->nr)], c->nr,
                       &c->f[dense_at(j, j, n)], n);
}

/* Copies F, which has x and y of each node in turn, to the four matrices of the compliance. */
static void split(const condensation *c, compliance *result) {
  const int n = c->ns;
  for (int q = 0; q < n; q++)
    for (int s = q; s < n; s++) {
      const double *x = &c->f[dense_at(2 * s, 2 * q, 2 * n)], *y = x + 2 * n;
      const size_t below = dense_at(s, q, n), above = dense_at(q, s, n);
      result->xx[below] = result->xx[above] = x[0];
      result->yy[below] = result->yy[above] = y[1];
      result->yx[below] = result->xy[above] = x[1];
      if (s > q) result->xy[below] = result->yx[above] = y[0];
    }
}

/* Converts the displacement of node r under a force at node k to the directions ss, sz, zs and
 * zz of the chart. */
static void turn_pair(const compliance *c, const double *axes, int r, int k, double turned[4]) {
  const size_t at = dense_at(r, k, c->n);
  const double *u = &axes[4 * r], *v = &axes[4 * k];
  for (int i = 0; i < 4; i++) {
    const double *from = &v[i % 2 * 2], *to = &u[i / 2 * 2];
    turned[i] = to[0] * (c->xx[at] * from[0] + c->xy[at] * from[1]) +
                to[1] * (c->yx[at] * from[0] + c->yy[at] * from[1]);
  }
}

/* Converts a compliance to the directions of the chart. The result is exactly symmetric. */
static void turn(compliance *c, const double *axes) {
  for (int k = 0; k < c->n; k++)
    for (int r = k; r < c->n; r++) {
      double t[4];
      const size_t below = dense_at(r, k, c->n), above = dense_at(k, r, c->n);
      turn_pair(c, axes, r, k, t);
      c->xx[below] = c->xx[above] = t[0];
      c->xy[below] = c->yx[above] = t[1];
      c->yx[below] = c->xy[above] = t[2];
      c->yy[below] = c->yy[above] = t[3];
    }
}

static arc_status turn_into_chart(const elastic_body *b, const double *box_at, compliance *c,
                                  arc_error *error) {
  if (!b->chart.polar) return ARC_OK;
  double *axes = malloc(4 * (size_t)c->n * sizeof *axes);
  if (!axes) return arc_fail(error, ARC_MEMORY, "out of memory for a compliance");
  for (int i = 0; i < c->n; i++)
    arc_chart_axes(&b->chart, box_at[2 * i * (b->mesh->rows + 1)], &axes[4 * i], &axes[4 * i + 2]);
  turn(c, axes);
  free(axes);
  return ARC_OK;
}

arc_status arc_body_condense(const elastic_body *b, const double *box_at, double even,
                             compliance *result, arc_error *error) {
  condensation c;
  arc_status status = condense(b, box_at, even, &c, error);
  if (status != ARC_OK) return status;
  for (int q = 0; q < 2 * c.ns; q += together) add_z(b, &c, q);
  for (int j = 0; j < 2 * c.ns; j += panel) add_panel(&c, j);
  split(&c, result);
  condensation_free(&c);
  status = turn_into_chart(b, box_at, result, error);
  if (status == ARC_OK && arc_body_layers(&b->mesh->solid) == 0) arc_compliance_level(result);
  return status;
}

/* Computes the displacements -K_ff^-1 K_fr u_rim of the far unknowns and writes them to u. */
static arc_status far_displacements(const elastic_body *b, const double *rim, double *u,
                                    arc_error *error) {
  double *far = calloc((size_t)b->far_count, sizeof *far);
  if (!far) return arc_fail(error, ARC_MEMORY, "out of memory for displacements");
  for (size_t k = 0; k < b->coupling.count; k++)
    far[b->coupling.row[k]] -= b->coupling.value[k] * rim[b->coupling.column[k]];
  const arc_status status = arc_factor_solve(b->far, far, error);
  for (int n = 0; n < 2 * b->mesh->nodes && status == ARC_OK; n++)
    if (b->far_at[n] >= 0) u[n] = far[b->far_at[n]];
  free(far);
  return status;
}

/* Computes the displacements of the rim and inner nodes due to the forces on the surface. f
 * contains the forces along x on all surface nodes, then the forces along y. */
static void box_displacements(const elastic_body *b, const condensation *c, const double *f,
                              double *rim, double *inner) {
  memset(rim, 0,
         (size_t)(c->nr + c->ni) *
             sizeof *rim); /* also clears `inner`, which follows `rim` in memory */
  for (int j = 0; j < 2 * c->ns; j++) {
    const double force = f[j % 2 * c->ns + j / 2];
    const double *w = &c->w[dense_at(0, j, c->nr)];
    for (int r = c->first[j]; r < c->nr; r++) rim[r] += w[r] * force;
    if (inner_unknown(b, j) >= 0) inner[inner_unknown(b, j)] = force;
  }
  arc_dense_cholesky_solve(c->nr, 1, c->t, c->nr, rim, c->nr);
  for (size_t k = 0; k < c->rim.count; k++)
    inner[c->rim.column[k]] -= c->rim.value[k] * rim[c->rim.row[k]];
  for (int i = 0; i < c->ni; i++) c->side[together * i] = inner[i];
  int from = 0, to = c->ni;
  arc_dense_band_solve(c->ni, b->band, c->band, c->side, &from, &to);
  for (int i = 0; i < c->ni; i++) inner[i] = c->side[together * i];
}

/* Converts the forces on n nodes from the directions of the chart to x and y. */
static void turn_forces(const elastic_body *b, const double *box_at, const double *f, double *to) {
  const int n = b->mesh->surface;
  for (int i = 0; i < n; i++) {
    double along[2], across[2];
    arc_chart_axes(&b->chart, box_at[2 * i * (b->mesh->rows + 1)], along, across);
    for (int d = 0; d < 2; d++) to[d * n + i] = along[d] * f[i] + across[d] * f[n + i];
  }
}

arc_status arc_body_displacements(const elastic_body *b, const double *box_at, double even,
                                  const double *f, double *u, arc_error *error) {
  condensation c;
  arc_status status = condense(b, box_at, even, &c, error);
  if (status != ARC_OK) return status;
  double *rim = malloc((size_t)(c.nr + c.ni + 2 * c.ns) * sizeof *rim);
  if (rim) {
    double *inner = rim + c.nr, *turned = inner + c.ni;
    if (b->chart.polar) {
      turn_forces(b, box_at, f, turned);
      f = turned;
    }
    box_displacements(b, &c, f, rim, inner);
    memset(u, 0, 2 * (size_t)b->mesh->nodes * sizeof *u);
    for (int k = 0; k < b->box_count; k++) {
      const double *from =
          b->box_inner[k] >= 0 ? &inner[2 * b->box_inner[k]] : &rim[2 * b->box_rim[k]];
      memcpy(&u[2 * b->mesh->box_node[k]], from, 2 * sizeof *u);
    }
    status = far_displacements(b, rim, u, error);
  } else {
    status = arc_fail(error, ARC_MEMORY, "out of memory for displacements");
  }
  free(rim);
  condensation_free(&c);
  return status;
}

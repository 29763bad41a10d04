/* The dense update of a worn shape: S = S_far + K_box(current nodes), F = the surface's
 * blocks of S^-1.
 *
 * With K_box = [K_ii K_ir; K_ri K_rr] (inner, rim): X = K_ii^-1 K_ir, Z = K_ii^-1 E, T = K_rr +
 * S_far - K_ri X and W = E_r - X' E_i give  u_rim = T^-1 W f,  u_inner = Z f - X u_rim,  F = E' Z +
 * W' T^-1 W, where E picks the surface unknowns, along x
 * first, then along y. K_ii is a narrow band, so nothing costs
 * more than T's size squared.
 */
#include "core/base/dense.h"
#include "core/elastic/body.h"

#include <stdlib.h>
#include <string.h>

typedef struct condensation {
  int ni, nr, ns;     /* inner and rim unknowns, surface nodes */
  double *band;       /* [(band + 1) * ni] factor of K_ii */
  double *x;          /* [ni x (nr + 2 ns)] X, then Z beside it */
  double *t;          /* [nr x nr] factor of T */
  double *w;          /* [nr x 2 ns] W */
  double *work;       /* of the band's solutions */
  sparse_entries rim; /* K_ri: row rim, column inner */
} condensation;

static void condensation_free(condensation *c) {
  free(c->band);
  free(c->x);
  free(c->t);
  free(c->w);
  free(c->work);
  arc_sparse_free(&c->rim);
}

static arc_status condensation_create(const elastic_body *b, condensation *c) {
  *c = (condensation){.ni = 2 * b->inner, .nr = 2 * b->rim, .ns = b->mesh->surface};
  const size_t ni = (size_t)c->ni, nr = (size_t)c->nr, ns = (size_t)c->ns;
  c->band = calloc((size_t)(b->band + 1) * ni, sizeof(double));
  c->x = calloc(ni * (nr + 2 * ns), sizeof(double));
  c->t = malloc(nr * nr * sizeof(double));
  c->w = calloc(2 * nr * ns, sizeof(double));
  c->work = malloc(ARC_DENSE_BAND_WORK * ni * sizeof(double));
  if (c->band && c->x && c->t && c->w && c->work) return ARC_OK;
  condensation_free(c);
  return ARC_MEMORY;
}

/* Adds one wear-box element with its nodes at box_xy. */
static arc_status add_box_element(const elastic_body *b, int e, const double *box_xy,
                                  condensation *c) {
  int corner[4], inner[8], rim[8];
  for (int a = 0; a < 4; a++) corner[a] = b->node_box[b->mesh->element[4 * e + a]];
  const element el = arc_element_at(box_xy, corner, b->mesh->def.element);
  double k[64];
  arc_element_stiffness(&el, b->d, k);
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

static int surface_inner(const elastic_body *b, int node) {
  return b->box_inner[node * (b->mesh->rows + 1)];
}

/* Right-hand sides [K_ir, E_i]. */
static void fill_right_hand_sides(const elastic_body *b, condensation *c) {
  for (size_t k = 0; k < c->rim.count; k++)
    c->x[dense_at(c->rim.column[k], c->rim.row[k], c->ni)] += c->rim.value[k];
  for (int s = 0; s < c->ns; s++) {
    const int at = surface_inner(b, s);
    for (int d = 0; d < 2 && at >= 0; d++)
      c->x[dense_at(2 * at + d, c->nr + d * c->ns + s, c->ni)] = 1;
  }
}

/* T -= K_ri X. */
static void reduce_rim(condensation *c) {
  for (int q = 0; q < c->nr; q++) {
    const double *x = &c->x[dense_at(0, q, c->ni)];
    double *t = &c->t[dense_at(0, q, c->nr)];
    for (size_t k = 0; k < c->rim.count; k++)
      t[c->rim.row[k]] -= c->rim.value[k] * x[c->rim.column[k]];
  }
}

/* W = E_r - X' E_i, for the surface unknowns along x (direction 0) or y (1). */
static void fill_w(const elastic_body *b, condensation *c, int direction) {
  for (int s = 0; s < c->ns; s++) {
    const int at = surface_inner(b, s);
    double *column = &c->w[dense_at(0, direction * c->ns + s, c->nr)];
    if (at < 0)
      column[2 * b->box_rim[s * (b->mesh->rows + 1)] + direction] = 1;
    else
      for (int r = 0; r < c->nr; r++) column[r] = -c->x[dense_at(2 * at + direction, r, c->ni)];
  }
}

static arc_status condense(const elastic_body *b, const double *box_xy, condensation *c,
                           arc_error *error) {
  const char *name = arc_body_name(b->mesh->body);
  if (condensation_create(b, c) != ARC_OK)
    return arc_fail(error, ARC_MEMORY, "out of memory for the %s's wear box", name);
  memcpy(c->t, b->s_far, (size_t)c->nr * (size_t)c->nr * sizeof(double));
  arc_status status = ARC_OK;
  for (int e = 0; e < b->mesh->box_elements && status == ARC_OK; e++)
    status = add_box_element(b, e, box_xy, c);
  if (status != ARC_OK) {
    arc_fail(error, status, "out of memory for the %s's wear box", name);
  } else {
    fill_right_hand_sides(b, c);
    int bad = arc_dense_band_cholesky(c->ni, b->band, c->band);
    if (!bad) {
      arc_dense_band_solve(c->ni, b->band, c->nr + 2 * c->ns, c->band, c->x, c->ni, c->work);
      reduce_rim(c);
      bad = arc_dense_cholesky(c->nr, c->t, c->nr);
    }
    if (bad)
      status = arc_fail(error, ARC_NUMERIC, "the %s's wear box is not positive definite at row %d",
                        name, bad);
  }
  if (status == ARC_OK) {
    fill_w(b, c, 0);
    fill_w(b, c, 1);
  } else {
    condensation_free(c);
  }
  return status;
}

/* block := rows of Z at the surface's unknowns along `direction`, under forces along `force`. */
static void surface_rows_of_z(const elastic_body *b, const condensation *c, int direction,
                              int force, double *result) {
  for (int s = 0; s < c->ns; s++) {
    const int at = surface_inner(b, s);
    for (int q = 0; q < c->ns; q++)
      result[dense_at(s, q, c->ns)] =
          at < 0 ? 0 : c->x[dense_at(2 * at + direction, c->nr + force * c->ns + q, c->ni)];
  }
}

static void fill_block(const elastic_body *b, const condensation *c, int direction, int force,
                       double *result) {
  const size_t half = (size_t)c->nr * (size_t)c->ns;
  surface_rows_of_z(b, c, direction, force, result);
  arc_dense_multiply_transposed(c->ns, c->ns, c->nr, 1, c->w + (size_t)direction * half, c->nr,
                                c->w + (size_t)force * half, c->nr, 1, result, c->ns);
}

arc_status arc_body_condense(const elastic_body *b, const double *box_xy, compliance *result,
                             arc_error *error) {
  condensation c;
  const arc_status status = condense(b, box_xy, &c, error);
  if (status != ARC_OK) return status;
  arc_dense_forward(c.nr, 2 * c.ns, c.t, c.nr, c.w, c.nr);
  fill_block(b, &c, 0, 0, result->xx);
  fill_block(b, &c, 0, 1, result->xy);
  fill_block(b, &c, 1, 1, result->yy);
  for (int q = 0; q < c.ns; q++)
    for (int s = 0; s < c.ns; s++)
      result->yx[dense_at(s, q, c.ns)] = result->xy[dense_at(q, s, c.ns)];
  condensation_free(&c);
  return ARC_OK;
}

/* u_far = -K_ff^-1 K_fr u_rim, written into u. */
static arc_status far_displacements(const elastic_body *b, const double *rim, double *u,
                                    arc_error *error) {
  double *far = calloc((size_t)b->far_count, sizeof *far);
  if (!far) return arc_fail(error, ARC_MEMORY, "out of memory for displacements");
  for (size_t k = 0; k < b->coupling.count; k++)
    far[b->coupling.row[k]] -= b->coupling.value[k] * rim[b->coupling.column[k]];
  const arc_status status = arc_factor_solve(b->far, far, error);
  for (int n = 0; n < b->mesh->nodes && status == ARC_OK; n++)
    if (b->node_far[n] >= 0) memcpy(&u[2 * n], &far[b->node_far[n]], 2 * sizeof *u);
  free(far);
  return status;
}

/* Rim and inner displacements of the wear box under surface forces f. */
static void box_displacements(const condensation *c, const double *f, double *rim, double *inner) {
  arc_dense_multiply(c->nr, 1, 2 * c->ns, 1, c->w, c->nr, f, 2 * c->ns, 0, rim, c->nr);
  arc_dense_cholesky_solve(c->nr, 1, c->t, c->nr, rim, c->nr);
  const double *z = &c->x[dense_at(0, c->nr, c->ni)];
  arc_dense_multiply(c->ni, 1, 2 * c->ns, 1, z, c->ni, f, 2 * c->ns, 0, inner, c->ni);
  arc_dense_multiply(c->ni, 1, c->nr, -1, c->x, c->ni, rim, c->nr, 1, inner, c->ni);
}

arc_status arc_body_displacements(const elastic_body *b, const double *box_xy, const double *f,
                                  double *u, arc_error *error) {
  condensation c;
  arc_status status = condense(b, box_xy, &c, error);
  if (status != ARC_OK) return status;
  double *rim = malloc((size_t)(c.nr + c.ni) * sizeof *rim);
  if (rim) {
    double *inner = rim + c.nr;
    box_displacements(&c, f, rim, inner);
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

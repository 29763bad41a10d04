/* Sparse Cholesky factors by CHOLMOD, supernodal with AMD ordering. A supernodal factorisation
 * fails for an indefinite matrix (a missing support), for which the simplicial LDL' would
 * continue. The status of CHOLMOD is read directly after each call, because the next call resets
 * it. */
#include "core/elastic/factor.h"
#include "core/base/dense.h"

#include <stdlib.h>
#include <string.h>
#if __has_include(<suitesparse/cholmod.h>)
#include <suitesparse/cholmod.h>
#else
#include <cholmod.h>
#endif

struct factor {
  cholmod_common common;
  cholmod_factor *l;
  int last;                 /* number of unknowns of the Schur complement */
  cholmod_dense *x, *y, *e; /* workspace that later solutions use again */
};

arc_status arc_sparse_add(sparse_entries *s, int row, int column, double value) {
  if (s->count == s->capacity) {
    const size_t capacity = 2 * s->capacity + 1024;
    int *rows = realloc(s->row, capacity * sizeof *rows);
    if (rows) s->row = rows;
    int *columns = realloc(s->column, capacity * sizeof *columns);
    if (columns) s->column = columns;
    double *values = realloc(s->value, capacity * sizeof *values);
    if (values) s->value = values;
    if (!rows || !columns || !values) return ARC_MEMORY;
    s->capacity = capacity;
  }
  s->row[s->count] = row;
  s->column[s->count] = column;
  s->value[s->count++] = value;
  return ARC_OK;
}

void arc_sparse_free(sparse_entries *s) {
  free(s->row);
  free(s->column);
  free(s->value);
  *s = (sparse_entries){0};
}

static cholmod_sparse *to_sparse(int n, const sparse_entries *entries, cholmod_common *common) {
  cholmod_triplet t = {.nrow = (size_t)n,
                       .ncol = (size_t)n,
                       .nzmax = entries->count,
                       .nnz = entries->count,
                       .i = entries->row,
                       .j = entries->column,
                       .x = entries->value,
                       .stype = -1,
                       .itype = CHOLMOD_INT,
                       .xtype = CHOLMOD_REAL,
                       .dtype = CHOLMOD_DOUBLE};
  return cholmod_triplet_to_sparse(&t, entries->count, common);
}

static arc_status why(const factor *f, arc_error *error) {
  if (f->common.status == CHOLMOD_OUT_OF_MEMORY)
    return arc_fail(error, ARC_MEMORY, "out of memory in the factorisation");
  if (f->common.status == CHOLMOD_NOT_POSDEF)
    return arc_fail(error, ARC_NUMERIC,
                    "the stiffness is not positive definite at column %zu of %zu",
                    f->l ? f->l->minor : 0, f->l ? f->l->n : 0);
  if (f->common.status == CHOLMOD_TOO_LARGE)
    return arc_fail(error, ARC_MEMORY,
                    "the mesh is too fine to be factorised; use larger elements");
  return arc_fail(error, ARC_NUMERIC, "CHOLMOD failed with status %d", f->common.status);
}

/* Computes a permutation that reduces the fill-in and keeps the last unknowns last, so that the
 * last part of the factor determines the Schur complement. Returns 0 on failure. */
static int order(cholmod_sparse *a, int last, int *permutation, cholmod_common *common) {
  const int n = (int)a->nrow;
  int *group = malloc((size_t)n * sizeof *group);
  if (!group) {
    common->status = CHOLMOD_OUT_OF_MEMORY;
    return 0;
  }
  for (int k = 0; k < n; k++) group[k] = k >= n - last;
  const int done = cholmod_camd(a, NULL, 0, group, permutation, common);
  free(group);
  return done;
}

/* Returns true if the last unknowns are still last. The analysis may reorder unknowns that are
 * not connected to the rest. */
static int kept_last(const factor *f) {
  const int *permutation = f->l->Perm, n = (int)f->l->n;
  for (int k = n - f->last; k < n; k++)
    if (permutation[k] < n - f->last) return 0;
  return 1;
}

static arc_status analyse(factor *f, cholmod_sparse *a, arc_error *error) {
  int *permutation = malloc(a->nrow * sizeof *permutation);
  if (!permutation) f->common.status = CHOLMOD_OUT_OF_MEMORY;
  if (permutation && order(a, f->last, permutation, &f->common))
    f->l = cholmod_analyze_p(a, permutation, NULL, 0, &f->common);
  free(permutation);
  if (!f->l) return why(f, error);
  if (kept_last(f)) return ARC_OK;
  return arc_fail(error, ARC_NUMERIC, "the mesh has parts that are not connected");
}

static arc_status factorise(factor *f, cholmod_sparse *a, arc_error *error) {
  const arc_status status = analyse(f, a, error);
  if (status != ARC_OK) return status;
  if (cholmod_factorize(a, f->l, &f->common) && f->common.status == CHOLMOD_OK &&
      f->l->minor == f->l->n)
    return ARC_OK;
  return why(f, error);
}

arc_status arc_factor_create(int n, int last, const sparse_entries *entries, factor **result,
                             arc_error *error) {
  *result = NULL;
  factor *f = calloc(1, sizeof *f);
  if (!f) return arc_fail(error, ARC_MEMORY, "out of memory in the factorisation");
  f->last = last;
  cholmod_start(&f->common);
  f->common.print = 0;
  f->common.nmethods = 1;
  f->common.method[0].ordering = CHOLMOD_GIVEN;
  f->common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse *a = to_sparse(n, entries, &f->common);
  const arc_status status = a ? factorise(f, a, error) : why(f, error);
  cholmod_free_sparse(&a, &f->common);
  if (status != ARC_OK) arc_factor_destroy(&f);
  *result = f;
  return status;
}

/* Copies the lower triangle of the factor's last rows and columns, in the order of the factor. */
static void last_block(const factor *f, double *block) {
  const cholmod_factor *l = f->l;
  const int *super = l->super, *pi = l->pi, *px = l->px, *rows = l->s;
  const int first = (int)l->n - f->last;
  const double *x = l->x;
  for (size_t s = 0; s < l->nsuper; s++)
    for (int c = super[s]; c < super[s + 1]; c++) {
      if (c < first) continue;
      const int height = pi[s + 1] - pi[s], at = c - super[s];
      for (int r = at; r < height; r++)
        block[dense_at(rows[pi[s] + r] - first, c - first, f->last)] =
            x[(size_t)px[s] + (size_t)r + (size_t)at * (size_t)height];
    }
}

arc_status arc_factor_schur(const factor *f, double *schur, arc_error *error) {
  const int m = f->last, *order_of = (const int *)f->l->Perm + f->l->n - m;
  const size_t count = (size_t)m * (size_t)m;
  double *block = calloc(2 * count, sizeof *block);
  if (!block) return arc_fail(error, ARC_MEMORY, "out of memory in the factorisation");
  double *product = block + count;
  last_block(f, block);
  arc_dense_square(m, m, block, m, product, m);
  const int first = (int)f->l->n - m;
  for (int c = 0; c < m; c++)
    for (int r = c; r < m; r++) {
      const int i = order_of[r] - first, j = order_of[c] - first;
      schur[dense_at(i, j, m)] = schur[dense_at(j, i, m)] = product[dense_at(r, c, m)];
    }
  free(block);
  return ARC_OK;
}

void arc_factor_destroy(factor **f) {
  if (!f || !*f) return;
  cholmod_common *c = &(*f)->common;
  cholmod_free_dense(&(*f)->x, c);
  cholmod_free_dense(&(*f)->y, c);
  cholmod_free_dense(&(*f)->e, c);
  cholmod_free_factor(&(*f)->l, c);
  cholmod_finish(c);
  free(*f);
  *f = NULL;
}

/* Allocates the workspace in advance, as cholmod_solve2 does not check its first allocation. */
static int ensure_workspace(factor *f, size_t count) {
  const size_t n = f->l->n, e = f->l->maxesize;
  return cholmod_ensure_dense(&f->x, n, count, n, CHOLMOD_REAL, &f->common) &&
         cholmod_ensure_dense(&f->y, n, count, n, CHOLMOD_REAL, &f->common) &&
         cholmod_ensure_dense(&f->e, e, count, e, CHOLMOD_REAL, &f->common);
}

/* Solves the system `system`, such as L x = b (CHOLMOD_L), for the right-hand side `from` and
 * writes the solution to f->x. Returns 0 on failure. */
static int solve_system(factor *f, int system, cholmod_dense *from) {
  return cholmod_solve2(system, f->l, from, NULL, &f->x, NULL, &f->y, &f->e, &f->common);
}

/* Solves A x = b with the factors L and L' of A. The rows of the last unknowns are set to zero
 * between both solutions, which excludes these unknowns. */
arc_status arc_factor_solve(factor *f, double *b, arc_error *error) {
  const size_t n = f->l->n, first = n - (size_t)f->last;
  double *rhs_values = calloc(n, sizeof *rhs_values);
  if (!rhs_values) return arc_fail(error, ARC_MEMORY, "out of memory for displacements");
  cholmod_dense rhs = {.nrow = n,
                       .ncol = 1,
                       .nzmax = n,
                       .d = n,
                       .x = rhs_values,
                       .xtype = CHOLMOD_REAL,
                       .dtype = CHOLMOD_DOUBLE};
  static const int system[] = {CHOLMOD_P, CHOLMOD_L, CHOLMOD_Lt, CHOLMOD_Pt};
  arc_status status = ensure_workspace(f, 1) ? ARC_OK : why(f, error);
  memcpy(rhs_values, b, first * sizeof *b);
  for (int k = 0; k < 4 && status == ARC_OK; k++) {
    if (!solve_system(f, system[k], &rhs)) status = why(f, error);
    if (status == ARC_OK) memcpy(rhs_values, f->x->x, n * sizeof *rhs_values);
    if (system[k] == CHOLMOD_L) memset(&rhs_values[first], 0, (size_t)f->last * sizeof *rhs_values);
  }
  if (status == ARC_OK) memcpy(b, rhs_values, first * sizeof *b);
  free(rhs_values);
  return status;
}

size_t arc_factor_bytes(const factor *f) {
  return f ? f->common.memory_inuse : 0;
}

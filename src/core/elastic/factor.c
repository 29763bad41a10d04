/* CHOLMOD, supernodal with AMD ordering. A supernodal factorisation fails on an indefinite matrix
 * (a forgotten support) where the simplicial LDL' would go on; the status is read at once, because
 * the next call resets it. */
#include "core/elastic/factor.h"

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
  cholmod_dense *x, *y, *e; /* workspace kept between solves */
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

arc_status arc_factor_create(int n, const sparse_entries *entries, factor **result,
                             arc_error *error) {
  *result = NULL;
  factor *f = calloc(1, sizeof *f);
  if (!f) return arc_fail(error, ARC_MEMORY, "out of memory in the factorisation");
  cholmod_start(&f->common);
  f->common.print = 0;
  f->common.nmethods = 1;
  f->common.method[0].ordering = CHOLMOD_AMD;
  f->common.supernodal = CHOLMOD_SUPERNODAL;
  arc_status status = ARC_OK;
  cholmod_sparse *a = to_sparse(n, entries, &f->common);
  if (a) f->l = cholmod_analyze(a, &f->common);
  if (!a || !f->l || !cholmod_factorize(a, f->l, &f->common) || f->common.status != CHOLMOD_OK ||
      f->l->minor < f->l->n)
    status = why(f, error);
  cholmod_free_sparse(&a, &f->common);
  if (status != ARC_OK) arc_factor_destroy(&f);
  *result = f;
  return status;
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

/* cholmod_solve2 takes its workspace itself, but asks for the second block without looking whether
 * it got the first, and then writes to nowhere. */
static int ensure_workspace(factor *f, size_t count) {
  const size_t n = f->l->n, e = f->l->maxesize;
  return cholmod_ensure_dense(&f->x, n, count, n, CHOLMOD_REAL, &f->common) &&
         cholmod_ensure_dense(&f->y, n, count, n, CHOLMOD_REAL, &f->common) &&
         cholmod_ensure_dense(&f->e, e, count, e, CHOLMOD_REAL, &f->common);
}

arc_status arc_factor_solve(factor *f, int count, double *b, arc_error *error) {
  const size_t n = f->l->n;
  if (!ensure_workspace(f, (size_t)count)) return why(f, error);
  cholmod_dense rhs = {.nrow = n,
                       .ncol = (size_t)count,
                       .nzmax = n * (size_t)count,
                       .d = n,
                       .x = b,
                       .xtype = CHOLMOD_REAL,
                       .dtype = CHOLMOD_DOUBLE};
  if (!cholmod_solve2(CHOLMOD_A, f->l, &rhs, NULL, &f->x, NULL, &f->y, &f->e, &f->common))
    return why(f, error);
  memcpy(b, f->x->x, n * (size_t)count * sizeof *b);
  return ARC_OK;
}

size_t arc_factor_bytes(const factor *f) {
  return f ? f->common.memory_inuse : 0;
}

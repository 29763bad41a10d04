/* A sparse Cholesky factor. factor.c is the one file that includes cholmod.h. */
#ifndef ELASTIC_FACTOR_H
#define ELASTIC_FACTOR_H

#include "archard/base.h"

/* Entries of a symmetric matrix, lower triangle (row >= column); repeated entries add up. */
typedef struct sparse_entries {
  size_t count, capacity;
  int *row, *column;
  double *value;
} sparse_entries;

/* Appends an entry; ARC_MEMORY leaves the list as it was. */
arc_status arc_sparse_add(sparse_entries *entries, int row, int column, double value);
void arc_sparse_free(sparse_entries *entries);

typedef struct factor factor;

/* Factorises the n x n matrix, whose last `last` unknowns come last. ARC_NUMERIC where it is not
 * positive definite, or where the first unknowns are not all joined to each other; ARC_MEMORY. */
arc_status arc_factor_create(int n, int last, const sparse_entries *entries, factor **result,
                             arc_error *error);
void arc_factor_destroy(factor **f);

/* What is left of the matrix at the last unknowns once the others are eliminated: schur [last x
 * last]. ARC_MEMORY. */
arc_status arc_factor_schur(const factor *f, double *schur, arc_error *error);

/* b := A^-1 b with A the matrix of the other unknowns alone, b [n - last]. Not for use by two
 * threads at once on one factor. */
arc_status arc_factor_solve(factor *f, double *b, arc_error *error);

/* Bytes the factor holds. */
size_t arc_factor_bytes(const factor *f);

#endif

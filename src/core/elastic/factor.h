/* Sparse Cholesky factorisation. Only factor.c includes cholmod.h. */
#ifndef ELASTIC_FACTOR_H
#define ELASTIC_FACTOR_H

#include "archard/base.h"

/* Entries of the lower triangle (row >= column) of a symmetric matrix. Repeated entries are
 * added. */
typedef struct sparse_entries {
  size_t count, capacity;
  int *row, *column;
  double *value;
} sparse_entries;

/* Appends an entry. After ARC_MEMORY the list is unchanged. */
arc_status arc_sparse_add(sparse_entries *entries, int row, int column, double value);
void arc_sparse_free(sparse_entries *entries);

typedef struct factor factor;

/* Factorises an n x n matrix. Its last `last` unknowns remain last in the ordering. Errors:
 * ARC_MEMORY; ARC_NUMERIC if the matrix is not positive definite or some of the other unknowns
 * are not connected to the rest. */
arc_status arc_factor_create(int n, int last, const sparse_entries *entries, factor **result,
                             arc_error *error);
void arc_factor_destroy(factor **f);

/* Computes the Schur complement of the last unknowns and writes it to schur [last x last].
 * Errors: ARC_MEMORY. */
arc_status arc_factor_schur(const factor *f, double *schur, arc_error *error);

/* Replaces b [n - last] by A^-1 b, where A is the matrix without the last unknowns. Two threads
 * must not use the same factor at the same time. Errors: ARC_MEMORY, ARC_NUMERIC. */
arc_status arc_factor_solve(factor *f, double *b, arc_error *error);

/* Returns the memory of the factor [bytes]. */
size_t arc_factor_bytes(const factor *f);

#endif

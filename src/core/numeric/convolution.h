/* Declares convolutions of cell values with even or odd kernels, computed by Fourier transforms.
 * Only convolution.c includes fftw3.h. */
#ifndef NUMERIC_CONVOLUTION_H
#define NUMERIC_CONVOLUTION_H

#include "archard/base.h"

/* A convolution u[i][j] = sum over k, l of kernel(i - k, j - l) p[k][l] on a window of rows x
 * columns cells, which are stored row by row. It is computed on a periodic box that contains the
 * window. A convolution does not change after its creation, so several threads may apply it at
 * once, each with its own workspace. */
typedef struct convolution convolution;
typedef struct convolution_work convolution_work;

/* Returns the value of a kernel at a lag of `row` rows and `column` columns, both >= 0. The parity
 * determines the values at negative lags. A kernel that is odd in a direction must be 0 at lag 0 of
 * this direction. */
typedef double (*lag_fn)(const void *context, int row, int column);
typedef enum lag_parity {
  EVEN_LAGS,
  ODD_ROWS,
  ODD_COLUMNS,
  ODD_BOTH = ODD_ROWS | ODD_COLUMNS
} lag_parity;

/* Returns the smallest length >= n that is a multiple of 4, not of 9, and has no prime factor above
 * 7. FFTW needs up to twice the time for other lengths of this size. */
int arc_transform_length(int n);

/* Creates a convolution without periodic images, on a box about twice as large as the window.
 * Errors: ARC_MEMORY. */
arc_status arc_convolution_create(int rows, int columns, lag_parity parity, lag_fn kernel,
                                  const void *context, convolution **made, arc_error *error);
/* Creates a convolution from symbol [box_rows / 2 + 1][box_columns / 2 + 1], the transform of an
 * even kernel on a periodic box of box_rows x box_columns cells (both even). */
arc_status arc_convolution_from_symbol(int rows, int columns, int box_rows, int box_columns,
                                       const double *symbol, convolution **made, arc_error *error);
/* Computes the symbol of an even kernel on a periodic box of box_rows x box_columns cells (both
 * even). */
arc_status arc_convolution_symbol(int box_rows, int box_columns, lag_fn kernel, const void *context,
                                  double *symbol, arc_error *error);
void arc_convolution_destroy(convolution **c);
size_t arc_convolution_bytes(const convolution *c);

/* Creates a workspace for the convolution `largest` and all convolutions that are not larger.
 * Returns NULL if out of memory. */
convolution_work *arc_convolution_work(const convolution *largest);
void arc_convolution_work_free(convolution_work **work);

/* Computes the convolution u of the kernel with p, both [rows * columns]. u and p may be the same
 * array. The workspace must be large enough for this convolution. */
void arc_convolution_apply(const convolution *c, convolution_work *work, const double *p,
                           double *u);

/* Computes a part of a convolution u of the kernel with p, so that several threads can share it.
 * The convolution has the stages 0, 1 and 2, each with arc_convolution_parts(c, stage) parts. All
 * parts of a stage must be complete before the next stage begins. The stages share the workspace
 * `shared`; each thread also has its workspace `own`, which may be `shared` for one of them. The
 * result has the bits of arc_convolution_apply. */
int arc_convolution_parts(const convolution *c, int stage);
void arc_convolution_part(const convolution *c, convolution_work *shared, convolution_work *own,
                          int stage, int part, const double *p, double *u);

/* Computes the convolution of fields whose consecutive rows begin `stride` numbers apart. */
void arc_convolution_apply_strided(const convolution *c, convolution_work *work, int stride,
                                   const double *p, double *u);

/* Computes two convolutions with a symmetric matrix of three kernels: u[0] = k[0] * p[0] + k[1] *
 * p[1] and u[1] = k[1] * p[0] + k[2] * p[1]. Only two forward and two backward transforms are
 * needed. The kernels must have the same window, and no kernel may be odd in only one direction. u
 * may be the same as p. In p and u, consecutive rows begin `stride` numbers apart. */
void arc_convolution_apply_pair(const convolution *const k[3], convolution_work *const work[2],
                                int stride, const double *const p[2], double *const u[2]);

/* Compute the forward and the backward transform of a whole box. `values` has the shape
 * [box_rows][box_columns], `spectrum` consists of [box_rows][box_columns / 2 + 1] pairs (real,
 * imaginary). The backward transform multiplies by 1 / (box_rows box_columns) and destroys the
 * spectrum. Error: ARC_MEMORY. */
arc_status arc_transform_forward(int box_rows, int box_columns, const double *values,
                                 double *spectrum, arc_error *error);
arc_status arc_transform_back(int box_rows, int box_columns, double *spectrum, double *values,
                              arc_error *error);

/* Transforms of `rows` rows with `box` (even) numbers each, for convolutions along rows only.
 * `values` has the shape [rows][box], `spectrum` consists of [rows][box / 2 + 1] pairs (real,
 * imaginary). Two threads must not use the same transform at once. arc_rows_create returns NULL if
 * out of memory. */
typedef struct row_transform row_transform;
row_transform *arc_rows_create(int rows, int box);
void arc_rows_destroy(row_transform **t);
void arc_rows_forward(row_transform *t, const double *values, double *spectrum);
/* Computes the backward transform, without the factor 1 / box. */
void arc_rows_back(row_transform *t, const double *spectrum, double *values);

#endif

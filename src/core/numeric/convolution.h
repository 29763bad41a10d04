/* Convolutions of cell values with even or odd kernels, by Fourier transforms. convolution.c is the
 * one file that includes fftw3.h. */
#ifndef NUMERIC_CONVOLUTION_H
#define NUMERIC_CONVOLUTION_H

#include "archard/base.h"

/* u[i][j] = sum over k, l of kernel(i - k, j - l) p[k][l] on a window of rows x columns cells, row
 * by row, computed on a periodic box that holds the window. Unchanged once made: any number of
 * threads may apply it, each with a workspace of its own. */
typedef struct convolution convolution;
typedef struct convolution_work convolution_work;

/* Kernel at a lag of so many rows and columns, both >= 0; its parity gives the other lags. Kernels
 * are 0 at the lag 0 of a direction in which they are odd. */
typedef double (*lag_fn)(const void *context, int row, int column);
typedef enum lag_parity {
  EVEN_LAGS,
  ODD_ROWS,
  ODD_COLUMNS,
  ODD_BOTH = ODD_ROWS | ODD_COLUMNS
} lag_parity;

/* The least even length from n upwards with no prime factor above 5. */
int arc_transform_length(int n);

/* Without periodic images: the box is at least twice the window. ARC_MEMORY. */
arc_status arc_convolution_create(int rows, int columns, lag_parity parity, lag_fn kernel,
                                  const void *context, convolution **made, arc_error *error);
/* With a given symbol, the transform of an even kernel on a box of box_rows x box_columns (even):
 * symbol [box_rows / 2 + 1][box_columns / 2 + 1]. */
arc_status arc_convolution_from_symbol(int rows, int columns, int box_rows, int box_columns,
                                       const double *symbol, convolution **made, arc_error *error);
/* The symbol of an even kernel wrapped on such a box, into symbol as above. */
arc_status arc_convolution_symbol(int box_rows, int box_columns, lag_fn kernel, const void *context,
                                  double *symbol, arc_error *error);
void arc_convolution_destroy(convolution **c);
size_t arc_convolution_bytes(const convolution *c);

/* A workspace that serves every convolution of a list; NULL: no memory. */
convolution_work *arc_convolution_work(const convolution *largest);
void arc_convolution_work_free(convolution_work **work);

/* u := kernel * p, both [rows * columns]; they may be the same array. The workspace must have been
 * made for a convolution at least as large. */
void arc_convolution_apply(const convolution *c, convolution_work *work, const double *p,
                           double *u);

/* u[0] := k[0] * p[0] + k[1] * p[1], u[1] := k[1] * p[0] + k[2] * p[1], with two transforms each.
 * The kernels are of one window, and none is odd in one direction alone. u may be p. */
void arc_convolution_apply_pair(const convolution *const k[3], convolution_work *const work[2],
                                const double *const p[2], double *const u[2]);

/* One transform of a box for pictures: `spectrum` [box_rows][box_columns / 2 + 1] pairs (real,
 * imaginary). forward: of values [box_rows][box_columns]; back: values from a spectrum, which is
 * destroyed, with the factor 1 / (box_rows box_columns). */
arc_status arc_transform_forward(int box_rows, int box_columns, const double *values,
                                 double *spectrum, arc_error *error);
arc_status arc_transform_back(int box_rows, int box_columns, double *spectrum, double *values,
                              arc_error *error);

/* Transforms of several rows of `box` (even) numbers each, for kernels that are a convolution along
 * rows only. values [rows][box]; spectrum [rows][box / 2 + 1] pairs (real, imaginary). Not for two
 * threads at once. NULL: no memory. */
typedef struct row_transform row_transform;
row_transform *arc_rows_create(int rows, int box);
void arc_rows_destroy(row_transform **t);
void arc_rows_forward(row_transform *t, const double *values, double *spectrum);
/* Back, without the factor 1 / box. */
void arc_rows_back(row_transform *t, const double *spectrum, double *values);

#endif

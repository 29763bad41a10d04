/* Computes convolutions by FFTW. First the rows of the window are transformed. Then blocks of
 * columns are copied, each column to consecutive numbers, transformed, multiplied by the symbol of
 * the kernel and transformed back. The padded box is never stored as a whole. FFTW's plans are
 * estimated, not measured, so that results do not change from run to run. */
#include "core/numeric/convolution.h"

#include "core/base/wide.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { block = 8 }; /* number of rows, or of columns, that are transformed together */

struct convolution {
  int rows, columns, box_rows, box_columns;
  int half;   /* number of columns of the spectrum: box_columns / 2 + 1 */
  int stride; /* distance between the starts of two rows of the spectrum, in complex numbers */
  int padded; /* distance between the starts of two rows of the values, in real numbers */
  int tall;   /* distance between the starts of two columns of a block, in complex numbers; longer
                 than a column, because few columns whose starts are a large power of two apart
                 fit into the processor's cache */
  double *symbol; /* [half][box_rows] scaled symbol, column by column */
  int imaginary;  /* true if the symbol is multiplied by the imaginary unit */
  /* Plans for a full block and for the last block: forward and backward transforms of rows, and of
   * columns. */
  fftw_plan into[2], out_of[2], down[2], up[2];
};

/* Arrays of a workspace. Each transform reads one array and writes another, because FFTW would copy
 * the data of a transform in place. */
struct convolution_work {
  double *values;                /* [rows][padded columns] */
  fftw_complex *spectrum;        /* [rows][stride] */
  fftw_complex *columns, *waves; /* [block][tall] */
};

int arc_transform_length(int n) {
  for (int length = (n + 3) / 4 * 4;; length += 4) {
    int rest = length;
    while (rest % 2 == 0) rest /= 2;
    if (rest % 3 == 0) rest /= 3;
    while (rest % 5 == 0) rest /= 5;
    while (rest % 7 == 0) rest /= 7;
    if (rest == 1) return length;
  }
}

/* Returns the number of rows (or columns), out of `all`, in the block that begins with `first`. */
static int width_of(int all, int first) {
  return all - first < block ? all - first : block;
}

static size_t spectrum_size(const convolution *c) {
  return (size_t)c->rows * (size_t)c->stride;
}

static void free_work(convolution_work *w) {
  fftw_free(w->values);
  fftw_free(w->spectrum);
  fftw_free(w->columns);
  fftw_free(w->waves);
  free(w);
}

convolution_work *arc_convolution_work(const convolution *c) {
  convolution_work *w = calloc(1, sizeof *w);
  if (!w) return NULL;
  w->values = fftw_malloc((size_t)c->rows * (size_t)c->padded * sizeof *w->values);
  w->spectrum = fftw_malloc(spectrum_size(c) * sizeof *w->spectrum);
  w->columns = fftw_malloc(block * (size_t)c->tall * sizeof *w->columns);
  w->waves = fftw_malloc(block * (size_t)c->tall * sizeof *w->waves);
  if (w->values && w->spectrum && w->columns && w->waves) return w;
  free_work(w);
  return NULL;
}

void arc_convolution_work_free(convolution_work **work) {
  if (*work) free_work(*work);
  *work = NULL;
}

/* --- plans ------------------------------------------------------------------------------------ */

static fftw_plan plan_columns(const convolution *c, int width, int sign, fftw_complex *from,
                              fftw_complex *to) {
  const int n = c->box_rows;
  return fftw_plan_many_dft(1, &n, width, from, NULL, 1, c->tall, to, NULL, 1, c->tall, sign,
                            FFTW_ESTIMATE);
}

/* Creates the plans of blocks of rows and columns, plan k of each kind. Returns 0 on failure. */
static int plan_blocks(convolution *c, convolution_work *w, int k, int rows, int columns) {
  const int n = c->box_columns;
  if (rows > 0) {
    c->into[k] = fftw_plan_many_dft_r2c(1, &n, rows, w->values, NULL, 1, c->padded, w->spectrum,
                                        NULL, 1, c->stride, FFTW_ESTIMATE);
    c->out_of[k] = fftw_plan_many_dft_c2r(1, &n, rows, w->spectrum, NULL, 1, c->stride, w->values,
                                          NULL, 1, c->padded, FFTW_ESTIMATE);
  }
  if (columns > 0) {
    c->down[k] = plan_columns(c, columns, FFTW_FORWARD, w->columns, w->waves);
    c->up[k] = plan_columns(c, columns, FFTW_BACKWARD, w->waves, w->columns);
  }
  return (rows == 0 || (c->into[k] && c->out_of[k])) && (columns == 0 || (c->down[k] && c->up[k]));
}

/* Creates the plans of a convolution. Returns 0 on failure. A lock of FFTW protects the memory that
 * all plans of a process share. */
static int plan(convolution *c, convolution_work *w) {
  fftw_make_planner_thread_safe();
  return plan_blocks(c, w, 0, c->rows < block ? 0 : block, c->half < block ? 0 : block) &&
         plan_blocks(c, w, 1, c->rows % block, c->half % block);
}

static void destroy_plan(fftw_plan p) {
  if (p) fftw_destroy_plan(p);
}

void arc_convolution_destroy(convolution **made) {
  convolution *c = *made;
  *made = NULL;
  if (!c) return;
  for (int k = 0; k < 2; k++) {
    destroy_plan(c->into[k]);
    destroy_plan(c->out_of[k]);
    destroy_plan(c->down[k]);
    destroy_plan(c->up[k]);
  }
  free(c->symbol);
  free(c);
}

size_t arc_convolution_bytes(const convolution *c) {
  return sizeof *c + (size_t)c->box_rows * (size_t)c->half * sizeof(double);
}

/* --- the symbol ------------------------------------------------------------------------------- */

static int is_imaginary(lag_parity parity) {
  return parity == ODD_ROWS || parity == ODD_COLUMNS;
}

/* Transposes and scales the symbol. Row i of the box has the symbol of row min(i, box_rows - i),
 * with the opposite sign for i > box_rows / 2 if the kernel is odd along the rows. */
static void store_symbol(convolution *c, lag_parity parity, const double *symbol) {
  const double size = (double)c->box_rows * c->box_columns;
  double *to = c->symbol;
  for (int j = 0; j < c->half; j++)
    for (int i = 0; i < c->box_rows; i++) {
      const int mirrored = i > c->box_rows / 2, row = mirrored ? c->box_rows - i : i;
      const double scale = (mirrored && parity & ODD_ROWS ? -1 : 1) / size;
      *to++ = scale * symbol[(size_t)row * (size_t)c->half + (size_t)j];
    }
}

static arc_status create(int rows, int columns, int box_rows, int box_columns, lag_parity parity,
                         const double *symbol, convolution **made, arc_error *error) {
  *made = NULL;
  convolution_work *work = NULL;
  convolution *c = calloc(1, sizeof *c);
  int complete = c != NULL;
  if (complete) {
    *c = (convolution){.rows = rows, .columns = columns, .box_rows = box_rows};
    c->box_columns = box_columns;
    c->imaginary = is_imaginary(parity);
    c->half = box_columns / 2 + 1;
    c->stride = c->half + c->half % 2;
    c->padded = (box_columns + 3) / 4 * 4;
    c->tall = (box_rows + 3) / 4 * 4 + 4;
    c->symbol = malloc((size_t)box_rows * (size_t)c->half * sizeof *c->symbol);
    work = arc_convolution_work(c);
    complete = c->symbol && work && plan(c, work);
  }
  if (complete)
    store_symbol(c, parity, symbol);
  else
    arc_convolution_destroy(&c);
  arc_convolution_work_free(&work);
  *made = c;
  return complete ? ARC_OK
                  : arc_fail(error, ARC_MEMORY, "out of memory for a window of %d x %d cells", rows,
                             columns);
}

arc_status arc_convolution_from_symbol(int rows, int columns, int box_rows, int box_columns,
                                       const double *symbol, convolution **made, arc_error *error) {
  return create(rows, columns, box_rows, box_columns, EVEN_LAGS, symbol, made, error);
}

/* Computes the symbol of a kernel. Evaluates the kernel on the periodic box, transforms these
 * values, and stores the part of the transform (real or imaginary) that is not zero. */
static arc_status find_symbol(int box_rows, int box_columns, lag_parity parity, lag_fn kernel,
                              const void *context, double *symbol, arc_error *error) {
  const double up = parity & ODD_ROWS ? -1 : 1, back = parity & ODD_COLUMNS ? -1 : 1;
  const size_t part = is_imaginary(parity) ? 1 : 0;
  const size_t rows = (size_t)box_rows, columns = (size_t)box_columns, half = columns / 2 + 1;
  double *values = malloc(rows * columns * sizeof *values);
  double *spectrum = malloc(rows * half * 2 * sizeof *spectrum);
  arc_status status = ARC_MEMORY;
  if (values && spectrum) {
    for (size_t i = 0; i <= rows / 2; i++)
      for (size_t j = 0; j < half; j++) {
        const double k = kernel(context, (int)i, (int)j);
        const size_t across = (rows - i) % rows, along = (columns - j) % columns;
        values[across * columns + along] = up * back * k;
        values[across * columns + j] = up * k;
        values[i * columns + along] = back * k;
        values[i * columns + j] = k;
      }
    status = arc_transform_forward(box_rows, box_columns, values, spectrum, error);
  } else {
    arc_fail(error, ARC_MEMORY, "out of memory for a kernel of %d x %d", box_rows, box_columns);
  }
  if (status == ARC_OK)
    for (size_t k = 0; k < (rows / 2 + 1) * half; k++) symbol[k] = spectrum[2 * k + part];
  free(values);
  free(spectrum);
  return status;
}

arc_status arc_convolution_symbol(int box_rows, int box_columns, lag_fn kernel, const void *context,
                                  double *symbol, arc_error *error) {
  return find_symbol(box_rows, box_columns, EVEN_LAGS, kernel, context, symbol, error);
}

/* A kernel that is set to zero at lags larger than the window. Such lags do not affect results. */
typedef struct limited {
  lag_fn kernel;
  const void *context;
  int rows, columns;
} limited;

static double within(const void *context, int row, int column) {
  const limited *l = context;
  return row < l->rows && column < l->columns ? l->kernel(l->context, row, column) : 0;
}

arc_status arc_convolution_create(int rows, int columns, lag_parity parity, lag_fn kernel,
                                  const void *context, convolution **made, arc_error *error) {
  const limited l = {kernel, context, rows, columns};
  const int box_rows = arc_transform_length(2 * rows - 1),
            box_columns = arc_transform_length(2 * columns - 1);
  const size_t size = ((size_t)box_rows / 2 + 1) * ((size_t)box_columns / 2 + 1);
  double *symbol = malloc(size * sizeof *symbol);
  *made = NULL;
  if (!symbol)
    return arc_fail(error, ARC_MEMORY, "out of memory for a window of %d x %d cells", rows,
                    columns);
  arc_status status = find_symbol(box_rows, box_columns, parity, within, &l, symbol, error);
  if (status == ARC_OK)
    status = create(rows, columns, box_rows, box_columns, parity, symbol, made, error);
  free(symbol);
  return status;
}

/* --- application ------------------------------------------------------------------------------ */

/* load_block transforms the block of rows that begins with row `first` of p to the spectrum.
 * store_block transforms these rows of the spectrum back to u. */
static void load_block(const convolution *c, const convolution_work *w, int first, const double *p,
                       int distance) {
  const size_t n = (size_t)c->columns, stride = (size_t)c->padded;
  const int width = width_of(c->rows, first);
  double *values = w->values + (size_t)first * stride;
  for (int i = 0; i < width; i++) {
    double *row = values + (size_t)i * stride;
    memcpy(row, p + (size_t)(first + i) * (size_t)distance, n * sizeof *p);
    memset(row + n, 0, (stride - n) * sizeof *p);
  }
  fftw_execute_dft_r2c(c->into[width == block ? 0 : 1], values,
                       w->spectrum + (size_t)first * (size_t)c->stride);
}

static void store_block(const convolution *c, const convolution_work *w, int first, double *u,
                        int distance) {
  const size_t n = (size_t)c->columns, stride = (size_t)c->padded;
  const int width = width_of(c->rows, first);
  double *values = w->values + (size_t)first * stride;
  fftw_execute_dft_c2r(c->out_of[width == block ? 0 : 1],
                       w->spectrum + (size_t)first * (size_t)c->stride, values);
  for (int i = 0; i < width; i++)
    memcpy(u + (size_t)(first + i) * (size_t)distance, values + (size_t)i * stride, n * sizeof *u);
}

ARC_WIDE static void multiply(size_t count, const double *symbol, double *restrict pairs) {
  for (size_t k = 0; k < count; k++) {
    pairs[2 * k] *= symbol[k];
    pairs[2 * k + 1] *= symbol[k];
  }
}

ARC_WIDE static void turn(size_t count, const double *symbol, double *restrict pairs) {
  for (size_t k = 0; k < count; k++) {
    const double real = pairs[2 * k];
    pairs[2 * k] = -symbol[k] * pairs[2 * k + 1];
    pairs[2 * k + 1] = symbol[k] * real;
  }
}

ARC_WIDE static void multiply_pair(size_t count, const double *const symbol[3],
                                   double *restrict first, double *restrict second) {
  for (size_t k = 0; k < 2 * count; k++) {
    const double a = first[k], b = second[k];
    first[k] = symbol[0][k / 2] * a + symbol[1][k / 2] * b;
    second[k] = symbol[1][k / 2] * a + symbol[2][k / 2] * b;
  }
}

/* lower_block transforms the columns `first` to first + width - 1 of the spectrum to w->waves.
 * raise_block transforms w->waves back to these columns. */
static void lower_block(const convolution *c, fftw_complex *spectrum, convolution_work *w,
                        int first, int width) {
  const size_t tall = (size_t)c->tall, rows = (size_t)c->rows, n = (size_t)width;
  for (size_t i = 0; i < rows; i++)
    for (size_t j = 0; j < n; j++)
      memcpy(w->columns + j * tall + i, spectrum + i * (size_t)c->stride + (size_t)first + j,
             sizeof *w->columns);
  for (size_t j = 0; j < n; j++)
    memset(w->columns + j * tall + rows, 0, ((size_t)c->box_rows - rows) * sizeof *w->columns);
  fftw_execute_dft(c->down[width == block ? 0 : 1], w->columns, w->waves);
}

static void raise_block(const convolution *c, fftw_complex *spectrum, convolution_work *w,
                        int first, int width) {
  const size_t tall = (size_t)c->tall, n = (size_t)width;
  fftw_execute_dft(c->up[width == block ? 0 : 1], w->waves, w->columns);
  for (size_t i = 0; i < (size_t)c->rows; i++)
    for (size_t j = 0; j < n; j++)
      memcpy(spectrum + i * (size_t)c->stride + (size_t)first + j, w->columns + j * tall + i,
             sizeof *w->columns);
}

static const double *symbol_at(const convolution *c, int column) {
  return c->symbol + (size_t)column * (size_t)c->box_rows;
}

/* Multiplies the block of columns of the spectrum that begins with column `first` by the symbol. */
static void apply_block(const convolution *c, fftw_complex *spectrum, convolution_work *w,
                        int first) {
  const int width = width_of(c->half, first);
  lower_block(c, spectrum, w, first, width);
  for (int j = 0; j < width; j++) {
    double *wave = (double *)w->waves[j * c->tall];
    (c->imaginary ? turn : multiply)((size_t)c->box_rows, symbol_at(c, first + j), wave);
  }
  raise_block(c, spectrum, w, first, width);
}

int arc_convolution_parts(const convolution *c, int stage) {
  return ((stage == 1 ? c->half : c->rows) + block - 1) / block;
}

void arc_convolution_part(const convolution *c, convolution_work *shared, convolution_work *own,
                          int stage, int part, const double *p, double *u) {
  const int first = part * block;
  if (stage == 0) load_block(c, shared, first, p, c->columns);
  if (stage == 1) apply_block(c, shared->spectrum, own, first);
  if (stage == 2) store_block(c, shared, first, u, c->columns);
}

void arc_convolution_apply(const convolution *c, convolution_work *work, const double *p,
                           double *u) {
  arc_convolution_apply_strided(c, work, c->columns, p, u);
}

void arc_convolution_apply_strided(const convolution *c, convolution_work *work, int stride,
                                   const double *p, double *u) {
  for (int i = 0; i < c->rows; i += block) load_block(c, work, i, p, stride);
  for (int i = 0; i < c->half; i += block) apply_block(c, work->spectrum, work, i);
  for (int i = 0; i < c->rows; i += block) store_block(c, work, i, u, stride);
}

void arc_convolution_apply_pair(const convolution *const k[3], convolution_work *const work[2],
                                int stride, const double *const p[2], double *const u[2]) {
  const convolution *c = k[0];
  for (int f = 0; f < 2; f++)
    for (int i = 0; i < c->rows; i += block) load_block(c, work[f], i, p[f], stride);
  for (int first = 0; first < c->half; first += block) {
    const int width = width_of(c->half, first);
    for (int f = 0; f < 2; f++) lower_block(c, work[f]->spectrum, work[f], first, width);
    for (int j = 0; j < width; j++) {
      const double *const symbol[3] = {symbol_at(k[0], first + j), symbol_at(k[1], first + j),
                                       symbol_at(k[2], first + j)};
      multiply_pair((size_t)c->box_rows, symbol, (double *)work[0]->waves[j * c->tall],
                    (double *)work[1]->waves[j * c->tall]);
    }
    for (int f = 0; f < 2; f++) raise_block(c, work[f]->spectrum, work[f], first, width);
  }
  for (int f = 0; f < 2; f++)
    for (int i = 0; i < c->rows; i += block) store_block(c, work[f], i, u[f], stride);
}

/* --- whole boxes ------------------------------------------------------------------------------ */

static arc_status no_memory(int rows, int columns, arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a transform of %d x %d", rows, columns);
}

/* Allocates arrays with FFTW's alignment, so that the plan does not depend on the addresses of the
 * caller's arrays. */
static int begin_box(int rows, int columns, double **values, fftw_complex **spectrum) {
  fftw_make_planner_thread_safe();
  *values = fftw_malloc((size_t)rows * (size_t)columns * sizeof **values);
  *spectrum = fftw_malloc((size_t)rows * ((size_t)columns / 2 + 1) * sizeof **spectrum);
  return *values && *spectrum;
}

static void end_box(fftw_plan p, double *values, fftw_complex *spectrum) {
  destroy_plan(p);
  fftw_free(values);
  fftw_free(spectrum);
}

arc_status arc_transform_forward(int rows, int columns, const double *values, double *spectrum,
                                 arc_error *error) {
  double *from;
  fftw_complex *to;
  fftw_plan p = NULL;
  if (begin_box(rows, columns, &from, &to))
    p = fftw_plan_dft_r2c_2d(rows, columns, from, to, FFTW_ESTIMATE);
  if (p) {
    memcpy(from, values, (size_t)rows * (size_t)columns * sizeof *from);
    fftw_execute(p);
    memcpy(spectrum, to, (size_t)rows * ((size_t)columns / 2 + 1) * sizeof *to);
  }
  const int done = p != NULL;
  end_box(p, from, to);
  return done ? ARC_OK : no_memory(rows, columns, error);
}

arc_status arc_transform_back(int rows, int columns, double *spectrum, double *values,
                              arc_error *error) {
  double *to;
  fftw_complex *from;
  fftw_plan p = NULL;
  if (begin_box(rows, columns, &to, &from))
    p = fftw_plan_dft_c2r_2d(rows, columns, from, to, FFTW_ESTIMATE);
  if (p) {
    const size_t count = (size_t)rows * (size_t)columns;
    memcpy(from, spectrum, (size_t)rows * ((size_t)columns / 2 + 1) * sizeof *from);
    fftw_execute(p);
    for (size_t k = 0; k < count; k++) values[k] = to[k] / (double)count;
  }
  const int done = p != NULL;
  end_box(p, to, from);
  return done ? ARC_OK : no_memory(rows, columns, error);
}

/* --- transforms of rows only --------------------------------------------------------------- */

struct row_transform {
  size_t values, pairs; /* number of real values and of complex numbers in all rows */
  double *from;
  fftw_complex *to;
  fftw_plan forward, back;
};

void arc_rows_destroy(row_transform **transform) {
  row_transform *t = *transform;
  *transform = NULL;
  if (!t) return;
  destroy_plan(t->forward);
  destroy_plan(t->back);
  fftw_free(t->from);
  fftw_free(t->to);
  free(t);
}

row_transform *arc_rows_create(int rows, int box) {
  row_transform *t = calloc(1, sizeof *t);
  const int half = box / 2 + 1;
  if (!t) return NULL;
  fftw_make_planner_thread_safe();
  t->values = (size_t)rows * (size_t)box;
  t->pairs = (size_t)rows * (size_t)half;
  t->from = fftw_malloc(t->values * sizeof *t->from);
  t->to = fftw_malloc(t->pairs * sizeof *t->to);
  if (t->from && t->to) {
    t->forward = fftw_plan_many_dft_r2c(1, &box, rows, t->from, NULL, 1, box, t->to, NULL, 1, half,
                                        FFTW_ESTIMATE);
    t->back = fftw_plan_many_dft_c2r(1, &box, rows, t->to, NULL, 1, half, t->from, NULL, 1, box,
                                     FFTW_ESTIMATE);
  }
  if (!t->forward || !t->back) arc_rows_destroy(&t);
  return t;
}

void arc_rows_forward(row_transform *t, const double *values, double *spectrum) {
  memcpy(t->from, values, t->values * sizeof *values);
  fftw_execute(t->forward);
  memcpy(spectrum, t->to, t->pairs * sizeof *t->to);
}

void arc_rows_back(row_transform *t, const double *spectrum, double *values) {
  memcpy(t->to, spectrum, t->pairs * sizeof *t->to);
  fftw_execute(t->back);
  memcpy(values, t->from, t->values * sizeof *values);
}

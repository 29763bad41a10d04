/* Displacements due to shear on rectangular cells, and their convolutions. A unit shear force along
 * x at a point of a body with shear modulus G and Poisson's ratio nu displaces the surface at the
 * distance r (components x and z) along x by ((1 - nu) / r + nu x^2 / r^3) / (2 pi G), along z by
 * nu x z / r^3 / (2 pi G), and inwards by (1 - 2 nu) x / r^2 / (4 pi G). */
#include "core/space/cerruti.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- integrals -------------------------------------------------------------------------------- */

typedef double (*corner_fn)(double u, double v);

static double over_corners(corner_fn f, double x, double z, double a, double b) {
  return f(x + a, z + b) + f(x - a, z - b) - f(x + a, z - b) - f(x - a, z + b);
}

static double along(double u, double v) {
  return arc_space_term(v, u);
}

static double across(double u, double v) {
  return arc_space_term(u, v);
}

static double oblique(double u, double v) {
  return -hypot(u, v);
}

static double inwards(double u, double v) {
  return v * log(hypot(u, v)) + u * atan(v / u);
}

void arc_cerruti_integrals(double x, double z, double a, double b, double integral[3]) {
  integral[0] = over_corners(along, x, z, a, b);
  integral[1] = over_corners(oblique, x, z, a, b);
  integral[2] = over_corners(across, x, z, a, b);
}

double arc_cerruti_couple(double x, double z, double a, double b) {
  return over_corners(inwards, x, z, a, b);
}

/* --- compliances of the pair ------------------------------------------------------------------ */

static const double pi = 3.14159265358979323846;

static double per_shear_modulus(arc_material m) {
  return 2 * (1 + m.nu) / m.E;
}

static double couple_of(arc_material m) {
  return (1 - 2 * m.nu) * per_shear_modulus(m) / (4 * pi);
}

double arc_cerruti_unlike(const arc_halfspace_def *def) {
  static const double rounding = 1e-9; /* largest relative difference of equal materials */
  const double upper = couple_of(def->body[ARC_UPPER].material),
               lower = couple_of(def->body[ARC_LOWER].material);
  return fabs(upper - lower) > rounding * (fabs(upper) + fabs(lower)) ? upper - lower : 0;
}

enum { XX, XZ, ZZ };

static double compliance(const arc_halfspace_def *def, int which, double x, double z) {
  double integral[3], sum = 0;
  arc_cerruti_integrals(x, z, def->size_x / 2, def->size_z / 2, integral);
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_material m = def->body[b].material;
    const double shear = per_shear_modulus(m) / (2 * pi), rest = 1 - m.nu;
    if (which == XX) sum += shear * (integral[XX] + rest * integral[ZZ]);
    if (which == XZ) sum += shear * m.nu * integral[XZ];
    if (which == ZZ) sum += shear * (integral[ZZ] + rest * integral[XX]);
  }
  return sum;
}

/* --- kernels ---------------------------------------------------------------------------------- */

typedef struct lag_context {
  const arc_halfspace_def *def;
  int which;
} lag_context;

static double lag_along(const void *context, int row, int column) {
  const lag_context *c = context;
  if (c->which == XZ && (row == 0 || column == 0)) return 0;
  return compliance(c->def, c->which, row * c->def->size_x, column * c->def->size_z);
}

/* Returns the change of the gap [mm/MPa] at a distance of `row` rows and `column` columns from a
 * cell with unit shear along x (which = 0) or along z. */
static double lag_couple(const void *context, int row, int column) {
  const lag_context *c = context;
  const arc_halfspace_def *d = c->def;
  const double x = row * d->size_x, z = column * d->size_z, a = d->size_x / 2, b = d->size_z / 2;
  if ((c->which == 0 ? row : column) == 0) return 0;
  return arc_cerruti_unlike(d) *
         (c->which == 0 ? arc_cerruti_couple(x, z, a, b) : arc_cerruti_couple(z, x, b, a));
}

static arc_status fill_along(const arc_halfspace_def *d, int nx, int nz, convolution *along[3],
                             arc_error *error) {
  static const lag_parity parity[3] = {EVEN_LAGS, ODD_BOTH, EVEN_LAGS};
  arc_status status = ARC_OK;
  for (int i = 0; i < 3 && status == ARC_OK; i++) {
    const lag_context context = {d, i};
    if (along[i]) continue;
    status = arc_convolution_create(nx, nz, parity[i], lag_along, &context, &along[i], error);
  }
  return status;
}

static arc_status fill(const arc_halfspace_def *d, space_shear_kernels *k, arc_error *error) {
  static const lag_parity odd[2] = {ODD_ROWS, ODD_COLUMNS};
  arc_status status = fill_along(d, d->nx, d->nz, k->along[0][0], error);
  for (int i = 0; i < 2 && status == ARC_OK && arc_cerruti_unlike(d) != 0; i++) {
    const lag_context context = {d, i};
    status =
        arc_convolution_create(d->nx, d->nz, odd[i], lag_couple, &context, &k->couple[i], error);
  }
  if (status != ARC_OK) return status;
  k->self[0] = compliance(d, XX, 0, 0);
  k->self[1] = compliance(d, ZZ, 0, 0);
  k->work = arc_convolution_work(k->along[0][0][0]);
  return k->work ? ARC_OK : arc_fail(error, ARC_MEMORY, "out of memory for a transform");
}

static arc_status check(const arc_halfspace_def *d, arc_error *error) {
  if (d->periodic)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'friction': expected 0 on periodic surfaces, where mean shear has no "
                    "finite displacement");
  if (arc_space_thinnest(d) == 0) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'friction': expected 0 with layers or a rigid base in 3-D: the shear of "
                  "such bodies is not computed");
}

arc_status arc_cerruti_kernels(arc_halfspace *h, const space_shear_kernels **found,
                               arc_error *error) {
  arc_status status = check(&h->def, error);
  if (status != ARC_OK) return status;
  pthread_mutex_lock(&h->lock);
  if (!h->shear) {
    space_shear_kernels *k = calloc(1, sizeof *k);
    status =
        k ? fill(&h->def, k, error)
          : arc_fail(error, ARC_MEMORY, "out of memory for the influence coefficients of shear");
    if (status != ARC_OK) arc_cerruti_destroy(&k);
    h->shear = k;
  }
  *found = h->shear;
  pthread_mutex_unlock(&h->lock);
  return status;
}

/* Creates the preconditioners of shear along x and z, without the coupling between both. */
static arc_status fill_inverse(const arc_halfspace_def *d, int nx, int nz, convolution *inverse[2],
                               arc_error *error) {
  arc_status status = ARC_OK;
  for (int i = 0; i < 2 && status == ARC_OK; i++) {
    const lag_context context = {d, i == 0 ? XX : ZZ};
    if (!inverse[i])
      status = arc_space_make_inverse(nx, nz, lag_along, &context, &inverse[i], error);
  }
  return status;
}

arc_status arc_cerruti_in_box(arc_halfspace *h, const space_box *box, arc_error *error) {
  convolution **along = h->shear->along[box->level_x][box->level_z];
  convolution **inverse = h->shear->inverse[box->level_x][box->level_z];
  pthread_mutex_lock(&h->lock);
  arc_status status = fill_along(&h->def, box->nx, box->nz, along, error);
  if (status == ARC_OK) status = fill_inverse(&h->def, box->nx, box->nz, inverse, error);
  pthread_mutex_unlock(&h->lock);
  return status;
}

void arc_cerruti_destroy(space_shear_kernels **kernels) {
  space_shear_kernels *k = *kernels;
  *kernels = NULL;
  if (!k) return;
  for (int x = 0; x < SPACE_LEVELS; x++)
    for (int z = 0; z < SPACE_LEVELS; z++)
      for (int i = 0; i < 3; i++) {
        arc_convolution_destroy(&k->along[x][z][i]);
        if (i < 2) arc_convolution_destroy(&k->inverse[x][z][i]);
      }
  for (int i = 0; i < 2; i++) arc_convolution_destroy(&k->couple[i]);
  arc_convolution_work_free(&k->work);
  free(k);
}

/* --- application ------------------------------------------------------------------------------ */

void arc_cerruti_shear_in(const arc_halfspace *h, const space_box *box, const double *const q[2],
                          double *const u[2]) {
  convolution *const *k = h->shear->along[box->level_x][box->level_z];
  const convolution *const along_both[3] = {k[0], k[1], k[2]};
  convolution_work *const work[2] = {h->work[0], h->shear->work};
  const size_t from = (size_t)box->x * (size_t)h->def.nz + (size_t)box->z;
  const double *const loads[2] = {q[0] + from, q[1] + from};
  double *const moves[2] = {u[0] + from, u[1] + from};
  arc_convolution_apply_pair(along_both, work, h->def.nz, loads, moves);
}

void arc_cerruti_precondition(const arc_halfspace *h, const space_box *box, double *const r[2]) {
  convolution *const *k = h->shear->inverse[box->level_x][box->level_z];
  convolution_work *const work[2] = {h->work[0], h->shear->work};
  const size_t from = (size_t)box->x * (size_t)h->def.nz + (size_t)box->z;
  for (int i = 0; i < 2; i++)
    arc_convolution_apply_strided(k[i], work[i], h->def.nz, r[i] + from, r[i] + from);
}

void arc_cerruti_shear(const arc_halfspace *h, const double *const q[2], double *const u[2]) {
  const space_box window = arc_space_window(h);
  arc_cerruti_shear_in(h, &window, q, u);
}

void arc_cerruti_along(const arc_halfspace *h, int axis, const double *q, double *u) {
  arc_convolution_apply(h->shear->along[0][0][2 * axis], h->work[0], q, u);
}

static void add(const arc_halfspace *h, const convolution *c, const double *from, double *to) {
  double *u = h->scratch;
  arc_convolution_apply(c, h->work[0], from, u);
  for (int k = 0; k < h->cells; k++) to[k] += u[k];
}

void arc_cerruti_add_gap(const arc_halfspace *h, const double *const q[2], double *gap) {
  for (int i = 0; i < 2 && h->shear->couple[i]; i++) add(h, h->shear->couple[i], q[i], gap);
}

void arc_cerruti_add_slip(const arc_halfspace *h, const double *pressure, double *const slip[2]) {
  for (int i = 0; i < 2 && h->shear->couple[i]; i++) add(h, h->shear->couple[i], pressure, slip[i]);
}

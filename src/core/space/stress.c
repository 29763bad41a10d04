/* Computes stresses in a half-space under normal pressure, as a sum over pressure waves. */
#include "core/space/halfspace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* `widening` is the size of the periodic box divided by the size of the window. The padding reduces
 * the effect of periodic images. */
enum { widening = 4, components = 6 };

/* Wave number that represents wave number 0, divided by the smallest positive wave number of the
 * box. The value follows from the zeta function of the square lattice, because the stresses have a
 * kink at |q| = 0. */
static const double zero_wave = 0.22895;

typedef struct wave {
  double cx, cz, q; /* direction (unit vector) and wave number */
  int zero;
} wave;

/* Returns the factor from a pressure wave to a stress (0 to 5: xx, yy, zz, xy, yz, xz; tension is
 * positive) at the depth s >= 0 [mm]. If *odd is 1, the factor is imaginary. */
static double factor(const wave *w, int component, double nu, double s, int *odd) {
  const double qs = w->q * s, e = exp(-qs), xx = w->cx * w->cx, zz = w->cz * w->cz;
  *odd = component == 3 || component == 4;
  switch (component) {
  case 0:
    return -(xx * (1 - qs) + 2 * nu * zz) * e;
  case 1:
    return -(1 + qs) * e;
  case 2:
    return -(zz * (1 - qs) + 2 * nu * xx) * e;
  case 3:
    return w->zero ? 0 : -w->cx * qs * e;
  case 4:
    return w->zero ? 0 : -w->cz * qs * e;
  default:
    return w->zero ? 0 : -w->cx * w->cz * (1 - 2 * nu - qs) * e;
  }
}

static wave wave_of(int i, int j, int nx, int nz, double step_x, double step_z) {
  const double x = (i <= nx / 2 ? i : i - nx) * step_x, z = j * step_z, q = hypot(x, z);
  if (i == 0 && j == 0) return (wave){sqrt(0.5), sqrt(0.5), zero_wave * sqrt(step_x * step_z), 1};
  /* odd components are 0 at the highest wave number */
  return (wave){2 * i == nx ? 0 : x / q, 2 * j == nz ? 0 : z / q, q, 0};
}

typedef struct plane {
  int nx, nz; /* size of the box [cells] */
  double step_x, step_z;
  double *values, *pressure, *spectrum; /* [nx][nz] values; [nx][nz / 2 + 1] complex spectra of the
                                           pressure and of a stress */
} plane;

static void multiply(const plane *b, int component, double nu, double s) {
  const int half = b->nz / 2 + 1;
  for (int i = 0; i < b->nx; i++)
    for (int j = 0; j < half; j++) {
      const wave w = wave_of(i, j, b->nx, b->nz, b->step_x, b->step_z);
      int odd;
      const double f = factor(&w, component, nu, s, &odd);
      const double *p = b->pressure + 2 * (i * half + j);
      double *to = b->spectrum + 2 * (i * half + j);
      to[0] = odd ? -f * p[1] : f * p[0];
      to[1] = odd ? f * p[0] : f * p[1];
    }
}

static arc_status transform(const arc_halfspace *h, plane *b, const double *pressure,
                            arc_error *error) {
  const arc_halfspace_def *d = &h->def;
  memset(b->values, 0, (size_t)b->nx * (size_t)b->nz * sizeof *b->values);
  for (int i = 0; i < d->nx; i++)
    memcpy(b->values + (size_t)i * (size_t)b->nz, pressure + (size_t)i * (size_t)d->nz,
           (size_t)d->nz * sizeof *pressure);
  return arc_transform_forward(b->nx, b->nz, b->values, b->pressure, error);
}

static void cut(const arc_halfspace *h, const plane *b, double *stress) {
  const arc_halfspace_def *d = &h->def;
  for (int i = 0; i < d->nx; i++)
    memcpy(stress + (size_t)i * (size_t)d->nz, b->values + (size_t)i * (size_t)b->nz,
           (size_t)d->nz * sizeof *stress);
}

arc_status arc_halfspace_stress(const arc_halfspace *h, const double *pressure, double nu, double y,
                                double *stress, arc_error *error) {
  const arc_halfspace_def *d = &h->def;
  const int wide = d->periodic ? 1 : widening;
  plane b = {.nx = arc_transform_length(wide * d->nx), .nz = arc_transform_length(wide * d->nz)};
  if (!(y <= 0))
    return arc_fail(error, ARC_ARGUMENT, "field 'y': expected a number <= 0, got %g", y);
  const size_t all = (size_t)b.nx * (size_t)b.nz, half = (size_t)b.nx * ((size_t)b.nz / 2 + 1);
  b.step_x = 2 * acos(-1) / (b.nx * d->size_x);
  b.step_z = 2 * acos(-1) / (b.nz * d->size_z);
  b.values = malloc((all + 4 * half) * sizeof *b.values);
  if (!b.values)
    return arc_fail(error, ARC_MEMORY, "out of memory for stresses on %d x %d cells", b.nx, b.nz);
  b.pressure = b.values + all;
  b.spectrum = b.pressure + 2 * half;
  arc_status status = transform(h, &b, pressure, error);
  for (int k = 0; k < components && status == ARC_OK; k++) {
    multiply(&b, k, nu, -y);
    status = arc_transform_back(b.nx, b.nz, b.spectrum, b.values, error);
    if (status == ARC_OK) cut(h, &b, stress + (size_t)k * (size_t)h->cells);
  }
  free(b.values);
  return status;
}

/* Computes displacements due to pressure on rectangles: Love's solution for half-spaces, and the
 * contribution of layers. */
#include "core/elastic/layered.h"
#include "core/space/halfspace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* --- half-space ------------------------------------------------------------------------------- */

/* For v < 0 an equivalent formula is used, because ln(v + r) would lose digits by cancellation. */
double arc_space_term(double u, double v) {
  const double r = hypot(u, v);
  if (u == 0) return 0;
  return u * (v >= 0 ? log(v + r) : 2 * log(fabs(u)) - log(r - v));
}

static double corner(double u, double v) {
  return arc_space_term(u, v) + arc_space_term(v, u);
}

double arc_space_love(double x, double z, double a, double b) {
  return (corner(x + a, z + b) + corner(x - a, z - b) - corner(x + a, z - b) -
          corner(x - a, z + b)) /
         pi;
}

/* --- layers ----------------------------------------------------------------------------------- */

static int layers_of(const arc_halfspace_body *b) {
  int layers = 0;
  while (layers < ARC_MOST_LAYERS && b->layer[layers].thickness > 0) layers++;
  return layers;
}

static arc_material top_of(const arc_halfspace_body *b) {
  return layers_of(b) > 0 ? b->layer[0].material : b->material;
}

static double modulus(const arc_halfspace_body *b, double q) {
  const int layers = layers_of(b);
  double base = b->depth > 0 ? b->depth : INFINITY;
  for (int l = 0; l < layers; l++) base -= b->layer[l].thickness;
  return arc_layers_modulus(ARC_PLANE_STRAIN, b->layer, layers, base, b->material, q);
}

double arc_space_symbol(const arc_halfspace_def *def, double q) {
  return 2 / q * (1 / modulus(&def->body[0], q) + 1 / modulus(&def->body[1], q));
}

double arc_space_surface_compliance(const arc_halfspace_def *def) {
  return 1 / arc_material_E_star(top_of(&def->body[0])) +
         1 / arc_material_E_star(top_of(&def->body[1]));
}

/* Returns the thickness of the top layer, or the depth of a body without layers; 0 for a
 * homogeneous half-space. */
static double top_thickness(const arc_halfspace_body *b) {
  return layers_of(b) > 0 ? b->layer[0].thickness : b->depth;
}

double arc_space_thinnest(const arc_halfspace_def *def) {
  double thinnest = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    const double t = top_thickness(&def->body[b]);
    if (t > 0 && (thinnest == 0 || t < thinnest)) thinnest = t;
  }
  return thinnest;
}

/* A function sampled at equal steps, with cubic interpolation between the samples. */
typedef struct spline {
  int count;
  double from, step;
  double *value, *slope; /* values and their derivatives times `step` */
} spline;

static int spline_create(spline *s, int count, double from, double to) {
  *s = (spline){.count = count, .from = from, .step = (to - from) / (count - 1)};
  s->value = malloc(3 * (size_t)count * sizeof *s->value);
  s->slope = s->value ? s->value + count : NULL;
  return s->value != NULL;
}

/* Computes the slopes of a cubic spline: its second derivative is continuous, and its slope is 0 at
 * both ends. */
static void spline_finish(spline *s) {
  const int n = s->count;
  double *d = s->slope, *upper = s->slope + n;
  d[0] = upper[0] = 0;
  for (int i = 1; i < n - 1; i++) {
    const double pivot = 4 - upper[i - 1];
    upper[i] = 1 / pivot;
    d[i] = (3 * (s->value[i + 1] - s->value[i - 1]) - d[i - 1]) / pivot;
  }
  d[n - 1] = 0;
  for (int i = n - 2; i > 0; i--) d[i] -= upper[i] * d[i + 1];
}

/* Returns the interpolated value; outside the range of samples the value is constant. */
static double spline_at(const spline *s, double x) {
  const double place = fmin(fmax((x - s->from) / s->step, 0), s->count - 1);
  const int i = (int)fmin(place, s->count - 2);
  const double t = place - i, u = 1 - t, *v = s->value + i, *d = s->slope + i;
  return v[0] * u * u * (1 + 2 * t) + v[1] * t * t * (1 + 2 * u) + d[0] * t * u * u -
         d[1] * t * t * u;
}

/* Compliance of the layered bodies minus the compliance of half-spaces of the topmost materials.
 * `symbol` is the wave number q times this difference, as a function of ln q. `radial` is the
 * Hankel transform of the difference, as a function of asinh(r / t) for the distance r. */
typedef struct rest {
  double t;       /* thickness of the thinnest top layer [mm] */
  double lowest;  /* wave number below which the symbol is constant [1/mm] */
  double highest; /* wave number above which the difference is 0 [1/mm] */
  spline symbol, radial;
} rest;

enum { SYMBOL_POINTS = 1500, RADII = 400, GAUSS = 8 };

/* depth times wave number above which a wave does not reach this depth: exp(-2 deep) is
 * negligible */
static const double deep = 18;

static int sample_symbol(const arc_halfspace_def *def, rest *r) {
  const double top = 2 * arc_space_surface_compliance(def);
  if (!spline_create(&r->symbol, SYMBOL_POINTS, log(r->lowest), log(r->highest))) return 0;
  for (int k = 0; k < SYMBOL_POINTS; k++) {
    const double q = exp(r->symbol.from + k * r->symbol.step);
    r->symbol.value[k] = q * arc_space_symbol(def, q) - top;
  }
  spline_finish(&r->symbol);
  return 1;
}

/* Positive points of Gauss' rule on [-1, 1], and the weights of these points. */
static const double gauss_at[GAUSS / 2] = {0.1834346424956498, 0.5255324099163290,
                                           0.7966664774136267, 0.9602898564975363};
static const double gauss_weight[GAUSS / 2] = {0.3626837833783620, 0.3137066458778873,
                                               0.2223810344533745, 0.1012285362903763};

/* Returns the integral of `symbol` times J0(q radius) over the wave numbers q from a to b. */
static double panel(const rest *r, double radius, double a, double b) {
  const double middle = (a + b) / 2, half = (b - a) / 2;
  double sum = 0;
  for (int k = 0; k < GAUSS; k++) {
    const double at = k % 2 ? gauss_at[k / 2] : -gauss_at[k / 2], q = middle + half * at;
    sum += gauss_weight[k / 2] * spline_at(&r->symbol, log(q)) * j0(q * radius);
  }
  return half * sum;
}

/* Returns the Hankel transform at a radius [mm]. The integration panels grow with q, and each
 * panel contains at most about one wave of J0. */
static double transform(const rest *r, double radius) {
  const double ratio = 1.3, longest = radius > 0 ? 2 * pi / radius : INFINITY;
  double sum = 0, a = 0;
  while (a < r->highest) {
    const double step = fmin(fmax((ratio - 1) * a, r->lowest), longest);
    const double b = fmin(a + step, r->highest);
    sum += panel(r, radius, a, b);
    a = b;
  }
  return sum / (2 * pi);
}

static int sample_radii(rest *r, double farthest) {
  if (!spline_create(&r->radial, RADII, 0, asinh(farthest / r->t))) return 0;
  for (int k = 0; k < RADII; k++)
    r->radial.value[k] = transform(r, r->t * sinh(k * r->radial.step));
  spline_finish(&r->radial);
  return 1;
}

static double rest_at(const rest *r, double x, double z) {
  return spline_at(&r->radial, asinh(hypot(x, z) / r->t));
}

/* Returns the integral, over a cell at (x, z), of the difference from half-spaces: by Gauss' rule
 * near the origin (within six cells or six thicknesses of the layer), elsewhere from the value at
 * the middle of the cell. */
static double rest_of_cell(const arc_halfspace_def *d, const rest *r, double x, double z) {
  const double area = d->size_x * d->size_z, size = fmax(d->size_x, d->size_z);
  double sum = 0;
  if (hypot(x, z) > 6 * fmax(size, r->t)) return area * rest_at(r, x, z);
  for (int i = 0; i < GAUSS; i++)
    for (int j = 0; j < GAUSS; j++) {
      const double u = (i % 2 ? 0.5 : -0.5) * gauss_at[i / 2] * d->size_x,
                   v = (j % 2 ? 0.5 : -0.5) * gauss_at[j / 2] * d->size_z;
      sum += gauss_weight[i / 2] * gauss_weight[j / 2] * rest_at(r, x + u, z + v);
    }
  return area * sum / 4;
}

static double total_depth(const arc_halfspace_body *b) {
  double depth = b->depth;
  for (int l = 0, n = layers_of(b); l < n; l++) depth += b->layer[l].thickness;
  return depth;
}

arc_status arc_space_add_layers(const arc_halfspace_def *d, double *kernel, arc_error *error) {
  rest r = {.t = arc_space_thinnest(d)};
  if (r.t == 0) return ARC_OK;
  r.lowest = 1e-3 / fmax(total_depth(&d->body[0]), total_depth(&d->body[1]));
  r.highest = deep / r.t;
  const double farthest = hypot((d->nx + 1) * d->size_x, (d->nz + 1) * d->size_z);
  const int done = sample_symbol(d, &r) && sample_radii(&r, farthest);
  for (int i = 0; done && i < d->nx; i++)
    for (int j = 0; j < d->nz; j++)
      kernel[(size_t)i * (size_t)d->nz + (size_t)j] +=
          rest_of_cell(d, &r, i * d->size_x, j * d->size_z);
  free(r.symbol.value);
  free(r.radial.value);
  return done ? ARC_OK
              : arc_fail(error, ARC_MEMORY,
                         "out of memory for the influence coefficients of layers");
}

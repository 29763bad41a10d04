/* Computes the compliance of layered bodies under pressure waves in closed form, layer by layer
 * from the base upwards. Under a pressure cos(q x), the displacements are u sin(q x) and v cos(q
 * x), and the stresses on planes of constant depth are q tau sin(q x) and q sigma cos(q x).
 * Within a layer the vector s = (u, v, tau, sigma), a function of the depth in units of 1 / q,
 * satisfies s' = A s. The matrix A satisfies (A^2 - 1)^2 = 0, so exp(A d) has four terms. The
 * ratio of displacements to stresses is computed at the lower face and then at the upper face of
 * each layer. */
#include "core/elastic/layered.h"
#include "core/base/dense.h"
#include "core/mesh/body_shape.h"

#include <math.h>
#include <string.h>

enum {
  half = 2,
  whole = 4
}; /* half: number of displacements, and of stresses; whole: number of
      both */

/* Depth below which layers have no influence, in units of 1 / q. */
static const double deep = 20;

typedef double square[whole * whole];

/* Computes the matrix A of a material. In plane stress, E and nu replace E* and nu / (1 - nu). */
static void find_rates(arc_space space, arc_material m, square a) {
  const double G = m.E / (2 * (1 + m.nu));
  const double across = space == ARC_PLANE_STRESS ? m.nu : m.nu / (1 - m.nu);
  memset(a, 0, sizeof(square));
  a[dense_at(0, 1, whole)] = 1;
  a[dense_at(0, 2, whole)] = 1 / G;
  a[dense_at(1, 0, whole)] = -across;
  a[dense_at(1, 3, whole)] = (1 - across) / (2 * G);
  a[dense_at(2, 0, whole)] = arc_material_modulus(space, m);
  a[dense_at(2, 3, whole)] = across;
  a[dense_at(3, 2, whole)] = -1;
}

/* Computes exp(-A d) divided by exp(d). Without this division the matrix could overflow. */
static void find_transfer(const square a, double d, square up) {
  const double e = exp(-2 * d), cosh = (1 + e) / 2, sinh = -expm1(-2 * d) / 2;
  const double c[whole] = {cosh - d * sinh / 2, -(3 * sinh - d * cosh) / 2, d * sinh / 2,
                           -(d * cosh - sinh) / 2};
  square power = {0}, next;
  memset(up, 0, sizeof(square));
  for (int i = 0; i < whole; i++) power[dense_at(i, i, whole)] = 1;
  for (int k = 0; k < whole; k++) {
    for (int i = 0; i < whole * whole; i++) up[i] += c[k] * power[i];
    arc_dense_multiply(whole, whole, whole, 1, a, whole, power, whole, 0, next, whole);
    memcpy(power, next, sizeof next);
  }
}

/* Converts the compliance c (displacements per stress) on the lower face of a layer of depth d
 * to the compliance on its upper face. */
static void add_layer_above(arc_space space, arc_material m, double d, double c[half * half]) {
  square a, up;
  double displaced[half * half], pressed[half * half];
  if (d == 0) return;
  find_rates(space, m, a);
  find_transfer(a, d, up);
  for (int i = 0; i < half; i++)
    for (int j = 0; j < half; j++) {
      const size_t at = dense_at(i, j, half);
      displaced[at] = up[dense_at(i, half + j, whole)];
      pressed[at] = up[dense_at(half + i, half + j, whole)];
      for (int k = 0; k < half; k++) {
        displaced[at] += up[dense_at(i, k, whole)] * c[dense_at(k, j, half)];
        pressed[at] += up[dense_at(half + i, k, whole)] * c[dense_at(k, j, half)];
      }
    }
  const double determinant = pressed[0] * pressed[3] - pressed[1] * pressed[2];
  for (int i = 0; i < half; i++) {
    const double left = displaced[i], right = displaced[half + i];
    c[i] = (left * pressed[3] - right * pressed[1]) / determinant;
    c[half + i] = (right * pressed[0] - left * pressed[2]) / determinant;
  }
}

/* Returns the depth of a body's rigid base [mm]. Returns INFINITY for solid arcs, which are
 * treated as half-planes. */
static double depth_of(const arc_body_def *b) {
  return arc_body_is_core(b) ? INFINITY : arc_body_depth(b);
}

double arc_layers_modulus(arc_space space, const arc_layer *layer, int layers, double base,
                          arc_material own, double q) {
  double c[half * half] = {0};
  if (layers == 0 && q * base > deep) return arc_material_modulus(space, own);
  add_layer_above(space, own, fmin(q * base, deep), c);
  for (int l = layers - 1; l >= 0; l--)
    add_layer_above(space, layer[l].material, fmin(q * layer[l].thickness, deep), c);
  return -2 / c[dense_at(1, 1, half)];
}

double arc_material_modulus(arc_space space, arc_material m) {
  return space == ARC_PLANE_STRESS ? m.E : arc_material_E_star(m);
}

double arc_contact_modulus(arc_space space, const arc_material material[ARC_BODIES]) {
  return 1 / (1 / arc_material_modulus(space, material[ARC_CYLINDER]) +
              1 / arc_material_modulus(space, material[ARC_PLATE]));
}

double arc_body_modulus(arc_space space, const arc_body_def *b, arc_material own, double q) {
  const int layers = arc_body_layers(b);
  const double base = depth_of(b) - arc_body_interface(b, layers - 1);
  return arc_layers_modulus(space, b->layer, layers, base, own, q);
}

double arc_pair_modulus(arc_space space, const arc_body_def solid[ARC_BODIES],
                        const arc_material own[ARC_BODIES], double q) {
  double yields = 0;
  for (int b = 0; b < ARC_BODIES; b++) yields += 1 / arc_body_modulus(space, &solid[b], own[b], q);
  return 1 / yields;
}

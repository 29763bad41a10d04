/* Solves Hertz' elliptic contact with complete elliptic integrals, which are computed by
 * arithmetic-geometric means. */
#include "archard/space.h"

#include <math.h>

/* Computes the complete elliptic integrals K(m) and E(m) for the parameter m = e^2, where e is
 * the eccentricity. */
static void elliptic(double m, double *K, double *E) {
  double a = 1, b = sqrt(1 - m), sum = m / 2, power = 0.5;
  for (int k = 0; k < 40 && a - b > 1e-16 * a; k++) {
    const double c = (a - b) / 2, next = (a + b) / 2;
    b = sqrt(a * b);
    a = next;
    power *= 2;
    sum += power * c * c;
  }
  *K = acos(-1) / (2 * a);
  *E = *K * (1 - sum);
}

/* Returns the ratio of the radii of curvature (larger / smaller) for which the half widths of the
 * contact ellipse have the ratio s (smaller / larger). */
static double ratio_of(double s) {
  double K, E;
  elliptic(1 - s * s, &K, &E);
  return (E / (s * s) - K) / (K - E);
}

/* Returns the ratio of the half widths (smaller / larger) for a ratio of the radii of curvature
 * (larger / smaller). The logarithm of the result is computed by bisection. */
static double slimness(double ratio) {
  double low = log(1e-8), high = log(1 - 1e-9);
  if (ratio < 1 + 1e-7) return 1;
  while (high - low > 1e-15 * fabs(low)) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    if (ratio_of(exp(middle)) > ratio)
      low = middle;
    else
      high = middle;
  }
  return exp((low + high) / 2);
}

static arc_status check(const char *name, double value, arc_error *error) {
  if (isfinite(value) && value > 0) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "field '%s': expected a number above 0, got %g", name,
                  value);
}

arc_status arc_hertz_ellipse_of(double radius_x, double radius_z, double E_star, double load,
                                arc_hertz_ellipse *hertz, arc_error *error) {
  const double value[4] = {radius_x, radius_z, E_star, load};
  static const char *const name[4] = {"radius", "radius_z", "E_star", "load"};
  for (int k = 0; k < 4; k++)
    if (check(name[k], value[k], error) != ARC_OK) return ARC_ARGUMENT;
  const double pi = acos(-1), large = fmax(radius_x, radius_z), small = fmin(radius_x, radius_z);
  const double s = slimness(large / small);
  double K = pi / 2, E, share = pi / 4; /* K and share = (K - E) / m for a circle */
  if (s < 1) {
    elliptic(1 - s * s, &K, &E);
    share = (K - E) / (1 - s * s);
  }
  /* The half width a is computed from 1 / (2 large) = p0 b / E* / a^2 share, with b = s a and p0
   * = 3 load / (2 pi a b). */
  const double a = cbrt(3 * load * large * share / (pi * E_star)), b = s * a;
  hertz->p_max = 3 * load / (2 * pi * a * b);
  hertz->approach = hertz->p_max * b / E_star * K;
  hertz->half_width = radius_x >= radius_z ? a : b;
  hertz->half_width_z = radius_x >= radius_z ? b : a;
  return ARC_OK;
}

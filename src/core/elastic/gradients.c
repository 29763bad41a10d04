/* Computes the gradients of the shape functions of elements in space. */
#include "core/elastic/element.h"

#include <string.h>

static const double corner_xi[4] = {-1, 1, 1, -1}, corner_eta[4] = {-1, -1, 1, 1};

/* Computes the Jacobian of the bilinear map of a quadrilateral and returns its determinant. */
static double jacobian(const element *e, double xi, double eta, double j[2][2]) {
  memset(j, 0, 4 * sizeof(double));
  for (int c = 0; c < 4; c++) {
    const double dxi = corner_xi[c] * (1 + corner_eta[c] * eta) / 4;
    const double deta = corner_eta[c] * (1 + corner_xi[c] * xi) / 4;
    for (int d = 0; d < 2; d++) {
      j[0][d] += dxi * e->xy[c][d];
      j[1][d] += deta * e->xy[c][d];
    }
  }
  return j[0][0] * j[1][1] - j[0][1] * j[1][0];
}

static void to_space(double j[2][2], double det, double dxi, double deta, double g[2]) {
  g[0] = (j[1][1] * dxi - j[0][1] * deta) / det;
  g[1] = (-j[1][0] * dxi + j[0][0] * deta) / det;
}

double arc_quad_gradients(const element *e, double xi, double eta, double g[][2]) {
  double j[2][2];
  const double det = jacobian(e, xi, eta, j);
  for (int c = 0; c < 4; c++)
    to_space(j, det, corner_xi[c] * (1 + corner_eta[c] * eta) / 4,
             corner_eta[c] * (1 + corner_xi[c] * xi) / 4, g[c]);
  return det;
}

void arc_quad_to_space(const element *e, double xi, double eta, int n, double slope[][2],
                       double g[][2]) {
  double j[2][2];
  const double det = jacobian(e, xi, eta, j);
  for (int c = 0; c < n; c++) to_space(j, det, slope[c][0], slope[c][1], g[c]);
}

/* Computes the gradients of the bubbles 1 - xi^2 and 1 - eta^2, transformed by the Jacobian at
 * the centre of the element. */
void arc_bubble_gradients(const element *e, double xi, double eta, double det, double g[][2]) {
  double j[2][2];
  const double det0 = jacobian(e, 0, 0, j);
  to_space(j, det0, -2 * xi, 0, g[0]);
  to_space(j, det0, 0, -2 * eta, g[1]);
  for (int b = 0; b < 2; b++)
    for (int d = 0; d < 2; d++) g[b][d] *= det0 / det;
}

double arc_triangle_gradients(const element *e, double g[][2]) {
  const double(*p)[2] = e->xy;
  const double det =
      (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
  for (int c = 0; c < 3; c++) {
    const double *q = p[(c + 1) % 3], *r = p[(c + 2) % 3];
    g[c][0] = (q[1] - r[1]) / det;
    g[c][1] = (r[0] - q[0]) / det;
  }
  return det;
}

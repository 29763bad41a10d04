/* Element stiffness and stress. CPE4I adds Wilson's two incompatible modes (bubbles) and
 * condenses them. The gradients of the bubbles use the Jacobian at the centre, which satisfies
 * the patch test (Taylor's correction). */
#include "core/elastic/element.h"
#include "core/base/dense.h"

#include <math.h>
#include <string.h>

static const double corner_xi[4] = {-1, 1, 1, -1}, corner_eta[4] = {-1, -1, 1, 1};

elasticity arc_elasticity_of(arc_material m) {
  const double scale = m.E / ((1 + m.nu) * (1 - 2 * m.nu));
  const double c11 = scale * (1 - m.nu);
  return (elasticity){c11, scale * m.nu, scale * (1 - 2 * m.nu) / 2, c11, m.nu};
}

elasticity arc_elasticity_in(arc_space space, arc_material m) {
  if (space != ARC_PLANE_STRESS) return arc_elasticity_of(m);
  const double scale = m.E / (1 - m.nu * m.nu);
  return (elasticity){scale, scale * m.nu, m.E / (2 * (1 + m.nu)), scale, m.nu};
}

arc_element arc_element_for(arc_element kind, double nu) {
  if (kind != ARC_ELEMENT_AUTO) return kind;
  return nu > 0.4 ? ARC_CPE4I : ARC_CPE4;
}

double arc_elasticity_bulk(elasticity d) {
  return d.c12 + 2 * d.c33 / 3;
}

elasticity arc_elasticity_deviatoric(elasticity d) {
  const double bulk = arc_elasticity_bulk(d);
  return (elasticity){d.c11 - bulk, d.c12 - bulk, d.c33, d.c22 - bulk, d.nu};
}

element arc_element_at(const double *xy, const int corner[4], arc_element kind) {
  element e = {.corners = corner[3] < 0 ? 3 : 4, .kind = kind};
  for (int c = 0; c < e.corners; c++) memcpy(e.xy[c], &xy[2 * corner[c]], sizeof e.xy[c]);
  return e;
}

double arc_triangle_swelling(const element *e, double gradient[6]) {
  double g[3][2];
  if (e->revolved.on) return arc_revolved_swelling(e, gradient);
  const double area = arc_triangle_gradients(e, g) / 2;
  for (int c = 0; c < 6; c++) gradient[c] = area * g[c / 2][c % 2];
  return area;
}

/* Adds weight B' D B to k [2 modes x 2 modes], row-major. */
static void add_product(int modes, double g[][2], elasticity d, double weight, double *k) {
  const int n = 2 * modes;
  for (int a = 0; a < modes; a++) {
    for (int b = 0; b < modes; b++) {
      double *at = &k[2 * a * n + 2 * b];
      at[0] += weight * (d.c11 * g[a][0] * g[b][0] + d.c33 * g[a][1] * g[b][1]);
      at[1] += weight * (d.c12 * g[a][0] * g[b][1] + d.c33 * g[a][1] * g[b][0]);
      at[n] += weight * (d.c12 * g[a][1] * g[b][0] + d.c33 * g[a][0] * g[b][1]);
      at[n + 1] += weight * (d.c22 * g[a][1] * g[b][1] + d.c33 * g[a][0] * g[b][0]);
    }
  }
}

/* Computes the stiffness of a quadrilateral. `modes` is 4 (corner functions) or 6 (corner
 * functions and bubbles). */
static void quad_stiffness(const element *e, elasticity d, int modes, double *k) {
  const double at = 1 / sqrt(3);
  memset(k, 0, (size_t)(4 * modes * modes) * sizeof *k);
  for (int p = 0; p < 4; p++) {
    const double xi = at * corner_xi[p], eta = at * corner_eta[p];
    double g[6][2];
    const double det = arc_quad_gradients(e, xi, eta, g);
    if (modes > 4) arc_bubble_gradients(e, xi, eta, det, &g[4]);
    add_product(modes, g, d, det, k);
  }
}

/* Eliminates the four bubble unknowns of the 12 x 12 matrix `full`, beginning with the last one.
 * Writes the 8 x 8 stiffness of the corners to k. */
static void condense_bubbles(double *full, double *k) {
  for (int m = 11; m >= 8; m--)
    for (int r = 0; r < m; r++)
      for (int c = 0; c < m; c++)
        full[r * 12 + c] -= full[r * 12 + m] * full[m * 12 + c] / full[m * 12 + m];
  for (int r = 0; r < 8; r++) memcpy(&k[8 * r], &full[12 * r], 8 * sizeof *k);
}

void arc_element_stiffness(const element *e, elasticity d, double *k) {
  if (e->revolved.on) {
    arc_revolved_stiffness(e, d, k);
  } else if (e->corners == 3) {
    double g[3][2];
    const double det = arc_triangle_gradients(e, g);
    memset(k, 0, 36 * sizeof *k);
    add_product(3, g, d, det / 2, k);
  } else if (e->kind == ARC_CPE4I) {
    double full[144];
    quad_stiffness(e, d, 6, full);
    condense_bubbles(full, k);
  } else {
    quad_stiffness(e, d, 4, k);
  }
}

/* The same formula is used for CPE4 and CPE4I, because the bubbles have no gradient at the
 * centre. */
void arc_element_stress(const element *e, elasticity d, const double *u, double stress[3]) {
  double g[4][2], exx = 0, eyy = 0, gxy = 0;
  if (e->revolved.on) {
    arc_revolved_stress(e, d, u, stress);
    return;
  }
  if (e->corners == 3)
    arc_triangle_gradients(e, g);
  else
    arc_quad_gradients(e, 0, 0, g);
  for (int c = 0; c < e->corners; c++) {
    exx += g[c][0] * u[2 * c];
    eyy += g[c][1] * u[2 * c + 1];
    gxy += g[c][1] * u[2 * c] + g[c][0] * u[2 * c + 1];
  }
  stress[0] = d.c11 * exx + d.c12 * eyy;
  stress[1] = d.c12 * exx + d.c22 * eyy;
  stress[2] = d.c33 * gxy;
}

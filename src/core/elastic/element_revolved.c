/* Elements of revolution: rings at the distance r from the axis of the body, with the hoop strain
 * u_x / r. Triangles
 * and quadrilaterals are fully integrated. With the same dilatation in the whole element
 * (B-bar), quadrilaterals do not lock if Poisson's ratio is near 1/2. */
#include "core/elastic/element.h"

#include <math.h>
#include <string.h>

enum { components = 4, most_points = 4 }; /* strain components: rr, zz, hoop, rz */

/* An integration point and the strains there under unit displacements of the corners. */
typedef struct point {
  double weight; /* [mm3] volume that the point represents */
  double strain[8][components];
} point;

/* Computes the strains at a point. n are the shape functions of u_x and ux their gradients; uy
 * are the gradients of the shape functions of u_y. */
static void fill_strains(const element *e, const double *n, double ux[][2], double uy[][2],
                         double area, point *p) {
  double x = 0;
  for (int c = 0; c < e->corners; c++) x += n[c] * e->xy[c][0];
  const double r = e->revolved.axis + x;
  p->weight = area * arc_revolution_weight(&e->revolved, x);
  memset(p->strain, 0, sizeof p->strain);
  for (int c = 0; c < e->corners; c++) {
    double *by_x = p->strain[2 * c], *by_y = p->strain[2 * c + 1];
    by_x[0] = ux[c][0];
    by_x[2] = n[c] / r;
    by_x[3] = ux[c][1];
    by_y[1] = uy[c][1];
    by_y[3] = uy[c][0];
  }
}

static const double side[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/* Returns the correction that makes u_y linear in r^2 instead of r along the edge from corner a
 * to b. The result is four times the deviation in the middle of the edge, divided by the
 * difference of u_y between the ends. It is 0 on steep edges, on which u_y also depends on y. */
static double dip_of(const element *e, int a, int b) {
  static const double level = 0.2, steep = 0.4; /* slopes of the edge between which the correction
                                                   decreases to 0 */
  const double dr = e->xy[b][0] - e->xy[a][0], dy = e->xy[b][1] - e->xy[a][1];
  const double sum = 2 * e->revolved.axis + e->xy[a][0] + e->xy[b][0];
  if (fabs(dy) >= steep * fabs(dr)) return 0;
  return fmin(1, (steep - fabs(dy / dr)) / (steep - level)) * (dr / sum);
}

/* Adds the correction along the edge from corner a to b to `slope`, the derivatives of the
 * corner functions by xi and eta. `along` is the direction of the edge (0: xi, 1: eta). The
 * correction decreases to zero at the opposite edge. */
static void bend_edge(const element *e, int a, int b, int along, const double at[2],
                      double slope[4][2]) {
  const double s = at[along], far = side[a][1 - along], share = (1 + far * at[1 - along]) / 2;
  const double dip = dip_of(e, a, b) / 4, value = dip * (s * s - 1);
  const double by[2] = {share * dip * 2 * s,
                        far / 2 *
                            value}; /* derivatives of the correction along and across the edge */
  for (int d = 0; d < 2; d++) {
    slope[b][d] += by[d != along];
    slope[a][d] -= by[d != along];
  }
}

/* Computes an integration point of a quadrilateral. u_x is bilinear. u_y is an even function of
 * r and therefore linear in r^2 along the edges. With u_y linear in r, the element would be up
 * to 5 % too stiff under a pressure at the axis. */
static void quad_point(const element *e, double xi, double eta, point *p) {
  const double at[2] = {xi, eta};
  double n[4], ux[4][2], uy[4][2], slope[4][2];
  const double det = arc_quad_gradients(e, xi, eta, ux);
  for (int c = 0; c < 4; c++) {
    const double along = 1 + side[c][0] * xi, across = 1 + side[c][1] * eta;
    n[c] = along * across / 4;
    slope[c][0] = side[c][0] * across / 4;
    slope[c][1] = side[c][1] * along / 4;
  }
  bend_edge(e, 0, 1, 0, at, slope);
  bend_edge(e, 3, 2, 0, at, slope);
  bend_edge(e, 0, 3, 1, at, slope);
  bend_edge(e, 1, 2, 1, at, slope);
  arc_quad_to_space(e, xi, eta, 4, slope, uy);
  fill_strains(e, n, ux, uy, det, p);
}

/* Computes an integration point of a triangle, with the same correction of u_y as in
 * quadrilaterals. At this point the shape function of corner c is `own`; the shape functions of
 * the other corners are equal. */
static void triangle_point(const element *e, int c, double own, double area, point *p) {
  double n[3], ux[3][2], uy[3][2];
  arc_triangle_gradients(e, ux);
  memcpy(uy, ux, sizeof uy);
  for (int k = 0; k < 3; k++) n[k] = k == c ? own : (1 - own) / 2;
  for (int a = 0; a < 3; a++) {
    const int b = (a + 1) % 3;
    const double dip = dip_of(e, a, b);
    for (int d = 0; d < 2; d++) {
      const double by = -dip * (ux[a][d] * n[b] + n[a] * ux[b][d]);
      uy[b][d] += by, uy[a][d] -= by;
    }
  }
  fill_strains(e, n, ux, uy, area, p);
}

/* Computes the integration points of an element and returns their number. */
static int all_points(const element *e, point *p) {
  static const double at = 0.57735026918962576451;
  if (e->corners == 3) {
    double g[3][2];
    const double third = arc_triangle_gradients(e, g) / 6;
    for (int c = 0; c < 3; c++) triangle_point(e, c, 2.0 / 3, third, &p[c]);
    return 3;
  }
  for (int c = 0; c < 4; c++) quad_point(e, c == 1 || c == 2 ? at : -at, c > 1 ? at : -at, &p[c]);
  return 4;
}

static double dilatation(const double strain[components]) {
  return strain[0] + strain[1] + strain[2];
}

/* Writes to `mean` the mean dilatation of the element under a unit value of each of the n
 * displacements. Returns the volume of the element [mm3]. */
static double mean_dilatation(int n, int points, const point *p, double mean[8]) {
  double volume = 0;
  memset(mean, 0, 8 * sizeof *mean);
  for (int q = 0; q < points; q++) {
    volume += p[q].weight;
    for (int k = 0; k < n; k++) mean[k] += p[q].weight * dilatation(p[q].strain[k]);
  }
  for (int k = 0; k < n; k++) mean[k] /= volume;
  return volume;
}

static int shares_dilatation(const element *e) {
  return e->corners == 4 && e->kind == ARC_CPE4I;
}

/* Replaces the dilatation at a point by the mean dilatation. */
static void take_mean(int n, const double mean[8], point *p) {
  for (int k = 0; k < n; k++) {
    const double add = (mean[k] - dilatation(p->strain[k])) / 3;
    for (int s = 0; s < 3; s++) p->strain[k][s] += add;
  }
}

static void stress_of(elasticity d, const double strain[components], double stress[components]) {
  const double volume = d.c12 * dilatation(strain);
  for (int s = 0; s < 3; s++) stress[s] = (d.c11 - d.c12) * strain[s] + volume;
  stress[1] += (d.c22 - d.c11) * strain[1];
  stress[3] = d.c33 * strain[3];
}

static void add_point(int n, const point *p, elasticity d, double *k) {
  for (int c = 0; c < n; c++) {
    double stress[components];
    stress_of(d, p->strain[c], stress);
    for (int r = 0; r < n; r++)
      for (int s = 0; s < components; s++)
        k[r * n + c] += p->weight * (p->strain[r][s] * stress[s]);
  }
}

void arc_revolved_stiffness(const element *e, elasticity d, double *k) {
  const int n = 2 * e->corners;
  point p[most_points];
  double mean[8];
  const int points = all_points(e, p);
  memset(k, 0, (size_t)(n * n) * sizeof *k);
  mean_dilatation(n, points, p, mean);
  for (int q = 0; q < points; q++) {
    if (shares_dilatation(e)) take_mean(n, mean, &p[q]);
    add_point(n, &p[q], d, k);
  }
}

double arc_revolved_swelling(const element *e, double gradient[6]) {
  point p[most_points];
  double mean[8];
  const double volume = mean_dilatation(6, all_points(e, p), p, mean);
  for (int k = 0; k < 6; k++) gradient[k] = volume * mean[k];
  return volume;
}

void arc_revolved_stress(const element *e, elasticity d, const double *u, double stress[3]) {
  const int n = 2 * e->corners;
  point p[most_points], centre;
  double mean[8], strain[components] = {0}, all[components];
  mean_dilatation(n, all_points(e, p), p, mean);
  if (e->corners == 3)
    triangle_point(e, 0, 1.0 / 3, 1, &centre);
  else
    quad_point(e, 0, 0, &centre);
  if (shares_dilatation(e)) take_mean(n, mean, &centre);
  for (int k = 0; k < n; k++)
    for (int s = 0; s < components; s++) strain[s] += u[k] * centre.strain[k][s];
  stress_of(d, strain, all);
  stress[0] = all[0];
  stress[1] = all[1];
  stress[2] = all[3];
}

/* Computes stresses at nodes. The stresses in elements are most accurate at the centres of
 * elements (superconvergence). On the boundary, the tractions are the normal and the shear
 * stress, and the stress along the boundary is computed from the strain along the boundary,
 * which is accurate to second order. Inside the body, a quadratic polynomial around each node is
 * fitted to the stresses at element centres and at boundary nodes (patch recovery after
 * Zienkiewicz and Zhu). */
#include "core/plane/recovery.h"
#include "core/base/dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct recovery {
  const elastic_body *body;
  const arc_mesh *mesh;
  const double *xy, *u;
  int samples;         /* number of samples, first one per element, then one per node */
  double *place;       /* positions of the samples [mm] */
  double *value;       /* stresses xx, yy, xy of the samples [MPa] */
  int *known;          /* for each sample, true if its stress has been computed */
  int *start, *around; /* elements around each node: index of its first element, and list of
                          elements */
  int *seen;           /* for each sample, 1 + index of the last node whose patch contains it */
  int *patch;          /* indices of the samples in the present patch */
} recovery;

static void recovery_free(recovery *r) {
  free(r->place);
  free(r->known);
  *r = (recovery){0};
}

static arc_status recovery_create(const elastic_body *body, const double *xy, const double *u,
                                  recovery *r) {
  const arc_mesh *m = body->mesh;
  *r = (recovery){.body = body, .mesh = m, .xy = xy, .u = u, .samples = m->elements + m->nodes};
  const size_t n = (size_t)r->samples;
  r->place = calloc(5 * n, sizeof *r->place);
  r->known = calloc(3 * n + (size_t)m->nodes + 1 + 4 * (size_t)m->elements, sizeof *r->known);
  if (!r->place || !r->known) {
    recovery_free(r);
    return ARC_MEMORY;
  }
  r->value = r->place + 2 * n;
  r->seen = r->known + n;
  r->patch = r->seen + n;
  r->start = r->patch + n;
  r->around = r->start + m->nodes + 1;
  return ARC_OK;
}

static void list_elements_around(recovery *r) {
  const arc_mesh *m = r->mesh;
  for (int e = 0; e < m->elements; e++)
    for (int c = 0; c < arc_mesh_corners(m, e); c++) r->start[m->element[4 * e + c]]++;
  for (int n = 0; n < m->nodes; n++) r->start[n + 1] += r->start[n];
  for (int e = m->elements - 1; e >= 0; e--)
    for (int c = 0; c < arc_mesh_corners(m, e); c++)
      r->around[--r->start[m->element[4 * e + c]]] = e;
}

/* --- stresses at the elements ----------------------------------------------------------------- */

static element element_with(const recovery *r, int e, double u[8]) {
  const int *corner = &r->mesh->element[4 * e];
  const element el = arc_body_element(r->body, r->xy, corner);
  for (int c = 0; c < el.corners; c++) memcpy(&u[2 * c], &r->u[2 * corner[c]], 2 * sizeof *u);
  return el;
}

static void sample_element(recovery *r, int e) {
  double u[8];
  const element el = element_with(r, e, u);
  arc_element_stress(&el, arc_body_elasticity(r->body, e), u, &r->value[3 * e]);
  for (int c = 0; c < el.corners; c++)
    for (int d = 0; d < 2; d++) r->place[2 * e + d] += el.xy[c][d] / el.corners;
  r->known[e] = 1;
}

/* Returns the change of a triangle's area [mm2] due to the displacements, and adds the area of the
 * triangle to *area. */
static double swelling_of(const recovery *r, int e, double *area) {
  double u[8], gradient[6], change = 0;
  const element el = element_with(r, e, u);
  *area += arc_triangle_swelling(&el, gradient);
  for (int k = 0; k < 6; k++) change += gradient[k] * u[k];
  return change;
}

/* Sets the hydrostatic stresses of all triangles in a cell to the same value, computed from the
 * dilatation of the cell. */
static void share_dilatation(recovery *r, int e, int triangles) {
  const double bulk = arc_elasticity_bulk(arc_body_elasticity(r->body, e));
  double area = 0, change = 0;
  for (int t = e; t < e + 2 * triangles; t += 2) change += swelling_of(r, t, &area);
  for (int t = e; t < e + 2 * triangles; t += 2) {
    double own = 0;
    const double grown = swelling_of(r, t, &own);
    for (int s = 0; s < 2; s++) r->value[3 * t + s] += bulk * (change / area - grown / own);
  }
}

static void sample_elements(recovery *r) {
  for (int e = 0; e < r->mesh->elements; e++) sample_element(r, e);
  for (int e = r->mesh->box_elements; e < r->mesh->elements; e++) {
    const int triangles = arc_body_cell(r->body, e);
    if (triangles > 1) share_dilatation(r, e, triangles);
  }
}

/* --- boundary stresses ------------------------------------------------------------------------ */

/* The boundary as a closed polygon. Edge k connects boundary node k with the next boundary node. */
typedef struct boundary {
  int count;
  double *p, *q;  /* tractions at the nodes: pressure, and shear along the boundary [MPa] */
  double *load;   /* force on each node divided by its tributary width [MPa] */
  double *bend;   /* second difference of `load` at each node [MPa] */
  double *length; /* length of each edge [mm] */
  double *rest;   /* stress along each edge without the local effect of pressure [MPa] */
  double *cusp;   /* stress along the boundary at each node minus the mean stress of its two edges
                     [MPa] */
  double *work;   /* workspace for the tractions at all nodes */
} boundary;

static int next_of(const boundary *o, int k) {
  return k + 1 < o->count ? k + 1 : 0;
}

static int last_of(const boundary *o, int k) {
  return k > 0 ? k - 1 : o->count - 1;
}

/* Coefficients of the stress along an edge without the local effect of pressure. This stress is
 * `modulus` times the strain along the edge plus `around` times the hoop strain plus `load`
 * times the pressure. */
typedef struct edge_law {
  double modulus, around, load;
} edge_law;

/* Returns the element that contains the edge between two boundary nodes. */
static int element_at(const recovery *r, int a, int b) {
  for (int k = r->start[a]; k < r->start[a + 1]; k++) {
    const int *corner = &r->mesh->element[4 * r->around[k]];
    for (int c = 0; c < arc_mesh_corners(r->mesh, r->around[k]); c++)
      if (corner[c] == b) return r->around[k];
  }
  return r->around[r->start[a]];
}

/* Returns the stress coefficients of an edge for the material of its element. */
static edge_law law_between(const recovery *r, int a, int b) {
  const arc_material top = arc_body_layer_material(
      &r->mesh->solid, r->mesh->layer[element_at(r, a, b)], r->body->material);
  const double nu = top.nu, modulus = arc_material_E_star(top);
  if (r->body->space == ARC_PLANE_STRESS) return (edge_law){top.E, 0, 1 - nu};
  const double around = r->body->space == ARC_AXISYMMETRIC ? nu * modulus : 0;
  return (edge_law){modulus, around, (1 - 2 * nu) / (1 - nu)};
}

/* Returns the mean hoop strain at two nodes. */
static double strain_around(const recovery *r, int a, int b) {
  const double radius = r->body->chart.revolved.axis + (r->xy[2 * a] + r->xy[2 * b]) / 2;
  return radius != 0 ? (r->u[2 * a] + r->u[2 * b]) / 2 / radius : 0;
}

/* Computes `rest`, the stress along each edge without the local effect of pressure. On a
 * half-plane, a pressure p causes the strain -(1 - 2 nu)(1 + nu) p / E along the surface, but
 * only at the loaded points. This strain is due to the stress -p along the surface. The
 * remaining stress is due to distant loads and is smooth, even where the pressure ends. */
static void split_edges(const recovery *r, boundary *o) {
  const int *node = r->mesh->outline_node;
  for (int k = 0; k < o->count; k++) {
    const double *a = &r->xy[2 * node[k]], *b = &r->xy[2 * node[next_of(o, k)]];
    const double *ua = &r->u[2 * node[k]], *ub = &r->u[2 * node[next_of(o, k)]];
    const edge_law law = law_between(r, node[k], node[next_of(o, k)]);
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double strain = ((ub[0] - ua[0]) * dx + (ub[1] - ua[1]) * dy) / (dx * dx + dy * dy);
    o->length[k] = hypot(dx, dy);
    o->rest[k] = law.modulus * strain + law.load * (o->load[k] + o->load[next_of(o, k)]) / 2;
    if (law.around != 0) o->rest[k] += law.around * strain_around(r, node[k], node[next_of(o, k)]);
    o->bend[k] = o->load[next_of(o, k)] - 2 * o->load[k] + o->load[last_of(o, k)];
  }
}

static double mean_bend(const boundary *o, int k) {
  return (o->bend[k] + o->bend[next_of(o, k)]) / 2;
}

/* Corrects an error of `rest`: the elements smooth the local strain. The error is a multiple of
 * the second difference of the pressure, with the same factor along a uniform surface. The
 * factor is computed so that the sum of the squared second differences of `rest` is smallest. */
static void sharpen(boundary *o) {
  double across = 0, square = 0;
  for (int k = 0; k < o->count; k++) {
    const int a = last_of(o, k), b = next_of(o, k);
    if (o->load[k] == 0 && o->load[b] == 0 && o->load[a] == 0) continue;
    const double rough = o->rest[a] - 2 * o->rest[k] + o->rest[b];
    const double source = mean_bend(o, a) - 2 * mean_bend(o, k) + mean_bend(o, b);
    across += rough * source;
    square += source * source;
  }
  const double share = square > 0 ? fmax(-0.5, fmin(0.5, across / square)) : 0;
  for (int k = 0; k < o->count; k++) o->rest[k] -= share * mean_bend(o, k);
}

/* Computes the stress at boundary node k from its two edges. Corners are skipped, because a
 * corner has no tangent. */
static void sample_boundary_node(recovery *r, const boundary *o, int k) {
  static const double straight = 0.9; /* smallest cosine of the angle between two edges that do
                                         not form a corner */
  const int *node = r->mesh->outline_node, before = last_of(o, k), at = node[k];
  const double la = o->length[before], lb = o->length[k];
  const double *a = &r->xy[2 * node[before]], *x = &r->xy[2 * at],
               *b = &r->xy[2 * node[next_of(o, k)]];
  double t[2], cosine = 0;
  for (int d = 0; d < 2; d++) {
    cosine += (x[d] - a[d]) / la * (b[d] - x[d]) / lb;
    t[d] = (x[d] - a[d]) / la * lb + (b[d] - x[d]) / lb * la;
  }
  if (cosine < straight) return;
  const double length = hypot(t[0], t[1]), tx = t[0] / length, ty = t[1] / length;
  const double rest = (o->rest[before] * lb + o->rest[k] * la) / (la + lb) + o->cusp[k];
  const double along = rest - o->p[k];
  const int s = r->mesh->elements + at;
  r->place[2 * s] = x[0];
  r->place[2 * s + 1] = x[1];
  r->value[3 * s] = along * tx * tx - o->p[k] * ty * ty + 2 * o->q[k] * tx * ty;
  r->value[3 * s + 1] = along * ty * ty - o->p[k] * tx * tx - 2 * o->q[k] * tx * ty;
  r->value[3 * s + 2] = (along + o->p[k]) * tx * ty + o->q[k] * (ty * ty - tx * tx);
  r->known[s] = 1;
}

/* Copies the tractions in the order of the boundary nodes. The body is on the left of the
 * boundary, which runs along +x on the cylinder's surface and along -x on the plate's surface. */
static void read_tractions(const arc_mesh *m, const surface_traction *traction, boundary *o) {
  double *normal = o->work, *shear = normal + m->nodes, *load = shear + m->nodes;
  double *cusp = load + m->nodes;
  const double sign = m->body == ARC_CYLINDER ? 1 : -1;
  for (int i = 0; i < m->surface; i++) {
    normal[m->surface_node[i]] = traction->normal[i];
    load[m->surface_node[i]] = traction->load[i];
    if (traction->tangential) shear[m->surface_node[i]] = sign * traction->tangential[i];
    if (traction->cusp) cusp[m->surface_node[i]] = traction->cusp[i];
  }
  for (int k = 0; k < o->count; k++) {
    o->p[k] = normal[m->outline_node[k]];
    o->q[k] = shear[m->outline_node[k]];
    o->load[k] = load[m->outline_node[k]];
    o->cusp[k] = cusp[m->outline_node[k]];
  }
}

static void sample_boundary(recovery *r, boundary *o, const surface_traction *traction) {
  const arc_mesh *m = r->mesh;
  double *fixed = o->work + 4 * (size_t)m->nodes;
  for (int k = 0; k < m->fixed; k++) fixed[m->fixed_node[k]] = 1;
  read_tractions(m, traction, o);
  split_edges(r, o);
  sharpen(o);
  for (int k = 0; k < o->count; k++)
    if (fixed[m->outline_node[k]] == 0) sample_boundary_node(r, o, k);
}

static arc_status make_boundary(recovery *r, const surface_traction *traction) {
  const size_t n = (size_t)r->mesh->outline, nodes = (size_t)r->mesh->nodes;
  double *block = calloc(7 * n + 5 * nodes, sizeof *block);
  if (!block) return ARC_MEMORY;
  boundary o = {.count = (int)n};
  double **member[] = {&o.p, &o.q, &o.load, &o.bend, &o.length, &o.rest, &o.cusp, &o.work};
  for (size_t k = 0; k < sizeof member / sizeof *member; k++) *member[k] = block + k * n;
  sample_boundary(r, &o, traction);
  free(block);
  return ARC_OK;
}

/* --- patches ---------------------------------------------------------------------------------- */

static void take(recovery *r, int sample, int node, int *count) {
  if (!r->known[sample] || r->seen[sample] == node + 1) return;
  r->seen[sample] = node + 1;
  r->patch[(*count)++] = sample;
}

static void take_around(recovery *r, int at, int node, int *count) {
  for (int k = r->start[at]; k < r->start[at + 1]; k++) take(r, r->around[k], node, count);
}

/* Collects the samples of a patch: the elements around a node, the elements around the corners
 * of these elements, and those corners that are boundary nodes. Returns their number. Sets
 * *reach to the distance [mm] of the farthest adjacent element. */
static int gather_patch(recovery *r, int node, double *reach) {
  const arc_mesh *m = r->mesh;
  int count = 0;
  take_around(r, node, node, &count);
  const int inner = count;
  *reach = 0;
  for (int k = 0; k < inner; k++) {
    const int e = r->patch[k];
    *reach = fmax(*reach, hypot(r->place[2 * e] - r->xy[2 * node],
                                r->place[2 * e + 1] - r->xy[2 * node + 1]));
    for (int c = 0; c < arc_mesh_corners(m, e); c++)
      take_around(r, m->element[4 * e + c], node, &count);
  }
  const int all = count;
  for (int k = 0; k < all; k++)
    for (int c = 0; c < arc_mesh_corners(m, r->patch[k]); c++)
      take(r, m->elements + m->element[4 * r->patch[k] + c], node, &count);
  return count;
}

enum { terms = 6 };

/* Computes the weighted normal equations of a polynomial with the terms 1, x, y, x2, xy, y2,
 * where x and y are distances from the node divided by `reach`. */
static void normal_equations(const recovery *r, int node, int count, double reach,
                             double a[terms * terms], double b[terms * 3]) {
  memset(a, 0, terms * terms * sizeof *a);
  memset(b, 0, terms * 3 * sizeof *b);
  for (int k = 0; k < count; k++) {
    const double *at = &r->place[2 * r->patch[k]], *value = &r->value[3 * r->patch[k]];
    const double x = (at[0] - r->xy[2 * node]) / reach, y = (at[1] - r->xy[2 * node + 1]) / reach;
    const double term[terms] = {1, x, y, x * x, x * y, y * y}, weight = exp(-x * x - y * y);
    for (int i = 0; i < terms; i++) {
      for (int j = 0; j < terms; j++) a[dense_at(i, j, terms)] += weight * term[i] * term[j];
      for (int s = 0; s < 3; s++) b[dense_at(i, s, terms)] += weight * term[i] * value[s];
    }
  }
}

/* Solves for the constant terms of a fit with the first n terms. The constant terms are the
 * stresses at the node. Returns 0 if the samples do not determine the fit. */
static int solve_fit(int n, const double *a, const double *b, double stress[3]) {
  double l[terms * terms], x[terms * 3];
  memcpy(l, a, sizeof l);
  memcpy(x, b, sizeof x);
  if (arc_dense_cholesky(n, l, terms)) return 0;
  for (int i = 0; i < n; i++) {
    const double pivot = l[dense_at(i, i, terms)];
    if (pivot * pivot < 1e-6 * a[dense_at(i, i, terms)]) return 0;
  }
  arc_dense_cholesky_solve(n, 3, l, terms, x, terms);
  for (int s = 0; s < 3; s++) stress[s] = x[dense_at(0, s, terms)];
  return 1;
}

static void fit_node(recovery *r, int node, double stress[3]) {
  double reach, a[terms * terms], b[terms * 3];
  const int count = gather_patch(r, node, &reach);
  normal_equations(r, node, count, reach, a, b);
  if (count > terms && solve_fit(terms, a, b, stress)) return;
  if (count > 3 && solve_fit(3, a, b, stress)) return;
  solve_fit(1, a, b, stress);
}

static void fit_inside(recovery *r, double *stress) {
  for (int n = 0; n < r->mesh->nodes; n++)
    if (!r->known[r->mesh->elements + n]) fit_node(r, n, &stress[3 * n]);
}

static void take_boundary(const recovery *r, double *stress) {
  for (int n = 0; n < r->mesh->nodes; n++) {
    const int own = r->mesh->elements + n;
    if (r->known[own]) memcpy(&stress[3 * n], &r->value[3 * own], 3 * sizeof *stress);
  }
}

/* Fits the stresses inside the body to boundary stresses from the nodal forces, which are
 * consistent with the elements. Then replaces the stresses at boundary nodes by values from the
 * pressures at points. */
arc_status arc_recover_stresses(const elastic_body *body, const double *xy, const double *u,
                                const surface_traction *traction, double *stress) {
  recovery r;
  surface_traction answered = *traction;
  answered.normal = traction->load;
  answered.cusp = NULL;
  arc_status status = recovery_create(body, xy, u, &r);
  if (status != ARC_OK) return status;
  list_elements_around(&r);
  sample_elements(&r);
  status = make_boundary(&r, &answered);
  if (status == ARC_OK) fit_inside(&r, stress);
  if (status == ARC_OK) status = make_boundary(&r, traction);
  if (status == ARC_OK) take_boundary(&r, stress);
  recovery_free(&r);
  return status;
}

/* Reads a pair of bodies from a Gmsh file: converts node numbers to indices, builds both meshes,
 * and checks the relative position of the bodies. */
#include "core/mesh/gmsh_body.h"
#include "core/mesh/gmsh_groups.h"

#include <math.h>
#include <stdlib.h>

/* --- node numbers ----------------------------------------------------------------------------- */

typedef struct numbered {
  long long tag;
  int index;
} numbered;

static int compare_numbered(const void *a, const void *b) {
  const numbered *p = a, *q = b;
  return (p->tag > q->tag) - (p->tag < q->tag);
}

static arc_status find_corners(const msh_file *f, const numbered *list, msh_element *e,
                               arc_error *error) {
  const int corners = e->type == MSH_LINE ? 2 : e->type == MSH_TRIANGLE ? 3 : 4;
  if (e->type > MSH_QUAD)
    return ARC_OK; /* the reader does not store corners for elements of higher order */
  for (int c = 0; c < corners; c++) {
    const numbered wanted = {.tag = e->corner[c]};
    const numbered *at = f->nodes.count > 0 ? bsearch(&wanted, list, (size_t)f->nodes.count,
                                                      sizeof wanted, compare_numbered)
                                            : NULL;
    if (!at)
      return arc_fail(error, ARC_GEOMETRY,
                      "%s: element %lld refers to node %lld, which does not exist", f->text.path,
                      e->tag, e->corner[c]);
    e->corner[c] = at->index;
  }
  return ARC_OK;
}

/* Replaces the node numbers in the corners of elements by indices. Error: ARC_GEOMETRY if two
 * nodes have the same number. */
static arc_status index_corners(msh_file *f, arc_error *error) {
  const msh_node *node = f->nodes.data;
  numbered *list = malloc(((size_t)f->nodes.count + 1) * sizeof *list);
  if (!list) return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", f->text.path);
  for (int n = 0; n < f->nodes.count; n++) list[n] = (numbered){node[n].tag, n};
  qsort(list, (size_t)f->nodes.count, sizeof *list, compare_numbered);
  arc_status status = ARC_OK;
  for (int n = 1; status == ARC_OK && n < f->nodes.count; n++)
    if (list[n].tag == list[n - 1].tag)
      status = arc_fail(error, ARC_GEOMETRY, "%s: two nodes have the number %lld", f->text.path,
                        list[n].tag);
  msh_element *e = f->elements.data;
  for (int i = 0; status == ARC_OK && i < f->elements.count; i++)
    status = find_corners(f, list, &e[i], error);
  free(list);
  return status;
}

/* --- relative position of the bodies ---------------------------------------------------------- */

static const double *surface_at(const arc_mesh *m, int i) {
  return &m->xy[2 * m->surface_node[i]];
}

/* Returns the height of a surface at x by linear interpolation between surface nodes, or NAN
 * outside the surface. The search begins at edge *i; *i is set to the edge at x. */
static double height_at(const arc_mesh *m, double x, int *i) {
  while (*i + 2 < m->surface && surface_at(m, *i + 1)[0] < x) ++*i;
  const double *p = surface_at(m, *i), *q = surface_at(m, *i + 1);
  if (!(x >= p[0] && x <= q[0])) return NAN;
  return p[1] + (q[1] - p[1]) * ((x - p[0]) / (q[0] - p[0]));
}

/* Reduces *gap to the smallest gap between the surface nodes of `m` and the surface of `other`
 * [mm], and sets *x to its position. Changes nothing if *gap is already smaller. */
static void least_gap(const arc_mesh *m, const arc_mesh *other, double *gap, double *x) {
  const double sign = m->body == ARC_CYLINDER ? 1 : -1;
  int edge = 0;
  for (int i = 0; i < m->surface; i++) {
    const double *at = surface_at(m, i);
    const double here = sign * (at[1] - height_at(other, at[0], &edge));
    if (here < *gap) *gap = here, *x = at[0];
  }
}

/* Checks that the bodies touch. A gap of up to `limit` is accepted, because the first point of
 * contact may be between nodes. */
static arc_status check_gap(const char *path, arc_mesh *const mesh[ARC_BODIES], arc_error *error) {
  double gap = INFINITY, x = 0;
  for (int b = 0; b < ARC_BODIES; b++) least_gap(mesh[b], mesh[1 - b], &gap, &x);
  const double limit = 0.02 * fmax(mesh[0]->def.size, mesh[1]->def.size);
  if (!isfinite(gap))
    return arc_fail(error, ARC_GEOMETRY,
                    "%s: the contact curves do not face each other: 'upper' from x = %.6g to %.6g "
                    "mm, 'lower' from %.6g to %.6g mm",
                    path, surface_at(mesh[0], 0)[0], surface_at(mesh[0], mesh[0]->surface - 1)[0],
                    surface_at(mesh[1], 0)[0], surface_at(mesh[1], mesh[1]->surface - 1)[0]);
  if (fabs(gap) <= limit) return ARC_OK;
  return arc_fail(
      error, ARC_GEOMETRY,
      "%s: the bodies %s by %.6g mm at x = %.6g mm; expected bodies that touch (to %.2g "
      "mm): move 'upper' by %.9g mm along y",
      path, gap > 0 ? "are apart" : "overlap", fabs(gap), x, limit, -gap);
}

/* Fits the parabola gap = c + b x + x^2 / (2 R) to the gap between both surfaces by least
 * squares and returns R [mm]. R is computed from the second Legendre polynomial about the
 * middle, which is orthogonal to c + b x. */
static double fit_radius(const arc_mesh *upper, const arc_mesh *lower) {
  static const double flattest = 1e6;
  const double from = fmax(surface_at(upper, 0)[0], surface_at(lower, 0)[0]);
  const double to =
      fmin(surface_at(upper, upper->surface - 1)[0], surface_at(lower, lower->surface - 1)[0]);
  enum { samples = 201 };
  double weight = 0, sum = 0;
  int above = 0, below = 0;
  for (int k = 0; k < samples; k++) {
    const double t = 2.0 * k / (samples - 1) - 1, x = (from + to) / 2 + t * (to - from) / 2;
    const double gap = height_at(upper, x, &above) - height_at(lower, x, &below);
    const double legendre = t * t - (samples + 1.0) / (3.0 * (samples - 1));
    if (!isfinite(gap)) continue;
    sum += legendre * gap;
    weight += legendre * t * t;
  }
  const double half = (to - from) / 2, curvature = 2 * sum / weight / (half * half);
  return curvature > 1 / flattest ? 1 / curvature : flattest;
}

/* --- the pair --------------------------------------------------------------------------------- */

static arc_status make_bodies(msh_file *f, arc_mesh *mesh[ARC_BODIES], arc_error *error) {
  signed char *owner = malloc((size_t)f->nodes.count + 1);
  if (!owner) return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", f->text.path);
  for (int n = 0; n < f->nodes.count; n++) owner[n] = -1;
  arc_status status = ARC_OK;
  for (int b = 0; status == ARC_OK && b < ARC_BODIES; b++)
    status = arc_msh_body(f, (arc_body)b, owner, &mesh[b], error);
  free(owner);
  return status;
}

static arc_status make_pair(msh_file *f, arc_mesh *mesh[ARC_BODIES], arc_error *error) {
  arc_status status = arc_msh_sort_groups(f, error);
  if (status == ARC_OK) status = index_corners(f, error);
  if (status == ARC_OK) status = make_bodies(f, mesh, error);
  if (status == ARC_OK) status = check_gap(f->text.path, mesh, error);
  if (status != ARC_OK) return status;
  const double radius = fit_radius(mesh[ARC_CYLINDER], mesh[ARC_PLATE]);
  for (int b = 0; b < ARC_BODIES; b++) {
    mesh[b]->radius = radius;
    mesh[b]->def.zone[1 - b] = mesh[1 - b]->def.zone[1 - b];
  }
  return ARC_OK;
}

/* Reads a file and builds the meshes of both bodies. After an error neither mesh exists (NULL). */
static arc_status read_pair(msh_file *file, arc_mesh *mesh[ARC_BODIES], arc_error *error) {
  arc_status status = arc_msh_read(file, error);
  if (status != ARC_OK) return status;
  status = make_pair(file, mesh, error);
  arc_msh_free(file);
  if (status != ARC_OK)
    for (int b = 0; b < ARC_BODIES; b++) arc_mesh_destroy(&mesh[b]);
  return status;
}

arc_status arc_mesh_read_msh(const char *path, arc_mesh *mesh[ARC_BODIES], arc_error *error) {
  msh_file file = {0};
  for (int b = 0; b < ARC_BODIES; b++) mesh[b] = NULL;
  const arc_status status = arc_msh_open(&file.text, path, error);
  return status == ARC_OK ? read_pair(&file, mesh, error) : status;
}

arc_status arc_mesh_parse_msh(const char *name, const char *text, size_t length,
                              arc_mesh *mesh[ARC_BODIES], arc_error *error) {
  msh_file file = {0};
  for (int b = 0; b < ARC_BODIES; b++) mesh[b] = NULL;
  const arc_status status = arc_msh_copy(&file.text, name, text, length, error);
  return status == ARC_OK ? read_pair(&file, mesh, error) : status;
}

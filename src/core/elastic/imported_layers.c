/* Determines the layers below the surface of an imported mesh: for each surface node, the range
 * of each layer along z of the chart. */
#include "core/elastic/imported_layers.h"
#include "core/base/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Part of an element below a surface node, as a range of depths [mm]. */
typedef struct piece {
  int node, layer;
  double from, to;
} piece;

typedef struct search {
  const elastic_body *body;
  double *sz; /* positions of all nodes of the mesh in the chart */
  double tiny;
  item_list pieces;
} search;

static int compare_pieces(const void *a, const void *b) {
  const piece *p = a, *q = b;
  if (p->node != q->node) return p->node < q->node ? -1 : 1;
  if (p->from != q->from) return p->from < q->from ? -1 : 1;
  return (p->layer > q->layer) - (p->layer < q->layer);
}

/* --- elements --------------------------------------------------------------------------------- */

static const double *corner(const search *f, int e, int k) {
  return &f->sz[2 * f->body->mesh->element[4 * e + k]];
}

/* Computes the extent of an element along s [mm]. */
static void reach(const search *f, int e, double *low, double *high) {
  *low = *high = corner(f, e, 0)[0];
  for (int k = 1; k < arc_mesh_corners(f->body->mesh, e); k++) {
    *low = fmin(*low, corner(f, e, k)[0]);
    *high = fmax(*high, corner(f, e, k)[0]);
  }
}

/* If the edge from p to q crosses the position s, extends the range low .. high so that it contains
 * the z of the edge at s. */
static void cut_edge(const double *p, const double *q, double s, double *low, double *high) {
  if (s < fmin(p[0], q[0]) || s > fmax(p[0], q[0])) return;
  const double z = p[0] == q[0] ? p[1] : p[1] + (q[1] - p[1]) * ((s - p[0]) / (q[0] - p[0]));
  *low = fmin(*low, z);
  *high = fmax(*high, z);
}

/* Adds the part of element e below surface node i to the list of parts. Returns 0 if memory is
 * exhausted. */
static int cut_element(search *f, int e, int i) {
  const arc_mesh *m = f->body->mesh;
  const int corners = arc_mesh_corners(m, e);
  const double *top = arc_body_top(f->body, i), up = m->body == ARC_UPPER ? 1 : -1;
  double low = INFINITY, high = -INFINITY;
  for (int k = 0; k < corners; k++)
    cut_edge(corner(f, e, k), corner(f, e, (k + 1) % corners), top[0], &low, &high);
  const double from = up > 0 ? low - top[1] : top[1] - high, to = from + (high - low);
  if (!(high - low > f->tiny) || to <= f->tiny) return 1;
  piece *found = arc_list_add(&f->pieces, sizeof *found);
  if (found) *found = (piece){.node = i, .layer = m->layer[e], .from = from, .to = to};
  return found != NULL;
}

/* Returns the index of the first surface node whose position is at least s. */
static int first_from(const search *f, double s) {
  int low = 0, high = f->body->mesh->surface;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (arc_body_top(f->body, middle)[0] < s)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

/* Collects the parts of all elements below the surface nodes. Skips elements on the opposite
 * side of a hole, at which s is discontinuous, because they are far from the surface. Returns 0
 * if memory is exhausted. */
static int find_pieces(search *f) {
  const arc_mesh *m = f->body->mesh;
  for (int e = 0; e < m->elements; e++) {
    double low, high;
    reach(f, e, &low, &high);
    if (f->body->chart.polar && high - low > f->body->chart.radius) continue;
    for (int i = first_from(f, low); i < m->surface && arc_body_top(f->body, i)[0] <= high; i++)
      if (!cut_element(f, e, i)) return 0;
  }
  return 1;
}

/* --- layers -------------------------------------------------------------------------------- */

/* Merges the parts below each node into layers. Parts on a common edge of two elements occur
 * twice; the duplicates are removed. */
static void join_pieces(const search *f, elastic_body *b) {
  const piece *list = f->pieces.data;
  int at = 0, count = 0;
  for (int i = 0; i < b->mesh->surface; i++) {
    double covered = 0;
    const int first = b->stratum_start[i] = count;
    for (; at < f->pieces.count && list[at].node == i; at++) {
      const piece *p = &list[at];
      if (p->to <= covered + f->tiny) continue;
      if (count == first || b->stratum[count - 1].layer != p->layer)
        b->stratum[count++] = (stratum){.layer = p->layer};
      b->stratum[count - 1].end = covered = p->to;
    }
    if (count == first) b->stratum[count++] = (stratum){.layer = arc_body_layers(&b->mesh->solid)};
    b->stratum[count - 1].end = INFINITY;
  }
}

static int prepare(search *f) {
  const arc_mesh *m = f->body->mesh;
  f->sz = malloc(2 * (size_t)m->nodes * sizeof *f->sz);
  if (!f->sz) return 0;
  arc_chart_from_space(&f->body->chart, m->nodes, m->xy, f->sz);
  for (int k = 0; k < 2 * m->nodes; k++) f->tiny = fmax(f->tiny, 1e-9 * fabs(f->sz[k]));
  return find_pieces(f);
}

arc_status arc_body_find_strata(elastic_body *b, arc_error *error) {
  const arc_mesh *m = b->mesh;
  if (m->rows > 0 || arc_body_layers(&m->solid) == 0) return ARC_OK;
  search f = {.body = b};
  int whole = prepare(&f);
  if (whole) {
    arc_list_sort(&f.pieces, sizeof(piece), compare_pieces);
    b->stratum = malloc((size_t)(f.pieces.count + m->surface) * sizeof *b->stratum);
    b->stratum_start = malloc((size_t)m->surface * sizeof *b->stratum_start);
    whole = b->stratum && b->stratum_start;
  }
  if (whole) join_pieces(&f, b);
  free(f.pieces.data);
  free(f.sz);
  return whole ? ARC_OK : arc_fail(error, ARC_MEMORY, "out of memory for the layers of a mesh");
}

arc_body_def arc_body_under_middle(const elastic_body *b, arc_material *own) {
  const int middle = b->mesh->surface / 2;
  arc_body_def solid = b->mesh->solid;
  memset(solid.layer, 0, sizeof solid.layer);
  double from = 0;
  for (int n = 0;; n++) {
    const stratum here = arc_body_stratum(b, middle, n);
    const arc_material material = arc_body_layer_material(&b->mesh->solid, here.layer, b->material);
    if (n == ARC_MOST_LAYERS || here.end == INFINITY) {
      *own = material;
      return solid;
    }
    solid.layer[n] = (arc_layer){.thickness = here.end - from, .material = material};
    from = here.end;
  }
}

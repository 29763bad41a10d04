/* Boundary polygon of a mesh, chained from the edges that belong to only one element. */
#include "core/mesh/outline.h"
#include "core/mesh/body_shape.h"

#include <stdlib.h>

typedef struct edge {
  int from, to;
} edge;

static int compare_undirected(const void *a, const void *b) {
  const edge *p = a, *q = b;
  const int pl = p->from < p->to ? p->from : p->to, ql = q->from < q->to ? q->from : q->to;
  if (pl != ql) return pl < ql ? -1 : 1;
  const int ph = p->from + p->to - pl, qh = q->from + q->to - ql;
  return (ph > qh) - (ph < qh);
}

static int all_edges(const arc_mesh *mesh, edge *list) {
  int n = 0;
  for (int e = 0; e < mesh->elements; e++) {
    const int *c = &mesh->element[4 * e], corners = arc_mesh_corners(mesh, e);
    for (int k = 0; k < corners; k++) list[n++] = (edge){c[k], c[(k + 1) % corners]};
  }
  return n;
}

/* Sets next[node] to the next node on the boundary, or to -1 for inner nodes. Returns a boundary
 * node, or -1 if there is none. */
static int link_boundary(const arc_mesh *mesh, edge *list, int *next) {
  const int n = all_edges(mesh, list);
  qsort(list, (size_t)n, sizeof *list, compare_undirected);
  for (int k = 0; k < mesh->nodes; k++) next[k] = -1;
  int first = -1;
  for (int k = 0; k < n; k++) {
    const int twin = (k > 0 && compare_undirected(&list[k - 1], &list[k]) == 0) ||
                     (k + 1 < n && compare_undirected(&list[k], &list[k + 1]) == 0);
    if (twin) continue;
    next[list[k].from] = list[k].to;
    if (first < 0) first = list[k].from;
  }
  return first;
}

arc_status arc_mesh_outline(arc_mesh *mesh) {
  edge *list = malloc(4 * (size_t)mesh->elements * sizeof *list);
  int *next = malloc((size_t)mesh->nodes * sizeof *next);
  mesh->outline_node = malloc((size_t)mesh->nodes * sizeof(int));
  arc_status status = list && next && mesh->outline_node ? ARC_OK : ARC_MEMORY;
  if (status == ARC_OK) {
    int first = link_boundary(mesh, list, next);
    if (arc_body_is_round(&mesh->solid) && !arc_body_is_core(&mesh->solid))
      first = mesh->surface_node[mesh->surface / 2];
    int at = first;
    while (at >= 0 && mesh->outline < mesh->nodes) {
      mesh->outline_node[mesh->outline++] = at;
      at = next[at];
      if (at == first) break;
    }
    if (first < 0 || at != first) status = ARC_GEOMETRY;
  }
  free(list);
  free(next);
  return status;
}

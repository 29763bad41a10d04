/* Boundary of a body from a Gmsh file: the boundary polygon, the candidate surface and the fixed
 * nodes. */
#include "core/mesh/gmsh_boundary.h"
#include "core/mesh/gmsh_groups.h"

#include <math.h>
#include <stdlib.h>

/* Limits of the number of nodes on a contact curve. The minimum is the same as in archard's
 * mesher. The maximum limits the size of the dense compliance matrices. */
enum { fewest_surface = 5, most_surface = 5000 };

typedef struct edge {
  int from, to, element;
} edge;

static arc_status out_of_memory(const msh_body *b) {
  return arc_fail(b->error, ARC_MEMORY, "out of memory for the mesh of %s", b->file->text.path);
}

static const char *role(const msh_body *b) {
  return arc_msh_role(b->mesh->body);
}

static const double *position(const msh_body *b, int node) {
  return &b->mesh->xy[2 * node];
}

/* --- boundary edges, which belong to only one element ----------------------------------------- */

/* Compares two edges by their nodes, regardless of direction. Used for sorting. */
static int compare_ends(const void *a, const void *b) {
  const edge *p = a, *q = b;
  const int pl = p->from < p->to ? p->from : p->to, ql = q->from < q->to ? q->from : q->to;
  if (pl != ql) return pl < ql ? -1 : 1;
  const int ph = p->from + p->to - pl, qh = q->from + q->to - ql;
  return (ph > qh) - (ph < qh);
}

static int compare_edges(const void *a, const void *b) {
  const edge *p = a, *q = b;
  const int ends = compare_ends(p, q);
  return ends ? ends : (p->element > q->element) - (p->element < q->element);
}

static int list_edges(const arc_mesh *m, edge *list) {
  int n = 0;
  for (int e = 0; e < m->elements; e++) {
    const int *c = &m->element[4 * e], corners = arc_mesh_corners(m, e);
    for (int k = 0; k < corners; k++) list[n++] = (edge){c[k], c[(k + 1) % corners], e};
  }
  return n;
}

static arc_status refuse_overlap(const msh_body *b, const edge *p, const edge *q) {
  const msh_element *e = b->file->elements.data;
  const double *at = position(b, p->from);
  return arc_fail(b->error, ARC_GEOMETRY,
                  "%s: elements %lld and %lld of '%s' overlap at node %lld, (%.6g, %.6g) mm; a "
                  "surface may be meshed or listed twice",
                  b->file->text.path, e[b->source[p->element]].tag, e[b->source[q->element]].tag,
                  role(b), arc_msh_tag(b, p->from), at[0], at[1]);
}

static arc_status link_edge(msh_body *b, const edge *e) {
  if (b->next[e->from] < 0) {
    b->next[e->from] = e->to;
    return ARC_OK;
  }
  const double *at = position(b, e->from);
  return arc_fail(b->error, ARC_GEOMETRY,
                  "%s: '%s' has two parts that share only node %lld at (%.6g, %.6g) mm",
                  b->file->text.path, role(b), arc_msh_tag(b, e->from), at[0], at[1]);
}

/* Sets b->next of each boundary node to the next node on the boundary. Returns ARC_GEOMETRY if two
 * parts of the body share only one node, or if elements overlap. In an overlap an edge belongs to
 * more than two elements, or two elements traverse it in the same direction. */
static arc_status link_boundary(msh_body *b, const edge *list, int n) {
  for (int k = 0; k < b->mesh->nodes; k++) b->next[k] = -1;
  arc_status status = ARC_OK;
  for (int k = 0, end; status == ARC_OK && k < n; k = end) {
    for (end = k + 1; end < n && compare_ends(&list[k], &list[end]) == 0;) end++;
    const int count = end - k;
    if (count > 2)
      status = refuse_overlap(b, &list[k], &list[k + 2]);
    else if (count == 2 && list[k].from == list[k + 1].from)
      status = refuse_overlap(b, &list[k], &list[k + 1]);
    else if (count == 1)
      status = link_edge(b, &list[k]);
  }
  return status;
}

/* Writes the boundary polygon that contains the contact surface. The boundaries of holes are not
 * part of this polygon. */
static arc_status chain_outline(msh_body *b) {
  arc_mesh *m = b->mesh;
  m->outline_node = malloc((size_t)m->nodes * sizeof(int));
  if (!m->outline_node) return out_of_memory(b);
  int at = m->surface_node[0];
  do {
    m->outline_node[m->outline++] = at;
    at = b->next[at];
  } while (at >= 0 && at != m->surface_node[0] && m->outline < m->nodes);
  return ARC_OK;
}

/* --- curves ----------------------------------------------------------------------------------- */

/* Writes the mesh numbers of the two end nodes of line `i` of the file to `end` (-1: the node is
 * not in this body) and returns the line. Returns NULL if the line is not in the given set of
 * this body. */
static const msh_element *line_of(const msh_body *b, int i, msh_set set, int end[2]) {
  const msh_element *e = (const msh_element *)b->file->elements.data + i;
  if (e->dim != 1) return NULL;
  const msh_entity *entity = arc_msh_entity_of(b->file, e);
  if (!entity || !(entity->sets & arc_msh_bit(b->mesh->body, set))) return NULL;
  for (int k = 0; k < 2; k++) end[k] = e->type == MSH_LINE ? b->local[e->corner[k]] : -1;
  return e;
}

static arc_status refuse_line(const msh_body *b, const msh_element *e, const char *set,
                              const char *what) {
  if (e->type != MSH_LINE)
    return arc_fail(b->error, ARC_GEOMETRY,
                    "%s: line %lld of '%s.%s' is of second or higher order (type %d of Gmsh); mesh "
                    "with -order 1, Mesh.ElementOrder = 1",
                    b->file->text.path, e->tag, role(b), set, e->type);
  const msh_node *node = (const msh_node *)b->file->nodes.data + e->corner[0];
  return arc_fail(b->error, ARC_GEOMETRY, "%s: line %lld of '%s.%s' at (%.6g, %.6g) mm %s",
                  b->file->text.path, e->tag, role(b), set, node->x[0], node->x[1], what);
}

/* --- the candidate surface -------------------------------------------------------------------- */

/* Rejects an overhanging line of the contact surface. The boundary polygon is counter-clockwise,
 * so x must increase along the surface of the upper body and decrease along the surface of the
 * lower body. */
static arc_status check_direction(const msh_body *b, const msh_element *e, int from, int to) {
  const double *p = position(b, from), *q = position(b, to);
  const int upper = b->mesh->body == ARC_CYLINDER;
  const double along = upper ? q[0] - p[0] : p[0] - q[0];
  if (along > 1e-6 * fabs(q[1] - p[1])) return ARC_OK;
  return refuse_line(b, e, "contact",
                     upper ? "overhangs: a contact surface has one y for each x, and the "
                             "surface of 'upper' faces down"
                           : "overhangs: a contact surface has one y for each x, and the "
                             "surface of 'lower' faces up");
}

/* Links the nodes of the contact surface: right[node] is the next node by increasing x,
 * left[node] the previous node, -1 if there is none. */
static arc_status link_surface(const msh_body *b, int *right, int *left) {
  arc_status status = ARC_OK;
  int end[2], count = 0;
  for (int n = 0; n < b->mesh->nodes; n++) right[n] = left[n] = -1;
  for (int i = 0; status == ARC_OK && i < b->file->elements.count; i++) {
    const msh_element *e = line_of(b, i, MSH_CONTACT, end);
    if (!e) continue;
    const int forth = end[0] >= 0 && end[1] >= 0 && b->next[end[0]] == end[1];
    const int back = end[0] >= 0 && end[1] >= 0 && b->next[end[1]] == end[0];
    if (!forth && !back)
      return refuse_line(b, e, "contact", "is not an edge on the boundary of the body");
    const int from = end[back], to = end[!back], upper = b->mesh->body == ARC_CYLINDER;
    status = check_direction(b, e, from, to);
    right[upper ? from : to] = upper ? to : from;
    left[upper ? to : from] = upper ? from : to;
    count++;
  }
  if (status != ARC_OK || count > 0) return status;
  return arc_fail(b->error, ARC_GEOMETRY, "%s: the group '%s.contact' has no elements",
                  b->file->text.path, role(b));
}

static arc_status refuse_pieces(const msh_body *b, int first, int second) {
  const double *p = position(b, first), *q = position(b, second);
  return arc_fail(b->error, ARC_GEOMETRY,
                  "%s: '%s.contact' is in pieces: expected one curve, got one that begins at "
                  "(%.6g, %.6g) mm and another at (%.6g, %.6g) mm",
                  b->file->text.path, role(b), p[0], p[1], q[0], q[1]);
}

static arc_status walk_surface(msh_body *b, const int *right, const int *left) {
  arc_mesh *m = b->mesh;
  int first = -1;
  for (int n = 0; n < m->nodes; n++) {
    if (right[n] < 0 || left[n] >= 0) continue;
    if (first >= 0) return refuse_pieces(b, first, n);
    first = n;
  }
  for (int n = first; n >= 0; n = right[n]) m->surface++;
  if (m->surface < fewest_surface || m->surface > most_surface)
    return arc_fail(b->error, ARC_GEOMETRY,
                    "%s: expected from %d to %d nodes on '%s.contact', got %d", b->file->text.path,
                    fewest_surface, most_surface, role(b), m->surface);
  m->surface_node = malloc((size_t)m->surface * sizeof(int));
  m->box_node = malloc((size_t)m->surface * sizeof(int));
  if (!m->surface_node || !m->box_node) return out_of_memory(b);
  for (int n = first, i = 0; n >= 0; n = right[n]) m->surface_node[i] = m->box_node[i] = n, i++;
  return ARC_OK;
}

static arc_status find_surface(msh_body *b) {
  int *right = malloc(2 * (size_t)b->mesh->nodes * sizeof *right);
  if (!right) return out_of_memory(b);
  int *left = right + b->mesh->nodes;
  arc_status status = link_surface(b, right, left);
  if (status == ARC_OK) status = walk_surface(b, right, left);
  free(right);
  return status;
}

/* --- fixed nodes ------------------------------------------------------------------------------ */

static arc_status mark_fixed(const msh_body *b, const edge *list, int edges, char *fixed) {
  int end[2];
  for (int i = 0; i < b->file->elements.count; i++) {
    const msh_element *e = line_of(b, i, MSH_FIXED, end);
    if (!e) continue;
    const edge line = {.from = end[0], .to = end[1]};
    if (end[0] < 0 || end[1] < 0) return refuse_line(b, e, "fixed", "is not part of the body");
    if (!bsearch(&line, list, (size_t)edges, sizeof line, compare_ends))
      return refuse_line(b, e, "fixed", "is not an edge of an element");
    fixed[end[0]] = fixed[end[1]] = 1;
  }
  for (int i = 0; i < b->mesh->surface; i++) {
    const int node = b->mesh->surface_node[i];
    const double *at = position(b, node);
    if (fixed[node])
      return arc_fail(b->error, ARC_GEOMETRY,
                      "%s: node %lld at (%.6g, %.6g) mm is both in '%s.contact' and in '%s.fixed'; "
                      "end the contact curve before this node",
                      b->file->text.path, arc_msh_tag(b, node), at[0], at[1], role(b), role(b));
  }
  return ARC_OK;
}

static arc_status find_fixed(msh_body *b, const edge *list, int edges) {
  arc_mesh *m = b->mesh;
  char *fixed = calloc((size_t)m->nodes, 1);
  m->fixed_node = malloc((size_t)m->nodes * sizeof(int));
  arc_status status = fixed && m->fixed_node ? mark_fixed(b, list, edges, fixed) : out_of_memory(b);
  for (int n = 0; status == ARC_OK && n < m->nodes; n++)
    if (fixed[n]) m->fixed_node[m->fixed++] = n;
  free(fixed);
  if (status != ARC_OK || m->fixed > 0) return status;
  return arc_fail(b->error, ARC_GEOMETRY, "%s: the group '%s.fixed' has no elements",
                  b->file->text.path, role(b));
}

/* --- sizes ------------------------------------------------------------------------------------ */

static void find_sizes(arc_mesh *m) {
  double least = INFINITY, most = 0;
  for (int i = 1; i < m->surface; i++) {
    const double *p = &m->xy[2 * m->surface_node[i - 1]], *q = &m->xy[2 * m->surface_node[i]];
    least = fmin(least, q[0] - p[0]);
  }
  for (int e = 0; e < m->elements; e++) {
    const int *c = &m->element[4 * e], corners = arc_mesh_corners(m, e);
    for (int k = 0; k < corners; k++) {
      const double *p = &m->xy[2 * c[k]], *q = &m->xy[2 * c[(k + 1) % corners]];
      most = fmax(most, hypot(q[0] - p[0], q[1] - p[1]));
    }
  }
  m->def.size = m->def.height = least;
  m->def.far = most;
  for (int body = 0; body < ARC_BODIES; body++)
    m->def.zone[body] = m->xy[2 * m->surface_node[m->surface - 1]] - m->xy[2 * m->surface_node[0]];
}

arc_status arc_msh_boundary(msh_body *b) {
  edge *list = malloc(4 * (size_t)b->mesh->elements * sizeof *list);
  if (!list) return out_of_memory(b);
  const int n = list_edges(b->mesh, list);
  qsort(list, (size_t)n, sizeof *list, compare_edges);
  arc_status status = link_boundary(b, list, n);
  if (status == ARC_OK) status = find_surface(b);
  if (status == ARC_OK) status = find_fixed(b, list, n);
  free(list);
  if (status == ARC_OK) status = chain_outline(b);
  if (status == ARC_OK) find_sizes(b->mesh);
  return status;
}

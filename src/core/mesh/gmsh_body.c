/* Builds and checks the mesh of one body of a Gmsh file: its elements, nodes and materials. */
#include "core/mesh/gmsh_body.h"
#include "core/mesh/gmsh_boundary.h"
#include "core/mesh/gmsh_groups.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const msh_node *file_nodes(const msh_body *b) {
  return b->file->nodes.data;
}

static const msh_element *file_element(const msh_body *b, int i) {
  return (const msh_element *)b->file->elements.data + i;
}

static arc_status out_of_memory(const msh_body *b) {
  return arc_fail(b->error, ARC_MEMORY, "out of memory for the mesh of %s", b->file->text.path);
}

/* --- elements --------------------------------------------------------------------------------- */

static arc_status refuse_type(const msh_body *b, const msh_element *e) {
  return arc_fail(b->error, ARC_GEOMETRY,
                  "%s: element %lld of '%s' is of second or higher order (type %d of Gmsh); "
                  "expected triangles with 3 and quadrilaterals with 4 nodes: mesh with -order 1, "
                  "Mesh.ElementOrder = 1",
                  b->file->text.path, e->tag, arc_msh_role(b->mesh->body), e->type);
}

/* Collects the elements of the body in the order of the file. Error: ARC_GEOMETRY if the body
 * has no elements. */
static arc_status pick_elements(msh_body *b) {
  arc_mesh *m = b->mesh;
  const unsigned own = arc_msh_bit(m->body, MSH_BODY);
  for (int i = 0; i < b->file->elements.count; i++) {
    const msh_element *e = file_element(b, i);
    const msh_entity *entity = arc_msh_entity_of(b->file, e);
    if (!entity || !(entity->sets & own)) continue;
    if (e->type != MSH_TRIANGLE && e->type != MSH_QUAD) return refuse_type(b, e);
    b->source[m->elements++] = i;
    *(e->type == MSH_QUAD ? &m->quads : &m->triangles) += 1;
  }
  if (m->elements > 0) return ARC_OK;
  return arc_fail(b->error, ARC_GEOMETRY, "%s: the group '%s' has no elements: mesh its surfaces",
                  b->file->text.path, arc_msh_role(m->body));
}

static arc_status refuse_owner(const msh_body *b, int node) {
  const msh_node *n = &file_nodes(b)[node];
  return arc_fail(
      b->error, ARC_GEOMETRY,
      "%s: node %lld at (%.6g, %.6g) mm belongs to both bodies; each body needs its own "
      "points and curves, also where they touch",
      b->file->text.path, n->tag, n->x[0], n->x[1]);
}

/* Numbers the nodes of the body in the order of the file. A node must not belong to both bodies. */
static arc_status number_nodes(msh_body *b, signed char *owner) {
  arc_mesh *m = b->mesh;
  const int count = b->file->nodes.count;
  for (int n = 0; n < count; n++) b->local[n] = -1;
  for (int e = 0; e < m->elements; e++) {
    const msh_element *from = file_element(b, b->source[e]);
    for (int c = 0; c < (from->type == MSH_QUAD ? 4 : 3); c++) {
      const int node = (int)from->corner[c];
      if (owner[node] >= 0 && owner[node] != (signed char)m->body) return refuse_owner(b, node);
      owner[node] = (signed char)m->body;
      b->local[node] = 0;
    }
  }
  for (int n = 0; n < count; n++) {
    if (b->local[n] < 0) continue;
    b->origin[m->nodes] = n;
    b->local[n] = m->nodes++;
  }
  return ARC_OK;
}

static arc_status fill(msh_body *b) {
  arc_mesh *m = b->mesh;
  m->xy = malloc(2 * (size_t)m->nodes * sizeof(double));
  m->element = malloc(4 * (size_t)m->elements * sizeof(int));
  if (!m->xy || !m->element) return out_of_memory(b);
  for (int n = 0; n < m->nodes; n++)
    memcpy(&m->xy[2 * n], file_nodes(b)[b->origin[n]].x, 2 * sizeof(double));
  for (int e = 0; e < m->elements; e++) {
    const msh_element *from = file_element(b, b->source[e]);
    for (int c = 0; c < 4; c++)
      m->element[4 * e + c] = c < 3 || from->type == MSH_QUAD ? b->local[from->corner[c]] : -1;
  }
  return ARC_OK;
}

/* Sets the material of each element. Elements outside named groups consist of the body's own
 * material. */
static arc_status fill_materials(msh_body *b) {
  arc_mesh *m = b->mesh;
  m->materials = b->file->materials[m->body];
  if (m->materials == 0) return ARC_OK;
  m->material_name = malloc((size_t)m->materials * sizeof *m->material_name);
  m->material = calloc((size_t)m->elements, sizeof(int));
  if (!m->material_name || !m->material) return out_of_memory(b);
  memcpy(m->material_name, b->file->material[m->body],
         (size_t)m->materials * sizeof *m->material_name);
  for (int e = 0; e < m->elements; e++) {
    const msh_element *from = file_element(b, b->source[e]);
    m->material[e] = arc_msh_entity_of(b->file, from)->material[m->body];
  }
  return ARC_OK;
}

/* --- shapes ----------------------------------------------------------------------------------- */

/* Returns the largest absolute coordinate of the nodes [mm], to which rounding errors are
 * proportional. */
static double extent(const arc_mesh *m) {
  double most = 0;
  for (int k = 0; k < 2 * m->nodes; k++) most = fmax(most, fabs(m->xy[k]));
  return most;
}

static arc_status check_plane(const msh_body *b) {
  const double limit = 1e-9 * extent(b->mesh);
  for (int n = 0; n < b->mesh->nodes; n++) {
    const msh_node *node = &file_nodes(b)[b->origin[n]];
    if (fabs(node->x[2]) > limit)
      return arc_fail(b->error, ARC_GEOMETRY,
                      "%s: expected all nodes in the plane z = 0, got node %lld at (%.6g, %.6g, "
                      "%.6g) mm",
                      b->file->text.path, node->tag, node->x[0], node->x[1], node->x[2]);
    if (fabs(node->x[0]) > 1e6 || fabs(node->x[1]) > 1e6)
      return arc_fail(b->error, ARC_GEOMETRY,
                      "%s: expected coordinates up to 1e6 mm, got node %lld at (%.6g, %.6g) mm",
                      b->file->text.path, node->tag, node->x[0], node->x[1]);
  }
  return ARC_OK;
}

/* Returns twice the signed area [mm2] of the triangle that consists of corner c of an element
 * and its two neighbours. */
static double jacobian_at(const arc_mesh *m, const int *e, int corners, int c) {
  const double *p = &m->xy[2 * e[c]], *q = &m->xy[2 * e[(c + 1) % corners]],
               *r = &m->xy[2 * e[(c + corners - 1) % corners]];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

static arc_status refuse_shape(const msh_body *b, int e, const char *what) {
  const arc_mesh *m = b->mesh;
  const int *c = &m->element[4 * e], corners = arc_mesh_corners(m, e);
  double x = 0, y = 0;
  for (int k = 0; k < corners; k++) {
    x += m->xy[2 * c[k]] / corners;
    y += m->xy[2 * c[k] + 1] / corners;
  }
  return arc_fail(b->error, ARC_GEOMETRY, "%s: element %lld of '%s' at (%.6g, %.6g) mm %s",
                  b->file->text.path, file_element(b, b->source[e])->tag, arc_msh_role(m->body), x,
                  y, what);
}

static arc_status check_shape(const msh_body *b, int e) {
  const arc_mesh *m = b->mesh;
  const int *c = &m->element[4 * e], corners = arc_mesh_corners(m, e);
  int turned = 0, flat = 0;
  for (int k = 0; k < corners; k++) {
    const double *p = &m->xy[2 * c[k]], *q = &m->xy[2 * c[(k + 1) % corners]];
    const double edge = hypot(q[0] - p[0], q[1] - p[1]), area = jacobian_at(m, c, corners, k);
    if (c[k] == c[(k + 1) % corners]) return refuse_shape(b, e, "has the same corner twice");
    turned += area < 0;
    flat += !(fabs(area) > 1e-6 * edge * edge);
  }
  if (turned == corners)
    return refuse_shape(b, e,
                        "is flipped: its corners run clockwise; reverse its surface "
                        "(ReverseMesh Surface in the .geo)");
  if (turned > 0) return refuse_shape(b, e, "is folded or not convex");
  return flat > 0 ? refuse_shape(b, e, "is degenerate at a corner (area near zero)") : ARC_OK;
}

static arc_status check_shapes(const msh_body *b) {
  arc_status status = ARC_OK;
  for (int e = 0; status == ARC_OK && e < b->mesh->elements; e++) status = check_shape(b, e);
  return status;
}

/* --- coincident nodes ------------------------------------------------------------------------- */

typedef struct grid_cell {
  double x, y; /* integer coordinates of the grid cell that contains `node` */
  int node;
} grid_cell;

static int compare_positions(const void *a, const void *b) {
  const grid_cell *p = a, *q = b;
  if (p->x != q->x) return p->x < q->x ? -1 : 1;
  if (p->y != q->y) return p->y < q->y ? -1 : 1;
  return (p->node > q->node) - (p->node < q->node);
}

/* Searches for two nodes in the same cell of a grid and writes them to `twins`. off_x and off_y
 * shift the grid, in units of its spacing. Returns 0 if no cell contains two nodes. */
static int find_twins(const arc_mesh *m, double spacing, double off_x, double off_y,
                      grid_cell *list, int twins[2]) {
  for (int n = 0; n < m->nodes; n++)
    list[n] = (grid_cell){floor(m->xy[2 * n] / spacing + off_x),
                          floor(m->xy[2 * n + 1] / spacing + off_y), n};
  qsort(list, (size_t)m->nodes, sizeof *list, compare_positions);
  for (int n = 1; n < m->nodes; n++) {
    if (list[n].x != list[n - 1].x || list[n].y != list[n - 1].y) continue;
    twins[0] = list[n - 1].node, twins[1] = list[n].node;
    return 1;
  }
  return 0;
}

/* Returns ARC_GEOMETRY if two nodes have nearly the same position. Two nodes closer than half
 * the grid spacing are in the same cell of at least one of four shifted grids. */
static arc_status check_twins(const msh_body *b) {
  const arc_mesh *m = b->mesh;
  const double spacing = 1e-9 * extent(m);
  int twins[2], found = 0;
  grid_cell *list = malloc((size_t)m->nodes * sizeof *list);
  if (!list) return out_of_memory(b);
  for (int grid = 0; grid < 4 && !found; grid++)
    found = find_twins(m, spacing, grid % 2 * 0.5, grid / 2 * 0.5, list, twins);
  free(list);
  if (!found) return ARC_OK;
  return arc_fail(b->error, ARC_GEOMETRY,
                  "%s: nodes %lld and %lld of '%s' coincide at (%.6g, %.6g) mm: the body has "
                  "a crack there; merge them (Coherence Mesh)",
                  b->file->text.path, arc_msh_tag(b, twins[0]), arc_msh_tag(b, twins[1]),
                  arc_msh_role(m->body), m->xy[2 * twins[0]], m->xy[2 * twins[0] + 1]);
}

/* --- one piece -------------------------------------------------------------------------------- */

static int root_of(int *parent, int node) {
  while (parent[node] != node) node = parent[node] = parent[parent[node]];
  return node;
}

/* Returns a node that is not connected with node 0 by elements, or -1 if all nodes are
 * connected. */
static int find_loose(const arc_mesh *m, int *parent) {
  for (int n = 0; n < m->nodes; n++) parent[n] = n;
  for (int e = 0; e < m->elements; e++)
    for (int c = 1; c < 4; c++)
      if (m->element[4 * e + c] >= 0)
        parent[root_of(parent, m->element[4 * e + c])] = root_of(parent, m->element[4 * e]);
  for (int n = 1; n < m->nodes; n++)
    if (root_of(parent, n) != root_of(parent, 0)) return n;
  return -1;
}

static arc_status check_connected(const msh_body *b) {
  const arc_mesh *m = b->mesh;
  int *parent = calloc((size_t)m->nodes, sizeof *parent);
  if (!parent) return out_of_memory(b);
  const int loose = find_loose(m, parent);
  free(parent);
  if (loose < 0) return ARC_OK;
  return arc_fail(b->error, ARC_GEOMETRY,
                  "%s: '%s' is in pieces: node %lld at (%.6g, %.6g) mm is not connected with node "
                  "%lld at (%.6g, %.6g) mm",
                  b->file->text.path, arc_msh_role(m->body), arc_msh_tag(b, loose),
                  m->xy[2 * loose], m->xy[2 * loose + 1], arc_msh_tag(b, 0), m->xy[0], m->xy[1]);
}

/* --- the whole -------------------------------------------------------------------------------- */

static arc_status build(msh_body *b, signed char *owner) {
  arc_status status = pick_elements(b);
  if (status == ARC_OK) status = number_nodes(b, owner);
  if (status == ARC_OK) status = fill(b);
  if (status == ARC_OK) status = check_plane(b);
  if (status == ARC_OK) status = check_shapes(b);
  if (status == ARC_OK) status = check_twins(b);
  if (status == ARC_OK) status = check_connected(b);
  if (status == ARC_OK) status = fill_materials(b);
  return status == ARC_OK ? arc_msh_boundary(b) : status;
}

arc_status arc_msh_body(const msh_file *file, arc_body body, signed char *owner, arc_mesh **mesh,
                        arc_error *error) {
  msh_body b = {.file = file, .mesh = calloc(1, sizeof *b.mesh), .error = error};
  const size_t nodes = (size_t)file->nodes.count + 1, elements = (size_t)file->elements.count + 1;
  b.local = malloc(nodes * sizeof(int));
  b.origin = malloc(nodes * sizeof(int));
  b.next = malloc(nodes * sizeof(int));
  b.source = malloc(elements * sizeof(int));
  arc_status status = ARC_OK;
  if (!b.mesh || !b.local || !b.origin || !b.next || !b.source) status = out_of_memory(&b);
  if (status == ARC_OK) {
    b.mesh->body = body;
    b.mesh->def = arc_mesh_default();
    b.mesh->def.rows = 0;
    status = build(&b, owner);
  }
  free(b.local);
  free(b.origin);
  free(b.next);
  free(b.source);
  if (status != ARC_OK) arc_mesh_destroy(&b.mesh);
  *mesh = b.mesh;
  return status;
}

/* Builds a condensed body: numbers its unknowns, assembles the stiffness outside the wear box,
 * and computes the Schur complement. */
#include "core/elastic/body.h"
#include "core/base/dense.h"
#include "core/elastic/condense.h"
#include "core/elastic/imported_layers.h"
#include "core/elastic/imported_mesh.h"
#include "core/mesh/body_shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest number of nodes in a cell of triangles: a cell with a hanging node on each edge has
 * eight triangles around its middle node. */
enum { most_cell_nodes = 9 };

static arc_status out_of_memory(const elastic_body *b, arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for the %s", arc_body_name(b->mesh->body));
}

/* Numbers the nodes of the wear box: the rim nodes, which also belong to an element outside the
 * box, and all other nodes, the inner nodes. */
static void number_box(elastic_body *b) {
  const arc_mesh *m = b->mesh;
  for (int n = 0; n < m->nodes; n++) b->node_box[n] = -1;
  for (int k = 0; k < b->box_count; k++) {
    b->node_box[m->box_node[k]] = k;
    b->box_rim[k] = b->box_inner[k] = -1;
  }
  for (int e = m->box_elements; e < m->elements; e++)
    for (int c = 0; c < 4; c++) {
      const int node = m->element[4 * e + c];
      if (node >= 0 && b->node_box[node] >= 0) b->box_rim[b->node_box[node]] = 0;
    }
  for (int k = 0; k < b->box_count; k++) {
    if (b->box_rim[k] == 0)
      b->box_rim[k] = b->rim++;
    else
      b->box_inner[k] = b->inner++;
  }
  b->band = 2 * (m->rows + 1) + 1; /* difference between the numbers of a node and of its diagonal
                                      neighbour in the next column */
}

static void number_far(elastic_body *b) {
  const arc_mesh *m = b->mesh;
  for (int n = 0; n < 2 * m->nodes; n++) b->far_at[n] = b->node_box[n / 2] >= 0 ? -1 : 0;
  for (int k = 0; k < m->fixed; k++) {
    const int node = m->fixed_node[k];
    if (arc_body_holds_sideways(&m->solid, m->xy[2 * node])) b->far_at[2 * node] = -1;
    b->far_at[2 * node + 1] = -1;
  }
  for (int n = 0; n < 2 * m->nodes; n++)
    if (b->far_at[n] == 0) b->far_at[n] = b->far_count++;
}

/* Adds the stiffness k of an element or cell with `count` nodes to `stiffness`, in which the rim
 * unknowns follow the far unknowns. Entries between far and rim unknowns are also added to the
 * coupling. */
static arc_status add_block(elastic_body *b, const int *nodes, int count, const double *k,
                            sparse_entries *stiffness) {
  const int n = 2 * count;
  int at[2 * most_cell_nodes];
  for (int r = 0; r < n; r++) {
    const int node = nodes[r / 2], box = b->node_box[node], far = b->far_at[2 * node + r % 2];
    at[r] = box >= 0 ? b->far_count + 2 * b->box_rim[box] + r % 2 : far;
  }
  arc_status status = ARC_OK;
  for (int r = 0; r < n; r++)
    for (int c = 0; c < n && status == ARC_OK; c++) {
      if (at[c] < 0 || at[r] < at[c]) continue;
      status = arc_sparse_add(stiffness, at[r], at[c], k[r * n + c]);
      if (status == ARC_OK && at[r] >= b->far_count && at[c] < b->far_count)
        status = arc_sparse_add(&b->coupling, at[c], at[r] - b->far_count, k[r * n + c]);
    }
  return status;
}

element arc_body_element(const elastic_body *b, const double *xy, const int corner[4]) {
  element e = arc_element_at(xy, corner, b->mesh->def.element);
  e.revolved = b->chart.revolved;
  return e;
}

static arc_status add_element(elastic_body *b, int e, elasticity d, sparse_entries *stiffness) {
  const int *corner = &b->mesh->element[4 * e];
  const element el = arc_body_element(b, b->mesh->xy, corner);
  double k[64];
  arc_element_stiffness(&el, d, k);
  return add_block(b, corner, el.corners, k, stiffness);
}

static int is_triangle(const arc_mesh *m, int e) {
  return arc_mesh_corners(m, e) == 3;
}

/* Returns true if triangle e is in the same cell as triangle e - 2. */
static int is_in_cell_of_previous(const arc_mesh *m, int e) {
  return e - 2 >= m->box_elements && e < m->elements && is_triangle(m, e) &&
         is_triangle(m, e - 2) && m->element[4 * e] == m->element[4 * (e - 2)];
}

int arc_body_cell(const elastic_body *b, int e) {
  if (b->mesh->def.element != ARC_CPE4I || b->mesh->rows == 0 || !is_triangle(b->mesh, e)) return 1;
  if (is_in_cell_of_previous(b->mesh, e)) return 0;
  int count = 1;
  while (is_in_cell_of_previous(b->mesh, e + 2 * count) && count < most_cell_nodes - 1) count++;
  return count;
}

/* Returns the index of the node in the list `nodes`. If the node is not in the list, it is
 * appended. */
static int enter_node(int node, int *nodes, int *count) {
  int at = 0;
  while (at < *count && nodes[at] != node) at++;
  if (at == *count) nodes[(*count)++] = node;
  return at;
}

/* Adds the stiffness of all triangles in a cell. The deviatoric part is computed for each
 * triangle; the dilatation is the same in all triangles. */
static arc_status add_cell(elastic_body *b, int e, int triangles, sparse_entries *stiffness) {
  const elasticity d = arc_body_elasticity(b, e), shape = arc_elasticity_deviatoric(d);
  int nodes[most_cell_nodes], count = 0;
  double swelling[2 * most_cell_nodes] = {0}, area = 0, k[4 * most_cell_nodes * most_cell_nodes];
  arc_status status = ARC_OK;
  for (int t = 0; t < triangles && status == ARC_OK; t++) {
    const int *corner = &b->mesh->element[4 * (e + 2 * t)];
    const element el = arc_body_element(b, b->mesh->xy, corner);
    double gradient[6];
    area += arc_triangle_swelling(&el, gradient);
    for (int c = 0; c < 3; c++) {
      const int at = enter_node(corner[c], nodes, &count);
      swelling[2 * at] += gradient[2 * c];
      swelling[2 * at + 1] += gradient[2 * c + 1];
    }
    status = add_element(b, e + 2 * t, shape, stiffness);
  }
  if (status != ARC_OK) return status;
  const int n = 2 * count;
  const double bulk = arc_elasticity_bulk(d) / area;
  for (int r = 0; r < n; r++)
    for (int c = 0; c < n; c++) k[r * n + c] = bulk * (swelling[r] * swelling[c]);
  return add_block(b, nodes, count, k, stiffness);
}

static arc_status add_far_elements(elastic_body *b, sparse_entries *stiffness) {
  arc_status status = ARC_OK;
  for (int e = b->mesh->box_elements; e < b->mesh->elements && status == ARC_OK; e++) {
    const int triangles = arc_body_cell(b, e);
    if (triangles == 1)
      status = add_element(b, e, arc_body_elasticity(b, e), stiffness);
    else if (triangles > 1)
      status = add_cell(b, e, triangles, stiffness);
  }
  return status;
}

/* Factorises the stiffness and computes its Schur complement S_far = K_rr - K_rf K_ff^-1 K_fr,
 * where f stands for the far and r for the rim unknowns. */
static arc_status eliminate_far(elastic_body *b, arc_error *error) {
  sparse_entries stiffness = {0};
  arc_status status = add_far_elements(b, &stiffness);
  const int rim = 2 * b->rim;
  if (status == ARC_OK)
    status = arc_factor_create(b->far_count + rim, rim, &stiffness, &b->far, error);
  else
    out_of_memory(b, error);
  arc_sparse_free(&stiffness);
  return status == ARC_OK ? arc_factor_schur(b->far, b->s_far, error) : status;
}

static arc_status allocate(elastic_body *b) {
  const arc_mesh *m = b->mesh;
  b->box_count = m->surface * (m->rows + 1);
  b->node_box = malloc((size_t)m->nodes * sizeof(int));
  b->far_at = malloc(2 * (size_t)m->nodes * sizeof(int));
  b->box_inner = malloc((size_t)b->box_count * sizeof(int));
  b->box_rim = malloc((size_t)b->box_count * sizeof(int));
  if (!b->node_box || !b->far_at || !b->box_inner || !b->box_rim) return ARC_MEMORY;
  number_box(b);
  number_far(b);
  b->box_at = malloc(2 * (size_t)b->box_count * sizeof *b->box_at);
  if (!b->box_at) return ARC_MEMORY;
  for (int k = 0; k < b->box_count; k++)
    arc_chart_from_space(&b->chart, 1, &m->xy[2 * m->box_node[k]], &b->box_at[2 * k]);
  b->s_far = calloc((size_t)(4 * b->rim) * (size_t)b->rim, sizeof(double));
  if (!b->s_far) return ARC_MEMORY;
  b->thinning = calloc(ARC_THINNING_SPAN * ARC_THINNING_SPAN, sizeof(double));
  if (!b->thinning) return ARC_MEMORY;
  return arc_compliance_create(&b->unworn, m->surface);
}

/* Returns the representative column of the wear box: the centre or, if the centre is on an axis
 * of revolution, the column halfway to the edge. */
static int usual_column(const elastic_body *b) {
  const revolution *r = &b->chart.revolved;
  return r->on && r->axis == 0 ? 3 * b->mesh->surface / 4 : b->mesh->surface / 2;
}

/* Computes `thinning`, the change of the compliance per lost fraction of thickness. `thinner` is
 * the compliance of a body whose representative column has lost the fraction `share` of its
 * thickness. */
static void take_difference(elastic_body *b, const compliance *thinner, double share) {
  const int n = b->mesh->surface, reach = ARC_THINNING_REACH, centre = usual_column(b);
  const double weight = arc_revolution_weight(&b->chart.revolved, arc_body_top(b, centre)[0]);
  for (int p = -reach; p <= reach; p++)
    for (int q = -reach; q <= reach; q++) {
      const int i = centre + p, j = centre + q;
      const int inside = i >= 0 && j >= 0 && i < n && j < n;
      b->thinning[(p + reach) * ARC_THINNING_SPAN + q + reach] =
          inside
              ? (thinner->yy[dense_at(i, j, n)] - b->unworn.yy[dense_at(i, j, n)]) / share * weight
              : 0;
    }
}

static arc_status find_thinning(elastic_body *b, double *box, arc_error *error) {
  /* a body without a wear box, or with layers, does not use `thinning` */
  if (b->mesh->rows == 0 || arc_body_layers(&b->mesh->solid) > 0) return ARC_OK;
  static const double share = 0.01;
  const int rows = b->mesh->rows, column = usual_column(b), first = column * (rows + 1);
  const double *bottom = &box[2 * (first + rows)], top = box[2 * first + 1];
  for (int row = 0; row < rows; row++)
    box[2 * (first + row) + 1] += share * (bottom[1] - top) * arc_body_pull(b, column, row);
  compliance thinner;
  arc_status status = arc_compliance_create(&thinner, b->mesh->surface);
  if (status != ARC_OK) return out_of_memory(b, error);
  status = arc_body_condense(b, box, 0, &thinner, error);
  if (status == ARC_OK) take_difference(b, &thinner, share);
  arc_compliance_free(&thinner);
  return status;
}

static arc_status condense_unworn(elastic_body *b, work_progress *seen, arc_error *error) {
  double *box = malloc(2 * (size_t)b->box_count * sizeof *box);
  if (!box) return out_of_memory(b, error);
  memcpy(box, b->box_at, 2 * (size_t)b->box_count * sizeof *box);
  arc_status status = arc_body_condense(b, box, 0, &b->unworn, error);
  if (status == ARC_OK) status = arc_work_stage(seen);
  if (status == ARC_OK) status = find_thinning(b, box, error);
  free(box);
  return status;
}

/* Sets the elasticity of each layer. Returns the largest Poisson's ratio of the body. */
static double take_materials(elastic_body *b, const arc_body_def *solid) {
  const int layers = arc_body_layers(solid);
  double nu = b->material.nu;
  for (int l = 0; l < layers; l++) {
    b->layer[l] = arc_elasticity_in(b->space, solid->layer[l].material);
    nu = fmax(nu, solid->layer[l].material.nu);
  }
  b->layer[layers] = b->d;
  return nu;
}

/* Builds the mesh of the body, or uses an imported one. */
static arc_status take_mesh(elastic_body *b, const arc_model_def *def, arc_body which,
                            arc_mesh **given, arc_error *error) {
  arc_mesh_def mesh = def->mesh;
  const arc_body_def solid = arc_model_solid(def, which);
  mesh.element = arc_element_for(mesh.element, take_materials(b, &solid));
  if (!*given) return arc_mesh_build_solid(&mesh, which, &solid, &b->mesh, error);
  b->mesh = *given;
  *given = NULL;
  b->mesh->def.element = mesh.element;
  b->mesh->solid = solid;
  return arc_given_layers(b->mesh, &solid, error);
}

/* Builds all parts of the body except the mesh. */
static arc_status make(elastic_body *b, work_progress *seen, arc_error *error) {
  arc_status status = arc_work_stage(seen);
  if (status == ARC_OK && (status = allocate(b)) != ARC_OK) out_of_memory(b, error);
  if (status == ARC_OK) status = arc_body_find_strata(b, error);
  if (status == ARC_OK) status = eliminate_far(b, error);
  if (status == ARC_OK) status = arc_work_stage(seen);
  if (status == ARC_OK) status = condense_unworn(b, seen, error);
  return status == ARC_OK ? arc_work_stage(seen) : status;
}

arc_status arc_body_create(const arc_model_def *def, arc_body which, arc_mesh **given,
                           work_progress *seen, elastic_body **result, arc_error *error) {
  *result = NULL;
  elastic_body *b = calloc(1, sizeof *b);
  if (!b) return arc_fail(error, ARC_MEMORY, "out of memory for the %s", arc_body_name(which));
  b->material = def->material[which];
  b->space = def->geometry;
  b->d = arc_elasticity_in(b->space, b->material);
  b->chart = arc_chart_of(def);
  arc_status status = take_mesh(b, def, which, given, error);
  if (status == ARC_OK) b->mesh->space = b->space, b->mesh->axis = def->axis;
  if (status == ARC_OK) status = make(b, seen, error);
  if (status != ARC_OK) arc_body_destroy(&b);
  *result = b;
  return status;
}

void arc_body_destroy(elastic_body **body) {
  if (!body || !*body) return;
  elastic_body *b = *body;
  arc_mesh_destroy(&b->mesh);
  free(b->node_box);
  free(b->far_at);
  free(b->box_inner);
  free(b->box_rim);
  arc_factor_destroy(&b->far);
  arc_sparse_free(&b->coupling);
  free(b->s_far);
  arc_compliance_free(&b->unworn);
  free(b->thinning);
  free(b->box_at);
  free(b->stratum);
  free(b->stratum_start);
  free(b);
  *body = NULL;
}

size_t arc_body_bytes(const elastic_body *b) {
  const size_t n = (size_t)b->mesh->nodes, m = (size_t)(2 * b->rim);
  return arc_factor_bytes(b->far) + b->coupling.capacity * 16 + 8 * m * m +
         arc_compliance_bytes(b->mesh->surface) + n * 28 + (size_t)b->mesh->elements * 16;
}

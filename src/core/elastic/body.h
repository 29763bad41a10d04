/* An elastic body, condensed to its wear box. The unknowns outside the wear box (`far`) are
 * eliminated once. `rim` nodes are box nodes that also belong to elements outside the box;
 * `inner` nodes are all other box nodes, including the contact surface. The inner unknowns are
 * numbered column by column, so that the stiffness of the box is a narrow band matrix. */
#ifndef ELASTIC_BODY_H
#define ELASTIC_BODY_H

#include "archard/model.h"
#include "core/base/worker_thread.h"
#include "core/elastic/chart.h"
#include "core/elastic/compliance.h"
#include "core/elastic/element.h"
#include "core/elastic/factor.h"

/* A layer below a surface node. It ends at the coordinate `end` [mm] along z of the chart, which
 * is INFINITY for the last layer. */
typedef struct stratum {
  double end;
  int layer;
} stratum;

typedef struct elastic_body {
  arc_mesh *mesh;
  arc_material material;
  elasticity d; /* elasticity of the body's own material below all layers */
  elasticity layer[ARC_MOST_LAYERS + 1]; /* elasticity of each layer, and then of the body's own
                                            material */
  arc_space space;
  chart chart;
  double *box_at; /* unworn positions of the wear-box nodes in the chart [mm] */
  int *node_box;  /* index of each node in box_node; -1 outside the wear box */
  int *far_at;    /* [2 nodes] index of each displacement (x, y) among the far unknowns, or -1 */
  int far_count;  /* number of far unknowns */
  int box_count;  /* number of nodes in the wear box */
  int *box_inner; /* [box_count] index of each box node among the inner nodes, or -1 */
  int *box_rim;   /* [box_count] index of each box node among the rim nodes, or -1 */
  int inner, rim; /* numbers of inner and rim nodes */
  int band;       /* half band width of the inner unknowns */
  factor *far;
  sparse_entries coupling; /* stiffness between far (row) and rim (column) unknowns */
  double *s_far;           /* Schur complement of the far part over the rim unknowns */
  compliance unworn;
  double *thinning; /* change of the compliance, see arc_body_thinning */
  stratum *stratum; /* layers below each surface node of an imported mesh; NULL for other bodies */
  int *stratum_start; /* index in `stratum` of the first layer below each surface node */
} elastic_body;

/* Consider a column of the wear box that has lost a fraction of its thickness. Returns the change
 * of the normal compliance between the nodes `a` and `b` columns away from it, divided by this
 * fraction. The change is limited to ARC_THINNING_REACH columns, because wear hardly changes the
 * true stiffness of the box, only the discretisation error. It is computed at the unworn centre or,
 * if the centre is on an axis of revolution, halfway between the axis and the edge. For bodies of
 * revolution it refers to 1 mm of circumference. */
enum { ARC_THINNING_REACH = 8, ARC_THINNING_SPAN = 2 * ARC_THINNING_REACH + 1 };
static inline double arc_body_thinning(const elastic_body *body, int a, int b) {
  return body->thinning[(a + ARC_THINNING_REACH) * ARC_THINNING_SPAN + b + ARC_THINNING_REACH];
}

/* Meshes, assembles, factorises and condenses a body. Counts its ARC_BODY_STAGES stages in
 * `seen` unless `seen` is NULL. If *given is not NULL, it is an imported mesh, which the body
 * uses and owns; *given becomes NULL, also on failure. On failure *body is NULL. */
enum { ARC_BODY_STAGES = 4 };
arc_status arc_body_create(const arc_model_def *def, arc_body which, arc_mesh **given,
                           work_progress *seen, elastic_body **body, arc_error *error);
void arc_body_destroy(elastic_body **body);
size_t arc_body_bytes(const elastic_body *body);

/* These functions return the unworn position (s, z) [mm] of surface node i in the chart, and the
 * position of the bottom of the wear box below this node. */
static inline const double *arc_body_top(const elastic_body *body, int i) {
  return &body->box_at[2 * i * (body->mesh->rows + 1)];
}
static inline const double *arc_body_bottom(const elastic_body *body, int i) {
  return &body->box_at[2 * (i * (body->mesh->rows + 1) + body->mesh->rows)];
}

/* Returns the displacement of the node in row `row` and column i of the wear box, divided by the
 * displacement of the surface. The result decreases in equal steps from row to row or, if the
 * body has layers of uniform thickness, in proportion to the depth. */
static inline double arc_body_pull(const elastic_body *body, int i, int row) {
  const int rows = body->mesh->rows;
  if (body->mesh->solid.layer[0].thickness == 0) return (double)(rows - row) / rows;
  const double top = arc_body_top(body, i)[1], bottom = arc_body_bottom(body, i)[1];
  return (bottom - body->box_at[2 * (i * (rows + 1) + row) + 1]) / (bottom - top);
}

/* Returns the n-th layer (from 0) below surface node i. The last layer ends at INFINITY. */
static inline stratum arc_body_stratum(const elastic_body *body, int i, int n) {
  if (body->stratum) return body->stratum[body->stratum_start[i] + n];
  const arc_body_def *solid = &body->mesh->solid;
  return (stratum){n < arc_body_layers(solid) ? arc_body_interface(solid, n) : INFINITY, n};
}

/* Returns the elasticity of an element outside the wear box. */
static inline elasticity arc_body_elasticity(const elastic_body *body, int e) {
  return body->layer[body->mesh->layer[e]];
}

/* If e is the first triangle of a cell, returns the number of triangles e, e + 2, ... of this
 * cell. They have a common dilatation, which prevents locking. Returns 0 for the other triangles
 * of a cell, and 1 for single elements, as in imported meshes. */
int arc_body_cell(const elastic_body *body, int e);

/* Returns the element of the body with the corners corner[4] among the nodes at xy; corner[3] is
 * -1 for a triangle. */
element arc_body_element(const elastic_body *body, const double *xy, const int corner[4]);

#endif

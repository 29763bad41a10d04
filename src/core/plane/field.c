/* Computes displacements and stresses inside a body by back-substitution from a contact
 * solution. */
#include "core/plane/recovery.h"
#include "core/plane/solution.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a stress field");
}

#define ADDRESS(name, unit, text) &field->name,
#define AND_ONE(name, unit, text) +1
enum { COLUMNS = 0 ARC_FIELD_COLUMNS(AND_ONE) };

static arc_status field_create(arc_field **result, int nodes) {
  const size_t n = (size_t)nodes;
  arc_field *field = calloc(1, sizeof *field);
  double *block = calloc(COLUMNS * n, sizeof *block);
  *result = field;
  if (!field || !block) {
    free(field);
    free(block);
    *result = NULL;
    return ARC_MEMORY;
  }
  double **member[] = {ARC_FIELD_COLUMNS(ADDRESS)};
  for (int m = 0; m < COLUMNS; m++) *member[m] = block + (size_t)m * n;
  field->nodes = nodes;
  return ARC_OK;
}

void arc_field_destroy(arc_field **field) {
  if (!field || !*field) return;
  free((*field)->x);
  free(*field);
  *field = NULL;
}

/* Returns the ratio of shear to pressure at the outermost contact node on the right or left
 * side. The ratio is positive if the shear on the cylinder is along +x. */
static double shear_at(const arc_contact *c, int right) {
  const int last = c->problem.set[right ? c->problem.active - 1 : 0];
  return c->state.t[c->problem.lo + last] / c->problem.f[last];
}

/* Computes the tractions at the surface nodes. Near smooth contact edges these are values at
 * points rather than means over elements. */
static void read_tractions(const arc_contact *c, arc_body body, const surface_traction *on) {
  const double sign = body == ARC_CYLINDER ? 1 : -1, *x = c->x[body];
  const int n = c->count[body];
  for (int i = 0; i < n && c->has_friction; i++) on->tangential[i] = sign * c->q[body][i];
  memcpy(on->normal, c->p[body], (size_t)n * sizeof *on->normal);
  for (int right = 0; right < 2; right++) {
    const contact_edge edge = arc_contact_problem_edge(&c->problem, c->handle.shape, right);
    arc_edge_sharpen(&edge, n, x, 1, on->normal);
    if (!c->has_friction) continue;
    const double shear = sign * shear_at(c, right);
    arc_edge_sharpen(&edge, n, x, shear, on->tangential);
    arc_edge_add_cusp(&edge, n, x, shear, on->cusp);
  }
}

static arc_status recover(const arc_contact *c, arc_body body, const double *xy, const double *u,
                          arc_field *field) {
  const size_t nodes = (size_t)field->nodes;
  double *stress = calloc(3 * nodes + 3 * (size_t)c->count[body], sizeof *stress);
  if (!stress) return ARC_MEMORY;
  surface_traction traction = {.normal = stress + 3 * nodes, .load = c->p[body]};
  if (c->has_friction) {
    traction.tangential = traction.normal + c->count[body];
    traction.cusp = traction.tangential + c->count[body];
  }
  read_tractions(c, body, &traction);
  const arc_status status =
      arc_recover_stresses(c->handle.shape->side[body].body, xy, u, &traction, stress);
  for (size_t n = 0; n < nodes && status == ARC_OK; n++) {
    field->sxx[n] = stress[3 * n];
    field->syy[n] = stress[3 * n + 1];
    field->sxy[n] = stress[3 * n + 2];
  }
  free(stress);
  return status;
}

/* Stores for each node 1 + the index of an element with the node's material. The array szz is used
 * as workspace for these numbers. A node on an interface has the material of the layer nearer to
 * the surface. Elements are numbered from the surface inwards. */
static void fill_elements(const elastic_body *body, arc_field *field) {
  const arc_mesh *m = body->mesh;
  for (int e = m->elements - 1; e >= 0; e--)
    for (int k = 0; k < arc_mesh_corners(m, e); k++) {
      double *found = &field->szz[m->element[4 * e + k]];
      if (*found == 0 || m->layer[e] < arc_body_layers(&m->solid)) *found = e + 1;
    }
}

/* Returns the stress normal to the section at node n. It follows from the stresses in the
 * section, the elasticity of the material there and the hoop strain. On the axis it equals the
 * radial stress. */
static double stress_out(const elastic_body *body, const arc_field *field, int n, elasticity own) {
  const revolution *revolved = &body->chart.revolved;
  const double r = revolved->axis + field->x[n], in = field->sxx[n] + field->syy[n];
  if (body->space == ARC_PLANE_STRESS) return 0;
  if (body->space == ARC_PLANE_STRAIN) return own.nu * in;
  const double modulus = 2 * (1 + own.nu) * own.c33;
  return r == 0 ? field->sxx[n] : modulus * field->ux[n] / r + own.nu * in;
}

static void derive_invariants(const elastic_body *body, arc_field *field) {
  fill_elements(body, field);
  for (int n = 0; n < field->nodes; n++) {
    const double x = field->sxx[n], y = field->syy[n], t = field->sxy[n];
    const elasticity own = arc_body_elasticity(body, (int)field->szz[n] - 1);
    const double z = stress_out(body, field, n, own);
    field->szz[n] = z;
    field->shear[n] = hypot((x - y) / 2, t);
    field->principal[n] = fmax((x + y) / 2 + field->shear[n], z);
    field->mises[n] =
        sqrt(((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) / 2 + 3 * t * t);
  }
}

/* Rotates the stress tensors with the body. Tensors rotate by twice the angle of vectors. */
static void turn_stresses(const placing *to, arc_field *field) {
  const double c = to->cos, s = to->sin;
  for (int k = 0; k < field->nodes && s != 0; k++) {
    const double x = field->sxx[k], y = field->syy[k], t = field->sxy[k];
    field->sxx[k] = c * c * x - 2 * c * s * t + s * s * y;
    field->syy[k] = s * s * x + 2 * c * s * t + c * c * y;
    field->sxy[k] = c * s * (x - y) + (c * c - s * s) * t;
  }
}

/* Transforms coordinates, displacements and stresses to the position of the body in the contact. */
static void place(const arc_contact *c, arc_body body, double *xy, double *u, arc_field *field) {
  const placing to = arc_chart_placing(&c->handle.shape->side[body].body->chart, body, c->problem.x,
                                       c->problem.angle);
  arc_placing_points(&to, field->nodes, xy);
  arc_placing_vectors(&to, field->nodes, u);
  turn_stresses(&to, field);
}

/* Computes the displacements of all nodes from the displacements of the wear box, and then the
 * stresses. `work` is memory for displacements and coordinates. */
static arc_status fill_field(const arc_contact *c, arc_body body, arc_field *field, double *work,
                             double *box, arc_error *error) {
  const shape_side *side = &c->handle.shape->side[body];
  const size_t n = (size_t)field->nodes;
  double *u = work, *xy = work + 2 * n, *f = box + 2 * (size_t)side->body->box_count;
  memcpy(f, c->force[body], 2 * (size_t)side->n * sizeof *f);
  const double sign = body == ARC_CYLINDER ? 1 : -1;
  for (int i = 0; i < side->n && !c->has_friction; i++) f[side->n + i] = sign * c->f[body][i];
  const double even = arc_shape_risen(c->handle.shape, body);
  arc_shape_box(side, side->xy, even, box);
  const arc_status status = arc_body_displacements(side->body, box, even, f, u, error);
  if (status != ARC_OK) return status;
  /* a mesh without a wear box has the shape of the unworn body */
  const arc_mesh *mesh = side->body->mesh;
  arc_shape_nodes(c->handle.shape, body, xy);
  if (recover(c, body, mesh->rows > 0 ? xy : mesh->xy, u, field) != ARC_OK)
    return out_of_memory(error);
  place(c, body, xy, u, field);
  for (size_t k = 0; k < n; k++) {
    field->x[k] = xy[2 * k];
    field->y[k] = xy[2 * k + 1];
    field->ux[k] = u[2 * k];
    field->uy[k] = u[2 * k + 1];
  }
  derive_invariants(side->body, field);
  return ARC_OK;
}

arc_status arc_contact_field(const arc_contact *c, arc_body body, arc_field **field,
                             arc_error *error) {
  const elastic_body *b = c->handle.shape->side[body].body;
  const size_t n = (size_t)b->mesh->nodes,
               box_size = 2 * (size_t)b->box_count + 2 * (size_t)b->mesh->surface;
  *field = NULL;
  double *work = calloc(4 * n, sizeof *work), *box = malloc(box_size * sizeof *box);
  arc_status status = field_create(field, b->mesh->nodes);
  if (!work || !box || status != ARC_OK)
    status = out_of_memory(error);
  else
    status = fill_field(c, body, *field, work, box, error);
  if (status != ARC_OK) arc_field_destroy(field);
  free(work);
  free(box);
  return status;
}

/* Implements the contact problem at one position of the plate: allocation, solution and results. */
#include "core/contact/contact_problem.h"
#include "core/base/carve.h"
#include "core/base/dense.h"
#include "core/mesh/body_shape.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

arc_status arc_contact_problem_create(contact_problem *p, const arc_model *model) {
  const size_t nc = (size_t)arc_model_mesh(model, ARC_CYLINDER)->surface;
  const size_t np = (size_t)arc_model_mesh(model, ARC_PLATE)->surface;
  *p = (contact_problem){.model = model, .nc = (int)nc, .np = (int)np};
  p->first = malloc(nc * sizeof(int));
  p->set = malloc(nc * sizeof(int));
  p->joined = malloc(2 * nc * sizeof(int));
  p->a = malloc(nc * nc * sizeof(double));
  p->factor = malloc(nc * nc * sizeof(double));
  const carve_part parts[] = {{&p->wc, nc},
                              {&p->gap, nc},
                              {&p->f, nc},
                              {&p->open, nc},
                              {&p->ones, nc},
                              {&p->slope, nc},
                              {&p->down, nc},
                              {&p->wp, np},
                              {&p->column, np},
                              {&p->weighted, nc},
                              {&p->nodal, 2 * nc},
                              {&p->on_body, 2 * (nc + np)},
                              {&p->drift, 3 * nc + 2 * np},
                              {&p->step, 2 * nc}};
  if (!ARC_CARVE(parts) || !p->first || !p->set || !p->joined || !p->a || !p->factor) {
    arc_contact_problem_free(p);
    return ARC_MEMORY;
  }
  p->made = p->joined + nc;
  return ARC_OK;
}

void arc_contact_problem_free(contact_problem *p) {
  free(p->first);
  free(p->set);
  free(p->joined);
  free(p->a);
  free(p->factor);
  free(p->wc);
  free(p->b);
  *p = (contact_problem){0};
}

size_t arc_contact_problem_bytes(const contact_problem *p) {
  const size_t nc = (size_t)p->nc, np = (size_t)p->np, width = (size_t)p->width;
  return sizeof *p + (2 * nc * nc + nc * width + 17 * nc + 6 * np) * sizeof(double) +
         4 * nc * sizeof(int);
}

void arc_contact_problem_set_angle(contact_problem *p, double angle) {
  if (p->angle == angle) return;
  p->angle = angle;
  p->aimed = p->factored = 0;
}

arc_status arc_contact_problem_update(contact_problem *p, const arc_shape *shape, double x,
                                      arc_error *error) {
  assert(shape->version > 0);
  if (p->version != shape->version || p->x != x) {
    p->version = 0;
    const arc_status status = arc_contact_problem_couple(p, shape, x, error);
    if (status != ARC_OK) return status;
    arc_contact_problem_assemble(p, shape);
    p->version = shape->version;
  }
  if (!p->aimed) arc_contact_problem_compute_down(p, shape);
  arc_contact_problem_update_gaps(p, shape);
  p->shape = shape;
  return ARC_OK;
}

/* Drops the warm start and fails with ARC_ZONE. The message names the body whose contact zone is
 * too narrow, and the width of the zone and its limit [mm]. */
static arc_status edge_reached(contact_problem *p, int left, arc_error *error) {
  const arc_model_def *def = arc_model_definition(p->model);
  const int node = left ? p->lo : p->lo + p->count - 1;
  const arc_body body = node == 1 || node == p->nc - 2 ? ARC_CYLINDER : ARC_PLATE;
  const arc_body_def solid = arc_model_solid(def, body);
  const body_limits limits = arc_body_limits(&solid);
  const double zone = def->mesh.zone[body];
  const char *name = arc_model_body_name(def, body), *end = left ? "left" : "right";
  p->active = 0;
  if (arc_model_is_given(p->model))
    return arc_fail(error, ARC_ZONE,
                    "with the plate at x = %g mm the contact reaches the %s end of the contact "
                    "curve of the %s",
                    p->x, end, name);
  if (zone < limits.zone * (1 - 1e-9))
    return arc_fail(error, ARC_ZONE,
                    "with the plate at x = %g mm the contact reaches the %s end of the contact "
                    "zone of the %s; use mesh.zone.%s > %g mm (at most %g mm)",
                    p->x, end, name, arc_body_name(body), zone, limits.zone);
  return arc_fail(error, ARC_ZONE,
                  "with the plate at x = %g mm the contact reaches the %s end of the contact zone "
                  "of the %s, whose width of %g mm is the largest (%s)",
                  p->x, end, name, zone, limits.zone_text);
}

/* Solves the contact problem with the compliance of the last condensation. If the compliance has
 * changed since then, adds this change times the forces to the gaps and solves again. */
static arc_status solve(contact_problem *p, double line) {
  arc_status status = arc_lcp_solve(p, line);
  if (status != ARC_OK || !arc_contact_problem_add_compliance_change(p)) return status;
  const int iterations = p->iterations;
  status = arc_lcp_solve(p, line);
  p->iterations += iterations;
  return status;
}

void arc_contact_problem_start_from(contact_problem *p, const contact_problem *neighbour) {
  if (p->active > 0) return;
  for (int s = 0; s < neighbour->active; s++) {
    const int candidate = neighbour->lo + neighbour->set[s] - p->lo;
    if (0 <= candidate && candidate < p->count) p->set[p->active++] = candidate;
  }
}

arc_status arc_contact_problem_check_zone(contact_problem *p, arc_error *error) {
  if (p->set[0] == 0) return edge_reached(p, 1, error);
  if (p->set[p->active - 1] == p->count - 1) return edge_reached(p, 0, error);
  return ARC_OK;
}

arc_status arc_contact_problem_fail(contact_problem *p, arc_error *error) {
  p->active = 0;
  return arc_fail(error, ARC_NUMERIC, "the contact solution failed with the plate at x = %g mm",
                  p->x);
}

arc_status arc_contact_problem_solve(contact_problem *p, double line, arc_error *error) {
  assert(p->version > 0);
  return solve(p, line) == ARC_OK ? arc_contact_problem_check_zone(p, error)
                                  : arc_contact_problem_fail(p, error);
}

void arc_contact_problem_forces(const contact_problem *p, double *f) {
  memset(f, 0, (size_t)p->nc * sizeof *f);
  memcpy(&f[p->lo], p->f, (size_t)p->count * sizeof *f);
}

/* Removes negative forces of plate nodes next to the contact, which are caused by negative parts of
 * the dual basis (mortar.c). Each negative force is added to the neighbour towards the largest
 * force, so that the sum is unchanged. */
static void push_only(double *f, int n) {
  int peak = 0;
  for (int l = 1; l < n; l++)
    if (f[l] > f[peak]) peak = l;
  for (int l = 0; l < peak; l++)
    if (f[l] < 0) f[l + 1] += f[l], f[l] = 0;
  for (int l = n - 1; l > peak; l--)
    if (f[l] < 0) f[l - 1] += f[l], f[l] = 0;
}

void arc_contact_problem_pressures(const contact_problem *p, double *pc, double *pp) {
  arc_contact_problem_forces(p, pc);
  arc_contact_problem_to_plate(p, pc, pp);
  push_only(pp, p->np);
  for (int i = 0; i < p->nc; i++) pc[i] /= p->wc[i];
  for (int l = 0; l < p->np; l++) pp[l] /= p->wp[l];
}

void arc_contact_problem_transfer(const contact_problem *p, const double *from, double *to) {
  double *weighted = p->weighted;
  for (int i = 0; i < p->nc; i++) weighted[i] = from[i] * p->wc[i];
  arc_contact_problem_to_plate(p, weighted, to);
  push_only(to, p->np);
  for (int l = 0; l < p->np; l++) to[l] /= p->wp[l];
}

/* Returns the index of the cylinder's node in the direction of the load. */
static int lowest(const contact_problem *p) {
  const shape_side *side = &p->shape->side[ARC_CYLINDER];
  if (p->angle == 0) return p->nc / 2;
  return arc_chart_nearest(side->settled, 1, p->nc, side->body->chart.radius * p->angle);
}

void arc_contact_problem_peaks(const contact_problem *p, double *center, double *largest) {
  const int middle = lowest(p) - p->lo;
  *center = *largest = 0;
  for (int k = 0; k < p->count; k++) {
    const double pressure = p->f[k] / p->wc[p->lo + k];
    *largest = fmax(*largest, pressure);
    if (k == middle) *center = pressure;
  }
}

double arc_contact_problem_ripple(const contact_problem *p, const arc_shape *shape, double reach) {
  const double *cyl = shape->side[ARC_CYLINDER].settled, *width = p->wc + p->lo;
  const double middle = cyl[2 * lowest(p)];
  double largest = 0, sum = 0;
  int count = 0;
  for (int k = 1; k + 1 < p->count; k++) {
    if (fabs(cyl[2 * (p->lo + k)] - middle) > reach) continue;
    const double here = p->f[k] / width[k],
                 beside = (p->f[k - 1] / width[k - 1] + p->f[k + 1] / width[k + 1]) / 2;
    largest = fmax(largest, fabs(here - beside));
    sum += here;
    count++;
  }
  return sum > 0 ? largest * count / sum : 0;
}

/* Returns the integral of the pressure [N/mm] along x over the candidates' cells between the
 * positions `from` and `to` [mm]. */
static double force_between(const contact_problem *p, const double *cyl, double from, double to) {
  double sum = 0;
  for (int k = 0; k < p->count; k++) {
    const int i = p->lo + k;
    const double left = (cyl[2 * i - 2] + cyl[2 * i]) / 2,
                 right = left + (cyl[2 * i + 2] - cyl[2 * i - 2]) / 2;
    const double width = fmin(right, to) - fmax(left, from);
    if (width > 0) sum += p->f[k] * width / p->wc[i];
  }
  return sum;
}

/* Compares all windows of the given length that begin or end at the edge of a cell, as one of them
 * has the largest mean pressure. */
double arc_contact_problem_average(const contact_problem *p, const arc_shape *shape,
                                   double length) {
  const double *cyl = shape->side[ARC_CYLINDER].settled;
  double most = 0, center;
  if (length == 0) {
    arc_contact_problem_peaks(p, &center, &most);
    return most;
  }
  for (int k = 0; k <= p->count; k++) {
    const int i = p->lo + k;
    const double edge = (cyl[2 * i - 2] + cyl[2 * i]) / 2;
    most = fmax(most, force_between(p, cyl, edge, edge + length));
    most = fmax(most, force_between(p, cyl, edge - length, edge));
  }
  return most / length;
}

void arc_contact_problem_forces_on(const contact_problem *p, arc_body body, double *force) {
  double *f = p->nodal, *mf = f + p->nc;
  arc_contact_problem_forces(p, f);
  for (int i = 0; i < p->nc; i++) mf[i] = p->slope[i] * f[i];
  if (body == ARC_CYLINDER) {
    for (int i = 0; i < p->nc; i++) force[i] = -mf[i];
    memcpy(&force[p->nc], f, (size_t)p->nc * sizeof *f);
  } else {
    arc_contact_problem_to_plate(p, mf, force);
    arc_contact_problem_to_plate(p, f, &force[p->np]);
    for (int l = 0; l < p->np; l++) force[p->np + l] *= -1;
  }
}

void arc_contact_problem_tangential(const contact_problem *p, const arc_shape *shape, arc_body body,
                                    double *u) {
  const compliance *c = shape_compliance(&shape->side[body]);
  double *force = p->on_body;
  arc_contact_problem_forces_on(p, body, force);
  arc_dense_multiply(c->n, 1, c->n, 1, c->xx, c->n, force, c->n, 0, u, c->n);
  arc_dense_multiply(c->n, 1, c->n, 1, c->xy, c->n, force + c->n, c->n, 1, u, c->n);
}

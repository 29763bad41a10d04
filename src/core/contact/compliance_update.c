/* Computes the first-order change of the compliance since the last condensation. Wear hardly
 * changes the true stiffness of a body, but it makes the elements near the surface thinner, which
 * changes their discretisation error. The effect of one column is limited to a few neighbouring
 * columns and proportional to the loss of thickness. It is therefore computed once
 * (arc_body_thinning) and used for all columns. Without this correction, pressures would jump
 * whenever the wear box is condensed again. */
#include "core/contact/contact_problem.h"

#include <math.h>
#include <string.h>

enum { reach = ARC_THINNING_REACH, span = ARC_THINNING_SPAN };

/* Returns the relative loss of thickness of the wear box at column i since the last
 * condensation. */
static double thinned(const shape_side *side, int i) {
  const double bottom = arc_body_bottom(side->body, i)[1];
  const double then = side->settled[2 * i + 1], now = side->xy[2 * i + 1];
  return (now - then) / (bottom - then);
}

/* Returns the circumference of the ring of node i in bodies of revolution, whose forces act on
 * whole rings: the change of the displacements is due to the force per circumference. Returns 1 in
 * the plane. */
static double weight_of(const shape_side *side, int i) {
  const int a = i > 0 ? i - 1 : 0, b = i + 1 < side->n ? i + 1 : i;
  if (!side->body->chart.revolved.on) return 1;
  return arc_shape_width(side, i) / ((side->settled[2 * b] - side->settled[2 * a]) / 2);
}

/* Adds the effect of a column's loss of thickness. Row j of the matrix contains the displacements
 * of the nodes around node j that a force on node j causes. In a body of revolution a uniform
 * pressure causes a smooth change even at the axis, where circumferences vanish. */
static void add_column(shape_side *side, int at, double share) {
  for (int a = -reach; a <= reach; a++) {
    if (at + a < 0 || at + a >= side->n) continue;
    double *row = &side->compliance_change[(at + a) * span + reach - a];
    const double line = share / weight_of(side, at + a);
    const int low = a > 0 ? a - reach : -reach, high = a < 0 ? a + reach : reach;
    for (int b = low; b <= high; b++) row[b] += line * arc_body_thinning(side->body, a, b);
  }
}

/* Computes the change of the compliance of one body. Bodies with layers are not corrected: wear
 * changes their true stiffness too, so they are condensed again earlier. */
void arc_shape_find_compliance_change(const arc_shape *shape, shape_side *side) {
  side->compliance_changed = 0;
  if (shape->geometry == ARC_FROZEN || !shape_is_corrected(shape)) return;
  if (arc_body_layers(&side->body->mesh->solid) > 0) return;
  memset(side->compliance_change, 0, (size_t)(side->n * span) * sizeof(double));
  for (int i = 1; i < side->n - 1; i++) {
    const double share = thinned(side, i);
    if (share == 0) continue;
    side->compliance_changed = 1;
    add_column(side, i, share);
  }
}

/* Computes u [n], the change of the compliance times the forces f [n]. */
static void compliance_change_times(const shape_side *side, const double *f, double *u) {
  memset(u, 0, (size_t)side->n * sizeof *u);
  for (int j = 0; j < side->n; j++) {
    if (f[j] == 0) continue;
    const int low = j < reach ? -j : -reach, last = side->n - 1 - j;
    const int high = last < reach ? last : reach;
    const double *row = &side->compliance_change[j * span + reach];
    for (int o = low; o <= high; o++) u[j + o] += row[o] * f[j];
  }
}

int arc_contact_problem_add_compliance_change(contact_problem *p) {
  if (!p->shape) return 0;
  const shape_side *cylinder = &p->shape->side[ARC_CYLINDER], *plate = &p->shape->side[ARC_PLATE];
  if (!cylinder->compliance_changed && !plate->compliance_changed) return 0;
  double *fc = p->drift, *uc = fc + p->nc, *below = uc + p->nc, *fp = below + p->nc;
  double *up = fp + p->np;
  arc_contact_problem_forces(p, fc);
  arc_contact_problem_to_plate(p, fc, fp);
  compliance_change_times(cylinder, fc, uc);
  compliance_change_times(plate, fp, up);
  arc_contact_problem_to_cylinder(p, up, below);
  for (int k = 0; k < p->count; k++) p->gap[k] += uc[p->lo + k] + below[p->lo + k];
  return 1;
}

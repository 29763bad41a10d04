/* Wear of an increment with elastic slip, computed from the work at pairs of points in contact. The
 * slip of a pair is the rigid displacement of the plate, plus the change of the elastic
 * displacement of the plate's point, minus the change at the cylinder's point. The material of the
 * plate moves below the cylinder, so the change of a plate point's displacement includes the
 * variation of the displacement along the path. Work is computed at the cylinder's nodes. The
 * coupling transfers the same work to the plate, so the worn volumes have the ratio of the wear
 * coefficients k_c and k_p (Eq. 15 of the paper on alpha). */
#include "core/plane/cycle.h"

#include <math.h>
#include <string.h>

/* Data of one end of an increment, from which its part of the work is computed. */
typedef struct increment {
  const wear_point *end;          /* solution at the start or the end of the increment */
  const contact_problem *problem; /* contact problem at the start or the end of the increment */
  double rigid, share;   /* displacement of the plate in the increment [mm]; weight of this end
                            in the work */
  const double *moved_c; /* change of the displacement along x at each cylinder node [mm] */
  const double *moved_p; /* change of the displacement along x at each plate node [mm] */
  double *under, *work, *plate; /* workspace for the nodes of the cylinder, the cylinder and the
                                   plate */
} increment;

/* Adds to the rates of both bodies the wear due to slip and pressure at one end of the increment.
 */
static void add_end(const arc_wear *w, const increment *inc, wear_rate *rate) {
  const contact_problem *p = inc->problem;
  arc_contact_problem_to_cylinder(p, inc->moved_p, inc->under);
  for (int i = 0; i < p->nc; i++) {
    const double slip = fabs(inc->rigid + inc->under[i] - inc->moved_c[i]);
    inc->work[i] = inc->share * slip * arc_wear_law(w, inc->end->p[ARC_CYLINDER][i]);
  }
  arc_wear_share(w, p, inc->end, inc->work, inc->plate, rate);
}

/* Computes the change of the plate's displacements for NSP, in which the contact is constant and
 * the plate's material moves below it by the distance `rigid` [mm]. */
static void carried_along(const arc_wear *w, const double *u, double rigid, double *moved) {
  const double *x = w->shape->side[ARC_PLATE].settled;
  for (int l = 0; l < w->np; l++) {
    const int a = l > 0 ? l - 1 : 0, b = l + 1 < w->np ? l + 1 : l;
    moved[l] = rigid * (u[b] - u[a]) / (x[2 * b] - x[2 * a]);
  }
}

void arc_wear_add_work(const arc_wear *w, int at, wear_rate *rate) {
  const wear_block *block = path_of(w)->block;
  const wear_point *point[2] = {&path_of(w)->point[(at + 1) % 2], &path_of(w)->point[at % 2]};
  const int mean = w->def.rule == ARC_TRAPEZOID;
  double *moved = plane_of(w)->slip, *moved_p = moved + w->nc, *under = moved_p + w->np;
  increment inc = {.rigid = block->x[at] - block->x[at - 1],
                   .share = block->repeat * (mean ? 0.5 : 1),
                   .moved_c = moved,
                   .moved_p = moved_p,
                   .under = under,
                   .work = under + w->nc,
                   .plate = under + 2 * w->nc};
  for (int i = 0; i < w->nc + w->np; i++) moved[i] = point[1]->u[0][i] - point[0]->u[0][i];
  if (w->manner.procedure == ARC_NSP) carried_along(w, point[1]->u[ARC_PLATE], inc.rigid, moved_p);
  for (int end = mean ? 0 : 1; end < 2; end++) {
    const int here = at - 1 + end;
    if (block->line[here] == 0) continue; /* bodies are separated */
    inc.end = point[end];
    inc.problem = &path_of(w)->problem[block->problem_of[here]];
    add_end(w, &inc, rate);
  }
}

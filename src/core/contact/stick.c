/* Where a contact with friction sticks. */
#include "core/contact/solution.h"

#include <math.h>

static int sticks(const arc_contact *c, int set) {
  return set >= 0 && set < c->pose.active && c->room.slip[c->pose.set[set]] == 0;
}

/* What friction holds back at a node: mu p - |q| [MPa]. */
static double reserve(const arc_contact *c, int set) {
  const int k = c->pose.set[set];
  return (c->def.friction * c->pose.f[k] - fabs(c->room.t[k])) / c->pose.wc[c->pose.lo + k];
}

static double x_of(const arc_contact *c, int set) {
  return c->x[ARC_CYLINDER][c->pose.lo + c->pose.set[set]];
}

/* The edge beyond the last node that sticks. mu p - |q| goes down to it with the square root of the
 * distance, as a pressure does; half way to the next node where there is only one to go by. */
static double edge_at(const arc_contact *c, int set, int direction) {
  const pose *p = &c->pose;
  const int at = p->lo + p->set[set];
  const double h = fabs(c->x[ARC_CYLINDER][at + direction] - c->x[ARC_CYLINDER][at]);
  if (set + direction < 0 || set + direction >= p->active)
    return direction > 0 ? c->result.right : c->result.left;
  if (!sticks(c, set - direction)) return x_of(c, set) + direction * h / 2;
  const double here = reserve(c, set), inside = reserve(c, set - direction);
  const double back = fabs(x_of(c, set) - x_of(c, set - direction));
  const double e = inside > here ? back * here * here / (inside * inside - here * here) : h;
  return x_of(c, set) + direction * fmin(e, h);
}

int arc_contact_stick(const arc_contact *c, int index, double edges[2]) {
  for (int s = 0; s < c->pose.active && c->rubs; s++) {
    if (!sticks(c, s) || sticks(c, s - 1) || index-- > 0) continue;
    int last = s;
    while (sticks(c, last + 1)) last++;
    edges[0] = edge_at(c, s, -1);
    edges[1] = edge_at(c, last, 1);
    return 1;
  }
  return 0;
}

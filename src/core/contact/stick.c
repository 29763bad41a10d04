/* Where a contact with friction sticks. */
#include "core/contact/solution.h"

#include <math.h>

/* Neighbours that stick, by their places in the active set. */
typedef struct stick_zone {
  const arc_contact *c;
  int first, last;
  double edge[2]; /* [mm] */
} stick_zone;

static int sticks(const arc_contact *c, int set) {
  return set >= 0 && set < c->pose.active && c->room.slip[c->pose.set[set]] == 0;
}

/* Whether it sticks together with the one after it. */
static int goes_on(const arc_contact *c, int set) {
  return sticks(c, set) && sticks(c, set + 1) && c->pose.set[set + 1] == c->pose.set[set] + 1;
}

/* What friction holds back at a node: mu p - |q| [MPa]. */
static double reserve(const arc_contact *c, int set) {
  const int k = c->pose.set[set];
  return (c->def.friction * c->pose.f[k] - fabs(c->room.t[k])) / c->pose.wc[c->pose.lo + k];
}

static double x_of(const arc_contact *c, int set) {
  return c->x[ARC_CYLINDER][c->pose.lo + c->pose.set[set]];
}

/* Squared, by the distance from the other edge [mm]. */
static double squared(const stick_zone *z, int set, double other) {
  const double r = reserve(z->c, set);
  return r * r / fabs(x_of(z->c, set) - other);
}

/* The edge beyond the last node that sticks, to the right or left of the other one. mu p - |q| goes
 * down to both with the square root of the distance, as the pressure of a contact does: where the
 * loads are Hertz', over the distance from the other edge its square is a line. That is drawn
 * through nodes off the edge, where means over elements are as good as points; half way to the next
 * node where there is only one to go by. */
static double edge_at(const stick_zone *z, int right, double other) {
  const arc_contact *c = z->c;
  const int out = right ? 1 : -1, set = right ? z->last : z->first, count = z->last - z->first + 1;
  const int off = count >= 6 ? 2 : count >= 4 ? 1 : 0, at = c->pose.lo + c->pose.set[set];
  const double end = x_of(c, set), h = fabs(c->x[ARC_CYLINDER][at + out] - end);
  if (count == 1) return end + out * h / 2;
  const double near = squared(z, set - out * off, other);
  const double inside = squared(z, set - out * (off + 1), other);
  const double from = x_of(c, set - out * off), back = fabs(from - x_of(c, set - out * (off + 1)));
  const double beyond = inside > near ? back * near / (inside - near) : INFINITY;
  return end + out * fmax(0, fmin(h, beyond - fabs(end - from)));
}

/* Where nothing slips on a side the zone ends with the contact. */
static void find_edges(stick_zone *z) {
  enum { rounds = 4 }; /* until each edge knows where the other one is */
  const arc_contact *c = z->c;
  const double ends[2] = {c->result.left, c->result.right};
  z->edge[0] = z->first == 0 ? ends[0] : x_of(c, z->first) - (x_of(c, z->last) - x_of(c, z->first));
  z->edge[1] = ends[1];
  for (int i = 0; i < rounds; i++) {
    if (z->last + 1 < c->pose.active) z->edge[1] = edge_at(z, 1, z->edge[0]);
    if (z->first > 0) z->edge[0] = edge_at(z, 0, z->edge[1]);
  }
  z->edge[0] = fmax(z->edge[0], ends[0]);
  z->edge[1] = fmin(z->edge[1], ends[1]);
}

int arc_contact_stick(const arc_contact *c, int index, double edges[2]) {
  for (int s = 0; s < c->pose.active && c->rubs; s++) {
    if (!sticks(c, s) || goes_on(c, s - 1) || index-- > 0) continue;
    stick_zone zone = {.c = c, .first = s, .last = s};
    while (goes_on(c, zone.last)) zone.last++;
    find_edges(&zone);
    edges[0] = zone.edge[0];
    edges[1] = zone.edge[1];
    return 1;
  }
  return 0;
}

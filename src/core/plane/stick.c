/* Stick zone of a contact with friction. */
#include "core/plane/solution.h"

#include <math.h>

/* Adjacent sticking nodes, by their indices in the active set. */
typedef struct stick_zone {
  const arc_contact *c;
  int first, last;
  double edge[2]; /* [mm] */
} stick_zone;

typedef double stress_at(const arc_contact *c, int set); /* [MPa] */

static int sticks(const arc_contact *c, int set) {
  return set >= 0 && set < c->pose.active && c->workspace.reserve[c->pose.set[set]] > 0;
}

/* True if the node and the next one stick. */
static int goes_on(const arc_contact *c, int set) {
  return sticks(c, set) && sticks(c, set + 1) && c->pose.set[set + 1] == c->pose.set[set] + 1;
}

/* What friction holds back at a node on the way that the plate goes [MPa]. */
static double reserve(const arc_contact *c, int set) {
  const int k = c->pose.set[set];
  return c->workspace.reserve[k] / c->pose.wc[c->pose.lo + k];
}

static double x_of(const arc_contact *c, int set) {
  return c->x[ARC_CYLINDER][c->pose.lo + c->pose.set[set]];
}

/* mu p at a node [MPa]. */
static double bound(const arc_contact *c, int set) {
  const int k = c->pose.set[set];
  return c->handle.def.friction * c->pose.f[k] / c->pose.wc[c->pose.lo + k];
}

/* What stress is squared, by the distance from the other edge [mm]. */
static double squared(const stick_zone *z, int set, double other, stress_at *stress) {
  const double r = stress(z->c, set);
  return r * r / fabs(x_of(z->c, set) - other);
}

/* How far beyond the last node that sticks, to the right or left of the other edge, a stress ends
 * [mm]. mu p - |q| goes down to both with the square root of the distance, as the pressure of a
 * contact does: where the loads are Hertz', over the distance from the other edge its square is a
 * line. That is drawn through nodes off the edge, where means over elements are as good as points;
 * half way to the next node where there is only one to go by. A node, which has the mean, sticks a
 * little longer than the surface there does: the edge may lie before it, by up to h / 4. */
static double beyond(const stick_zone *z, int right, double other, stress_at *stress) {
  const arc_contact *c = z->c;
  const int out = right ? 1 : -1, set = right ? z->last : z->first, count = z->last - z->first + 1;
  const int off = count >= 6 ? 2 : count >= 4 ? 1 : 0, at = c->pose.lo + c->pose.set[set];
  const double end = x_of(c, set), h = fabs(c->x[ARC_CYLINDER][at + out] - end);
  if (count == 1) return h / 2;
  const double near = squared(z, set - out * off, other, stress);
  const double inside = squared(z, set - out * (off + 1), other, stress);
  const double from = x_of(c, set - out * off), back = fabs(from - x_of(c, set - out * (off + 1)));
  const double more = inside > near ? back * near / (inside - near) : INFINITY;
  return fmax(-h / 4, fmin(h, more - fabs(end - from)));
}

static double edge_at(const stick_zone *z, int right, double other) {
  return x_of(z->c, right ? z->last : z->first) +
         (right ? 1 : -1) * beyond(z, right, other, reserve);
}

/* The edge beyond the last node in contact, which sticks: that of the contact, less by what motion
 * has taken off the reserve since. */
static double edge_at_end(const stick_zone *z, int right, double other) {
  const double ends[2] = {z->c->handle.result.left, z->c->handle.result.right};
  const double less = beyond(z, right, ends[!right], bound) - beyond(z, right, other, reserve);
  return ends[right] - (right ? 1 : -1) * less;
}

/* Without slipping nodes on a side the zone ends with the contact, until the plate moves. */
static void find_edges(stick_zone *z) {
  enum { rounds = 4 }; /* until each edge knows where the other one is */
  const arc_contact *c = z->c;
  const int moves = c->state.memory.sense != 0;
  const double ends[2] = {c->handle.result.left, c->handle.result.right};
  z->edge[0] = z->first == 0 ? ends[0] : x_of(c, z->first) - (x_of(c, z->last) - x_of(c, z->first));
  z->edge[1] = ends[1];
  for (int i = 0; i < rounds; i++) {
    const int slips[2] = {z->first > 0, z->last + 1 < c->pose.active};
    for (int right = 1; right >= 0; right--)
      if (slips[right] || moves)
        z->edge[right] = (slips[right] ? edge_at : edge_at_end)(z, right, z->edge[!right]);
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

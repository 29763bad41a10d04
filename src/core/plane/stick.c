/* Stick zones of a contact with friction. */
#include "core/plane/solution.h"

#include <math.h>

/* A stick zone of adjacent nodes. first and last are indices in the active set. */
typedef struct stick_zone {
  const arc_contact *c;
  int first, last;
  double edge[2]; /* positions of the left and the right edge [mm] */
} stick_zone;

typedef double stress_at(const arc_contact *c, int set); /* function that returns a stress at a
                                                            node [MPa] */

static int sticks(const arc_contact *c, int set) {
  return set >= 0 && set < c->problem.active && c->workspace.reserve[c->problem.set[set]] > 0;
}

/* Returns true if a node and the adjacent next node both stick. */
static int is_in_cell_of_previous(const arc_contact *c, int set) {
  return sticks(c, set) && sticks(c, set + 1) && c->problem.set[set + 1] == c->problem.set[set] + 1;
}

/* Returns the reserve of a sticking node [MPa]: the shear stress that can be added before the
 * node slips in the direction of the plate's motion. */
static double reserve(const arc_contact *c, int set) {
  const int k = c->problem.set[set];
  return c->workspace.reserve[k] / c->problem.wc[c->problem.lo + k];
}

static double x_of(const arc_contact *c, int set) {
  return c->x[ARC_CYLINDER][c->problem.lo + c->problem.set[set]];
}

/* Returns the friction limit mu p at a node [MPa]. */
static double bound(const arc_contact *c, int set) {
  const int k = c->problem.set[set];
  return c->handle.def.friction * c->problem.f[k] / c->problem.wc[c->problem.lo + k];
}

/* Returns the square of a stress at a node, divided by the distance of the node from the opposite
 * edge `other` [MPa2/mm]. */
static double squared(const stick_zone *z, int set, double other, stress_at *stress) {
  const double r = stress(z->c, set);
  return r * r / fabs(x_of(z->c, set) - other);
}

/* Returns the distance [mm] from the last sticking node on the right or left side to the point
 * where a stress vanishes. Like the pressure of a contact, the reserve falls with the square
 * root of the distance from the edge. For Hertz' contacts the square of the stress, divided by
 * the distance from the opposite edge, is linear in x. A line is fitted to nodes away from the
 * edge, where means over elements are as accurate as values at points. A stick zone of a single
 * node ends halfway to the next node. A node represents a mean over its element of size h, and
 * it sticks slightly longer than the point of the surface. Therefore the edge may be up to h / 4
 * inside the last sticking node. */
static double beyond(const stick_zone *z, int right, double other, stress_at *stress) {
  const arc_contact *c = z->c;
  const int out = right ? 1 : -1, set = right ? z->last : z->first, count = z->last - z->first + 1;
  const int off = count >= 6 ? 2 : count >= 4 ? 1 : 0, at = c->problem.lo + c->problem.set[set];
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

/* Returns the edge of a stick zone that extends to the outermost node in contact. The contact edge
 * is moved inwards by the distance between the points where the friction bound and the reserve
 * vanish. */
static double edge_at_end(const stick_zone *z, int right, double other) {
  const double ends[2] = {z->c->handle.result.left, z->c->handle.result.right};
  const double less = beyond(z, right, ends[!right], bound) - beyond(z, right, other, reserve);
  return ends[right] - (right ? 1 : -1) * less;
}

/* Computes both edges of a stick zone. On a side without slipping nodes, the edge is the contact
 * edge if the plate has not moved. */
static void find_edges(stick_zone *z) {
  enum { rounds = 4 }; /* iterations, because each edge depends on the other */
  const arc_contact *c = z->c;
  const int moves = c->state.memory.sense != 0;
  const double ends[2] = {c->handle.result.left, c->handle.result.right};
  z->edge[0] = z->first == 0 ? ends[0] : x_of(c, z->first) - (x_of(c, z->last) - x_of(c, z->first));
  z->edge[1] = ends[1];
  for (int i = 0; i < rounds; i++) {
    const int slips[2] = {z->first > 0, z->last + 1 < c->problem.active};
    for (int right = 1; right >= 0; right--)
      if (slips[right] || moves)
        z->edge[right] = (slips[right] ? edge_at : edge_at_end)(z, right, z->edge[!right]);
  }
  z->edge[0] = fmax(z->edge[0], ends[0]);
  z->edge[1] = fmin(z->edge[1], ends[1]);
}

int arc_contact_stick(const arc_contact *c, int index, double edges[2]) {
  for (int s = 0; s < c->problem.active && c->has_friction; s++) {
    if (!sticks(c, s) || is_in_cell_of_previous(c, s - 1) || index-- > 0) continue;
    stick_zone zone = {.c = c, .first = s, .last = s};
    while (is_in_cell_of_previous(c, zone.last)) zone.last++;
    find_edges(&zone);
    edges[0] = zone.edge[0];
    edges[1] = zone.edge[1];
    return 1;
  }
  return 0;
}

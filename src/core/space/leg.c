/* Computes legs of a loading history. In a leg, load and motion (or force) change in proportion.
 * The increments of a leg are halved until a further halving hardly changes motion, shear and
 * work. */
#include "core/space/halfspace.h"

#include <math.h>

typedef struct leg {
  arc_halfspace *h;
  const double *const *depth;
  const arc_halfspace_leg *def;
  const arc_halfspace_options *options;
  double xi[2], force[2]; /* motion [mm] and force [N] at the start of the leg */
  double carried, yielding,
      work; /* reference values of the relative errors: force [N], motion [mm] and work [N mm] */
  arc_halfspace_friction *coarser; /* state computed with half as many increments, or NULL */
  arc_halfspace_effort *effort;
} leg;

static double between(double from, double to, double share) {
  return share < 1 ? from + share * (to - from) : to;
}

/* Advances in one increment to the point at the fraction `share` (0 to 1) of the leg. */
static arc_status advance(const leg *g, double share, const arc_halfspace_friction *guess,
                          arc_halfspace_friction *state, arc_error *error) {
  arc_halfspace_increment to = g->def->to;
  to.position.load = between(g->def->load, to.position.load, share);
  for (int i = 0; i < 2; i++) {
    to.xi[i] = between(g->xi[i], to.xi[i], share);
    to.force[i] = between(g->force[i], to.force[i], share);
  }
  to.guess = guess;
  g->effort->increments++;
  return arc_halfspace_slide(g->h, g->depth, &to, g->options, state, g->effort, error);
}

/* --- effect of halving ------------------------------------------------------------------------ */

/* Largest accepted changes of the results of a part of a leg when its increments are halved.
 * Changes of motion and shear are relative to full slip. The change of work is relative to the work
 * of the leg (work_share) or of the part (own_share). The work of the leg is assumed to be at least
 * `little` times friction times load times displacement at full slip. Errors of motion and work add
 * up over a leg; errors of shear decay. */
static const double motion_share = 1e-4, shear_share = 1e-3, work_share = 1e-3, own_share = 3e-3,
                    little = 1e-3, turn_share = 0.05;

/* Solutions of a part of a leg: the state before it, the state after one increment, and the states
 * in the middle and at the end of two increments. */
typedef struct solutions {
  const arc_halfspace_friction *begin, *once, *middle, *twice;
} solutions;

/* Returns the sum of the changes of shear over the cells, as a force [N]. */
static double shear_change(const leg *g, const solutions *s) {
  double sum = 0;
  for (int k = 0; k < arc_halfspace_sites(g->h, ARC_UPPER); k++)
    sum += hypot(s->twice->q[0][k] - s->once->q[0][k], s->twice->q[1][k] - s->once->q[1][k]);
  return sum * arc_halfspace_site_area(g->h, ARC_UPPER);
}

/* Returns the sum of the changes of work over the cells [N mm]. The sum of the work itself may
 * agree by chance, where changes in different cells cancel. */
static double work_change(const leg *g, const solutions *s) {
  const double mu = g->def->to.friction, *const start = s->begin->pressure,
               *const half = s->middle->pressure;
  double sum = 0;
  for (int k = 0; k < arc_halfspace_sites(g->h, ARC_UPPER); k++)
    sum += fabs(arc_space_work_at(mu, start[k], s->middle, k) +
                arc_space_work_at(mu, half[k], s->twice, k) -
                arc_space_work_at(mu, start[k], s->once, k));
  return sum * arc_halfspace_site_area(g->h, ARC_UPPER);
}

/* Computes the reference values of force, motion and work of a leg from its solutions in one and in
 * two increments. */
static void find_scales(leg *g, const solutions *s) {
  const double mu = g->def->to.friction;
  g->carried = mu * fmax(g->def->load, g->def->to.position.load);
  g->yielding = mu * fmax(fabs(s->begin->approach), fabs(s->once->approach));
  g->work = fmax(s->twice->energy - s->begin->energy, little * g->carried * g->yielding);
}

/* Returns true if all cells slip under a given force, in a long motion. In each increment the
 * directions of slip turn towards the motion at once, although they turn over a motion of about the
 * displacement at full slip. Solutions in one and in two increments then agree without being
 * right. */
static int turns_at_once(const leg *g, const solutions *s) {
  const arc_halfspace_increment *to = &g->def->to;
  double motion = 0;
  for (int i = 0; i < 2; i++)
    if (to->by_force[i]) motion = fmax(motion, fabs(s->twice->xi[i] - s->middle->xi[i]));
  if (motion <= turn_share * g->yielding) return 0;
  for (int k = 0; k < arc_halfspace_sites(g->h, ARC_UPPER); k++)
    if (s->twice->pressure[k] > 0 && s->twice->stick[k] > 0) return 0;
  return 1;
}

/* Returns true if the solutions of a part in one and in two increments agree within the accepted
 * changes. */
static int is_resolved(const leg *g, const solutions *s) {
  const double own = s->twice->energy - s->begin->energy;
  if (!(shear_change(g, s) <= shear_share * g->carried)) return 0;
  for (int i = 0; i < 2; i++)
    if (!(fabs(s->twice->xi[i] - s->once->xi[i]) <= motion_share * g->yielding)) return 0;
  return work_change(g, s) <= fmax(own_share * own, work_share * g->work);
}

/* --- halving ---------------------------------------------------------------------------------- */

/* A part of a leg, between two fractions (0 to 1) of its length. */
typedef struct part {
  double from, to;
  int halvings;
} part;

static arc_status refine(leg *g, part p, const arc_halfspace_friction *begin,
                         arc_halfspace_friction *state, arc_error *error);

/* Accepts the solution of a part in two increments as the new state. The coarser state, if any,
 * advances in one increment. */
static arc_status accept(const leg *g, part p, arc_halfspace_friction *end,
                         arc_halfspace_friction *state, arc_error *error) {
  const arc_halfspace_friction once = *state;
  *state = *end;
  *end = once;
  return g->coarser ? advance(g, p.to, state, g->coarser, error) : ARC_OK;
}

/* Refines both halves of a part of a leg. On input *middle is the solution of the first half in one
 * increment. */
static arc_status refine_halves(leg *g, part p, const arc_halfspace_friction *begin,
                                arc_halfspace_friction *middle, arc_halfspace_friction *state,
                                arc_error *error) {
  const double half = (p.from + p.to) / 2;
  arc_halfspace_friction end;
  arc_status status = refine(g, (part){p.from, half, p.halvings + 1}, begin, middle, error);
  if (status == ARC_OK) status = arc_halfspace_friction_copy(g->h, middle, &end, error);
  if (status != ARC_OK) return status;
  status = advance(g, p.to, state, &end, error);
  if (status == ARC_OK) status = refine(g, (part){half, p.to, p.halvings + 1}, middle, &end, error);
  arc_halfspace_friction_end(status == ARC_OK ? state : &end);
  if (status == ARC_OK) *state = end;
  return status;
}

/* Solves a part of a leg in two increments. Returns the state after the first increment in *middle
 * and the state after the second in *end. The caller frees both states, also after an error. */
static arc_status halve(const leg *g, part p, const arc_halfspace_friction *begin,
                        const arc_halfspace_friction *once, arc_halfspace_friction *middle,
                        arc_halfspace_friction *end, arc_error *error) {
  *middle = *end = (arc_halfspace_friction){.pressure = NULL};
  arc_status status = arc_halfspace_friction_copy(g->h, begin, middle, error);
  if (status == ARC_OK) status = advance(g, (p.from + p.to) / 2, NULL, middle, error);
  if (status == ARC_OK) status = arc_halfspace_friction_copy(g->h, middle, end, error);
  return status == ARC_OK ? advance(g, p.to, once, end, error) : status;
}

/* Refines a part of a leg. On input *state is the solution of the part in one increment. It is
 * replaced by the solution in as many increments as necessary. */
static arc_status refine(leg *g, part p, const arc_halfspace_friction *begin,
                         arc_halfspace_friction *state, arc_error *error) {
  enum { most_halvings = 9, most_for_turns = 40 };
  arc_halfspace_friction middle, end;
  arc_status status = halve(g, p, begin, state, &middle, &end, error);
  if (status == ARC_OK) {
    const solutions s = {begin, state, &middle, &end};
    if (p.halvings == 0) find_scales(g, &s);
    const int turns = turns_at_once(g, &s), resolved = !turns && is_resolved(g, &s);
    const int last = p.halvings >= (turns ? most_for_turns : most_halvings);
    g->effort->unresolved += last && !resolved;
    status = resolved || last ? accept(g, p, &end, state, error)
                              : refine_halves(g, p, begin, &middle, state, error);
  }
  arc_halfspace_friction_end(&middle);
  arc_halfspace_friction_end(&end);
  return status;
}

/* --- legs ------------------------------------------------------------------------------------- */

/* Updates the coarser state after a leg whose increments the user chose. It becomes a copy of the
 * finer state, but the difference of their energies, caused by earlier legs, remains. */
static arc_status follow_finer(const leg *g, double before, const arc_halfspace_friction *state,
                               arc_error *error) {
  arc_halfspace_friction copy;
  const arc_status status = arc_halfspace_friction_copy(g->h, state, &copy, error);
  if (status != ARC_OK) return status;
  copy.energy = g->coarser->energy + state->energy - before;
  arc_halfspace_friction_end(g->coarser);
  *g->coarser = copy;
  return ARC_OK;
}

static arc_status go(leg *g, const arc_halfspace_friction *begin, arc_halfspace_friction *state,
                     arc_error *error) {
  arc_status status = ARC_OK;
  const int given = g->def->increments, n = given > 0 ? given : 1;
  for (int i = 1; i <= n && status == ARC_OK; i++)
    status = advance(g, (double)i / n, NULL, state, error);
  if (status == ARC_OK && given == 0 && g->def->to.friction > 0)
    return refine(g, (part){.to = 1}, begin, state, error);
  return status == ARC_OK && g->coarser ? follow_finer(g, begin->energy, state, error) : status;
}

/* Replaces the state by `copy`, or frees the copy after an error. */
static void commit(arc_status status, arc_halfspace_friction *copy, arc_halfspace_friction *state) {
  arc_halfspace_friction_end(status == ARC_OK ? state : copy);
  if (status == ARC_OK) *state = *copy;
}

arc_status arc_halfspace_follow(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_leg *def, const arc_halfspace_options *options,
                                arc_halfspace_friction *state, arc_halfspace_friction *coarser,
                                arc_halfspace_effort *effort, arc_error *error) {
  arc_halfspace_effort ignored = {0};
  arc_halfspace_friction end, beside = {.pressure = NULL};
  leg g = {.h = h,
           .depth = depth,
           .def = def,
           .options = options,
           .xi = {state->xi[0], state->xi[1]},
           .force = {state->force[0], state->force[1]},
           .coarser = coarser ? &beside : NULL,
           .effort = effort ? effort : &ignored};
  arc_status status = arc_halfspace_friction_copy(h, state, &end, error);
  if (status == ARC_OK && coarser) status = arc_halfspace_friction_copy(h, coarser, &beside, error);
  if (status != ARC_OK) {
    arc_halfspace_friction_end(&end);
    return status;
  }
  status = go(&g, state, &end, error);
  commit(status, &end, state);
  if (coarser) commit(status, &beside, coarser);
  return status;
}

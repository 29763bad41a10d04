/* What surfaces under one load remember of the forces that sheared them.
 *
 * Pushed one way, nodes slip one after the other, those last that stick best. Where the plate turns
 * all stick, and the same nodes slip the other way in the same order, each after twice the force.
 * Once the force is back where an inner loop began that loop is forgotten, as if it had never been
 * (Masing's and Madelung's rules): what is to come depends on the forces at which the plate turned
 * and that no later way has passed. The first way, on surfaces without shear, is half such a way
 * from the other side. Where there was shear that another load has left, nothing is known of the
 * first way; of those after it, as long as the force stays where it was since. */
#include "core/friction/friction.h"

#include <math.h>
#include <string.h>

/* Forces or loads that differ by less than this share of the load count as equal. */
static const double rounding = 1e-9;

/* Direction of the plate under a constant load; 0: unknown. */
static int sense_of(const friction_task *k, const friction_state *s) {
  static const double still = 1e-12;
  const double way = k->dx + k->w->shear.shift;
  if (k->step->mu == 0 || fabs(k->step->line - s->line) > rounding * s->line) return 0;
  if (fabs(way) <= still * fabs(k->p->approach)) return s->memory.sense;
  return way > 0 ? 1 : -1;
}

/* True if the shear is negligible. */
static int is_free(const friction_state *s, double mu) {
  static const double little = 0.1;
  double sum = 0;
  for (int i = 0; i < s->nc; i++) sum += fabs(s->t[i]);
  return sum <= little * mu * s->line;
}

/* Force at which the present motion closes a loop [N/mm]. */
static double loop_end(const friction_memory *m) {
  if (m->count < 2) return copysign(INFINITY, m->sense);
  if (m->count == 2 && m->fresh) return 2 * m->turn[0].force - m->turn[1].force;
  return m->turn[m->count - 2].force;
}

/* Removes the closed loop and continues on the motion before it. */
static double close_loop(friction_memory *m) {
  friction_turn *last = &m->turn[m->count - 1];
  const double whole = (m->count == 2 && m->fresh ? 2 : 1) * last->energy;
  const double rest = whole - m->energy;
  m->energy = m->count == 2 ? last->energy : last[-1].energy;
  if (m->count == 2 && !m->fresh) m->turn[0] = *last;
  m->count -= m->count == 2 ? 1 : 2;
  return rest;
}

void arc_friction_close_loops(friction_state *s) {
  friction_memory *m = &s->memory;
  while (m->sense * (s->tangential - loop_end(m)) > -rounding * s->line) {
    const double rest = close_loop(m);
    s->between += rest;
    s->energy += rest;
  }
}

double arc_friction_rise(const friction_memory *m, double force) {
  const double way = fmax(0, m->sense * (force - m->turn[m->count - 1].force));
  return m->count == 1 && m->fresh ? way : way / 2;
}

/* Drops the oldest turning point. */
static void note_turn(friction_memory *m, double force) {
  if (m->count == ARC_FRICTION_TURNS) {
    memmove(&m->turn[0], &m->turn[1], (ARC_FRICTION_TURNS - 1) * sizeof *m->turn);
    m->count--;
    m->fresh = 0;
  }
  m->turn[m->count++] = (friction_turn){force, m->energy};
  m->energy = 0;
}

void arc_friction_turn(const friction_task *k, friction_state *s) {
  friction_memory *m = &s->memory;
  const int sense = sense_of(k, s), turns = sense != m->sense;
  if (sense == 0) *m = (friction_memory){0};
  if (sense == 0 || !turns) return;
  if (m->count == 0)
    m->fresh = is_free(s, k->step->mu);
  else
    arc_friction_close_loops(s);
  note_turn(m, s->tangential);
  m->sense = sense;
}

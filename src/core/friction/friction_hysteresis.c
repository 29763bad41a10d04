/* Stores the reversals of the tangential force under a constant load. During a motion in one
 * direction nodes begin to slip one after the other. At a reversal all nodes stick; then they slip
 * back in the same order, each after twice the change of force. A hysteresis loop is closed and
 * removed when the force returns to its start (rules of Masing and Madelung). Later states
 * therefore depend only on the reversals of loops that are still open. A first motion, on surfaces
 * without shear, is half of a motion after a reversal. If shear remains from an earlier load, the
 * energy of the first motion is not corrected. The energy of later motions is corrected only while
 * the force stays within the range covered under the present load. */
#include "core/friction/friction.h"

#include <math.h>
#include <string.h>

/* Forces or loads count as equal if they differ by less than this fraction of the load. */
static const double rounding = 1e-9;

/* Returns the direction of the plate's motion under a constant load: 1 or -1, or 0 if it is unknown
 * or the load changes. */
static int sense_of(const friction_task *k, const friction_state *s) {
  static const double still = 1e-12;
  const double motion = k->dx + k->w->shear.shift;
  if (k->step->mu == 0 || fabs(k->step->line - s->line) > rounding * s->line) return 0;
  if (fabs(motion) <= still * fabs(k->p->approach)) return s->memory.sense;
  return motion > 0 ? 1 : -1;
}

/* Returns true if the remaining shear forces are small compared with the limit of friction. */
static int is_free(const friction_state *s, double mu) {
  static const double little = 0.1;
  double sum = 0;
  for (int i = 0; i < s->nc; i++) sum += fabs(s->t[i]);
  return sum <= little * mu * s->line;
}

/* Returns the force at which the present motion closes a loop [N/mm]. */
static double loop_end(const friction_memory *m) {
  if (m->count < 2) return copysign(INFINITY, m->sense);
  if (m->count == 2 && m->fresh) return 2 * m->turn[0].force - m->turn[1].force;
  return m->turn[m->count - 2].force;
}

/* Removes the closed loop and continues with the motion before the loop. Returns the part of the
 * loop's energy correction [N] that the present motion does not include yet. */
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
  const double change = fmax(0, m->sense * (force - m->turn[m->count - 1].force));
  return m->count == 1 && m->fresh ? change : change / 2;
}

/* Appends a reversal at a force [N/mm]. If the list is full, the oldest reversal is removed. */
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

/* Implements the state of a contact with friction: allocation, copies and the unloaded state. Also
 * defines the increments in which the load is applied. */
#include "core/friction/friction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t numbers_of(const friction_state *s) {
  return 4 * (size_t)s->nc + 2 * (size_t)(s->nc + s->np);
}

arc_status arc_friction_create(friction_state *s, const arc_model *model, double x) {
  *s = (friction_state){.nc = arc_model_mesh(model, ARC_CYLINDER)->surface,
                        .np = arc_model_mesh(model, ARC_PLATE)->surface,
                        .x = x};
  const size_t nc = (size_t)s->nc;
  s->f = calloc(numbers_of(s), sizeof(double)); /* one block for all arrays */
  if (!s->f) return ARC_MEMORY;
  s->t = s->f + nc;
  s->slip = s->t + nc;
  s->slip_path = s->slip + nc;
  s->u[ARC_CYLINDER] = s->slip_path + nc;
  s->u[ARC_PLATE] = s->u[ARC_CYLINDER] + 2 * nc;
  return ARC_OK;
}

void arc_friction_reset(friction_state *s, double x) {
  memset(s->f, 0, arc_friction_bytes(s));
  s->x = x;
  s->approach = s->line = s->tangential = s->energy = s->between = 0;
  s->memory = (friction_memory){0};
}

void arc_friction_free(friction_state *s) {
  free(s->f);
  *s = (friction_state){0};
}

size_t arc_friction_bytes(const friction_state *s) {
  return numbers_of(s) * sizeof *s->f;
}

int arc_friction_press_increments(const arc_model *model, double load) {
  static const double an_element = 4, least = 20, most = 400;
  const arc_model_def *def = arc_model_definition(model);
  const double elements = arc_model_half_width(def, load) / def->mesh.size;
  return (int)fmin(most, fmax(least, ceil(an_element * elements)));
}

friction_step arc_friction_pressing(const friction_step *to, int i, int n) {
  const double share = (double)i / n;
  friction_step step = *to;
  step.line *= share * share;
  return step;
}

void arc_friction_copy(friction_state *to, const friction_state *from) {
  to->x = from->x;
  to->approach = from->approach;
  to->line = from->line;
  to->tangential = from->tangential;
  to->energy = from->energy;
  to->between = from->between;
  to->memory = from->memory;
  memcpy(to->f, from->f, arc_friction_bytes(from));
}

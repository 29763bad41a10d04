/* Allocates workspaces for increments with friction. */
#include "core/base/carve.h"
#include "core/friction/friction.h"

#include <stdlib.h>

static arc_status create_shear(shear_problem *s, size_t n) {
  const carve_part parts[] = {{&s->bound, n}, {&s->drive, n},  {&s->t, n},    {&s->slip, n},
                              {&s->ones, n},  {&s->target, n}, {&s->held, n}, {&s->pulled, n}};
  s->factor = malloc(n * n * sizeof(double));
  s->direction = calloc(3 * n, sizeof(int));
  if (!ARC_CARVE(parts) || !s->factor || !s->direction) return ARC_MEMORY;
  s->list = s->direction + n;
  s->pick = s->list + n;
  return ARC_OK;
}

static size_t coupled_size(size_t nc) {
  return 2 * nc * (2 * nc + 3);
}

arc_status arc_friction_workspace_create(friction_workspace *w, const arc_model *model) {
  const size_t nc = (size_t)arc_model_mesh(model, ARC_CYLINDER)->surface;
  const size_t np = (size_t)arc_model_mesh(model, ARC_PLATE)->surface;
  *w =
      (friction_workspace){.nc = (int)nc, .np = (int)np, .sweeps_before_newton = 4, .by_force = 50};
  const carve_part parts[] = {{&w->gap, nc},     {&w->sheared, nc},        {&w->before, nc},
                              {&w->t, nc},       {&w->slip, nc},           {&w->reserve, nc},
                              {&w->dragged, nc}, {&w->work, 4 * (nc + np)}};
  w->coupled = malloc(coupled_size(nc) * sizeof(double));
  w->pivots = malloc(6 * nc * sizeof(int));
  if (!ARC_CARVE(parts) || !w->coupled || !w->pivots || create_shear(&w->shear, nc) != ARC_OK) {
    arc_friction_workspace_free(w);
    return ARC_MEMORY;
  }
  return ARC_OK;
}

void arc_friction_workspace_free(friction_workspace *w) {
  free(w->gap);
  free(w->coupled);
  free(w->pivots);
  free(w->shear.bound);
  free(w->shear.factor);
  free(w->shear.direction);
  *w = (friction_workspace){0};
}

size_t arc_friction_workspace_bytes(const friction_workspace *w) {
  const size_t nc = (size_t)w->nc, np = (size_t)w->np;
  return sizeof *w + (nc * nc + coupled_size(nc) + 19 * nc + 4 * np) * sizeof(double) +
         9 * nc * sizeof(int);
}

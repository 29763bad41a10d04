/* Room for increments with friction. */
#include "core/friction/friction.h"

#include <stdlib.h>

static arc_status create_shear(shear_problem *s, size_t n) {
  s->bound = calloc(8 * n, sizeof(double));
  s->factor = malloc(n * n * sizeof(double));
  s->way = calloc(3 * n, sizeof(int));
  if (!s->bound || !s->factor || !s->way) return ARC_MEMORY;
  s->drive = s->bound + n;
  s->t = s->drive + n;
  s->slip = s->t + n;
  s->ones = s->slip + n;
  s->target = s->ones + n;
  s->held = s->target + n;
  s->pulled = s->held + n;
  s->list = s->way + n;
  s->pick = s->list + n;
  return ARC_OK;
}

static size_t coupled_size(size_t nc) {
  return 2 * nc * (2 * nc + 3);
}

arc_status arc_friction_workspace_create(friction_workspace *w, const arc_model *model) {
  const size_t nc = (size_t)arc_model_mesh(model, ARC_CYLINDER)->surface;
  const size_t np = (size_t)arc_model_mesh(model, ARC_PLATE)->surface;
  *w = (friction_workspace){.nc = (int)nc, .np = (int)np, .patience = 4, .by_force = 50};
  w->gap = calloc(7 * nc + 4 * (nc + np), sizeof(double));
  w->coupled = malloc(coupled_size(nc) * sizeof(double));
  w->pivots = malloc(6 * nc * sizeof(int));
  if (!w->gap || !w->coupled || !w->pivots || create_shear(&w->shear, nc) != ARC_OK) {
    arc_friction_workspace_free(w);
    return ARC_MEMORY;
  }
  w->sheared = w->gap + nc;
  w->before = w->sheared + nc;
  w->t = w->before + nc;
  w->slip = w->t + nc;
  w->reserve = w->slip + nc;
  w->dragged = w->reserve + nc;
  w->work = w->dragged + nc;
  return ARC_OK;
}

void arc_friction_workspace_free(friction_workspace *w) {
  free(w->gap);
  free(w->coupled);
  free(w->pivots);
  free(w->shear.bound);
  free(w->shear.factor);
  free(w->shear.way);
  *w = (friction_workspace){0};
}

size_t arc_friction_workspace_bytes(const friction_workspace *w) {
  const size_t nc = (size_t)w->nc, np = (size_t)w->np;
  return sizeof *w + (nc * nc + coupled_size(nc) + 19 * nc + 4 * np) * sizeof(double) +
         9 * nc * sizeof(int);
}

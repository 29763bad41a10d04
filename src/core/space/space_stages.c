/* Stages of an implicit step on half-spaces: the pressures of all positions with the wear of the
 * stage in their gaps, one convex problem. A step starts from the shapes alone, so that its bits do
 * not depend on what was solved before. */
#include "core/space/space_kind.h"

#include "core/base/carve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct stages {
  space_path path;
  double *pressure, *trial;                  /* [count][window] */
  double *known[ARC_BODIES], *z[ARC_BODIES]; /* [sites] depths [mm], those of the shape included */
} stages;

arc_status arc_space_begin_stages(wear_stage *s) {
  const arc_wear *w = s->run;
  stages *own = s->own = calloc(1, sizeof *own);
  if (!own) return ARC_MEMORY;
  const arc_status status = arc_space_path(w, &s->window, &own->path, &s->error);
  if (status != ARC_OK) return status;
  const size_t nc = (size_t)w->nc, np = (size_t)w->np,
               all = (size_t)(own->path.count > 0 ? own->path.count : 1) * nc;
  const carve_part parts[] = {{&own->pressure, all}, {&own->trial, all}, {&own->known[0], nc},
                              {&own->known[1], np},  {&own->z[0], nc},   {&own->z[1], np}};
  return ARC_CARVE(parts) ? ARC_OK : ARC_MEMORY;
}

void arc_space_end_stages(wear_stage *s, double cycles, wear_depths *depth) {
  stages *own = s->own;
  (void)cycles;
  (void)depth;
  if (!own) return;
  free(own->path.position);
  free(own->pressure);
  free(own);
  s->own = NULL;
}

static void note(wear_stage *s, double peak) {
  const stages *own = s->own;
  s->last = (wear_rate){.peak = peak};
  for (int j = 0; j < own->path.count; j++)
    s->last.pressed += own->path.position[j].weight * own->path.position[j].load;
  s->watch->solutions += own->path.count;
}

arc_status arc_space_start(wear_stage *s, double *rate) {
  stages *own = s->own;
  arc_wear *w = s->run;
  const space_shape *shape = space_shape_of(s->window.shape);
  const double *const depth[] = {shape->depth[ARC_UPPER], shape->depth[ARC_LOWER]};
  double *const to[] = {sites_from(w, rate, ARC_UPPER), sites_from(w, rate, ARC_LOWER)};
  const arc_halfspace_options options = {.callbacks = s->watch->callbacks};
  arc_halfspace_report report = {0};
  const int n = w->nc + w->np;
  memset(rate, 0, (size_t)n * sizeof *rate);
  memset(s->z, 0, (size_t)n * sizeof *s->z);
  memset(s->worn, 0, (size_t)n * sizeof *s->worn);
  if (own->path.count == 0) return ARC_OK;
  const arc_status status =
      arc_halfspace_rate(shape->grid->h, depth, own->path.position, own->path.count, &options,
                         own->pressure, to, &report, &s->error);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < sites_of(w, b); i++) to[b][i] *= s->k[b];
  note(s, report.p_max);
  return status;
}

/* Solves z = known + h k rate(z), whose known part is the shape's and s->known, with `more` on top
 * where not NULL; starts from `pressure`, and leaves those of the solution there. */
static arc_status solve(wear_stage *s, double h, const double *more, double *pressure,
                        double *peak) {
  stages *own = s->own;
  arc_wear *w = s->run;
  const space_shape *shape = space_shape_of(s->window.shape);
  const arc_halfspace_wear wear = {.c = {h * s->k[ARC_UPPER], h * s->k[ARC_LOWER]}};
  const arc_halfspace_options options = {.warm = 1, .callbacks = s->watch->callbacks};
  const double *const known[] = {own->known[ARC_UPPER], own->known[ARC_LOWER]};
  double *const to[] = {own->z[ARC_UPPER], own->z[ARC_LOWER]};
  arc_halfspace_report report = {0};
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *fixed = sites_from(w, s->known, b);
    for (int i = 0; i < sites_of(w, b); i++)
      own->known[b][i] =
          shape->depth[b][i] + fixed[i] + (more ? more[(b == ARC_UPPER ? 0 : w->nc) + i] : 0);
  }
  const arc_status status =
      arc_halfspace_stage(shape->grid->h, known, &wear, own->path.position, own->path.count,
                          &options, pressure, to, &report, &s->error);
  *peak = report.p_max;
  return status;
}

arc_status arc_space_stage(wear_stage *s, double h, double *rate) {
  stages *own = s->own;
  arc_wear *w = s->run;
  double peak = 0;
  if (own->path.count > 0) {
    const arc_status status = solve(s, h, NULL, own->pressure, &peak);
    if (status != ARC_OK) return status;
  }
  for (int b = 0; b < ARC_BODIES; b++) {
    double *r = sites_from(w, rate, b), *z = sites_from(w, s->z, b);
    const double *fixed = sites_from(w, s->known, b);
    for (int i = 0; i < sites_of(w, b); i++) {
      const int wears = own->path.count > 0 && h * s->k[b] > 0;
      r[i] = wears ? (own->z[b][i] - own->known[b][i]) / h : 0;
      z[i] = fixed[i] + h * r[i];
    }
  }
  memcpy(s->worn, s->z, (size_t)(w->nc + w->np) * sizeof *s->worn);
  note(s, peak);
  return ARC_OK;
}

/* A defect of the known part, seen through the stage: what stiff ripples it has, pressures take
 * back within the step. */
double arc_space_error(wear_stage *s, double h, double *defect) {
  stages *own = s->own;
  arc_wear *w = s->run;
  const size_t all = (size_t)own->path.count * (size_t)w->nc;
  double peak = 0, change = 0, largest = 0;
  if (own->path.count == 0) return 0;
  memcpy(own->trial, own->pressure, all * sizeof *own->trial);
  if (solve(s, h, defect, own->trial, &peak) != ARC_OK) return -1;
  const space_shape *shape = space_shape_of(s->window.shape);
  for (int b = 0; b < ARC_BODIES; b++) {
    double *d = sites_from(w, defect, b);
    const double *z = sites_from(w, s->z, b);
    for (int i = 0; i < sites_of(w, b); i++) d[i] = own->z[b][i] - shape->depth[b][i] - z[i];
  }
  for (size_t i = 0; i < all; i++) {
    change = fmax(change, fabs(own->trial[i] - own->pressure[i]));
    largest = fmax(largest, own->pressure[i]);
  }
  return largest > 0 ? change / largest : 0;
}

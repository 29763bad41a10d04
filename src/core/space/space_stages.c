/* Stages of an implicit step on half-spaces. The pressures of all positions, with the wear of the
 * stage in their gaps, are the solution of one convex problem. A step uses only the shapes and no
 * earlier solution, so that its result is reproducible in all bits. */
#include "core/space/space_kind.h"

#include "core/base/carve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tolerances of the gaps in a stage and in an error estimate, divided by the tolerance of a
 * step. */
static const double of_stage = 0.03, of_estimate = 0.1;

typedef struct stages {
  space_path path;
  double *pressure, *trial;                  /* [count][window] */
  double *known[ARC_BODIES], *z[ARC_BODIES]; /* [sites] known part and solution z of a stage: depths
                                                that include the depths of the shape [mm] */
  int linear; /* 1 if the wear is k p ds with the same k at all sites */
  double *work[ARC_BODIES], *factor[ARC_BODIES]; /* [sites] see arc_space_linearise */
  double
      *open[ARC_BODIES]; /* [sites] factor times k of the exposed layer, divided by the largest k */
} stages;

arc_status arc_space_begin_stages(wear_stage *s) {
  const arc_wear *w = s->run;
  stages *own = s->own = calloc(1, sizeof *own);
  if (!own) return ARC_MEMORY;
  const arc_status status = arc_space_path(w, &s->window, &own->path, &s->error);
  if (status != ARC_OK) return status;
  const size_t nc = (size_t)w->nc, np = (size_t)w->np,
               all = (size_t)(own->path.count > 0 ? own->path.count : 1) * nc;
  const carve_part parts[] = {{&own->pressure, all}, {&own->trial, all},  {&own->known[0], nc},
                              {&own->known[1], np},  {&own->z[0], nc},    {&own->z[1], np},
                              {&own->work[0], nc},   {&own->work[1], np}, {&own->factor[0], nc},
                              {&own->factor[1], np}, {&own->open[0], nc}, {&own->open[1], np}};
  own->linear = arc_space_is_linear(w, s->window.state) && !w->manner.layered[ARC_UPPER] &&
                !w->manner.layered[ARC_LOWER];
  return ARC_CARVE(parts) ? ARC_OK : ARC_MEMORY;
}

void arc_space_end_stages(wear_stage *s, double cycles, wear_depths *depth) {
  stages *own = s->own;
  (void)cycles;
  (void)depth;
  if (!own) return;
  arc_space_end_path(&own->path);
  free(own->pressure);
  free(own);
  s->own = NULL;
}

static void note(wear_stage *s, double peak) {
  const stages *own = s->own;
  s->last.peak = peak;
  s->last.pressed = 0;
  for (int j = 0; j < own->path.count; j++)
    s->last.pressed += own->path.position[j].weight * own->path.position[j].load;
  s->progress->solutions += own->path.count;
}

/* Computes the wear work of own->pressure and its linearisation. */
static arc_status linearise(wear_stage *s) {
  stages *own = s->own;
  arc_status status = ARC_OK;
  const double mu = s->window.mu;
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = arc_space_linearise(s->run, s->window.state, space_shape_of(s->window.shape),
                                 &own->path, own->pressure, mu, (arc_body)b, own->work[b],
                                 own->factor[b], &s->error);
  return status;
}

arc_status arc_space_start(wear_stage *s, double *rate) {
  stages *own = s->own;
  arc_wear *w = s->run;
  const space_shape *shape = space_shape_of(s->window.shape);
  const double *const depth[] = {shape->depth[ARC_UPPER], shape->depth[ARC_LOWER]};
  double *const to[] = {sites_from(w, rate, ARC_UPPER), sites_from(w, rate, ARC_LOWER)};
  wear_rate sums = {.node = {to[ARC_UPPER], to[ARC_LOWER]}};
  const int n = w->nc + w->np;
  memset(rate, 0, (size_t)n * sizeof *rate);
  memset(s->z, 0, (size_t)n * sizeof *s->z);
  memset(s->worn, 0, (size_t)n * sizeof *s->worn);
  if (own->path.count == 0) return ARC_OK;
  const arc_status status = arc_space_solve_path(w, &s->window, depth, &own->path, s->progress,
                                                 own->pressure, &sums, &s->error);
  s->last = sums;
  if (status != ARC_OK) return status;
  if (!own->linear) {
    if (linearise(s) != ARC_OK) return s->error.status;
    for (int b = 0; b < ARC_BODIES; b++)
      memcpy(to[b], own->work[b], (size_t)sites_of(w, b) * sizeof *to[b]);
  }
  for (int b = 0; b < ARC_BODIES; b++)
    for (int i = 0; i < sites_of(w, b); i++) to[b][i] *= s->k[b];
  return ARC_OK;
}

/* Returns the part of a site's depth that does not depend on the pressures [mm], and stores
 * own->open. `due` is this part for the largest k, and `about` is the depth due to own->work. If
 * the body has layers, the depth is linearised about `about`. */
static double known_at(const wear_stage *s, int b, int i, double due, double about) {
  const stages *own = s->own;
  const double h = space_shape_of(s->window.shape)->depth[b][i];
  double share;
  if (!s->run->manner.layered[b]) {
    own->open[b][i] = own->factor[b][i];
    return h + due;
  }
  const double worn = arc_space_worn(s->window.shape, (arc_body)b, i, about, &share);
  own->open[b][i] = share * own->factor[b][i];
  return h + worn + share * (due - about);
}

/* Sets own->known to the sum of four parts: the depths of the shape, s->known, `more` (unless
 * NULL), and the wear of own->pressure without its linear part. */
static void set_known(wear_stage *s, double h, const double *more) {
  stages *own = s->own;
  arc_wear *w = s->run;
  const double rest = own->linear ? 0 : 1 - arc_space_law_growth(w);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *fixed = sites_from(w, s->known, b), *on_top = more ? more : NULL;
    if (on_top && b == ARC_LOWER) on_top += w->nc;
    for (int i = 0; i < sites_of(w, b); i++) {
      const double before = fixed[i] + (on_top ? on_top[i] : 0),
                   work = own->linear ? 0 : h * s->k[b] * own->work[b][i];
      own->known[b][i] = known_at(s, b, i, before + rest * work, before + work);
    }
  }
}

/* Returns the tolerance of the gaps: `share` times the tolerance of a step's depths. A share of
 * 0.03 changes the depths of a step by less than 0.01 of the step's tolerance; a share of 0.1
 * changes an estimated error by 5 %. */
static double gap_tolerance(const arc_wear *w, double share) {
  static const double finest = 1e-6, usual = 1e-5, coarsest = 1e-4;
  const double tolerance = w->def.tolerance;
  return tolerance > 0 ? fmin(coarsest, fmax(finest, share * tolerance)) : usual;
}

/* Solves own->z = own->known + h k rate with the linearised rate, to the tolerance of gaps
 * gap_tolerance(share). `pressure` is the initial guess and is replaced by the solution. */
static arc_status solve(wear_stage *s, double h, double share, double *pressure, double *peak) {
  stages *own = s->own;
  const space_shape *shape = space_shape_of(s->window.shape);
  const arc_halfspace_wear wear = {
      .c = {h * s->k[ARC_UPPER], h * s->k[ARC_LOWER]},
      .factor = {own->linear ? NULL : own->open[0], own->linear ? NULL : own->open[1]}};
  const arc_halfspace_options options = {.warm = 1,
                                         .tolerance = gap_tolerance(s->run, share),
                                         .gap = own->path.gap,
                                         .callbacks = s->progress->callbacks};
  const double *const known[] = {own->known[ARC_UPPER], own->known[ARC_LOWER]};
  double *const to[] = {own->z[ARC_UPPER], own->z[ARC_LOWER]};
  arc_halfspace_report report = {0};
  const arc_status status =
      arc_halfspace_stage(shape->grid->h, known, &wear, own->path.position, own->path.count,
                          &options, pressure, to, &report, &s->error);
  *peak = report.p_max;
  return status;
}

/* Sets own->z to the sum of the depths of the shape, s->known and the wear of own->pressure.
 * Returns the largest change of own->z divided by the largest depth. */
static double take_work(wear_stage *s, double h) {
  stages *own = s->own;
  arc_wear *w = s->run;
  double change = 0, deepest = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *fixed = sites_from(w, s->known, b),
                 *depth = space_shape_of(s->window.shape)->depth[b];
    for (int i = 0; i < sites_of(w, b); i++) {
      const double due = h * s->k[b] * own->work[b][i];
      own->known[b][i] = depth[i] + fixed[i];
      const double z =
          w->manner.layered[b]
              ? depth[i] + arc_space_worn(s->window.shape, (arc_body)b, i, fixed[i] + due, NULL)
              : own->known[b][i] + due;
      change = fmax(change, fabs(z - own->z[b][i]));
      deepest = fmax(deepest, z);
      own->z[b][i] = z;
    }
  }
  return deepest > 0 ? change / deepest : 0;
}

/* Computes the slip of the cycle on the depths own->z, under own->pressure. */
static arc_status find_slip(wear_stage *s) {
  stages *own = s->own;
  const double *const depth[] = {own->z[ARC_UPPER], own->z[ARC_LOWER]};
  return arc_space_slip(s->run, &s->window, depth, &own->path, own->pressure, s->progress, &s->last,
                        &s->error);
}

/* Solves linearised problems repeatedly until the solution satisfies the wear law. */
static arc_status solve_law(wear_stage *s, double h, double *peak) {
  enum { most_passes = 20 };
  static const double settled = 1e-5; /* accepted change, relative to the largest depth */
  stages *own = s->own;
  for (int pass = 0; pass < most_passes; pass++) {
    set_known(s, h, NULL);
    arc_status status = solve(s, h, of_stage, own->pressure, peak);
    if (status == ARC_OK && own->path.slip) status = find_slip(s);
    if (status == ARC_OK) status = linearise(s);
    if (status != ARC_OK) return status;
    if (take_work(s, h) < settled) return ARC_OK;
  }
  return arc_fail(&s->error, ARC_NOT_CONVERGED,
                  "wear and pressures did not converge in %d iterations", most_passes);
}

arc_status arc_space_stage(wear_stage *s, double h, double *rate) {
  stages *own = s->own;
  arc_wear *w = s->run;
  double peak = 0;
  if (own->path.count > 0) {
    set_known(s, h, NULL);
    const arc_status status =
        own->linear ? solve(s, h, of_stage, own->pressure, &peak) : solve_law(s, h, &peak);
    if (status != ARC_OK) return status;
  }
  for (int b = 0; b < ARC_BODIES; b++) {
    double *r = sites_from(w, rate, b), *z = sites_from(w, s->z, b);
    const double *fixed = sites_from(w, s->known, b);
    for (int i = 0; i < sites_of(w, b); i++) {
      const int wears = own->path.count > 0 && h * s->k[b] > 0;
      r[i] = !wears                 ? 0
             : w->manner.layered[b] ? s->k[b] * own->work[b][i]
                                    : (own->z[b][i] - own->known[b][i]) / h;
      z[i] = fixed[i] + h * r[i];
    }
  }
  memcpy(s->worn, s->z, (size_t)(w->nc + w->np) * sizeof *s->worn);
  arc_space_through_layers(s->window.shape, s->worn);
  note(s, peak);
  return ARC_OK;
}

/* Returns the fraction of a position's load that is carried by other cells if the pressures
 * own->pressure change to own->trial. */
static double shifted(const stages *own, int position, int cells) {
  const double *p = own->pressure + (size_t)position * (size_t)cells,
               *trial = own->trial + (size_t)position * (size_t)cells;
  double change = 0, load = 0;
  for (int i = 0; i < cells; i++) {
    change += fabs(trial[i] - p[i]);
    load += p[i];
  }
  return load > 0 ? change / (2 * load) : 0;
}

/* Converts a defect of the known part to the error of the step, because the pressures remove stiff
 * ripples of the defect within the step. The remaining error is largest at cells that enter the
 * contact, where the pressure has a kink in time. At most a quarter of it remains in the depth of
 * any cell. In tests, depths with a tolerance of 1e-3 differed from those with 3e-5 by 0.1 to 1.2
 * tolerances at the worst cell (strokes of 0.5 to 8 half widths, alpha of 0 to 1, 6 and 12 cells in
 * a half width, four distances). */
double arc_space_error(wear_stage *s, double h, double *defect) {
  static const double left = 0.25;
  stages *own = s->own;
  arc_wear *w = s->run;
  const size_t all = (size_t)own->path.count * (size_t)w->nc;
  double peak = 0;
  if (own->path.count == 0) return 0;
  memcpy(own->trial, own->pressure, all * sizeof *own->trial);
  set_known(s, h, defect);
  if (solve(s, h, of_estimate, own->trial, &peak) != ARC_OK) return -1;
  const space_shape *shape = space_shape_of(s->window.shape);
  for (int b = 0; b < ARC_BODIES; b++) {
    double *d = sites_from(w, defect, b);
    const double *z = sites_from(w, s->worn, b);
    for (int i = 0; i < sites_of(w, b); i++)
      d[i] = left * (own->z[b][i] - shape->depth[b][i] - z[i]);
  }
  double largest = 0;
  for (int j = 0; j < own->path.count; j++) largest = fmax(largest, shifted(own, j, w->nc));
  return largest;
}

/* Computes the wear of both bodies of a joint. The wear work p |s|, pressure times sliding
 * distance, is computed at the cup's cells. The head receives the same total work, at the points
 * that face these cells at the present rotation. */
#include "core/base/carve.h"
#include "core/sphere/sphere.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Data of one update. */
typedef struct sweep {
  arc_joint *j;
  const arc_joint_wear_def *def;
  double cycles, alpha;
  double *was;              /* state of the joint before the update */
  double *gain[ARC_BODIES]; /* [sites] depth [mm] by which the surface is lowered at the end of an
                               explicit update */
  double *shear, *mean;     /* [sites][3] sums of p |s| t t' over a cycle, for the cross-shear;
                               [sites] mean pressure */
  double *k, *loss, *share; /* [sites] wear coefficient k; [sites] wear depth k N p |s| of an
                               instant in N cycles [mm]; [sites] cross-shear */
  arc_joint_record record;
} sweep;

static int begin(sweep *s) {
  const size_t n = (size_t)s->j->sites;
  const carve_part parts[] = {{&s->gain[0], n},   {&s->gain[1], n},
                              {&s->shear, 3 * n}, {&s->mean, n},
                              {&s->k, n},         {&s->loss, n},
                              {&s->share, n},     {&s->was, arc_joint_state_count(s->j)}};
  if (!ARC_CARVE(parts)) return 0;
  arc_joint_state(s->j, s->was);
  return 1;
}

/* Adds p |s| t t' of a cell to the sums for the cross-shear, with the unit vector t of sliding in
 * the directions of the angles theta and phi. */
static void add_shear(sweep *s, const double w[3], int site, double p) {
  const double *n = s->j->normal + 3 * (size_t)site;
  const double slide[3] = {w[1] * n[2] - w[2] * n[1], w[2] * n[0] - w[0] * n[2],
                           w[0] * n[1] - w[1] * n[0]};
  const double sine = sqrt(n[1] * n[1] + n[2] * n[2]), f = n[1] / sine, g = n[2] / sine;
  const double across = -sine * slide[0] + n[0] * (f * slide[1] + g * slide[2]),
               along = g * slide[1] - f * slide[2];
  const double length = sqrt(across * across + along * along);
  if (length == 0) return;
  double *t = s->shear + 3 * (size_t)site;
  t[0] += p * across * across / length;
  t[1] += p * across * along / length;
  t[2] += p * along * along / length;
}

/* Adds the wear of the head at an instant to `to`. It is scaled so that its volume is the fraction
 * alpha of `volume`, the wear volume of both bodies at this instant. */
static void wear_head(sweep *s, const double R[9], double volume, double *to) {
  arc_joint *j = s->j;
  const double alpha = s->alpha, edge = cos(0.7072 * j->size * j->d);
  double *mine = s->share,
         sum = 0; /* `share` is needed only in call_k, so its memory is a workspace here */
  for (int i = 0; i < j->sites; i++) {
    double n[3];
    const double *m = j->normal + 3 * (size_t)i;
    mine[i] = 0;
    if (R[6] * m[0] + R[7] * m[1] + R[8] * m[2] < edge) continue;
    arc_sphere_rotate(R, m, n);
    mine[i] = arc_sphere_linear(j, s->loss, n);
    sum += mine[i] * j->area[i];
  }
  if (sum <= 0) return;
  for (int i = 0; i < j->sites; i++) to[i] += alpha * volume / sum * mine[i];
  s->record.volume[ARC_UPPER] += alpha * volume;
}

static void deposit(sweep *s, const arc_gait_instant *at) {
  arc_joint *j = s->j;
  const int is_explicit = s->def->explicit_scheme;
  double *const cup = is_explicit ? s->gain[ARC_LOWER] : j->h[ARC_LOWER];
  double *const head = is_explicit ? s->gain[ARC_UPPER] : j->h[ARC_UPPER];
  double volume = 0, area = 0;
  memset(s->loss, 0, (size_t)j->sites * sizeof *s->loss);
  for (int c = 0; c < j->size * j->size; c++) {
    const double p = j->press[c];
    if (p <= 0) continue;
    const int site = sphere_site(j, c);
    const double work = p * arc_sphere_sliding(j, at->omega, site);
    s->loss[site] = s->k[site] * s->cycles * work;
    cup[site] += (1 - s->alpha) * s->loss[site];
    volume += s->loss[site] * j->area[site];
    area += j->cell[c];
    s->record.work += work * j->cell[c];
    s->record.p_peak = fmax(s->record.p_peak, p);
    s->mean[site] += p / s->def->instants;
    add_shear(s, at->omega, site, p);
  }
  s->record.area = fmax(s->record.area, area);
  s->record.rim_margin = fmin(s->record.rim_margin, arc_sphere_rim_margin(j));
  s->record.loss += volume;
  s->record.volume[ARC_LOWER] += (1 - s->alpha) * volume;
  if (s->alpha > 0) wear_head(s, at->rotation, volume, head);
}

static double size_of(const double v[3]) {
  return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Adds the number of the increment to the error message of an invalid load. */
static arc_status refuse_load(int increment, arc_error *error) {
  const arc_error why = *error;
  return arc_fail(error, why.status, "%.300s, in increment %d of the cycle", why.message,
                  increment + 1);
}

/* Solves the contacts of all instants of the cycle once, in reverse order if `backwards` is 1. */
static arc_status run(sweep *s, int backwards, const arc_callbacks *callbacks, arc_error *error) {
  double heaviest = 0;
  for (int step = 0; step < s->def->instants; step++) {
    const int i = backwards ? s->def->instants - 1 - step : step;
    const arc_gait_instant *at = &s->def->instant[i];
    const sphere_stand stand = {.rotation = at->rotation,
                                .load = at->load,
                                .omega = s->def->explicit_scheme ? NULL : at->omega,
                                .k = s->k,
                                .dose = s->cycles,
                                .instant = i};
    double approach[3];
    if (callbacks && callbacks->stop && callbacks->stop(callbacks->context))
      return arc_fail(error, ARC_STOPPED, "stopped");
    if (size_of(at->load) == 0) continue; /* no contact, so no wear */
    const arc_status status =
        arc_sphere_solve(s->j, &stand, approach, &s->record.iterations, error);
    if (status == ARC_ARGUMENT) return refuse_load(i, error);
    if (status != ARC_OK) return status;
    s->record.solutions++;
    if (size_of(at->load) > heaviest) {
      heaviest = size_of(at->load);
      memcpy(s->record.penetration, approach, sizeof approach);
    }
    deposit(s, at);
  }
  return ARC_OK;
}

/* Computes the wear coefficients of the cup's cells from the cross-shear and the mean pressure
 * of a cycle. */
static arc_status call_k(sweep *s, arc_error *error) {
  arc_joint *j = s->j;
  const double middle = s->record.cycles + s->cycles / 2;
  arc_joint_cross_shear(j, s->share);
  for (int i = 0; i < j->sites && s->def->k_function; i++) {
    s->k[i] = s->def->k_function(s->def->context, s->share[i], s->mean[i], middle);
    if (!(s->k[i] >= 0) || !isfinite(s->k[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'k': the function returned %g, expected a number >= 0 mm2/N", s->k[i]);
  }
  return ARC_OK;
}

/* Computes the creep at the end of the update from the mean pressure over all cycles until then. */
static arc_status call_creep(sweep *s, arc_error *error) {
  arc_joint *j = s->j;
  const double end = s->record.cycles + s->cycles;
  for (int i = 0; i < j->sites && s->def->creep && end > 0; i++) {
    const double p = (j->pressed[i] + s->cycles * s->mean[i]) / end;
    if (p <= 0) continue;
    j->creep[i] = s->def->creep(s->def->context, p, end);
    if (!(j->creep[i] >= 0 && j->creep[i] < j->def.radius))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'creep': the function returned %g, expected 0 mm or more, and less "
                      "than the radius",
                      j->creep[i]);
  }
  return ARC_OK;
}

static arc_status set_alpha(sweep *s, arc_error *error) {
  s->alpha = s->def->alpha;
  if (!s->def->alpha_function) return ARC_OK;
  s->alpha = s->def->alpha_function(s->def->context, s->record.cycles + s->cycles / 2);
  if (s->alpha >= 0 && s->alpha <= 1) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "field 'alpha': the function returned %g, expected 0 to 1",
                  s->alpha);
}

/* Evaluates the user's functions for alpha, k and creep. k and creep require one pass through the
 * cycle without wear. */
static arc_status set_coefficients(sweep *s, const arc_callbacks *callbacks, arc_error *error) {
  arc_joint *j = s->j;
  for (int i = 0; i < j->sites; i++) s->k[i] = s->def->k;
  const arc_status known = set_alpha(s, error);
  if (known != ARC_OK || (!s->def->k_function && !s->def->creep)) return known;
  const arc_joint_record before = s->record;
  const double cycles = s->cycles;
  s->cycles = 0;
  arc_status status = run(s, 0, callbacks, error);
  s->cycles = cycles;
  const int solutions = s->record.solutions, iterations = s->record.iterations;
  s->record = before;
  s->record.solutions = solutions;
  s->record.iterations = iterations;
  if (status != ARC_OK) return status;
  const size_t n = (size_t)j->sites;
  memcpy(j->shear, s->shear, 3 * n * sizeof(double));
  status = call_k(s, error);
  if (status == ARC_OK) status = call_creep(s, error);
  memset(s->shear, 0, 3 * n * sizeof(double));
  memset(s->mean, 0, n * sizeof(double));
  return status;
}

static arc_status check(const arc_joint_wear_def *d, double cycles, arc_error *error) {
  if (d->instants < 1) return arc_fail(error, ARC_ARGUMENT, "field 'loading': expected a gait");
  if (!d->alpha_function && !(d->alpha >= 0 && d->alpha <= 1))
    return arc_fail(error, ARC_ARGUMENT, "field 'alpha': expected 0 to 1, got %g", d->alpha);
  if (!d->k_function && !(d->k >= 0 && isfinite(d->k)))
    return arc_fail(error, ARC_ARGUMENT, "field 'k': expected a number >= 0 mm2/N, got %g", d->k);
  if (!(cycles >= 0 && isfinite(cycles)))
    return arc_fail(error, ARC_ARGUMENT, "field 'cycles': expected 0 or more, got %g", cycles);
  return ARC_OK;
}

arc_status arc_joint_update(arc_joint *j, const arc_joint_wear_def *def, double cycles,
                            const arc_callbacks *callbacks, arc_joint_record *record,
                            arc_error *error) {
  sweep s = {.j = j, .def = def, .cycles = cycles, .record = *record};
  const size_t count = arc_joint_state_count(j);
  arc_status status = check(def, cycles, error);
  if (status != ARC_OK) return status;
  if (!begin(&s)) return arc_fail(error, ARC_MEMORY, "out of memory for an update");
  const size_t n = (size_t)j->sites;
  s.record.p_peak = s.record.area = s.record.work = 0;
  s.record.rim_margin = j->def.cover;
  status = set_coefficients(&s, callbacks, error);
  if (status == ARC_OK) status = run(&s, record->updates % 2, callbacks, error);
  if (status == ARC_OK) {
    for (int b = 0; b < ARC_BODIES; b++)
      for (size_t i = 0; i < n; i++) j->h[b][i] += s.gain[b][i];
    memcpy(j->shear, s.shear, 3 * n * sizeof(double));
    for (size_t i = 0; i < n && def->creep; i++) j->pressed[i] += cycles * s.mean[i];
    s.record.cycles += cycles;
    s.record.updates++;
    *record = s.record;
  } else {
    arc_sphere_back(j, s.was, count);
  }
  free(s.gain[0]);
  return status;
}

double arc_joint_explicit_limit(const arc_joint *j, const arc_joint_wear_def *def) {
  const double least = j->kernel ? j->limit * j->d / acos(-1) : 1 / j->K;
  double sliding = 0;
  for (int i = 0; i < def->instants; i++) {
    const double *load = def->instant[i].load, *w = def->instant[i].omega, size = size_of(load);
    const double turned[3] = {w[1] * load[2] - w[2] * load[1], w[2] * load[0] - w[0] * load[2],
                              w[0] * load[1] - w[1] * load[0]};
    sliding += size > 0 ? size_of(turned) / size * j->def.radius : 0;
  }
  return 2 * least / (def->k * sliding);
}

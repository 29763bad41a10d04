/* Computes contact pressures and wear rates for given depths, and the implicit stage of a step. */
#include "core/space/positions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void fill_report(const positions *p, arc_halfspace_report *report) {
  const size_t all = (size_t)p->s.count * (size_t)p->s.h->cells;
  if (!report) return;
  *report = (arc_halfspace_report){.iterations = p->used.iterations,
                                   .applications = p->used.applications,
                                   .sets = p->used.sets,
                                   .guarded = p->used.guarded};
  for (size_t k = 0; k < all; k++) report->p_max = fmax(report->p_max, p->pressure[k]);
}

/* Stores the pressures of all `count` positions: the solved positions and their mirror images. */
static void store_pressures(const positions *p, int count, double *pressure) {
  const arc_halfspace *h = p->s.h;
  const size_t cells = (size_t)h->cells, nz = (size_t)h->def.nz;
  if (!pressure) return;
  memcpy(pressure, p->pressure, (size_t)p->s.count * cells * sizeof *pressure);
  for (int j = p->s.count; j < count; j++)
    for (int i = 0; i < h->def.nx; i++)
      memcpy(pressure + (size_t)j * cells + (size_t)i * nz,
             pressure + (size_t)(count - 1 - j) * cells + (size_t)(h->def.nx - 1 - i) * nz,
             nz * sizeof *pressure);
}

/* Allocates one array of sites per body. Both arrays are in one block of memory. */
static int take_sites(const arc_halfspace *h, double *sites[ARC_BODIES]) {
  const size_t upper = (size_t)arc_halfspace_sites(h, ARC_UPPER),
               lower = (size_t)arc_halfspace_sites(h, ARC_LOWER);
  sites[ARC_UPPER] = calloc(upper + lower, sizeof(double));
  sites[ARC_LOWER] = sites[ARC_UPPER] ? sites[ARC_UPPER] + upper : NULL;
  return sites[ARC_UPPER] != NULL;
}

static arc_status no_memory(const arc_halfspace *h, arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for the depths of %d sites",
                  arc_halfspace_sites(h, ARC_UPPER) + arc_halfspace_sites(h, ARC_LOWER));
}

arc_status arc_halfspace_solve(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_position *position,
                               const arc_halfspace_options *options, double *pressure,
                               double *approach, arc_halfspace_report *report, arc_error *error) {
  positions p;
  arc_status status =
      arc_positions_create(h, depth, NULL, position, 1, 0, options, pressure, &p, error);
  if (status != ARC_OK) return status;
  p.s.weight[0] = 1;
  status = arc_positions_solve(&p, error);
  if (status == ARC_OK) {
    store_pressures(&p, 1, pressure);
    *approach = p.approach[0];
    fill_report(&p, report);
  }
  arc_positions_free(&p);
  return status;
}

arc_status arc_halfspace_gaps(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, const double *pressure,
                              double approach, double *gap, arc_error *error) {
  stroke_place place;
  const arc_status status = arc_stroke_place(h, position->x, &place, error);
  if (status != ARC_OK) return status;
  const stroke s = {.h = h, .count = 1, .place = &place, .box = arc_space_window(h)};
  double *u = h->scratch;
  arc_convolution_apply(h->convolution[0][0], h->work[0], pressure, u);
  arc_stroke_gap(&s, depth, 0, gap);
  for (int k = 0; k < h->cells; k++) gap[k] += u[k] - approach;
  return ARC_OK;
}

arc_status arc_halfspace_rate(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, int count,
                              const arc_halfspace_options *options, double *pressure,
                              double *const rate[ARC_BODIES], arc_halfspace_report *report,
                              arc_error *error) {
  positions p;
  arc_status status =
      arc_positions_create(h, depth, NULL, position, count, 1, options, pressure, &p, error);
  if (status != ARC_OK) return status;
  status = arc_positions_solve_each(&p, error);
  if (status == ARC_OK) {
    arc_positions_rate(&p, rate);
    store_pressures(&p, count, pressure);
    fill_report(&p, report);
  }
  arc_positions_free(&p);
  return status;
}

/* Returns true if the values of opposite positions are exact mirror images in x. */
static int values_are_mirrored(const arc_halfspace *h, int count, const double *value) {
  const size_t rows = (size_t)count * (size_t)h->def.nx, nz = (size_t)h->def.nz;
  for (size_t i = 0; i < rows / 2; i++)
    if (memcmp(value + i * nz, value + (rows - 1 - i) * nz, nz * sizeof *value) != 0) return 0;
  return 1;
}

arc_status arc_halfspace_sum(arc_halfspace *h, const arc_halfspace_position *position, int count,
                             const double *value, arc_body body, double *sum, arc_error *error) {
  const arc_halfspace_options options = {.warm = 1};
  const int mirror = values_are_mirrored(h, count, value);
  positions p;
  const arc_status status =
      arc_positions_create(h, NULL, NULL, position, count, mirror, &options, value, &p, error);
  if (status != ARC_OK) return status;
  arc_positions_sum(&p, body, sum);
  arc_positions_free(&p);
  return ARC_OK;
}

/* Computes depth = known + c factor rate at each site of both bodies. */
static void wear(const arc_halfspace *h, const arc_halfspace_wear *w,
                 const double *const known[ARC_BODIES], double *const rate[ARC_BODIES],
                 double *const depth[ARC_BODIES]) {
  for (int b = 0; b < ARC_BODIES; b++)
    for (int k = 0, n = arc_halfspace_sites(h, (arc_body)b); k < n; k++) {
      const double factor = w->factor[b] ? w->factor[b][k] : 1;
      depth[b][k] = (known ? known[b][k] : 0) + w->c[b] * factor * rate[b][k];
    }
}

static arc_status check_wear(const arc_halfspace_wear *w, arc_error *error) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (!(w->c[b] >= 0) || !isfinite(w->c[b]))
      return arc_fail(error, ARC_ARGUMENT, "field 'c': expected a number >= 0, got %g", w->c[b]);
  return ARC_OK;
}

arc_status arc_halfspace_stage(arc_halfspace *h, const double *const known[ARC_BODIES],
                               const arc_halfspace_wear *w, const arc_halfspace_position *position,
                               int count, const arc_halfspace_options *options, double *pressure,
                               double *const depth[ARC_BODIES], arc_halfspace_report *report,
                               arc_error *error) {
  positions p;
  double *rate[ARC_BODIES];
  arc_status status = check_wear(w, error);
  if (status == ARC_OK)
    status = arc_positions_create(h, known, w, position, count, 1, options, pressure, &p, error);
  if (status != ARC_OK) return status;
  const int wears = w->c[ARC_UPPER] > 0 || w->c[ARC_LOWER] > 0;
  if (!take_sites(h, rate))
    status = no_memory(h, error);
  else
    status = wears ? arc_positions_solve(&p, error) : arc_positions_solve_each(&p, error);
  if (status == ARC_OK) {
    arc_positions_rate(&p, rate);
    wear(h, w, known, rate, depth);
    store_pressures(&p, count, pressure);
    fill_report(&p, report);
  }
  free(rate[ARC_UPPER]);
  arc_positions_free(&p);
  return status;
}

/* --- largest eigenvalue ----------------------------------------------------------------------- */

enum { most_powers = 60 };
static const double settled = 0.005; /* accepted change of the eigenvalue between iterations */

/* Workspace of the power iteration. */
typedef struct tangent {
  positions *p;
  const arc_halfspace_wear *wear;
  active_work *work;
  double *gap, *dp, *pressure;                  /* [count][box] */
  double *sum[ARC_BODIES];                      /* [box], [rows][box.nz] sums of weight times dp */
  double *depth[ARC_BODIES], *rate[ARC_BODIES]; /* [sites] */
} tangent;

static void free_tangent(tangent *t) {
  arc_active_work_destroy(&t->work);
  free(t->gap);
  free(t->depth[ARC_UPPER]);
  free(t->rate[ARC_UPPER]);
}

static int take_tangent(tangent *t) {
  const arc_halfspace *h = t->p->s.h;
  const space_box *box = &t->p->s.box;
  const size_t cells = (size_t)box->nx * (size_t)box->nz, all = (size_t)t->p->s.count * cells,
               lower = (size_t)h->rows * (size_t)box->nz;
  t->work = arc_active_work_create(t->p->s.count, (int)cells, 1, 0);
  t->gap = malloc((3 * all + cells + lower) * sizeof *t->gap);
  if (t->gap) {
    t->dp = t->gap + all;
    t->pressure = t->dp + all;
    t->sum[ARC_UPPER] = t->pressure + all;
    t->sum[ARC_LOWER] = t->sum[ARC_UPPER] + cells;
    arc_positions_read_box(t->p, t->pressure);
  }
  const int depths = take_sites(h, t->depth), rates = take_sites(h, t->rate);
  return t->work && t->gap && depths && rates;
}

static double length_of(const tangent *t, double *const value[ARC_BODIES]) {
  double sum = 0;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int k = 0, n = arc_halfspace_sites(t->p->s.h, (arc_body)b); k < n; k++)
      sum += value[b][k] * value[b][k];
  return sqrt(sum);
}

/* Sets the depths to a chessboard pattern, for which the elastic compliance is smallest. */
static void start(const tangent *t) {
  const arc_halfspace *h = t->p->s.h;
  for (int b = 0; b < ARC_BODIES; b++)
    for (int k = 0, n = arc_halfspace_sites(h, (arc_body)b); k < n; k++)
      t->depth[b][k] = (k / h->def.nz + k % h->def.nz) % 2 ? 1 : -1;
}

/* Sets the rate of a body at the sites of the box to -c factor sum / length. At all other sites it
 * remains 0. */
static void set_rate(const tangent *t, int b, double length) {
  const arc_halfspace *h = t->p->s.h;
  const space_box *box = &t->p->s.box;
  const int rows = b == ARC_UPPER ? box->nx : h->rows, first = b == ARC_UPPER ? box->x : 0;
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < box->nz; j++) {
      const int k = (first + i) * h->def.nz + box->z + j;
      const double factor = t->wear->factor[b] ? t->wear->factor[b][k] : 1;
      t->rate[b][k] = -t->wear->c[b] * factor * t->sum[b][i * box->nz + j] / length;
    }
}

/* Makes one step of the power iteration. Sets the rate to minus the change of c factor sum(weight
 * p) caused by the change `depth` of the depths, divided by the norm of `depth`. */
static arc_status multiply(tangent *t, arc_error *error) {
  stroke *s = &t->p->s;
  active_count used = {0};
  const double length = length_of(t, t->depth);
  const double *const depth[ARC_BODIES] = {t->depth[ARC_UPPER], t->depth[ARC_LOWER]};
  for (int j = 0; j < s->count; j++)
    arc_stroke_read(s, depth, j, t->gap + (size_t)j * (size_t)s->box.nx * (size_t)s->box.nz);
  const active_problem problem = {.blocks = s->count,
                                  .cells = s->box.nx * s->box.nz,
                                  .modes = 1,
                                  .gap = t->gap,
                                  .weight = s->weight,
                                  .apply = arc_stroke_apply,
                                  .context = s,
                                  .tolerance = 1e-3,
                                  .team = s->h->team};
  const arc_status status =
      arc_active_set_tangent(&problem, t->work, t->pressure, t->dp, &used, error);
  if (status == ARC_STOPPED) return arc_fail(error, ARC_STOPPED, "stopped on request");
  if (status != ARC_OK) return status;
  s->upper = t->sum[ARC_UPPER];
  s->lower = t->sum[ARC_LOWER];
  arc_stroke_gather(s, t->dp, 1);
  for (int b = 0; b < ARC_BODIES; b++) set_rate(t, b, length);
  return ARC_OK;
}

static arc_status iterate(tangent *t, double *eigenvalue, arc_error *error) {
  double before = 0;
  const size_t sites = (size_t)arc_halfspace_sites(t->p->s.h, ARC_UPPER) +
                       (size_t)arc_halfspace_sites(t->p->s.h, ARC_LOWER);
  start(t);
  for (int k = 0; k < most_powers; k++) {
    const arc_status status = multiply(t, error);
    if (status != ARC_OK) return status;
    *eigenvalue = length_of(t, t->rate);
    if (*eigenvalue == 0 || (k > 2 && fabs(*eigenvalue - before) < settled * *eigenvalue)) break;
    before = *eigenvalue;
    memcpy(t->depth[ARC_UPPER], t->rate[ARC_UPPER], sites * sizeof(double));
  }
  return ARC_OK;
}

arc_status arc_halfspace_eigenvalue(arc_halfspace *h, const arc_halfspace_wear *w,
                                    const arc_halfspace_position *position, int count,
                                    const double *pressure, const arc_callbacks *callbacks,
                                    double *eigenvalue, arc_error *error) {
  const arc_halfspace_options options = {.warm = 1, .callbacks = callbacks};
  positions p;
  arc_status status = check_wear(w, error);
  if (status == ARC_OK)
    status = arc_positions_create(h, NULL, w, position, count, 0, &options, pressure, &p, error);
  if (status != ARC_OK) return status;
  tangent t = {.p = &p, .wear = w};
  p.s.c[ARC_UPPER] = p.s.c[ARC_LOWER] = 0;
  status = arc_positions_fit_box(&p, error);
  if (status == ARC_OK)
    status = take_tangent(&t) ? iterate(&t, eigenvalue, error) : no_memory(h, error);
  p.s.upper = p.s.lower = NULL;
  free_tangent(&t);
  arc_positions_free(&p);
  return status;
}

/* Sets up the active-set problem of several positions on a box, and copies its solution to the
 * window. */
#include "core/space/positions.h"

#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- symmetry --------------------------------------------------------------------------------- */

static int is_even(const double *value, int rows, int columns) {
  for (int i = 0; value && i < rows / 2; i++)
    if (memcmp(value + (size_t)i * (size_t)columns,
               value + (size_t)(rows - 1 - i) * (size_t)columns,
               (size_t)columns * sizeof *value) != 0)
      return 0;
  return 1;
}

/* Returns true if each row of values is exactly symmetric in z. */
static int is_even_across(const double *value, int rows, int columns) {
  for (int i = 0; value && i < rows; i++)
    for (int j = 0; j < columns / 2; j++)
      if (value[i * columns + j] != value[i * columns + columns - 1 - j]) return 0;
  return 1;
}

typedef int (*evenness)(const double *value, int rows, int columns);

static int bodies_are_even(const arc_halfspace *h, const double *const depth[ARC_BODIES],
                           const arc_halfspace_wear *wear, evenness even) {
  const int nz = h->def.nz, rows[ARC_BODIES] = {h->def.nx, h->rows};
  for (int b = 0; b < ARC_BODIES; b++)
    if (!even(h->recess[b], rows[b], nz) || !even(depth ? depth[b] : NULL, rows[b], nz) ||
        !even(wear ? wear->factor[b] : NULL, rows[b], nz))
      return 0;
  return 1;
}

int arc_space_are_even(const arc_halfspace *h, const double *const depth[ARC_BODIES], int across) {
  return bodies_are_even(h, depth, NULL, across ? is_even_across : is_even);
}

static int positions_are_even(const arc_halfspace_position *p, int count) {
  for (int j = 0; j < (count + 1) / 2; j++) {
    const arc_halfspace_position *q = &p[count - 1 - j];
    if (p[j].x != -q->x || p[j].load != q->load || p[j].weight != q->weight) return 0;
  }
  return 1;
}

/* --- creation --------------------------------------------------------------------------------- */

static arc_status check_position(const arc_halfspace_position *p, int weighted, arc_error *error) {
  if (!(p->load > 0) || !isfinite(p->load))
    return arc_fail(error, ARC_ARGUMENT, "field 'load': expected a number above 0, got %g",
                    p->load);
  if (!isfinite(p->x))
    return arc_fail(error, ARC_ARGUMENT, "field 'x': expected a finite number, got %g", p->x);
  if (weighted && (!(p->weight > 0) || !isfinite(p->weight)))
    return arc_fail(error, ARC_ARGUMENT, "field 'weight': expected a number above 0, got %g",
                    p->weight);
  return ARC_OK;
}

void arc_positions_free(positions *p) {
  free(p->s.place);
  free(p->s.weight);
  free(p->pressure);
  p->s.place = NULL;
  p->s.weight = p->pressure = NULL;
}

static int allocate(positions *p) {
  const size_t n = (size_t)p->s.count;
  p->s.place = malloc(n * sizeof *p->s.place);
  p->s.weight = malloc(3 * n * sizeof *p->s.weight);
  p->pressure = malloc(n * (size_t)p->s.h->cells * sizeof *p->pressure);
  if (!p->s.place || !p->s.weight || !p->pressure) return 0;
  p->load = p->s.weight + n;
  p->approach = p->load + n;
  return 1;
}

static arc_status fill_position(positions *p, const arc_halfspace_position *position, int j,
                                int middle, int weighted, arc_error *error) {
  const arc_halfspace_def *d = &p->s.h->def;
  const arc_status status = check_position(position, weighted, error);
  p->s.weight[j] = position->weight * (middle ? 0.5 : 1);
  p->load[j] = position->load / (d->size_x * d->size_z);
  return status == ARC_OK ? arc_stroke_place(p->s.h, position->x, &p->s.place[j], error) : status;
}

/* Returns ARC_MEMORY if the arrays for all positions exceed the free memory. */
static arc_status check_memory(const arc_halfspace *h, int count, arc_error *error) {
  static const double much = 256e6, mega = 1e6;
  const double bytes = arc_halfspace_bytes(&h->def, count);
  if (bytes < much || bytes < arc_memory_free()) return ARC_OK;
  return arc_fail(error, ARC_MEMORY,
                  "out of memory: %d positions of %d x %d cells need %.0f MB, %.0f MB are free; "
                  "larger cells or fewer increments need less",
                  count, h->def.nx, h->def.nz, bytes / mega, arc_memory_free() / mega);
}

arc_status arc_positions_create(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_wear *wear,
                                const arc_halfspace_position *position, int count, int mirror,
                                const arc_halfspace_options *options, const double *pressure,
                                positions *p, arc_error *error) {
  const double *extra = options ? options->gap : NULL;
  const int mirrored = mirror && count > 1 && !extra && positions_are_even(position, count) &&
                       bodies_are_even(h, depth, wear, is_even);
  *p = (positions){.s = {.h = h, .count = mirrored ? (count + 1) / 2 : count}, .depth = depth};
  p->s.mirrored = mirrored;
  p->s.extra = extra;
  p->s.even = bodies_are_even(h, depth, wear, is_even_across) &&
              is_even_across(extra, count * h->def.nx, h->def.nz);
  if (wear)
    for (int b = 0; b < ARC_BODIES; b++) {
      p->s.c[b] = wear->c[b];
      p->s.factor[b] = wear->factor[b];
    }
  p->s.callbacks = options ? options->callbacks : NULL;
  p->tolerance = options && options->tolerance > 0 ? options->tolerance : 1e-5;
  p->warm = options && options->warm && pressure;
  if (check_memory(h, p->s.count, error) != ARC_OK) return ARC_MEMORY;
  if (!allocate(p)) {
    arc_positions_free(p);
    return arc_fail(error, ARC_MEMORY, "out of memory for %d positions of %d cells", count,
                    h->cells);
  }
  arc_status status = ARC_OK;
  for (int j = 0; j < p->s.count && status == ARC_OK; j++)
    status = fill_position(p, &position[j], j, mirrored && j == count - 1 - j, wear != NULL, error);
  if (p->warm && status == ARC_OK)
    memcpy(p->pressure, pressure, (size_t)p->s.count * (size_t)h->cells * sizeof *pressure);
  if (status != ARC_OK) arc_positions_free(p);
  return status;
}

/* --- boxes ------------------------------------------------------------------------------------ */

/* Computes the ranges of rows and columns that are in contact at any position. */
static void find_ranges(const positions *p, space_range *x, space_range *z) {
  *x = *z = (space_range){0, -1};
  for (int j = 0; j < p->s.count; j++)
    arc_space_find_range(p->s.h, p->pressure + (size_t)j * (size_t)p->s.h->cells, x, z);
}

/* Copies rows between window and box: from the box to the window if `into` is 1, otherwise from
 * the window to the box. */
static void copy_box(const positions *p, const space_box *box, int position, double *window,
                     double *boxed, int into) {
  const arc_halfspace *h = p->s.h;
  const size_t nz = (size_t)box->nz;
  double *w = window + (size_t)position * (size_t)h->cells,
         *b = boxed + (size_t)position * (size_t)box->nx * nz;
  if (into) memset(w, 0, (size_t)h->cells * sizeof *w);
  for (int i = 0; i < box->nx; i++) {
    double *from = b + (size_t)i * nz,
           *to = w + (size_t)(box->x + i) * (size_t)h->def.nz + (size_t)box->z;
    memcpy(into ? to : from, into ? from : to, nz * sizeof *w);
  }
}

/* --- solution --------------------------------------------------------------------------------- */

/* Computes the initial guess for a position whose pressures are all zero. */
static void start_one(void *context, int position, int worker) {
  positions *p = context;
  const arc_halfspace *h = p->s.h;
  const int w = p->s.count > 1 ? worker : p->s.worker;
  double *pressure = p->pressure + (size_t)position * (size_t)h->cells,
         *gap = h->scratch + (size_t)w * 2 * (size_t)h->cells;
  int positive = 0;
  for (int k = 0; p->warm && k < h->cells && !positive; k++) positive = pressure[k] > 0;
  if (positive) return;
  arc_stroke_gap(&p->s, p->depth, position, gap);
  arc_space_guess(h, gap, p->load[position] * h->def.size_x * h->def.size_z, pressure);
}

/* Data for the search for cells outside the box at which the surfaces overlap. x and z are the
 * ranges of these cells at each position. */
typedef struct outside {
  positions *p;
  space_box box;
  int layered;        /* 1 if a body has layers or a rigid base */
  space_range *x, *z; /* [count] */
} outside;

static int in_box(const space_box *b, int i, int k) {
  return i >= b->x && i < b->x + b->nx && k >= b->z && k < b->z + b->nz;
}

/* Returns true if the gap of a cell outside the box is not larger than the approach. Otherwise the
 * surfaces overlap nowhere outside the box, because pressures on half-spaces without layers only
 * increase gaps. */
static int may_overlap(const outside *o, const double *gap, double approach) {
  const arc_halfspace *h = o->p->s.h;
  for (int i = 0; i < h->def.nx; i++)
    for (int k = 0; k < h->def.nz; k++)
      if (gap[i * h->def.nz + k] <= approach && !in_box(&o->box, i, k)) return 1;
  return 0;
}

static void look_outside(void *context, int position, int worker) {
  const outside *o = context;
  const positions *p = o->p;
  const arc_halfspace *h = p->s.h;
  const int w = p->s.count > 1 ? worker : p->s.worker;
  double *u = h->scratch + (size_t)w * 2 * (size_t)h->cells, *gap = u + h->cells, largest = 0;
  o->x[position] = o->z[position] = (space_range){0, -1};
  arc_stroke_gap(&p->s, p->depth, position, gap);
  if (!o->layered && !may_overlap(o, gap, p->approach[position])) return;
  arc_convolution_apply(h->convolution[0][0], h->work[w],
                        p->pressure + (size_t)position * (size_t)h->cells, u);
  for (int k = 0; k < h->cells; k++) largest = fmax(largest, u[k]);
  for (int i = 0; i < h->def.nx; i++)
    for (int k = 0; k < h->def.nz; k++) {
      const int c = i * h->def.nz + k;
      if (in_box(&o->box, i, k)) continue;
      if (u[c] + gap[c] - p->approach[position] > -2 * p->tolerance * largest) continue;
      arc_space_extend(&o->x[position], i);
      arc_space_extend(&o->z[position], k);
    }
}

/* Extends the ranges to the cells outside the box where the surfaces overlap. Sets *wider to 1 if
 * such cells exist, otherwise to 0. */
static arc_status check_outside(positions *p, const space_box *box, space_range *x, space_range *z,
                                int *wider, arc_error *error) {
  const int n = p->s.count;
  *wider = 0;
  if (box->level_x == 0 && box->level_z == 0) return ARC_OK;
  outside o = {.p = p,
               .box = *box,
               .layered = arc_space_thinnest(&p->s.h->def) > 0,
               .x = malloc(2 * (size_t)n * sizeof(space_range))};
  if (!o.x) return arc_fail(error, ARC_MEMORY, "out of memory for %d positions", n);
  o.z = o.x + n;
  p->s.box = arc_space_window(p->s.h);
  arc_team_run(n > 1 ? p->s.h->team : NULL, n, look_outside, &o);
  p->s.box = o.box;
  for (int j = 0; j < n; j++)
    if (o.x[j].high >= o.x[j].low) {
      *wider = 1;
      arc_space_extend(x, o.x[j].low), arc_space_extend(x, o.x[j].high);
      arc_space_extend(z, o.z[j].low), arc_space_extend(z, o.z[j].high);
    }
  free(o.x);
  return ARC_OK;
}

/* Returns true if preconditioning saves time, which is the case for a single contact without wear
 * on at least 96 x 96 cells. */
static int is_preconditioned(const positions *p) {
  const stroke *s = &p->s;
  const int worn = s->c[ARC_UPPER] > 0 || s->c[ARC_LOWER] > 0, many = 96 * 96;
  return s->count == 1 && !worn && !s->h->def.periodic && s->box.nx * s->box.nz >= many;
}

/* Arrays of a box and the workspace of the active-set solver. */
typedef struct box_memory {
  double *gap, *pressure;
  active_work *work;
} box_memory;

static void free_box(positions *p, box_memory *m) {
  free(m->gap);
  free(p->s.upper);
  arc_active_work_destroy(&m->work);
  p->s.upper = p->s.lower = NULL;
}

static arc_status take_box(positions *p, box_memory *m, int preconditioned, arc_error *error) {
  const size_t n = (size_t)p->s.box.nx * (size_t)p->s.box.nz, all = n * (size_t)p->s.count;
  m->gap = malloc(2 * all * sizeof *m->gap);
  m->work = arc_active_work_create(p->s.count, (int)n, 1, preconditioned);
  p->s.upper = malloc((n + (size_t)p->s.h->rows * (size_t)p->s.box.nz) * sizeof *p->s.upper);
  if (m->gap && m->work && p->s.upper) {
    m->pressure = m->gap + all;
    p->s.lower = p->s.upper + n;
    return ARC_OK;
  }
  free_box(p, m);
  return arc_fail(error, ARC_MEMORY, "out of memory for %d positions of %zu cells", p->s.count, n);
}

enum { box_margin = 4 }; /* rows and columns into which the contact may grow */

static arc_status find_kernels(positions *p, int preconditioned, arc_error *error) {
  const space_box *b = &p->s.box;
  arc_status status = arc_space_convolution(p->s.h, b->level_x, b->level_z, &p->s.kernel, error);
  if (status == ARC_OK && preconditioned)
    status = arc_space_inverse(p->s.h, b->level_x, b->level_z, &p->s.inverse, error);
  return status;
}

arc_status arc_positions_fit_box(positions *p, arc_error *error) {
  space_range x, z;
  find_ranges(p, &x, &z);
  p->s.box = arc_space_box(p->s.h, x, z, box_margin, p->s.mirrored);
  return find_kernels(p, 0, error);
}

void arc_positions_read_box(const positions *p, double *boxed) {
  for (int j = 0; j < p->s.count; j++) copy_box(p, &p->s.box, j, p->pressure, boxed, 0);
}

static arc_status solve_in_box(positions *p, arc_error *error) {
  stroke *s = &p->s;
  const int pre = is_preconditioned(p);
  box_memory m = {NULL, NULL, NULL};
  arc_status status = find_kernels(p, pre, error);
  if (status == ARC_OK) status = take_box(p, &m, pre, error);
  if (status != ARC_OK) return status;
  for (int j = 0; j < s->count; j++) {
    arc_stroke_gap(s, p->depth, j, m.gap + (size_t)j * (size_t)s->box.nx * (size_t)s->box.nz);
  }
  arc_positions_read_box(p, m.pressure);
  const active_problem problem = {.blocks = s->count,
                                  .cells = s->box.nx * s->box.nz,
                                  .modes = 1,
                                  .gap = m.gap,
                                  .load = p->load,
                                  .weight = s->weight,
                                  .apply = arc_stroke_apply,
                                  .precondition = pre ? arc_stroke_precondition : NULL,
                                  .context = s,
                                  .tolerance = p->tolerance,
                                  .team = s->count > 1 ? s->h->team : NULL};
  status = arc_active_set_solve(&problem, m.work, m.pressure, p->approach, &p->used, error);
  if (status == ARC_STOPPED) arc_fail(error, ARC_STOPPED, "stopped on request");
  for (int j = 0; j < s->count && status == ARC_OK; j++)
    copy_box(p, &s->box, j, p->pressure, m.pressure, 1);
  free_box(p, &m);
  return status;
}

/* Averages the two halves of each row of pressures, which agree within rounding errors, so that the
 * pressures are exactly symmetric in z. */
static void make_even(void *context, int position, int worker) {
  const positions *p = context;
  const int nz = p->s.h->def.nz;
  (void)worker;
  for (int i = 0; i < p->s.h->def.nx; i++) {
    double *row = p->pressure + (size_t)position * (size_t)p->s.h->cells + (size_t)i * (size_t)nz;
    for (int j = 0; j < nz / 2; j++) row[j] = row[nz - 1 - j] = (row[j] + row[nz - 1 - j]) / 2;
  }
}

/* Returns ARC_ZONE if the contact reaches the edge of the window. */
static arc_status check_edge(const positions *p, arc_error *error) {
  const arc_halfspace_def *d = &p->s.h->def;
  space_range x, z;
  if (d->periodic) return ARC_OK;
  find_ranges(p, &x, &z);
  if (x.low > 0 && z.low > 0 && x.high < d->nx - 1 && z.high < d->nz - 1) return ARC_OK;
  return arc_fail(
      error, ARC_ZONE,
      "the contact reaches the edge of the window of %g x %g mm: a larger window is needed",
      d->nx * d->size_x, d->nz * d->size_z);
}

arc_status arc_positions_solve(positions *p, arc_error *error) {
  space_range x, z;
  int wider = 1;
  p->s.box = arc_space_window(p->s.h);
  arc_team_run(p->s.count > 1 ? p->s.h->team : NULL, p->s.count, start_one, p);
  find_ranges(p, &x, &z);
  arc_status status = ARC_OK;
  while (wider && status == ARC_OK) {
    p->s.box = arc_space_box(p->s.h, x, z, box_margin, p->s.mirrored);
    status = solve_in_box(p, error);
    if (status == ARC_OK) status = check_outside(p, &p->s.box, &x, &z, &wider, error);
  }
  if (status != ARC_OK) return status;
  if (p->s.even) arc_team_run(p->s.count > 1 ? p->s.h->team : NULL, p->s.count, make_even, p);
  return check_edge(p, error);
}

/* --- independent positions -------------------------------------------------------------------- */

/* Data for the parallel solution of independent positions. */
typedef struct singles {
  positions *all;
  arc_status *status; /* [count] */
  arc_error *error;   /* [workers] error of the first position that failed on each worker */
  active_count *used; /* [count] */
  int *failed;        /* [workers] 1 + index of the failed position; 0: none */
} singles;

static void solve_single(void *context, int position, int worker) {
  const singles *g = context;
  const positions *all = g->all;
  double weight = 1;
  if (g->failed[worker]) return;
  positions one = {.s = all->s,
                   .load = all->load + position,
                   .pressure = all->pressure + (size_t)position * (size_t)all->s.h->cells,
                   .approach = all->approach + position,
                   .depth = all->depth,
                   .tolerance = all->tolerance,
                   .warm = all->warm};
  one.s.count = 1;
  one.s.mirrored = 0;
  one.s.worker = worker;
  if (all->s.extra) one.s.extra = all->s.extra + (size_t)position * (size_t)all->s.h->cells;
  one.s.place = all->s.place + position;
  one.s.weight = &weight;
  one.s.c[ARC_UPPER] = one.s.c[ARC_LOWER] = 0;
  g->status[position] = arc_positions_solve(&one, &g->error[worker]);
  g->used[position] = one.used;
  if (g->status[position] != ARC_OK) g->failed[worker] = position + 1;
}

/* Returns the status of the first failed position, and sums the iteration counts of the solver over
 * all positions. */
static arc_status settle(const singles *g, int workers, arc_error *error) {
  const int n = g->all->s.count;
  active_count *sum = &g->all->used;
  for (int j = 0; j < n; j++) {
    sum->iterations += g->used[j].iterations;
    sum->applications += g->used[j].applications;
    sum->sets += g->used[j].sets;
    sum->guarded += g->used[j].guarded;
  }
  for (int j = 0; j < n; j++)
    for (int w = 0; w < workers; w++)
      if (g->failed[w] == j + 1) return arc_fail(error, g->status[j], "%s", g->error[w].message);
  return ARC_OK;
}

arc_status arc_positions_solve_each(positions *p, arc_error *error) {
  const size_t n = (size_t)p->s.count;
  const int workers = arc_team_workers(p->s.h->team);
  singles g = {.all = p, .status = calloc(n, sizeof *g.status), .used = calloc(n, sizeof *g.used)};
  g.error = calloc((size_t)workers, sizeof *g.error);
  g.failed = calloc((size_t)workers, sizeof *g.failed);
  arc_status status;
  if (g.status && g.used && g.error && g.failed) {
    arc_team_run(n > 1 ? p->s.h->team : NULL, (int)n, solve_single, &g);
    status = settle(&g, workers, error);
  } else {
    status = arc_fail(error, ARC_MEMORY, "out of memory for %zu positions", n);
  }
  free(g.status);
  free(g.used);
  free(g.error);
  free(g.failed);
  return status;
}

/* Computes for each site the sum of weight times pressure: for both bodies if `both` is 1, else
 * only for bodies that wear (c > 0). */
static void gather(positions *p, int both, double *upper, double *lower) {
  p->s.box = arc_space_window(p->s.h);
  p->s.upper = upper;
  p->s.lower = lower;
  arc_stroke_gather(&p->s, p->pressure, both);
  p->s.upper = p->s.lower = NULL;
}

void arc_positions_rate(positions *p, double *const rate[ARC_BODIES]) {
  gather(p, 1, rate[ARC_UPPER], rate[ARC_LOWER]);
}

void arc_positions_sum(positions *p, arc_body body, double *sum) {
  p->s.c[ARC_UPPER] = body == ARC_UPPER;
  p->s.c[ARC_LOWER] = body == ARC_LOWER;
  gather(p, 0, sum, sum);
}

/* Applies the operator of a stroke, which maps the pressures at all positions to one sum per cell
 * and position: the elastic displacement at this position plus the wear depths of both bodies due
 * to all positions. Pressures are distributed to the rows of the lower body with the same weights
 * with which its wear is interpolated at a position, so the operator is symmetric. These weights
 * sum to 1, so the wear volumes of both bodies have no interpolation error. */
#include "core/space/stroke.h"

#include "core/base/callbacks.h"
#include "core/numeric/cells.h"

#include <math.h>
#include <string.h>

arc_status arc_stroke_place(const arc_halfspace *h, double x, stroke_place *place,
                            arc_error *error) {
  const arc_halfspace_def *d = &h->def;
  *place = (stroke_place){0, 0};
  if (d->periodic && x != 0)
    return arc_fail(error, ARC_ARGUMENT, "field 'x': expected 0 for periodic surfaces, got %g", x);
  if (d->groove > 0 || d->periodic) return ARC_OK;
  const double offset = (h->rows - d->nx) / 2 - x / d->size_x, whole = round(offset);
  const int is_whole = fabs(offset - whole) < 1e-9;
  const double from = is_whole ? whole : floor(offset);
  place->row = (int)fmax(-1, fmin(from, h->rows));
  place->share = is_whole ? 0 : offset - from;
  if (place->row >= 0 && place->row + d->nx + (place->share > 0) <= h->rows) return ARC_OK;
  return arc_fail(error, ARC_ZONE,
                  "position x = %g mm: expected -%g to %g mm, because the grid of the lower body "
                  "has %d rows of cells",
                  x, (h->rows - d->nx) / 2 * d->size_x, (h->rows - d->nx) / 2 * d->size_x, h->rows);
}

/* --- sums over positions ---------------------------------------------------------------------- */

static size_t box_cells(const stroke *s) {
  return (size_t)s->box.nx * (size_t)s->box.nz;
}

static const double *pressures(const stroke *s, int position, int row) {
  return s->from + (size_t)position * box_cells(s) + (size_t)row * (size_t)s->box.nz;
}

static void sum_upper_row(const stroke *s, int row) {
  const int nz = s->box.nz;
  double *to = s->upper + (size_t)row * (size_t)nz;
  memset(to, 0, (size_t)nz * sizeof *to);
  for (int j = 0; j < s->count; j++) arc_cells_add(nz, s->weight[j], pressures(s, j, row), to);
}

static void add_row(const stroke *s, int position, int row, double weight, double *to) {
  if (weight == 0 || row < 0 || row >= s->box.nx) return;
  arc_cells_add(s->box.nz, weight, pressures(s, position, row), to);
}

/* Adds to `to` the weighted pressures of all positions at one row of the track. */
static void add_track_row(const stroke *s, int row, double *to) {
  for (int j = 0; j < s->count; j++) {
    const stroke_place *p = &s->place[j];
    const int in_box = row - p->row - s->box.x;
    add_row(s, j, in_box, s->weight[j] * (1 - p->share), to);
    add_row(s, j, in_box - 1, s->weight[j] * p->share, to);
  }
}

static void add_groove(const stroke *s, double *to) {
  const double spread = s->h->def.size_x / s->h->def.groove;
  for (int j = 0; j < s->count; j++)
    for (int i = 0; i < s->box.nx; i++) add_row(s, j, i, spread * s->weight[j], to);
}

static void sum_lower_row(const stroke *s, int row) {
  double *to = s->lower + (size_t)row * (size_t)s->box.nz;
  memset(to, 0, (size_t)s->box.nz * sizeof *to);
  if (s->h->def.groove > 0)
    add_groove(s, to);
  else
    add_track_row(s, row, to);
}

/* Adds its mirror image to a sum. */
static void add_mirror(double *sum, int rows, int columns) {
  for (int i = 0; i < (rows + 1) / 2; i++) {
    double *a = sum + (size_t)i * (size_t)columns,
           *b = sum + (size_t)(rows - 1 - i) * (size_t)columns;
    for (int k = 0; k < columns; k++) a[k] = b[k] = a[k] + b[k];
  }
}

enum { chunk = 8 /* rows per task */ };

static int chunks(int rows) {
  return (rows + chunk - 1) / chunk;
}

/* Computes `chunk` rows of the sums of both bodies. The rows of the upper body are numbered first.
 */
static void sum_rows(void *context, int task, int worker) {
  const stroke *s = context;
  const int all = s->box.nx + s->h->rows;
  (void)worker;
  for (int k = task * chunk; k < (task + 1) * chunk && k < all; k++)
    if (k >= s->box.nx && (s->both || s->c[ARC_LOWER] > 0))
      sum_lower_row(s, k - s->box.nx);
    else if (k < s->box.nx && (s->both || s->c[ARC_UPPER] > 0))
      sum_upper_row(s, k);
}

void arc_stroke_gather(stroke *s, const double *p, int both) {
  const int rows = s->box.nx + s->h->rows;
  s->from = p;
  s->both = both;
  arc_team_run(s->count > 1 ? s->h->team : NULL, chunks(rows), sum_rows, s);
  if (s->mirrored && (both || s->c[ARC_UPPER] > 0)) add_mirror(s->upper, s->box.nx, s->box.nz);
  if (s->mirrored && (both || s->c[ARC_LOWER] > 0)) add_mirror(s->lower, s->h->rows, s->box.nz);
}

/* --- operator --------------------------------------------------------------------------------- */

static void convolve(void *context, int position, int worker) {
  const stroke *s = context;
  const size_t o = (size_t)position * box_cells(s);
  arc_convolution_apply(s->kernel, s->h->work[s->count > 1 ? worker : s->worker], s->from + o,
                        s->to + o);
}

/* A stage of the convolution of one position. */
typedef struct stage {
  const stroke *s;
  int position, number;
} stage;

static void convolve_part(void *context, int part, int worker) {
  const stage *a = context;
  const stroke *s = a->s;
  const size_t o = (size_t)a->position * box_cells(s);
  arc_convolution_part(s->kernel, s->h->work[0], s->h->work[worker], a->number, part, s->from + o,
                       s->to + o);
}

/* Computes the convolutions of all positions. The threads share the positions, and each of the last
 * positions if their number is not a multiple of the number of threads. */
static void convolve_all(stroke *s, work_team *team) {
  const int shared = team ? s->count % arc_team_workers(team) : 0;
  arc_team_run(team, s->count - shared, convolve, s);
  for (int j = s->count - shared; j < s->count; j++)
    for (int k = 0; k < 3; k++) {
      stage a = {s, j, k};
      arc_team_run(team, arc_convolution_parts(s->kernel, k), convolve_part, &a);
    }
}

/* Adds the wear at one row of the box to `to`: at each site c times factor times sum, multiplied by
 * the interpolation weight `share`. */
static void wear_row(const stroke *s, int body, int site_row, double share, const double *sum,
                     double *to) {
  const double c = s->c[body] * share, *factor = s->factor[body];
  if (c == 0) return;
  if (!factor) {
    arc_cells_add(s->box.nz, c, sum, to);
    return;
  }
  factor += (size_t)site_row * (size_t)s->h->def.nz + (size_t)s->box.z;
  for (int j = 0; j < s->box.nz; j++) to[j] += c * factor[j] * sum[j];
}

static void wear_lower(const stroke *s, int row, double share, double *to) {
  if (share != 0)
    wear_row(s, ARC_LOWER, row, share, s->lower + (size_t)row * (size_t)s->box.nz, to);
}

/* Adds the wear at `chunk` rows of a position. */
static void add_wear(void *context, int task, int worker) {
  const stroke *s = context;
  const int each = chunks(s->box.nx), position = task / each, first = task % each * chunk;
  const stroke_place *p = &s->place[position];
  const int groove = s->h->def.groove > 0;
  (void)worker;
  for (int i = first; i < first + chunk && i < s->box.nx; i++) {
    const size_t o = (size_t)i * (size_t)s->box.nz;
    double *to = s->to + (size_t)position * box_cells(s) + o;
    wear_row(s, ARC_UPPER, s->box.x + i, 1, s->upper + o, to);
    if (s->c[ARC_LOWER] == 0) continue;
    const int row = groove ? 0 : p->row + s->box.x + i;
    wear_lower(s, row, 1 - p->share, to);
    wear_lower(s, row + 1, p->share, to);
  }
}

arc_status arc_stroke_apply(void *context, const double *p, double *u) {
  stroke *s = context;
  work_team *team = s->count > 1 ? s->h->team : NULL;
  if (s->worker == 0 && callbacks_stop(s->callbacks)) return ARC_STOPPED;
  s->from = p;
  s->to = u;
  convolve_all(s, team);
  if (s->c[ARC_UPPER] == 0 && s->c[ARC_LOWER] == 0) return ARC_OK;
  arc_stroke_gather(s, p, 0);
  arc_team_run(team, s->count * chunks(s->box.nx), add_wear, s);
  return ARC_OK;
}

arc_status arc_stroke_precondition(void *context, const double *r, double *z) {
  const stroke *s = context;
  for (int j = 0; j < s->count; j++)
    arc_convolution_apply(s->inverse, s->h->work[s->worker], r + (size_t)j * box_cells(s),
                          z + (size_t)j * box_cells(s));
  return ARC_OK;
}

/* --- gaps ------------------------------------------------------------------------------------- */

static void read_row(const stroke *s, const double *value, int row, double share, double *sum) {
  if (share != 0)
    arc_cells_add(s->box.nz, share, value + (size_t)row * (size_t)s->h->def.nz + (size_t)s->box.z,
                  sum);
}

static void add_read(const stroke *s, const double *const value[ARC_BODIES], int position,
                     double *sum) {
  const stroke_place *p = &s->place[position];
  for (int i = 0; i < s->box.nx; i++) {
    double *to = sum + (size_t)i * (size_t)s->box.nz;
    const int row = s->h->def.groove > 0 ? 0 : p->row + s->box.x + i;
    read_row(s, value[ARC_UPPER], s->box.x + i, 1, to);
    read_row(s, value[ARC_LOWER], row, 1 - p->share, to);
    read_row(s, value[ARC_LOWER], row + 1, p->share, to);
  }
}

void arc_stroke_read(const stroke *s, const double *const value[ARC_BODIES], int position,
                     double *sum) {
  memset(sum, 0, box_cells(s) * sizeof *sum);
  add_read(s, value, position, sum);
}

void arc_stroke_gap(const stroke *s, const double *const depth[ARC_BODIES], int position,
                    double *gap) {
  const double *const recess[ARC_BODIES] = {s->h->recess[ARC_UPPER], s->h->recess[ARC_LOWER]};
  arc_stroke_read(s, recess, position, gap);
  if (depth) add_read(s, depth, position, gap);
  const space_box *box = &s->box;
  const double *extra = s->extra ? s->extra + (size_t)position * (size_t)s->h->cells : NULL;
  for (int i = 0; extra && i < box->nx; i++)
    for (int j = 0; j < box->nz; j++)
      gap[i * box->nz + j] += extra[(box->x + i) * s->h->def.nz + box->z + j];
}

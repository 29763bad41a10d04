/* Creates a pair of half-spaces and computes the data that follow from its definition. */
#include "core/space/cerruti.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

arc_halfspace_def arc_halfspace_default(void) {
  const arc_halfspace_body flat = {.material = arc_material_default()};
  arc_halfspace_def def = {.body = {flat, flat}, .size_x = 0.02, .size_z = 0.02};
  def.body[ARC_UPPER].radius_x = def.body[ARC_UPPER].radius_z = 10;
  def.nx = def.nz = 63;
  return def;
}

static int rows_of(const arc_halfspace_def *d) {
  return d->groove > 0 ? 1 : d->track > 0 ? d->track : d->nx;
}

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status check_number(const char *name, double value, int valid, const char *expected,
                               arc_error *error) {
  if (valid) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "field '%s': expected %s, got %g", name, expected, value);
}

static arc_status check_body(const arc_halfspace_body *b, arc_error *error) {
  arc_status status = arc_material_check(b->material, error);
  double layers = 0;
  for (int l = 0; l < ARC_MOST_LAYERS && b->layer[l].thickness > 0 && status == ARC_OK; l++) {
    layers += b->layer[l].thickness;
    status = arc_material_check(b->layer[l].material, error);
  }
  if (status == ARC_OK)
    status = check_number("depth", b->depth, b->depth == 0 || b->depth > layers,
                          "0, or more than the thickness of the layers", error);
  if (status == ARC_OK)
    status = check_number("radius_x", b->radius_x, isfinite(b->radius_x), "a number", error);
  if (status == ARC_OK)
    status = check_number("radius_z", b->radius_z, isfinite(b->radius_z), "a number", error);
  return status;
}

static arc_status check_cells(const arc_halfspace_def *d, arc_error *error) {
  static const char *const positive = "a number above 0";
  const int longer = d->track - d->nx;
  arc_status status =
      check_number("size_x", d->size_x, isfinite(d->size_x) && d->size_x > 0, positive, error);
  if (status == ARC_OK)
    status =
        check_number("size_z", d->size_z, isfinite(d->size_z) && d->size_z > 0, positive, error);
  if (status == ARC_OK)
    status = check_number("nx", d->nx, d->nx >= 8 && d->nx <= 4096, "8 to 4096", error);
  if (status == ARC_OK)
    status = check_number("nz", d->nz, d->nz >= 8 && d->nz <= 4096, "8 to 4096", error);
  if (status == ARC_OK)
    status = check_number("track", d->track, d->track == 0 || (longer >= 0 && longer % 2 == 0),
                          "0, or nx plus an even number", error);
  if (status == ARC_OK)
    status = check_number("groove", d->groove, d->groove >= 0 && isfinite(d->groove),
                          "a length, or 0", error);
  if (status == ARC_OK)
    status = check_number("turned", d->turned, d->turned == 0 || d->turned == 1, "0 or 1", error);
  if (status == ARC_OK && d->periodic)
    status =
        check_number("periodic", d->periodic, d->track <= d->nx && d->nx % 2 == 0 && d->nz % 2 == 0,
                     "an even number of cells and no track", error);
  return status;
}

static arc_status check(const arc_halfspace_def *d, arc_error *error) {
  arc_status status = check_cells(d, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) status = check_body(&d->body[b], error);
  if (status != ARC_OK) return status;
  const double thinnest = arc_space_thinnest(d), widest = fmax(d->size_x, d->size_z);
  if (!d->periodic && thinnest > 0 && widest > 4 * thinnest)
    return arc_fail(error, ARC_GEOMETRY,
                    "cells of %g mm are too wide for a layer of %g mm: expected at most four times "
                    "its thickness",
                    widest, thinnest);
  return ARC_OK;
}

/* --- kernel ----------------------------------------------------------------------------------- */

static arc_status make_kernel(arc_halfspace *h, arc_error *error) {
  const arc_halfspace_def *d = &h->def;
  const double compliance = arc_space_surface_compliance(d);
  for (int i = 0; i < d->nx; i++)
    for (int j = 0; j < d->nz; j++)
      h->kernel[(size_t)i * (size_t)d->nz + (size_t)j] =
          compliance * arc_space_love(i * d->size_x, j * d->size_z, d->size_x / 2, d->size_z / 2);
  return arc_space_add_layers(d, h->kernel, error);
}

static double lag(const void *context, int row, int column) {
  const arc_halfspace *h = context;
  return h->kernel[(size_t)row * (size_t)h->def.nz + (size_t)column];
}

/* Creates the convolution of a periodic window, whose kernel is given by its Fourier transform, the
 * symbol. The mean displacement of half-spaces is infinite and is set to 0. */
static arc_status make_periodic(arc_halfspace *h, arc_error *error) {
  const arc_halfspace_def *d = &h->def;
  const int half_x = d->nx / 2 + 1, half_z = d->nz / 2 + 1;
  const double step_x = 2 * acos(-1) / (d->nx * d->size_x),
               step_z = 2 * acos(-1) / (d->nz * d->size_z);
  double *symbol = malloc((size_t)half_x * (size_t)half_z * sizeof *symbol);
  if (!symbol) return arc_fail(error, ARC_MEMORY, "out of memory for the influence coefficients");
  for (int i = 0; i < half_x; i++)
    for (int j = 0; j < half_z; j++)
      symbol[i * half_z + j] = i + j > 0 ? arc_space_symbol(d, hypot(i * step_x, j * step_z)) : 0;
  if (d->body[ARC_UPPER].depth > 0 && d->body[ARC_LOWER].depth > 0)
    symbol[0] = arc_space_symbol(d, 1e-4 * fmin(step_x, step_z));
  const arc_status status =
      arc_convolution_from_symbol(d->nx, d->nz, d->nx, d->nz, symbol, &h->convolution[0][0], error);
  free(symbol);
  return status;
}

arc_status arc_space_convolution(arc_halfspace *h, int level_x, int level_z,
                                 const convolution **found, arc_error *error) {
  convolution **kept = &h->convolution[level_x][level_z];
  arc_status status = ARC_OK;
  pthread_mutex_lock(&h->lock);
  if (!*kept)
    status = arc_convolution_create(h->level_x[level_x], h->level_z[level_z], EVEN_LAGS, lag, h,
                                    kept, error);
  *found = *kept;
  pthread_mutex_unlock(&h->lock);
  return status;
}

arc_status arc_space_make_inverse(int rows, int columns, lag_fn kernel, const void *context,
                                  convolution **made, arc_error *error) {
  const int box_x = arc_transform_length(rows + rows / 4),
            box_z = arc_transform_length(columns + columns / 4);
  const size_t count = ((size_t)box_x / 2 + 1) * ((size_t)box_z / 2 + 1);
  double *symbol = malloc(count * sizeof *symbol), least = INFINITY;
  if (!symbol) return arc_fail(error, ARC_MEMORY, "out of memory for the preconditioner");
  arc_status status = arc_convolution_symbol(box_x, box_z, kernel, context, symbol, error);
  for (size_t k = 0; k < count && status == ARC_OK; k++)
    if (symbol[k] > 0) least = fmin(least, symbol[k]);
  for (size_t k = 0; k < count && status == ARC_OK; k++) symbol[k] = 1 / fmax(symbol[k], least);
  if (status == ARC_OK)
    status = arc_convolution_from_symbol(rows, columns, box_x, box_z, symbol, made, error);
  free(symbol);
  return status;
}

arc_status arc_space_inverse(arc_halfspace *h, int level_x, int level_z, const convolution **found,
                             arc_error *error) {
  convolution **kept = &h->inverse[level_x][level_z];
  arc_status status = ARC_OK;
  pthread_mutex_lock(&h->lock);
  if (!*kept)
    status = arc_space_make_inverse(h->level_x[level_x], h->level_z[level_z], lag, h, kept, error);
  *found = *kept;
  pthread_mutex_unlock(&h->lock);
  return status;
}

/* --- creation --------------------------------------------------------------------------------- */

static void find_recess(arc_halfspace *h, int body) {
  const arc_halfspace_def *d = &h->def;
  const arc_halfspace_body *b = &d->body[body];
  const int rows = body == ARC_UPPER ? d->nx : h->rows;
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < d->nz; j++) {
      const double along = space_x(d, rows, i), across = space_z(d, j);
      const double x = d->turned ? across : along, z = d->turned ? along : across;
      double y = 0;
      if (b->radius_x != 0) y += x * x / (2 * b->radius_x);
      if (b->radius_z != 0) y += z * z / (2 * b->radius_z);
      if (b->recess) y += b->recess(b->context, x, z);
      h->recess[body][(size_t)i * (size_t)d->nz + (size_t)j] = y;
    }
}

static int allocate(arc_halfspace *h) {
  const size_t cells = (size_t)h->cells, nz = (size_t)h->def.nz;
  const int workers = h->def.workers;
  h->kernel = malloc(cells * sizeof *h->kernel);
  h->recess[ARC_UPPER] = malloc(cells * sizeof(double));
  h->recess[ARC_LOWER] = malloc((size_t)h->rows * nz * sizeof(double));
  h->work = calloc((size_t)workers, sizeof *h->work);
  h->scratch = malloc((size_t)workers * 2 * cells * sizeof *h->scratch);
  return h->kernel && h->recess[ARC_UPPER] && h->recess[ARC_LOWER] && h->work && h->scratch;
}

static arc_status check_recess(const arc_halfspace *h, arc_error *error) {
  for (int b = 0; b < ARC_BODIES; b++)
    for (int k = 0, n = arc_halfspace_sites(h, (arc_body)b); k < n; k++)
      if (!isfinite(h->recess[b][k]))
        return arc_fail(error, ARC_ARGUMENT, "field 'recess': expected a finite number, got %g",
                        h->recess[b][k]);
  return ARC_OK;
}

static arc_status fill(arc_halfspace *h, arc_error *error) {
  const convolution *largest;
  if (!allocate(h)) return arc_fail(error, ARC_MEMORY, "out of memory for %d cells", h->cells);
  for (int b = 0; b < ARC_BODIES; b++) find_recess(h, b);
  arc_status status = check_recess(h, error);
  arc_space_box_sizes(h->def.nx, h->def.periodic, h->level_x);
  arc_space_box_sizes(h->def.nz, h->def.periodic, h->level_z);
  if (status == ARC_OK && h->def.periodic)
    status = make_periodic(h, error);
  else if (status == ARC_OK)
    status = make_kernel(h, error);
  if (status == ARC_OK) status = arc_space_convolution(h, 0, 0, &largest, error);
  if (status == ARC_OK) status = arc_team_create(h->def.workers, &h->team, error);
  for (int w = 0; w < h->def.workers && status == ARC_OK; w++) {
    h->work[w] = arc_convolution_work(largest);
    if (!h->work[w]) status = arc_fail(error, ARC_MEMORY, "out of memory for a transform");
  }
  return status;
}

arc_status arc_halfspace_create(const arc_halfspace_def *def, arc_halfspace **made,
                                arc_error *error) {
  *made = NULL;
  arc_status status = check(def, error);
  if (status != ARC_OK) return status;
  arc_halfspace *h = calloc(1, sizeof *h);
  if (!h) return arc_fail(error, ARC_MEMORY, "out of memory for half-spaces");
  pthread_mutex_init(&h->lock, NULL);
  h->def = *def;
  h->def.workers = def->workers > 1 ? def->workers : 1;
  h->cells = def->nx * def->nz;
  h->rows = rows_of(def);
  status = fill(h, error);
  if (status != ARC_OK) arc_halfspace_destroy(&h);
  *made = h;
  return status;
}

void arc_halfspace_destroy(arc_halfspace **made) {
  arc_halfspace *h = *made;
  *made = NULL;
  if (!h) return;
  for (int i = 0; i < SPACE_LEVELS; i++)
    for (int j = 0; j < SPACE_LEVELS; j++) {
      arc_convolution_destroy(&h->convolution[i][j]);
      arc_convolution_destroy(&h->inverse[i][j]);
    }
  arc_cerruti_destroy(&h->shear);
  for (int w = 0; h->work && w < h->def.workers; w++) arc_convolution_work_free(&h->work[w]);
  arc_team_destroy(&h->team);
  pthread_mutex_destroy(&h->lock);
  free(h->kernel);
  free(h->recess[ARC_UPPER]);
  free(h->recess[ARC_LOWER]);
  free(h->work);
  free(h->scratch);
  free(h);
}

/* --- sites ------------------------------------------------------------------------------------ */

const arc_halfspace_def *arc_halfspace_definition(const arc_halfspace *h) {
  return &h->def;
}

int arc_halfspace_sites(const arc_halfspace *h, arc_body body) {
  return body == ARC_UPPER ? h->cells : h->rows * h->def.nz;
}

double arc_halfspace_site_area(const arc_halfspace *h, arc_body body) {
  const arc_halfspace_def *d = &h->def;
  return d->size_z * (body == ARC_LOWER && d->groove > 0 ? d->groove : d->size_x);
}

void arc_halfspace_site_at(const arc_halfspace *h, arc_body body, int site, double *x, double *z) {
  const arc_halfspace_def *d = &h->def;
  const double along = space_x(d, body == ARC_UPPER ? d->nx : h->rows, site / d->nz),
               across = space_z(d, site % d->nz);
  *x = d->turned ? across : along;
  *z = d->turned ? along : across;
}

int arc_space_is_flat(const arc_halfspace *h, const double *const depth[ARC_BODIES],
                      arc_body body) {
  const double *recess = h->recess[body], *worn = depth ? depth[body] : NULL;
  if (h->def.body[body].recess) return 0;
  for (int k = 0, n = arc_halfspace_sites(h, body); k < n; k++)
    if (recess[k] != 0 || (worn && worn[k] != 0)) return 0;
  return 1;
}

const double *arc_halfspace_recess(const arc_halfspace *h, arc_body body) {
  return h->recess[body];
}

double arc_halfspace_bytes(const arc_halfspace_def *d, int positions) {
  const double cells = (double)d->nx * d->nz, track = (double)rows_of(d) * d->nz;
  const double box = 4 * cells, workers = d->workers > 1 ? d->workers : 1;
  return 8 * (8 * cells * positions + 6 * (cells + track) + box + workers * 3 * cells);
}

/* --- sizes ------------------------------------------------------------------------------------ */

int arc_space_whole_cells(double number) {
  return (int)fmin(ceil(number), INT_MAX / 4);
}

static int odd_above(double n) {
  enum { fewest = 9 };
  const int whole = arc_space_whole_cells(fmax(n, fewest));
  return whole + (whole % 2 == 0);
}

/* Returns the half extent [mm] of the scar along an axis with relative radius r [mm]. It follows
 * from the half width of the elastic contact and the half extent of a cap with the worn volume. */
static double reach(double contact, double r, double other, double volume) {
  const double depth = sqrt(volume / (acos(-1) * sqrt(r * other)));
  return hypot(contact, sqrt(2 * r * depth));
}

arc_status arc_space_estimate(const arc_halfspace_def *d, double rx, double rz, double load,
                              arc_hertz_ellipse *hertz) {
  double compliance = arc_space_surface_compliance(d);
  arc_status status = arc_hertz_ellipse_of(rx, rz, 1 / compliance, load, hertz, NULL);
  for (int k = 0; k < 8 && arc_space_thinnest(d) > 0 && status == ARC_OK; k++) {
    const double q = 2 / sqrt(hertz->half_width * hertz->half_width_z);
    compliance = sqrt(compliance * q * arc_space_symbol(d, q) / 2);
    status = arc_hertz_ellipse_of(rx, rz, 1 / compliance, load, hertz, NULL);
  }
  return status;
}

void arc_halfspace_fit(arc_halfspace_def *d, double load, double volume, double stroke,
                       double increment, double fineness) {
  const arc_halfspace_body *b = d->body;
  double curvature[2] = {0};
  for (int k = 0; k < ARC_BODIES; k++) {
    if (b[k].radius_x != 0) curvature[0] += 1 / b[k].radius_x;
    if (b[k].radius_z != 0) curvature[1] += 1 / b[k].radius_z;
  }
  arc_hertz_ellipse hertz;
  const double rx = 1 / curvature[d->turned != 0], rz = 1 / curvature[d->turned == 0];
  if (arc_space_estimate(d, rx, rz, load, &hertz) != ARC_OK) return;
  const double usual = fmin(hertz.half_width, hertz.half_width_z) / fineness;
  d->size_x = increment > usual / 2 ? increment / fmax(1, round(increment / usual)) : usual;
  d->size_z = d->size_x;
  const double margin = 1.15;
  d->nx = odd_above(2 * margin * reach(hertz.half_width, rx, rz, volume) / d->size_x);
  d->nz = odd_above(2 * margin * reach(hertz.half_width_z, rz, rx, volume) / d->size_z);
  d->track = d->nx + 2 * arc_space_whole_cells(stroke / 2 / d->size_x - 1e-9);
}

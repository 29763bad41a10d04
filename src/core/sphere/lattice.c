/* Joints: checks of the definition, the lattice of cells, interpolation between its cells, and the
 * window of the contact. */
#include "core/base/carve.h"
#include "core/sphere/sphere.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

const char *const arc_foundation_names[] = {ARC_FOUNDATION_LIST(ARC_CHOICE_NAME) NULL};

/* --- definitions ------------------------------------------------------------------------------ */

arc_joint_def arc_joint_default(void) {
  const arc_material cocr = {.E = 230e3, .nu = 0.3}, pe = {.E = 1000, .nu = 0.4},
                     ti = {.E = 110e3, .nu = 0.3};
  return (arc_joint_def){.radius = 14,
                         .clearance = 0.06,
                         .cover = 90,
                         .core = cocr,
                         .cup = {{.thickness = 3, .material = cocr},
                                 {.thickness = 6, .material = pe},
                                 {.thickness = 2, .material = ti}},
                         .size = 2};
}

static arc_status expect(arc_error *error, const char *field, const char *what, double got) {
  return arc_fail(error, ARC_ARGUMENT, "field '%s': expected %s, got %g", field, what, got);
}

static arc_status check_layers(const arc_layer *layer, const char *body, double most,
                               arc_error *error) {
  double sum = 0;
  for (int i = 0; i < ARC_MOST_LAYERS && layer[i].thickness != 0; i++) {
    const arc_status status = arc_material_check(layer[i].material, error);
    if (status != ARC_OK) return status;
    if (!(layer[i].thickness > 0) || !isfinite(layer[i].thickness))
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%s.layers[%d].thickness': expected a number > 0 mm, got %g", body,
                      i + 1, layer[i].thickness);
    sum += layer[i].thickness;
  }
  if (sum < most) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field '%s.layers': expected a total thickness below the radius, %g mm, got %g mm", body,
      most, sum);
}

arc_status arc_joint_check(const arc_joint_def *def, arc_error *error) {
  if (!(def->radius > 0) || !isfinite(def->radius))
    return expect(error, "head.radius", "mm above 0", def->radius);
  if (!(def->clearance > 0) || !(def->clearance < def->radius / 2))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'cup.clearance': expected a radial clearance in mm above 0 and below half "
        "the radius, head.radius = %g mm, got %g",
        def->radius, def->clearance);
  if (!(def->cover > 0 && def->cover <= 180))
    return expect(error, "cup.cover", "degrees above 0 up to 180", def->cover);
  if (!(fabs(def->inclination) < 90))
    return expect(error, "cup.inclination", "degrees between -90 and 90", def->inclination);
  if (!(def->size >= 0.25 && def->size <= 10))
    return expect(error, "mesh.size", "degrees from 0.25 to 10", def->size);
  if (def->foundation < 0 || def->foundation > ARC_FOUNDATION_COLUMN)
    return expect(error, "foundation", "\"elastic\", \"winkler\" or \"column\"", def->foundation);
  if (def->cup[0].thickness == 0)
    return arc_fail(error, ARC_ARGUMENT, "field 'cup.layers': expected at least one, got none");
  arc_status status = arc_material_check(def->core, error);
  if (status == ARC_OK) status = check_layers(def->head, "head", def->radius, error);
  if (status == ARC_OK) status = check_layers(def->cup, "cup", 1e6 * def->radius, error);
  return status;
}

/* --- the lattice ------------------------------------------------------------------------------ */

static void place_cells(arc_joint *j) {
  for (int i = 0; i < j->rows; i++) {
    const double theta = (i + 0.5) * j->d, low = cos(i * j->d), high = cos((i + 1) * j->d);
    for (int k = 0; k < 2 * j->rows; k++) {
      const double phi = (k + 0.5 - j->rows) * j->d;
      const int site = i * 2 * j->rows + k;
      double *n = j->normal + 3 * (size_t)site;
      n[0] = cos(theta), n[1] = sin(theta) * sin(phi), n[2] = sin(theta) * cos(phi);
      j->area[site] = j->def.radius * j->def.radius * (low - high) * j->d;
    }
  }
}

void arc_sphere_rotate(const double R[9], const double n[3], double to[3]) {
  for (int i = 0; i < 3; i++) to[i] = R[3 * i] * n[0] + R[3 * i + 1] * n[1] + R[3 * i + 2] * n[2];
}

void arc_sphere_rotate_back(const double R[9], const double n[3], double to[3]) {
  for (int i = 0; i < 3; i++) to[i] = R[i] * n[0] + R[3 + i] * n[1] + R[6 + i] * n[2];
}

/* Computes the row and the column of the direction n, counted from the centre of the first cell. */
static void locate(const arc_joint *j, const double n[3], double *row, double *column) {
  *row = acos(fmax(-1, fmin(1, n[0]))) / j->d - 0.5;
  *column = (atan2(n[1], n[2]) + pi) / j->d - 0.5;
}

static double value(const arc_joint *j, const double *map, int row, int column) {
  const int columns = 2 * j->rows;
  if (row < 0) row = 0;
  if (row >= j->rows) row = j->rows - 1;
  return map[row * columns + (column + columns) % columns];
}

double arc_sphere_linear(const arc_joint *j, const double *map, const double n[3]) {
  double row, column;
  locate(j, n, &row, &column);
  const int i = (int)floor(row), k = (int)floor(column);
  const double s = row - i, t = column - k;
  return (1 - s) * ((1 - t) * value(j, map, i, k) + t * value(j, map, i, k + 1)) +
         s * ((1 - t) * value(j, map, i + 1, k) + t * value(j, map, i + 1, k + 1));
}

/* Computes the Lagrange weights of four points at -1, 0, 1 and 2 for the position t. */
static void cubic_weights(double t, double w[4]) {
  w[0] = -t * (t - 1) * (t - 2) / 6;
  w[1] = (t + 1) * (t - 1) * (t - 2) / 2;
  w[2] = -(t + 1) * t * (t - 2) / 2;
  w[3] = (t + 1) * t * (t - 1) / 6;
}

double arc_sphere_cubic(const arc_joint *j, const double *map, const double n[3]) {
  double row, column, a[4], b[4], sum = 0;
  locate(j, n, &row, &column);
  const int i = (int)floor(row), k = (int)floor(column);
  cubic_weights(row - i, a);
  cubic_weights(column - k, b);
  for (int r = 0; r < 4; r++)
    for (int c = 0; c < 4; c++) sum += a[r] * b[c] * value(j, map, i + r - 1, k + c - 1);
  return sum;
}

double arc_sphere_sliding(const arc_joint *j, const double w[3], int site) {
  const double *n = j->normal + 3 * (size_t)site;
  return j->def.radius *
         sqrt(pow(w[1] * n[2] - w[2] * n[1], 2) + pow(w[2] * n[0] - w[0] * n[2], 2) +
              pow(w[0] * n[1] - w[1] * n[0], 2));
}

/* --- the window ------------------------------------------------------------------------------- */

static void leave_window(arc_joint *j) {
  arc_sphere_kernel_free(&j->kernel);
  arc_active_work_destroy(&j->work);
  free(j->gap);
  free(j->kept);
  j->gap = j->kept = NULL;
  j->kept_count = 0;
}

arc_status arc_sphere_open(arc_joint *j, int size, arc_error *error) {
  leave_window(j);
  j->size = size;
  const size_t n = (size_t)size * (size_t)size;
  const carve_part parts[] = {
      {&j->gap, n}, {&j->mode, 3 * n}, {&j->cell, n}, {&j->press, n}, {&j->soft, n}};
  if (j->def.foundation == ARC_FOUNDATION_ELASTIC) j->kernel = arc_sphere_kernel(j, size);
  j->work = arc_active_work_create(1, (int)n, 3, 0);
  if (!ARC_CARVE(parts) || !j->work || (j->def.foundation == ARC_FOUNDATION_ELASTIC && !j->kernel))
    return arc_fail(error, ARC_MEMORY, "out of memory for a contact of %d x %d cells", size, size);
  for (int c = 0; c < (int)n; c++) {
    const int site = sphere_site(j, c);
    j->cell[c] = j->area[site];
    for (int k = 0; k < 3; k++) j->mode[(size_t)k * n + (size_t)c] = j->normal[3 * site + k];
  }
  return ARC_OK;
}

arc_status arc_sphere_make_kept(arc_joint *j, int instants, arc_error *error) {
  const size_t count = (size_t)instants * (size_t)j->size * (size_t)j->size;
  double *kept = calloc(count > 0 ? count : 1, sizeof *kept);
  if (!kept) return arc_fail(error, ARC_MEMORY, "out of memory for initial pressures");
  free(j->kept);
  j->kept = kept;
  j->kept_count = instants;
  return ARC_OK;
}

arc_status arc_sphere_grow(arc_joint *j, arc_error *error) {
  const int most = j->rows - 2, wanted = j->size + 2 * (j->size / 8 + 1);
  if (j->size >= most)
    return arc_fail(error, ARC_ZONE,
                    "the contact reaches %.0f degrees from the direction of the load: expected a "
                    "contact that does not reach the poles of the cup; are clearance and wear in "
                    "mm, the load in N and k in mm2/N?",
                    most * j->d * 90 / pi);
  return arc_sphere_open(j, wanted < most ? wanted : most, error);
}

/* --- joints ----------------------------------------------------------------------------------- */

void arc_joint_destroy(arc_joint **joint) {
  arc_joint *j = *joint;
  *joint = NULL;
  if (!j) return;
  leave_window(j);
  free(j->normal);
  free(j->remainder);
  free(j);
}

arc_status arc_joint_create(const arc_joint_def *def, arc_joint **made, arc_error *error) {
  enum { first_window = 40 /* initial width of the window [degrees] */ };
  int numeric = 0;
  *made = NULL;
  arc_status status = arc_joint_check(def, error);
  if (status != ARC_OK) return status;
  arc_joint *j = calloc(1, sizeof *j);
  if (!j) return arc_fail(error, ARC_MEMORY, "out of memory for a joint");
  j->def = *def;
  j->rows = 2 * (int)ceil(90 / def->size - 1e-9);
  j->d = pi / j->rows;
  j->sites = 2 * j->rows * j->rows;
  j->limit = arc_sphere_limit(def, j->rows);
  j->K = arc_sphere_winkler(def);
  const size_t n = (size_t)j->sites;
  const carve_part parts[] = {{&j->normal, 3 * n}, {&j->area, n},   {&j->h[0], n},
                              {&j->h[1], n},       {&j->p, n},      {&j->shear, 3 * n},
                              {&j->creep, n},      {&j->pressed, n}};
  if (!ARC_CARVE(parts)) status = arc_fail(error, ARC_MEMORY, "out of memory for a joint");
  if (status == ARC_OK && def->foundation == ARC_FOUNDATION_ELASTIC) {
    j->remainder = arc_sphere_remainder(def, j->rows, &numeric);
    if (numeric)
      status = arc_fail(error, ARC_NUMERIC,
                        "the compliance of the layers cannot be computed: a layer may be too thin");
    else if (!j->remainder)
      status = arc_fail(error, ARC_MEMORY, "out of memory for a joint");
  }
  if (status == ARC_OK) {
    place_cells(j);
    status = arc_sphere_open(j, 2 * (int)ceil(first_window / 2 * pi / 180 / j->d), error);
  }
  if (status != ARC_OK) arc_joint_destroy(&j);
  *made = j;
  return status;
}

const arc_joint_def *arc_joint_definition(const arc_joint *j) {
  return &j->def;
}

int arc_joint_rows(const arc_joint *j) {
  return j->rows;
}

const double *arc_joint_depth(const arc_joint *j, arc_body body) {
  return j->h[body];
}

const double *arc_joint_creep(const arc_joint *j) {
  return j->creep;
}

const double *arc_joint_pressure(const arc_joint *j) {
  return j->p;
}

double arc_joint_cell_area(const arc_joint *j, int site) {
  return j->area[site];
}

arc_status arc_joint_set_depth(arc_joint *j, arc_body body, const double *depth, arc_error *error) {
  for (int i = 0; i < j->sites; i++)
    if (!(fabs(depth[i]) < j->def.radius))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'worn': expected depths in mm below the radius, got %g at cell %d",
                      depth[i], i + 1);
  memcpy(j->h[body], depth, (size_t)j->sites * sizeof *depth);
  return ARC_OK;
}

void arc_joint_cross_shear(const arc_joint *j, double *share) {
  for (int i = 0; i < j->sites; i++) {
    const double *t = j->shear + 3 * (size_t)i, trace = t[0] + t[2];
    const double root = sqrt(pow(t[0] - t[2], 2) + 4 * t[1] * t[1]);
    share[i] = trace > 0 ? fmax(0, (trace - root) / (2 * trace)) : 0;
  }
}

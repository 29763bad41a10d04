/* Transfers depths to another grid with a larger window, a longer track or finer cells. */
#include "core/space/halfspace.h"

#include <math.h>
#include <string.h>

/* The cells of one body along one axis, symmetric about 0. */
typedef struct axis {
  int count;
  double size;
} axis;

static axis along_x(const arc_halfspace *h, int body) {
  return (axis){body == ARC_UPPER ? h->def.nx : h->rows,
                body == ARC_LOWER && h->def.groove > 0 ? h->def.groove : h->def.size_x};
}

static axis along_z(const arc_halfspace *h) {
  return (axis){h->def.nz, h->def.size_z};
}

/* Returns the position of cell i of the axis `to`, in cells of the axis `from`. */
static double place(const axis *to, int i, const axis *from) {
  const double x = (i - (to->count - 1) / 2.0) * to->size / from->size + (from->count - 1) / 2.0;
  return fabs(x - round(x)) < 1e-9 ? round(x) : x;
}

static double at(const double *value, const axis *x, const axis *z, int i, int j) {
  if (i < 0 || j < 0 || i >= x->count || j >= z->count) return 0;
  return value[(size_t)i * (size_t)z->count + (size_t)j];
}

/* Returns the value at (u, v) [cells], interpolated linearly along both axes between four cells. */
static double between(const double *value, const axis *x, const axis *z, double u, double v) {
  const int i = (int)floor(u), j = (int)floor(v);
  const double s = u - i, t = v - j;
  double sum = (1 - s) * (1 - t) * at(value, x, z, i, j);
  if (s > 0) sum += s * (1 - t) * at(value, x, z, i + 1, j);
  if (t > 0) sum += (1 - s) * t * at(value, x, z, i, j + 1);
  if (s > 0 && t > 0) sum += s * t * at(value, x, z, i + 1, j + 1);
  return sum;
}

static double total(const double *value, const axis *x, const axis *z) {
  double sum = 0;
  for (size_t k = 0, n = (size_t)x->count * (size_t)z->count; k < n; k++) sum += value[k];
  return sum * x->size * z->size;
}

/* Returns true if a worn cell lies outside the new grid. */
static int loses(const double *value, const axis *x, const axis *z, const axis *to_x,
                 const axis *to_z) {
  const double half_x = to_x->count * to_x->size / 2, half_z = to_z->count * to_z->size / 2;
  for (int i = 0; i < x->count; i++)
    for (int j = 0; j < z->count; j++)
      if (at(value, x, z, i, j) != 0 && (fabs((i - (x->count - 1) / 2.0) * x->size) > half_x ||
                                         fabs((j - (z->count - 1) / 2.0) * z->size) > half_z))
        return 1;
  return 0;
}

/* Multiplies the depths by a factor that adds `missing` to their sum. */
static void scale(double *grown, size_t cells, double missing) {
  double sum = 0;
  for (size_t k = 0; k < cells; k++) sum += grown[k];
  for (size_t k = 0; k < cells && sum > 0; k++) grown[k] *= 1 + missing / sum;
}

/* Adds the depths that are missing, summed over all cells, to the worn cells in equal parts. A
 * factor would change the shape of the scar, and with it the pressures, more. */
static void keep_sum(double *grown, size_t cells, double missing) {
  size_t worn = 0, deeper = 0;
  for (size_t k = 0; k < cells; k++) worn += grown[k] > 0;
  const double least = worn > 0 ? 2 * fabs(missing) / (double)worn : 0;
  for (size_t k = 0; k < cells; k++) deeper += grown[k] > least;
  if (2 * deeper < worn) {
    scale(grown, cells, missing);
    return;
  }
  for (size_t k = 0; k < cells; k++)
    if (grown[k] > least) grown[k] += missing / (double)deeper;
}

static void regrow(const double *value, const axis *x, const axis *z, const axis *to_x,
                   const axis *to_z, double *grown) {
  int exact = x->size == to_x->size && z->size == to_z->size;
  for (int i = 0; i < to_x->count; i++)
    for (int j = 0; j < to_z->count; j++) {
      const double u = place(to_x, i, x), v = place(to_z, j, z);
      exact = exact && u == floor(u) && v == floor(v);
      grown[(size_t)i * (size_t)to_z->count + (size_t)j] = between(value, x, z, u, v);
    }
  if (exact) return;
  const double missing = total(value, x, z) - total(grown, to_x, to_z);
  keep_sum(grown, (size_t)to_x->count * (size_t)to_z->count, missing / (to_x->size * to_z->size));
}

arc_status arc_halfspace_regrow(const arc_halfspace *from, const double *const depth[ARC_BODIES],
                                const arc_halfspace *to, double *const grown[ARC_BODIES],
                                arc_error *error) {
  const axis z = along_z(from), to_z = along_z(to);
  for (int b = 0; b < ARC_BODIES; b++) {
    const axis x = along_x(from, b), to_x = along_x(to, b);
    if (loses(depth[b], &x, &z, &to_x, &to_z))
      return arc_fail(error, ARC_ZONE, "the new window does not contain all worn cells");
  }
  for (int b = 0; b < ARC_BODIES; b++) {
    const axis x = along_x(from, b), to_x = along_x(to, b);
    regrow(depth[b], &x, &z, &to_x, &to_z, grown[b]);
  }
  return ARC_OK;
}

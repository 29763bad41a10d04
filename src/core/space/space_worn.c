/* Initial surfaces with depths given by the user, for runs and contacts. */
#include "core/space/space_kind.h"

#include <math.h>

static int odd_cells(double half, double size) {
  return 2 * (int)ceil(half / size) + 1;
}

arc_status arc_space_given_create(arc_model *model, const arc_wear_def *def, double half_x,
                                  double half_z, arc_shape **shape, arc_error *error) {
  static const double most =
      1e6; /* largest number of cells along an axis; memory sets a lower limit */
  arc_halfspace_def cells = arc_space_cells(def, arc_model_definition(model));
  const int beyond = cells.track > 0 ? cells.track - cells.nx : 0;
  *shape = NULL;
  if (!(fmax(half_x / cells.size_x, half_z / cells.size_z) < most))
    return arc_fail(error, ARC_ARGUMENT, "field 'worn': expected depths within %g mm, got %g",
                    most * cells.size_x, fmax(half_x, half_z));
  if (!cells.periodic) {
    cells.nx = (int)fmax(cells.nx, odd_cells(cells.turned ? half_z : half_x, cells.size_x));
    cells.nz = (int)fmax(cells.nz, odd_cells(cells.turned ? half_x : half_z, cells.size_z));
  }
  if (cells.groove == 0) cells.track = cells.nx + beyond;
  arc_space_limit(arc_model_definition(model), &cells);
  return arc_space_create(model, &cells, (space_shape **)(void *)shape, error);
}

int arc_space_given_sites(const arc_shape *shape, arc_body body, const double **x,
                          const double **z) {
  const space_shape *s = space_shape_of(shape);
  *x = s->grid->x[body];
  *z = s->grid->z[body];
  return space_sites(s, (int)body);
}

static int is_border(const space_shape *s, int b, int i) {
  const arc_halfspace_def *d = arc_halfspace_definition(s->grid->h);
  const int nz = d->nz, rows = space_sites(s, b) / nz;
  if (d->periodic) return 0;
  return (rows > 1 && (i / nz == 0 || i / nz == rows - 1)) || i % nz == 0 || i % nz == nz - 1;
}

arc_status arc_space_given_depths(arc_shape *shape, arc_body body, const double *depth,
                                  arc_error *error) {
  space_shape *s = (space_shape *)(void *)shape;
  static const double nothing = 1e-12; /* share of the largest depth that is 0 at the border */
  const int n = space_sites(s, (int)body);
  double most = 0;
  for (int i = 0; i < n; i++) most = fmax(most, depth[i]);
  for (int i = 0; i < n; i++) {
    if (!(depth[i] >= 0) || !isfinite(depth[i]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field 'worn': expected depths >= 0 mm, got %g at x = %g, z = %g mm",
                      depth[i], s->grid->x[body][i], s->grid->z[body][i]);
    if (depth[i] > nothing * most && is_border(s, (int)body, i))
      return arc_fail(
          error, ARC_ZONE,
          "field 'worn': expected a depth that is 0 at the border of the window, got %g "
          "mm at x = %g, z = %g mm",
          depth[i], s->grid->x[body][i], s->grid->z[body][i]);
  }
  for (int i = 0; i < n; i++) s->depth[body][i] = is_border(s, (int)body, i) ? 0 : depth[i];
  return ARC_OK;
}

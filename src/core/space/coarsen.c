/* Doubles the cells of a run when wear has made its contact much wider, so that long runs do not
 * stay on the cells of the unworn contact. */
#include "core/space/halfspace.h"
#include "core/space/space_kind.h"

#include <math.h>

/* Resolution of the contact, divided by that of the unworn contact, above which cells are doubled.
 */
static const double rich = 2.5;

enum { fewest = 8 }; /* cells of a stroke below which they are not doubled */

int arc_space_follows(const arc_wear_def *def, const arc_model_def *model) {
  const arc_halfspace_def bodies = arc_space_bodies(model);
  return !(model->mesh.size > 0) && !model->periodic && !arc_wear_has_friction(def) &&
         arc_space_thinnest(&bodies) == 0 && !arc_body_is_map(&model->body[ARC_UPPER]) &&
         !arc_body_is_map(&model->body[ARC_LOWER]);
}

double arc_space_stroke_unit(const arc_wear_def *def, const arc_model_def *model, double cells) {
  enum { most = 1 << 20 };
  double unit = 2;
  if (!arc_space_follows(def, model)) return unit;
  while (unit < most && cells >= fewest * unit) unit *= 2;
  return unit;
}

/* Returns true if cells along the motion may be as long as `increments` of the `half` increments of
 * a stroke. */
static int divides(const arc_wear_def *def, int half, int increments) {
  return def->blocks == 0 && def->increments == 0 && half % (2 * increments) == 0 &&
         half / increments >= fewest;
}

double arc_space_first_volume(const arc_wear_def *def, const arc_model_def *model, int rests) {
  if (!arc_space_follows(def, model) ||
      (!rests && !divides(def, arc_space_increments(def, model) / 2, 2)))
    return INFINITY;
  const arc_hertz_ellipse hertz = arc_space_hertz(model, def->load);
  const double radius = hertz.half_width * hertz.half_width_z / hertz.approach,
               depth = rich * rich / 2 * hertz.approach;
  return acos(-1) * radius * depth * depth;
}

int arc_space_increments_per_cell(const arc_wear *w, const wear_block *b) {
  const arc_halfspace_def *d = arc_halfspace_definition(space_shape_of(w->shape)->grid->h);
  const double step = b->count > 2 ? fabs(b->x[1] - b->x[0]) : 0;
  if (w->manner.rests || arc_wear_has_friction(&w->def) || !(d->size_x < step * b->count)) return 1;
  const int increments = (int)round(d->size_x / step);
  return increments > 1 && divides(&w->def, (b->count - 1) / 2, increments) ? increments : 1;
}

/* Returns true if the cells along the motion can be doubled. */
static int can_double(const arc_wear *w, const arc_halfspace_def *cells) {
  const wear_block *b = &w->block[0];
  return w->manner.rests ||
         ((cells->track - cells->nx) % 4 == 0 &&
          divides(&w->def, (b->count - 1) / 2, 2 * arc_space_increments_per_cell(w, b)));
}

/* Returns the number of doubled cells for a window of n cells: enough for twice the present
 * contact, and at least for the present window. */
static int doubled(int n, double half_width, double size) {
  static const double margin = 1.15;
  const int same = 2 * ((n + 1) / 4) + 1, needed = 2 * (int)(margin * half_width / size) + 1;
  return needed > same ? needed : same;
}

/* Returns the half width [mm] above which cells of a size are doubled, for the half width of the
 * unworn contact and its default cell. Half widths are often whole or half numbers of cells, where
 * a rounding error would decide, so the limit is between them. */
static double limit(double unworn, double cell, double size) {
  return (round(rich * unworn / cell) + 0.25) * size;
}

int arc_space_coarsen(const arc_wear *w, arc_halfspace_def *cells) {
  const arc_model_def *model = arc_model_definition(w->model);
  const arc_wear_record *last = arc_wear_last(w);
  const space_shape *s = space_shape_of(w->shape);
  *cells = *arc_halfspace_definition(s->grid->h);
  if (!arc_space_follows(&w->def, model)) return 0;
  const arc_hertz_ellipse hertz = arc_space_hertz(model, w->def.load);
  const double cell = arc_space_cell(model, w->def.load),
               unworn = space_along(s, hertz.half_width, hertz.half_width_z),
               unworn_z = space_along(s, hertz.half_width_z, hertz.half_width),
               along = space_along(s, last->half_width, last->half_width_z),
               across = space_along(s, last->half_width_z, last->half_width);
  const int beyond = cells->track - cells->nx;
  const int by_x = along > limit(unworn, cell, cells->size_x) && can_double(w, cells),
            by_z = across > limit(unworn_z, cell, cells->size_z);
  if (by_x) {
    cells->nx = doubled(cells->nx, along, cells->size_x);
    cells->size_x *= 2;
    if (cells->groove == 0) cells->track = cells->nx + beyond / 2;
  }
  if (by_z) {
    cells->nz = doubled(cells->nz, across, cells->size_z);
    cells->size_z *= 2;
  }
  return by_x || by_z;
}

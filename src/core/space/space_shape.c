/* Worn surfaces that depend on x and z, on grids of cells that they share, and their conversion to
 * arrays for storage. */
#include "core/space/space_kind.h"

#include "core/base/carve.h"
#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- cells ------------------------------------------------------------------------------------ */

space_grid *arc_space_hold(space_grid *grid) {
  grid->references++;
  return grid;
}

void arc_space_let_go(space_grid **held) {
  space_grid *grid = *held;
  *held = NULL;
  if (!grid || --grid->references > 0) return;
  arc_halfspace_destroy(&grid->h);
  free(grid->x[ARC_UPPER]);
  free(grid);
}

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for surfaces");
}

/* Returns ARC_MEMORY for windows that need more than the free memory or have too many rows or
 * columns. */
static arc_status check_memory(const arc_halfspace_def *d, arc_error *error) {
  enum { most = 4096 };
  const int positions = d->track > d->nx ? d->track - d->nx + 1 : 1;
  const double needed = 2 * arc_halfspace_bytes(d, positions), left = arc_memory_free();
  if (d->nx > most || d->nz > most)
    return arc_fail(error, ARC_MEMORY,
                    "a window of %d x %d cells: expected at most %d x %d; use a mesh.size above "
                    "%.2g mm",
                    d->nx, d->nz, most, most, d->size_x);
  if (needed <= left) return ARC_OK;
  return arc_fail(error, ARC_MEMORY,
                  "a window of %d x %d cells%s needs about %.2g GB of memory, and %.2g GB are "
                  "free: use a mesh.size above %.2g mm%s",
                  d->nx, d->nz, positions > 1 ? " at all positions of the motion" : "",
                  needed / 1e9, left / 1e9, d->size_x,
                  positions > 1 ? ", a shorter motion or, in wear{}, procedure = \"NSP\"" : "");
}

static arc_status create_grid(const arc_halfspace_def *cells, space_grid **made, arc_error *error) {
  arc_status status = check_memory(cells, error);
  *made = NULL;
  if (status != ARC_OK) return status;
  space_grid *grid = calloc(1, sizeof *grid);
  if (!grid) return out_of_memory(error);
  grid->references = 1;
  status = arc_halfspace_create(cells, &grid->h, error);
  if (status == ARC_OK) {
    const size_t nu = (size_t)arc_halfspace_sites(grid->h, ARC_UPPER),
                 nl = (size_t)arc_halfspace_sites(grid->h, ARC_LOWER);
    const carve_part parts[] = {{&grid->x[ARC_UPPER], nu},
                                {&grid->x[ARC_LOWER], nl},
                                {&grid->z[ARC_UPPER], nu},
                                {&grid->z[ARC_LOWER], nl}};
    if (!ARC_CARVE(parts)) status = out_of_memory(error);
  }
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    for (int i = 0; i < arc_halfspace_sites(grid->h, (arc_body)b); i++)
      arc_halfspace_site_at(grid->h, (arc_body)b, i, &grid->x[b][i], &grid->z[b][i]);
  if (status != ARC_OK) arc_space_let_go(&grid);
  *made = grid;
  return status;
}

/* --- surfaces --------------------------------------------------------------------------------- */

void arc_space_discard(arc_shape **shape) {
  space_shape *s = (space_shape *)(void *)*shape;
  *shape = NULL;
  if (!s) return;
  arc_space_let_go(&s->grid);
  free(s->depth[ARC_UPPER]);
  arc_model_release(&s->handle.model);
  free(s);
}

static arc_status create_on(arc_model *model, space_grid *grid, space_shape **result,
                            arc_error *error) {
  const size_t nu = (size_t)arc_halfspace_sites(grid->h, ARC_UPPER),
               nl = (size_t)arc_halfspace_sites(grid->h, ARC_LOWER);
  space_shape *s = *result = calloc(1, sizeof *s);
  if (!s) return out_of_memory(error);
  const size_t nz = (size_t)arc_halfspace_definition(grid->h)->nz;
  s->depth[ARC_UPPER] = calloc(nu + nl + 3 * (nu + nl) / nz, sizeof(double));
  if (!s->depth[ARC_UPPER]) {
    free(s);
    *result = NULL;
    return out_of_memory(error);
  }
  s->depth[ARC_LOWER] = s->depth[ARC_UPPER] + nu;
  s->line[ARC_UPPER] = s->depth[ARC_LOWER] + nl;
  s->line[ARC_LOWER] = s->line[ARC_UPPER] + 3 * nu / nz;
  s->grid = arc_space_hold(grid);
  s->handle.model = arc_model_retain(model);
  return ARC_OK;
}

arc_status arc_space_create(arc_model *model, const arc_halfspace_def *cells, space_shape **shape,
                            arc_error *error) {
  space_grid *grid;
  *shape = NULL;
  arc_status status = create_grid(cells, &grid, error);
  if (status != ARC_OK) return status;
  status = create_on(model, grid, shape, error);
  arc_space_let_go(&grid);
  return status;
}

arc_status arc_space_copy(const arc_shape *shape, arc_shape **copy, arc_error *error) {
  const space_shape *from = space_shape_of(shape);
  space_shape *to;
  const arc_status status = create_on(from->handle.model, from->grid, &to, error);
  *copy = (arc_shape *)(void *)to;
  if (status != ARC_OK) return status;
  const size_t n = (size_t)(space_sites(from, ARC_UPPER) + space_sites(from, ARC_LOWER));
  memcpy(to->depth[ARC_UPPER], from->depth[ARC_UPPER], n * sizeof(double));
  return ARC_OK;
}

arc_status arc_space_regrow(const space_shape *from, const arc_halfspace_def *cells,
                            space_shape **grown, arc_error *error) {
  arc_status status = arc_space_create(from->handle.model, cells, grown, error);
  if (status != ARC_OK) return status;
  const double *const depth[] = {from->depth[ARC_UPPER], from->depth[ARC_LOWER]};
  double *const to[] = {(*grown)->depth[ARC_UPPER], (*grown)->depth[ARC_LOWER]};
  status = arc_halfspace_regrow(from->grid->h, depth, (*grown)->grid->h, to, error);
  if (status != ARC_OK) arc_space_discard((arc_shape **)(void *)grown);
  return status;
}

/* Creates the initial surfaces of a run from worn surfaces. The cells are unchanged. The track is
 * extended if necessary, and the threads are those of the run. */
static arc_status take_over(arc_model *model, const arc_wear_def *def, const arc_shape *from,
                            arc_shape **shape, arc_error *error) {
  const space_shape *worn = space_shape_of(from);
  const arc_halfspace_def wanted = arc_space_cells(def, arc_model_definition(model));
  arc_halfspace_def cells = *arc_halfspace_definition(worn->grid->h);
  if (worn->handle.model != model)
    return arc_fail(error, ARC_ARGUMENT, "worn: the starting shape belongs to another model");
  if ((cells.groove > 0) != (wanted.groove > 0) ||
      (cells.groove > 0 && cells.groove != wanted.groove))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'procedure': a groove (\"NSP\") needs a starting shape worn as a groove "
                    "with the same stroke");
  if (cells.turned != wanted.turned)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'slide': expected \"%s\", along which the starting shape was worn",
                    arc_slide_names[cells.turned]);
  const double margin = (wanted.track - wanted.nx) * wanted.size_x;
  const int beyond = 2 * (int)ceil(margin / 2 / cells.size_x - 1e-9);
  const int contains = cells.groove > 0 || cells.track >= cells.nx + beyond;
  if (contains && cells.workers == wanted.workers) return arc_space_copy(from, shape, error);
  if (!contains) cells.track = cells.nx + beyond;
  cells.workers = wanted.workers;
  return arc_space_regrow(worn, &cells, (space_shape **)(void *)shape, error);
}

/* Enlarges the window until it contains the contact, because the estimate of the contact may be too
 * small for layers and maps. */
static arc_status hold_contact(const arc_model_def *model, double load, arc_shape **shape,
                               arc_error *error) {
  enum { most_tries = 12 };
  arc_status status = arc_space_hold_load(space_shape_of(*shape), load, error);
  for (int i = 0; i < most_tries && status == ARC_ZONE; i++) {
    const space_shape *s = space_shape_of(*shape);
    arc_halfspace_def cells = *arc_halfspace_definition(s->grid->h);
    space_shape *larger = NULL;
    status = arc_space_widen(model, 4, &cells, error);
    if (status == ARC_OK) status = arc_space_regrow(s, &cells, &larger, error);
    if (status != ARC_OK) break;
    arc_space_discard(shape);
    *shape = (arc_shape *)(void *)larger;
    status = arc_space_hold_load(larger, load, error);
  }
  if (status != ARC_OK) arc_space_discard(shape);
  return status;
}

arc_status arc_space_surfaces(arc_model *model, const arc_wear_def *def, const arc_shape *from,
                              arc_shape **shape, arc_error *error) {
  const arc_model_def *bodies = arc_model_definition(model);
  const arc_halfspace_def cells = arc_space_cells(def, bodies);
  *shape = NULL;
  const arc_status status =
      from ? take_over(model, def, from, shape, error)
           : arc_space_create(model, &cells, (space_shape **)(void *)shape, error);
  return status == ARC_OK ? hold_contact(bodies, def->load, shape, error) : status;
}

/* --- conversion to arrays --------------------------------------------------------------------- */

enum { SIZE_X, SIZE_Z, NX, NZ, TRACK, GROOVE, CELLS };

arc_array *arc_space_save(const arc_shape *shape, size_t *count) {
  const space_shape *s = space_shape_of(shape);
  const arc_halfspace_def *d = arc_halfspace_definition(s->grid->h);
  const double cells[CELLS] = {d->size_x, d->size_z, d->nx, d->nz, d->track, d->groove};
  const size_t nz = (size_t)d->nz;
  const arc_array list[] = {
      {"cells", ARC_UPPER, 0, 0, {1, CELLS}, cells},
      {"h", ARC_UPPER, 0, 0, {(size_t)d->nx, nz}, s->depth[ARC_UPPER]},
      {"h", ARC_LOWER, 0, 0, {(size_t)space_sites(s, ARC_LOWER) / nz, nz}, s->depth[ARC_LOWER]}};
  *count = 3;
  return arc_arrays_copy(list, *count);
}

static int whole(double value) {
  return value >= 0 && value <= 1e5 && value == floor(value);
}

static arc_status read_cells(const arc_array *state, size_t count, arc_halfspace_def *d,
                             arc_error *error) {
  const arc_array *cells = arc_array_find(state, count, ARC_UPPER, "cells");
  if (cells && arc_array_count(cells) == CELLS) {
    const double *v = cells->values;
    if (whole(v[NX]) && whole(v[NZ]) && whole(v[TRACK])) {
      d->size_x = v[SIZE_X];
      d->size_z = v[SIZE_Z];
      d->nx = (int)v[NX];
      d->nz = (int)v[NZ];
      d->track = (int)v[TRACK];
      d->groove = v[GROOVE];
      return ARC_OK;
    }
  }
  return arc_fail(error, ARC_ARGUMENT,
                  "state: expected %d numbers for the cells, three of them whole numbers", CELLS);
}

static arc_status read_depths(space_shape *s, int b, const arc_array *state, size_t count,
                              arc_error *error) {
  static const double most = 1e6; /* largest depth that a file may contain [mm] */
  const arc_array *h = arc_array_find(state, count, (arc_body)b, "h");
  const size_t n = (size_t)space_sites(s, b);
  if (!h || arc_array_count(h) != n)
    return arc_fail(error, ARC_ARGUMENT, "state: expected %zu depths h of the %s", n,
                    arc_body_name((arc_body)b));
  for (size_t i = 0; i < n; i++) {
    if (!(fabs(h->values[i]) < most))
      return arc_fail(error, ARC_ARGUMENT, "state: expected depths in mm, got h[%zu] = %g", i,
                      h->values[i]);
    s->depth[b][i] = h->values[i];
  }
  return ARC_OK;
}

arc_status arc_space_load(arc_model *model, const arc_wear_def *def, const arc_array *state,
                          size_t count, arc_shape **shape, arc_error *error) {
  *shape = NULL;
  arc_halfspace_def cells = arc_space_bodies(arc_model_definition(model));
  space_shape *s = NULL;
  cells.turned = def->slide == ARC_SLIDE_Z;
  cells.workers = def->workers;
  arc_status status = read_cells(state, count, &cells, error);
  if (status == ARC_OK) status = arc_space_create(model, &cells, &s, error);
  *shape = (arc_shape *)(void *)s;
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = read_depths(s, b, state, count, error);
  if (status != ARC_OK && s) arc_space_discard(shape);
  return status;
}

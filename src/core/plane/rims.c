/* Meshes for partial slip. The surfaces slip in zones at both edges of the contact. These slip
 * zones may be much narrower than the elements that a contact without friction needs. */
#include "core/plane/cycle.h"

#include <math.h>
#include <stdlib.h>

/* Minimum number of elements in a slip zone. With this number the volumes after 10000 cycles are
 * accurate to 1 % if the stick zone ends halfway between two nodes, and to 2 % otherwise. */
static const double in_rim = 5;

/* Largest automatic number of columns in a zone. The slip zones are resolved in a zone that is
 * `contact_widths` times as wide as the contact. */
static const double most_columns = 320, contact_widths = 3;

double arc_wear_least_size(double width) {
  return width / most_columns;
}

/* Results for a cycle of a block. */
typedef struct cycle_of {
  double share; /* amplitude of the tangential force divided by the friction limit; 1 for gross
                   slip */
  double stick; /* stick width of the cycle: the width that never slips [mm] */
} cycle_of;

/* Computes a cycle on the present mesh. The tangential force depends on the stiffness of the
 * bodies and is already accurate on this mesh. If the solution fails, the result is gross slip,
 * and the first step of the run reports the error. */
static cycle_of solve_cycle(arc_wear *w, const wear_block *block, double mu) {
  const wear_window window = {.block = block,
                              .shape = w->shape,
                              .last = block->count - 1,
                              .state = arc_wear_last(w),
                              .mu = mu};
  wear_progress progress = {0};
  arc_error error = {0};
  arc_loop *loop = NULL;
  cycle_of cycle = {.share = 1};
  if (w->kind->loop(w, &window, &progress, &loop, &error) != ARC_OK) return cycle;
  double least = INFINITY, largest = -INFINITY;
  for (size_t i = 0; i < loop->count; i++) {
    least = fmin(least, loop->tangential[i]);
    largest = fmax(largest, loop->tangential[i]);
  }
  if (!loop->gross) cycle.share = fmin(1, (largest - least) / 2 / (mu * block->load));
  cycle.stick = loop->stick_width;
  free(loop);
  return cycle;
}

/* Computes the half widths [mm] of the contact and of its stick zone. For unworn half-planes of
 * the same material, the stick zone is as wide as the contact under the load L - Q / mu, with
 * the load L, the tangential force Q and the coefficient of friction mu. For worn surfaces the
 * stick width is a result of the cycle. */
static void find_rim(const arc_wear *w, const wear_block *block, const cycle_of *cycle,
                     double *contact, double *stick) {
  const arc_model_def *def = arc_model_definition(w->model);
  const arc_wear_record *now = arc_wear_last(w);
  const int worn = now->depth_cylinder > 0 || now->depth_plate > 0;
  *contact = worn ? now->half_width : arc_model_half_width(def, block->load);
  *stick = worn ? fmin(cycle->stick / 2, *contact)
                : arc_model_half_width(def, block->load * (1 - cycle->share));
}

double arc_wear_rim_size(const arc_wear *w) {
  const arc_wear_record *now = arc_wear_last(w);
  if (now->gross != 0 || now->stick_width == 0) return INFINITY;
  return fmax(0, now->half_width - now->stick_width / 2) / in_rim;
}

/* Returns the element size [mm] at which the slip zones of a block's cycle have enough elements.
 * Each node sticks or slips as a whole, so the size is chosen for a stick zone that ends halfway
 * between two nodes. */
static double size_for(arc_wear *w, const wear_block *block, double mu) {
  static const double rounding = 1e-9;
  const arc_mesh_def *mesh = &arc_model_definition(w->model)->mesh;
  const cycle_of cycle = solve_cycle(w, block, mu);
  double a, c;
  if (!(cycle.share > 0 && cycle.share < 1)) return mesh->size;
  find_rim(w, block, &cycle, &a, &c);
  const double fine = (a - c) / in_rim / mesh->fineness;
  const double size = fmin(mesh->size, fmax(arc_wear_least_size(contact_widths * a), fine));
  const double halfway = c / (ceil(c / size - 0.5 - rounding) + 0.5);
  return halfway >= size / 2 ? halfway : size;
}

static double smallest_size(arc_wear *w) {
  double mu, size = arc_model_definition(w->model)->mesh.size;
  arc_error error = {0};
  if (w->def.friction_function) return size;
  if (arc_wear_friction(w, arc_wear_last(w), &mu, &error) != ARC_OK || mu == 0) return size;
  for (int b = 0; b < w->blocks; b++) size = fmin(size, size_for(w, &w->block[b], mu));
  return size;
}

static arc_status build(const arc_wear *w, double size, arc_model **model, arc_shape **shape,
                        arc_error *error) {
  arc_model_def def = *arc_model_definition(w->model);
  double needed[ARC_BODIES];
  def.mesh.size = size;
  def.mesh.height = def.mesh.zone[ARC_CYLINDER] = def.mesh.zone[ARC_PLATE] = 0;
  arc_model_fit(&def, w->def.load);
  arc_wear_zones(&w->def, &def, needed);
  arc_model_fit_zones(&def, needed);
  arc_status status = arc_model_build(&def, model, error);
  if (status == ARC_OK)
    status = arc_shape_create(*model, w->def.geometry, w->def.refresh, shape, error);
  return status == ARC_OK ? arc_shape_remap(w->shape, *shape, error) : status;
}

arc_status arc_wear_resolve(arc_wear *w, arc_wear **finer, arc_error *error) {
  const arc_mesh_def *mesh = &arc_model_definition(w->model)->mesh;
  *finer = NULL;
  if (!arc_wear_has_friction(&w->def) || mesh->fineness == 0 || arc_model_is_given(w->model))
    return ARC_OK;
  const double size = smallest_size(w);
  if (size >= mesh->size) return ARC_OK;
  arc_model *model = NULL;
  arc_shape *shape = NULL;
  arc_status status = build(w, size, &model, &shape, error);
  if (status == ARC_OK) status = arc_wear_create_on(model, &w->def, shape, finer, error);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
  return status;
}

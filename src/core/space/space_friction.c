/* Contact objects with friction: pressing and motions. */
#include "core/base/callbacks.h"
#include "core/elastic/pair.h"
#include "core/space/cerruti.h"
#include "core/space/space_kind.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The rim of slip is a few hundredths of the contact wide at small forces: cells over the half
 * width with which Mindlin's loops are right to 0.4 % from a fifth of full slip on. */
static const double cells_of_friction = 28, usual_cells = 8;

void arc_space_fit_friction(const arc_model_def *def, double load, arc_halfspace_def *cells) {
  arc_model_def fine = *def;
  fine.mesh.fineness =
      (def->mesh.fineness > 0 ? def->mesh.fineness : 1) * (cells_of_friction / usual_cells);
  arc_space_fit(&fine, 0, load, 0, 0, 0, cells);
}

void arc_space_sizes(const space_contact *c, double *shear, double *slip) {
  const arc_halfspace_friction *f = &c->rubbing;
  for (int k = 0, n = space_sites(space_shape_of(c->handle.shape), ARC_UPPER); k < n; k++) {
    shear[k] = hypot(f->q[0][k], f->q[1][k]);
    slip[k] = hypot(f->slip[0][k], f->slip[1][k]);
  }
}

/* --- increments ------------------------------------------------------------------------------- */

/* Solves one increment, on a larger window if necessary. */
static arc_status go_to(space_contact *c, const arc_halfspace_increment *to,
                        const arc_callbacks *callbacks, arc_halfspace_effort *effort,
                        arc_error *error) {
  enum { most_tries = 12 };
  arc_status status = ARC_ZONE;
  c->handle.def.x = to->position.x;
  for (int i = 0; i < most_tries && status == ARC_ZONE; i++) {
    const space_shape *s = space_shape_of(c->handle.shape);
    const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
    const arc_halfspace_options options = {.callbacks = callbacks};
    status = arc_halfspace_slide(s->grid->h, depth, to, &options, &c->rubbing, effort, error);
    if (status != ARC_ZONE) break;
    status = arc_space_widen_contact(c, error);
    if (status != ARC_OK) return status;
    status = ARC_ZONE;
  }
  return status;
}

/* Copies the state to the results of the contact. */
static arc_status read_state(space_contact *c, const arc_halfspace_effort *effort,
                             const arc_callbacks *callbacks, arc_error *error) {
  const arc_halfspace_friction *f = &c->rubbing;
  const size_t n = (size_t)space_sites(space_shape_of(c->handle.shape), ARC_UPPER);
  double on = 0, stuck = 0;
  free(c->pressure);
  c->pressure = malloc(n * sizeof *c->pressure);
  if (!c->pressure) return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
  memcpy(c->pressure, f->pressure, n * sizeof *c->pressure);
  for (size_t k = 0; k < n; k++) {
    on += f->pressure[k] > 0;
    stuck += f->stick[k];
  }
  arc_space_read_result(c, f->approach, effort->sets);
  arc_contact_result *r = &c->handle.result;
  r->tangential = f->force[0];
  r->tangential_z = f->force[1];
  r->energy = f->energy;
  r->z = f->xi[1];
  r->stick = on > 0 ? stuck / on : 0;
  c->handle.def.x = c->origin + f->xi[0];
  if (effort->unfinished > 0)
    arc_warn(callbacks, "pressure and shear did not settle in %d increments: use more increments",
             effort->unfinished);
  return ARC_OK;
}

/* --- pressing --------------------------------------------------------------------------------- */

/* More than one solution may exist beyond this product of friction and Dundurs' beta. */
static void warn_coupling(const space_contact *c, const arc_halfspace_def *d,
                          const arc_callbacks *callbacks) {
  static const double unique = 0.4;
  const double beta = 2 * acos(-1) * fabs(arc_cerruti_unlike(d)) / arc_space_surface_compliance(d);
  if (c->handle.def.friction * beta > unique)
    arc_warn(
        callbacks,
        "friction %g times Dundurs' beta %.2g is above %g: there may be more than one solution",
        c->handle.def.friction, beta, unique);
}

static void warn_coarse(const space_contact *c, const arc_halfspace_def *d,
                        const arc_callbacks *callbacks) {
  static const double fewest = 20;
  const double cells = c->handle.result.half_width / d->size_x;
  if (cells < fewest)
    arc_warn(callbacks,
             "the contact has %.2g cells in its half width: with friction stick zones and energies "
             "may be off by several per cent below %g; use a smaller mesh.size",
             cells, fewest);
}

arc_status arc_space_press(space_contact *c, const arc_callbacks *callbacks, arc_error *error) {
  enum { usual = 20 };
  const arc_contact_def def = c->handle.def;
  const arc_halfspace *h = space_shape_of(c->handle.shape)->grid->h;
  const int wanted = def.increments > 0 ? def.increments : usual;
  const int rubs =
      def.press == ARC_PRESS_FRICTION && arc_cerruti_unlike(arc_halfspace_definition(h)) != 0;
  const int n = rubs ? wanted : 1;
  arc_halfspace_effort effort = {0};
  c->origin = def.x;
  arc_status status = arc_halfspace_friction_begin(h, &c->rubbing, error);
  for (int i = 1; i <= n && status == ARC_OK; i++) {
    const double load = i < n ? def.load * i / n : def.load;
    const arc_halfspace_increment to = {.friction = rubs ? def.friction : 0,
                                        .position = {.x = def.x, .load = load, .weight = 1}};
    status = go_to(c, &to, callbacks, &effort, error);
  }
  if (status == ARC_OK) status = read_state(c, &effort, callbacks, error);
  if (status != ARC_OK) return status;
  if (!rubs) c->handle.result.stick = 1;
  const arc_halfspace_def *d = arc_halfspace_definition(space_shape_of(c->handle.shape)->grid->h);
  warn_coupling(c, d, callbacks);
  warn_coarse(c, d, callbacks);
  return ARC_OK;
}

/* --- motions ---------------------------------------------------------------------------------- */

static double between(double from, double to, double share) {
  return share < 1 ? from + share * (to - from) : to;
}

static arc_status check(const space_contact *c, const arc_motion_def *motion, double load,
                        arc_error *error) {
  const double carried = c->handle.def.friction * load;
  const double x = motion->by_force ? motion->tangential : 0,
               z = motion->by_force_z ? motion->tangential_z : 0;
  if (hypot(x, z) < carried) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%s': expected less than friction times the load, %g N, got %g N",
                  fabs(x) >= fabs(z) ? "tangential" : "tangential_z", carried, hypot(x, z));
}

/* Shapes are read along x only. */
static void warn_across(const space_contact *c, double z, const arc_callbacks *callbacks) {
  const space_shape *s = space_shape_of(c->handle.shape);
  const arc_halfspace *h = s->grid->h;
  const double *recess = arc_halfspace_recess(h, ARC_LOWER);
  double most = 0;
  for (int k = 0; k < space_sites(s, ARC_LOWER); k++)
    most = fmax(most, recess[k] + s->depth[ARC_LOWER][k]);
  if (most > 0 && fabs(z) > arc_halfspace_definition(h)->size_z)
    arc_warn(callbacks,
             "the lower body is not flat and moves %g mm along z: its shape is taken as if it "
             "stayed, which is for motions below a cell of %.3g mm",
             z, arc_halfspace_definition(h)->size_z);
}

arc_status arc_space_rub(space_contact *c, const arc_motion_def *motion,
                         const arc_callbacks *callbacks, arc_error *error) {
  const arc_halfspace_friction *f = &c->rubbing;
  const double load[2] = {c->handle.def.load, motion->load > 0 ? motion->load : c->handle.def.load};
  const double x[2] = {c->handle.def.x, motion->by_force ? c->handle.def.x : motion->x};
  const double xi[2] = {f->xi[0], f->xi[1]}, force[2] = {f->force[0], f->force[1]};
  arc_halfspace_effort effort = {0};
  arc_status status = arc_settings_check(arc_motion_settings, "", motion, error);
  if (status == ARC_OK) status = check(c, motion, load[1], error);
  for (int i = 1; i <= motion->increments && status == ARC_OK; i++) {
    const double share = (double)i / motion->increments;
    arc_halfspace_increment to = {.friction = c->handle.def.friction,
                                  .by_force = {motion->by_force, motion->by_force_z}};
    to.position = (arc_halfspace_position){
        .x = between(x[0], x[1], share), .load = between(load[0], load[1], share), .weight = 1};
    to.xi[0] = to.position.x - c->origin;
    to.xi[1] = between(xi[1], motion->z, share);
    to.force[0] = between(force[0], motion->tangential, share);
    to.force[1] = between(force[1], motion->tangential_z, share);
    c->handle.def.load = to.position.load;
    status = go_to(c, &to, callbacks, &effort, error);
  }
  if (status == ARC_OK) status = read_state(c, &effort, callbacks, error);
  if (status == ARC_OK) warn_across(c, f->xi[1], callbacks);
  return status;
}

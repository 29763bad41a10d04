/* Contacts with friction: cell sizes, pressing the bodies together, and motions. */
#include "core/base/callbacks.h"
#include "core/elastic/pair.h"
#include "core/space/cerruti.h"
#include "core/space/space_kind.h"
#include "core/space/stick_zone.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Default numbers of cells in the half width of a contact, with friction and without. At small
 * forces the slip annulus is only a few hundredths as wide as the contact. With 40 cells Mindlin's
 * loops are accurate to 0.4 % for forces of at least a fifth of the force of full slip. */
static const double cells_of_friction = 40, usual_cells = 8;

/* Makes the cells of a slender contact longer, so that its longer half width has at most four times
 * as many cells as the shorter one. */
static void stretch(const arc_model_def *def, double load, arc_halfspace_def *cells) {
  static const double enough = 4;
  const arc_hertz_ellipse hertz = arc_space_hertz(def, load);
  const double slenderness = hertz.half_width_z / hertz.half_width;
  const double times = fmax(slenderness, 1 / slenderness) / enough;
  if (def->periodic || def->mesh.size > 0 || !(times > 1)) return;
  const int along_z = (slenderness > 1) != cells->turned;
  double *size = along_z ? &cells->size_z : &cells->size_x;
  int *count = along_z ? &cells->nz : &cells->nx;
  *size *= times;
  *count = 2 * arc_space_whole_cells((*count / times - 1) / 2) + 1;
  if (!along_z) cells->track = *count;
}

void arc_space_fit_friction(const arc_model_def *def, double load, arc_halfspace_def *cells) {
  arc_model_def fine = *def;
  fine.mesh.fineness =
      (def->mesh.fineness > 0 ? def->mesh.fineness : 1) * (cells_of_friction / usual_cells);
  arc_space_fit(&fine, 0, load, 0, 0, 0, cells);
  stretch(def, load, cells);
  const arc_halfspace_def bodies =
      arc_space_bodies(def); /* with maps of *def, not of its local copy */
  for (int b = 0; b < ARC_BODIES; b++) cells->body[b] = bodies.body[b];
}

/* --- cells of runs ---------------------------------------------------------------------------- */

/* Returns half of the largest range of the force (if by_force is 1) or of the position in the
 * cycles of a run. `plain` is the amplitude of a run without blocks. */
static double amplitude(const arc_wear_def *d, int by_force, double plain) {
  double most = d->blocks == 0 ? plain : 0;
  for (int b = 0; b < d->blocks; b++) {
    const double *value = by_force ? d->loading[b].tangential : d->loading[b].x;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; value && i < d->loading[b].count; i++) {
      low = fmin(low, value[i]);
      high = fmax(high, value[i]);
    }
    if (high > low) most = fmax(most, (high - low) / 2);
  }
  return most;
}

/* Returns the compliance of the pair to shear in Mindlin's solution [1/MPa]. */
static double compliance_to_shear(const arc_model_def *model) {
  double sum = 0;
  for (int b = 0; b < ARC_BODIES; b++)
    sum += 2 * (2 - model->material[b].nu) * (1 + model->material[b].nu) / model->material[b].E;
  return sum;
}

/* Returns the radius of the stick zone divided by the contact radius, by Mindlin's solution: 1 for
 * full stick, 0 for gross slip. If the friction coefficient varies, returns the value for half the
 * force of full slip. */
static double stick_share(const arc_wear_def *d, const arc_model_def *model) {
  if (!arc_wear_friction_is_known(d) || d->friction == 0) return cbrt(0.5);
  const double force = amplitude(d, 1, d->tangential), carried = d->friction * d->load;
  if (force > 0) return cbrt(fmax(0, 1 - force / carried));
  const arc_hertz_ellipse hertz = arc_space_hertz(model, d->load);
  const double yielding =
      3 * carried * compliance_to_shear(model) / (16 * sqrt(hertz.half_width * hertz.half_width_z));
  return sqrt(fmax(0, 1 - amplitude(d, 0, d->stroke / 2) / yielding));
}

double arc_space_slip_volume(const arc_wear_def *d, const arc_model_def *model) {
  static const double periods = 20; /* wear has ended after this number of periods of 1 / (4 mu k
                                       p_0) cycles (p_0: largest pressure) */
  const double share = stick_share(d, model);
  if (!(share > 0 && share < 1) || d->blocks > 0) return INFINITY;
  const arc_hertz_ellipse hertz = arc_space_hertz(model, d->load);
  const double a = sqrt(hertz.half_width * hertz.half_width_z);
  const double loop = 0.9 * d->load * d->load * compliance_to_shear(model) / a *
                      (1 - pow(share, 5) - 5 * (1 - pow(share, 3)) / 6 * (1 + share * share));
  return periods * loop / (4 * hertz.p_max); /* `loop` is for mu = 1; mu cancels in the volume */
}

double arc_space_slip_cell(const arc_wear_def *def, const arc_model_def *model) {
  /* in_rim, in_stick and in_contact are minimum numbers of cells in the width of the slip annulus,
   * in the radius of the stick zone and in the half width of the contact. A small stick zone, which
   * carries the whole load at the end of wear, may require more cells in the half width, up to
   * for_stick; a narrow annulus, up to `most`. */
  static const double in_rim = 5, in_stick = 10, in_contact = 14, for_stick = 28, most = 64;
  const double finer = model->mesh.fineness > 0 ? model->mesh.fineness : 1;
  const double share = stick_share(def, model);
  if (model->mesh.size > 0 || !(share > 0 && share < 1)) return arc_space_cell(model, def->load);
  const arc_hertz_ellipse hertz = arc_space_hertz(model, def->load);
  const double half = fmin(hertz.half_width, hertz.half_width_z);
  const double for_rim = fmin(most, in_rim / (1 - share));
  const double for_both = fmax(for_rim, fmin(for_stick, in_stick / share));
  const double cells = fmax(in_contact, for_both) * finer;
  return arc_stick_zone_cell(half / cells, share * hertz.half_width, share * hertz.half_width_z,
                             (1 - share) * half);
}

void arc_space_warn_slip(const arc_wear_def *def, const arc_model_def *model, double size,
                         const arc_callbacks *callbacks) {
  static const double fewest = 2.5;
  const double share = arc_wear_has_friction(def) ? stick_share(def, model) : 0;
  if (!(share > 0 && share < 1)) return;
  const arc_hertz_ellipse hertz = arc_space_hertz(model, def->load);
  const double width = (1 - share) * fmin(hertz.half_width, hertz.half_width_z);
  if (width < fewest * size)
    arc_warn(
        callbacks,
        "the slip annulus, %.2g mm wide, has %.2g cells: with fewer than %g, volumes may be off by "
        "several per cent and depths by more; use a smaller mesh.size",
        width, width / size, fewest);
}

void arc_space_sizes(const space_contact *c, double *shear, double *slip) {
  const arc_halfspace_friction *f = &c->rubbing;
  for (int k = 0, n = space_sites(space_shape_of(c->handle.shape), ARC_UPPER); k < n; k++) {
    shear[k] = hypot(f->q[0][k], f->q[1][k]);
    slip[k] = hypot(f->slip[0][k], f->slip[1][k]);
  }
}

/* --- increments ------------------------------------------------------------------------------- */

/* Computes a leg of the motion, in a larger window if necessary. */
static arc_status go_along(space_contact *c, const arc_halfspace_leg *leg,
                           const arc_callbacks *callbacks, arc_halfspace_effort *effort,
                           arc_error *error) {
  enum { most_tries = 12 };
  static const double exact = 1e-8;
  arc_status status = ARC_ZONE;
  for (int i = 0; i < most_tries && status == ARC_ZONE; i++) {
    const space_shape *s = space_shape_of(c->handle.shape);
    const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
    const arc_halfspace_options options = {.tolerance = exact, .callbacks = callbacks};
    *effort = (arc_halfspace_effort){0};
    status = arc_halfspace_follow(s->grid->h, depth, leg, &options, &c->rubbing, &c->coarser,
                                  effort, error);
    if (status != ARC_ZONE) break;
    status = arc_space_widen_contact(c, effort->farthest, error);
    if (status != ARC_OK) return status;
    status = ARC_ZONE;
  }
  return status;
}

/* Warns if the increments were too large to resolve the leg. */
static void warn_unresolved(const space_contact *c, const arc_halfspace_effort *effort,
                            const arc_callbacks *callbacks) {
  if (effort->unfinished > 0)
    arc_warn(callbacks, "pressure and shear did not converge in %d increments: use more increments",
             effort->unfinished);
  if (effort->unresolved > 0)
    arc_warn(callbacks,
             "in %d of %d increments, halving them still changed motion or energy: the energy may "
             "be off by %.2g N mm",
             2 * effort->unresolved, effort->increments, c->handle.result.energy_error);
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
  r->energy_error = fabs(f->energy - c->coarser.energy);
  r->z = f->xi[1];
  r->stick = on > 0 ? stuck / on : 0;
  c->handle.def.x = c->origin + f->xi[0];
  warn_unresolved(c, effort, callbacks);
  return ARC_OK;
}

/* --- pressing --------------------------------------------------------------------------------- */

/* Warns if the product of the friction coefficient and Dundurs' beta is so large that more than one
 * solution may exist. */
static void warn_coupling(const space_contact *c, const arc_halfspace_def *d,
                          const arc_callbacks *callbacks) {
  static const double unique = 0.4;
  const double beta = acos(-1) * fabs(arc_cerruti_unlike(d)) / arc_space_surface_compliance(d);
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
             "the contact has %.2g cells in its half width: with friction and fewer than %g cells, "
             "stick zones and energies may be off by several per cent; use a smaller mesh.size",
             cells, fewest);
}

arc_status arc_space_press(space_contact *c, const arc_callbacks *callbacks, arc_error *error) {
  const arc_contact_def def = c->handle.def;
  const arc_halfspace *h = space_shape_of(c->handle.shape)->grid->h;
  const int rubs =
      def.press == ARC_PRESS_FRICTION && arc_cerruti_unlike(arc_halfspace_definition(h)) != 0;
  const arc_halfspace_leg leg = {.to = {.friction = rubs ? def.friction : 0,
                                        .position = {.x = def.x, .load = def.load, .weight = 1},
                                        .follows = 1},
                                 .increments = rubs ? def.increments : 1};
  arc_halfspace_effort effort = {0};
  c->origin = def.x;
  arc_status status = arc_halfspace_friction_begin(h, &c->rubbing, error);
  if (status == ARC_OK) status = arc_halfspace_friction_begin(h, &c->coarser, error);
  if (status == ARC_OK) status = go_along(c, &leg, callbacks, &effort, error);
  if (status == ARC_OK) status = read_state(c, &effort, callbacks, error);
  if (status != ARC_OK) return status;
  if (!rubs) c->handle.result.stick = 1;
  const arc_halfspace_def *d = arc_halfspace_definition(space_shape_of(c->handle.shape)->grid->h);
  warn_coupling(c, d, callbacks);
  warn_coarse(c, d, callbacks);
  return ARC_OK;
}

/* --- motions ---------------------------------------------------------------------------------- */

/* Returns ARC_ARGUMENT if the contact under the load would have too many cells. */
static arc_status check_cells(const space_contact *c, double load, arc_error *error) {
  static const double most_in_motion = 512;
  const space_shape *s = space_shape_of(c->handle.shape);
  const arc_model_def *model = arc_model_definition(arc_shape_model(c->handle.shape));
  if (model->periodic) return ARC_OK;
  const arc_halfspace_def *d = arc_halfspace_definition(s->grid->h);
  const arc_hertz_ellipse hertz = arc_space_hertz(model, load);
  const double cells = fmax(hertz.half_width / (d->turned ? d->size_z : d->size_x),
                            hertz.half_width_z / (d->turned ? d->size_x : d->size_z));
  if (cells <= most_in_motion) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'load': %g N gives %.3g cells in the half width, expected at most %g: "
                  "create a contact under a load closer to this one, or use a larger mesh.size",
                  load, cells, most_in_motion);
}

static arc_status check(const space_contact *c, const arc_motion_def *motion, double load,
                        arc_error *error) {
  static const double farthest =
      1e6; /* [mm] rounding errors of larger motions would exceed 1e-10 mm */
  const double carried = c->handle.def.friction * load;
  if (!motion->by_force && fabs(motion->x - c->origin) > farthest)
    return arc_fail(error, ARC_ARGUMENT, "field 'x': expected at most %g mm, got %g", farthest,
                    motion->x);
  if (!motion->by_force_z && fabs(motion->z) > farthest)
    return arc_fail(error, ARC_ARGUMENT, "field 'z': expected at most %g mm, got %g", farthest,
                    motion->z);
  const double x = motion->by_force ? motion->tangential : 0,
               z = motion->by_force_z ? motion->tangential_z : 0;
  if (hypot(x, z) < carried) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%s': expected less than friction times the load, %g N, got %g N",
                  fabs(x) >= fabs(z) ? "tangential" : "tangential_z", carried, hypot(x, z));
}

/* Returns ARC_ARGUMENT if the surfaces slide along z on a lower body that is not flat, because its
 * shape is displaced along x only. */
static arc_status check_across(const space_contact *c, arc_error *error) {
  const space_shape *s = space_shape_of(c->handle.shape);
  const arc_halfspace *h = s->grid->h;
  const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
  const double z = c->rubbing.travel[1], size = arc_halfspace_definition(h)->size_z;
  if (fabs(z) <= size || arc_space_is_flat(h, depth, ARC_LOWER)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'z': the lower body is not flat, so surfaces that slide along z are "
                  "expected to slide at most a cell of %.3g mm, got %.3g mm: turn the bodies and "
                  "move along x",
                  size, fabs(z));
}

arc_status arc_space_rub(space_contact *c, const arc_motion_def *motion,
                         const arc_callbacks *callbacks, arc_error *error) {
  const arc_contact_def *def = &c->handle.def;
  const double load = motion->load > 0 ? motion->load : def->load;
  const double x = motion->by_force ? def->x : motion->x;
  const arc_halfspace_leg leg = {.to = {.friction = def->friction,
                                        .position = {.x = c->origin, .load = load, .weight = 1},
                                        .follows = 1,
                                        .by_force = {motion->by_force, motion->by_force_z},
                                        .xi = {x - c->origin, motion->z},
                                        .force = {motion->tangential, motion->tangential_z}},
                                 .load = def->load,
                                 .increments = motion->increments};
  arc_halfspace_effort effort = {0};
  arc_status status = arc_settings_check(arc_motion_settings, "", motion, error);
  if (status == ARC_OK) status = check(c, motion, load, error);
  if (status == ARC_OK) status = check_cells(c, load, error);
  if (status == ARC_OK) status = go_along(c, &leg, callbacks, &effort, error);
  c->handle.def.load = load;
  if (status == ARC_OK) status = check_across(c, error);
  return status == ARC_OK ? read_state(c, &effort, callbacks, error) : status;
}

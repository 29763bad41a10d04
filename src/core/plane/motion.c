/* Contacts with friction: pressing the bodies together and moving them. */
#include "core/base/callbacks.h"
#include "core/plane/solution.h"

#include <math.h>
#include <string.h>

#define ARC_SETTING_OF arc_motion_def
const arc_setting arc_motion_settings[] = {
    ARC_MOTION_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_WHOLE){.name = NULL},
};
#undef ARC_SETTING_OF

static double thickness_of(const arc_contact *c) {
  return arc_model_definition(c->handle.shape->handle.model)->thickness;
}

/* Solves one increment and updates the state of the contact. */
static arc_status go_to(arc_contact *c, double pairing, const friction_step *step,
                        arc_error *error) {
  arc_status status = arc_contact_problem_update(&c->problem, c->handle.shape, pairing, error);
  if (status == ARC_OK)
    status = arc_friction_solve(&c->problem, &c->compliance, &c->workspace, step, &c->state, error);
  c->iterations += c->workspace.iterations;
  c->mu = step->mu;
  return status;
}

/* Presses the bodies together up to the whole load, with or without friction. The result is the
 * initial state of motions with friction. */
arc_status arc_contact_press(arc_contact *c, arc_error *error) {
  const int has_friction = c->handle.def.press == ARC_PRESS_FRICTION;
  const int usual =
      arc_friction_press_increments(c->handle.shape->handle.model, c->handle.def.load);
  const friction_step to = {.mu = has_friction ? c->handle.def.friction : 0,
                            .line = contact_line(c),
                            .x = c->handle.def.x};
  const int wanted = c->handle.def.increments, n = has_friction ? wanted > 0 ? wanted : usual : 1;
  arc_status status = ARC_OK;
  for (int i = 1; i <= n && status == ARC_OK; i++) {
    const friction_step step = arc_friction_pressing(&to, i, n);
    status = go_to(c, c->handle.def.x, &step, error);
  }
  return status;
}

arc_motion_def arc_contact_motion(const arc_contact *c) {
  arc_motion_def motion;
  arc_settings_default(arc_motion_settings, &motion);
  motion.x = c->handle.def.x;
  motion.load = c->handle.def.load;
  motion.z = c->handle.result.z;
  motion.tangential = c->handle.result.tangential;
  motion.tangential_z = c->handle.result.tangential_z;
  motion.by_force = motion.by_force_z = 0;
  return motion;
}

static arc_status check_motion(const arc_contact *from, const arc_motion_def *motion,
                               arc_error *error) {
  const arc_status status = arc_settings_check(arc_motion_settings, "", motion, error);
  if (status != ARC_OK) return status;
  if (motion->z != 0 || motion->by_force_z)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%s': expected none, as a plane model has no motion along z, got %g",
                    motion->by_force_z ? "tangential_z" : "z",
                    motion->by_force_z ? motion->tangential_z : motion->z);
  if (!motion->by_force) return status;
  if (!from->has_friction)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'tangential': expected none, as the contact has no friction "
                    "(contact{ friction = 0.3 } has), got %g N",
                    motion->tangential);
  const double carried = from->handle.def.friction * motion->load;
  if (fabs(motion->tangential) < carried) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'tangential': expected less than friction times the load, %g N, got %g N",
                  carried, motion->tangential);
}

static double between(double from, double to, double share) {
  return share < 1 ? from + share * (to - from) : to;
}

/* Returns the longest motion [mm] in which the pairs of opposite nodes remain unchanged. It is
 * about the elastic displacement of sticking points, and half the length of an increment in wear
 * cycles. */
static double slack_of(const arc_contact *c, double load) {
  static const double share = 1 / 16.0;
  return share * arc_model_half_width(arc_model_definition(c->handle.shape->handle.model), load);
}

/* Computes a motion in increments. The pairs of opposite nodes remain unchanged in short
 * motions, and in motions under a given force, whose displacements are small. In all other
 * motions the pairs follow the plate. */
static arc_status travel(arc_contact *c, const arc_contact *from, const arc_motion_def *motion,
                         const arc_callbacks *callbacks, arc_error *error) {
  const double thickness = thickness_of(c);
  const double moved = motion->by_force ? 0 : motion->x - from->problem.x;
  const int stay = fabs(moved) <= slack_of(from, motion->load);
  arc_status status = ARC_OK;
  for (int i = 1; i <= motion->increments && status == ARC_OK; i++) {
    const double share = (double)i / motion->increments;
    friction_step step = {.mu = c->handle.def.friction, .by_force = motion->by_force};
    step.line = between(from->handle.def.load, motion->load, share) / thickness;
    step.x = between(from->handle.def.x, motion->x, share);
    step.tangential =
        between(from->handle.result.tangential, motion->tangential, share) / thickness;
    status = callbacks_check(callbacks, error);
    if (status == ARC_OK) status = go_to(c, stay ? from->problem.x : step.x, &step, error);
  }
  c->handle.def.x = c->state.x;
  return status;
}

arc_status arc_plane_move(const arc_contact *from, const arc_motion_def *wanted,
                          const arc_callbacks *callbacks, arc_contact **result, arc_error *error) {
  arc_contact_def def = from->handle.def;
  arc_motion_def whole = *wanted, *motion = &whole;
  if (motion->load == 0) motion->load = from->handle.def.load; /* the default is the present load */
  if (motion->increments == 0) motion->increments = 1;
  arc_status status = check_motion(from, motion, error);
  if (status != ARC_OK) return status;
  def.load = motion->load;
  if (!from->has_friction) {
    def.x = motion->x;
    return arc_contact_solve(from->handle.shape, &def, callbacks, result, error);
  }
  status = arc_contact_create(from->handle.shape, &def, result, error);
  if (status == ARC_OK) {
    arc_friction_copy(&(*result)->state, &from->state);
    status = travel(*result, from, motion, callbacks, error);
  }
  return arc_contact_finish(result, status, callbacks, error);
}

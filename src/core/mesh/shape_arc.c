/* Bodies with round surfaces: half cylinders, balls, discs and rings. */
#include "core/mesh/body_shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static double own_radius(const arc_body_def *b) {
  return b->radius;
}

/* --- cylinders: half discs, fixed at the flat side -------------------------------------------- */

static const char *const cylinder_fields[] = {"radius", "hold", NULL};

static body_limits cylinder_limits(const arc_body_def *b) {
  return (body_limits){.zone = 1.6 * b->radius,
                       .zone_text = "1.6 radius",
                       .outer = 0.9 * b->radius,
                       .reach = b->radius};
}

const body_shape arc_body_shape_cylinder = {cylinder_fields,
                                            FORM_CORE,
                                            3.14159265358979323846 / 2,
                                            NULL,
                                            own_radius,
                                            own_radius,
                                            cylinder_limits,
                                            NULL,
                                            NULL,
                                            NULL,
                                            &arc_body_shape_disc};

/* --- balls: half-spaces with two radii, without a mesh ---------------------------------------- */

static const char *const ball_fields[] = {"radius", "radius_z", NULL};

static void resolve_ball(arc_body_def *b, double radius) {
  (void)radius;
  if (b->radius_z == 0) b->radius_z = b->radius;
}

const body_shape arc_body_shape_ball = {ball_fields,
                                        FORM_CORE,
                                        3.14159265358979323846 / 2,
                                        resolve_ball,
                                        own_radius,
                                        own_radius,
                                        cylinder_limits,
                                        NULL,
                                        NULL,
                                        NULL,
                                        NULL};

/* --- whole arcs ------------------------------------------------------------------------------- */

static body_limits whole_limits(double radius) {
  return (body_limits){.zone = 2.8 * radius,
                       .zone_text = "2.8 radius",
                       .outer = 0.9 * (pi * radius),
                       .reach = radius};
}

static body_limits disc_limits(const arc_body_def *b) {
  return whole_limits(b->radius);
}

static const char *const disc_fields[] = {"radius", NULL};

const body_shape arc_body_shape_disc = {disc_fields, FORM_CORE,  3.14159265358979323846,
                                        NULL,        own_radius, own_radius,
                                        disc_limits, NULL,       NULL,
                                        NULL,        NULL};

static const char *const ring_fields[] = {"inner", "outer", "fixed", NULL};

static double ring_radius(const arc_body_def *b) {
  return b->fixed == ARC_RIM_OUTER ? -b->inner : b->outer;
}

static double ring_wall(const arc_body_def *b) {
  return b->outer - b->inner;
}

static body_limits ring_limits(const arc_body_def *b) {
  return whole_limits(fabs(ring_radius(b)));
}

static arc_status check_ring(const arc_body_def *b, const char *path, arc_error *error) {
  if (b->inner > 0 && b->outer > b->inner * 1.02 && isfinite(b->outer)) return ARC_OK;
  if (b->inner > 0 && b->outer == 0)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%souter': expected the outer radius, more than %g mm, got none", path,
                    b->inner * 1.02);
  return arc_fail(
      error, ARC_ARGUMENT,
      "fields '%sinner' and '%souter': expected 0 < inner < outer / 1.02 mm, got %g and "
      "%g",
      path, path, b->inner, b->outer);
}

const body_shape arc_body_shape_ring = {ring_fields, FORM_WALL,   3.14159265358979323846,
                                        NULL,        ring_radius, ring_wall,
                                        ring_limits, NULL,        NULL,
                                        check_ring,  NULL};

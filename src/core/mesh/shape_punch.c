/* Punches: surfaces with a flat between rounded edges. */
#include "core/mesh/body_shape.h"

#include <math.h>

static const char *const fields[] = {"flat", "radius", "height", NULL};

/* Sets the default height and the width. The default height is the radius of the model or, if
 * larger, twice the radius of the punch. */
static void resolve(arc_body_def *b, double radius) {
  if (b->height == 0) b->height = fmax(radius, 2 * b->radius);
  b->width = b->flat + 2 * b->radius;
}

/* Returns the limits of a punch: the flat plus its rounded edges. For each edge, the same multiples
 * of the radius are allowed as for a cylinder. */
static body_limits limits(const arc_body_def *b) {
  return (body_limits){.zone = b->flat + 1.6 * b->radius,
                       .zone_text = "flat + 1.6 radius",
                       .outer = b->flat / 2 + 0.9 * b->radius,
                       .reach = b->flat / 2 + b->radius,
                       .flat = b->flat / 2};
}

static double inset(const arc_body_def *b, double crest, double x) {
  const double beyond = fabs(x) - b->flat / 2;
  (void)crest;
  if (beyond <= 0) return 0;
  if (beyond >= b->radius) return b->radius;
  /* R - sqrt(R^2 - s^2) without cancellation */
  return beyond * beyond / (b->radius + sqrt((b->radius - beyond) * (b->radius + beyond)));
}

static arc_status check(const arc_body_def *b, const char *path, arc_error *error) {
  if (b->flat == 0)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field '%sflat': expected the width of the flat, a number > 0 mm, got none or 0", path);
  if (!(b->flat > 0))
    return arc_fail(error, ARC_ARGUMENT, "field '%sflat': expected a number > 0 mm, got %g", path,
                    b->flat);
  if (b->radius < 0.9 * b->height) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%sheight': expected more than radius / 0.9 = %g mm, got %g", path,
                  b->radius / 0.9, b->height);
}

const body_shape arc_body_shape_punch = {
    fields, FORM_RECTANGLE, 0, resolve, NULL, arc_body_height, limits, NULL, inset, check, NULL};

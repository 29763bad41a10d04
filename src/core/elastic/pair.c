/* Pairs of bodies: their names, and checks of the two shapes against each other. */
#include "core/elastic/pair.h"
#include "core/mesh/body_shape.h"

#include <math.h>
#include <string.h>

arc_body_def arc_model_solid(const arc_model_def *def, arc_body body) {
  arc_body_def own = def->body[body];
  if (def->geometry == ARC_SPATIAL && own.kind == ARC_SOLID_USUAL && body == ARC_UPPER)
    own.kind = ARC_SOLID_BALL;
  return arc_body_resolve(&own, body, def->radius);
}

double arc_model_wear_k(const arc_model_def *def, arc_body body) {
  double k = def->material[body].k;
  for (int l = 0; l < arc_body_layers(&def->body[body]); l++)
    k = fmax(k, def->body[body].layer[l].material.k);
  return k;
}

double arc_contact_mismatch(arc_space space, const arc_material material[ARC_BODIES]) {
  static const double rounding = 1e-9; /* largest value for equal materials */
  double kappa[ARC_BODIES];
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_material m = material[b];
    kappa[b] = space == ARC_PLANE_STRESS ? (1 - m.nu) / m.E : (1 - 2 * m.nu) * (1 + m.nu) / m.E;
  }
  const double beta =
      arc_contact_modulus(space, material) * (kappa[ARC_CYLINDER] - kappa[ARC_PLATE]) / 2;
  return fabs(beta) > rounding ? beta : 0;
}

/* --- names of bodies */

static const char *kind_of(const arc_model_def *def, arc_body body) {
  return arc_solid_names[arc_model_solid(def, body).kind];
}

/* Returns true if the kind of a body can be its name. This is not possible if both bodies have the
 * same kind, or for a lower cylinder, because "cylinder" means the upper body. */
static int is_named_by_kind(const arc_model_def *def, arc_body body) {
  const char *kind = kind_of(def, body);
  if (strcmp(kind, kind_of(def, (arc_body)(1 - body))) == 0) return 0;
  return body == ARC_UPPER || strcmp(kind, arc_body_name(ARC_UPPER)) != 0;
}

static int is_usual_pair(const arc_model_def *def) {
  return arc_model_solid(def, ARC_UPPER).kind == ARC_SOLID_CYLINDER &&
         arc_model_solid(def, ARC_LOWER).kind == ARC_SOLID_BLOCK;
}

const char *arc_model_role_name(arc_body body) {
  return body == ARC_UPPER ? "upper" : "lower";
}

const char *arc_model_body_name(const arc_model_def *def, arc_body body) {
  if (def->body[body].name[0]) return def->body[body].name;
  if (is_usual_pair(def)) return arc_body_name(body);
  return is_named_by_kind(def, body) ? kind_of(def, body) : arc_model_role_name(body);
}

int arc_model_find_body(const arc_model_def *def, const char *word, arc_body *body) {
  int kinds = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    *body = (arc_body)b;
    if (strcmp(word, arc_model_role_name(*body)) == 0) return 1;
    if (def->body[b].name[0] && strcmp(word, def->body[b].name) == 0) return 1;
  }
  for (int b = 0; b < ARC_BODIES; b++)
    if (strcmp(word, kind_of(def, (arc_body)b)) == 0) kinds++, *body = (arc_body)b;
  if (kinds == 1) return is_named_by_kind(def, *body) ? 1 : -1;
  if (kinds > 1) return -1;
  for (int b = 0; b < ARC_BODIES; b++) {
    *body = (arc_body)b;
    if (strcmp(word, arc_body_name(*body)) == 0) return 1;
  }
  return 0;
}

static arc_status check_names(const arc_model_def *def, arc_error *error) {
  const char *name = def->body[ARC_LOWER].name;
  if (!name[0] || strcmp(name, def->body[ARC_UPPER].name) != 0) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'lower.name': expected a name that differs from the upper body's, got \"%s\" for both",
      name);
}

/* --- definition of a pair */

static arc_status check_fit(const arc_body_def *pin, const arc_body_def *hole, arc_error *error) {
  if (!arc_body_is_round(pin) || arc_body_is_hollow(pin))
    return arc_fail(
        error, ARC_ARGUMENT,
        "in a ring held by its outer rim: expected a cylinder, a disc or a ring held by "
        "its inner rim, got a %s",
        arc_solid_names[pin->kind]);
  const double radius = arc_body_radius(pin);
  if (radius < hole->inner && radius >= 0.5 * hole->inner) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'radius': expected less than the hole's radius %g mm and at least half of it, got "
      "%g mm",
      hole->inner, radius);
}

/* --- bodies of revolution --------------------------------------------------------------------- */

/* Returns the half width of a body [mm]. */
static double reach_of(const arc_body_def *b) {
  return arc_body_is_round(b) ? fabs(arc_body_radius(b)) : b->width / 2;
}

/* Checks that a profile is symmetric about its axis of revolution. */
static arc_status check_profile_turns(const arc_body_def *b, const char *path, arc_error *error) {
  const arc_series *y = &b->y_series;
  for (int i = 0; i < y->count; i++) {
    const double x = y->distance[i], there = arc_body_inset(b, 0, -x);
    if (fabs(there + y->value[i]) > 1e-9 * b->height)
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%sy': expected the same height at x and -x for a body of revolution, "
                      "got %g and %g mm at x = %g mm",
                      path, y->value[i], -there, x);
  }
  return ARC_OK;
}

/* Function that checks one of the two bodies of revolution of a pair. */
typedef arc_status turn_check(const arc_model_def *def, const arc_body_def *b, const char *path,
                              arc_error *error);

static arc_status check_no_hole(const arc_model_def *def, const arc_body_def *b, const char *path,
                                arc_error *error) {
  (void)def;
  if (!arc_body_is_hollow(b)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'geometry': expected \"plane strain\" or \"plane stress\" for a hole "
                  "(%skind = \"ring\" held by its outer rim), whose axis is normal to the section",
                  path);
}

static arc_status check_turns(const arc_model_def *def, const arc_body_def *b, const char *path,
                              arc_error *error) {
  const arc_status status = check_no_hole(def, b, path, error);
  if (status != ARC_OK) return status;
  if (def->axis > 0 && reach_of(b) >= def->axis)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'axis': expected 0 or more than %g mm, as the %s extends so far towards "
                    "the axis, got %g mm",
                    reach_of(b), path[0] == 'u' ? "upper body" : "lower body", def->axis);
  if (arc_body_has_points(b) && def->axis == 0) return check_profile_turns(b, path, error);
  return ARC_OK;
}

static arc_status check_space(const arc_model_def *def, arc_error *error) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_body_is_spatial(&def->body[b]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%s': a %s needs geometry = \"3-D\" (a ball is a body.cylinder{} with "
                      "\"axisymmetric\"), got \"%s\"",
                      arc_model_role_name((arc_body)b), arc_solid_names[def->body[b].kind],
                      arc_space_names[def->geometry]);
  if (def->periodic)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'periodic': expected geometry = \"3-D\" beside it, got \"%s\"",
                    arc_space_names[def->geometry]);
  if (def->geometry != ARC_AXISYMMETRIC && def->axis == 0) return ARC_OK;
  if (def->geometry != ARC_AXISYMMETRIC)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'axis': expected geometry = \"axisymmetric\" beside it, got \"%s\"",
                    arc_space_names[def->geometry]);
  if (def->thickness == 1) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'thickness': bodies of revolution have no thickness, got %g mm",
                  def->thickness);
}

/* Checks each body and the names of both. */
static arc_status check_each(const arc_model_def *def, const arc_body_def solid[ARC_BODIES],
                             arc_error *error) {
  arc_status status = arc_body_check(&solid[ARC_UPPER], "upper.", error);
  if (status == ARC_OK) status = arc_body_check(&solid[ARC_LOWER], "lower.", error);
  if (status == ARC_OK) status = check_names(def, error);
  return status == ARC_OK ? check_space(def, error) : status;
}

static arc_status check_holes(const arc_body_def solid[ARC_BODIES], arc_error *error) {
  for (int b = ARC_BODIES - 1; b >= 0; b--)
    if (arc_body_is_hollow(&solid[b])) return check_fit(&solid[1 - b], &solid[b], error);
  return ARC_OK;
}

static arc_status check_pair(const arc_model_def *def, turn_check *check, arc_error *error) {
  static const char *const path[] = {"upper.", "lower."};
  const arc_body_def solid[] = {arc_model_solid(def, ARC_UPPER), arc_model_solid(def, ARC_LOWER)};
  arc_status status = check_each(def, solid, error);
  if (status == ARC_OK && def->geometry != ARC_AXISYMMETRIC) return check_holes(solid, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = check(def, &solid[b], path[b], error);
  return status;
}

arc_status arc_model_check_pair(const arc_model_def *def, arc_error *error) {
  return check_pair(def, check_turns, error);
}

arc_status arc_model_check_given_pair(const arc_model_def *def, arc_error *error) {
  return check_pair(def, check_no_hole, error);
}

double arc_model_relative_radius(const arc_model_def *def) {
  const arc_body_def upper = arc_model_solid(def, ARC_UPPER),
                     lower = arc_model_solid(def, ARC_LOWER);
  const double ru = arc_body_radius(&upper), rl = arc_body_radius(&lower);
  if (isinf(ru)) return rl;
  if (isinf(rl)) return ru;
  return 1 / (1 / ru + 1 / rl);
}

int arc_model_is_hertzian(const arc_model_def *def) {
  const arc_body_def upper = arc_model_solid(def, ARC_UPPER),
                     lower = arc_model_solid(def, ARC_LOWER);
  if (def->geometry == ARC_AXISYMMETRIC && def->axis > 0)
    return 0; /* the contact of a ring is a circle */
  return arc_body_is_core(&upper) && arc_body_is_flat(&lower) && arc_body_layers(&upper) == 0 &&
         arc_body_layers(&lower) == 0;
}

double arc_model_width(const arc_model_def *def) {
  const arc_body_def lower = arc_model_solid(def, ARC_LOWER);
  return 2 * arc_body_half_length(&lower);
}

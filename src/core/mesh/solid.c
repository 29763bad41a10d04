/* Shapes of bodies in numbers. */
#include "archard/body.h"
#include "core/mesh/build.h"

#include <math.h>
#include <stdio.h>

static const double pi = 3.14159265358979323846;

const char *const arc_solid_names[] = {ARC_SOLID_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_rim_names[] = {ARC_RIM_LIST(ARC_CHOICE_NAME) NULL};
_Static_assert(0 ARC_SOLID_LIST(ARC_CHOICE_ONE) == 8,
               "a new body: decide it in mesh/solid.c and mesh/map.c");

#define ARC_SETTING_OF arc_layer
const arc_setting arc_layer_settings[] = {
    ARC_LAYER_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_TEXT)
        ARC_MATERIAL_SETTING(offsetof(arc_layer, material), "material", "Material of the layer."),
    {.name = NULL},
};
#undef ARC_SETTING_OF

#define LAYER(number)                                                                              \
  {                                                                                                \
    .name = "layer" #number, .unit = "", .kind = ARC_GROUP, .group = arc_layer_settings,           \
    .offset = offsetof(arc_body_def, layer) + ((number)-1) * sizeof(arc_layer),                    \
    .type = "a table { thickness=, material= }",                                                   \
    .text = "Layer " #number ", counted from the surface."                                         \
  }

#define ARC_SETTING_OF arc_body_def
const arc_setting arc_body_settings[] = {
    ARC_BODY_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_CHOICE,
                      ARC_SETTING_TEXT){.name = "y",
                                        .unit = "mm",
                                        .kind = ARC_NUMBER,
                                        .forms = ARC_SERIES | ARC_OPTIONAL,
                                        .offset = offsetof(arc_body_def, y),
                                        .series = offsetof(arc_body_def, y_series),
                                        ARC_RANGE_ANY,
                                        .text = "Heights of a profile over x, out of the body."},
    LAYER(1),
    LAYER(2),
    LAYER(3),
    LAYER(4),
    {.name = NULL},
};
#undef ARC_SETTING_OF

arc_body_def arc_body_resolve(const arc_body_def *def, arc_body role, double radius) {
  arc_body_def b = *def;
  const int usual = b.kind == ARC_SOLID_USUAL || b.kind == ARC_SOLID_GMSH;
  if (usual) b.kind = role == ARC_UPPER ? ARC_SOLID_CYLINDER : ARC_SOLID_BLOCK;
  if (b.radius == 0) b.radius = radius;
  if (b.kind == ARC_SOLID_PUNCH) b.width = b.flat + 2 * b.radius;
  if (b.width == 0) b.width = 2 * radius;
  if (b.height == 0) b.height = radius;
  return b;
}

int arc_body_is_round(const arc_body_def *b) {
  return b->kind == ARC_SOLID_CYLINDER || b->kind == ARC_SOLID_DISC || b->kind == ARC_SOLID_RING;
}

int arc_body_is_hollow(const arc_body_def *b) {
  return b->kind == ARC_SOLID_RING && b->fixed == ARC_RIM_OUTER;
}

double arc_body_radius(const arc_body_def *b) {
  if (!arc_body_is_round(b)) return INFINITY;
  if (b->kind != ARC_SOLID_RING) return b->radius;
  return arc_body_is_hollow(b) ? -b->inner : b->outer;
}

double arc_body_half_length(const arc_body_def *b) {
  if (!arc_body_is_round(b)) return b->width / 2;
  return pi * fabs(arc_body_radius(b)) / (b->kind == ARC_SOLID_CYLINDER ? 2 : 1);
}

double arc_body_depth(const arc_body_def *b) {
  if (!arc_body_is_round(b)) return b->height;
  return b->kind == ARC_SOLID_RING ? b->outer - b->inner : b->radius;
}

double arc_body_measure(const arc_body_def *b) {
  return arc_body_is_round(b) ? arc_body_depth(b) : fmin(b->width / 2, b->height);
}

/* Over the flat of a punch, and as far into its edges as into a cylinder. */
double arc_body_widest_zone(const arc_body_def *b) {
  if (b->kind == ARC_SOLID_DISC || b->kind == ARC_SOLID_RING) return 2.8 * fabs(arc_body_radius(b));
  if (b->kind == ARC_SOLID_PUNCH) return b->flat + 1.6 * b->radius;
  return b->kind == ARC_SOLID_CYLINDER ? 1.6 * b->radius : 0.8 * b->width;
}

static double punch_inset(const arc_body_def *b, double x) {
  const double beyond = fabs(x) - b->flat / 2;
  if (beyond <= 0) return 0;
  if (beyond >= b->radius) return b->radius;
  /* R - sqrt(R^2 - s^2), written so that nothing cancels */
  return beyond * beyond / (b->radius + sqrt((b->radius - beyond) * (b->radius + beyond)));
}

static double height_at(const arc_series *y, double x) {
  int low = 0, high = y->count - 1;
  if (x <= y->distance[0]) return y->value[0];
  if (x >= y->distance[high]) return y->value[high];
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    if (y->distance[middle] <= x)
      low = middle;
    else
      high = middle;
  }
  const double share = (x - y->distance[low]) / (y->distance[high] - y->distance[low]);
  return y->value[low] + share * (y->value[high] - y->value[low]);
}

static double highest(const arc_series *y) {
  double most = y->value[0];
  for (int i = 1; i < y->count; i++) most = fmax(most, y->value[i]);
  return most;
}

double arc_body_crest(const arc_body_def *b) {
  return b->kind == ARC_SOLID_PROFILE ? highest(&b->y_series) : 0;
}

double arc_body_inset(const arc_body_def *b, double crest, double x) {
  if (b->kind == ARC_SOLID_PUNCH) return punch_inset(b, x);
  if (b->kind != ARC_SOLID_PROFILE) return 0;
  return crest - height_at(&b->y_series, x);
}

int arc_body_layers(const arc_body_def *b) {
  int count = 0;
  while (count < ARC_MOST_LAYERS && (b->layer[count].thickness > 0 || b->layer[count].name[0]))
    count++;
  return count;
}

arc_material arc_body_layer_material(const arc_body_def *b, int layer, arc_material own) {
  return layer < arc_body_layers(b) ? b->layer[layer].material : own;
}

double arc_body_interface(const arc_body_def *b, int layer) {
  double depth = 0;
  for (int l = 0; l <= layer; l++) depth += b->layer[l].thickness;
  return depth;
}

/* --- what cannot be --------------------------------------------------------------------------- */

static arc_status check_ring(const arc_body_def *b, const char *path, arc_error *error) {
  if (b->inner > 0 && b->outer > b->inner * 1.02 && isfinite(b->outer)) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "fields '%sinner' and '%souter': expected 0 < inner < outer / 1.02 mm, got %g and "
      "%g",
      path, path, b->inner, b->outer);
}

static arc_status check_punch(const arc_body_def *b, const char *path, arc_error *error) {
  if (!(b->flat > 0))
    return arc_fail(error, ARC_ARGUMENT, "field '%sflat': expected a number > 0 mm, got %g", path,
                    b->flat);
  if (b->radius < 0.9 * b->height) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%sheight': expected more than radius / 0.9 = %g mm, got %g", path,
                  b->radius / 0.9, b->height);
}

static arc_status check_profile(const arc_body_def *b, const char *path, arc_error *error) {
  const arc_series *y = &b->y_series;
  if (y->count < 2)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%sy': expected a function of x or heights at two places or more, got "
                    "%d",
                    path, y->count);
  double least = y->value[0];
  for (int i = 0; i < y->count; i++) {
    if (!isfinite(y->value[i]) || !isfinite(y->distance[i]))
      return arc_fail(error, ARC_ARGUMENT, "field '%sy': expected finite numbers, got %g at x = %g",
                      path, y->value[i], y->distance[i]);
    if (i > 0 && !(y->distance[i] > y->distance[i - 1]))
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%sx': expected increasing numbers, got %g after %g", path,
                      y->distance[i], y->distance[i - 1]);
    least = fmin(least, y->value[i]);
  }
  if (highest(y) - least < 0.5 * b->height) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field '%sy': expected heights within half of the body's height %g mm, got a range "
      "of %g",
      path, b->height, highest(y) - least);
}

static arc_status check_layers(const arc_body_def *b, const char *path, arc_error *error) {
  const int layers = arc_body_layers(b);
  if (layers == 0 || arc_body_interface(b, layers - 1) < 0.9 * arc_body_measure(b)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%slayers': expected less than 0.9 of the body's %g mm in all, got %g mm",
                  path, arc_body_measure(b), arc_body_interface(b, layers - 1));
}

arc_status arc_body_check(const arc_body_def *b, const char *path, arc_error *error) {
  arc_status status = arc_body_check_name(b, path, error);
  if (status != ARC_OK) return status;
  if (b->kind == ARC_SOLID_RING) status = check_ring(b, path, error);
  if (b->kind == ARC_SOLID_PUNCH) status = check_punch(b, path, error);
  if (b->kind == ARC_SOLID_PROFILE) status = check_profile(b, path, error);
  return status == ARC_OK ? check_layers(b, path, error) : status;
}

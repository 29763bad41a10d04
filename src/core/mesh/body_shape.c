/* Computes dimensions of bodies by the functions of their kinds. Also defines the kind "block"
 * and layers. */
#include "core/mesh/body_shape.h"
#include "core/mesh/body_name.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const arc_solid_names[] = {ARC_SOLID_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_rim_names[] = {ARC_RIM_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_hold_names[] = {ARC_HOLD_LIST(ARC_CHOICE_NAME) NULL};

#define SHAPE(name, word, shape) &arc_body_shape_##shape,
static const body_shape *const shapes[] = {ARC_SOLID_LIST(SHAPE)};

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

#define AXIS(axis)                                                                                 \
  {                                                                                                \
    .name = #axis, .unit = "mm", .kind = ARC_NUMBER, .forms = ARC_SERIES | ARC_OPTIONAL,           \
    .offset = offsetof(arc_body_def, axis), .series = offsetof(arc_body_def, axis##_series),       \
    ARC_RANGE_ANY, .text = "Positions of the points of a map along " #axis "."                     \
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
                                        .text = "Heights of a profile at the positions x, "
                                                "positive out of the body."},
    AXIS(x),
    AXIS(z),
    LAYER(1),
    LAYER(2),
    LAYER(3),
    LAYER(4),
    {.name = NULL},
};
#undef ARC_SETTING_OF

/* --- by kind ---------------------------------------------------------------------------------- */

const body_shape *arc_body_shape_of(const arc_body_def *b) {
  const body_shape *shape = shapes[b->kind];
  return b->hold == ARC_HOLD_HUB && shape->with_hub ? shape->with_hub : shape;
}

const char *const *arc_body_fields(arc_solid kind) {
  return shapes[kind]->fields;
}

arc_body_def arc_body_resolve(const arc_body_def *def, arc_body role, double radius) {
  arc_body_def b = *def;
  const int usual = b.kind == ARC_SOLID_USUAL || b.kind == ARC_SOLID_GMSH;
  if (usual) b.kind = role == ARC_UPPER ? ARC_SOLID_CYLINDER : ARC_SOLID_BLOCK;
  const body_shape *shape = arc_body_shape_of(&b);
  if (b.radius == 0 && shape->form != FORM_MAP) b.radius = radius;
  if (shape->resolve) shape->resolve(&b, radius);
  if (b.width == 0) b.width = 2 * radius;
  if (b.height == 0) b.height = radius;
  return b;
}

int arc_body_is_round(const arc_body_def *b) {
  return arc_body_shape_of(b)->radius != NULL;
}

int arc_body_is_hollow(const arc_body_def *b) {
  return signbit(arc_body_radius(b)) != 0;
}

int arc_body_is_spatial(const arc_body_def *b) {
  for (const char *const *own = arc_body_fields(b->kind); *own; own++)
    if (strcmp(*own, "radius_z") == 0) return 1;
  return 0;
}

arc_status arc_body_keep_series(arc_body_def *b, double **block) {
  arc_series *const series[] = {&b->y_series, &b->x_series, &b->z_series};
  enum { COUNT = sizeof series / sizeof *series };
  size_t all = 0;
  for (int k = 0; k < COUNT; k++) all += 2 * (size_t)series[k]->count;
  double *to = *block = all > 0 ? malloc(all * sizeof *to) : NULL;
  for (int k = 0; k < COUNT; k++) {
    const size_t n = to ? (size_t)series[k]->count : 0;
    const arc_series kept = {(int)n, to, to ? to + n : NULL};
    if (n > 0) memcpy(to, series[k]->distance, n * sizeof *to);
    if (n > 0) memcpy(to + n, series[k]->value, n * sizeof *to);
    *series[k] = kept;
    if (to) to += 2 * n;
  }
  return all == 0 || *block ? ARC_OK : ARC_MEMORY;
}

int arc_body_is_map(const arc_body_def *b) {
  return arc_body_shape_of(b)->form == FORM_MAP;
}

int arc_body_is_core(const arc_body_def *b) {
  return arc_body_shape_of(b)->form == FORM_CORE;
}

int arc_body_holds_sideways(const arc_body_def *b, double x) {
  return b->hold != ARC_HOLD_FREE || fabs(x) <= 0.15 * b->radius;
}

int arc_body_is_closed(const arc_body_def *b) {
  return arc_body_shape_of(b)->turn > 3;
}

int arc_body_is_flat(const arc_body_def *b) {
  const body_shape *shape = arc_body_shape_of(b);
  return !shape->radius && !shape->inset;
}

int arc_body_has_points(const arc_body_def *b) {
  return arc_body_shape_of(b)->form == FORM_POINTS;
}

double arc_body_radius(const arc_body_def *b) {
  return arc_body_is_round(b) ? arc_body_shape_of(b)->radius(b) : INFINITY;
}

double arc_body_half_length(const arc_body_def *b) {
  if (!arc_body_is_round(b)) return b->width / 2;
  return arc_body_shape_of(b)->turn * fabs(arc_body_radius(b));
}

double arc_body_depth(const arc_body_def *b) {
  return arc_body_shape_of(b)->depth(b);
}

double arc_body_measure(const arc_body_def *b) {
  return arc_body_is_round(b) ? arc_body_depth(b) : fmin(b->width / 2, b->height);
}

body_limits arc_body_limits(const arc_body_def *b) {
  return arc_body_shape_of(b)->limits(b);
}

double arc_body_widest_zone(const arc_body_def *b) {
  return arc_body_limits(b).zone;
}

double arc_body_crest(const arc_body_def *b) {
  const body_shape *shape = arc_body_shape_of(b);
  return shape->crest ? shape->crest(b) : 0;
}

double arc_body_inset(const arc_body_def *b, double crest, double x) {
  const body_shape *shape = arc_body_shape_of(b);
  return shape->inset ? shape->inset(b, crest, x) : 0;
}

/* --- blocks ----------------------------------------------------------------------------------- */

double arc_body_height(const arc_body_def *b) {
  return b->height;
}

body_limits arc_body_limits_of_width(const arc_body_def *b) {
  return (body_limits){.zone = 0.8 * b->width,
                       .zone_text = b->width == 2 * b->radius ? "1.6 radius" : "0.8 of the width",
                       .outer = 0.9 * (b->width / 2),
                       .reach = 0.4 * b->width};
}

static const char *const block_fields[] = {"width", "height", NULL}, *const no_fields[] = {NULL};

#define RECTANGLE(fields)                                                                          \
  {                                                                                                \
    fields, FORM_RECTANGLE, 0, NULL, NULL, arc_body_height, arc_body_limits_of_width, NULL, NULL,  \
        NULL, NULL                                                                                 \
  }
const body_shape arc_body_shape_block = RECTANGLE(block_fields);
/* Placeholders: arc_body_resolve replaces these kinds by other kinds. */
const body_shape arc_body_shape_usual = RECTANGLE(no_fields);
const body_shape arc_body_shape_gmsh = RECTANGLE(no_fields);

/* --- layers ----------------------------------------------------------------------------------- */

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

/* --- validation ------------------------------------------------------------------------------- */

static arc_status check_layers(const arc_body_def *b, const char *path, arc_error *error) {
  const int layers = arc_body_layers(b);
  if (layers == 0 || arc_body_interface(b, layers - 1) < 0.9 * arc_body_measure(b)) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field '%slayers': expected less than 0.9 of the body's %g mm in total, got %g mm", path,
      arc_body_measure(b), arc_body_interface(b, layers - 1));
}

arc_status arc_body_check(const arc_body_def *b, const char *path, arc_error *error) {
  arc_status status = arc_body_check_name(b, path, error);
  if (status != ARC_OK) return status;
  const body_shape *shape = arc_body_shape_of(b);
  if (shape->check) status = shape->check(b, path, error);
  return status == ARC_OK ? check_layers(b, path, error) : status;
}

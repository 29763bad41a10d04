/* Describes a pair of bodies as text, for printed models, contacts and runs. */
#include "lua/engine/pair_text.h"
#include "lua/engine/classes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Line break and indentation for a line below a label in the text of a run. */
static const char *const indent = "\n            ";

/* Adds a text such as "E 200000 MPa nu 0.3". If the wear coefficient is above 0, also adds the text
 * `before` and the coefficient. */
static void add_material(luaL_Buffer *to, arc_material material, const char *before) {
  char text[100];
  snprintf(text, sizeof text, "%.31s%sE %.6g MPa nu %.6g", material.name,
           material.name[0] ? ", " : "", material.E, material.nu);
  luaL_addstring(to, text);
  if (!(material.k > 0)) return;
  luaL_addstring(to, before);
  snprintf(text, sizeof text, "k %.6g mm2/N = %.6g mm3/(N m)", material.k, 1e3 * material.k);
  luaL_addstring(to, text);
}

/* Writes a body, such as "roller (cylinder of radius 5 mm)". */
static void show_body(const arc_model_def *model, arc_body body, char *text, size_t size) {
  const arc_body_def solid = arc_model_solid(model, body);
  const double radius = fabs(arc_body_radius(&solid));
  const char *name = model->body[body].name, *kind = arc_solid_names[solid.kind];
  char shape[90];
  if (solid.radius_z > 0 && solid.radius_z != solid.radius)
    snprintf(shape, sizeof shape, "%s of radii %.6g mm and %.6g mm along z", kind, radius,
             solid.radius_z);
  else
    snprintf(shape, sizeof shape, isfinite(radius) ? "%s of radius %.6g mm" : "%s", kind, radius);
  snprintf(text, size, name[0] ? "%.31s (%s)" : "%.31s%s", name, shape);
}

static int is_usual(const arc_model_def *model) {
  return model->body[ARC_UPPER].kind == ARC_SOLID_USUAL &&
         model->body[ARC_LOWER].kind == ARC_SOLID_USUAL;
}

const char *pair_show(const arc_model_def *model, char *text, size_t size) {
  char part[ARC_BODIES][140];
  snprintf(text, size, "radius %.6g mm", model->radius);
  if (is_usual(model)) return text;
  for (int b = 0; b < ARC_BODIES; b++) show_body(model, (arc_body)b, part[b], sizeof part[b]);
  snprintf(text, size, "%s on %s", part[ARC_UPPER], part[ARC_LOWER]);
  return text;
}

static int are_alike(const arc_material *of) {
  return of[0].E == of[1].E && of[0].nu == of[1].nu && of[0].k == of[1].k &&
         strcmp(of[0].name, of[1].name) == 0;
}

void pair_add_materials(luaL_Buffer *text, const arc_model_def *model) {
  const arc_material *of = model->material;
  const int alike = are_alike(of);
  const int is_long =
      of[ARC_UPPER].k > 0 || of[ARC_LOWER].k > 0 || of[ARC_UPPER].name[0] || of[ARC_LOWER].name[0];
  luaL_addstring(text, "  materials ");
  for (int b = 0; b < (alike ? 1 : ARC_BODIES); b++) {
    if (b > 0) luaL_addstring(text, is_long ? indent : ", ");
    luaL_addstring(text, alike ? "both" : body_name(model, (arc_body)b));
    luaL_addchar(text, ' ');
    add_material(text, of[b], indent);
  }
  luaL_addchar(text, '\n');
}

static void add_layer(luaL_Buffer *text, const arc_layer *layer, const char *before_k) {
  char line[80];
  snprintf(line, sizeof line, "%.31s%s%.6g mm of ", layer->name, layer->name[0] ? ", " : "",
           layer->thickness);
  luaL_addstring(text, line);
  add_material(text, layer->material, before_k);
}

void pair_add_layers(luaL_Buffer *text, const arc_model_def *model, arc_body body,
                     const char *before) {
  const arc_body_def *def = &model->body[body];
  for (int l = 0; l < arc_body_layers(def); l++) {
    luaL_addstring(text, before);
    add_layer(text, &def->layer[l], " ");
  }
}

void pair_add_body(luaL_Buffer *text, const arc_model_def *model, arc_body body) {
  char shape[110];
  show_body(model, body, shape, sizeof shape);
  luaL_addstring(text, shape);
  luaL_addstring(text, ": ");
  add_material(text, model->material[body], " ");
  pair_add_layers(text, model, body, "\n  ");
}

int pair_has_layers(const arc_model_def *model) {
  return arc_body_layers(&model->body[ARC_UPPER]) + arc_body_layers(&model->body[ARC_LOWER]) > 0;
}

static const double rounding = 1e-6; /* a run that ends at the bottom of a layer is through it */

void pair_add_all_layers(luaL_Buffer *text, const arc_model_def *model,
                         const double depth[ARC_BODIES]) {
  const char *before = "  layers    ";
  for (int b = 0; b < ARC_BODIES; b++) {
    double bottom = 0; /* [mm] */
    for (int l = 0; l < arc_body_layers(&model->body[b]); l++) {
      bottom += model->body[b].layer[l].thickness;
      luaL_addstring(text, before);
      luaL_addstring(text, body_name(model, (arc_body)b));
      luaL_addchar(text, ' ');
      add_layer(text, &model->body[b].layer[l], indent);
      if (depth[b] >= bottom * (1 - rounding)) luaL_addstring(text, ", worn through");
      before = indent;
    }
  }
  if (pair_has_layers(model)) luaL_addchar(text, '\n');
}

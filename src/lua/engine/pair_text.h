/* Describes the two bodies of a model as text. */
#ifndef LUA_PAIR_TEXT_H
#define LUA_PAIR_TEXT_H

#include "archard/model.h"

#include <lauxlib.h>

/* Writes a text such as "radius 10 mm" for the default bodies, or "pin (disc of radius 9.95 mm) on
 * block" for other bodies. */
const char *pair_show(const arc_model_def *model, char *text, size_t size);

/* Adds a line such as "  materials both E 200000 MPa nu 0.3", with the wear coefficients if they
 * are set. */
void pair_add_materials(luaL_Buffer *text, const arc_model_def *model);

/* For each layer of a body, from the surface inwards, adds the text `before` and a text such as
 * "0.003 mm of E 400000 MPa nu 0.3 k 1e-10 mm2/N = 1e-07 mm3/(N m)". */
void pair_add_layers(luaL_Buffer *text, const arc_model_def *model, arc_body body,
                     const char *before);

/* Adds a line such as "roller (cylinder of radius 5 mm): E 200000 MPa nu 0.3", and one line for
 * each layer. */
void pair_add_body(luaL_Buffer *text, const arc_model_def *model, arc_body body);

/* Adds lines for the layers of both bodies, if there are any. Layers that are thinner than the wear
 * depth of their body [mm] are marked as worn through. */
void pair_add_all_layers(luaL_Buffer *text, const arc_model_def *model,
                         const double depth[ARC_BODIES]);
int pair_has_layers(const arc_model_def *model);

#endif

/* A pair of bodies in words. */
#ifndef LUA_PAIR_TEXT_H
#define LUA_PAIR_TEXT_H

#include "archard/model.h"

#include <lauxlib.h>

/* "radius 10 mm" of the usual pair, "pin (disc of radius 9.95 mm) on block" of others. */
const char *pair_show(const arc_model_def *model, char *text, size_t size);

/* A line "  materials both E 200000 MPa nu 0.3", with wear coefficients that the bodies have. */
void pair_add_materials(luaL_Buffer *text, const arc_model_def *model);

/* The layers of a body from the surface inwards, "0.003 mm of E 400000 MPa nu 0.3 k 1e-10 mm2/N =
 * 1e-07 mm3/(N m)", with `before` before each; nothing where there are none. */
void pair_add_layers(luaL_Buffer *text, const arc_model_def *model, arc_body body,
                     const char *before);

/* Lines of both bodies' layers, where there are any. */
void pair_add_all_layers(luaL_Buffer *text, const arc_model_def *model);
int pair_has_layers(const arc_model_def *model);

#endif

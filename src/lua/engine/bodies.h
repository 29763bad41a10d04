/* Bodies as scripts give them. */
#ifndef LUA_BODIES_H
#define LUA_BODIES_H

#include "archard/model.h"
#include "lua/base/args.h"

/* Reads the fields `upper` and `lower` of the definition table at `index` over the bodies and
 * materials of a model whose radius is known. Profiles live as long as the tables they are given
 * in. */
void body_read(lua_State *L, int index, args_place place, arc_model_def *def);

/* Reads kinds and names alone, as far as they are ones: for who comes before the model. */
void body_read_names(lua_State *L, int index, arc_model_def *def);

/* Pushes a body of a model as body_read takes it, or nil where it is the usual one. */
void body_push(lua_State *L, const arc_model_def *def, arc_body body);

#endif

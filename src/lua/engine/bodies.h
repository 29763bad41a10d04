/* Reads the bodies of a model definition from Lua tables, and pushes them as tables. */
#ifndef LUA_BODIES_H
#define LUA_BODIES_H

#include "archard/model.h"
#include "lua/base/args.h"

/* Reads the fields `upper` and `lower` of the definition table at `index` into the bodies and
 * materials of `def`. The radius of `def` must be set before. The data of profiles in `def` are
 * valid until the calling C function returns. */
void body_read(lua_State *L, int index, args_location location, arc_model_def *def);

/* Reads only what decides the names of the bodies: their kinds and names, and whether the model is
 * three-dimensional. Raises no errors. The function is used before the model is built. */
void body_read_names(lua_State *L, int index, arc_model_def *def);

/* Pushes a body of a model as a table for body_read, or nil for the default body. */
void body_push(lua_State *L, const arc_model_def *def, arc_body body);

#endif

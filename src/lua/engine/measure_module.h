/* lua/engine/measure_module.h - pushes quantities of two wear profiles as Lua tables. */
#ifndef LUA_MEASURE_MODULE_H
#define LUA_MEASURE_MODULE_H

#include "archard/measure.h"

#include <lua.h>

/* measure_push_combined pushes { x=, h= }, the sum of both depths (Eq. 31 of Mattei and Di Puccio).
 * measure_push_partition pushes { x=, value= }, the cylinder's share of the sum (Eq. 30). Both
 * tables have values at points of the plate. Temporary buffers stay below the table on the stack.
 * The functions return 1. */
int measure_push_combined(lua_State *L, arc_depths cylinder, arc_depths plate);
int measure_push_partition(lua_State *L, arc_depths cylinder, arc_depths plate);

#endif

/* Heights of bodies by points: profiles over x, maps over x and z. */
#ifndef LUA_BODY_POINTS_H
#define LUA_BODY_POINTS_H

#include "archard/model.h"
#include "lua/base/args.h"

/* Reads field `y` of the body at `index`, a function of x or a list beside `x` [mm], as the series
 * of a profile; functions are sampled over the body's width, or over two radii [mm]. The points
 * live as long as the call. Errors name the field. */
void body_read_profile(lua_State *L, int index, args_place place, double radius, arc_body_def *def);

/* Reads the fields x, z and y of the body at `index` [mm] as the series of a map, likewise. */
void body_read_map(lua_State *L, int index, args_place place, arc_body_def *def);

/* Whether the value at `index` is a map, as map{} makes one. */
int body_is_map(lua_State *L, int index);

/* Sets x, z and y of the table at index 2 from the value at index 1: a map, a table with one in its
 * field y, or the fields of one. Refuses heights in other units than mm. */
void body_take_map(lua_State *L, args_place place);

#endif

/* Reads surfaces of bodies that are given by points: profiles over x, and maps over x and z. */
#ifndef LUA_BODY_POINTS_H
#define LUA_BODY_POINTS_H

#include "archard/model.h"
#include "lua/base/args.h"

/* Reads field `y` of the body at `index` as the series of a profile [mm]. The field is a function
 * of x, or a list of heights at the positions in the list `x`. A function is sampled over the
 * body's width, or over the length 2 * `radius` if the width is 0. The points are valid until the
 * calling C function returns. Errors name the field. */
void body_read_profile(lua_State *L, int index, args_location location, double radius,
                       arc_body_def *def);

/* Reads the fields x, z and y of the body at `index` as the series of a map [mm]. The series are
 * valid until the calling C function returns. */
void body_read_map(lua_State *L, int index, args_location location, arc_body_def *def);

/* Returns true if the value at `index` is an object of the class ("profile" or "map"). */
int body_is(lua_State *L, int index, const char *class);

/* Sets x and y of the table at index 2 from a measured profile: the value at index 1, or its field
 * y. If neither is a profile, the table is unchanged. */
void body_take_profile(lua_State *L);

/* Sets x, z and y of the table at index 2 from the value at index 1, which is a map, a table with a
 * map in its field y, or a table with the fields of a map. Raises an error if the unit is not
 * mm. */
void body_take_map(lua_State *L, args_location location);

#endif

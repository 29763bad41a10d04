/* lua/surface_maps.h - surfaces over x and z, handed out as arrays by the engine, as maps and as
 * sections along x or z. */
#ifndef LUA_SURFACE_MAPS_H
#define LUA_SURFACE_MAPS_H

#include "archard/array.h"
#include "archard/contact.h"
#include "lua/base/args.h"

/* Pushes the values `name` of a body as a map; `unit` of the values. */
void surface_push_map(lua_State *L, const arc_array *arrays, size_t count, arc_body body,
                      const char *name, const char *unit);

/* Pushes { x=, NAME=, ... } of a body along the section that the table at `index` names, { z = 0 }
 * or { x = 0 }; none: z = 0. `names` ends with NULL. x is the place along the section; of one at
 * an x it is z, which the table has too. */
void surface_push_section(lua_State *L, int index, const char *where, const arc_array *arrays,
                          size_t count, arc_body body, const char *const *names);

/* Pushes stresses of a contact in 3-D (stress_map.c) by the table at `index`: { y= } a plane, { z=
 * } or { x= } a section, body= "lower" or another word for a body: a table of maps sxx .. sxz,
 * mises [MPa]; a section's are over x (z) and depth, which stands for z. */
int stress_push_space(lua_State *L, const arc_contact *contact, int index, const char *where);

#endif

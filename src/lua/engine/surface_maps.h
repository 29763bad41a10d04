/* lua/engine/surface_maps.h - pushes arrays of the engine over x and z as maps, and as sections
 * along x or z. */
#ifndef LUA_SURFACE_MAPS_H
#define LUA_SURFACE_MAPS_H

#include "archard/array.h"
#include "archard/contact.h"
#include "lua/base/args.h"

/* Pushes the array `name` of a body as a map with the unit `unit`. */
void surface_push_map(lua_State *L, const arc_array *arrays, size_t count, arc_body body,
                      const char *name, const char *unit);

/* Pushes the section { x=, NAME=, ... } of a body. The table at `index`, { z = 0 } or { x = 0 },
 * is its position (default z = 0). `names` ends with NULL. Field x is the coordinate along the
 * section. For a section at constant x this coordinate is z, and the section also has a field z. */
void surface_push_section(lua_State *L, int index, const char *where, const arc_array *arrays,
                          size_t count, arc_body body, const char *const *names);

/* Pushes stresses [MPa] of a 3-D contact (stress_map.c) for the table at `index`: { y= } for a
 * plane, { z= } or { x= } for a section. The field `body` selects the body (default lower). The
 * result is a table of maps sxx .. sxz, mises. The maps of a section are over x (or z) and the
 * depth; their field z is the depth. */
int stress_push_space(lua_State *L, const arc_contact *contact, int index, const char *where);

#endif

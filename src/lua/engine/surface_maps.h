/* lua/engine/surface_maps.h - pushes arrays of the engine over x and z as maps, and as sections
 * along x or z. */
#ifndef LUA_SURFACE_MAPS_H
#define LUA_SURFACE_MAPS_H

#include "archard/array.h"
#include "archard/contact.h"
#include "lua/base/args.h"

/* --- surface_maps.c --------------------------------------------------------------------------- */

/* Pushes the array `name` of a body as a map with the unit `unit`. */
void surface_push_map(lua_State *L, const arc_array *arrays, size_t count, arc_body body,
                      const char *name, const char *unit);

/* Pushes a section { x=, NAME=, ... } through the arrays `names` of a body; the list ends with
 * NULL. The table at `index` is the position of the section: { z = 0 } (default) or { x = 0 }. The
 * field x contains the coordinate along the section. In a section at constant x, this is the
 * coordinate z, which is also in the field z. */
void surface_push_section(lua_State *L, int index, const char *where, const arc_array *arrays,
                          size_t count, arc_body body, const char *const *names);

/* Pushes the list of surfaces { body=, update=, distance=, x=, h=, y=, p= }, with z in 3-D. The
 * arrays must be sorted by body and update. */
void surface_push_list(lua_State *L, const arc_array *arrays, size_t count);

/* --- stress_map.c ----------------------------------------------------------------------------- */

/* Pushes the stresses [MPa] of a 3-D contact (stress_map.c) as a table of maps sxx .. sxz, mises.
 * The table at `index` selects a plane, { y= }, or a section, { z= } or { x= }. Its field `body`
 * selects the body (default lower). The maps of a section extend over x (or z) and the depth, which
 * is in their field z. */
int stress_push_space(lua_State *L, const arc_contact *contact, int index, const char *where);

#endif

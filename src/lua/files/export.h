/* lua/files/export.h - functions of export_csv.c used by export_module.c. */
#ifndef LUA_EXPORT_H
#define LUA_EXPORT_H

#include "lua/engine/classes.h"

/* Returns the extension of the file name in a path, such as ".vtk", or NULL if the name has none.
 */
const char *export_ending(const char *path);

/* Pushes the file name for one body, such as "file-cylinder.vtk" for "file.vtk". If `path` has no
 * extension, the extension `usual` is used. */
const char *export_push_path(lua_State *L, const char *path, const char *body, const char *usual);

/* Implements the Lua function export.csv (export_csv.c). */
int export_csv(lua_State *L);

#endif

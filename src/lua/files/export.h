/* lua/files/export.h - what export_csv.c offers to the export of files. */
#ifndef LUA_EXPORT_H
#define LUA_EXPORT_H

#include "lua/engine/classes.h"

/* The ending of the last name of a path, ".vtk"; NULL where it has none. */
const char *export_ending(const char *path);

/* Pushes "file-cylinder.ending" for "file.ending"; `usual` is the ending where there is none. */
const char *export_push_path(lua_State *L, const char *path, const char *body, const char *usual);

/* export.csv (export_csv.c). */
int export_csv(lua_State *L);

#endif

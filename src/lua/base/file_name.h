/* lua/file_name.h - file names passed by scripts. */
#ifndef LUA_PATH_H
#define LUA_PATH_H

#include <lua.h>

/* The file name at `index`: not empty and without zero bytes, which would end a C string. Raises
 * ARC_ARGUMENT, "field 'NAME': expected a file name, got ...". */
const char *path_argument(lua_State *L, int index, const char *where, const char *name);

#endif

/* lua/base/file_name.h - checks file names from scripts. */
#ifndef LUA_PATH_H
#define LUA_PATH_H

#include <lua.h>

/* Returns the file name at `index`. The name must not be empty or contain zero bytes, which
 * would end a C string. Raises ARC_ARGUMENT, "field 'NAME': expected a file name, got ...". */
const char *path_argument(lua_State *L, int index, const char *where, const char *name);

#endif

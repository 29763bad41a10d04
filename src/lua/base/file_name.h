/* lua/file_name.h - names of files that scripts hand over. */
#ifndef LUA_PATH_H
#define LUA_PATH_H

#include <lua.h>

/* The name at `index`: text that is not empty and without zero bytes, at which C would end it.
 * Raises ARC_ARGUMENT, "field 'NAME': expected a file name, got ...". */
const char *path_argument(lua_State *L, int index, const char *where, const char *name);

#endif

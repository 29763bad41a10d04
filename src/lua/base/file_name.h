/* lua/file_name.h - names of files that scripts hand over. */
#ifndef LUA_PATH_H
#define LUA_PATH_H

#include <lua.h>

/* What a file is for. */
typedef enum path_use { PATH_READ, PATH_WRITE } path_use;

/* The name at `index`: text that is not empty and without zero bytes, at which C would end it.
 * Raises ARC_ARGUMENT, "field 'NAME': expected a file name, got ...". */
const char *path_argument(lua_State *L, int index, const char *where, const char *name,
                          path_use use);

/* From here on files are read below `folder` and the working folder, and written below the latter:
 * names of others are refused. May raise an error of Lua's. */
void file_name_confine(lua_State *L, const char *folder);

/* The folder that names are confined to for reading, or NULL. */
const char *file_name_confined(lua_State *L);

/* Whether a file of that name may be used so: always, unless names are confined. */
int file_name_is_allowed(lua_State *L, const char *path, path_use use);

#endif

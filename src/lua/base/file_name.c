/* Names of files, checked before C sees them. */
#include "lua/base/file_name.h"

#include "lua/base/args.h"

#include <string.h>

const char *path_argument(lua_State *L, int index, const char *where, const char *name,
                          path_use use) {
  (void)use;
  size_t length = 0;
  const char *path = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &length) : NULL;
  if (path && length > 0 && strlen(path) == length) return path;
  lua_pushvalue(L, index);
  args_refuse(L, (args_place){where, ""}, name,
              path && length > 0 ? "a file name without zero bytes" : "a file name");
}

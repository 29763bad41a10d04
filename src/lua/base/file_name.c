/* Checks file names from scripts. */
#include "lua/base/file_name.h"

#include "lua/base/args.h"

#include <string.h>

/* Returns NULL if the value at `index` is a valid file name, otherwise a description of the
 * expected value. */
static const char *trouble_with(lua_State *L, int index) {
  size_t length = 0;
  const char *path = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &length) : NULL;
  if (length == 0) return "a file name";
  return strlen(path) == length ? NULL : "a file name without zero bytes";
}

const char *path_argument(lua_State *L, int index, const char *where, const char *name) {
  const char *expected = trouble_with(L, index);
  if (!expected) return lua_tostring(L, index);
  lua_pushvalue(L, index);
  args_refuse(L, (args_location){where, ""}, name, expected);
}

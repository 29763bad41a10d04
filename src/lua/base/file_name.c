/* Names of files, checked before C sees them. */
#include "lua/base/file_name.h"

#include "lua/base/args.h"

#include <lauxlib.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* --- folders ---------------------------------------------------------------------------------- */

/* Its address names the registry's entry: the folders that files are confined to. */
static const char confined_key = 0;

typedef struct confined {
  char read[PATH_MAX], write[PATH_MAX]; /* without links */
} confined;

static void resolve(lua_State *L, const char *folder, char *whole) {
  if (!realpath(folder, whole)) luaL_error(L, "%s: no such folder", folder);
}

void file_name_confine(lua_State *L, const char *folder) {
  confined *to = lua_newuserdatauv(L, sizeof *to, 0);
  resolve(L, folder, to->read);
  resolve(L, ".", to->write);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &confined_key);
}

static const confined *find(lua_State *L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &confined_key);
  const confined *to = lua_touserdata(L, -1);
  lua_pop(L, 1);
  return to;
}

const char *file_name_confined(lua_State *L) {
  const confined *to = find(L);
  return to ? to->read : NULL;
}

static int is_below(const char *path, const char *folder) {
  const size_t length = strlen(folder);
  if (strncmp(path, folder, length) != 0) return 0;
  return path[length] == '/' || path[length] == '\0' || folder[length - 1] == '/';
}

/* The folder that a new file of this name would be in, without links; zero where there is none. A
 * link to nothing is no new file. */
static int resolve_new(const char *path, char whole[PATH_MAX]) {
  char folder[PATH_MAX];
  struct stat there;
  const char *slash = strrchr(path, '/');
  const size_t length = slash == path ? 1 : slash ? (size_t)(slash - path) : 1;
  if (lstat(path, &there) == 0 || length >= sizeof folder) return 0;
  memcpy(folder, slash ? path : ".", length);
  folder[length] = '\0';
  return realpath(folder, whole) != NULL;
}

int file_name_is_allowed(lua_State *L, const char *path, path_use use) {
  char whole[PATH_MAX];
  const confined *to = find(L);
  if (!to) return 1;
  if (!realpath(path, whole) && !resolve_new(path, whole)) return 0;
  return is_below(whole, to->write) || (use == PATH_READ && is_below(whole, to->read));
}

/* --- arguments -------------------------------------------------------------------------------- */

/* What is expected instead, or NULL. */
static const char *trouble_with(lua_State *L, int index, path_use use) {
  size_t length = 0;
  const char *path = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &length) : NULL;
  if (length == 0) return "a file name";
  if (strlen(path) != length) return "a file name without zero bytes";
  if (file_name_is_allowed(L, path, use)) return NULL;
  return use == PATH_READ ? "a file below the folder of the script or the working folder (sandbox)"
                          : "a file below the working folder (sandbox)";
}

const char *path_argument(lua_State *L, int index, const char *where, const char *name,
                          path_use use) {
  const char *expected = trouble_with(L, index, use);
  if (!expected) return lua_tostring(L, index);
  lua_pushvalue(L, index);
  args_refuse(L, (args_place){where, ""}, name, expected);
}

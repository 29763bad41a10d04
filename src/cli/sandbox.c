/* The limits of the sandbox. */
#include "cli/sandbox.h"

#include "archard/base.h"
#include "cli/signals.h"
#include "lua/base/confine.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"

#include <lauxlib.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static const double mebi = 1048576;

sandbox sandbox_usual(void) {
  return (sandbox){.memory = 1024, .seconds = 3600, .instructions = 1e11};
}

int sandbox_set(sandbox *self, const char *name, const char *text) {
  char *end;
  const double value = strtod(text, &end);
  if (end == text || *end != '\0' || !(value > 0) || !isfinite(value)) return 0;
  if (strcmp(name, "memory") == 0) self->memory = value;
  if (strcmp(name, "seconds") == 0) self->seconds = value;
  if (strcmp(name, "instructions") == 0) self->instructions = value;
  return 1;
}

/* --- memory ----------------------------------------------------------------------------------- */

/* As lua_Alloc wants it: for new blocks `old` is a kind, no size. */
static void *allocate(void *context, void *block, size_t old, size_t size) {
  sandbox *self = context;
  const size_t held = block ? old : 0;
  if (size == 0) {
    free(block);
    self->used -= held;
    return NULL;
  }
  if (size > held && (double)(self->used - held) + (double)size > self->memory * mebi) return NULL;
  void *moved = realloc(block, size);
  if (moved) self->used = self->used - held + size;
  return moved;
}

lua_State *sandbox_new_state(sandbox *self) {
  return lua_newstate(allocate, self);
}

/* Pages that the process has mapped so far. */
static double mapped(void) {
  double pages = 0;
  FILE *file = fopen("/proc/self/statm", "r");
  if (file && fscanf(file, "%lf", &pages) != 1) pages = 0;
  if (file) fclose(file);
  return pages * (double)sysconf(_SC_PAGESIZE);
}

/* What the engine and other programs take, too. */
static void limit_memory(const sandbox *self) {
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  const double wanted = mapped() + self->memory * mebi, largest = 0x1p63;
  if (wanted >= largest) return;
  if (limit.rlim_cur != RLIM_INFINITY && (double)limit.rlim_cur < wanted) return;
  limit.rlim_cur = (rlim_t)wanted;
  setrlimit(RLIMIT_AS, &limit);
}

/* --- entering --------------------------------------------------------------------------------- */

/* Pushes the folder of a path, "." where it names none. */
static const char *push_folder(lua_State *L, const char *path) {
  const char *slash = path ? strrchr(path, '/') : NULL;
  if (!slash) return lua_pushliteral(L, ".");
  return lua_pushlstring(L, path, slash == path ? 1 : (size_t)(slash - path));
}

void sandbox_enter(lua_State *L, const sandbox *self, const char *script) {
  const char *folder = push_folder(L, script);
  arc_error error;
  if (confine_files(folder, ".", &error) != ARC_OK) luaL_error(L, "%s", error.message);
  script_require(L, "archard.lib.sandbox");
  lua_pushstring(L, folder);
  lua_call(L, 1, 0);
  lua_pop(L, 1);
  arc_reserve_blas();
  limit_memory(self);
  interrupt_limit(L, self->instructions, signals_begin_working_grace);
  signals_limit(self->seconds);
}

/* Sets and enforces the limits of the sandbox. */
#include "cli/sandbox.h"

#include "archard/base.h"
#include "cli/signals.h"
#include "lua/base/confine.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"
#include "system/child.h"
#include "system/jail.h"
#include "system/memory_limit.h"

#include <errno.h>
#include <lauxlib.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double mebi = 1048576;

/* A single file may be as large as the memory limit. All files together may be FILES_AT_ONCE
 * times as large as this limit, but may fill at most half of the free disk space. */
enum { FILES_AT_ONCE = 4 };

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

/* Allocator of Lua (lua_Alloc) that enforces the memory limit. If `block` is NULL, Lua passes
 * the type of a new object in `old` instead of a size. */
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

/* --- enabling the sandbox --------------------------------------------------------------------- */

/* Copies the folder of a path to `folder`. The folder of a name without slashes is ".". */
static void folder_of(const char *path, char folder[PATH_MAX]) {
  const char *slash = path ? strrchr(path, '/') : NULL;
  const size_t length = slash == path ? 1 : slash ? (size_t)(slash - path) : 1;
  snprintf(folder, PATH_MAX, "%.*s", (int)length, slash ? path : ".");
}

/* Returns the path of the program `name` in one of the folders of PATH, or `name` itself if no
 * folder contains the program. */
static const char *find(const char *name, char path[PATH_MAX]) {
  const char *folders = getenv("PATH");
  while (folders && *folders && !strchr(name, '/')) {
    const size_t length = strcspn(folders, ":");
    const int fits = snprintf(path, PATH_MAX, "%.*s/%s", (int)length, folders, name) < PATH_MAX;
    if (length > 0 && fits && access(path, X_OK) == 0) return path;
    folders += length + (folders[length] == ':');
  }
  return name;
}

static void report_missing(int missing) {
  static const char *const what[] = {
      "that no other files are opened and no other programs run (it has no Landlock of version 3)",
      "that no connections are made (it has no filter for system calls)",
      "a limit of the number of processes (it does not count processes of root)"};
  for (int i = 0; i < 3; i++)
    if (missing & 1 << i)
      fprintf(stderr, "archard: --sandbox: this system does not ensure %s\n", what[i]);
}

/* Environment variable that marks a program that was restarted in the jail. Its value is the
 * process id. */
static const char mark[] = "ARCHARD_CONFINED";

static int is_confined(void) {
  const char *who = getenv(mark);
  const int confined = who && atol(who) == (long)getpid();
  unsetenv(mark);
  return confined;
}

/* Sets the environment variable `mark`. Sets the working folder as the folder of temporary
 * files, also for child processes. */
static void set_environment(const char *folder) {
  char number[24];
  snprintf(number, sizeof number, "%ld", (long)getpid());
  setenv(mark, number, 1);
  setenv("TMPDIR", folder, 1);
  setenv("SQLITE_TMPDIR", folder, 1);
}

int sandbox_confine(const sandbox *self, const char *script, char **argv) {
  char folder[PATH_MAX], here[PATH_MAX], path[PATH_MAX];
  const char *gnuplot = getenv("ARCHARD_GNUPLOT");
  if (is_confined()) return 1;
  folder_of(script, folder);
  if (!realpath(".", here)) {
    perror("archard: the working folder");
    return 0;
  }
  const arc_jail jail = {folder, here, find(gnuplot && *gnuplot ? gnuplot : "gnuplot", path),
                         self->memory * mebi};
  set_environment(here);
  int missing = arc_jail_enter(&jail);
  /* without `strict`, a missing limit of processes is accepted, because few workers run */
  if (!self->strict) missing &= ~ARC_JAIL_PROCESSES;
  report_missing(missing);
  if (missing && self->strict) return 0;
  fprintf(stderr, "archard: cannot restart inside the sandbox: %s\n",
          strerror(arc_child_again(argv)));
  return 0;
}

void sandbox_enter(lua_State *L, const sandbox *self, const char *script) {
  char folder[PATH_MAX];
  arc_error error;
  folder_of(script, folder);
  if (confine_files(folder, ".", &error) != ARC_OK) luaL_error(L, "%s", error.message);
  script_require(L, "archard.lib.sandbox");
  lua_pushstring(L, folder);
  lua_call(L, 1, 0);
  arc_reserve_blas();
  const double free = confine_free();
  confine_disk(fmax(free - FILES_AT_ONCE * self->memory * mebi, free / 2));
  arc_child_confine();
  arc_memory_limit_set(self->memory * mebi);
  interrupt_limit(L, self->instructions, signals_begin_working_grace);
  signals_limit(self->seconds);
}

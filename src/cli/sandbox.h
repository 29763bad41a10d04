/* cli/sandbox.h - restrictions of an untrusted script. Lua's libraries are loaded without the
 * functions that can change anything outside the script (scripts/lib/sandbox.lua). The operating
 * system permits reading only below the script's folder and the working folder, and writing only
 * below the working folder (system/jail.h). The memory limit applies to Lua, the engine and all
 * started programs. The limit in seconds is elapsed time. A script that exceeds a limit is
 * stopped as by Ctrl-C. If it does not stop within a grace period, the program ends. */
#ifndef CLI_SANDBOX_H
#define CLI_SANDBOX_H

#include <lua.h>

typedef struct sandbox {
  int wanted, strict;  /* strict: do not run if the system cannot enforce all restrictions */
  double memory;       /* memory limit [MiB] */
  double seconds;      /* time limit [s]; 0: no limit */
  double instructions; /* limit of the number of Lua instructions */
  size_t used;         /* memory used by Lua [bytes] */
} sandbox;

/* Returns the default limits. */
sandbox sandbox_usual(void);

/* Sets the limit `name` to the number in `text`. Returns 0 if the number is not positive. */
int sandbox_set(sandbox *self, const char *name, const char *text);

/* Creates a Lua state with limited memory. Returns NULL if memory is exhausted. `self` must
 * exist as long as the state. */
lua_State *sandbox_new_state(sandbox *self);

/* Restricts this program and restarts it with these restrictions. Returns 1 in the restarted
 * program. On failure it prints the reason on standard error and returns 0. */
int sandbox_confine(const sandbox *self, const char *script, char **argv);

/* Restricts the libraries, files and resources of a Lua state. `script` is the path of the
 * script, or NULL without a script. May raise a Lua error. */
void sandbox_enter(lua_State *L, const sandbox *self, const char *script);

#endif

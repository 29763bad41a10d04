/* cli/sandbox.h - restrictions of an untrusted script. Lua's libraries are loaded without functions
 * that reach outside the script (scripts/lib/sandbox.lua). Files can be read below the script's
 * folder and written below the working folder, as the system enforces (system/jail.h). The memory
 * limit covers Lua, the engine and all started programs; seconds are elapsed time. A script that
 * exceeds a limit is stopped as by Ctrl-C, and ended if it does not stop within a grace period. */
#ifndef CLI_SANDBOX_H
#define CLI_SANDBOX_H

#include <lua.h>

typedef struct sandbox {
  int wanted, strict;  /* strict: refuse to run if the system cannot enforce everything */
  double memory;       /* [MiB] */
  double seconds;      /* 0: no limit */
  double instructions; /* limit of Lua's memory; 0: none */
  size_t used;         /* bytes used by Lua */
} sandbox;

/* The default limits. */
sandbox sandbox_usual(void);

/* Sets the limit `name` to the number in `text`. Returns zero unless it is > 0. */
int sandbox_set(sandbox *self, const char *name, const char *text);

/* Creates a state with limited memory; NULL without memory. `self` must outlive it. */
lua_State *sandbox_new_state(sandbox *self);

/* Confines this program and restarts it. Returns non-zero inside; zero on failure, with the reason
 * on standard error. */
int sandbox_confine(const sandbox *self, const char *script, char **argv);

/* Enters the sandbox: restricts libraries, files and resources. `script` is the path of the script,
 * or NULL. May raise a Lua error. */
void sandbox_enter(lua_State *L, const sandbox *self, const char *script);

#endif

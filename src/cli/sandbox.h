/* cli/sandbox.h - a script of a stranger: what it may use, and how much of it.
 *
 * Lua's libraries are left without what reaches out of the script (scripts/lib/sandbox.lua); files
 * are those below the script's folder, to read, and below the working folder: the system sees to
 * that (system/jail.h). Memory is that of Lua, of the engine and of all that is started, seconds
 * are on the clock. What goes beyond a limit is stopped as by Ctrl-C, and ended where that does not
 * stop it within grace. */
#ifndef CLI_SANDBOX_H
#define CLI_SANDBOX_H

#include <lua.h>

typedef struct sandbox {
  int wanted, strict;  /* strict: not where the system cannot ensure all */
  double memory;       /* [MiB] */
  double seconds;      /* 0: no limit */
  double instructions; /* of Lua; 0: no limit */
  size_t used;         /* bytes of Lua's */
} sandbox;

/* Limits as they are unless options say otherwise. */
sandbox sandbox_usual(void);

/* Sets the limit of the name to the number in `text`; zero where that is none above 0. */
int sandbox_set(sandbox *self, const char *name, const char *text);

/* A state whose memory is limited; NULL without memory. `self` must outlive it. */
lua_State *sandbox_new_state(sandbox *self);

/* Has the system confine this program and begins it anew, inside. Returns non-zero there; zero
 * where that failed, or is refused, with the reason on standard error. */
int sandbox_confine(const sandbox *self, const char *script, char **argv);

/* Closes the sandbox around all that follows: what the script may use, the files that it has, the
 * limits. `script` is its path, NULL where it is no file. May raise an error of Lua's. */
void sandbox_enter(lua_State *L, const sandbox *self, const char *script);

#endif

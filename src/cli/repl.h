/* cli/repl.h - reads chunks, runs them, shows their values. */
#ifndef CLI_REPL_H
#define CLI_REPL_H

#include "cli/chunk.h"

#include <lua.h>

/* The prompt, until the user leaves it. Errors are shown and forgotten. */
void repl_run(lua_State *L);

/* Standard input as if it had been typed, without banner, prompt or colour. The first error ends
 * it; messages count the lines of the input. */
run_status repl_run_pipe(lua_State *L);

#endif

/* cli/repl.h - the prompt, which reads chunks, runs them and prints their values. */
#ifndef CLI_REPL_H
#define CLI_REPL_H

#include "cli/chunk.h"

#include <lua.h>

/* Runs the prompt until the user ends the session. Errors are printed and do not end the prompt. */
void repl_run(lua_State *L);

/* Runs standard input like typed lines, but without banner, prompt or colours. Stops at the
 * first error. Messages contain the line number in the input. */
run_status repl_run_pipe(lua_State *L);

#endif

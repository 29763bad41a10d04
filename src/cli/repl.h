/* cli/repl.h - the prompt: reads chunks, runs them, prints their values. */
#ifndef CLI_REPL_H
#define CLI_REPL_H

#include "cli/chunk.h"

#include <lua.h>

/* Runs the prompt until the user leaves. Errors are printed and do not end it. */
void repl_run(lua_State *L);

/* Runs standard input like typed lines, without banner, prompt or colour, up to the first error;
 * messages have the line number of the input. */
run_status repl_run_pipe(lua_State *L);

#endif

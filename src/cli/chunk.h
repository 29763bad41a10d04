/* cli/chunk.h - the one gate that every chunk of the user's passes. */
#ifndef CLI_CHUNK_H
#define CLI_CHUNK_H

#include <lua.h>

typedef enum run_status { RUN_OK, RUN_FAILED, RUN_INTERRUPTED } run_status;

/* Calls the function below the `arguments` values on top of the stack, as lua_call does. On failure
 * nothing of it is left on the stack, the message and a traceback are on standard error, and a
 * pending interrupt is over. */
run_status run_call(lua_State *L, int arguments, int results);

/* Pops the error value on top of the stack and reports it as run_call would: for a chunk that could
 * not even be loaded. */
run_status run_refused(lua_State *L);

#endif

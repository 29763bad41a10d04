/* cli/chunk.h - protected calls of all chunks of the user. */
#ifndef CLI_CHUNK_H
#define CLI_CHUNK_H

#include <lua.h>

typedef enum run_status { RUN_OK, RUN_FAILED, RUN_INTERRUPTED } run_status;

/* Calls the function below the `arguments` values on top of the stack, as lua_call does. On failure
 * the function is removed from the stack, message and traceback are printed on standard error, and
 * a pending interrupt is cleared. */
run_status run_call(lua_State *L, int arguments, int results);

/* Pops the error value on top of the stack and prints it like a failed call: for a chunk that could
 * not be loaded. */
run_status run_refused(lua_State *L);

#endif

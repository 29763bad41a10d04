/* cli/chunk.h - protected calls of the chunks that a user enters. */
#ifndef CLI_CHUNK_H
#define CLI_CHUNK_H

#include <lua.h>

typedef enum run_status { RUN_OK, RUN_FAILED, RUN_INTERRUPTED } run_status;

/* Works like lua_call for the function on the stack below its arguments, whose number is
 * `arguments`. On failure removes the function, prints the message and the traceback on standard
 * error, and clears a pending interrupt. */
run_status run_call(lua_State *L, int arguments, int results);

/* Pops the error value on top of the stack and prints it, as run_call does after a failure. Used
 * for chunks that could not be loaded. */
run_status run_refused(lua_State *L);

/* Prints the first `length` bytes of a text on standard error, without control characters, which
 * names in files may contain. */
void print_plain(const char *text, size_t length);

#endif

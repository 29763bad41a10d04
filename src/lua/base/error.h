/* lua/error.h - the errors the binding raises.
 *
 * An error object is a table { code=, where=, step=, message=, position=, cause= } that turns into
 * text by itself: code is the name of an arc_status ("ARGUMENT", "NOT_CONVERGED", ...), where the
 * function that failed ("wear", "wear:step"), step the update it failed in (nil outside a run),
 * position "file:line:" of the caller, cause the value a user's function raised.
 */
#ifndef LUA_ERROR_H
#define LUA_ERROR_H

#include "archard/base.h"

#include <lua.h>

/* Pushes a text as arc_show_text shows it; all messages of error objects are. */
void error_push_plain(lua_State *L, const char *text);

/* Raises an error object; the format is that of lua_pushfstring. */
void error_raise(lua_State *L, arc_status code, const char *where, const char *format, ...)
    __attribute__((noreturn));

/* Does nothing for ARC_OK; else raises what the engine reported. A stop that the user asked for
 * raises "interrupted". `step` < 0: no step. */
void error_check(lua_State *L, arc_status status, const arc_error *error, const char *where,
                 lua_Number step);

/* Raises ARC_CALLBACK for the error value on top of the stack, left there by a user's function that
 * `name` describes. An interrupt goes on unchanged. */
void error_callback(lua_State *L, const char *where, const char *name) __attribute__((noreturn));

/* Calls the function below `arguments` values on the stack with a traceback for its errors; returns
 * LUA_OK or leaves the error value on top. */
int error_pcall(lua_State *L, int arguments, int results);

/* The level of the first function of the user's: neither in C nor in a script of the program,
 * unless that is the chunk that runs. 0, which has no place in a text, where there is none. */
int error_user_level(lua_State *L);

#endif

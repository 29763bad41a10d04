/* lua/error.h - the errors that the Lua binding raises.
 *
 * An error object is a table { code=, where=, step=, message=, position=, cause= } with __tostring.
 * code: name of an arc_status ("ARGUMENT", "NOT_CONVERGED", ...); where: the function that failed
 * ("wear", "wear:step"); step: the update in which it failed (nil outside a run); position:
 * "file:line:" of the caller; cause: the value that a user's function raised.
 */
#ifndef LUA_ERROR_H
#define LUA_ERROR_H

#include "archard/base.h"

#include <lua.h>

/* Pushes `text` with control characters escaped (arc_show_text), as in all messages of error
 * objects. */
void error_push_plain(lua_State *L, const char *text);

/* Raises an error object; `format` as for lua_pushfstring. */
void error_raise(lua_State *L, arc_status code, const char *where, const char *format, ...)
    __attribute__((noreturn));

/* Returns if `status` is ARC_OK; else raises the engine's error. A stop requested by the user
 * raises "interrupted". `step` < 0: no step. */
void error_check(lua_State *L, arc_status status, const arc_error *error, const char *where,
                 lua_Number step);

/* Raises ARC_CALLBACK for the error value on top of the stack, raised by a user's function that
 * `name` describes. "interrupted" is raised again unchanged. */
void error_callback(lua_State *L, const char *where, const char *name) __attribute__((noreturn));

/* lua_pcall with a traceback added to errors that are text. Returns LUA_OK, or another status with
 * the error value on top. */
int error_pcall(lua_State *L, int arguments, int results);

/* Stack level of the first function of the user: not in C, and not in a built-in script unless that
 * is the main chunk. 0 (no position in messages) if no level qualifies. */
int error_user_level(lua_State *L);

#endif

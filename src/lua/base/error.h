/* lua/base/error.h - the errors that the Lua binding raises.
 *
 * An error object is a table { code=, where=, step=, message=, position=, cause= } with __tostring.
 *   code      name of the arc_status, such as "ARGUMENT" or "NOT_CONVERGED"
 *   where     name of the function that failed, such as "wear" or "wear:step"
 *   step      number of the update that failed; nil outside a run
 *   position  "file:line:" of the caller
 *   cause     error value that a function of the user raised; nil for other errors */
#ifndef LUA_ERROR_H
#define LUA_ERROR_H

#include "archard/base.h"

#include <lua.h>

/* Pushes `text` with control characters escaped (arc_show_text). The messages of all error objects
 * are escaped. */
void error_push_plain(lua_State *L, const char *text);

/* Calls the function in upvalue 1 and returns its result with control characters escaped. The
 * __tostring of each class is such a closure, because names in files are not trusted. */
int error_plain_result(lua_State *L);

/* Raises an error object. `format` has the syntax of lua_pushfstring. */
void error_raise(lua_State *L, arc_status code, const char *where, const char *format, ...)
    __attribute__((noreturn));

/* Raises the engine's error unless `status` is ARC_OK. A stop requested by the user raises
 * "interrupted". `step` is the number of the update that failed; < 0: no update. */
void error_check(lua_State *L, arc_status status, const arc_error *error, const char *where,
                 lua_Number step);

/* Raises ARC_CALLBACK for the error value on top of the stack, which a function of the user has
 * raised. `name` describes the user's function. An interrupt is raised again unchanged. */
void error_callback(lua_State *L, const char *where, const char *name) __attribute__((noreturn));

/* Calls lua_pcall and adds a traceback to errors that are strings. Returns LUA_OK, or another
 * status with the error value on top of the stack. */
int error_pcall(lua_State *L, int arguments, int results);

/* Returns the stack level of the innermost function of the user. C functions do not count. A
 * function of a built-in script counts only if this script is the main chunk. Returns 0 if the
 * stack has no function of the user; messages then have no position. */
int error_user_level(lua_State *L);

#endif

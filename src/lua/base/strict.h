/* lua/base/strict.h - raises errors for unknown globals, and for unknown fields of the program's
 * objects and tables. The message contains the most similar valid name.
 *
 * Only reads by the user's Lua code raise errors. In built-in scripts and C functions an unknown
 * name is nil, so that they can test for fields. Scripts use this file as the module
 * `archard.strict`. */
#ifndef LUA_STRICT_H
#define LUA_STRICT_H

#include <lua.h>

/* Switches the errors for unknown names off in this Lua state (option --lax). */
void strict_lax(lua_State *L);

/* Returns true if the user's code, not a built-in script, reads a field. Only metamethods in C call
 * this function. */
int strict_reads(lua_State *L);
int strict_reads_called(lua_State *L); /* version of strict_reads for functions wrapped by call.h */

/* Raises the error "no field 'NAME'" for the object `where`. Valid names are the string keys and
 * the list values of the table at index `known`. */
void strict_refuse(lua_State *L, const char *where, const char *name, int known)
    __attribute__((noreturn));

/* Makes it an error to read an unknown field of the table on top of the stack, and sets its
 * __tostring. `where` is the name of the table in messages. */
void strict_table(lua_State *L, const char *where);

/* Pushes a metatable for strict tables with aliases. `words` is the index of a table that maps each
 * alias to the name of its field. */
void strict_metatable(lua_State *L, const char *where, int words);

/* Returns true if the table at `index` was made strict with the name `where`. */
int strict_is(lua_State *L, int index, const char *where);

/* Makes it an error to read an unknown field of the table on top of the stack, unless its metatable
 * already has an __index. Other metamethods are not changed. */
void strict_module(lua_State *L, const char *where);

/* Makes it an error to read a global that was never assigned. */
void strict_globals(lua_State *L);

/* Makes it an error to read an unknown name of Lua's libraries, such as math.sqr. */
void strict_libraries(lua_State *L);

/* Raises an error if the user's code reads the name at index 2, which is not a name of the library
 * at index `library`. The __index of strings calls this function. */
void strict_method(lua_State *L, int library);

#endif

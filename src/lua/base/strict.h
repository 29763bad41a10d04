/* lua/strict.h - errors for unknown names of globals and of fields of the program's objects and
 * tables; the message has the nearest known name.
 *
 * Only reads by the user's Lua text raise errors. Built-in scripts and C functions get nil, so they
 * can test for fields. Scripts use this file as the module `archard.strict`.
 */
#ifndef LUA_STRICT_H
#define LUA_STRICT_H

#include <lua.h>

/* Switches these errors off in this state: `archard --lax`. */
void strict_lax(lua_State *L);

/* True if the user's text reads the field; for __index functions in C. */
int strict_reads(lua_State *L);
int strict_reads_called(lua_State *L); /* for functions wrapped by call.h */

/* Raises the error "no field 'NAME'" for the object `where`. Known names are read from the table at
 * index `known`: its text keys and the values of its list part. */
void strict_refuse(lua_State *L, const char *where, const char *name, int known)
    __attribute__((noreturn));

/* Makes unknown fields of the table on top of the stack errors and sets its __tostring. `where`:
 * name of the table; must be a text of the program. */
void strict_table(lua_State *L, const char *where);

/* Pushes a metatable for strict tables with aliases. `words`: index of a table from alias to field
 * name. */
void strict_metatable(lua_State *L, const char *where, int words);

/* True if the table at `index` was made strict with the name `where`. */
int strict_is(lua_State *L, int index, const char *where);

/* strict_table for a table that has a metatable; sets __index only if it has none. */
void strict_module(lua_State *L, const char *where);

/* Makes reading a global that was never assigned an error. */
void strict_globals(lua_State *L);

/* Makes unknown names in Lua's libraries an error, e.g. math.sqr. */
void strict_libraries(lua_State *L);

/* For the __index of strings: raises an error if the user's text reads the name at index 2, which
 * is not in the library at index `library`. */
void strict_method(lua_State *L, int library);

#endif

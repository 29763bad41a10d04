/* lua/strict.h - a name that nobody has given is an error that says the nearest one: globals, and
 * fields of objects and tables of ours.
 *
 * Only what the user's Lua text reads is refused. The scripts inside the program ask objects what
 * they have, and so do functions in C: both get nil. Scripts of ours have all this as the module
 * `archard.strict`.
 */
#ifndef LUA_STRICT_H
#define LUA_STRICT_H

#include <lua.h>

/* Nothing is refused in this state any more: `archard --lax`. */
void strict_lax(lua_State *L);

/* Whether the function that indexes is the user's: for __index functions in C. */
int strict_reads(lua_State *L);
int strict_reads_called(lua_State *L); /* for those that call.h has wrapped */

/* Raises the error for a field: `where` has it not. The names at index `known` are the values of a
 * list, or else the keys of a table, or both. */
void strict_refuse(lua_State *L, const char *where, const char *name, int known)
    __attribute__((noreturn));

/* Makes unknown fields of the table on top of the stack errors, and has it print as the prompt
 * shows it. `where` must be text of the program's own. */
void strict_table(lua_State *L, const char *where);

/* Pushes a metatable for such tables whose fields answer to other words too: from each, in the
 * table at `words`, to the name of the field. */
void strict_metatable(lua_State *L, const char *where, int words);

/* Whether the table at `index` was made one of `where` by either. */
int strict_is(lua_State *L, int index, const char *where);

/* The same of a table with a metatable of its own, which gains an __index where it has none. */
void strict_module(lua_State *L, const char *where);

/* Makes reading of globals that were never assigned an error. */
void strict_globals(lua_State *L);

/* The same of the names in Lua's own libraries: math.sqr. */
void strict_libraries(lua_State *L);

/* For the __index of strings: refuses the name at index 2, which the library at `library` has not,
 * where the user reads it. */
void strict_method(lua_State *L, int library);

#endif

/* lua/archard.h - the module `archard` as Lua sees it.
 *
 * How a class joins: write `int luaopen_archard_NAME(lua_State *L)`, leaving one value on the stack
 * (a constructor function, or a table), and add a line to the list in archard.c. The value becomes
 * the global NAME and the field NAME of `require "archard"`. A class written in Lua joins by the
 * name of its script.
 *
 * What completion and help look for in the metatable of an object; they never call __index:
 *   __name     "archard.NAME" or "NAME": the class, as the help entries spell it
 *   __index    a table of methods; or a function, and then
 *   __methods  the table of methods that function looks in
 *   __fields   names of the fields __index computes: a list of names, or function(object) -> list
 */
#ifndef LUA_ARCHARD_H
#define LUA_ARCHARD_H

#include <lua.h>

/* Registers the scripts and modules below package.preload, sets the globals and leaves the module
 * table on the stack (also in package.loaded.archard). The standard libraries must be open. It is
 * also what the stock interpreter calls for `require "archard"`, in archard.so: the same there but
 * for Ctrl-C, which is the interpreter's. Turns warnings on, and threads of BLAS and OpenMP off. */
int luaopen_archard(lua_State *L);

/* The module `archard.term`: what the terminal is and can do. */
int luaopen_archard_term(lua_State *L);

/* The module `archard.gnuplot`: figures as tables, drawn by gnuplot; scripts/plot/init.lua uses it.
 */
int luaopen_archard_gnuplot(lua_State *L);

/* The module `archard.store`: run files. */
int luaopen_archard_store(lua_State *L);

/* The module `archard.process`: copies of this program at work. */
int luaopen_archard_process(lua_State *L);

/* The module `archard.warnings`: keeps warnings for whoever asks, instead of showing them. */
int luaopen_archard_warnings(lua_State *L);

/* The module `archard.files`: writes texts and numbers as every export does. */
int luaopen_archard_files(lua_State *L);

/* The module `archard.random`: points by design and seed, quantiles. */
int luaopen_archard_random(lua_State *L);

/* The module `archard.least_squares`: fits of parameters to data. */
int luaopen_archard_least_squares(lua_State *L);

/* The module `archard.measure`: what profiles tell. */
int luaopen_archard_measure(lua_State *L);

/* The module `archard.names`: what values and misspelt names are called in messages, and the
 * raising of errors. */
int luaopen_archard_names(lua_State *L);

/* The module `archard.strict`: unknown names as errors. */
int luaopen_archard_strict(lua_State *L);

/* The module `archard.sphere`: balls in sockets, for scripts/joint. */
int luaopen_archard_sphere(lua_State *L);

/* The module `archard.settings`: what can be set and what is recorded. */
int luaopen_archard_settings(lua_State *L);

#endif

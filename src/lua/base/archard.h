/* lua/base/archard.h - the Lua module `archard`.
 *
 * To add a class in C, write `int luaopen_archard_NAME(lua_State *L)`, which pushes one value (a
 * constructor function or a table), and add the function to the list in archard.c. The value
 * becomes the global NAME and the field NAME of `require "archard"`. A class in Lua is listed there
 * by the name of its script.
 *
 * Completion and help read these fields of an object's metatable, without calling __index:
 *   __name     "archard.NAME" or "NAME": name of the class as in the help topics
 *   __index    the table of methods, or a function; with a function also:
 *   __methods  the table of methods
 *   __fields   names of the fields that __index computes: a list, or function(object) -> list */
#ifndef LUA_ARCHARD_H
#define LUA_ARCHARD_H

#include <lua.h>

/* Registers the scripts and modules in package.preload, sets the globals, and pushes the module
 * table (also stored in package.loaded.archard). The standard libraries must be open. Switches
 * warnings on and limits BLAS and OpenMP to one thread. The standard interpreter calls this
 * function for `require "archard"` from archard.so and then handles Ctrl-C itself. */
int luaopen_archard(lua_State *L);

/* The module `archard.term`: returns properties of the terminal, such as its size. */
int luaopen_archard_term(lua_State *L);

/* The module `archard.gnuplot`: draws figures by gnuplot. Figures are tables
 * (scripts/plot/init.lua). */
int luaopen_archard_gnuplot(lua_State *L);

/* The module `archard.store`: reads and writes run files. */
int luaopen_archard_store(lua_State *L);

/* The module `archard.process`: starts worker processes, which are copies of this program. */
int luaopen_archard_process(lua_State *L);

/* The module `archard.warnings`: collects warnings instead of printing them. */
int luaopen_archard_warnings(lua_State *L);

/* The module `archard.files`: writes texts and numbers in the format of all exports. */
int luaopen_archard_files(lua_State *L);

/* The module `archard.random`: computes the sample points of a design, such as Sobol points, from a
 * seed, and quantiles of distributions. */
int luaopen_archard_random(lua_State *L);

/* The module `archard.least_squares`: solves nonlinear least-squares problems. */
int luaopen_archard_least_squares(lua_State *L);

/* The module `archard.measure`: computes measures of wear profiles, such as their sum. */
int luaopen_archard_measure(lua_State *L);

/* The module `archard.names`: shows values in messages, searches for the most similar valid name,
 * and raises errors. */
int luaopen_archard_names(lua_State *L);

/* The module `archard.strict`: raises errors for unknown names. */
int luaopen_archard_strict(lua_State *L);

/* The module `archard.sphere`: computes ball-and-socket joints for scripts/joint. */
int luaopen_archard_sphere(lua_State *L);

/* The module `archard.settings`: lists all settings of definitions and all columns of the
 * history. */
int luaopen_archard_settings(lua_State *L);

#endif

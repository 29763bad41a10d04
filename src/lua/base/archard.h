/* lua/base/archard.h - the Lua module `archard`.
 *
 * To add a class in C, write `int luaopen_archard_NAME(lua_State *L)`, which pushes one value (a
 * constructor function or a table), and add this function to the list `classes` in archard.c. The
 * value becomes the global NAME and the field NAME of `require "archard"`. To add a class in Lua,
 * add its name and its module to the list `scripted` in archard.c.
 *
 * Completion and help read these fields of an object's metatable, without calling __index:
 *   __name     name of the class in the help topics, as "archard.NAME" or "NAME"
 *   __index    the table of methods, or a function that returns methods and computed fields
 *   __methods  the table of methods, required if __index is a function
 *   __fields   names of the computed fields: a list, or a function(object) that returns a list */
#ifndef LUA_ARCHARD_H
#define LUA_ARCHARD_H

#include <lua.h>

/* Pushes the module table, which is also stored in package.loaded.archard. Registers the scripts
 * and modules in package.preload, sets the globals, switches warnings on, and limits BLAS and
 * OpenMP to one thread. The standard libraries must be open. The standard interpreter calls this
 * function for `require "archard"` from archard.so and then handles Ctrl-C itself. */
int luaopen_archard(lua_State *L);

/* The module `archard.term`: returns properties of the terminal, such as its size. */
int luaopen_archard_term(lua_State *L);

/* The module `archard.gnuplot`: draws figures with gnuplot. A figure is a Lua table
 * (scripts/plot/init.lua). */
int luaopen_archard_gnuplot(lua_State *L);

/* The module `archard.store`: reads and writes run files. */
int luaopen_archard_store(lua_State *L);

/* The module `archard.process`: starts worker processes, which are copies of this program. */
int luaopen_archard_process(lua_State *L);

/* The module `archard.warnings`: collects warnings instead of printing them. */
int luaopen_archard_warnings(lua_State *L);

/* The module `archard.files`: writes results as CSV, VTK, input decks and Gmsh files, and reads and
 * writes text files. */
int luaopen_archard_files(lua_State *L);

/* The module `archard.random`: computes the sample points of a design, such as Sobol points, from a
 * seed. Also computes quantiles of distributions. */
int luaopen_archard_random(lua_State *L);

/* The module `archard.least_squares`: solves nonlinear least-squares problems. */
int luaopen_archard_least_squares(lua_State *L);

/* The module `archard.measure`: computes quantities from wear profiles, such as the sum of two
 * profiles. */
int luaopen_archard_measure(lua_State *L);

/* The module `archard.names`: formats values for messages, searches for the most similar valid
 * name, and raises errors. */
int luaopen_archard_names(lua_State *L);

/* The module `archard.strict`: raises an error if the user's code reads an unknown name. */
int luaopen_archard_strict(lua_State *L);

/* The module `archard.sphere`: computes contact and wear of ball-and-socket joints for
 * scripts/joint. */
int luaopen_archard_sphere(lua_State *L);

/* The module `archard.settings`: lists all settings of definitions and all columns of the
 * history. */
int luaopen_archard_settings(lua_State *L);

#endif

/* Registers all classes and functions in the module `archard` and as globals. Each class has its
 * own file. archard.h describes how to add a class. */
#include "lua/base/archard.h"

#include "archard/base.h"
#include "lua/engine/classes.h"
#include "lua/base/scripts.h"
#include "lua/base/strict.h"

#include <lauxlib.h>

/* List of the classes written in C: the name of each global, and the function that pushes its
 * value. */
static const luaL_Reg classes[] = {
    {"material", luaopen_archard_material},
    {"hertz", luaopen_archard_hertz},
    {"model", luaopen_archard_model},
    {"contact", luaopen_archard_contact},
    {"body", luaopen_archard_body},
    {"wear", luaopen_archard_wear},
    {NULL, NULL},
};

/* List of the modules written in C that define no global. Scripts load these modules by require. */
static const luaL_Reg modules[] = {
    {"archard.term", luaopen_archard_term},
    {"archard.gnuplot", luaopen_archard_gnuplot},
    {"archard.store", luaopen_archard_store},
    {"archard.process", luaopen_archard_process},
    {"archard.warnings", luaopen_archard_warnings},
    {"archard.names", luaopen_archard_names},
    {"archard.settings", luaopen_archard_settings},
    {"archard.measure", luaopen_archard_measure},
    {"archard.files", luaopen_archard_files},
    {"archard.random", luaopen_archard_random},
    {"archard.least_squares", luaopen_archard_least_squares},
    {"archard.sphere", luaopen_archard_sphere},
    {"archard.strict", luaopen_archard_strict},
    {"archard.contact_record", luaopen_archard_contact_record},
    {NULL, NULL},
};

#define DISTRIBUTIONS "archard.uncertainty.distributions"

/* List of the classes written in Lua: the name of each global, and the module in scripts/ that
 * returns its value. */
static const char *const scripted[][2] = {
    {"help", "archard.help"},         {"plot", "archard.plot"},
    {"study", "archard.study"},       {"fit", "archard.fit"},
    {"csv", "archard.lib.csv"},       {"profile", "archard.profile"},
    {"export", "archard.export"},     {"who", "archard.session.who"},
    {"session", "archard.session"},   {"examples", "archard.session.examples"},
    {"map", "archard.map"},           {"gait", "archard.joint.gait"},
    {"joint", "archard.joint.joint"},
};
enum { SCRIPTED = sizeof scripted / sizeof *scripted };

/* List of the functions written in Lua, which are loaded at their first call: the name of the
 * global, the module, and the field of the module (NULL: the module itself is the function). */
static const char *const functions[][3] = {
    {"calibrate", "archard.study.calibrate"},  {"time", "archard.lib.time"},
    {"uniform", DISTRIBUTIONS, "uniform"},     {"normal", DISTRIBUTIONS, "normal"},
    {"lognormal", DISTRIBUTIONS, "lognormal"},
};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* Pops a value and stores it in three tables: as field `name` of the module table below it, as a
 * global of the user, and as a global of the built-in scripts. */
static void publish(lua_State *L, const char *name) {
  if (lua_istable(L, -1)) strict_module(L, name);
  lua_pushvalue(L, -1);
  lua_setglobal(L, name);
  lua_pushvalue(L, -1);
  script_set_global(L, name);
  lua_setfield(L, -2, name);
}

static void open_classes(lua_State *L) {
  for (const luaL_Reg *class = classes; class->name; class ++) {
    lua_pushcfunction(L, class->func);
    lua_pushstring(L, class->name);
    lua_call(L, 1, 1);
    publish(L, class->name);
  }
}

static void open_scripted(lua_State *L) {
  for (int i = 0; i < SCRIPTED; i++) {
    script_require(L, scripted[i][1]);
    publish(L, scripted[i][0]);
  }
}

static void open_functions(lua_State *L) {
  for (int i = 0; i < FUNCTIONS; i++) {
    script_require(L, "archard.lib.lazy");
    lua_pushstring(L, functions[i][1]);
    lua_pushstring(L, functions[i][2]);
    lua_call(L, 2, 1);
    publish(L, functions[i][0]);
  }
}

int luaopen_archard(lua_State *L) {
  luaL_checkversion(L);
  arc_single_threaded();
  lua_warning(L, "@on", 0); /* enables warnings, which standard Lua disables by default */
  script_preload(L, modules);
  lua_newtable(L);
  lua_pushliteral(L, ARC_VERSION);
  lua_setfield(L, -2, "version");

  /* The module is registered before the classes are opened, because the scripts of some classes
   * require "archard". */
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_pushvalue(L, -2);
  lua_setfield(L, -2, "archard");
  lua_pop(L, 1);
  lua_pushvalue(L, -1);
  script_set_module(L, "archard");

  open_classes(L);
  open_scripted(L);
  open_functions(L);
  strict_module(L, "archard");
  return 1;
}

/* Methods of the class wear that are written in Lua. Each method loads a module of scripts/,
 * which returns a function, and calls this function with the object and the other arguments. */
#include "lua/base/scripts.h"
#include "lua/wear/wear_class.h"

static int call_module(lua_State *L, const char *module) {
  const int given = lua_gettop(L);
  script_require(L, module);
  lua_insert(L, 1);
  lua_call(L, given, 1);
  return 1;
}

/* wear:sensitivity{ of=, to= } returns the sensitivities of the results that `of` names to the
 * numbers of the definition that `to` names. */
int wear_sensitivity(lua_State *L) {
  wear_self(L, "wear:sensitivity");
  return call_module(L, "archard.uncertainty.sensitivity");
}

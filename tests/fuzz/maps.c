/* Fuzz target for map.read with files of all formats, with and without repair and levelling of the
 * map, and for gait.read. */
#include "in_lua.h"

static const char script[] =
    "local map, gait = require'archard.map.read', require'archard.joint.gait'\n" IN_LUA_READ
    "local function maps(given) return read(function(path) return map.read(path, given) end) end\n"
    "return { maps{ unit = 'um' }, maps{ unit = 'um', fill = true, outliers = 3, level = 'plane' "
    "},\n"
    "  maps{ unit = 'um', step = 1e-3, fill = 0 }, read(function(path) return gait.read(path) end) "
    "}\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  in_lua_call(in_lua_state(script), 4, data, size, ".map");
  return 0;
}

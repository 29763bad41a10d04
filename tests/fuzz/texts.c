/* Fuzz target for text input: csv.read, profile.read, and the completion and compilation of chunks
 * at the prompt. Completion and compilation must never fail. */
#include "in_lua.h"

static const char script[] =
    "local csv, complete, prompt = require'archard.lib.csv', require'archard.session.complete',\n"
    "  require'archard.lib.prompt'\n"
    "local profile = require'archard.profile'\n" IN_LUA_READ
    "return { read(csv.read), read(function(path) return profile.read(path, { level = 'line' }) "
    "end),\n"
    "  function(_, text) complete.words(text) end,\n"
    "  function(_, text) prompt.compile(text, '=fuzz', 1) end }\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  in_lua_call(in_lua_state(script), 4, data, size, ".csv");
  return 0;
}

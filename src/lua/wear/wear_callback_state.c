/* Implements the state object, which is the argument of the user's functions. The object reads the
 * present record. It is reused for every call, and cannot be read after the call. */
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/wear/wear_class.h"
#include "lua/wear/wear_functions.h"

static const char kind[] = "archard.state";

enum { DEPTH = ARC_WEAR_COLUMN_COUNT, VOLUME };

#define COLUMN_FIELD(name, unit, range, rule, text) ARGS_OTHER(#name),
static const arc_setting known[] = {
    ARC_WEAR_COLUMNS(COLUMN_FIELD) ARGS_OTHER("depth"), ARGS_OTHER("volume"), {.name = NULL}};

/* Returns the state at index 1. Also checks the size, because a script may have set the
 * metatable of states on another userdata. */
static const callback_state *place_of(lua_State *L) {
  const callback_state *state = luaL_checkudata(L, 1, kind);
  luaL_argexpected(L, lua_rawlen(L, 1) == sizeof *state, 1, kind);
  return state;
}

static const callback_state *self(lua_State *L) {
  const callback_state *state = place_of(L);
  if (!state->record)
    error_raise(L, ARC_ARGUMENT, "state",
                "the state is readable only during the call of your function; copy the numbers "
                "that you need");
  return state;
}

static void push_volume(lua_State *L, const callback_state *state) {
  const arc_wear_record *record = state->record;
  push_by_body(L, state->pair, record->volume_cylinder, record->volume_plate, "state.volume");
  array_set_number(L, "total", record->volume_cylinder + record->volume_plate);
}

/* Metamethod __index: returns state.NAME. Upvalue: table that maps names to the numbers of
 * columns. */
static int state_index(lua_State *L) {
  const callback_state *state = self(L);
  const arc_wear_record *record = state->record;
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNUMBER)
    args_unknown(L, (args_location){"state", ""}, known, luaL_tolstring(L, 2, NULL));
  const int column = (int)lua_tointeger(L, -1);
  if (column == DEPTH)
    push_by_body(L, state->pair, record->depth_cylinder, record->depth_plate, "state.depth");
  else if (column == VOLUME)
    push_volume(L, state);
  else
    lua_pushnumber(L, arc_wear_record_get(record, column));
  return 1;
}

static int state_newindex(lua_State *L) {
  error_raise(L, ARC_ARGUMENT, "state", "field '%s' cannot be set: the state is read-only",
              luaL_tolstring(L, 2, NULL));
}

static int state_tostring(lua_State *L) {
  const callback_state *state = place_of(L);
  if (state->record)
    record_push_line(L, state->record);
  else
    lua_pushliteral(L, "state (not readable after the call)");
  return 1;
}

/* Pushes a table that maps names to the numbers of columns. */
static void push_columns(lua_State *L) {
  lua_createtable(L, 0, ARC_WEAR_COLUMN_COUNT + 2);
  for (int column = 0; known[column].name; column++) {
    lua_pushinteger(L, column);
    lua_setfield(L, -2, known[column].name);
  }
}

static void push_metatable(lua_State *L) {
  static const luaL_Reg events[] = {
      {"__newindex", state_newindex}, {"__tostring", state_tostring}, {NULL, NULL}};
  if (!luaL_newmetatable(L, kind)) return;
  luaL_setfuncs(L, events, 0);
  push_columns(L);
  lua_pushcclosure(L, state_index, 1);
  lua_setfield(L, -2, "__index");
}

callback_state *state_push(lua_State *L) {
  callback_state *state = lua_newuserdatauv(L, sizeof *state, 0);
  *state = (callback_state){NULL, NULL};
  push_metatable(L);
  lua_setmetatable(L, -2);
  return state;
}

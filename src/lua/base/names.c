/* Formats values for messages and searches for the most similar valid name. C code calls the
 * functions directly; scripts use the module `archard.names`, which can also raise errors. */
#include "lua/base/names.h"
#include "lua/base/archard.h"
#include "lua/base/error.h"

#include <lauxlib.h>
#include <math.h>
#include <string.h>
#include <strings.h>

/* --- search for the most similar valid name --------------------------------------------------- */

enum { LONGEST = 31 };

static int least(int a, int b, int c) {
  int low = a < b ? a : b;
  return low < c ? low : c;
}

/* Returns the edit distance of two names: the smallest number of letters to change, insert, delete
 * or swap. Returns LONGEST if a name has more than LONGEST letters. */
static int distance_of(const char *a, const char *b) {
  int la = (int)strlen(a), lb = (int)strlen(b), cost[LONGEST + 1][LONGEST + 1];
  if (la > LONGEST || lb > LONGEST) return LONGEST;
  for (int i = 0; i <= la; i++) cost[i][0] = i;
  for (int j = 0; j <= lb; j++) cost[0][j] = j;
  for (int i = 1; i <= la; i++)
    for (int j = 1; j <= lb; j++) {
      int change = cost[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
      cost[i][j] = least(cost[i - 1][j] + 1, cost[i][j - 1] + 1, change);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost[i][j] = least(cost[i][j], cost[i - 2][j - 2] + 1, cost[i][j]);
    }
  return cost[la][lb];
}

/* Symbols and terms of textbooks and other programs: the term, a valid name that it corresponds to,
 * and their relation. */
static const char *const meanings[][3] = {
    {"mu", "friction", ""},
    {"R", "radius", ""},
    {"r", "radius", ""},
    {"diameter", "radius", ", half of the diameter"},
    {"diameter", "flat", ", the diameter of a pin minus twice the radius of its edge"},
    {"width", "flat", ", the width without the rounded edges"},
    {"depth", "depth_plate", ""},
    {"h_plate", "depth_plate", ""},
    {"h_cylinder", "depth_cylinder", ""},
    {"pressure", "p_center", ""},
    {"P", "load", ""},
    {"F", "load", ""},
    {"L", "load", ""},
    {"force", "load", ""},
    {"N", "cycles", ""},
    {"Q", "tangential", ""},
    {"v", "nu", ""},
    {"poisson", "nu", ""},
    {"young", "E", ""},
    {"e", "E", ""},
    {"s", "stroke", ""},
    {"amplitude", "stroke", ", twice the amplitude"},
    {"d", "distance", ""},
    {"looks", "snapshots", ""},
    {"cores", "workers", ""},
    {"threads", "workers", ""},
    {"color", "colour", ""},
    {"speed", "distance", ", speed times time"},
    {"velocity", "distance", ", speed times time"},
    {"time", "cycles", ", frequency times time"},
    {"frequency", "cycles", ", frequency times time"},
    {"xlim", "xrange", ""},
    {"ylim", "yrange", ""},
    {"filename", "file", ""},
    {"coating", "layers", ""},
    {"coating", "model", ", whose bodies have layers"},
    {"layers", "model", ", whose bodies have layers"},
};

/* Returns the relation of a term to the valid name `known`; NULL if it has another meaning. */
static const char *relation_of(const char *term, const char *known) {
  for (size_t i = 0; i < sizeof meanings / sizeof *meanings; i++)
    if (strcmp(term, meanings[i][0]) == 0 && strcmp(known, meanings[i][1]) == 0)
      return meanings[i][2];
  return strncmp(term, "k_", 2) == 0 && strcmp(known, "k_cylinder") == 0 ? "" : NULL;
}

const char *names_relation(const names_search *search) {
  const char *relation = relation_of(search->name, search->best);
  return relation ? relation : "";
}

names_search names_begin(const char *name) {
  const size_t length = strlen(name);
  return (names_search){name, NULL, length > LONGEST || length < 2 ? 0 : 1 + (int)length / 4};
}

void names_offer(names_search *search, const char *known) {
  if (search->limit < 0) return; /* a name with this meaning was offered before */
  if (relation_of(search->name, known) || strcasecmp(known, search->name) == 0) {
    search->best = known;
    search->limit = -1;
  }
  int distance = distance_of(search->name, known);
  if (distance > search->limit) return;
  if (search->best && distance == search->limit && strcmp(known, search->best) >= 0) return;
  search->best = known;
  search->limit = distance;
}

/* nearest(name, list of valid names) returns the most similar name and the text of names_relation,
 * or nil if no name is similar. */
static int names_nearest(lua_State *L) {
  names_search search = names_begin(luaL_checkstring(L, 1));
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  /* The list keeps the texts alive, so that they may be popped before the search ends. */
  for (lua_Integer i = 1; lua_rawgeti(L, 2, i) == LUA_TSTRING; i++) {
    names_offer(&search, lua_tostring(L, -1));
    lua_pop(L, 1);
  }
  lua_pushstring(L, search.best); /* pushes nil if `best` is NULL */
  lua_pushstring(L, search.best ? names_relation(&search) : "");
  return 2;
}

/* --- values ----------------------------------------------------------------------------------- */

/* Writes zero bytes as \0, because a zero byte would end a C string. */
const char *names_push_text(lua_State *L, int index) {
  size_t length;
  const char *text = lua_tolstring(L, index, &length);
  luaL_Buffer shown;
  luaL_buffinit(L, &shown);
  for (size_t i = 0; i < length; i++) {
    if (text[i])
      luaL_addchar(&shown, text[i]);
    else
      luaL_addstring(&shown, "\\0");
  }
  luaL_pushresult(&shown);
  return lua_tostring(L, -1);
}

/* Pushes a string in quotes. If the string has more than 200 bytes, pushes only the start of its
 * first line, and its length. */
static const char *push_quoted(lua_State *L, int index) {
  enum { most = 200 };
  size_t length, shown;
  const char *text = lua_tolstring(L, index, &length);
  for (shown = 0; shown < length && shown < most && text[shown] != '\n'; shown++) continue;
  if (length <= most) return lua_pushfstring(L, "\"%s\"", names_push_text(L, index));
  while (shown > 0 && ((unsigned char)text[shown] & 0xC0) == 0x80) shown--; /* full character */
  lua_pushlstring(L, text, shown);
  return lua_pushfstring(L, "\"%s...\" (%d characters)", names_push_text(L, -1), (int)length);
}

const char *names_push_shown(lua_State *L, int index) {
  switch (lua_type(L, index)) {
  case LUA_TNUMBER:
    if (isnan(lua_tonumber(L, index))) return lua_pushliteral(L, "nan");
    return luaL_tolstring(L, index, NULL);
  case LUA_TSTRING:
    return push_quoted(L, index);
  case LUA_TBOOLEAN:
    return lua_pushstring(L, lua_toboolean(L, index) ? "true" : "false");
  default:
    break;
  }
  if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) {
    const char *class = lua_tostring(L, -1);
    return lua_pushfstring(L, "a %s object", class + (strncmp(class, "archard.", 8) == 0 ? 8 : 0));
  }
  return lua_pushfstring(L, lua_isnil(L, index) ? "%s" : "a %s", luaL_typename(L, index));
}

/* shown(value) returns a description such as 3, "text", "a wear object", "a table". */
static int names_shown(lua_State *L) {
  lua_settop(L, 1);
  names_push_shown(L, 1);
  return 1;
}

/* plain(text) returns the text with control characters written as \xNN. */
static int names_plain(lua_State *L) {
  luaL_checkstring(L, 1);
  error_push_plain(L, names_push_text(L, 1));
  return 1;
}

/* --- errors ----------------------------------------------------------------------------------- */

/* raise(where, status, message) raises an error object. `status` is a name such as "ARGUMENT". */
static int names_raise(lua_State *L) {
  const char *where = luaL_checkstring(L, 1), *name = luaL_checkstring(L, 2);
  const char *message = luaL_checkstring(L, 3);
#define RAISE_IF_NAMED(status, value, text)                                                        \
  if (strcmp(name, #status) == 0) error_raise(L, ARC_##status, where, "%s", message);
  ARC_STATUS_LIST(RAISE_IF_NAMED)
#undef RAISE_IF_NAMED
  return luaL_error(L, "unknown status '%s'", name);
}

int luaopen_archard_names(lua_State *L) {
  static const luaL_Reg functions[] = {{"nearest", names_nearest},
                                       {"shown", names_shown},
                                       {"plain", names_plain},
                                       {"raise", names_raise},
                                       {NULL, NULL}};
  luaL_newlib(L, functions);
  return 1;
}

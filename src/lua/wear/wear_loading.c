/* Reads the field `loading` of a run: blocks with the motion of the lower body and the load over a
 * cycle. These quantities are functions of t or arrays, and the load may also be a number. All are
 * sampled in this file. */
#include "archard/measure.h"
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/wear/wear_class.h"

#include <stdio.h>
#include <string.h>

typedef struct block_def {
  int increments; /* 0: not set */
  double cycles;  /* 0: not set */
} block_def;

static const arc_setting definition[] = {
    {.name = "increments",
     .kind = ARC_WHOLE,
     .offset = offsetof(block_def, increments),
     .low = 1,
     .high = 1e6},
    ARGS_ABOVE_0(block_def, cycles),
    ARGS_OTHER("t"),
    ARGS_OTHER("x"),
    ARGS_OTHER("load"),
    ARGS_OTHER("tangential"),
    ARGS_OTHER("rotation"),
    ARGS_OTHER("load_angle"),
    ARGS_OTHER("periodic"),
    {.name = NULL},
};

/* State of reading a block, whose buffers are on the stack. */
typedef struct reading {
  lua_State *L;
  int table; /* stack index of the block's table */
  args_location location;
  size_t given, count;    /* number of time points of the user's arrays, and of sampled times */
  const double *from, *t; /* time points (0 to 1) of the user's arrays, and sampled times */
} reading;

enum { usual_increments = 100, most_blocks = 1000000 };

/* --- times ------------------------------------------------------------------------------------ */

static const double *push_uniform(lua_State *L, size_t count) {
  double *t = array_buffer(L, count);
  for (size_t i = 0; i < count; i++) t[i] = (double)i / (double)(count - 1);
  return t;
}

/* Pushes the field `t`, scaled to the range 0 to 1. */
static const double *push_times(const reading *r, size_t *count) {
  lua_State *L = r->L;
  double *t = array_read(L, r->location, "t", count);
  if (*count < 2)
    error_raise(L, ARC_ARGUMENT, r->location.where,
                "field '%st': expected at least 2 points in time, got %d", r->location.prefix,
                (int)*count);
  for (size_t i = 1; i < *count; i++)
    if (!(t[i] > t[i - 1]))
      error_raise(L, ARC_ARGUMENT, r->location.where,
                  "field '%st[%d]': expected increasing times, got %s after %s", r->location.prefix,
                  (int)i + 1, args_show_number(L, t[i]), args_show_number(L, t[i - 1]));
  const double start = t[0], length = t[*count - 1] - start;
  for (size_t i = 0; i < *count; i++) t[i] = (t[i] - start) / length;
  return t;
}

/* Returns the length of the array in the field `name`, or 0 if the field is not a table. */
static size_t values_in(const reading *r, const char *name) {
  lua_State *L = r->L;
  size_t length = 0;
  if (lua_getfield(L, r->table, name) == LUA_TTABLE)
    length = array_length(L, r->location, name, ARRAY_MOST);
  lua_pop(L, 1);
  return length;
}

/* Sets the sampled times of the block. With the field `increments` they are uniform. Otherwise they
 * are the times `t`. Without `t` they are uniform: one for each value of the user's arrays, or 100
 * increments if there are only functions. */
static void find_times(reading *r, int increments) {
  lua_State *L = r->L;
  static const char *const lists[] = {"x", "tangential", "rotation", "load", "load_angle", NULL};
  size_t values = 0;
  for (int i = 0; lists[i] && values == 0; i++) values = values_in(r, lists[i]);
  const int timed = lua_getfield(L, r->table, "t") != LUA_TNIL;
  if (timed)
    r->from = push_times(r, &r->given);
  else if (values > 1)
    r->from = push_uniform(L, r->given = values);
  if (timed && increments > 0 && !values)
    error_raise(L, ARC_ARGUMENT, r->location.where,
                "fields '%st' and '%sincrements': expected one of them if x and load are "
                "functions, got both",
                r->location.prefix, r->location.prefix);
  r->count = r->given;
  r->t = r->from;
  if (r->given > 0 && increments == 0) return;
  r->count = (size_t)(increments > 0 ? increments : usual_increments) + 1;
  r->t = push_uniform(L, r->count);
}

/* --- values ----------------------------------------------------------------------------------- */

static void sample_array(const reading *r, const char *name, double *value) {
  lua_State *L = r->L;
  size_t count;
  const double *given = array_read(L, r->location, name, &count);
  if (count != r->given || count < 2)
    error_raise(
        L, ARC_ARGUMENT, r->location.where,
        "field '%s%s': expected %d numbers (at least 2), one for each point in time; got %d",
        r->location.prefix, name, (int)r->given, (int)count);
  for (size_t i = 0; i < r->count; i++)
    value[i] = r->t == r->from ? given[i]
                               : arc_measure_interpolate(r->from, given, count, r->t[i], given[0]);
}

/* Calls the function on top of the stack for each sampled time. */
static void sample_function(const reading *r, const char *name, double *value) {
  lua_State *L = r->L;
  char call[80];
  for (size_t i = 0; i < r->count; i++) {
    snprintf(call, sizeof call, "%s%s(%.6g)", r->location.prefix, name, r->t[i]);
    lua_pushvalue(L, -1);
    lua_pushnumber(L, r->t[i]);
    if (error_pcall(L, 1, 1) != LUA_OK) error_callback(L, r->location.where, call);
    value[i] = lua_tonumber(L, -1);
    if (lua_type(L, -1) != LUA_TNUMBER || !isfinite(value[i]))
      error_raise(L, ARC_CALLBACK, r->location.where, "%s: expected a finite number, got %s", call,
                  names_push_shown(L, -1));
    lua_pop(L, 1);
  }
}

/* Samples the field `name` at the block's times into a buffer, which is appended to the list at
 * `holder`. A number applies to all times. If the field is nil, all values are `constant`. If
 * `constant` is NaN, a number or nil raises an error. */
static const double *sample(const reading *r, int holder, const char *name, double constant) {
  lua_State *L = r->L;
  const int top = lua_gettop(L);
  double *value = array_buffer(L, r->count);
  lua_rawseti(L, holder, (lua_Integer)lua_rawlen(L, holder) + 1);
  int type = lua_getfield(L, r->table, name);
  if (type == LUA_TFUNCTION)
    sample_function(r, name, value);
  else if (type == LUA_TTABLE)
    sample_array(r, name, value);
  else if (!isnan(constant) && (type == LUA_TNUMBER || type == LUA_TNIL))
    for (size_t i = 0; i < r->count; i++)
      value[i] = type == LUA_TNUMBER ? lua_tonumber(L, -1) : constant;
  else
    args_refuse(L, r->location, name,
                isnan(constant) ? "a function of t or an array"
                                : "a number, a function of t or an array");
  lua_settop(L, top);
  return value;
}

/* Returns a buffer of zeros, which is appended to the list at `holder`. */
static const double *still(const reading *r, int holder) {
  double *value = array_buffer(r->L, r->count);
  memset(value, 0, r->count * sizeof *value);
  lua_rawseti(r->L, holder, (lua_Integer)lua_rawlen(r->L, holder) + 1);
  return value;
}

/* --- blocks ----------------------------------------------------------------------------------- */

static int read_periodic(const reading *r) {
  lua_State *L = r->L;
  int type = lua_getfield(L, r->table, "periodic");
  if (type != LUA_TNIL && type != LUA_TBOOLEAN)
    args_refuse(L, r->location, "periodic", "true or false");
  int periodic = type == LUA_TNIL || lua_toboolean(L, -1);
  lua_pop(L, 1);
  return periodic;
}

/* Returns the name of the field that drives the lower body: x, tangential or rotation. If the
 * block has none of these fields, returns "rotation" for a rotating load (load_angle), otherwise
 * "x". */
static const char *drive_of(const reading *r) {
  static const char *const drives[] = {"x", "tangential", "rotation", NULL};
  const char *found = NULL;
  for (int i = 0; drives[i]; i++) {
    if (!args_given(r->L, r->table, drives[i])) continue;
    if (found)
      error_raise(r->L, ARC_ARGUMENT, r->location.where,
                  "fields '%s%s' and '%s%s': expected one of them, got both", r->location.prefix,
                  found, r->location.prefix, drives[i]);
    found = drives[i];
  }
  return found ? found : drives[args_given(r->L, r->table, "load_angle") ? 2 : 0];
}

/* Warns if the motion does not end where it begins, although the cycle repeats. */
static void warn_open(const reading *r, const char *drive, const double *motion) {
  static const double noise = 0.01; /* of the range of the motion, accepted in measured cycles */
  char text[300];
  const double first = motion[0], last = motion[r->count - 1];
  double low = first, high = first;
  for (size_t i = 0; i < r->count; i++) low = fmin(low, motion[i]), high = fmax(high, motion[i]);
  if (!(fabs(last - first) > noise * (high - low))) return;
  snprintf(text, sizeof text,
           "%s: %s%s begins at %.6g and ends at %.6g: the jump back to the start of the next cycle "
           "causes no wear. Close the cycle, as math.sin(2 * math.pi * t) does, or set periodic = "
           "false for a single history",
           r->location.where, r->location.prefix, drive, first, last);
  lua_warning(r->L, text, 0);
}

/* Reads the block on top of the stack. */
static arc_loading read_block(lua_State *L, int holder, args_location location, double load) {
  const int top = lua_gettop(L);
  block_def def = {0};
  reading r = {.L = L, .table = top, .location = location};
  luaL_checkstack(L, 20, location.where);
  if (!lua_istable(L, top)) args_refuse(L, location, "", "a table { x=, load=, ... }");
  args_read(L, top, location, definition, &def);
  find_times(&r, def.increments);
  arc_loading block = {.count = (int)r.count, .periodic = read_periodic(&r)};
  const char *drive = drive_of(&r);
  const int by_x = strcmp(drive, "x") == 0, turns = strcmp(drive, "rotation") == 0;
  const double *driven = sample(&r, holder, drive, NAN);
  if (block.periodic && strcmp(drive, "tangential") != 0) warn_open(&r, drive, driven);
  block.x = by_x ? driven : still(&r, holder);
  if (turns) block.rotation = driven;
  if (!turns && !by_x) block.tangential = driven;
  block.load = sample(&r, holder, "load", load);
  if (args_given(L, top, "load_angle")) block.load_angle = sample(&r, holder, "load_angle", 0);
  block.cycles = def.cycles > 0 ? def.cycles : block.periodic ? (double)INFINITY : 1;
  lua_settop(L, top);
  return block;
}

/* Returns true if the table at `index` is a list of blocks, false if it is a block. */
static int is_list(lua_State *L, int index) {
  int list = lua_rawgeti(L, index, 1) != LUA_TNIL;
  lua_pop(L, 1);
  return list;
}

double loading_largest(const arc_wear_def *def) {
  double largest = 0;
  for (int b = 0; b < def->blocks; b++)
    for (int i = 0; i < def->loading[b].count; i++)
      largest = fmax(largest, def->loading[b].load[i]);
  return largest;
}

int loading_read(lua_State *L, int index, args_location location, arc_wear_def *def) {
  int type = args_get(L, index, "loading");
  if (type == LUA_TBOOLEAN && !lua_toboolean(L, -1)) def->blocks = 0;
  if (type == LUA_TNIL || (type == LUA_TBOOLEAN && !lua_toboolean(L, -1))) return 0;
  if (type != LUA_TTABLE)
    args_refuse(L, location, "loading",
                type == LUA_TUSERDATA
                    ? "a block { x=, load= } or a list of blocks (a gait needs model = joint{})"
                    : "a block { x=, load= } or a list of blocks");
  const int loading = lua_gettop(L), list = is_list(L, loading);
  const int count = list ? (int)array_length(L, location, "loading", most_blocks) : 1;
  lua_newtable(L);
  const int holder = lua_gettop(L);
  arc_loading *blocks = lua_newuserdatauv(L, (size_t)count * sizeof *blocks, 0);
  for (int b = 0; b < count; b++) {
    char prefix[40] = "loading.";
    if (list) {
      lua_rawgeti(L, loading, b + 1);
      snprintf(prefix, sizeof prefix, "loading[%d].", b + 1);
    } else {
      lua_pushvalue(L, loading);
    }
    blocks[b] = read_block(L, holder, (args_location){location.where, prefix}, def->load);
    lua_pop(L, 1);
  }
  def->blocks = count;
  def->loading = blocks;
  return 1;
}

void loading_push(lua_State *L, const arc_wear_def *def) {
  lua_createtable(L, def->blocks, 0);
  for (int b = 0; b < def->blocks; b++) {
    const arc_loading *block = &def->loading[b];
    lua_createtable(L, 0, 4);
    const double *driven = block->tangential ? block->tangential
                           : block->rotation ? block->rotation
                                             : block->x;
    const char *drive = block->tangential ? "tangential" : block->rotation ? "rotation" : "x";
    array_set(L, drive, driven, (size_t)block->count);
    if (block->load_angle) array_set(L, "load_angle", block->load_angle, (size_t)block->count);
    array_set(L, "load", block->load, (size_t)block->count);
    if (isfinite(block->cycles)) {
      array_set_number(L, "cycles", block->cycles);
    }
    lua_pushboolean(L, block->periodic);
    lua_setfield(L, -2, "periodic");
    lua_rawseti(L, -2, b + 1);
  }
}

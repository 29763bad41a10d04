/* Module `archard.gnuplot`: passes figures, which are Lua tables, to the plot layer
 * (archard/plot.h). scripts/plot/init.lua is the user's interface and checks the arguments; the
 * checks in this file only prevent crashes. All arrays of a figure are userdata in one table, which
 * is alive during the call, so that Lua errors leak nothing. */
#include "lua/base/archard.h"
#include "lua/base/array_read.h"
#include "lua/base/interrupt.h"

#include "plot/plot.h"

#include <lauxlib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char session_name[] = "archard.gnuplot session";

#define WORD(name, text) text,
static const char *const styles[] = {ARC_PLOT_STYLE_LIST(WORD) NULL};
static const char *const keys[] = {ARC_PLOT_KEY_LIST(WORD) NULL};

enum { MOST_PARTS = 100000 }; /* largest number of figures, panels or curves */

/* State of reading a figure: the table that keeps memory alive, and the numbers of the present
 * panel and curve for messages. */
typedef struct reader {
  lua_State *L;
  int anchors; /* stack index of the table that keeps memory and strings alive */
  size_t panel, curve;
} reader;

/* Allocates zeroed memory that is valid during the call. */
static void *anchored(reader *r, size_t count, size_t size) {
  void *memory = lua_newuserdatauv(r->L, count ? count * size : 1, 0);
  memset(memory, 0, count * size);
  lua_rawseti(r->L, r->anchors, (lua_Integer)lua_rawlen(r->L, r->anchors) + 1);
  return memory;
}

/* --- simple fields of the table on top of the stack ------------------------------------------- */

static const char *read_string(reader *r, const char *name) {
  const char *text = NULL;
  if (lua_getfield(r->L, -1, name) != LUA_TNIL) {
    text = lua_tostring(r->L, -1);
    if (!text) luaL_error(r->L, "%s must be a string, got %s", name, luaL_typename(r->L, -1));
    lua_pushvalue(r->L, -1);
    lua_rawseti(r->L, r->anchors, (lua_Integer)lua_rawlen(r->L, r->anchors) + 1);
  }
  lua_pop(r->L, 1);
  return text;
}

static double read_number(reader *r, const char *name, double otherwise) {
  double value = otherwise;
  if (lua_getfield(r->L, -1, name) != LUA_TNIL) {
    if (lua_type(r->L, -1) != LUA_TNUMBER)
      luaL_error(r->L, "%s must be a number, got %s", name, luaL_typename(r->L, -1));
    value = lua_tonumber(r->L, -1);
  }
  lua_pop(r->L, 1);
  return value;
}

static int read_count(reader *r, const char *name) {
  double value = read_number(r, name, 0);
  if (!(value >= 0 && value <= 100000) || value != floor(value))
    luaL_error(r->L, "%s must be a whole number from 0 to 100000, got %f", name, value);
  return (int)value;
}

static int read_flag(reader *r, const char *name) {
  lua_getfield(r->L, -1, name);
  int flag = lua_toboolean(r->L, -1);
  lua_pop(r->L, 1);
  return flag;
}

/* Returns the index of the word in field `name` within the NULL-terminated list `choices`.
 * Returns 0 if the field is nil. */
static int read_choice(reader *r, const char *name, const char *const *choices) {
  const char *word = read_string(r, name);
  for (int i = 0; word && choices[i]; i++)
    if (strcmp(word, choices[i]) == 0) return i;
  if (word) luaL_error(r->L, "%s: unknown value '%s'", name, word);
  return 0;
}

/* --- columns ---------------------------------------------------------------------------------- */

static size_t length_of(reader *r, const char *name, size_t most) {
  return array_length(r->L, (args_location){"plot", ""}, name, most);
}

/* Reads the field `name`, a list of numbers, as an array. */
static double *read_column(reader *r, const char *name, size_t *count) {
  if (lua_getfield(r->L, -1, name) != LUA_TTABLE)
    luaL_error(r->L, "panel %d: curve %d: %s must be a list of numbers, got %s", (int)r->panel,
               (int)r->curve, name, luaL_typename(r->L, -1));
  *count = length_of(r, name, ARRAY_MOST);
  double *column = anchored(r, *count, sizeof *column);
  for (size_t i = 0; i < *count; i++) {
    if (lua_rawgeti(r->L, -1, (lua_Integer)i + 1) != LUA_TNUMBER)
      luaL_error(r->L, "panel %d: curve %d: %s[%d] must be a number, got %s", (int)r->panel,
                 (int)r->curve, name, (int)i + 1, luaL_typename(r->L, -1));
    column[i] = lua_tonumber(r->L, -1);
    lua_pop(r->L, 1);
  }
  lua_pop(r->L, 1);
  return column;
}

static void same_length(reader *r, const char *name, size_t count, size_t expected) {
  if (count != expected)
    luaL_error(r->L, "panel %d: curve %d: x has %d numbers, %s has %d: expected equal lengths",
               (int)r->panel, (int)r->curve, (int)expected, name, (int)count);
}

/* --- the parts of a figure, each read from the table on top of the stack ---------------------- */

static const double *read_error(reader *r, size_t expected) {
  size_t count;
  int given = lua_getfield(r->L, -1, "error") != LUA_TNIL;
  lua_pop(r->L, 1);
  if (!given) return NULL;
  const double *error = read_column(r, "error", &count);
  same_length(r, "error", count, expected);
  return error;
}

static void read_curve(reader *r, arc_plot_curve *curve) {
  size_t count;
  curve->x = read_column(r, "x", &curve->count);
  curve->y = read_column(r, "y", &count);
  same_length(r, "y", count, curve->count);
  curve->title = read_string(r, "title");
  curve->style = (arc_plot_style)read_choice(r, "style", styles);
  curve->colour = read_string(r, "colour");
  curve->series = read_count(r, "series");
  curve->dash = read_count(r, "dash");
  curve->width = read_number(r, "width", 0);
  curve->error = read_error(r, curve->count);
  curve->value = read_number(r, "value", NAN);
  curve->scaled = !isnan(curve->value);
  curve->labelled = read_flag(r, "labelled");
}

static const arc_plot_field *read_field(reader *r) {
  arc_plot_field *field = NULL;
  if (lua_getfield(r->L, -1, "field") == LUA_TTABLE) {
    size_t corners, count;
    r->curve = 0;
    field = anchored(r, 1, sizeof *field);
    field->x = read_column(r, "x", &corners);
    field->y = read_column(r, "y", &count);
    same_length(r, "y", count, corners);
    field->value = read_column(r, "value", &count);
    same_length(r, "value", count, corners);
    if (corners % 4 != 0)
      luaL_error(r->L, "field: expected a multiple of 4 corners, got %d", (int)corners);
    field->count = corners / 4;
  }
  lua_pop(r->L, 1);
  return field;
}

/* Reads the user's tick labels of the axis on top of the stack from the field places = { at = {
 * numbers }, words = { labels } }. */
static void read_places(reader *r, arc_plot_axis *axis) {
  if (lua_getfield(r->L, -1, "places") == LUA_TTABLE) {
    axis->places = read_column(r, "at", &axis->place_count);
    const char **words = anchored(r, axis->place_count, sizeof *words);
    axis->words = words;
    if (lua_getfield(r->L, -1, "words") != LUA_TTABLE) luaL_error(r->L, "axis without tick labels");
    for (size_t i = 0; i < axis->place_count; i++) {
      if (lua_rawgeti(r->L, -1, (lua_Integer)i + 1) != LUA_TSTRING)
        luaL_error(r->L, "axis: tick %d has no label", (int)i + 1);
      words[i] = lua_tostring(r->L, -1);
      lua_rawseti(r->L, r->anchors, (lua_Integer)lua_rawlen(r->L, r->anchors) + 1);
    }
    lua_pop(r->L, 1);
  }
  lua_pop(r->L, 1);
}

static arc_plot_axis read_axis(reader *r, const char *name) {
  arc_plot_axis axis = arc_plot_axis_default();
  if (lua_getfield(r->L, -1, name) == LUA_TTABLE) {
    axis.label = read_string(r, "label");
    axis.min = read_number(r, "min", NAN);
    axis.max = read_number(r, "max", NAN);
    axis.log = read_flag(r, "log");
    axis.reverse = read_flag(r, "reverse");
    read_places(r, &axis);
  }
  lua_pop(r->L, 1);
  return axis;
}

static void read_panel(reader *r, arc_plot_panel *panel) {
  *panel = arc_plot_panel_default();
  panel->title = read_string(r, "title");
  panel->x = read_axis(r, "x");
  panel->y = read_axis(r, "y");
  panel->value = read_axis(r, "value");
  panel->key = (arc_plot_key)read_choice(r, "key", keys);
  panel->equal = read_flag(r, "equal");
  panel->levels = read_count(r, "levels");
  panel->field = read_field(r);
  if (lua_getfield(r->L, -1, "curves") == LUA_TTABLE) {
    panel->curve_count = length_of(r, "curves", MOST_PARTS);
    arc_plot_curve *curves = anchored(r, panel->curve_count, sizeof *curves);
    panel->curves = curves;
    for (size_t i = 0; i < panel->curve_count; i++) {
      r->curve = i + 1;
      if (lua_rawgeti(r->L, -1, (lua_Integer)i + 1) != LUA_TTABLE)
        luaL_error(r->L, "panel %d: curve %d is not a table", (int)r->panel, (int)i + 1);
      read_curve(r, &curves[i]);
      lua_pop(r->L, 1);
    }
  }
  lua_pop(r->L, 1);
}

static void read_figure(reader *r, arc_plot_figure *figure) {
  luaL_checkstack(r->L, 20, "figure");
  figure->title = read_string(r, "title");
  figure->rows = read_count(r, "rows");
  figure->columns = read_count(r, "columns");
  figure->one_key = read_flag(r, "one_key");
  if (lua_getfield(r->L, -1, "panels") != LUA_TTABLE) luaL_error(r->L, "figure without panels");
  figure->panel_count = length_of(r, "panels", MOST_PARTS);
  arc_plot_panel *panels = anchored(r, figure->panel_count, sizeof *panels);
  figure->panels = panels;
  for (size_t i = 0; i < figure->panel_count; i++) {
    r->panel = i + 1;
    if (lua_rawgeti(r->L, -1, (lua_Integer)i + 1) != LUA_TTABLE)
      luaL_error(r->L, "panel %d is not a table", (int)i + 1);
    read_panel(r, &panels[i]);
    lua_pop(r->L, 1);
  }
  lua_pop(r->L, 1);
}

static arc_plot_output read_output(reader *r) {
  static const char *const media[] = {"text", "sixel", "png", "window", "file", NULL};
  arc_plot_output output = {.medium = (arc_plot_medium)read_choice(r, "medium", media)};
  output.file = read_string(r, "file");
  output.terminal = read_string(r, "terminal");
  output.width = read_count(r, "width");
  output.height = read_count(r, "height");
  output.colour = read_flag(r, "colour");
  output.ascii = read_flag(r, "ascii");
  output.grey = read_flag(r, "grey");
  output.fine = read_flag(r, "fine");
  output.dpi = read_number(r, "dpi", 0);
  output.points = read_number(r, "points", 0);
  output.lines = read_number(r, "lines", 0);
  output.family = read_string(r, "family");
  return output;
}

/* --- functions for Lua ------------------------------------------------------------------------ */

static arc_gnuplot *session_of(lua_State *L) {
  arc_gnuplot **box = lua_touserdata(L, lua_upvalueindex(1));
  if (!*box) luaL_error(L, "the plots of this session are closed");
  return *box;
}

/* Returns nil, the message and the name of the status, as functions of the io library do on
 * failure. */
static int failed(lua_State *L, const arc_error *error) {
  lua_pushnil(L);
  lua_pushstring(L, error->message);
  lua_pushstring(L, arc_status_name(error->status));
  return 3;
}

/* Pushes a picture as a string. The call is protected, so that the picture is freed if Lua runs out
 * of memory. */
static int push_picture(lua_State *L) {
  size_t length = (size_t)lua_tointeger(L, 2);
  const char *picture = lua_touserdata(L, 1);
  lua_pushlstring(L, picture, length);
  return 1;
}

static int hand_over(lua_State *L, char *picture, size_t length) {
  if (!picture) {
    lua_pushboolean(L, 1);
    return 1;
  }
  lua_pushcfunction(L, push_picture);
  lua_pushlightuserdata(L, picture);
  lua_pushinteger(L, (lua_Integer)length);
  int status = lua_pcall(L, 2, 1, 0);
  free(picture);
  return status == LUA_OK ? 1 : lua_error(L);
}

/* draw(figure, output) draws a figure and returns the picture, or true if there is none. On failure
 * it returns nil, message, status. */
static int gnuplot_draw(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  lua_newtable(L);
  reader r = {.L = L, .anchors = 3};
  arc_plot_figure figure = {.title = NULL};
  lua_pushvalue(L, 2);
  arc_plot_output output = read_output(&r);
  lua_pushvalue(L, 1);
  read_figure(&r, &figure);
  char *picture = NULL;
  size_t length = 0;
  arc_error error;
  if (arc_plot_draw(session_of(L), &figure, &output, &picture, &length, &error) != ARC_OK)
    return failed(L, &error);
  return hand_over(L, picture, length);
}

/* animate(figures, delay, output) writes an animation of the figures and returns true. On failure
 * it returns nil, message, status. */
static int gnuplot_animate(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  double delay = luaL_checknumber(L, 2);
  luaL_checktype(L, 3, LUA_TTABLE);
  lua_settop(L, 3);
  lua_newtable(L);
  reader r = {.L = L, .anchors = 4};
  lua_pushvalue(L, 3);
  arc_plot_output output = read_output(&r);
  lua_pushvalue(L, 1);
  const size_t count = length_of(&r, "figures", MOST_PARTS);
  arc_plot_figure *frames = anchored(&r, count, sizeof *frames);
  for (size_t i = 0; i < count; i++) {
    if (lua_rawgeti(L, -1, (lua_Integer)i + 1) != LUA_TTABLE)
      return luaL_error(L, "frame %d is not a table", (int)i + 1);
    read_figure(&r, &frames[i]);
    lua_pop(L, 1);
  }
  arc_error error;
  if (arc_plot_animate(session_of(L), frames, count, delay, &output, &error) != ARC_OK)
    return failed(L, &error);
  lua_pushboolean(L, 1);
  return 1;
}

/* about() returns gnuplot's version and terminals. On failure it returns nil, message, status. */
static int gnuplot_about(lua_State *L) {
  arc_gnuplot *session = session_of(L);
  arc_error error;
  if (arc_gnuplot_start(session, &error) != ARC_OK) return failed(L, &error);
  lua_pushnumber(L, arc_gnuplot_version(session));
  lua_pushstring(L, arc_gnuplot_terminals(session));
  return 2;
}

static void open_session(lua_State *L, arc_gnuplot **box, const char *program) {
  arc_gnuplot_def def = arc_gnuplot_default();
  arc_gnuplot *fresh = NULL;
  arc_error error;
  if (program && *program) def.program = program;
  def.should_stop = interrupt_pending;
  if (arc_gnuplot_open(&def, &fresh, &error) != ARC_OK) luaL_error(L, "%s", error.message);
  arc_gnuplot_close(box);
  *box = fresh;
}

/* use(program) opens a session with this gnuplot program and closes the old session. */
static int gnuplot_use(lua_State *L) {
  open_session(L, lua_touserdata(L, lua_upvalueindex(1)), luaL_checkstring(L, 1));
  return 0;
}

static int session_gc(lua_State *L) {
  arc_gnuplot_close(luaL_checkudata(L, 1, session_name));
  return 0;
}

/* Sets field `name` of the table on top of the stack to a list of words. */
static void set_words(lua_State *L, const char *name, const char *const *words) {
  lua_newtable(L);
  for (int i = 0; words[i]; i++) {
    lua_pushstring(L, words[i]);
    lua_rawseti(L, -2, i + 1);
  }
  lua_setfield(L, -2, name);
}

/* Pushes the functions and the lists of curve styles, key positions and file extensions. */
int luaopen_archard_gnuplot(lua_State *L) {
  static const luaL_Reg functions[] = {{"draw", gnuplot_draw},
                                       {"animate", gnuplot_animate},
                                       {"about", gnuplot_about},
                                       {"use", gnuplot_use},
                                       {NULL, NULL}};
  luaL_newlibtable(L, functions);
  arc_gnuplot **box = lua_newuserdatauv(L, sizeof *box, 0);
  *box = NULL;
  luaL_newmetatable(L, session_name);
  lua_pushcfunction(L, session_gc);
  lua_setfield(L, -2, "__gc");
  lua_setmetatable(L, -2);
  open_session(L, box, getenv("ARCHARD_GNUPLOT"));
  luaL_setfuncs(L, functions, 1);
  lua_pushliteral(L, ARC_PLOT_FILE_ENDINGS);
  lua_setfield(L, -2, "endings");
  set_words(L, "styles", styles);
  set_words(L, "keys", keys);
  return 1;
}

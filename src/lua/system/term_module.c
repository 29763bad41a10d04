/* Module `archard.term`: functions for scripts that return properties of the terminal. */
#include "lua/base/archard.h"
#include "lua/system/term_query.h"

#include <langinfo.h>
#include <lauxlib.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

static const char *const stream_names[] = {"stdin", "stdout", "stderr", NULL};

/* Returns the file descriptor of the stream that argument 1 names: "stdin", "stdout" (default) or
 * "stderr". */
static int check_stream(lua_State *L) {
  return luaL_checkoption(L, 1, "stdout", stream_names);
}

static int term_is_terminal(lua_State *L) {
  lua_pushboolean(L, isatty(check_stream(L)));
  return 1;
}

/* Returns the number in the environment variable `name`, or `otherwise` if the variable is not a
 * number from 1 to 9999. */
static int environment_number(const char *name, int otherwise) {
  const char *text = getenv(name);
  long number = text ? strtol(text, NULL, 10) : 0;
  return number > 0 && number < 10000 ? (int)number : otherwise;
}

/* size(stream) returns the columns and lines of the terminal. If the terminal does not report
 * them, returns the environment variables COLUMNS and LINES, or 80 and 24. */
static int term_size(lua_State *L) {
  struct winsize size = {0};
  int columns = 0, lines = 0;
  if (ioctl(check_stream(L), TIOCGWINSZ, &size) == 0) {
    columns = size.ws_col;
    lines = size.ws_row;
  }
  lua_pushinteger(L, columns > 0 ? columns : environment_number("COLUMNS", 80));
  lua_pushinteger(L, lines > 0 ? lines : environment_number("LINES", 24));
  return 2;
}

static int is_dumb(void) {
  const char *name = getenv("TERM");
  return name == NULL || *name == '\0' || strcmp(name, "dumb") == 0;
}

/* movable(stream) returns true if the cursor can be moved and lines can be redrawn. */
static int term_movable(lua_State *L) {
  lua_pushboolean(L, isatty(check_stream(L)) && !is_dumb());
  return 1;
}

static int term_colour(lua_State *L) {
  const char *no_color = getenv("NO_COLOR");
  int refused = no_color != NULL && *no_color != '\0';
  lua_pushboolean(L, isatty(check_stream(L)) && !is_dumb() && !refused);
  return 1;
}

/* utf8() returns true in a UTF-8 locale. The program calls setlocale(LC_CTYPE, "") at its start. */
static int term_utf8(lua_State *L) {
  lua_pushboolean(L, strcmp(nl_langinfo(CODESET), "UTF-8") == 0);
  return 1;
}

/* pixels() returns the width and height of the screen [pixels], or nothing if the terminal does not
 * report these. */
static int term_pixels(lua_State *L) {
  struct winsize size = {0};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_xpixel == 0 || size.ws_ypixel == 0)
    return 0;
  lua_pushinteger(L, size.ws_xpixel);
  lua_pushinteger(L, size.ws_ypixel);
  return 2;
}

/* pictures() returns the graphics protocol that the terminal reports, "kitty" or "sixel", or
 * nothing. */
static int term_pictures(lua_State *L) {
  if (is_dumb()) return 0;
  term_answer answer = term_query_graphics();
  if (!answer.kitty && !answer.sixel) return 0;
  lua_pushstring(L, answer.kitty ? "kitty" : "sixel");
  return 1;
}

/* clock() returns the seconds of a monotonic clock. */
static int term_clock(lua_State *L) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  lua_pushnumber(L, (lua_Number)now.tv_sec + (lua_Number)now.tv_nsec * 1e-9);
  return 1;
}

int luaopen_archard_term(lua_State *L) {
  static const luaL_Reg functions[] = {
      {"is_terminal", term_is_terminal}, {"size", term_size},         {"movable", term_movable},
      {"colour", term_colour},           {"utf8", term_utf8},         {"clock", term_clock},
      {"pixels", term_pixels},           {"pictures", term_pictures}, {NULL, NULL},
  };
  luaL_newlib(L, functions);
  return 1;
}

/* Pushes rows of a run's history as tables, as aligned lines of text, and as columns. */
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/base/strict.h"
#include "lua/wear/wear_class.h"

#include <math.h>
#include <stdio.h>

static const char kind[] = "archard.record";

static int record_tostring(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_getfield(L, 1, "text");
  return 1;
}

void record_push(lua_State *L, const arc_wear_record *record) {
  lua_createtable(L, 0, ARC_WEAR_COLUMN_COUNT + 1);
  lua_insert(L, -2);
  lua_setfield(L, -2, "text");
  for (int i = 0; i < ARC_WEAR_COLUMN_COUNT; i++) {
    array_set_number(L, arc_wear_column_name(i), arc_wear_record_get(record, i));
  }
  if (luaL_newmetatable(L, kind)) {
    lua_pushcfunction(L, record_tostring);
    lua_setfield(L, -2, "__tostring");
  }
  lua_setmetatable(L, -2);
  strict_module(L, "record");
}

/* Writes the depth partition factor (alpha-tilde), or "-" if there is no wear. */
static const char *show_partition(const arc_wear_record *record, char *text, size_t size) {
  if (isfinite(record->depth_partition))
    snprintf(text, size, "%5.3f", record->depth_partition);
  else
    snprintf(text, size, "-");
  return text;
}

/* Returns the number of decimals for printing a cycle number: 1 if an adaptive step ended within a
 * cycle, 0 for whole cycles and from cycle 1000 on. */
static int cycle_digits(double cycle) {
  return cycle == floor(cycle) || cycle >= 1000 ? 0 : 1;
}

void record_push_line(lua_State *L, const arc_wear_record *record) {
  char line[200], partition[20];
  snprintf(line, sizeof line,
           "cycle %5.*f %7.1f mm  p %5.1f MPa  h %5.3f %5.3f um  V %9.3e mm3  a~ %s",
           cycle_digits(record->cycle), record->cycle, record->distance, record->p_center,
           1e3 * record->depth_cylinder, 1e3 * record->depth_plate,
           record->volume_cylinder + record->volume_plate,
           show_partition(record, partition, sizeof partition));
  lua_pushstring(L, line);
}

static void add_row(luaL_Buffer *text, const arc_wear_record *record) {
  char line[200], partition[20];
  snprintf(line, sizeof line, "\n%7.6g %9.1f %9.2f %9.4f %8.4f %11.3e %10.3e %7s", record->cycle,
           record->distance, record->p_center, 1e3 * record->depth_cylinder,
           1e3 * record->depth_plate, record->volume_cylinder, record->volume_plate,
           show_partition(record, partition, sizeof partition));
  luaL_addstring(text, line);
}

/* Prints at most 20 rows at equal intervals, including the last row. */
void record_push_lines(lua_State *L, const arc_wear_record *records, size_t count) {
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  luaL_addstring(&text,
                 "  cycle  distance  p_center        depth [um]         volume [mm3]    alpha-\n"
                 "             [mm]     [MPa]  cylinder    plate    cylinder      plate   tilde");
  size_t every = (count + 19) / 20;
  for (size_t i = 0; i < count; i++)
    if ((count - 1 - i) % every == 0) add_row(&text, records + i);
  luaL_pushresult(&text);
}

void records_push_columns(lua_State *L, const arc_wear_record *records, size_t count) {
  lua_createtable(L, 0, ARC_WEAR_COLUMN_COUNT);
  for (int column = 0; column < ARC_WEAR_COLUMN_COUNT; column++) {
    lua_createtable(L, (int)count, 0);
    for (size_t i = 0; i < count; i++) {
      lua_pushnumber(L, arc_wear_record_get(records + i, column));
      lua_rawseti(L, -2, (lua_Integer)i + 1);
    }
    strict_table(L, "list of numbers");
    lua_setfield(L, -2, arc_wear_column_name(column));
  }
  strict_table(L, "history");
}

void history_push(lua_State *L, const arc_wear *wear) {
  size_t count;
  const arc_wear_record *records = arc_wear_history(wear, &count);
  records_push_columns(L, records, count);
  columns_by_body(L, arc_model_definition(arc_wear_model(wear)), "history");
}

/* The table export: files for other tools, out of objects and of plain tables; and for scripts the
 * module `archard.files`, the writing of texts and numbers below it. */
#include "archard/export.h"
#include "lua/base/archard.h"
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/wear/wear_class.h"

#include <string.h>

static const char *path_argument(lua_State *L, int index, const char *where) {
  if (lua_type(L, index) == LUA_TSTRING) return lua_tostring(L, index);
  lua_settop(L, index);
  args_refuse(L, (args_place){where, ""}, "path", "a file name");
}

/* --- CSV ------------------------------------------------------------------------------------- */

static const char csv_where[] = "export.csv";

/* Columns on their way to a file; what holds them stands on the stack. */
typedef struct csv_table {
  const char **names;
  const double **data;
  size_t columns, rows;
} csv_table;

/* Pushes room for so many columns. */
static csv_table push_columns(lua_State *L, size_t columns) {
  csv_table table = {.columns = columns};
  size_t unit = sizeof(void *) * (columns ? columns : 1);
  table.names = lua_newuserdatauv(L, unit, 0);
  table.data = lua_newuserdatauv(L, unit, 0);
  return table;
}

static void write_columns(lua_State *L, const char *path, csv_table table) {
  arc_error error = {0};
  arc_status status =
      arc_export_csv(path, table.columns, table.names, table.data, table.rows, &error);
  error_check(L, status, &error, csv_where, -1);
}

static void write_history(lua_State *L, const char *path, const arc_wear *wear) {
  csv_table table = push_columns(L, ARC_WEAR_COLUMN_COUNT);
  const arc_wear_record *records = arc_wear_history(wear, &table.rows);
  for (int column = 0; column < ARC_WEAR_COLUMN_COUNT; column++) {
    double *values = array_buffer(L, table.rows);
    for (size_t i = 0; i < table.rows; i++) values[i] = arc_wear_record_get(records + i, column);
    table.names[column] = arc_wear_column_name(column);
    table.data[column] = values;
  }
  write_columns(L, path, table);
}

/* A copy of `count` values on the stack, filled up with NaN to `rows`. */
static const double *push_padded(lua_State *L, const double *values, size_t count, size_t rows) {
  double *padded = array_buffer(L, rows);
  for (size_t i = 0; i < rows; i++) padded[i] = i < count ? values[i] : NAN;
  return padded;
}

/* The pressures of both bodies side by side; the shorter columns end early. */
static void write_pressures(lua_State *L, const char *path, const arc_contact *contact) {
  static const char *const names[] = {"x_cylinder", "p_cylinder", "x_plate", "p_plate"};
  csv_table table = push_columns(L, 4);
  for (int body = 0; body < ARC_BODIES; body++) {
    size_t count = (size_t)arc_contact_pressure(contact, (arc_body)body).count;
    if (count > table.rows) table.rows = count;
  }
  for (int body = 0; body < ARC_BODIES; body++) {
    arc_pressure pressure = arc_contact_pressure(contact, (arc_body)body);
    table.data[2 * body] = push_padded(L, pressure.x, (size_t)pressure.count, table.rows);
    table.data[2 * body + 1] = push_padded(L, pressure.p, (size_t)pressure.count, table.rows);
  }
  memcpy(table.names, names, sizeof names);
  write_columns(L, path, table);
}

/* Pushes "file-cylinder.ending" for "file.ending". */
static const char *push_path(lua_State *L, const char *path, arc_body body, const char *usual) {
  const char *name = strrchr(path, '/');
  const char *ending = strrchr(name ? name : path, '.');
  size_t stem = ending ? (size_t)(ending - path) : strlen(path);
  lua_pushlstring(L, path, stem);
  lua_pushfstring(L, "%s-%s%s", lua_tostring(L, -1), body_names[body], ending ? ending : usual);
  lua_remove(L, -2);
  return lua_tostring(L, -1);
}

/* The fields of both bodies, one file each; leaves the names of the files on the stack. */
static int write_stress(lua_State *L, const char *path, const arc_contact *contact) {
#define NAME(name, unit, text)   #name,
#define COLUMN(name, unit, text) f->name,
  static const char *const names[] = {ARC_FIELD_COLUMNS(NAME)};
  const size_t count = sizeof names / sizeof *names;
  for (int body = 0; body < ARC_BODIES; body++) {
    const char *file = push_path(L, path, (arc_body)body, ".csv");
    const arc_field *f = field_push_holder(L, contact, (arc_body)body, csv_where);
    const double *const columns[] = {ARC_FIELD_COLUMNS(COLUMN)};
    arc_error error = {0};
    arc_status status = arc_export_csv(file, count, names, columns, (size_t)f->nodes, &error);
    error_check(L, status, &error, csv_where, -1);
    lua_pop(L, 1);
  }
  return ARC_BODIES;
}

/* The order of columns of a plain table: positions first, then by name. */
static int rank_of(const char *name) {
  static const char *const first[] = {"distance", "t", "x", "y"};
  for (int i = 0; i < 4; i++)
    if (strcmp(name, first[i]) == 0) return i;
  return 4;
}

static int goes_before(const char *a, const char *b) {
  int ranks = rank_of(a) - rank_of(b);
  return ranks ? ranks < 0 : strcmp(a, b) < 0;
}

/* Puts a name into its place among the first `count`. */
static void insert_name(const char **names, size_t count, const char *name) {
  while (count > 0 && goes_before(name, names[count - 1])) {
    names[count] = names[count - 1];
    count--;
  }
  names[count] = name;
}

/* Collects the names of the columns of the table at `index`, sorted. */
static csv_table push_names(lua_State *L, int index, args_place place) {
  size_t columns = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) columns++;
  if (columns == 0)
    error_raise(L, ARC_ARGUMENT, place.where, "the table is empty; expected arrays by name");
  csv_table table = push_columns(L, columns);
  size_t count = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      error_raise(L, ARC_ARGUMENT, place.where,
                  "expected a table of arrays by name, as { x={...}, h={...} }; found [%s]",
                  luaL_tolstring(L, -2, NULL));
    insert_name(table.names, count++, lua_tostring(L, -2));
  }
  return table;
}

/* Writes a plain table of arrays of one length. */
static void write_table(lua_State *L, const char *path, int index) {
  args_place place = {csv_where, ""};
  csv_table table = push_names(L, index, place);
  luaL_checkstack(L, 2 * (int)table.columns + 12, csv_where);
  for (size_t i = 0; i < table.columns; i++) {
    size_t rows;
    lua_getfield(L, index, table.names[i]);
    table.data[i] = array_read(L, place, table.names[i], &rows);
    if (i > 0 && rows != table.rows)
      error_raise(L, ARC_ARGUMENT, csv_where,
                  "expected arrays of one length, got %d numbers in '%s' and %d in '%s'",
                  (int)table.rows, table.names[0], (int)rows, table.names[i]);
    table.rows = rows;
  }
  write_columns(L, path, table);
}

/* export.csv(wear | contact | stress | table of arrays, path) -> the two files of a stress */
static int export_csv(lua_State *L) {
  lua_settop(L, 2);
  const char *path = path_argument(L, 2, csv_where);
  luaL_checkstack(L, 2 * ARC_WEAR_COLUMN_COUNT + 12, csv_where);
  if (box_test(L, 1, &wear_class))
    write_history(L, path, box_check(L, 1, &wear_class, csv_where)->thing);
  else if (box_test(L, 1, &contact_class))
    write_pressures(L, path, box_check(L, 1, &contact_class, csv_where)->thing);
  else if (stress_contact(L, 1, csv_where))
    return write_stress(L, path, stress_contact(L, 1, csv_where));
  else if (lua_istable(L, 1))
    write_table(L, path, 1);
  else
    error_raise(L, ARC_ARGUMENT, csv_where,
                "expected a wear or contact object, a stress or a table of arrays, got %s",
                names_push_shown(L, 1));
  return 0;
}

/* --- VTK ------------------------------------------------------------------------------------- */

static const char vtk_where[] = "export.vtk";

/* One file a body; returns their names. */
static int write_bodies(lua_State *L, const char *path, const arc_model *model,
                        const arc_contact *contact) {
  arc_error error = {0};
  for (int body = 0; body < ARC_BODIES; body++) {
    const char *file = push_path(L, path, (arc_body)body, ".vtk");
    const arc_field *field =
        contact ? field_push_holder(L, contact, (arc_body)body, vtk_where) : NULL;
    arc_status status = arc_export_vtk(file, arc_model_mesh(model, (arc_body)body), field, &error);
    error_check(L, status, &error, vtk_where, -1);
    if (field) lua_pop(L, 1);
  }
  return ARC_BODIES;
}

static int write_mesh(lua_State *L, const char *path) {
  arc_error error = {0};
  arc_status status = arc_export_vtk(path, mesh_of(L, 1, vtk_where), NULL, &error);
  error_check(L, status, &error, vtk_where, -1);
  lua_pushvalue(L, 2);
  return 1;
}

/* export.vtk(contact | stress | model | mesh, path) -> the files written: one of a mesh, else one a
 * body */
static int export_vtk(lua_State *L) {
  lua_settop(L, 2);
  const char *path = path_argument(L, 2, vtk_where);
  if (box_test(L, 1, &mesh_class)) return write_mesh(L, path);
  if (box_test(L, 1, &model_class))
    return write_bodies(L, path, box_check(L, 1, &model_class, vtk_where)->thing, NULL);
  const arc_contact *contact = stress_contact(L, 1, vtk_where);
  if (!contact && !box_test(L, 1, &contact_class))
    error_raise(
        L, ARC_ARGUMENT, vtk_where, "expected a contact, its stress, a model or a mesh, got %s%s",
        names_push_shown(L, 1), box_test(L, 1, &wear_class) ? " (its contact is w:contact())" : "");
  if (!contact) contact = box_check(L, 1, &contact_class, vtk_where)->thing;
  return write_bodies(L, path, arc_contact_model(contact), contact);
}

/* --- input decks ----------------------------------------------------------------------------- */

/* export.inp(model, path) */
static int export_inp(lua_State *L) {
  static const char where[] = "export.inp";
  lua_settop(L, 2);
  const char *path = path_argument(L, 2, where);
  const arc_model *model = box_check(L, 1, &model_class, where)->thing;
  arc_error error = {0};
  error_check(L, arc_export_inp(path, model, &error), &error, where, -1);
  return 0;
}

int luaopen_archard_export(lua_State *L) {
  static const luaL_Reg functions[] = {
      {"csv", export_csv}, {"vtk", export_vtk}, {"inp", export_inp}, {NULL, NULL}};
  luaL_newlib(L, functions);
  return 1;
}

/* --- for scripts ----------------------------------------------------------------------------- */

/* write(where, path, text): the file is whole, or not there and an error of `where` is raised */
static int files_write(lua_State *L) {
  size_t length;
  const char *where = luaL_checkstring(L, 1), *path = luaL_checkstring(L, 2);
  const char *text = luaL_checklstring(L, 3, &length);
  arc_error error = {0};
  error_check(L, arc_export_text(path, text, length, &error), &error, where, -1);
  return 0;
}

/* number(value) -> its shortest text */
static int files_number(lua_State *L) {
  lua_pushstring(L, arc_number_to_text(luaL_checknumber(L, 1)).text);
  return 1;
}

int luaopen_archard_files(lua_State *L) {
  static const luaL_Reg functions[] = {
      {"write", files_write}, {"number", files_number}, {NULL, NULL}};
  luaL_newlib(L, functions);
  return 1;
}

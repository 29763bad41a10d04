/* Writes CSV files: histories, pressures, stresses, and the user's tables of arrays. */
#include "archard/export.h"
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/base/strict.h"
#include "lua/base/names.h"
#include "lua/base/file_name.h"
#include "lua/files/export.h"
#include "lua/wear/wear_class.h"

#include <string.h>

const char *export_ending(const char *path) {
  const char *name = strrchr(path, '/');
  return strrchr(name ? name : path, '.');
}

const char *export_push_path(lua_State *L, const char *path, const char *body, const char *usual) {
  const char *ending = export_ending(path);
  size_t stem = ending ? (size_t)(ending - path) : strlen(path);
  lua_pushlstring(L, path, stem);
  lua_pushfstring(L, "%s-%s%s", lua_tostring(L, -1), body, ending ? ending : usual);
  lua_remove(L, -2);
  return lua_tostring(L, -1);
}

static const char where[] = "export.csv";

enum { MOST_COLUMNS = 100000 };

/* Columns of a file. Their arrays are on the Lua stack. */
typedef struct csv_table {
  const char **names, **units;
  const double **data;
  size_t columns, rows;
} csv_table;

/* Pushes buffers for the names, units and data of `columns` columns. The units are NULL. */
static csv_table push_columns(lua_State *L, size_t columns) {
  csv_table table = {.columns = columns};
  const size_t bytes = sizeof(void *) * (columns ? columns : 1);
  table.names = lua_newuserdatauv(L, bytes, 0);
  table.units = memset(lua_newuserdatauv(L, bytes, 0), 0, bytes);
  table.data = lua_newuserdatauv(L, bytes, 0);
  return table;
}

static void write_columns(lua_State *L, const char *path, csv_table table) {
  arc_error error = {0};
  arc_status status =
      arc_export_csv(path, table.columns, table.names, table.units, table.data, table.rows, &error);
  error_check(L, status, &error, where, -1);
}

static void write_history(lua_State *L, const char *path, const arc_wear *wear) {
#define UNIT(name, unit, range, rule, text) unit,
  static const char *const units[] = {ARC_WEAR_COLUMNS(UNIT)};
#undef UNIT
  csv_table table = push_columns(L, ARC_WEAR_COLUMN_COUNT);
  const arc_wear_record *records = arc_wear_history(wear, &table.rows);
  for (int column = 0; column < ARC_WEAR_COLUMN_COUNT; column++) {
    double *values = array_buffer(L, table.rows);
    for (size_t i = 0; i < table.rows; i++) values[i] = arc_wear_record_get(records + i, column);
    table.names[column] = arc_wear_column_name(column);
    table.units[column] = units[column];
    table.data[column] = values;
  }
  write_columns(L, path, table);
}

/* Pushes a copy of `count` values, followed by NaN up to `rows` values. */
static const double *push_padded(lua_State *L, const double *values, size_t count, size_t rows) {
  double *padded = array_buffer(L, rows);
  for (size_t i = 0; i < rows; i++) padded[i] = i < count ? values[i] : NAN;
  return padded;
}

/* Appends a column with values at the surface nodes of a body. */
static void add_nodal(lua_State *L, csv_table *table, const char *name, const char *unit,
                      const arc_contact *contact, arc_body body, const double *values) {
  const arc_model_def *pair = arc_model_definition(arc_contact_model(contact));
  const size_t count = (size_t)arc_contact_pressure(contact, body).count, at = table->columns++;
  table->names[at] = lua_pushfstring(L, "%s_%s", name, body_name(pair, body));
  table->units[at] = unit;
  table->data[at] = push_padded(L, values, count, table->rows);
}

/* Writes the pressures of both bodies in adjacent columns. With friction also writes the shear of
 * both bodies and the slip at the nodes of the cylinder. Shorter columns end with NaN. */
static void write_contact(lua_State *L, const char *path, const arc_contact *contact) {
  enum { most_columns = 7 };
  csv_table table = push_columns(L, most_columns);
  int count;
  const double *slip = arc_contact_slip(contact, &count);
  table.columns = 0;
  for (arc_body body = 0; body < ARC_BODIES; body++) {
    count = arc_contact_pressure(contact, body).count;
    if ((size_t)count > table.rows) table.rows = (size_t)count;
  }
  for (arc_body body = 0; body < ARC_BODIES; body++) {
    const arc_pressure pressure = arc_contact_pressure(contact, body);
    add_nodal(L, &table, "x", "mm", contact, body, pressure.x);
    add_nodal(L, &table, "p", "MPa", contact, body, pressure.p);
  }
  for (arc_body body = 0; body < ARC_BODIES && slip; body++)
    add_nodal(L, &table, "q", "MPa", contact, body, arc_contact_shear(contact, body).q);
  if (slip) add_nodal(L, &table, "s", "mm", contact, ARC_CYLINDER, slip);
  write_columns(L, path, table);
}

/* Writes one file for each body with its stress field. The names of the files stay on the stack. */
static int write_stress(lua_State *L, const char *path, const arc_contact *contact) {
#define NAME(name, unit, text)   #name,
#define UNIT(name, unit, text)   unit,
#define COLUMN(name, unit, text) f->name,
  static const char *const names[] = {ARC_FIELD_COLUMNS(NAME)};
  static const char *const units[] = {ARC_FIELD_COLUMNS(UNIT)};
  const size_t count = sizeof names / sizeof *names;
  const arc_model_def *pair = arc_model_definition(arc_contact_model(contact));
  for (int body = 0; body < ARC_BODIES; body++) {
    const char *file = export_push_path(L, path, body_name(pair, (arc_body)body), ".csv");
    const arc_field *f = field_push_holder(L, contact, (arc_body)body, where);
    const double *const columns[] = {ARC_FIELD_COLUMNS(COLUMN)};
    arc_error error = {0};
    arc_status status =
        arc_export_csv(file, count, names, units, columns, (size_t)f->nodes, &error);
    error_check(L, status, &error, where, -1);
    lua_pop(L, 1);
  }
  return ARC_BODIES;
#undef NAME
#undef UNIT
#undef COLUMN
}

/* --- tables of the user ----------------------------------------------------------------------- */

/* Returns the rank of a column name for sorting the columns of a user's table: first distance, t, x
 * and y, then all other columns by name. */
static int rank_of(const char *name) {
  static const char *const first[] = {"distance", "t", "x", "y"};
  for (int i = 0; i < 4; i++)
    if (strcmp(name, first[i]) == 0) return i;
  return 4;
}

static int is_before(const char *a, const char *b) {
  int ranks = rank_of(a) - rank_of(b);
  return ranks ? ranks < 0 : strcmp(a, b) < 0;
}

/* Inserts a name into the first `count` names, which are sorted. */
static void insert_name(const char **names, size_t count, const char *name) {
  while (count > 0 && is_before(name, names[count - 1])) {
    names[count] = names[count - 1];
    count--;
  }
  names[count] = name;
}

/* Pushes the sorted names of the columns of the table at `index`. The table is a copy, which
 * scripts cannot change between counting and collecting the names. */
static csv_table push_names(lua_State *L, int index) {
  size_t columns = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) columns++;
  if (columns > MOST_COLUMNS)
    error_raise(L, ARC_ARGUMENT, where, "expected at most %d columns, got %I", MOST_COLUMNS,
                (LUAI_UACINT)columns);
  if (columns == 0)
    error_raise(L, ARC_ARGUMENT, where, "the table is empty; expected arrays by name");
  csv_table table = push_columns(L, columns);
  size_t count = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      error_raise(L, ARC_ARGUMENT, where,
                  "expected a table of arrays by name, as { x={...}, h={...} }; found [%s]",
                  luaL_tolstring(L, -2, NULL));
    insert_name(table.names, count++, lua_tostring(L, -2));
  }
  return table;
}

/* Returns the unit that a column with this name has in the program's own tables, or NULL if the
 * name is unknown. */
static const char *unit_of(const char *name) {
#define KNOWN(name, unit, range, rule, text) {#name, unit},
  static const char *const known[][2] = {{"x", "mm"},
                                         {"y", "mm"},
                                         {"h", "mm"},
                                         {"worn_x", "mm"},
                                         {"way", "mm"},
                                         {"p", "MPa"},
                                         ARC_WEAR_COLUMNS(KNOWN)};
#undef KNOWN
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    if (strcmp(known[i][0], name) == 0) return known[i][1][0] ? known[i][1] : NULL;
  return NULL;
}

/* Returns true if the table at `index` is a result of the program, whose units are known. */
static int is_own(lua_State *L, int index) {
  static const char *const ours[] = {"wear:profile",  "case:profile", "pressure",
                                     "case:pressure", "combined",     "mesh:coordinates",
                                     "history"};
  int own = 0;
  for (size_t i = 0; !own && i < sizeof ours / sizeof *ours; i++)
    own = strict_is(L, index, ours[i]);
  return own;
}

/* Sets the known units of the columns of a table that is a result of the program. */
static void set_own_units(csv_table table) {
  for (size_t i = 0; i < table.columns; i++) table.units[i] = unit_of(table.names[i]);
}

/* Sets the units from the table { name = unit } at `index`. If the value is nil, sets no units. */
static void read_units(lua_State *L, int index, csv_table table) {
  if (lua_isnil(L, index)) return;
  if (!lua_istable(L, index))
    error_raise(L, ARC_ARGUMENT, where, "expected units by name as { x = \"mm\" }, got %s",
                names_push_shown(L, index));
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    const char *name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    size_t i = 0;
    while (i < table.columns && strcmp(table.names[i], name) != 0) i++;
    if (i == table.columns || lua_type(L, -1) != LUA_TSTRING)
      error_raise(L, ARC_ARGUMENT, where,
                  "expected the unit of a column as a string, got '%s' = %s", name,
                  names_push_shown(L, -1));
    table.units[i] = lua_tostring(L, -1);
  }
}

/* Replaces the table at `index` by a copy. Has no effect on other values. */
static void use_copy(lua_State *L, int index) {
  if (!lua_istable(L, index)) return;
  args_push_copy(L, index);
  lua_replace(L, index);
}

/* Writes a user's table of arrays, which must have equal length. */
static void write_table(lua_State *L, const char *path, int index, int units) {
  const int own = is_own(L, index);
  use_copy(L, index);
  use_copy(L, units);
  csv_table table = push_names(L, index);
  if (own) set_own_units(table);
  read_units(L, units, table);
  luaL_checkstack(L, 2 * (int)table.columns + 12, where);
  for (size_t i = 0; i < table.columns; i++) {
    size_t rows;
    lua_getfield(L, index, table.names[i]);
    table.data[i] = array_read_any(L, (args_location){where, ""}, table.names[i], &rows);
    if (i > 0 && rows != table.rows)
      error_raise(L, ARC_ARGUMENT, where,
                  "expected arrays of equal length, got %d numbers in '%s' and %d in '%s'",
                  (int)table.rows, table.names[0], (int)rows, table.names[i]);
    table.rows = rows;
  }
  write_columns(L, path, table);
}

/* Returns the file name at index 2. Raises an error if its extension belongs to another format. */
static const char *csv_path(lua_State *L) {
  static const char *const endings[] = {".csv", ".txt", ".dat", ".tsv", NULL};
  const char *path = path_argument(L, 2, where, "path"), *ending = export_ending(path);
  for (int i = 0; ending && endings[i]; i++)
    if (strcmp(ending, endings[i]) == 0) return path;
  if (!ending) return path;
  lua_settop(L, 2);
  args_refuse(L, (args_location){where, ""}, "path",
              "a file name with the extension .csv, .txt, .dat or .tsv, or without extension");
}

/* csv(object, path, units) writes a file. The object is a wear, contact or stress object, or a
 * table of arrays. The optional table `units` contains the unit of each column by name. Returns the
 * file name, or two names for a stress object. */
int export_csv(lua_State *L) {
  lua_settop(L, 3);
  const char *path = csv_path(L);
  luaL_checkstack(L, 2 * ARC_WEAR_COLUMN_COUNT + 12, where);
  if (box_test(L, 1, &wear_class))
    write_history(L, path, box_check(L, 1, &wear_class, where)->thing);
  else if (box_test(L, 1, &contact_class))
    write_contact(L, path, box_check(L, 1, &contact_class, where)->thing);
  else if (stress_contact(L, 1, where))
    return write_stress(L, path, stress_contact(L, 1, where));
  else if (lua_istable(L, 1))
    write_table(L, path, 1, 3);
  else
    error_raise(L, ARC_ARGUMENT, where,
                "expected a wear or contact object, a stress or a table of arrays, got %s",
                names_push_shown(L, 1));
  lua_pushvalue(L, 2);
  return 1;
}

/* Creates the tables of a run file and the views for users, and converts files of older formats.
 * The names of the columns are defined in columns.c. A file that is opened for writing is
 * converted in one transaction. A file that is opened for reading is never changed, because an
 * older program may still use it, or it may be write-protected; a temporary copy is converted
 * instead. */
#include "store/store.h"

#include <stdlib.h>

#define TEXT_OF(number) TEXT(number)
#define TEXT(number)    #number

/* Columns for numbers have no SQL type, because with the type REAL the sign of zero would be
 * lost. */
#define CASE_ID      "case_id INTEGER NOT NULL REFERENCES cases"
#define NAMED_VALUES "(" CASE_ID ", name TEXT NOT NULL, value, PRIMARY KEY (case_id, name))"
#define MAKE_TEXTS   "CREATE TABLE texts (name TEXT PRIMARY KEY, text TEXT NOT NULL);"
#define MAKE_ARRAYS                                                                                \
  "CREATE TABLE arrays (" CASE_ID ", part TEXT NOT NULL, updates NOT NULL, distance_mm,"           \
  "  body TEXT NOT NULL, name TEXT NOT NULL, rows INTEGER NOT NULL, columns INTEGER NOT NULL,"     \
  "  numbers BLOB NOT NULL, PRIMARY KEY (case_id, part, updates, body, name));"
static const char tables[] =
    "CREATE TABLE info (name TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID;"
    "CREATE TABLE cases (id INTEGER PRIMARY KEY, label TEXT NOT NULL,"
    "  status TEXT NOT NULL DEFAULT 'waiting', message TEXT, seconds REAL, checksum TEXT,"
    "  created TEXT, finished TEXT);" MAKE_TEXTS "CREATE TABLE settings " NAMED_VALUES
    " WITHOUT ROWID;"
    "CREATE TABLE definition " NAMED_VALUES " WITHOUT ROWID;"
    "CREATE TABLE results " NAMED_VALUES " WITHOUT ROWID;"
    "CREATE TABLE history (" CASE_ID ", step INTEGER NOT NULL@columns,"
    "  PRIMARY KEY (case_id, step)) WITHOUT ROWID;" MAKE_ARRAYS;

/* Statements that remove the views. The views are created again when the tables change. */
static const char drop_views[] = "DROP VIEW IF EXISTS case_results;"
                                 "DROP VIEW IF EXISTS history_of;"
                                 "DROP VIEW IF EXISTS units;";
static const char case_results[] =
    "CREATE VIEW case_results AS SELECT c.id AS case_id, c.label, c.status, c.message,"
    "  (SELECT value FROM results WHERE case_id = c.id AND name = 'warning') AS warning,"
    "  c.created, c.finished, c.seconds@settings@results,"
    "  h.volume_cylinder_mm3 + h.volume_plate_mm3 AS volume_total_mm3"
    "  FROM cases c LEFT JOIN history h ON h.case_id = c.id AND"
    "  h.step = (SELECT max(step) FROM history WHERE case_id = c.id)";

#define OTHER(name)                                                                                \
  " JOIN arrays " name " ON " name ".case_id = x.case_id AND " name ".part = x.part AND " name     \
  ".updates = x.updates AND " name ".body = x.body AND " name ".name = '" name "' AND " name       \
  ".rows = x.rows"
static const char surfaces[] =
    "CREATE VIEW surfaces AS WITH RECURSIVE byte(bytes) AS (VALUES (x'@bytes')),"
    "  site(node) AS (SELECT 0 UNION ALL SELECT node + 1 FROM site"
    "  WHERE node + 1 < (SELECT max(rows) FROM arrays WHERE part = 'surface'))"
    "  SELECT x.case_id, x.updates, x.distance_mm, x.body, node@numbers"
    "  FROM arrays x" OTHER("h") OTHER("y")
        OTHER("p") " JOIN site ON node < x.rows JOIN byte"
                   "  WHERE x.part = 'surface' AND x.name = 'x' AND x.columns = 1";
static const char views[] = "CREATE VIEW history_of AS SELECT case_id, label, step@columns"
                            "  FROM history JOIN cases ON case_id = id;"
                            "CREATE VIEW units (name, unit, text) AS VALUES @units;"
                            "PRAGMA user_version = " TEXT_OF(ARC_STORE_FORMAT) ";";

/* SQL statements for the conversion to format 5, in which surfaces and states are stored as arrays.
 * The older tables have one row for each node of a surface, and one row for the state of each body.
 */
#define PACKED(name, column)                                                                       \
  "INSERT INTO arrays SELECT case_id, 'surface', updates, max(distance_mm), body, '" name          \
  "', count(*), 1, array_of(" column ") FROM older_surfaces GROUP BY case_id, updates, body;"
#define LAST(column) "(SELECT max(" column ") FROM history h WHERE h.case_id = s.case_id)"
#define MOVED(name, array)                                                                         \
  "INSERT INTO arrays SELECT case_id, 'state', " LAST("updates") ", " LAST(                        \
      "distance_mm") ", body, '" name "', " array " FROM older_state s GROUP BY case_id, body;"
/* clang-format off */
static const char to_arrays[] =
    "ALTER TABLE history ADD COLUMN half_width_z_mm;"
    "ALTER TABLE history ADD COLUMN area_mm2;"
    PACKED("x", "x_mm")
    PACKED("h", "h_mm")
    PACKED("y", "y_mm")
    PACKED("p", "p_MPa")
    MOVED("h", "length(h) / 8, 1, h")
    MOVED("xy", "length(h) / 8, 2, xy")
    MOVED("settled", "length(h) / 8, 2, settled")
    MOVED("even", "1, 1, array_of(even)")
    MOVED("condensed", "1, 1, array_of(condensed)")
    "DROP TABLE older_surfaces; DROP TABLE older_state;";
/* clang-format on */

/* Conversions from each format to the next format. A conversion must not be changed after its
 * release. `names` renames tables and columns to their names in the present SQL texts. `values`
 * adds or changes values that are part of the checksums. */
static const struct migration {
  int from;
  const char *names, *values;
} migrations[] = {
    {1,
     "ALTER TABLE cases RENAME COLUMN digest TO checksum;"
     "ALTER TABLE history RENAME COLUMN \"update\" TO updates;"
     "ALTER TABLE history RENAME COLUMN distance TO distance_mm;"
     "ALTER TABLE history RENAME COLUMN k TO k_mm2_per_N;"
     "ALTER TABLE history RENAME COLUMN p_center TO p_center_MPa;"
     "ALTER TABLE history RENAME COLUMN p_max TO p_max_MPa;"
     "ALTER TABLE history RENAME COLUMN half_width TO half_width_mm;"
     "ALTER TABLE history RENAME COLUMN depth_cylinder TO depth_cylinder_mm;"
     "ALTER TABLE history RENAME COLUMN depth_plate TO depth_plate_mm;"
     "ALTER TABLE history RENAME COLUMN volume_cylinder TO volume_cylinder_mm3;"
     "ALTER TABLE history RENAME COLUMN volume_plate TO volume_plate_mm3;"
     "ALTER TABLE surfaces RENAME COLUMN \"update\" TO updates;"
     "ALTER TABLE surfaces RENAME COLUMN distance TO distance_mm;"
     "ALTER TABLE surfaces RENAME COLUMN x TO x_mm;"
     "ALTER TABLE surfaces RENAME COLUMN h TO h_mm;"
     "ALTER TABLE surfaces RENAME COLUMN y TO y_mm;"
     "ALTER TABLE surfaces RENAME COLUMN p TO p_MPa;",
     "ALTER TABLE cases ADD COLUMN created TEXT;"
     "ALTER TABLE cases ADD COLUMN finished TEXT;"},
    {2, "", "ALTER TABLE history ADD COLUMN p_peak_MPa;"},
    {3, "",
     "ALTER TABLE history ADD COLUMN load_N;"
     "ALTER TABLE history ADD COLUMN load_low_N;"
     "ALTER TABLE history ADD COLUMN load_reference_N;"
     "ALTER TABLE history ADD COLUMN travel_mm;"
     "ALTER TABLE history ADD COLUMN load_distance_N_mm;"
     "ALTER TABLE history ADD COLUMN box_rows;"
     "ALTER TABLE history ADD COLUMN elements;"
     "ALTER TABLE history ADD COLUMN energy_N_mm;"
     "ALTER TABLE history ADD COLUMN cycle_energy_N_mm;"
     "ALTER TABLE history ADD COLUMN largest_shear_N;"
     "ALTER TABLE history ADD COLUMN stick_width_mm;"
     "ALTER TABLE history ADD COLUMN gross;" MAKE_TEXTS},
    {4,
     "ALTER TABLE surfaces RENAME TO older_surfaces;"
     "ALTER TABLE state RENAME TO older_state;" MAKE_ARRAYS,
     to_arrays},
    /* In format 5, the jump "auto" was a separate value, and the jump of a 2-D case without jump,
     * tolerance and scheme was 100 cycles. */
    {5, "",
     "UPDATE definition SET value = 0.0 WHERE name = 'jump' AND EXISTS (SELECT 1 FROM definition d"
     "  WHERE d.case_id = definition.case_id AND d.name = 'jump_auto' AND d.value <> 0);"
     "DELETE FROM definition WHERE name = 'jump_auto';"
     "INSERT INTO settings SELECT id, 'jump', 100.0 FROM cases WHERE NOT EXISTS (SELECT 1"
     "  FROM settings WHERE case_id = id AND (name IN ('jump', 'tolerance', 'scheme')"
     "  OR name = 'model.geometry' AND value = '3-D'))"
     "  AND EXISTS (SELECT 1 FROM info WHERE name = 'kind' AND value = 'study');"},
};

enum { MIGRATIONS = sizeof migrations / sizeof *migrations };
_Static_assert(MIGRATIONS == ARC_STORE_FORMAT - 1, "a new format needs a line in migrations");

static arc_status make_views(arc_store *store, arc_error *error) {
  arc_status status = arc_store_script(store, case_results, error);
  if (status == ARC_OK) status = arc_store_script(store, surfaces, error);
  return status == ARC_OK ? arc_store_script(store, views, error) : status;
}

arc_status arc_schema_make(arc_store *store, arc_error *error) {
  arc_status status = arc_database_run(store->db,
                                       "PRAGMA page_size = 4096; PRAGMA application_id = " TEXT_OF(
                                           ARC_STORE_APPLICATION) ";"
                                                                  "BEGIN IMMEDIATE",
                                       error);
  if (status == ARC_OK) status = arc_store_script(store, tables, error);
  if (status == ARC_OK) status = make_views(store, error);
  return status == ARC_OK ? arc_database_run(store->db, "COMMIT", error) : status;
}

/* Removes the views. In formats before 5 `surfaces` is a table and is preserved. */
static arc_status forget_views(arc_store *store, long long format, arc_error *error) {
  const arc_status status = arc_database_run(store->db, drop_views, error);
  if (status != ARC_OK || format < 5) return status;
  return arc_database_run(store->db, "DROP VIEW IF EXISTS surfaces", error);
}

/* Converts the tables. A case with a correct checksum receives a new checksum at the commit. A
 * damaged case keeps its wrong checksum. */
static arc_status migrate(arc_store *store, long long format, arc_error *error) {
  arc_status status = forget_views(store, format, error);
  for (int m = (int)format - 1; m < MIGRATIONS && status == ARC_OK; m++)
    status = arc_database_run(store->db, migrations[m].names, error);
  store->older = format < 5; /* in formats before 5, surfaces and states had their own tables */
  if (status == ARC_OK) status = arc_store_unseal_sound(store, error);
  store->older = 0;
  for (int m = (int)format - 1; m < MIGRATIONS && status == ARC_OK; m++)
    status = arc_database_run(store->db, migrations[m].values, error);
  if (status == ARC_ARGUMENT) /* the file contains rows that archard did not write */
    return arc_fail(error, ARC_FORMAT, "%s: the file is damaged: its rows contradict each other",
                    store->path);
  return status == ARC_OK ? make_views(store, error) : status;
}

/* Creates the views again if another version of archard created them. */
static arc_status renew_views(arc_store *store, arc_error *error) {
  query *q;
  int row = 0;
  char *wanted = arc_columns_sql(case_results);
  if (!wanted) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  arc_status status = arc_query_open(
      store->db, "SELECT 1 FROM sqlite_master WHERE name = 'case_results' AND sql = ?1", &q, error);
  if (status == ARC_OK) arc_query_set_text(q, 1, wanted);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  arc_query_close(&q);
  free(wanted);
  if (status != ARC_OK || row) return status;
  status = forget_views(store, ARC_STORE_FORMAT, error);
  return status == ARC_OK ? make_views(store, error) : status;
}

/* Converts the file in one transaction. If several programs open the file at once, the first
 * program converts it. */
arc_status arc_schema_update(arc_store *store, arc_error *error) {
  long long format = 0;
  arc_status status = arc_database_run(store->db, "BEGIN IMMEDIATE", error);
  if (status != ARC_OK) return status;
  status = arc_schema_format(store, &format, error);
  if (status == ARC_OK && format < ARC_STORE_FORMAT) status = migrate(store, format, error);
  if (status == ARC_OK) status = renew_views(store, error);
  return arc_store_leave(store, 1, status, error);
}

/* The tables of a run file, the views for people, and how a file of an older format becomes one of
 * today's. Leans on columns.c for the names.
 *
 * A file that is opened for writing is brought up to date in one transaction; a reader never
 * changes a file (an older program may still be at work on it, or it may be write-protected) and
 * brings a temporary copy up to date instead. */
#include "store/store.h"

#include <stdlib.h>

#define TEXT_OF(number) TEXT(number)
#define TEXT(number)    #number

/* Numbers that must come back to the same bits stand in columns without a type: those of type REAL
 * would lose the sign of zero. */
#define CASE_ID      "case_id INTEGER NOT NULL REFERENCES cases"
#define NAMED_VALUES "(" CASE_ID ", name TEXT NOT NULL, value, PRIMARY KEY (case_id, name))"
#define MAKE_TEXTS   "CREATE TABLE texts (name TEXT PRIMARY KEY, text TEXT NOT NULL);"
static const char tables[] =
    "CREATE TABLE info (name TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID;"
    "CREATE TABLE cases (id INTEGER PRIMARY KEY, label TEXT NOT NULL,"
    "  status TEXT NOT NULL DEFAULT 'waiting', message TEXT, seconds REAL, checksum TEXT,"
    "  created TEXT, finished TEXT);" MAKE_TEXTS "CREATE TABLE settings " NAMED_VALUES
    " WITHOUT ROWID;"
    "CREATE TABLE definition " NAMED_VALUES " WITHOUT ROWID;"
    "CREATE TABLE results " NAMED_VALUES " WITHOUT ROWID;"
    "CREATE TABLE history (" CASE_ID ", step INTEGER NOT NULL@columns,"
    "  PRIMARY KEY (case_id, step)) WITHOUT ROWID;"
    "CREATE TABLE surfaces (" CASE_ID ", updates, distance_mm, body TEXT NOT NULL,"
    "  node INTEGER NOT NULL, x_mm, h_mm, y_mm, p_MPa,"
    "  PRIMARY KEY (case_id, updates, body, node)) WITHOUT ROWID;"
    "CREATE TABLE state (" CASE_ID ", body TEXT NOT NULL, condensed INTEGER NOT NULL, even,"
    "  h BLOB NOT NULL, xy BLOB NOT NULL, settled BLOB NOT NULL,"
    "  PRIMARY KEY (case_id, body)) WITHOUT ROWID;";

/* Views hold nothing: they are made anew whenever the tables change. */
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
static const char views[] = "CREATE VIEW history_of AS SELECT case_id, label, step@columns"
                            "  FROM history JOIN cases ON case_id = id;"
                            "CREATE VIEW units (name, unit, text) AS VALUES @units;"
                            "PRAGMA user_version = " TEXT_OF(ARC_STORE_FORMAT) ";";

/* From the format before, in order; never changed once released. `names` renames, so that the SQL
 * of today finds its tables and columns, `values` adds what the checksums are then taken of. */
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
};

enum { MIGRATIONS = sizeof migrations / sizeof *migrations };
_Static_assert(MIGRATIONS == ARC_STORE_FORMAT - 1, "a new format needs a line in migrations");

static arc_status make_views(arc_store *store, arc_error *error) {
  const arc_status status = arc_store_script(store, case_results, error);
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

/* Cases whose checksum is right get a new one with the commit; of damaged ones it stays wrong. */
static arc_status migrate(arc_store *store, long long format, arc_error *error) {
  arc_status status = arc_database_run(store->db, drop_views, error);
  for (int m = (int)format - 1; m < MIGRATIONS && status == ARC_OK; m++)
    status = arc_database_run(store->db, migrations[m].names, error);
  if (status == ARC_OK) status = arc_store_unseal_sound(store, error);
  for (int m = (int)format - 1; m < MIGRATIONS && status == ARC_OK; m++)
    status = arc_database_run(store->db, migrations[m].values, error);
  return status == ARC_OK ? make_views(store, error) : status;
}

/* Views of a program that knew other settings are made anew: they hold nothing. */
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
  status = arc_database_run(store->db, drop_views, error);
  return status == ARC_OK ? make_views(store, error) : status;
}

/* Of several programs that open a file at once, the first changes it and the others find it done.
 */
arc_status arc_schema_update(arc_store *store, arc_error *error) {
  long long format = 0;
  arc_status status = arc_database_run(store->db, "BEGIN IMMEDIATE", error);
  if (status != ARC_OK) return status;
  status = arc_schema_format(store, &format, error);
  if (status == ARC_OK && format < ARC_STORE_FORMAT) status = migrate(store, format, error);
  if (status == ARC_OK) status = renew_views(store, error);
  return arc_store_leave(store, 1, status, error);
}

/* The inside of an arc_store, for the files of this layer. */
#ifndef STORE_STORE_H
#define STORE_STORE_H

#include "archard/place.h"
#include "archard/store.h"
#include "store/database.h"

/* The file's application_id, "arch"; at byte 68. */
#define ARC_STORE_APPLICATION 1634886504

/* The time stamps of cases. */
#define ARC_STORE_NOW "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')"

struct arc_store {
  database *db;
  char *path;       /* the file's name for the user */
  arc_place *place; /* where a new file is written until it is published; NULL: none */
  int verified;     /* the case whose checksum was compared last; 0: none */
};

/* --- transaction.c ------------------------------------------------------------------------------
 */

/* Opens a transaction unless one is open; *own says whether it did. */
arc_status arc_store_enter(arc_store *store, int *own, arc_error *error);
/* Ends what arc_store_enter began: commits after ARC_OK, takes back after anything else. Returns
 * the status of the whole. */
arc_status arc_store_leave(arc_store *store, int own, arc_status status, arc_error *error);

/* --- columns.c, statement.c: SQL texts with the columns of history and settings -----------------
 */

/* The pattern with these words replaced: @columns by ", NAME" for each column of the history,
 * @values by as many ", ?", @results by the columns that are results, @settings by the expressions
 * of the settings, @units by the rows of `units`. To be freed; NULL: out of memory. */
char *arc_columns_sql(const char *pattern);

/* Runs statements without results; `sql` is a pattern here and below. */
arc_status arc_store_script(arc_store *store, const char *sql, arc_error *error);

/* A query of one case, with its id as parameter 1. */
arc_status arc_store_query(arc_store *store, const char *sql, int id, query **q, arc_error *error);

/* Runs a statement with the case's id as parameter 1. */
arc_status arc_store_run(arc_store *store, const char *sql, int id, arc_error *error);

/* --- format.c, schema.c: the number of a format; tables and views -------------------------------
 */

/* ARC_FORMAT: a format that this program does not know. */
arc_status arc_schema_check(const char *path, long long format, arc_error *error);
/* The file's format, checked. */
arc_status arc_schema_format(arc_store *store, long long *format, arc_error *error);
/* Makes the tables of a new file. */
arc_status arc_schema_make(arc_store *store, arc_error *error);
/* Brings a file to today's format, in one transaction. */
arc_status arc_schema_update(arc_store *store, arc_error *error);

/* --- digest.c: checksums of finished cases -----------------------------------------------------
 */

/* Whatever changes a case takes its checksum away first; the commit writes those of finished cases
 * anew. */
arc_status arc_store_open_seal(arc_store *store, int id, arc_error *error);
arc_status arc_store_seal_finished(arc_store *store, arc_error *error);
/* Takes away the checksums that match, before the tables change; those of damaged cases stay. */
arc_status arc_store_unseal_sound(arc_store *store, arc_error *error);
/* ARC_FORMAT where the contents of a finished case do not match its checksum; of all of them. */
arc_status arc_store_verify(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_all(arc_store *store, arc_error *error);

/* --- stored_definition.c: the engine's definitions as named values ------------------------------
 */

/* Writes the definition of a run as the values of a case. */
arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error);

#endif

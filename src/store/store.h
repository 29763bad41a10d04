/* The struct arc_store, and functions that only this folder uses. */
#ifndef STORE_STORE_H
#define STORE_STORE_H

#include "archard/atomic_file.h"
#include "archard/store.h"
#include "store/database.h"

#include <stdint.h>

/* The text "arch" as a number. It is SQLite's application_id, at byte 68 of the file. */
#define ARC_STORE_APPLICATION 1634886504

/* SQL expression for the time stamps of cases. */
#define ARC_STORE_NOW "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')"

struct arc_store {
  database *db;
  char *path, *file;          /* name of the file as the user wrote it, and its absolute path */
  arc_atomic_file *temporary; /* new file that has not been published yet, or NULL */
  int older;                  /* true while the tables are in a format older than 5 */
  int verified;               /* id of the case whose checksum was compared last; 0: none */
  int *open; /* ids of the `opened` cases that changed in this transaction and need new checksums */
  size_t opened;
};

/* Names of all columns of the table `arrays` except case_id. */
#define ARC_ARRAYS "part, updates, distance_mm, body, name, rows, columns, numbers"

/* Adds bytes to a checksum and returns the new checksum. The initial checksum is
 * ARC_STORE_CHECKSUM. */
#define ARC_STORE_CHECKSUM 14695981039346656037u

enum { ARC_TEXT_NAME = 24 }; /* size of the name of a text, including the final zero byte */

/* --- damage.c --------------------------------------------------------------------------------- */

/* Sets the error ARC_FORMAT. The message is "PATH: the file is damaged: ", followed by the case
 * and the formatted text. */
arc_status arc_store_damaged(const arc_store *store, arc_error *error, int id, const char *format,
                             ...) __attribute__((format(printf, 4, 5)));
/* If the engine finds an error in the data of a stored case, reports that the file is damaged. An
 * error that can also occur with an intact file keeps its status. */
arc_status arc_store_refused(const arc_store *store, arc_error *error, int id,
                             const arc_error *why);

/* --- rows.c ----------------------------------------------------------------------------------- */

/* Enlarges an array of `count` items by one item of `size` bytes. Returns NULL if memory is
 * exhausted; the array is then unchanged. */
void *arc_store_grown(void *block, size_t count, size_t size);

/* Reads the id of a case from the first column of a row. Errors: ARC_FORMAT if the id is
 * invalid. */
arc_status arc_store_id(arc_store *store, query *q, int *id, arc_error *error);

/* --- transaction.c ---------------------------------------------------------------------------- */

/* Opens a transaction if none is open. Sets *own to 1 if this call opened the transaction,
 * otherwise to 0. */
arc_status arc_store_enter(arc_store *store, int *own, arc_error *error);
/* Ends the transaction if arc_store_enter began it (`own`). Commits if `status` is ARC_OK,
 * otherwise rolls back. Returns `status`, or the error of the commit. */
arc_status arc_store_leave(arc_store *store, int own, arc_status status, arc_error *error);

/* --- rollback.c ------------------------------------------------------------------------------- */

/* These functions begin and end a transaction that only reads a snapshot of the file. The
 * transaction must be short, because programs that write wait for its end. */
arc_status arc_store_look(arc_store *store, int *own, arc_error *error);
void arc_store_look_away(arc_store *store, int own);

/* --- columns.c: SQL texts with the columns of history ----------------------------------------- */

/* Returns an SQL text in which the words of `pattern` are replaced: @columns by ", NAME" for
 * each column of the history; @values by the same number of ", ?"; @results by the columns of
 * the results; @settings by the expressions of the settings; @bytes by all byte values in
 * hexadecimal; @numbers by the columns of `surfaces`; @units by the rows of `units`. The caller
 * frees the text. Returns NULL if memory is exhausted. */
char *arc_columns_sql(const char *pattern);

/* --- statement.c: SQL statements -------------------------------------------------------------- */

/* Runs statements without results. In this function and the two functions below, `sql` is a
 * pattern of arc_columns_sql. */
arc_status arc_store_script(arc_store *store, const char *sql, arc_error *error);

/* Opens a query whose parameter 1 is the id of a case. */
arc_status arc_store_query(arc_store *store, const char *sql, int id, query **q, arc_error *error);

/* Runs a statement whose parameter 1 is the id of a case. */
arc_status arc_store_run(arc_store *store, const char *sql, int id, arc_error *error);

/* --- format.c: format number ------------------------------------------------------------------ */

/* Checks that this program supports the format number of a file. Errors: ARC_FORMAT. */
arc_status arc_schema_check(const char *path, long long format, arc_error *error);
/* Reads and checks the format of the file. */
arc_status arc_schema_format(arc_store *store, long long *format, arc_error *error);

/* --- schema.c: tables and views --------------------------------------------------------------- */

/* Creates the tables of a new file. */
arc_status arc_schema_make(arc_store *store, arc_error *error);
/* Converts a file to the present format, in one transaction. */
arc_status arc_schema_update(arc_store *store, arc_error *error);

/* --- digest.c: checksums of finished cases ---------------------------------------------------- */

/* Removes the checksum of a case. Must be called before the case is changed. At the commit, the
 * case receives a new checksum if it is finished or has a run. Other cases without a checksum
 * were not written by archard and never receive one. */
arc_status arc_store_open_seal(arc_store *store, int id, arc_error *error);
/* Removes the checksums of all cases that the query `ids` returns. */
arc_status arc_store_open_seals(arc_store *store, const char *ids, arc_error *error);
arc_status arc_store_seal_changed(arc_store *store, arc_error *error);
/* Before the tables are changed, removes all correct checksums. Wrong checksums are preserved. A
 * required checksum that is missing is replaced by a wrong one, so that damage is reported. */
arc_status arc_store_unseal_sound(arc_store *store, arc_error *error);
/* arc_store_verify compares the checksum of a case, arc_store_verify_all the checksums of all
 * cases. arc_store_verify_run, for a run that will be read, also requires a checksum. Errors:
 * ARC_FORMAT if a checksum does not match or a finished case has no checksum. */
arc_status arc_store_verify(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_run(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_all(arc_store *store, arc_error *error);
uint64_t arc_store_checksum(uint64_t sum, const void *bytes, size_t count);

/* --- texts.c: long texts, each stored once ---------------------------------------------------- */

/* Stores a long text and sets `name` to the name of the text. For a short text, which is not
 * stored, `name` is "". */
arc_status arc_store_put_text(arc_store *store, const char *text, char name[ARC_TEXT_NAME],
                              arc_error *error);
/* Sets *text to the text with the name `name`, or to NULL if `name` does not have the form of
 * such a name. The caller frees the text. Errors: ARC_FORMAT if the text is missing or does not
 * match the checksum in its name. */
arc_status arc_store_get_text(arc_store *store, const char *name, char **text, arc_error *error);
/* Compares the checksums of all texts with the checksums in their names. Errors: ARC_FORMAT if a
 * text does not match its name. */
arc_status arc_store_verify_texts(arc_store *store, arc_error *error);

/* --- stored_definition.c: the engine's definitions as named values ---------------------------- */

/* Stores the definition of a run in the database as the values of case `id`. */
arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error);

#endif

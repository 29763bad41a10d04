/* Members of arc_store, and functions of this layer. */
#ifndef STORE_STORE_H
#define STORE_STORE_H

#include "archard/atomic_file.h"
#include "archard/store.h"
#include "store/database.h"

#include <stdint.h>

/* The file's application_id, "arch"; at byte 68. */
#define ARC_STORE_APPLICATION 1634886504

/* The time stamps of cases. */
#define ARC_STORE_NOW "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')"

struct arc_store {
  database *db;
  char *path, *file;          /* the name given by the user, and the absolute path */
  arc_atomic_file *temporary; /* where a new file is written until it is published; NULL: none */
  int older;                  /* 1 if the tables still have an older format */
  int verified;               /* the case whose checksum was compared last; 0: none */
  int *open; /* [opened] cases changed in this transaction, whose checksums the commit writes */
  size_t opened;
};

/* Fails with ARC_FORMAT: "PATH: the file is damaged: " and the damage of a case. */
arc_status arc_store_damaged(const arc_store *store, arc_error *error, int id, const char *format,
                             ...) __attribute__((format(printf, 4, 5)));
/* The same for errors of the engine about a case; other statuses are kept. */
arc_status arc_store_refused(const arc_store *store, arc_error *error, int id,
                             const arc_error *why);

/* --- rows.c ----------------------------------------------------------------------------------- */

/* Enlarges a block [count] for one more item of `size` bytes. NULL: out of memory, the block is
 * unchanged. */
void *arc_store_grown(void *block, size_t count, size_t size);

/* Reads the id of a case from the first column of a row. ARC_FORMAT: invalid. */
arc_status arc_store_id(arc_store *store, query *q, int *id, arc_error *error);

/* --- transaction.c ---------------------------------------------------------------------------- */

/* Opens a transaction unless one is open; *own: 1 if it did. */
arc_status arc_store_enter(arc_store *store, int *own, arc_error *error);
/* Ends the transaction of arc_store_enter: commits after ARC_OK, else rolls back. Returns the total
 * status. */
arc_status arc_store_leave(arc_store *store, int own, arc_status status, arc_error *error);
/* The same for readers: until arc_store_look_away they read one snapshot. Writers wait meanwhile,
 * so it must be short. */
arc_status arc_store_look(arc_store *store, int *own, arc_error *error);
void arc_store_look_away(arc_store *store, int own);

/* Columns of the table of arrays after the id of the case. */
#define ARC_ARRAYS "part, updates, distance_mm, body, name, rows, columns, numbers"

/* --- columns.c, statement.c: SQL texts with the columns of history and settings --------------- */

/* The pattern with these words replaced: @columns by ", NAME" for each column of the history,
 * @values by as many ", ?", @results by the columns that are results, @settings by the expressions
 * of the settings, @bytes by all bytes in hexadecimal, @numbers by the columns of `surfaces`,
 * @units by the rows of `units`. To be freed; NULL: out of memory. */
char *arc_columns_sql(const char *pattern);

/* Runs statements without results; `sql` is a pattern here and below. */
arc_status arc_store_script(arc_store *store, const char *sql, arc_error *error);

/* A query of one case, with its id as parameter 1. */
arc_status arc_store_query(arc_store *store, const char *sql, int id, query **q, arc_error *error);

/* Runs a statement with the id of the case as parameter 1. */
arc_status arc_store_run(arc_store *store, const char *sql, int id, arc_error *error);

/* --- format.c, schema.c: the number of a format; tables and views ----------------------------- */

/* Fails with ARC_FORMAT for an unknown format. */
arc_status arc_schema_check(const char *path, long long format, arc_error *error);
/* Reads and checks the format of the file. */
arc_status arc_schema_format(arc_store *store, long long *format, arc_error *error);
/* Creates the tables of a new file. */
arc_status arc_schema_make(arc_store *store, arc_error *error);
/* Converts a file to the present format, in one transaction. */
arc_status arc_schema_update(arc_store *store, arc_error *error);

/* --- digest.c: checksums of finished cases ---------------------------------------------------- */

/* To be called before a case is changed: removes its checksum. The commit writes new ones for these
 * cases, if finished or with a run. Other cases without a checksum were not written by archard and
 * never get one. */
arc_status arc_store_open_seal(arc_store *store, int id, arc_error *error);
/* The same for all cases of the query `ids`. */
arc_status arc_store_open_seals(arc_store *store, const char *ids, arc_error *error);
arc_status arc_store_seal_changed(arc_store *store, arc_error *error);
/* Removes correct checksums before the tables change; wrong ones are kept, and missing ones become
 * wrong ones. */
arc_status arc_store_unseal_sound(arc_store *store, arc_error *error);
/* Checks the checksum of a case: ARC_FORMAT if it does not match, or is missing in a finished case;
 * the same to read a run, which must have one; the same for all cases. */
arc_status arc_store_verify(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_run(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_all(arc_store *store, arc_error *error);

/* Extends a checksum over some bytes. */
#define ARC_STORE_CHECKSUM 14695981039346656037u
uint64_t arc_store_checksum(uint64_t sum, const void *bytes, size_t count);

/* --- texts.c: long texts, once in a file ------------------------------------------------------ */

enum { ARC_TEXT_NAME = 24 }; /* size of a name with its final zero */

/* Stores a long text under `name`; "" for a short text, which is stored in place.
 */
arc_status arc_store_put_text(arc_store *store, const char *text, char name[ARC_TEXT_NAME],
                              arc_error *error);
/* The text of a name, released by free(); NULL if it is not a name. ARC_FORMAT: the text is missing
 * or does not match. */
arc_status arc_store_get_text(arc_store *store, const char *name, char **text, arc_error *error);
/* ARC_FORMAT if a text does not match its name. */
arc_status arc_store_verify_texts(arc_store *store, arc_error *error);

/* --- stored_definition.c: the engine's definitions as named values ---------------------------- */

/* Writes the definition of a run as the values of a case. */
arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error);

#endif

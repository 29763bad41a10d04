/* The inside of an arc_store, for the files of this layer. */
#ifndef STORE_STORE_H
#define STORE_STORE_H

#include "archard/place.h"
#include "archard/store.h"
#include "store/database.h"

#include <stdint.h>

/* The file's application_id, "arch"; at byte 68. */
#define ARC_STORE_APPLICATION 1634886504

/* The time stamps of cases. */
#define ARC_STORE_NOW "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')"

struct arc_store {
  database *db;
  char *path;       /* the file's name for the user */
  arc_place *place; /* where a new file is written until it is published; NULL: none */
  int older;        /* whether the tables are still those of an older format */
  int verified;     /* the case whose checksum was compared last; 0: none */
  int *open; /* [opened] cases changed in this transaction: their checksums are ours to write */
  size_t opened;
};

/* ARC_FORMAT: "PATH: the file is damaged: " and what is wrong with a case. */
arc_status arc_store_damaged(const arc_store *store, arc_error *error, int id, const char *format,
                             ...) __attribute__((format(printf, 4, 5)));
/* The same of what the engine refuses in a case; other statuses than its refusals stay. */
arc_status arc_store_refused(const arc_store *store, arc_error *error, int id,
                             const arc_error *why);

/* --- rows.c -------------------------------------------------------------------------------------
 */

/* The block [count], which only this grows, with room for one more thing of `size` bytes; NULL: out
 * of memory, the block is as it was. */
void *arc_store_grown(void *block, size_t count, size_t size);

/* The id of a case in the first column of a row. ARC_FORMAT: none that a case can have. */
arc_status arc_store_id(arc_store *store, query *q, int *id, arc_error *error);

/* --- transaction.c ------------------------------------------------------------------------------
 */

/* Opens a transaction unless one is open; *own says whether it did. */
arc_status arc_store_enter(arc_store *store, int *own, arc_error *error);
/* Ends what arc_store_enter began: commits after ARC_OK, takes back after anything else. Returns
 * the status of the whole. */
arc_status arc_store_leave(arc_store *store, int own, arc_status status, arc_error *error);
/* The same for whoever only reads: all that is read until arc_store_look_away is of one moment,
 * whatever other programs store meanwhile. They wait for it: nothing is computed in between. */
arc_status arc_store_look(arc_store *store, int *own, arc_error *error);
void arc_store_look_away(arc_store *store, int own);

/* The columns of the table of arrays behind the case's id. */
#define ARC_ARRAYS "part, updates, distance_mm, body, name, rows, columns, numbers"

/* --- columns.c, statement.c: SQL texts with the columns of history and settings -----------------
 */

/* The pattern with these words replaced: @columns by ", NAME" for each column of the history,
 * @values by as many ", ?", @results by the columns that are results, @settings by the expressions
 * of the settings, @bytes by all bytes in hexadecimal, @numbers by the columns of `surfaces`,
 * @units by the rows of `units`. To be freed; NULL: out of memory. */
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

/* Whatever changes a case takes its checksum away first; the commit writes those of cases that are
 * finished or hold a run anew: of these cases alone. What else has none is a stranger's, and is
 * never given one. */
arc_status arc_store_open_seal(arc_store *store, int id, arc_error *error);
/* The same of all cases that the query `ids` gives. */
arc_status arc_store_open_seals(arc_store *store, const char *ids, arc_error *error);
arc_status arc_store_seal_changed(arc_store *store, arc_error *error);
/* Takes away the checksums that match, before the tables change; those of damaged cases stay, and
 * where one is missing there is one that matches nothing. */
arc_status arc_store_unseal_sound(arc_store *store, arc_error *error);
/* ARC_FORMAT where the contents of a case do not match its checksum, or where it is finished and
 * has none; the second for whoever reads a run, which has one in any case; of all cases. */
arc_status arc_store_verify(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_run(arc_store *store, int id, arc_error *error);
arc_status arc_store_verify_all(arc_store *store, arc_error *error);

/* Goes on with a checksum, which begins with the number, over some bytes. */
#define ARC_STORE_CHECKSUM 14695981039346656037u
uint64_t arc_store_checksum(uint64_t sum, const void *bytes, size_t count);

/* --- texts.c: long texts, once in a file --------------------------------------------------------
 */

enum { ARC_TEXT_NAME = 24 }; /* room for a name with its end */

/* Keeps a text that is long; `name` then stands for it, "" for one that may stand where it belongs.
 */
arc_status arc_store_put_text(arc_store *store, const char *text, char name[ARC_TEXT_NAME],
                              arc_error *error);
/* The text that a name stands for, to be freed with free(); NULL: it is no name. ARC_FORMAT: there
 * is none, or another one. */
arc_status arc_store_get_text(arc_store *store, const char *name, char **text, arc_error *error);
/* ARC_FORMAT where a text is not what its name says. */
arc_status arc_store_verify_texts(arc_store *store, arc_error *error);

/* --- stored_definition.c: the engine's definitions as named values ------------------------------
 */

/* Writes the definition of a run as the values of a case. */
arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error);

#endif

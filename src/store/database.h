/* Access to SQLite databases and queries. The parameters of a query are numbered from 1, its
 * columns from 0. */
#ifndef STORE_DATABASE_H
#define STORE_DATABASE_H

#include "archard/base.h"

typedef struct database database;
typedef struct query query;

/* Opens a database. `path` must be an absolute path, or "" for a temporary database. Other names
 * are not allowed, because SQLite interprets names such as "file:..." and ":memory:". With
 * `create` the file must not exist and is created. Error messages contain `name`. */
arc_status arc_database_open(const char *path, const char *name, int writable, int create,
                             database **db, arc_error *error);
void arc_database_close(database **db);
/* Replaces the open database by a temporary copy. The copy is deleted when the database is
 * closed. */
arc_status arc_database_copy(database *db, arc_error *error);
/* Attaches another database as schema "other". */
arc_status arc_database_attach(database *db, const database *other, arc_error *error);

/* Checks all pages of the file. Errors: ARC_FORMAT if the file is damaged. */
arc_status arc_database_check(database *db, arc_error *error);

/* Runs statements without results. */
arc_status arc_database_run(database *db, const char *sql, arc_error *error);

/* Returns the number of rows changed by the last statement. */
int arc_database_changes(const database *db);
/* Returns true if a transaction is open. */
int arc_database_in_transaction(const database *db);

arc_status arc_query_open(database *db, const char *sql, query **result, arc_error *error);
void arc_query_close(query **q);

/* These functions set a parameter of a query. An error is returned by the next call of
 * arc_query_step. Texts and arrays must be valid until that call. */
void arc_query_set_number(query *q, int index, double value);
void arc_query_set_whole(query *q, int index, long long value);
void arc_query_set_text(query *q, int index, const char *text); /* NULL sets the value NULL of
                                                                   SQL */
void arc_query_set_array(query *q, int index, const double *values, size_t count);

/* Computes the next row of the result. Sets *row to 0 if there are no more rows. */
arc_status arc_query_step(query *q, int *row, arc_error *error);

/* Resets a query, so that new parameters can be set. */
void arc_query_reset(query *q);

/* Runs a query without rows and resets it. */
arc_status arc_query_run(query *q, arc_error *error);

typedef enum column_kind {
  COLUMN_NONE,
  COLUMN_WHOLE,
  COLUMN_NUMBER,
  COLUMN_TEXT,
  COLUMN_ARRAY,
  COLUMN_BYTES /* a blob that is not an array of numbers */
} column_kind;

int arc_query_columns(const query *q);
column_kind arc_query_kind(query *q, int column);
double arc_query_number(query *q, int column); /* returns NaN if the value is NULL */
long long arc_query_whole(query *q, int column);
/* Returns "" if the value is NULL. The text is valid until the next call of arc_query_step. */
const char *arc_query_text(query *q, int column);
size_t arc_query_array_count(query *q, int column);
/* Copies the array in a column, at most `count` numbers. */
void arc_query_array(query *q, int column, double *values, size_t count);

#endif

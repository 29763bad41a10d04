/* The only file that calls SQLite. Translates result codes of SQLite to statuses and messages with
 * advice. Lets SQLite open only the run file, its journal and unnamed temporary files. */
#include "store/database.h"
#include "archard/lock.h"
#include "store/journal.h"

#include <math.h>
#include <pthread.h>
#include <sqlite3.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct database {
  sqlite3 *handle;
  char *path, *name;       /* path of the file, and its name in messages */
  long long bytes, beside; /* sizes of the file and of the attached file before the query [bytes] */
  arc_lock_kind locks;
  long long work; /* number of instructions that the query may still execute, divided by WATCH */
};

struct query {
  database *db;
  sqlite3_stmt *statement;
  int failed; /* SQLite's error code for the first parameter that was not set */
  long long rows;
};

/* Longest time that a process waits while another process uses the file [ms]. A transaction
 * needs about 10 ms. */
enum { PATIENCE = 60000 };

static arc_status status_of(int code) {
  switch (code & 0xff) {
  case SQLITE_NOMEM:
    return ARC_MEMORY;
  case SQLITE_CORRUPT:
  case SQLITE_NOTADB:
  case SQLITE_PERM:  /* only from open_guarded, for a file that is not safe */
  case SQLITE_ERROR: /* the program's SQL is correct, so the file lacks a table or column */
  case SQLITE_AUTH:
  case SQLITE_TOOBIG:
  case SQLITE_INTERRUPT: /* the query exceeded its limit of instructions */
    return ARC_FORMAT;
  case SQLITE_CONSTRAINT:
    return ARC_ARGUMENT;
  default:
    return ARC_IO;
  }
}

/* Returns the errno of the last failed operation on the file, or 0. */
static int system_error(const database *db, int code) {
  int number = sqlite3_system_errno(db->handle);
  if ((code & 0xff) == SQLITE_IOERR)
    sqlite3_file_control(db->handle, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
  return number;
}

static const char *read_only(int code) {
  switch (code) {
  case SQLITE_READONLY_ROLLBACK:
    return "a killed program left an unfinished change, which cannot be undone without write "
           "permission";
  case SQLITE_READONLY_DBMOVED:
    return "the file was moved or removed while it was open";
  default:
    return "no permission to write";
  }
}

static const char lock_remedy[] = ": the disk does not support locks, so a file NAME.lock marks "
                                  "the run file NAME as in use; if no "
                                  "program on any machine uses it, remove NAME.lock";

static arc_status fail(const database *db, int code, arc_error *error) {
  const char *why = db->handle ? sqlite3_errmsg(db->handle) : sqlite3_errstr(code);
  const char *remedy = "", *what = "";
  switch (code & 0xff) {
  case SQLITE_FULL:
    why = "the disk is full";
    remedy = "; data stored before is intact";
    break;
  case SQLITE_CANTOPEN:
  case SQLITE_IOERR:
    if (system_error(db, code)) why = strerror(system_error(db, code));
    break;
  case SQLITE_CORRUPT:
  case SQLITE_NOTADB:
    why = "the file is damaged";
    break;
  case SQLITE_PERM:
    why = "the file is damaged: the journal or log beside it was not written by archard";
    break;
  case SQLITE_ERROR:
  case SQLITE_AUTH:
    what = "the file is damaged: ";
    break;
  case SQLITE_TOOBIG:
    why = "the file is damaged: a value is larger than any value of a run";
    break;
  case SQLITE_INTERRUPT:
    why = "the file is damaged: reading it needs too much work for its size";
    break;
  case SQLITE_CONSTRAINT:
    why = "a value occurs twice, or belongs to a case that is missing";
    break;
  case SQLITE_BUSY:
    why = "another program keeps the file locked";
    if (db->locks == ARC_LOCK_BY_NAME) remedy = lock_remedy;
    break;
  case SQLITE_READONLY:
    why = read_only(code);
    break;
  default:
    break;
  }
  return arc_fail(error, status_of(code), "%s: %s%s%s", db->name, what, why, remedy);
}

/* --- limits ----------------------------------------------------------------------------------- */

/* Files are not trusted: for example, pages may form cycles, and tables may be views. Therefore
 * the number of instructions of a query is limited in proportion to the size of the file. The
 * queries of this program need about 50 instructions for a row of 30 bytes, and a few times more
 * for merges. */
enum { WATCH = 10000, LARGEST_VALUE = 64 << 20 };
static const long long work_at_least = 10000000, work_a_byte = 100, rows_at_least = 100000;

static int has_worked_enough(void *context) {
  database *db = context;
  return db->work-- <= 0;
}

static void begin_work(database *db) {
  db->work = (work_at_least + work_a_byte * db->bytes) / WATCH;
}

static void measure(database *db) {
  struct stat file;
  db->bytes = db->beside + (stat(db->path, &file) == 0 ? (long long)file.st_size : 0);
  begin_work(db);
}

/* Prevents SQLite from executing code in the file: views, triggers, and functions with side
 * effects. */
static void distrust(database *db) {
  sqlite3_db_config(db->handle, SQLITE_DBCONFIG_DEFENSIVE, 1, NULL);
  sqlite3_db_config(db->handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, NULL);
  sqlite3_db_config(db->handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, NULL);
  sqlite3_db_config(db->handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, NULL);
  sqlite3_limit(db->handle, SQLITE_LIMIT_LENGTH, LARGEST_VALUE);
  sqlite3_progress_handler(db->handle, WATCH, has_worked_enough, db);
}

/* --- files ------------------------------------------------------------------------------------ */

/* Restricted file system interfaces of SQLite, one interface for each kind of lock. */
enum { KINDS = ARC_LOCK_NONE + 1 };
static const char *const guarded_names[KINDS] = {"archard", "archard-by-name", "archard-alone"};
static const char *const beneath_names[KINDS] = {"unix", "unix-dotfile", "unix-none"};
static sqlite3_vfs guarded[KINDS];
static int (*open_beneath)(sqlite3_vfs *, const char *, sqlite3_file *, int, int *);

/* Opens a file for SQLite. Rejects super-journals, write-ahead logs and unsafe journals
 * (journals that name another file, links, pipes). If such files are beside an untrusted file,
 * SQLite could delete or write any file, or wait forever. SQLite deletes only files that it
 * could open, and the journal of its own file. */
static int open_guarded(sqlite3_vfs *self, const char *name, sqlite3_file *file, int flags,
                        int *given) {
  const int foreign = flags & (SQLITE_OPEN_SUPER_JOURNAL | SQLITE_OPEN_WAL);
  const int journal = name && flags & SQLITE_OPEN_MAIN_JOURNAL;
  file->pMethods = NULL;
  if (foreign || (journal && !arc_journal_is_sound(name))) return SQLITE_PERM;
  return open_beneath(self, name, file, flags, given);
}

static int register_guarded(int kind) {
  sqlite3_vfs *beneath = sqlite3_vfs_find(beneath_names[kind]), *own = &guarded[kind];
  if (sqlite3_vfs_find(guarded_names[kind])) return SQLITE_OK;
  if (!beneath) return SQLITE_NOMEM;
  open_beneath = beneath->xOpen; /* SQLite's open function is the same for all kinds of locks */
  *own = *beneath;
  own->pNext = NULL;
  own->zName = guarded_names[kind];
  own->xOpen = open_guarded;
  if (kind == ARC_LOCK_BY_NAME) { /* SQLite's lock folders do not identify the owner of a lock */
    own->xSetSystemCall(own, "mkdir", (sqlite3_syscall_ptr)arc_lock_take);
    own->xSetSystemCall(own, "rmdir", (sqlite3_syscall_ptr)arc_lock_leave);
  }
  return sqlite3_vfs_register(own, 0);
}

/* Registers the restricted interfaces. Further calls have no effect. */
static int guard(void) {
  static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
  pthread_mutex_lock(&lock);
  int code = SQLITE_OK;
  for (int kind = 0; kind < KINDS && code == SQLITE_OK; kind++) code = register_guarded(kind);
  pthread_mutex_unlock(&lock);
  return code;
}

/* --- lists of numbers ------------------------------------------------------------------------- */

/* A list of the numbers in the rows of an SQL group. */
typedef struct number_list {
  double *number;
  size_t count, capacity;
} number_list;

static int reserve(number_list *list) {
  if (list->count < list->capacity) return 1;
  const size_t capacity = 2 * list->capacity + 64;
  double *grown = realloc(list->number, capacity * sizeof *grown);
  if (!grown) return 0;
  list->number = grown;
  list->capacity = capacity;
  return 1;
}

static void add_number(sqlite3_context *context, int count, sqlite3_value **value) {
  number_list *list = sqlite3_aggregate_context(context, sizeof *list);
  (void)count;
  if (!list || !reserve(list))
    sqlite3_result_error_nomem(context);
  else
    list->number[list->count++] =
        sqlite3_value_type(value[0]) == SQLITE_NULL ? (double)NAN : sqlite3_value_double(value[0]);
}

static void give_numbers(sqlite3_context *context) {
  const number_list *list = sqlite3_aggregate_context(context, 0);
  if (list && list->number)
    sqlite3_result_blob64(context, list->number, list->count * sizeof *list->number, free);
}

/* Defines the SQL function array_of(number), which joins the numbers of a group to one array in
 * the order of the rows. */
static int define_arrays(sqlite3 *handle) {
  return sqlite3_create_function(handle, "array_of", 1, SQLITE_UTF8 | SQLITE_DIRECTONLY, NULL, NULL,
                                 add_number, give_numbers);
}

/* --- databases -------------------------------------------------------------------------------- */

static arc_status configure(database *db, arc_error *error) {
  sqlite3_extended_result_codes(db->handle, 1);
  sqlite3_busy_timeout(db->handle, PATIENCE);
  /* a misspelt column name in double quotes is then an error rather than a text */
  sqlite3_db_config(db->handle, SQLITE_DBCONFIG_DQS_DDL, 0, NULL);
  sqlite3_db_config(db->handle, SQLITE_DBCONFIG_DQS_DML, 0, NULL);
  distrust(db);
  if (define_arrays(db->handle) != SQLITE_OK) return fail(db, SQLITE_NOMEM, error);
  /* The journal is a rollback journal rather than a write-ahead log. Therefore the database is a
   * single file while it is idle, and it may be on a network file system. */
  return arc_database_run(
      db, "PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON; PRAGMA cell_size_check = ON",
      error);
}

static database *new_database(const char *path, const char *name) {
  database *db = calloc(1, sizeof *db);
  if (!db) return NULL;
  db->path = strdup(path);
  db->name = strdup(name);
  if (db->path && db->name) return db;
  arc_database_close(&db);
  return NULL;
}

arc_status arc_database_open(const char *path, const char *name, int writable, int create,
                             database **result, arc_error *error) {
  *result = NULL;
  arc_lock_kind locks = ARC_LOCK_NONE; /* no other process uses the new file yet */
  arc_status status = create ? ARC_OK : arc_lock_look(path, name, &locks, error);
  if (status != ARC_OK) return status;
  database *db = new_database(path, name);
  if (!db) return arc_fail(error, ARC_MEMORY, "%s: out of memory", name);
  db->locks = locks;
  /* SQLite needs no mutex, because only one thread uses a store. Locking a mutex for every
   * parameter would cost a third of the time. */
  int flags = SQLITE_OPEN_NOMUTEX | (writable ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY);
  if (create) flags |= SQLITE_OPEN_CREATE;
  int code = guard();
  if (code == SQLITE_OK) code = sqlite3_open_v2(db->path, &db->handle, flags, guarded_names[locks]);
  status = code == SQLITE_OK ? configure(db, error) : fail(db, code, error);
  if (status != ARC_OK) arc_database_close(&db);
  *result = db;
  return status;
}

void arc_database_close(database **db) {
  if (!db || !*db) return;
  sqlite3_close_v2((*db)->handle);
  free((*db)->path);
  free((*db)->name);
  free(*db);
  *db = NULL;
}

/* Copies a snapshot of the database `from` into the schema `schema` of `to`. */
static arc_status copy(database *to, const char *schema, const database *from, arc_error *error) {
  sqlite3_backup *backup = sqlite3_backup_init(to->handle, schema, from->handle, "main");
  if (backup) sqlite3_backup_step(backup, -1);
  int code = backup ? sqlite3_backup_finish(backup) : sqlite3_errcode(to->handle);
  const database told = {.handle = to->handle, .name = from->name};
  return code == SQLITE_OK ? ARC_OK : fail(&told, code, error);
}

/* Replaces the database by a copy without a file name. SQLite stores a small copy in memory, and
 * a large copy in a hidden file. */
arc_status arc_database_copy(database *db, arc_error *error) {
  database *made;
  arc_status status = arc_database_open("", db->name, 1, 1, &made, error);
  if (status != ARC_OK) return status;
  status = copy(made, "main", db, error);
  if (status == ARC_OK) {
    sqlite3 *original = db->handle;
    db->handle = made->handle;
    made->handle = original;
    sqlite3_progress_handler(db->handle, WATCH, has_worked_enough, db);
  }
  arc_database_close(&made);
  return status;
}

/* Attaches the file `path`. The path is a parameter of the SQL statement, because it may contain
 * any character. */
static arc_status attach(database *db, const char *path, arc_error *error) {
  query *q;
  arc_status status = arc_query_open(db, "ATTACH ?1 AS other", &q, error);
  if (status != ARC_OK) return status;
  arc_query_set_text(q, 1, path);
  status = arc_query_run(q, error);
  arc_query_close(&q);
  return status;
}

/* Attaches another database. If it is a temporary copy, which has no path, its content is copied
 * instead. The attached file is only read, and its journal is in memory. With a journal file,
 * SQLite would treat a change as a change of two files and record it in a third file. */
arc_status arc_database_attach(database *db, const database *other, arc_error *error) {
  const char *path = sqlite3_db_filename(other->handle, "main");
  db->beside = other->bytes;
  arc_status status = attach(db, path, error);
  if (status != ARC_OK) return status;
  if (!*path) status = copy(db, "other", other, error);
  if (status == ARC_OK) status = arc_database_run(db, "PRAGMA other.journal_mode = MEMORY", error);
  if (status != ARC_OK) arc_database_run(db, "DETACH other", NULL);
  return status;
}

arc_status arc_database_run(database *db, const char *sql, arc_error *error) {
  measure(db);
  int code = sqlite3_exec(db->handle, sql, NULL, NULL, NULL);
  return code == SQLITE_OK ? ARC_OK : fail(db, code, error);
}

int arc_database_changes(const database *db) {
  return sqlite3_changes(db->handle);
}

int arc_database_in_transaction(const database *db) {
  return !sqlite3_get_autocommit(db->handle);
}

/* --- queries ---------------------------------------------------------------------------------- */

arc_status arc_query_open(database *db, const char *sql, query **result, arc_error *error) {
  *result = NULL;
  query *q = calloc(1, sizeof *q);
  if (!q) return arc_fail(error, ARC_MEMORY, "%s: out of memory", db->name);
  q->db = db;
  measure(db);
  int code = sqlite3_prepare_v2(db->handle, sql, -1, &q->statement, NULL);
  if (code == SQLITE_OK) {
    *result = q;
    return ARC_OK;
  }
  arc_query_close(&q);
  return fail(db, code, error);
}

void arc_query_close(query **q) {
  if (!q || !*q) return;
  sqlite3_finalize((*q)->statement);
  free(*q);
  *q = NULL;
}

static void note(query *q, int code) {
  if (q->failed == SQLITE_OK) q->failed = code;
}

void arc_query_set_number(query *q, int index, double value) {
  note(q, sqlite3_bind_double(q->statement, index, value));
}

void arc_query_set_whole(query *q, int index, long long value) {
  note(q, sqlite3_bind_int64(q->statement, index, value));
}

void arc_query_set_text(query *q, int index, const char *text) {
  note(q, sqlite3_bind_text(q->statement, index, text, -1, SQLITE_STATIC));
}

void arc_query_set_array(query *q, int index, const double *values, size_t count) {
  /* The address of an empty array may be NULL, which SQLite would store as NULL. */
  const void *bytes = count > 0 ? (const void *)values : "";
  note(q, sqlite3_bind_blob64(q->statement, index, bytes, count * sizeof(double), SQLITE_STATIC));
}

arc_status arc_query_step(query *q, int *row, arc_error *error) {
  *row = 0;
  if (q->failed != SQLITE_OK) return fail(q->db, q->failed, error);
  int code = sqlite3_step(q->statement);
  *row = code == SQLITE_ROW;
  if (*row && ++q->rows > rows_at_least + q->db->bytes) code = SQLITE_INTERRUPT;
  return code == SQLITE_ROW || code == SQLITE_DONE ? ARC_OK : fail(q->db, code, error);
}

void arc_query_reset(query *q) {
  sqlite3_reset(q->statement);
  begin_work(q->db);
}

arc_status arc_query_run(query *q, arc_error *error) {
  int row;
  arc_status status = arc_query_step(q, &row, error);
  arc_query_reset(q);
  return status;
}

int arc_query_columns(const query *q) {
  return sqlite3_column_count(q->statement);
}

column_kind arc_query_kind(query *q, int column) {
  switch (sqlite3_column_type(q->statement, column)) {
  case SQLITE_INTEGER:
    return COLUMN_WHOLE;
  case SQLITE_FLOAT:
    return COLUMN_NUMBER;
  case SQLITE_TEXT:
    return COLUMN_TEXT;
  case SQLITE_BLOB:
    return sqlite3_column_bytes(q->statement, column) % (int)sizeof(double) == 0 ? COLUMN_ARRAY
                                                                                 : COLUMN_BYTES;
  default:
    return COLUMN_NONE;
  }
}

double arc_query_number(query *q, int column) {
  if (arc_query_kind(q, column) == COLUMN_NONE) return (double)NAN;
  return sqlite3_column_double(q->statement, column);
}

long long arc_query_whole(query *q, int column) {
  return sqlite3_column_int64(q->statement, column);
}

const char *arc_query_text(query *q, int column) {
  const unsigned char *text = sqlite3_column_text(q->statement, column);
  return text ? (const char *)text : "";
}

size_t arc_query_array_count(query *q, int column) {
  if (arc_query_kind(q, column) != COLUMN_ARRAY) return 0;
  return (size_t)sqlite3_column_bytes(q->statement, column) / sizeof(double);
}

/* Copies the numbers, because a blob of SQLite may not be aligned for doubles. */
void arc_query_array(query *q, int column, double *values, size_t count) {
  const void *bytes = sqlite3_column_blob(q->statement, column);
  size_t there = arc_query_array_count(q, column);
  if (count > there) count = there;
  if (count > 0) memcpy(values, bytes, count * sizeof *values);
}

/* --- the whole file --------------------------------------------------------------------------- */

/* Reports that the file failed a check. If the check failed because of an I/O error, reports the
 * I/O error instead. */
static arc_status refuse_unsound(const database *db, const char *said, arc_error *error) {
  if (system_error(db, SQLITE_IOERR)) return fail(db, SQLITE_IOERR, error);
  return arc_fail(error, ARC_FORMAT, "%s: the file is damaged: %s", db->name, said);
}

arc_status arc_database_check(database *db, arc_error *error) {
  query *q;
  int row;
  arc_status status = arc_query_open(db, "PRAGMA quick_check(1)", &q, error);
  if (status == ARC_OK) status = arc_query_step(q, &row, error);
  if (status == ARC_OK && strcmp(arc_query_text(q, 0), "ok") != 0)
    status = refuse_unsound(db, arc_query_text(q, 0), error);
  arc_query_close(&q);
  return status;
}

/* Recognises, creates, opens and replaces run files. Reads and writes the notes in a run file, each
 * of which has a name and a text. */
#include "store/journal.h"
#include "store/store.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* --- recognition of run files */

/* Returns true if the file is truncated and has no journal that could restore it. */
static int is_cut_off(const char *path, const unsigned char *header) {
  const int journalled = arc_journal_stands(path);
  struct stat file;
  long long page = header[16] << 8 | header[17];
  if (page == 1) page = 65536;
  return !journalled && stat(path, &file) == 0 && file.st_size < page * arc_big_endian(header + 28);
}

static arc_status check_header(const arc_store *store, const unsigned char *header, size_t size,
                               arc_error *error) {
  const char *path = store->path;
  static const char magic[] = "SQLite format 3";
  if (size < 100 || memcmp(header, magic, sizeof magic) != 0)
    return arc_fail(error, ARC_FORMAT, "%s: not a run file of archard (%s)", path,
                    size == 0 ? "the file is empty"
                              : "the file does not begin like an SQLite database");
  long long application = arc_big_endian(header + 68), format = arc_big_endian(header + 60);
  if (application != ARC_STORE_APPLICATION)
    return arc_fail(error, ARC_FORMAT,
                    "%s: not a run file of archard but another program's database (its application "
                    "id is %lld, expected %d)",
                    path, application, ARC_STORE_APPLICATION);
  arc_status status = arc_schema_check(path, format, error);
  if (status == ARC_OK && is_cut_off(store->file, header))
    return arc_fail(error, ARC_FORMAT, "%s: the file is damaged: it is truncated", path);
  return status;
}

/* Checks the header before SQLite opens the file, because SQLite may write to any database file. */
static arc_status check_file(const arc_store *store, arc_error *error) {
  unsigned char header[100];
  FILE *file;
  const arc_status status = arc_file_open(store->path, &file, error);
  if (status != ARC_OK) return status;
  size_t size = fread(header, 1, sizeof header, file);
  int failed = ferror(file) ? errno : 0;
  fclose(file);
  if (failed) return arc_fail(error, ARC_IO, "%s: %s", store->path, strerror(failed));
  return check_header(store, header, size, error);
}

/* --- opening and creating files --------------------------------------------------------------- */

static arc_status new_store(const char *path, arc_file_use use, arc_store **store,
                            arc_error *error) {
  char file[PATH_MAX];
  *store = NULL;
  const arc_status status = arc_file_find(path, use, file, error);
  if (status != ARC_OK) return status;
  *store = calloc(1, sizeof **store);
  if (*store) (*store)->path = strdup(path), (*store)->file = strdup(file);
  if (*store && (*store)->path && (*store)->file) return ARC_OK;
  arc_store_close(store);
  return arc_fail(error, ARC_MEMORY, "%s: out of memory", path);
}

void arc_store_close(arc_store **store) {
  if (!store || !*store) return;
  arc_database_close(&(*store)->db);
  arc_atomic_file_discard(&(*store)->temporary);
  free((*store)->open);
  free((*store)->path);
  free((*store)->file);
  free(*store);
  *store = NULL;
}

const char *arc_store_path(const arc_store *store) {
  return store->path;
}

/* Returns an error if there is a journal without its file. SQLite would apply this journal to
 * the new file. */
static arc_status check_left(const arc_store *store, arc_error *error) {
  if (!arc_journal_stands(store->file) || access(store->file, F_OK) == 0) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "%s: not created, because %s-journal is the journal of a file that no longer "
                  "exists; remove this journal",
                  store->path, store->path);
}

/* Creates the complete new file under a temporary name. */
static arc_status make_beside(arc_store *store, arc_error *error) {
  arc_status status = check_left(store, error);
  if (status == ARC_OK) status = arc_atomic_file_create(store->path, &store->temporary, error);
  if (status == ARC_OK)
    status = arc_database_open(arc_atomic_file_path(store->temporary), store->path, 1, 1,
                               &store->db, error);
  return status == ARC_OK ? arc_schema_make(store, error) : status;
}

/* Creates a file and opens it. If several programs create a file with the same name at once, the
 * first program creates it and all others open it. */
static arc_status create(arc_store *store, arc_error *error) {
  arc_status status = make_beside(store, error);
  arc_database_close(&store->db);
  if (status == ARC_OK) status = arc_atomic_file_publish_first(&store->temporary, error);
  return status == ARC_OK ? arc_database_open(store->file, store->path, 1, 0, &store->db, error)
                          : status;
}

/* Converts a file of an older format. If the store is opened for writing, the file itself is
 * converted. Otherwise a temporary copy is converted. */
static arc_status bring_up_to_date(arc_store *store, arc_store_mode mode, arc_error *error) {
  long long format;
  arc_status status = arc_schema_format(store, &format, error);
  if (status != ARC_OK || format == ARC_STORE_FORMAT) return status;
  if (mode == ARC_STORE_READ) status = arc_database_copy(store->db, error);
  return status == ARC_OK ? arc_schema_update(store, error) : status;
}

/* Opens a file. Even in read mode the file is opened for writing if possible, because only then
 * can SQLite roll back the transaction of a program that was killed. In read mode this program
 * itself does not write. */
static arc_status open_existing(arc_store *store, arc_store_mode mode, arc_error *error) {
  int writable = mode != ARC_STORE_READ || access(store->file, W_OK) == 0;
  arc_status status = arc_database_open(store->file, store->path, writable, 0, &store->db, error);
  if (status == ARC_OK) status = bring_up_to_date(store, mode, error);
  if (status == ARC_OK && mode == ARC_STORE_READ)
    status = arc_database_run(store->db, "PRAGMA query_only = ON", error);
  return status;
}

arc_status arc_store_open(const char *path, arc_store_mode mode, arc_store **result,
                          arc_error *error) {
  arc_store *store;
  arc_status status =
      new_store(path, mode == ARC_STORE_READ ? ARC_FILE_READ : ARC_FILE_WRITE, &store, error);
  if (status == ARC_OK && mode == ARC_STORE_CREATE && access(store->file, F_OK) != 0) {
    status = create(store, error);
  } else if (status == ARC_OK) {
    status = check_file(store, error);
    if (status == ARC_OK) status = open_existing(store, mode, error);
  }
  if (status != ARC_OK) arc_store_close(&store);
  *result = store;
  return status;
}

/* Sets *empty to 1 if the file has no cases, otherwise to 0. */
static arc_status is_empty(arc_store *store, int *empty, arc_error *error) {
  arc_case *cases;
  size_t count;
  const arc_status status = arc_store_cases(store, &cases, &count, error);
  *empty = count == 0;
  free(cases);
  return status;
}

/* Checks the kind of a file. A file without a kind is accepted if it has no cases, because a
 * program that is killed at its start creates such a file. */
static arc_status check_kind(arc_store *old, const char *kind, arc_error *error) {
  char *found = NULL;
  int empty = 0;
  arc_status status = arc_store_info(old, "kind", &found, error);
  if (status == ARC_OK && !found) status = is_empty(old, &empty, error);
  if (status == ARC_OK && !empty && (!found || strcmp(found, kind) != 0))
    status = arc_fail(error, ARC_ARGUMENT, "%s: not replaced: it holds a %s, expected a %s",
                      arc_store_path(old), found ? found : "file without a kind", kind);
  free(found);
  return status;
}

/* Checks the path of a new file. If a file with this path exists, it must be of the same kind. */
static arc_status check_replaced(const arc_store *store, const char *kind, arc_error *error) {
  if (access(store->file, F_OK) != 0) return ARC_OK;
  arc_store *old = NULL;
  arc_status status = arc_store_open(store->path, ARC_STORE_READ, &old, error);
  if (status == ARC_OK) status = check_kind(old, kind, error);
  arc_store_close(&old);
  return status;
}

arc_status arc_store_replace(const char *path, const char *kind, arc_store **result,
                             arc_error *error) {
  arc_store *store;
  arc_status status = new_store(path, ARC_FILE_WRITE, &store, error);
  if (status == ARC_OK) status = check_replaced(store, kind, error);
  if (status == ARC_OK) status = make_beside(store, error);
  if (status == ARC_OK) status = arc_store_set_info(store, "kind", kind, error);
  if (status != ARC_OK) arc_store_close(&store);
  *result = store;
  return status;
}

arc_status arc_store_publish(arc_store **store, arc_error *error) {
  if (!(*store)->temporary)
    return arc_fail(error, ARC_ARGUMENT, "%s: this store was not made to replace a file",
                    (*store)->path);
  arc_database_close(&(*store)->db);
  arc_status status = arc_atomic_file_publish(&(*store)->temporary, error);
  arc_store_close(store);
  return status;
}

arc_status arc_store_check(arc_store *store, arc_error *error) {
  arc_status status = arc_database_check(store->db, error);
  if (status == ARC_OK) status = arc_store_verify_texts(store, error);
  return status == ARC_OK ? arc_store_verify_all(store, error) : status;
}

/* --- notes ------------------------------------------------------------------------------------ */

arc_status arc_store_set_info(arc_store *store, const char *name, const char *text,
                              arc_error *error) {
  query *q;
  arc_status status =
      arc_query_open(store->db,
                     text ? "INSERT OR REPLACE INTO info (name, value) VALUES (?1, ?2)"
                          : "DELETE FROM info WHERE name = ?1",
                     &q, error);
  if (status != ARC_OK) return status;
  arc_query_set_text(q, 1, name);
  if (text) arc_query_set_text(q, 2, text);
  status = arc_query_run(q, error);
  arc_query_close(&q);
  return status;
}

arc_status arc_store_info(arc_store *store, const char *name, char **text, arc_error *error) {
  *text = NULL;
  query *q;
  int row;
  arc_status status =
      arc_query_open(store->db, "SELECT value FROM info WHERE name = ?1", &q, error);
  if (status != ARC_OK) return status;
  arc_query_set_text(q, 1, name);
  status = arc_query_step(q, &row, error);
  if (status == ARC_OK && row) {
    *text = strdup(arc_query_text(q, 0));
    if (!*text) status = arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  }
  arc_query_close(&q);
  return status;
}

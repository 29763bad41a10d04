/* Locks files, also on disks that do not support file locks or do not respond. */
#include "archard/lock.h"

#include "core/base/owner.h"
#include "core/base/worker_thread.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* --- kinds of locks */

/* A query whether the disk of a file supports locks. It runs on a separate thread, because it never
 * returns if the lock daemon is dead. */
typedef struct question {
  work_progress progress;
  int file, answer; /* descriptor of the file; result of the query: 0 or an errno */
} question;

/* Tests whether the disk supports locks: queries the lock of one byte of the file, at the offset
 * 2^30, which SQLite also locks in database files. Stores 0 or an errno as the result. */
static arc_status ask(void *job) {
  question *q = job;
  struct flock lock = {.l_type = F_RDLCK, .l_whence = SEEK_SET, .l_start = 1 << 30, .l_len = 1};
  q->answer = fcntl(q->file, F_GETLK, &lock) == 0 ? 0 : errno;
  return ARC_OK;
}

static void discard(void *job) {
  question *q = job;
  if (q->file >= 0) close(q->file);
  free(q);
}

/* Time limit for a lock query to the disk [s]. */
enum { PATIENCE = 10 };

static int has_waited(void *context) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec >= *(const time_t *)context;
}

/* Queries the locks of a file. Returns 0 if the disk supports locks, ETIMEDOUT if it does not
 * respond, or another errno. */
static int locks_of(const char *path) {
  struct timespec now;
  question *q = calloc(1, sizeof *q);
  if (!q) return ENOMEM;
  q->file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  clock_gettime(CLOCK_MONOTONIC, &now);
  time_t until = now.tv_sec + PATIENCE;
  const arc_callbacks patience = {.stop = has_waited, .context = &until};
  const worker_task work = {ask, discard, &q->progress};
  int left = 0;
  if (arc_worker_thread_run(&work, q, "", &patience, &left) == ARC_STOPPED) return ETIMEDOUT;
  const int answer = q->answer;
  discard(q);
  return answer;
}

/* Returns true if a file can be created in the folder of the path. */
static int is_folder_writable(const char *path) {
  char folder[PATH_MAX];
  snprintf(folder, sizeof folder, "%.*s", (int)(strrchr(path, '/') + 1 - path), path);
  return access(folder, W_OK) == 0;
}

arc_status arc_lock_look(const char *path, const char *name, arc_lock_kind *kind,
                         arc_error *error) {
  const int why = locks_of(path);
  *kind = ARC_LOCK_SYSTEM;
  if (why == ETIMEDOUT)
    return arc_fail(error, ARC_IO, "%s: the disk has not answered a lock request within %d s", name,
                    PATIENCE);
  if (why == ENOLCK || why == ENOSYS || why == EOPNOTSUPP)
    *kind = is_folder_writable(path) ? ARC_LOCK_BY_NAME : ARC_LOCK_NONE;
  return ARC_OK;
}

/* --- by name ---------------------------------------------------------------------------------- */

static int is_left(const char *lock) {
  char text[ARC_OWNER];
  const ssize_t length = readlink(lock, text, sizeof text - 1);
  if (length < 0) return 0;
  text[length] = '\0';
  return arc_owner_look(text) == ARC_OWNER_GONE;
}

static int make(const char *lock) {
  char owner[ARC_OWNER];
  arc_owner_name(owner);
  return symlink(owner, lock);
}

/* Removes an abandoned lock. If several programs find this lock, one of them creates a second lock,
 * LOCK-turn. Only this program checks the first lock again and removes it. If a killed program left
 * a second lock, it is removed in the same manner. */
static void remove_left(const char *lock) {
  char turn[PATH_MAX];
  if ((size_t)snprintf(turn, sizeof turn, "%s-turn", lock) >= sizeof turn) return;
  if (make(turn) != 0) {
    if (errno != EEXIST || !is_left(turn)) return;
    remove_left(turn);
    if (make(turn) != 0) return;
  }
  if (is_left(lock)) unlink(lock);
  unlink(turn);
}

int arc_lock_take(const char *lock, mode_t ignored) {
  (void)ignored;
  if (make(lock) == 0) return 0;
  if (errno != EEXIST) return -1;
  if (is_left(lock)) {
    remove_left(lock);
    return make(lock);
  }
  errno =
      EEXIST; /* restores errno, which readlink changes if the owner meanwhile removes the lock */
  return -1;
}

int arc_lock_leave(const char *lock) {
  return unlink(lock);
}

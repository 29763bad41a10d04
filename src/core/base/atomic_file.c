/* Writes files atomically (POSIX). The name of a temporary file, ".archard-part-SYSTEM-PID-TIME",
 * identifies the program that writes it. Files of killed programs are therefore recognised without
 * locks, which network disks may not support. */
#include "archard/atomic_file.h"
#include "core/base/owner.h"
#include "core/base/resolve.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static const char prefix[] = ".archard-part-";

struct arc_atomic_file {
  int descriptor;        /* descriptor of the temporary file */
  char name[PATH_MAX];   /* name given by the user, for messages */
  char target[PATH_MAX]; /* path of the final file without symbolic links; "" for a scratch file */
  char path[PATH_MAX];   /* path of the temporary file */
  size_t folder;         /* length of the folder part of `path`, with the final slash */
  int stream;            /* 1: the target is a device, a pipe, or a file that is already open */
  int own;               /* N if the target is "/proc/PID/fd/N" of this process, else -1 */
};

static arc_status failed(const char *name, int why, arc_error *error) {
  return arc_file_failed(name, ARC_FILE_WRITE, why, error);
}

static int is_temporary(const char *name) {
  return strncmp(name, prefix, sizeof prefix - 1) == 0;
}

/* --- files of killed programs ----------------------------------------------------------------- */

/* Suffix of the journal that SQLite writes beside a database file. */
static const char journal[] = "-journal";

static void remove_temporary(int folder, const char *name) {
  char beside[NAME_MAX + sizeof journal];
  snprintf(beside, sizeof beside, "%s%s", name, journal);
  unlinkat(folder, beside, 0);
  unlinkat(folder, name, 0);
}

/* Temporary files of other computers count as abandoned at this age [s]: ten days, the age at which
 * systemd removes files from /tmp (tmpfiles.d). */
static const double longest = 10 * 86400.0;

static int is_abandoned(const char *name, const struct stat *facts) {
  const arc_owner_state owner = arc_owner_look(name + sizeof prefix - 1);
  if (owner != ARC_OWNER_ELSEWHERE) return owner == ARC_OWNER_GONE;
  return difftime(time(NULL), facts->st_mtime) > longest;
}

static void clean_temporary(int folder, const char *name) {
  struct stat facts;
  if (fstatat(folder, name, &facts, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(facts.st_mode) &&
      facts.st_uid == geteuid() && is_abandoned(name, &facts))
    remove_temporary(folder, name);
}

void arc_atomic_file_clean(const char *folder) {
  DIR *list = opendir(folder);
  if (!list) return;
  for (struct dirent *entry; (entry = readdir(list));)
    if (is_temporary(entry->d_name) && !strstr(entry->d_name, journal))
      clean_temporary(dirfd(list), entry->d_name);
  closedir(list);
}

/* --- the target ------------------------------------------------------------------------------- */

/* Checks that an open descriptor is writable. Returns 0 or an errno. */
static int check_descriptor(arc_atomic_file *file) {
  const int flags = fcntl(file->own, F_GETFL);
  file->stream = 1;
  if (flags < 0) return errno;
  return (flags & O_ACCMODE) == O_RDONLY ? EACCES : 0;
}

/* Checks that the target is writable if it exists. Sets *mode to its permissions, or to 0 if there
 * is no such file. Returns 0 or an errno. */
static int check_target(arc_atomic_file *file, mode_t *mode) {
  struct stat facts;
  *mode = 0;
  file->own = arc_file_descriptor(file->target);
  if (file->own >= 0) return check_descriptor(file);
  if (stat(file->target, &facts) != 0) return errno == ENOENT ? 0 : errno;
  if (S_ISDIR(facts.st_mode)) return EISDIR;
  if (access(file->target, W_OK) != 0) return errno;
  file->stream = !S_ISREG(facts.st_mode);
  if (!file->stream) *mode = facts.st_mode & 07777;
  return 0;
}

/* Copies the folder of an absolute path, with its final slash, to file->path. Returns 0 or an
 * errno. */
static int set_folder(arc_atomic_file *file, const char *path) {
  file->folder = (size_t)(strrchr(path, '/') - path) + 1;
  if (file->folder >= PATH_MAX - NAME_MAX) return ENAMETOOLONG;
  memcpy(file->path, path, file->folder);
  return 0;
}

/* --- creating --------------------------------------------------------------------------------- */

/* Creates a temporary file with a name that this process has never used, because another program
 * may still be removing a file with an earlier name. Returns 0 or an errno. */
static int create_temporary(arc_atomic_file *file) {
  char owner[ARC_OWNER];
  arc_owner_name(owner);
  for (int tried = 0; tried < 100; tried++) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    snprintf(file->path + file->folder, PATH_MAX - file->folder, "%s%s-%lld%09ld", prefix, owner,
             (long long)now.tv_sec, now.tv_nsec);
    file->descriptor = open(file->path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file->descriptor >= 0) return 0;
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

static int create(arc_atomic_file *file, mode_t mode) {
  char *name = file->path + file->folder;
  *name = '\0';
  arc_atomic_file_clean(file->path);
  int why = create_temporary(file);
  if (!why && mode && fchmod(file->descriptor, mode) != 0) why = errno;
  return why;
}

static arc_atomic_file *new_file(const char *name) {
  arc_atomic_file *file = calloc(1, sizeof *file);
  if (!file) return NULL;
  file->descriptor = file->own = -1;
  snprintf(file->name, sizeof file->name, "%s", name);
  return file;
}

/* If `why` is 0, sets *result to `file` and returns ARC_OK. If `why` is an errno, discards the
 * file, sets *result to NULL and returns an error. */
static arc_status finish(arc_atomic_file *file, int why, arc_atomic_file **result,
                         arc_error *error) {
  arc_status status = why ? failed(file->name, why, error) : ARC_OK;
  if (why) arc_atomic_file_discard(&file);
  *result = file;
  return status;
}

arc_status arc_atomic_file_create(const char *name, arc_atomic_file **result, arc_error *error) {
  *result = NULL;
  mode_t mode = 0;
  arc_atomic_file *file = new_file(name);
  if (!file) return arc_fail(error, ARC_MEMORY, "out of memory for writing '%.200s'", name);
  const arc_status status = arc_file_find(name, ARC_FILE_WRITE, file->target, error);
  if (status != ARC_OK) {
    arc_atomic_file_discard(&file);
    return status;
  }
  int why = check_target(file, &mode);
  if (!why) why = set_folder(file, file->stream ? P_tmpdir "/" : file->target);
  if (!why) why = create(file, mode);
  return finish(file, why, result, error);
}

arc_status arc_atomic_file_create_scratch(const char *folder, arc_atomic_file **result,
                                          arc_error *error) {
  *result = NULL;
  arc_atomic_file *file = new_file(folder);
  if (!file)
    return arc_fail(error, ARC_MEMORY, "out of memory while creating a file in the folder '%.200s'",
                    folder);
  char whole[PATH_MAX + 1];
  int why = realpath(folder, whole) ? set_folder(file, strcat(whole, "/")) : errno;
  if (!why) why = create(file, S_IRUSR | S_IWUSR);
  return finish(file, why, result, error);
}

const char *arc_atomic_file_path(const arc_atomic_file *file) {
  return file->path;
}

const char *arc_atomic_file_name(const arc_atomic_file *file) {
  return file->name;
}

/* --- publishing ------------------------------------------------------------------------------- */

void arc_atomic_file_discard(arc_atomic_file **file) {
  if (!file || !*file) return;
  if ((*file)->descriptor >= 0) {
    unlink((*file)->path);
    close((*file)->descriptor);
  }
  free(*file);
  *file = NULL;
}

/* Opens the target for writing. If it is an open descriptor of this process, flushes all streams
 * first and duplicates the descriptor. Returns -1 with errno on failure. */
static int open_stream(const arc_atomic_file *file) {
  if (file->own < 0) return open(file->target, O_WRONLY | O_CLOEXEC | O_NOCTTY);
  fflush(NULL);
  return fcntl(file->own, F_DUPFD_CLOEXEC, 0);
}

/* Writes `count` bytes to the descriptor `to`. Returns 0 or an errno. */
static int write_all(int to, const char *bytes, size_t count) {
  while (count > 0) {
    const ssize_t written = write(to, bytes, count);
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes += written, count -= (size_t)written;
  }
  return 0;
}

/* Copies the file to a device, pipe or open descriptor. Returns 0 or an errno. */
static int copy_to_stream(const arc_atomic_file *file) {
  char block[1 << 16];
  const int from = file->descriptor, to = open_stream(file);
  if (to < 0) return errno;
  int why = lseek(from, 0, SEEK_SET) < 0 ? errno : 0;
  ssize_t got = 1;
  while (!why && got > 0) {
    got = read(from, block, sizeof block);
    why = got < 0 ? errno : write_all(to, block, (size_t)got);
  }
  if (close(to) != 0 && !why) why = errno;
  return why;
}

/* Flushes the folder of the file to disk, if the file system supports it, so that the new file name
 * is stored. */
static void sync_folder(const arc_atomic_file *file) {
  char folder[PATH_MAX];
  snprintf(folder, sizeof folder, "%.*s", (int)file->folder, file->path);
  int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/* Renames the file `path` to `target` unless `target` exists. On file systems without hard links,
 * an existing target is replaced. Returns 0 or an errno. */
static int name_first(const char *path, const char *target) {
  if (link(path, target) == 0 || errno == EEXIST) return unlink(path) == 0 ? 0 : errno;
  if (errno != EPERM && errno != ENOTSUP && errno != ENOSYS) return errno;
  return rename(path, target) == 0 ? 0 : errno;
}

/* Moves or copies the temporary file to its target. If `first` is true, an existing target is kept.
 * Returns 0 or an errno. */
static int publish_name(arc_atomic_file *file, int first) {
  if (file->stream) return copy_to_stream(file);
  if (fsync(file->descriptor) != 0) return errno;
  int why = 0;
  if (first)
    why = name_first(file->path, file->target);
  else if (rename(file->path, file->target) != 0)
    why = errno;
  if (why) return why;
  sync_folder(file);
  close(file->descriptor);
  file->descriptor = -1;
  return 0;
}

static arc_status publish(arc_atomic_file **file, int first, arc_error *error) {
  int why = publish_name(*file, first);
  arc_status status = why ? failed((*file)->name, why, error) : ARC_OK;
  arc_atomic_file_discard(file);
  return status;
}

arc_status arc_atomic_file_publish(arc_atomic_file **file, arc_error *error) {
  return publish(file, 0, error);
}

arc_status arc_atomic_file_publish_first(arc_atomic_file **file, arc_error *error) {
  return publish(file, 1, error);
}

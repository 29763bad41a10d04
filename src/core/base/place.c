/* Files that appear whole or not at all. Leans on POSIX.
 *
 * A place is a file ".archard-part-SYSTEM-PID-TIME": one whose program is not there any more was
 * left by it. Nobody asks for locks, which disks on a network may not have, or wait for.
 */
#include "archard/place.h"
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

struct arc_place {
  int descriptor;        /* of the place */
  char asked[PATH_MAX];  /* name given by the user, for messages */
  char target[PATH_MAX]; /* the file itself, behind symbolic links; "" for scratch */
  char path[PATH_MAX];   /* of the place */
  size_t folder;         /* letters of path that are the folder, with its slash */
  int stream;            /* the target is a device, a pipe, or open already */
  int own;               /* the descriptor of this process that the target names, or -1 */
};

static arc_status failed(const char *path, int why, arc_error *error) {
  const char *reason = why == EILSEQ ? "a control character in its folder's name" : strerror(why);
  return arc_fail(error, ARC_IO, "cannot write '%.200s': %s", path, reason);
}

static int has_control(const char *path) {
  for (const char *c = path; *c; c++)
    if ((unsigned char)*c < 0x20 || *c == 0x7f) return 1;
  return 0;
}

static int is_part(const char *name) {
  return strncmp(name, prefix, sizeof prefix - 1) == 0;
}

/* --- what was left ---------------------------------------------------------------------------- */

/* A database keeps its journal beside it. */
static const char journal[] = "-journal";

static void remove_part(int folder, const char *name) {
  char beside[NAME_MAX + sizeof journal];
  snprintf(beside, sizeof beside, "%s%s", name, journal);
  unlinkat(folder, beside, 0);
  unlinkat(folder, name, 0);
}

/* Files of other systems count as abandoned after ten days, the age at which systemd removes files
 * in /tmp (tmpfiles.d). */
static const double longest = 10 * 86400.0;

static int is_left(const char *name, const struct stat *facts) {
  const arc_owner_state owner = arc_owner_look(name + sizeof prefix - 1);
  if (owner != ARC_OWNER_ELSEWHERE) return owner == ARC_OWNER_GONE;
  return difftime(time(NULL), facts->st_mtime) > longest;
}

static void sweep_part(int folder, const char *name) {
  struct stat facts;
  if (fstatat(folder, name, &facts, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(facts.st_mode) &&
      facts.st_uid == geteuid() && is_left(name, &facts))
    remove_part(folder, name);
}

void arc_place_sweep(const char *folder) {
  DIR *list = opendir(folder);
  if (!list) return;
  for (struct dirent *entry; (entry = readdir(list));)
    if (is_part(entry->d_name) && !strstr(entry->d_name, journal))
      sweep_part(dirfd(list), entry->d_name);
  closedir(list);
}

/* --- whose place it is ------------------------------------------------------------------------ */

static arc_status check_name(const char *path, arc_error *error) {
  if (!path[0]) return arc_fail(error, ARC_ARGUMENT, "a file without a name");
  if (has_control(path))
    return arc_fail(error, ARC_ARGUMENT, "a file name with a control character in it");
  return strlen(path) < PATH_MAX - NAME_MAX
             ? ARC_OK
             : arc_fail(error, ARC_ARGUMENT, "'%.200s...': the path is too long", path);
}

/* Checks that an open descriptor is writable. Returns 0 or an errno. */
static int look_at_own(arc_place *place) {
  const int flags = fcntl(place->own, F_GETFL);
  place->stream = 1;
  if (flags < 0) return errno;
  return (flags & O_ACCMODE) == O_RDONLY ? EACCES : 0;
}

/* Checks an existing file and copies its permissions. Returns 0 or an errno. */
static int look_at(arc_place *place, mode_t *mode) {
  struct stat facts;
  *mode = 0;
  place->own = arc_file_descriptor(place->target);
  if (place->own >= 0) return look_at_own(place);
  if (stat(place->target, &facts) != 0) return errno == ENOENT ? 0 : errno;
  if (S_ISDIR(facts.st_mode)) return EISDIR;
  if (access(place->target, W_OK) != 0) return errno;
  place->stream = !S_ISREG(facts.st_mode);
  if (!place->stream) *mode = facts.st_mode & 07777;
  return 0;
}

/* Sets the folder of an absolute path, with its slash. Returns 0 or an errno. */
static int set_folder(arc_place *place, const char *path) {
  place->folder = (size_t)(strrchr(path, '/') - path) + 1;
  if (place->folder >= PATH_MAX - NAME_MAX) return ENAMETOOLONG;
  memcpy(place->path, path, place->folder);
  return has_control(place->path) ? EILSEQ : 0;
}

/* --- taking ----------------------------------------------------------------------------------- */

/* Creates a file of a name never used by this process, as another program may still be removing the
 * last one. Returns 0 or an errno. */
static int make_part(arc_place *place) {
  char owner[ARC_OWNER];
  arc_owner_name(owner);
  for (int tried = 0; tried < 100; tried++) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    snprintf(place->path + place->folder, PATH_MAX - place->folder, "%s%s-%lld%09ld", prefix, owner,
             (long long)now.tv_sec, now.tv_nsec);
    place->descriptor = open(place->path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (place->descriptor >= 0) return 0;
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

static int take(arc_place *place, mode_t mode) {
  char *name = place->path + place->folder;
  *name = '\0';
  arc_place_sweep(place->path);
  int why = make_part(place);
  if (!why && mode && fchmod(place->descriptor, mode) != 0) why = errno;
  return why;
}

static arc_place *new_place(const char *asked) {
  arc_place *place = calloc(1, sizeof *place);
  if (!place) return NULL;
  place->descriptor = place->own = -1;
  snprintf(place->asked, sizeof place->asked, "%s", asked);
  return place;
}

/* Returns the place, or drops it and fails. */
static arc_status given(arc_place *place, int why, arc_place **result, arc_error *error) {
  arc_status status = why ? failed(place->asked, why, error) : ARC_OK;
  if (why) arc_place_drop(&place);
  *result = place;
  return status;
}

arc_status arc_place_take(const char *path, arc_place **result, arc_error *error) {
  *result = NULL;
  mode_t mode = 0;
  arc_status status = check_name(path, error);
  if (status == ARC_OK) status = arc_file_allowed(path, ARC_FILE_WRITE, error);
  if (status != ARC_OK) return status;
  arc_place *place = new_place(path);
  if (!place) return arc_fail(error, ARC_MEMORY, "out of memory for writing '%.200s'", path);
  int why = arc_file_resolve(path, place->target);
  if (!why) why = look_at(place, &mode);
  if (!why) why = set_folder(place, place->stream ? P_tmpdir "/" : place->target);
  if (!why) why = take(place, mode);
  return given(place, why, result, error);
}

arc_status arc_place_scratch(const char *folder, arc_place **result, arc_error *error) {
  *result = NULL;
  arc_place *place = new_place(folder);
  if (!place) return arc_fail(error, ARC_MEMORY, "out of memory for a file in '%.200s'", folder);
  char whole[PATH_MAX + 1];
  int why = realpath(folder, whole) ? set_folder(place, strcat(whole, "/")) : errno;
  if (!why) why = take(place, S_IRUSR | S_IWUSR);
  return given(place, why, result, error);
}

const char *arc_place_path(const arc_place *place) {
  return place->path;
}

const char *arc_place_asked(const arc_place *place) {
  return place->asked;
}

/* --- ending ----------------------------------------------------------------------------------- */

void arc_place_drop(arc_place **place) {
  if (!place || !*place) return;
  if ((*place)->descriptor >= 0) {
    unlink((*place)->path);
    close((*place)->descriptor);
  }
  free(*place);
  *place = NULL;
}

/* Opens the target for writing, after flushing standard output. Returns -1 with errno on failure.
 */
static int open_stream(const arc_place *place) {
  if (place->own < 0) return open(place->target, O_WRONLY | O_CLOEXEC | O_NOCTTY);
  fflush(NULL);
  return fcntl(place->own, F_DUPFD_CLOEXEC, 0);
}

/* Returns an errno. */
static int write_all(int to, const char *bytes, size_t count) {
  while (count > 0) {
    const ssize_t written = write(to, bytes, count);
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes += written, count -= (size_t)written;
  }
  return 0;
}

/* Copies the place to a device, pipe or open descriptor. Returns 0 or an errno. */
static int pour(const arc_place *place) {
  char block[1 << 16];
  const int from = place->descriptor, to = open_stream(place);
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

/* Flushes the folder, if the disk supports it, so that the name is on the disk. */
static void sync_folder(const arc_place *place) {
  char folder[PATH_MAX];
  snprintf(folder, sizeof folder, "%.*s", (int)place->folder, place->path);
  int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/* Renames unless the name exists; on disks without hard links always. Returns 0 or an errno. */
static int name_first(const char *path, const char *target) {
  if (link(path, target) == 0 || errno == EEXIST) return unlink(path) == 0 ? 0 : errno;
  if (errno != EPERM && errno != ENOTSUP && errno != ENOSYS) return errno;
  return rename(path, target) == 0 ? 0 : errno;
}

/* Returns an errno. */
static int give_name(arc_place *place, int first) {
  if (place->stream) return pour(place);
  if (fsync(place->descriptor) != 0) return errno;
  int why = 0;
  if (first)
    why = name_first(place->path, place->target);
  else if (rename(place->path, place->target) != 0)
    why = errno;
  if (why) return why;
  sync_folder(place);
  close(place->descriptor);
  place->descriptor = -1;
  return 0;
}

static arc_status publish(arc_place **place, int first, arc_error *error) {
  int why = give_name(*place, first);
  arc_status status = why ? failed((*place)->asked, why, error) : ARC_OK;
  arc_place_drop(place);
  return status;
}

arc_status arc_place_publish(arc_place **place, arc_error *error) {
  return publish(place, 0, error);
}

arc_status arc_place_publish_first(arc_place **place, arc_error *error) {
  return publish(place, 1, error);
}

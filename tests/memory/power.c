/* Records the file operations of a program in a folder for tests/trust/power.lua, which simulates
 * power cuts. The library is loaded with LD_PRELOAD; POWER_FOLDER is the folder, POWER_LOG the file
 * for the record.
 * An entry of the record consists of a letter and six numbers of 8 bytes (device, inode, offset,
 * length of the bytes, lengths of the first and the second path), then the bytes and paths.
 * Writes are recorded before they are done, synchronizations after. Writes inside stdio are not
 * visible, so the whole content of a file is recorded when the file is synchronized or renamed. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SYSTEM(result, name, ...)                                                                  \
  static result (*system_s)(__VA_ARGS__);                                                          \
  if (!system_s) *(void **)&system_s = dlsym(RTLD_NEXT, name)

/* --- the list --------------------------------------------------------------------------------- */

static void tell_all(char *record, size_t size) {
  SYSTEM(ssize_t, "write", int, const void *, size_t);
  const int saved = errno, log = open(getenv("POWER_LOG"), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (log < 0 || system_s(log, record, size) != (ssize_t)size) abort();
  close(log);
  errno = saved;
}

static void tell(char what, const struct stat *facts, long long offset, const void *bytes,
                 size_t count, const char *path, const char *other) {
  const size_t first = path ? strlen(path) : 0, second = other ? strlen(other) : 0;
  const long long head[] = {(long long)facts->st_dev, (long long)facts->st_ino, offset,
                            (long long)count,         (long long)first,         (long long)second};
  const size_t size = 1 + sizeof head + count + first + second;
  char *record = malloc(size), *at = record;
  if (!record) abort();
  *at++ = what;
  at = (char *)memcpy(at, head, sizeof head) + sizeof head;
  if (count > 0) at = (char *)memcpy(at, bytes, count) + count;
  if (first > 0) at = (char *)memcpy(at, path, first) + first;
  if (second > 0) memcpy(at, other, second);
  tell_all(record, size);
  free(record);
}

/* Returns the path relative to the folder, or NULL if the path is outside the folder. */
static const char *within(int folder, const char *path, char whole[PATH_MAX]) {
  const char *base = getenv("POWER_FOLDER");
  char stands[PATH_MAX] = "";
  if (!base || !path) return NULL;
  if (path[0] != '/' && folder == AT_FDCWD && !getcwd(stands, sizeof stands)) return NULL;
  if (path[0] != '/' && folder != AT_FDCWD) {
    char link[40];
    snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
    const ssize_t length = readlink(link, stands, sizeof stands - 1);
    if (length < 0) return NULL;
    stands[length] = '\0';
  }
  if (snprintf(whole, PATH_MAX, "%s%s%s", stands, stands[0] ? "/" : "", path) >= PATH_MAX) abort();
  const size_t length = strlen(base);
  return strncmp(whole, base, length) == 0 && whole[length] == '/' ? whole + length + 1 : NULL;
}

/* Returns the path of an open file relative to the folder, or "." for the folder itself. */
static const char *opened(int file, char whole[PATH_MAX]) {
  char link[40], target[PATH_MAX];
  const char *base = getenv("POWER_FOLDER");
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, target, sizeof target - 1);
  if (length < 0 || !base) return NULL;
  target[length] = '\0';
  if (strcmp(target, base) == 0) return ".";
  return within(AT_FDCWD, target, whole);
}

static void tell_content(int file) {
  char whole[PATH_MAX];
  struct stat facts;
  if (fstat(file, &facts) != 0 || !S_ISREG(facts.st_mode)) return;
  char *bytes = malloc((size_t)facts.st_size + 1);
  if (!bytes || pread(file, bytes, (size_t)facts.st_size, 0) != facts.st_size) abort();
  tell('C', &facts, 0, bytes, (size_t)facts.st_size, opened(file, whole), NULL);
  free(bytes);
}

static void tell_content_of(const char *path) {
  SYSTEM(int, "open", const char *, int, ...);
  const int file = system_s(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return;
  tell_content(file);
  close(file);
}

/* --- creation of files ------------------------------------------------------------------------ */

static void tell_opened(int file, const char *path, int flags, int was_there) {
  struct stat facts;
  if (file < 0 || fstat(file, &facts) != 0) return;
  if (!was_there) tell('N', &facts, 0, NULL, 0, path, NULL);
  if (was_there && flags & O_TRUNC) tell('T', &facts, 0, NULL, 0, path, NULL);
}

#define OPEN(name)                                                                                 \
  int name(const char *path, int flags, ...) {                                                     \
    SYSTEM(int, #name, const char *, int, ...);                                                    \
    char whole[PATH_MAX];                                                                          \
    struct stat facts;                                                                             \
    va_list rest;                                                                                  \
    va_start(rest, flags);                                                                         \
    const int mode = flags & O_CREAT ? va_arg(rest, int) : 0;                                      \
    va_end(rest);                                                                                  \
    const char *own = flags & (O_CREAT | O_TRUNC) ? within(AT_FDCWD, path, whole) : NULL;          \
    const int was_there = own && lstat(path, &facts) == 0, file = system_s(path, flags, mode);     \
    if (own) tell_opened(file, own, flags, was_there);                                             \
    return file;                                                                                   \
  }
OPEN(open)
OPEN(open64)

/* --- writes ----------------------------------------------------------------------------------- */

static void tell_write(int file, const void *bytes, size_t count, long long offset) {
  char whole[PATH_MAX];
  struct stat facts;
  const char *path = opened(file, whole);
  if (path && fstat(file, &facts) == 0 && S_ISREG(facts.st_mode))
    tell('W', &facts, offset, bytes, count, path, NULL);
}

ssize_t write(int file, const void *bytes, size_t count) {
  SYSTEM(ssize_t, "write", int, const void *, size_t);
  if (getenv("POWER_FOLDER")) tell_write(file, bytes, count, lseek(file, 0, SEEK_CUR));
  return system_s(file, bytes, count);
}

#define PWRITE(name, offset_type)                                                                  \
  ssize_t name(int file, const void *bytes, size_t count, offset_type offset) {                    \
    SYSTEM(ssize_t, #name, int, const void *, size_t, offset_type);                                \
    tell_write(file, bytes, count, offset);                                                        \
    return system_s(file, bytes, count, offset);                                                   \
  }
PWRITE(pwrite, off_t)
PWRITE(pwrite64, off64_t)

#define TRUNCATE(name, offset_type)                                                                \
  int name(int file, offset_type length) {                                                         \
    SYSTEM(int, #name, int, offset_type);                                                          \
    char whole[PATH_MAX];                                                                          \
    struct stat facts;                                                                             \
    const char *path = opened(file, whole);                                                        \
    if (path && fstat(file, &facts) == 0) tell('T', &facts, length, NULL, 0, path, NULL);          \
    return system_s(file, length);                                                                 \
  }
TRUNCATE(ftruncate, off_t)
TRUNCATE(ftruncate64, off64_t)

/* --- synchronization -------------------------------------------------------------------------- */

static void tell_synced(int file, char whole[PATH_MAX]) {
  struct stat facts;
  const char *path = opened(file, whole);
  if (!path || fstat(file, &facts) != 0) return;
  tell(S_ISDIR(facts.st_mode) ? 'D' : 'S', &facts, 0, NULL, 0, path, NULL);
}

#define SYNC(name)                                                                                 \
  int name(int file) {                                                                             \
    SYSTEM(int, #name, int);                                                                       \
    char whole[PATH_MAX];                                                                          \
    if (opened(file, whole)) tell_content(file);                                                   \
    const int result = system_s(file);                                                             \
    if (result == 0) tell_synced(file, whole);                                                     \
    return result;                                                                                 \
  }
SYNC(fsync)
SYNC(fdatasync)

/* --- names ------------------------------------------------------------------------------------ */

#define TWO_NAMES(name, letter)                                                                    \
  int name(const char *from, const char *to) {                                                     \
    SYSTEM(int, #name, const char *, const char *);                                                \
    char one[PATH_MAX], two[PATH_MAX];                                                             \
    struct stat facts = {0};                                                                       \
    const char *own = within(AT_FDCWD, from, one), *other = within(AT_FDCWD, to, two);             \
    if (own) tell_content_of(from);                                                                \
    const int result = system_s(from, to);                                                         \
    if (result == 0 && own && other) tell(letter, &facts, 0, NULL, 0, own, other);                 \
    return result;                                                                                 \
  }
TWO_NAMES(rename, 'R')
TWO_NAMES(link, 'L')

int unlink(const char *path) {
  SYSTEM(int, "unlink", const char *);
  char whole[PATH_MAX];
  struct stat facts = {0};
  const char *own = within(AT_FDCWD, path, whole);
  const int result = system_s(path);
  if (result == 0 && own) tell('U', &facts, 0, NULL, 0, own, NULL);
  return result;
}

int unlinkat(int folder, const char *path, int flags) {
  SYSTEM(int, "unlinkat", int, const char *, int);
  char whole[PATH_MAX];
  struct stat facts = {0};
  const char *own = within(folder, path, whole);
  const int result = system_s(folder, path, flags);
  if (result == 0 && own) tell('U', &facts, 0, NULL, 0, own, NULL);
  return result;
}

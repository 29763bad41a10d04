/* Computes the paths of files from the names that users write. */
#include "core/base/resolve.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Writes to `whole` the absolute path of a file's folder, followed by the last part of the file
 * name. Returns 0 or an errno. */
static int in_folder(const char *name, char whole[PATH_MAX]) {
  char folder[PATH_MAX];
  const char *slash = strrchr(name, '/'), *last = slash ? slash + 1 : name;
  snprintf(folder, sizeof folder, "%.*s", slash ? (int)(last - name) : 1, slash ? name : ".");
  if (!realpath(folder, whole)) return errno;
  const size_t length = whole[1] ? strlen(whole) : 0;
  if (length + 1 + strlen(last) >= PATH_MAX) return ENAMETOOLONG;
  whole[length] = '/';
  strcpy(whole + length + 1, last);
  return 0;
}

int arc_file_descriptor(const char *path) {
  char own[PATH_MAX], *end;
  const char *last = strrchr(path, '/');
  if (!last || !isdigit((unsigned char)last[1]) || !realpath("/proc/self", own)) return -1;
  const size_t length = strlen(own);
  const int inside = strncmp(path, own, length) == 0 && path[length] == '/';
  if (!inside || last - path < 3 || strncmp(last - 3, "/fd", 3) != 0) return -1;
  const long number = strtol(last + 1, &end, 10);
  return *end || number >= INT_MAX ? -1 : (int)number;
}

/* Computes the absolute path without symbolic links. The folder must exist, the file need not.
 * Returns 0 or an errno. */
static int resolve(const char *name, char *path) {
  char next[PATH_MAX], link[PATH_MAX];
  if (strlen(name) >= PATH_MAX) return ENAMETOOLONG;
  strcpy(next, name);
  for (int links = 0; links < 40; links++) {
    const int why = in_folder(next, path);
    if (why || arc_file_descriptor(path) >= 0) return why;
    const ssize_t length = readlink(path, link, sizeof link - 1);
    if (length < 0 && errno == EINVAL) return realpath(strcpy(next, path), path) ? 0 : errno;
    if (length < 0) return errno == ENOENT ? 0 : errno;
    link[length] = '\0';
    const int kept = link[0] == '/' ? 0 : (int)(strrchr(path, '/') + 1 - path);
    if (snprintf(next, sizeof next, "%.*s%s", kept, path, link) >= PATH_MAX) return ENAMETOOLONG;
  }
  return ELOOP;
}

/* --- for users -------------------------------------------------------------------------------- */

__attribute__((weak)) arc_status arc_file_allowed(const char *name, const char *path,
                                                  arc_file_use use, arc_error *error) {
  (void)name, (void)path, (void)use, (void)error;
  return ARC_OK;
}

arc_status arc_file_refused(const char *name, arc_file_use use, const char *why, arc_error *error) {
  return arc_fail(error, ARC_IO,
                  use == ARC_FILE_WRITE ? "cannot write '%.200s': %s" : "cannot read %.200s: %s",
                  name, why);
}

arc_status arc_file_failed(const char *name, arc_file_use use, int code, arc_error *error) {
  const int no_folder = use == ARC_FILE_WRITE && code == ENOENT;
  char why[160];
  snprintf(why, sizeof why, no_folder ? "its folder does not exist (%s)" : "%s", strerror(code));
  return arc_file_refused(name, use, why, error);
}

static int has_control(const char *path) {
  for (const char *c = path; *c; c++)
    if ((unsigned char)*c < 0x20 || *c == 0x7f) return 1;
  return 0;
}

arc_status arc_file_find(const char *name, arc_file_use use, char *path, arc_error *error) {
  const int strict = use == ARC_FILE_WRITE;
  if (!*name) return arc_fail(error, ARC_ARGUMENT, "the file name is empty");
  if (strict && has_control(name))
    return arc_fail(error, ARC_ARGUMENT, "the file name has a control character");
  const int why = resolve(name, path);
  if (why) return arc_file_failed(name, use, why, error);
  if (strict && has_control(path))
    return arc_file_refused(name, use, "a control character in its folder's name", error);
  return arc_file_allowed(name, path, use, error);
}

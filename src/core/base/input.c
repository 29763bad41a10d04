/* Opens and reads files. Only regular files are accepted: a pipe could block, and a device may have
 * no end. */
#include "core/base/resolve.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static arc_status refuse(const char *name, const char *why, arc_error *error) {
  return arc_file_refused(name, ARC_FILE_READ, why, error);
}

arc_status arc_file_open(const char *name, FILE **stream, arc_error *error) {
  char path[PATH_MAX];
  struct stat facts;
  *stream = NULL;
  const arc_status status = arc_file_find(name, ARC_FILE_READ, path, error);
  if (status != ARC_OK) return status;
  const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return refuse(name, strerror(errno), error);
  const int is_file = fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode);
  if (is_file) *stream = fdopen(descriptor, "rb");
  if (*stream) return ARC_OK;
  close(descriptor);
  return refuse(name, is_file ? "out of memory" : "not a file but a directory, pipe or device",
                error);
}

/* Reads a stream to its end into a buffer that grows by doubling. The caller frees *text, also on
 * failure. */
static arc_status read_all(const char *path, FILE *stream, char **text, size_t *length,
                           arc_error *error) {
  static const size_t largest = (size_t)1 << 30;
  size_t capacity = 1 << 16;
  char *more = malloc(capacity);
  for (*length = 0; more; more = realloc(*text, capacity *= 2)) {
    *text = more;
    *length += fread(*text + *length, 1, capacity - 1 - *length, stream);
    if (ferror(stream)) return refuse(path, strerror(errno), error);
    if (*length > largest)
      return arc_fail(error, ARC_FORMAT, "%s: expected at most 1 GiB, got more", path);
    (*text)[*length] = '\0';
    if (*length + 1 < capacity) return ARC_OK;
  }
  return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", path);
}

arc_status arc_file_read(const char *path, char **text, size_t *length, arc_error *error) {
  FILE *stream;
  *text = NULL;
  arc_status status = arc_file_open(path, &stream, error);
  if (status != ARC_OK) return status;
  status = read_all(path, stream, text, length, error);
  fclose(stream);
  if (status == ARC_OK) return ARC_OK;
  free(*text);
  *text = NULL;
  return status;
}

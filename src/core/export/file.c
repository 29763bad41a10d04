/* Complete files or none. */
#include "core/export/file.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static arc_status fail(const char *path, arc_error *error) {
  return arc_fail(error, ARC_IO, "cannot write %s: %s", path, strerror(errno));
}

static void forget(output_file *file) {
  free(file->path);
  free(file->temporary);
  *file = (output_file){0};
}

arc_number_text arc_number_to_text(double value) {
  arc_number_text result = {"nan"};
  for (int digits = 15; digits <= 17 && !isnan(value); digits++) {
    snprintf(result.text, sizeof result.text, "%.*g", digits, value == 0 ? 0.0 : value);
    if (strtod(result.text, NULL) == value) break;
  }
  return result;
}

arc_status arc_output_open(output_file *file, const char *path, arc_error *error) {
  static const char ending[] = ".part";
  const size_t length = strlen(path);
  *file = (output_file){.path = malloc(length + 1), .temporary = malloc(length + sizeof ending)};
  if (!file->path || !file->temporary) {
    forget(file);
    return arc_fail(error, ARC_MEMORY, "out of memory for writing %s", path);
  }
  memcpy(file->path, path, length + 1);
  memcpy(file->temporary, path, length);
  memcpy(file->temporary + length, ending, sizeof ending);
  file->stream = fopen(file->temporary, "w");
  if (file->stream) return ARC_OK;
  const arc_status status = fail(path, error);
  forget(file);
  return status;
}

arc_status arc_output_close(output_file *file, arc_error *error) {
  int bad = ferror(file->stream);
  if (fflush(file->stream) != 0) bad = 1;
  if (fclose(file->stream) != 0) bad = 1;
  if (!bad && rename(file->temporary, file->path) != 0) bad = 1;
  arc_status status = ARC_OK;
  if (bad) {
    status = fail(file->path, error);
    remove(file->temporary);
  }
  forget(file);
  return status;
}

arc_status arc_export_text(const char *path, const char *text, size_t length, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  fwrite(text, 1, length, file.stream);
  return arc_output_close(&file, error);
}

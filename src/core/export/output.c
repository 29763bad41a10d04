/* Output files that are written completely or not at all. */
#include "core/export/output.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

arc_number_text arc_number_to_text(double value) {
  arc_number_text result = {"nan"};
  for (int digits = 15; digits <= 17 && !isnan(value); digits++) {
    snprintf(result.text, sizeof result.text, "%.*g", digits, value == 0 ? 0.0 : value);
    if (strtod(result.text, NULL) == value) break;
  }
  return result;
}

static arc_status fail(const arc_atomic_file *temporary, arc_error *error) {
  return arc_fail(error, ARC_IO, "cannot write '%.200s': %s", arc_atomic_file_name(temporary),
                  strerror(errno));
}

arc_status arc_output_open(output_file *file, const char *path, arc_error *error) {
  *file = (output_file){0};
  arc_status status = arc_atomic_file_create(path, &file->temporary, error);
  if (status != ARC_OK) return status;
  file->stream = fopen(arc_atomic_file_path(file->temporary), "w");
  if (file->stream) return ARC_OK;
  status = fail(file->temporary, error);
  arc_atomic_file_discard(&file->temporary);
  return status;
}

arc_status arc_output_close(output_file *file, arc_error *error) {
  int bad = ferror(file->stream);
  if (fflush(file->stream) != 0) bad = 1;
  if (fclose(file->stream) != 0) bad = 1;
  if (!bad) return arc_atomic_file_publish(&file->temporary, error);
  const arc_status status = fail(file->temporary, error);
  arc_atomic_file_discard(&file->temporary);
  return status;
}

arc_status arc_export_text(const char *path, const char *text, size_t length, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  fwrite(text, 1, length, file.stream);
  return arc_output_close(&file, error);
}

/* Comma-separated columns. */
#include "core/export/file.h"

arc_status arc_export_csv(const char *path, size_t columns, const char *const names[],
                          const double *const data[], size_t rows, arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  for (size_t c = 0; c < columns; c++)
    fprintf(file.stream, "%s%s", names[c], c + 1 < columns ? "," : "\n");
  for (size_t r = 0; r < rows; r++)
    for (size_t c = 0; c < columns; c++)
      fprintf(file.stream, "%s%c", arc_number_to_text(data[c][r]).text,
              c + 1 < columns ? ',' : '\n');
  return arc_output_close(&file, error);
}

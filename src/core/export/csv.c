/* Comma-separated columns. */
#include "archard/export.h"
#include "core/export/file.h"

#include <math.h>

/* A value that is not a number has no sign, whatever the C library would print. */
static void write_value(FILE *out, double value) {
  if (isnan(value))
    fputs("nan", out);
  else
    fprintf(out, "%.17g", value);
}

arc_status arc_export_csv(const char *path, size_t columns, const char *const names[],
                          const double *const data[], size_t rows, arc_error *error) {
  output_file file;
  const arc_status status = output_open(&file, path, error);
  if (status != ARC_OK) return status;
  for (size_t c = 0; c < columns; c++)
    fprintf(file.stream, "%s%s", names[c], c + 1 < columns ? "," : "\n");
  for (size_t r = 0; r < rows; r++)
    for (size_t c = 0; c < columns; c++) {
      write_value(file.stream, data[c][r]);
      fputc(c + 1 < columns ? ',' : '\n', file.stream);
    }
  return output_close(&file, error);
}

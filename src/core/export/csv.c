/* Writes columns of numbers as comma-separated values (CSV). */
#include "core/export/output.h"

static void write_name(FILE *out, const char *name, const char *unit) {
  if (unit && unit[0])
    fprintf(out, "%s [%s]", name, unit);
  else
    fputs(name, out);
}

arc_status arc_export_csv(const char *path, size_t columns, const char *const names[],
                          const char *const units[], const double *const data[], size_t rows,
                          arc_error *error) {
  output_file file;
  const arc_status status = arc_output_open(&file, path, error);
  if (status != ARC_OK) return status;
  for (size_t c = 0; c < columns; c++) {
    write_name(file.stream, names[c], units ? units[c] : NULL);
    fputc(c + 1 < columns ? ',' : '\n', file.stream);
  }
  for (size_t r = 0; r < rows; r++)
    for (size_t c = 0; c < columns; c++)
      fprintf(file.stream, "%s%c", arc_number_to_text(data[c][r]).text,
              c + 1 < columns ? ',' : '\n');
  return arc_output_close(&file, error);
}

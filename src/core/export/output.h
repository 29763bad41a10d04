/* Output files that are renamed to their final names when they are complete. */
#ifndef EXPORT_OUTPUT_H
#define EXPORT_OUTPUT_H

#include "archard/export.h"
#include "archard/atomic_file.h"

#include <stdio.h>

typedef struct output_file {
  FILE *stream;
  arc_atomic_file *temporary;
} output_file;

/* Opens a temporary file for `path`. Errors: as for arc_atomic_file_create. */
arc_status arc_output_open(output_file *file, const char *path, arc_error *error);
/* Flushes and closes the file, and renames it to its final name. After a write error the file is
 * discarded, and the function returns ARC_IO. */
arc_status arc_output_close(output_file *file, arc_error *error);

#endif

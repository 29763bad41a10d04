/* A file that appears under its name only when it is complete. */
#ifndef EXPORT_FILE_H
#define EXPORT_FILE_H

#include "archard/export.h"

#include <stdio.h>

typedef struct output_file {
  FILE *stream;
  char *path, *temporary;
} output_file;

/* Opens a temporary file beside `path`. ARC_IO with the reason, ARC_MEMORY. */
arc_status arc_output_open(output_file *file, const char *path, arc_error *error);
/* Flushes, closes and renames; on any write error removes the temporary file and returns ARC_IO. */
arc_status arc_output_close(output_file *file, arc_error *error);

#endif

/* A file that appears under its name only when it is complete. */
#ifndef EXPORT_OUTPUT_H
#define EXPORT_OUTPUT_H

#include "archard/export.h"
#include "archard/place.h"

#include <stdio.h>

typedef struct output_file {
  FILE *stream;
  arc_place *place;
} output_file;

/* Opens a file in a place for `path`. Errors of arc_place_take. */
arc_status arc_output_open(output_file *file, const char *path, arc_error *error);
/* Flushes, closes and publishes; on any write error drops the place and returns ARC_IO. */
arc_status arc_output_close(output_file *file, arc_error *error);

#endif

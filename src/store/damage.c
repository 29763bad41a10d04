/* Writes error messages about damaged files. */
#include "store/store.h"

#include <stdarg.h>
#include <stdio.h>

arc_status arc_store_damaged(const arc_store *store, arc_error *error, int id, const char *format,
                             ...) {
  char what[400];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(what, sizeof what, format, arguments);
  va_end(arguments);
  return arc_fail(error, ARC_FORMAT, "%s: the file is damaged: case %d %s", store->path, id, what);
}

/* If the engine finds an error in the data of a stored case, reports that the file is damaged. An
 * error that can also occur with an intact file keeps its status. */
arc_status arc_store_refused(const arc_store *store, arc_error *error, int id,
                             const arc_error *why) {
  switch (why->status) {
  case ARC_ARGUMENT:
  case ARC_GEOMETRY:
  case ARC_NUMERIC:
    return arc_store_damaged(store, error, id, "has invalid data: %s", why->message);
  default:
    return arc_fail(error, why->status, "%s", why->message);
  }
}

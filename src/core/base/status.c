/* Status texts, error messages and warnings. */
#include "core/base/callbacks.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *arc_status_text(arc_status status) {
  switch (status) {
#define CASE(name, value, text)                                                                    \
  case ARC_##name:                                                                                 \
    return text;
    ARC_STATUS_LIST(CASE)
#undef CASE
  }
  return "unknown status";
}

const char *arc_status_name(arc_status status) {
  switch (status) {
#define CASE(name, value, text)                                                                    \
  case ARC_##name:                                                                                 \
    return #name;
    ARC_STATUS_LIST(CASE)
#undef CASE
  }
  return "UNKNOWN";
}

/* A NaN has no sign that means anything. */
static void unsign(char *text) {
  for (char *at = text; (at = strstr(at, "-nan")) != NULL;) memmove(at, at + 1, strlen(at));
}

arc_status arc_fail(arc_error *error, arc_status status, const char *format, ...) {
  if (error) {
    error->status = status;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
    unsign(error->message);
  }
  return status;
}

void arc_warn(const arc_callbacks *callbacks, const char *format, ...) {
  char text[512];
  if (!callbacks || !callbacks->warn) return;
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  callbacks->warn(callbacks->context, text);
}

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

/* Removes the minus sign of every "-nan" in a text. */
static void unsign(char *text) {
  for (char *at = text; (at = strstr(at, "-nan")) != NULL;) memmove(at, at + 1, strlen(at));
}

/* Returns true for characters that change the text direction (Unicode Bidi_Control) or end a
 * line. */
static int turns(const unsigned char *at) {
  const int last = at[0] == 0xe2 && at[1] ? at[2] : 0;
  if (at[0] == 0xd8) return at[1] == 0x9c;
  if (at[0] != 0xe2) return 0;
  if (at[1] == 0x81) return last >= 0xa6 && last <= 0xa9;
  return at[1] == 0x80 && (last == 0x8e || last == 0x8f || (last >= 0xa8 && last <= 0xae));
}

/* Returns the length [bytes] of the UTF-8 character at `at`, or 0 if it is invalid or not
 * displayable. */
static size_t showable(const unsigned char *at) {
  static const unsigned char lead[] = {0xc0, 0xe0, 0xf0, 0xf8};
  if (at[0] < 0x80) return (at[0] >= 0x20 && at[0] != 0x7f) || at[0] == '\n' || at[0] == '\t';
  for (size_t more = 1; more < 4; more++) {
    size_t i = 1;
    if (at[0] < lead[more - 1] || at[0] >= lead[more]) continue;
    while (i <= more && (at[i] & 0xc0) == 0x80) i++;
    const int control = (at[0] == 0xc2 && at[1] < 0xa0) || turns(at);
    return i > more && !control ? i : 0;
  }
  return 0;
}

void arc_show_text(const char *text, char *shown, size_t size) {
  const unsigned char *at = (const unsigned char *)text;
  size_t length = 0;
  while (*at) {
    char hex[8];
    const size_t count = showable(at), width = count ? count : 4;
    snprintf(hex, sizeof hex, "\\x%02x", *at);
    if (length + width >= size) break;
    memcpy(shown + length, count ? (const char *)at : hex, width);
    length += width;
    at += count ? count : 1;
  }
  shown[length] = '\0';
}

arc_status arc_fail(arc_error *error, arc_status status, const char *format, ...) {
  if (error) {
    error->status = status;
    va_list arguments;
    va_start(arguments, format);
    char message[sizeof error->message];
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    unsign(message);
    arc_show_text(message, error->message, sizeof error->message);
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

/* Checks the first and last bytes of a picture file. */
#include "plot/picture.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

typedef struct mark {
  const char *ending, *first, *last;
} mark;

static const mark marks[] = {
    {"png", "\x89PNG", "IEND\xae\x42\x60\x82"},
    {"svg", "<?xml", "</svg>"},
    {"pdf", "%PDF-", "%%EOF"},
    {"eps", "%!PS", "%%EOF"},
    {"gif", "GIF8", ";"},
};

static const mark *mark_of(const char *file) {
  const char *dot = strrchr(file, '.');
  for (size_t i = 0; dot && i < sizeof marks / sizeof *marks; i++)
    if (strcasecmp(dot + 1, marks[i].ending) == 0) return &marks[i];
  return NULL;
}

static int begins(FILE *stream, const char *first) {
  char bytes[8];
  size_t count = strlen(first);
  return fread(bytes, 1, count, stream) == count && memcmp(bytes, first, count) == 0;
}

/* Returns true if the file ends with the bytes `last`. Line breaks after these bytes are
 * ignored. */
static int ends(FILE *stream, const char *last) {
  char bytes[32];
  size_t count = strlen(last);
  if (fseek(stream, 0, SEEK_END) != 0) return 0;
  long size = ftell(stream), tail = size < (long)sizeof bytes ? size : (long)sizeof bytes;
  if (size < 0 || fseek(stream, -tail, SEEK_END) != 0) return 0;
  size_t got = fread(bytes, 1, (size_t)tail, stream);
  while (got > 0 && (bytes[got - 1] == '\n' || bytes[got - 1] == '\r')) got--;
  return got >= count && memcmp(bytes + got - count, last, count) == 0;
}

arc_status arc_picture_check(const char *path, const char *file, arc_error *error) {
  const mark *expected = mark_of(file);
  if (!expected) return ARC_OK;
  FILE *stream = fopen(path, "rb");
  if (!stream) return arc_fail(error, ARC_IO, "cannot write '%.200s': %s", file, strerror(errno));
  int whole = begins(stream, expected->first) && ends(stream, expected->last);
  fclose(stream);
  if (whole) return ARC_OK;
  return arc_fail(error, ARC_IO,
                  "cannot write '%.200s': gnuplot left an incomplete picture (is the disk full?)",
                  file);
}

/* Common parts of the fuzz targets. A target is one file with LLVMFuzzerTestOneInput. `make
 * fuzz` builds the targets with clang's libFuzzer; `make check` builds them with replay.c, which
 * runs them on the files in corpus/. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Prints a finding and aborts the program. */
#define FOUND(...) (fprintf(stderr, "found: " __VA_ARGS__), fputc('\n', stderr), abort())

/* Returns the path of a file that only this process uses. The file is in memory if the system has a
 * folder for such files. */
__attribute__((unused)) static const char *own_file(const char *ending) {
  static char path[4][80];
  static int turn;
  turn = (turn + 1) % 4;
  snprintf(path[turn], sizeof path[turn], "%s/archard-fuzz-%ld%s",
           access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp", (long)getpid(), ending);
  return path[turn];
}

__attribute__((unused)) static const char *as_file(const uint8_t *data, size_t size,
                                                   const char *ending) {
  const char *path = own_file(ending);
  FILE *file = fopen(path, "wb");
  if (!file || fwrite(data, 1, size, file) != size || fclose(file) != 0) abort();
  return path;
}

/* The bytes of an input, from which values are read. After the end of the input all values are
 * zero. */
typedef struct source {
  const uint8_t *data;
  size_t left;
} source;

__attribute__((unused)) static void take_bytes(source *s, void *to, size_t count) {
  const size_t got = s->left < count ? s->left : count;
  memset(to, 0, count);
  memcpy(to, s->data, got);
  s->data += got, s->left -= got;
}

__attribute__((unused)) static unsigned take_byte(source *s) {
  uint8_t byte;
  take_bytes(s, &byte, 1);
  return byte;
}

/* Returns a number in [low, high], computed from the next two bytes. */
__attribute__((unused)) static double take_in(source *s, double low, double high) {
  uint16_t bits;
  take_bytes(s, &bits, sizeof bits);
  return low + (high - low) * bits / 65535;
}

/* Returns any double, including NaN, infinity and denormal numbers. */
__attribute__((unused)) static double take_any(source *s) {
  double value;
  take_bytes(s, &value, sizeof value);
  return value;
}

#endif

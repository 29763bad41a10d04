/* Runs a fuzz target, with which it is linked instead of libFuzzer, on the files of a folder.
 * These are inputs that failed earlier and inputs that together execute all code of the target.
 * Usage: replay FOLDER; prints a TAP line for each file. */
#include <dirent.h>

#include "fuzz.h"

static uint8_t *bytes_of(const char *path, size_t *size) {
  FILE *file = fopen(path, "rb");
  struct stat facts;
  if (!file || fstat(fileno(file), &facts) != 0) return NULL;
  uint8_t *bytes = malloc((size_t)facts.st_size + 1);
  *size = bytes ? fread(bytes, 1, (size_t)facts.st_size, file) : 0;
  fclose(file);
  return bytes;
}

int main(int argc, char **argv) {
  struct dirent **entries = NULL;
  int tests = 0;
  const int count = argc == 2 ? scandir(argv[1], &entries, NULL, alphasort) : -1;
  if (count < 0) return fprintf(stderr, "usage: %s FOLDER\n", argv[0]), 2;
  for (int i = 0; i < count; i++) {
    char path[600];
    size_t size;
    snprintf(path, sizeof path, "%s/%s", argv[1], entries[i]->d_name);
    uint8_t *bytes = entries[i]->d_name[0] == '.' ? NULL : bytes_of(path, &size);
    if (bytes) {
      LLVMFuzzerTestOneInput(bytes, size);
      printf("ok %d - %s\n", ++tests, entries[i]->d_name);
    }
    free(bytes);
    free(entries[i]);
  }
  free(entries);
  printf("1..%d\n", tests);
  return 0;
}

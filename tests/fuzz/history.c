/* Fuzz target for history files of the prompt: whatever a file contains, later entries must be
 * readable. */
#include "fuzz.h"

#include "cli/history_file.h"

static void count_entry(void *context, const char *entry) {
  *(int *)context += entry[0] != '\0';
}

static void note_marker(void *context, const char *entry) {
  if (strcmp(entry, "the marker") == 0) *(int *)context = 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const char *path = as_file(data, size, ".history");
  int before = 0, found = 0;
  history_file_read(path, 1000, count_entry, &before);
  history_file_append(path, "the marker");
  history_file_read(path, 1000, note_marker, &found);
  if (!found) FOUND("an appended entry is missing");
  return 0;
}

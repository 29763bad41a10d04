/* Common parts of the export tests: a temporary folder, functions that read lines and numbers,
 * and a worn contact. */
#ifndef TESTS_EXPORT_SHARED_H
#define TESTS_EXPORT_SHARED_H

#include "check.h"

#include <dirent.h>

#include "archard/export.h"

static char folder[] = "/tmp/archard-export-XXXXXX";

UNUSED static const char *in_folder(const char *name) {
  static char path[300];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

UNUSED static int make_folder(void **state) {
  (void)state;
  return mkdtemp(folder) ? 0 : -1;
}

UNUSED static int remove_folder(void **state) {
  (void)state;
  char command[80];
  snprintf(command, sizeof command, "rm -rf %s", folder);
  return system(command);
}

UNUSED static int files_in_folder(void) {
  DIR *dir = opendir(folder);
  int count = 0;
  for (struct dirent *entry; (entry = readdir(dir));) count += entry->d_name[0] != '.';
  closedir(dir);
  return count;
}

/* find_line() reads lines up to the first one that starts with `start` and stores this line in
 * `line`. The test fails if the file contains no such line. */
UNUSED static char line[400];

UNUSED static void find_line(FILE *file, const char *start) {
  while (fgets(line, sizeof line, file))
    if (strncmp(line, start, strlen(start)) == 0) return;
  print_error("no line '%s'\n", start);
  fail();
}

UNUSED static arc_contact *solve_worn(arc_model *model) {
  arc_shape *shape = NULL;
  arc_contact *contact = NULL;
  check_ok(arc_shape_create(model, ARC_MOVING, 0, &shape, why));
  const int n = arc_model_mesh(model, ARC_PLATE)->surface;
  double *depth = calloc((size_t)n, sizeof *depth);
  for (int i = n / 3; i < n - n / 3; i++) depth[i] = 1e-4 / 3;
  check_ok(arc_shape_wear(shape, ARC_PLATE, depth, why));
  check_ok(
      arc_contact_solve(shape, &(arc_contact_def){.load = 100, .x = 0.1}, NULL, &contact, why));
  arc_shape_destroy(&shape);
  free(depth);
  return contact;
}

#endif

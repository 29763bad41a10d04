/* Computes the available memory on Linux. */
#include "core/base/memory.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* Returns the number after `key` in the first line that begins with `key`, or NaN if the file has
 * no such line. With an empty key, returns the first number in the file. */
static double number_in(const char *path, const char *key) {
  FILE *file = fopen(path, "r");
  char line[200];
  double value = NAN;
  if (!file) return value;
  while (isnan(value) && fgets(line, sizeof line, file))
    if (strncmp(line, key, strlen(key)) == 0 && sscanf(line + strlen(key), "%lf", &value) != 1)
      value = NAN;
  fclose(file);
  return value;
}

static double of_machine(void) {
  return 1024 * number_in("/proc/meminfo", "MemAvailable:");
}

static double of_group(void) {
  return number_in("/sys/fs/cgroup/memory.max", "") -
         number_in("/sys/fs/cgroup/memory.current", "");
}

static double of_limits(void) {
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) || limit.rlim_cur == RLIM_INFINITY) return INFINITY;
  return (double)limit.rlim_cur - number_in("/proc/self/statm", "") * (double)sysconf(_SC_PAGESIZE);
}

double arc_memory_free(void) {
  return fmin(fmin(INFINITY, of_machine()),
              fmin(of_group(), of_limits())); /* unknown values are NaN, which fmin ignores */
}

void arc_memory_release(const void *array) {
  free((void *)(uintptr_t)array);
}

/* Sets the memory limit of this process and its children. The size of the process is read from
 * /proc (Linux). */
#include "system/memory_limit.h"

#include <math.h>
#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

enum { MOST_CHILDREN = 512 };

static struct {
  double base; /* size of the data segment and the stack when the limit was set [bytes] */
  int limited, count;
  struct reservation {
    pid_t child;
    rlim_t bytes;
  } reservations[MOST_CHILDREN];
} state;

/* Returns the mapped memory of this process, and sets *data to the size of its data [bytes]. Both
 * are 0 if unknown. */
static double mapped(double *data) {
  double all = 0, private = 0;
  FILE *file = fopen("/proc/self/statm", "r");
  if (file && fscanf(file, "%lf %*s %*s %*s %*s %lf", &all, &private) != 2) all = private = 0;
  if (file) fclose(file);
  const double page = (double)sysconf(_SC_PAGESIZE);
  if (data) *data = private * page;
  return all * page;
}

/* Adds `bytes`, which may be negative, to the memory limit of this process. */
static void shift(double bytes) {
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = (rlim_t)((double)limit.rlim_cur + bytes);
  setrlimit(RLIMIT_AS, &limit);
}

void arc_memory_limit_set(double bytes) {
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  const double wanted = mapped(&state.base) + bytes, largest = 0x1p62;
  if (wanted < largest && (limit.rlim_cur == RLIM_INFINITY || (double)limit.rlim_cur > wanted))
    limit.rlim_cur = (rlim_t)wanted;
  state.limited = limit.rlim_cur != RLIM_INFINITY && setrlimit(RLIMIT_AS, &limit) == 0;
}

rlim_t arc_memory_limit_reserve(double part) {
  struct rlimit limit;
  if (!state.limited || state.count == MOST_CHILDREN || getrlimit(RLIMIT_AS, &limit) != 0) return 0;
  const double bytes = floor(part * fmax(0, (double)limit.rlim_cur - mapped(NULL)));
  shift(-bytes);
  return (rlim_t)bytes + 1;
}

void arc_memory_limit_assign(rlim_t bytes, pid_t child) {
  if (bytes == 0) return;
  if (child == 0)
    shift((double)(bytes - 1));
  else
    state.reservations[state.count++] = (struct reservation){child, bytes};
}

rlim_t arc_memory_limit_base(void) {
  return (rlim_t)state.base;
}

void arc_memory_limit_release(pid_t child) {
  for (int i = 0; i < state.count; i++)
    if (state.reservations[i].child == child) {
      shift((double)(state.reservations[i].bytes - 1));
      state.reservations[i] = state.reservations[--state.count];
      return;
    }
}

/* The limit of this process shrinks by what its children get. Leans on Linux for the size of a
 * process. */
#include "system/room.h"

#include <math.h>
#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

enum { MOST_CHILDREN = 512 };

static struct {
  double own; /* data of this process when the limit began: what a child needs before its script */
  int limited, count;
  struct loan {
    pid_t child;
    rlim_t bytes;
  } loans[MOST_CHILDREN];
} room;

/* Bytes of this process that are mapped, and those of them that are data; 0 where nothing says. */
static double mapped(double *data) {
  double all = 0, private = 0;
  FILE *file = fopen("/proc/self/statm", "r");
  if (file && fscanf(file, "%lf %*s %*s %*s %*s %lf", &all, &private) != 2) all = private = 0;
  if (file) fclose(file);
  const double page = (double)sysconf(_SC_PAGESIZE);
  if (data) *data = private * page;
  return all * page;
}

/* Changes the limit of this process by so many bytes. */
static void shift(double bytes) {
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = (rlim_t)((double)limit.rlim_cur + bytes);
  setrlimit(RLIMIT_AS, &limit);
}

void arc_room_limit(double bytes) {
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  const double wanted = mapped(&room.own) + bytes, largest = 0x1p62;
  if (wanted < largest && (limit.rlim_cur == RLIM_INFINITY || (double)limit.rlim_cur > wanted))
    limit.rlim_cur = (rlim_t)wanted;
  room.limited = limit.rlim_cur != RLIM_INFINITY && setrlimit(RLIMIT_AS, &limit) == 0;
}

rlim_t arc_room_take(double part) {
  struct rlimit limit;
  if (!room.limited || room.count == MOST_CHILDREN || getrlimit(RLIMIT_AS, &limit) != 0) return 0;
  const double bytes = floor(part * fmax(0, (double)limit.rlim_cur - mapped(NULL)));
  shift(-bytes);
  return (rlim_t)bytes + 1;
}

void arc_room_lend(rlim_t bytes, pid_t child) {
  if (bytes == 0) return;
  if (child == 0)
    shift((double)(bytes - 1));
  else
    room.loans[room.count++] = (struct loan){child, bytes};
}

rlim_t arc_room_own(void) {
  return (rlim_t)room.own;
}

void arc_room_return(pid_t child) {
  for (int i = 0; i < room.count; i++)
    if (room.loans[i].child == child) {
      shift((double)(room.loans[i].bytes - 1));
      room.loans[i] = room.loans[--room.count];
      return;
    }
}

/* Makes and reads the names of running programs. A name consists of two numbers, which identify the
 * computer and the process. */
#include "core/base/owner.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

/* Adds `count` bytes to the FNV-1a hash `sum` and returns the new hash. */
static unsigned long long add(unsigned long long sum, const void *bytes, size_t count) {
  const unsigned char *byte = bytes;
  for (size_t i = 0; i < count; i++) sum = (sum ^ byte[i]) * 1099511628211u;
  return sum;
}

/* Returns a number that identifies the computer, its last boot and the process namespace. This
 * program can check whether another process still runs only if both have the same number. */
static unsigned long long this_system(void) {
  struct utsname name = {0};
  struct stat processes = {0};
  char start[40] = "";
  const int file = open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC);
  if (file >= 0 && read(file, start, sizeof start) < 0) start[0] = '\0';
  if (file >= 0) close(file);
  uname(&name);
  stat("/proc/self/ns/pid", &processes);
  unsigned long long sum = add(14695981039346656037u, start, sizeof start);
  sum = add(sum, name.nodename, strlen(name.nodename));
  return add(sum, &processes.st_ino, sizeof processes.st_ino);
}

void arc_owner_name(char name[ARC_OWNER]) {
  snprintf(name, ARC_OWNER, "%016llx-%ld", this_system(), (long)getpid());
}

arc_owner_state arc_owner_look(const char *name) {
  unsigned long long system;
  long process;
  if (sscanf(name, "%16llx-%ld", &system, &process) != 2 || process <= 0 || system != this_system())
    return ARC_OWNER_ELSEWHERE;
  return kill((pid_t)process, 0) != 0 && errno == ESRCH ? ARC_OWNER_GONE : ARC_OWNER_LIVES;
}

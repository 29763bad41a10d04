/* Simulates a disk without locks for a program that loads this library (LD_PRELOAD). Every lock
 * request fails with the error number ARCHARD_LOCKS. If this variable is "hang", the request never
 * returns, as on a network disk whose server has no lock daemon. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

static int refuse(void) {
  const char *how = getenv("ARCHARD_LOCKS");
  if (!how) abort();
  while (strcmp(how, "hang") == 0) pause();
  errno = atoi(how);
  return -1;
}

int flock(int file, int how) {
  (void)file, (void)how;
  return refuse();
}

static int is_lock(int what) {
  return what == F_GETLK || what == F_SETLK || what == F_SETLKW || what == F_OFD_GETLK ||
         what == F_OFD_SETLK || what == F_OFD_SETLKW;
}

#define CONTROL(name)                                                                              \
  int name(int file, int what, ...) {                                                              \
    static int (*system_s)(int, int, ...);                                                         \
    va_list rest;                                                                                  \
    va_start(rest, what);                                                                          \
    void *argument = va_arg(rest, void *);                                                         \
    va_end(rest);                                                                                  \
    if (!system_s) *(void **)&system_s = dlsym(RTLD_NEXT, #name);                                  \
    return is_lock(what) ? refuse() : system_s(file, what, argument);                              \
  }

CONTROL(fcntl)
CONTROL(fcntl64)

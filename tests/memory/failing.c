/* Simulates exhausted memory and failing system calls in a program that loads this library
 * (LD_PRELOAD). The program sends commands by allocations of special sizes, which it never needs
 * otherwise and which fail:
 *   2^30 + 64 n bytes: after n more allocations, several in a row fail, because Lua tries again
 *     after a garbage collection.
 *   2^30 + 2^29 + 64 n bytes: after n more system calls, one fails.
 *   2^30 - 4096 bytes: ends both.
 * With n = 2^22 nothing fails, and the file ARCHARD_COUNT receives the number of possible failures
 * and for each call site the numbers of its first and last call. A call site is a chain of callers.
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <poll.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);

typedef enum kind { NOTHING, MEMORY, SYSTEM } kind;
static const size_t first_of[] = {((size_t)1 << 30) - 4096, (size_t)1 << 30, (size_t)3 << 29};
static const int in_a_row[] = {0, 8, 1};
enum { NONE = 1 << 22 };

static kind armed;
static long asked, first;
static __thread int inside;

/* --- call sites ------------------------------------------------------------------------------- */

typedef struct place {
  uint64_t callers; /* hash of the callers' addresses; 0: no call yet */
  long first, last;
} place;
enum { CALLERS = 12, PLACES = 1 << 16 };
static place places[PLACES];

static uint64_t hash_of_callers(void) {
  void *caller[CALLERS];
  const int count = backtrace(caller, CALLERS);
  uint64_t hash = 14695981039346656037u; /* Computes the FNV-1a hash of the addresses. */
  for (int k = 0; k < count; k++) hash = (hash ^ (uintptr_t)caller[k]) * 1099511628211u;
  return hash;
}

static void note(long n) {
  const uint64_t callers = hash_of_callers();
  size_t at = callers % PLACES;
  for (int tried = 0; places[at].callers && places[at].callers != callers; tried++) {
    if (tried == PLACES) abort();
    at = (at + 1) % PLACES;
  }
  if (!places[at].callers) places[at] = (place){callers, n, n};
  places[at].last = n;
}

static void tell(long count) {
  const char *path = getenv("ARCHARD_COUNT");
  FILE *file = path ? fopen(path, "w") : NULL;
  if (!file) abort();
  fprintf(file, "%ld\n", count);
  for (size_t k = 0; k < PLACES; k++) {
    if (places[k].callers) fprintf(file, "%ld\n%ld\n", places[k].first, places[k].last);
    places[k].callers = 0;
  }
  if (fclose(file) != 0) abort();
}

/* Calls `work` without counting its own allocations and system calls. */
static void unseen(void (*work)(long), long n) {
  inside = 1;
  work(n);
  inside = 0;
}

/* --- failures --------------------------------------------------------------------------------- */

static int fails(kind what) {
  if (inside || armed != what) return 0;
  const long n = asked++;
  if (first == NONE) unseen(note, n);
  return n >= first && n < first + in_a_row[what];
}

/* Returns true for a call by libgomp, which ends the program if an allocation of its threads
 * fails. */
static int ends_the_program(const void *caller) {
  Dl_info from;
  return dladdr(caller, &from) && strstr(from.dli_fname, "libgomp");
}

static int memory_fails(size_t size, const void *caller) {
  if (inside) return 0;
  if (size < first_of[NOTHING]) return fails(MEMORY) && !ends_the_program(caller);
  const kind wanted = size < first_of[MEMORY] ? NOTHING : size < first_of[SYSTEM] ? MEMORY : SYSTEM;
  if (wanted == NOTHING && armed != NOTHING && first == NONE) unseen(tell, asked);
  armed = wanted;
  first = (long)((size - first_of[wanted]) / 64);
  asked = 0;
  return 1;
}

static void *none(void) {
  errno = ENOMEM;
  return NULL;
}

void *malloc(size_t size) {
  return memory_fails(size, __builtin_return_address(0)) ? none() : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
  return memory_fails(count * size, __builtin_return_address(0)) ? none()
                                                                 : __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size) {
  return size > 0 && memory_fails(size, __builtin_return_address(0)) ? none()
                                                                     : __libc_realloc(memory, size);
}

/* Wraps a system call: on failure it returns `refusal` without effect, as if a network disk were
 * disconnected. */
#define CALL(type, name, refusal, parameters, ...)                                                 \
  type name parameters;                                                                            \
  type name parameters {                                                                           \
    static type(*system_s) parameters;                                                             \
    if (!system_s) *(void **)&system_s = dlsym(RTLD_NEXT, #name);                                  \
    if (!fails(SYSTEM)) return system_s(__VA_ARGS__);                                              \
    errno = ESTALE;                                                                                \
    return refusal;                                                                                \
  }

CALL(int, access, -1, (const char *path, int mode), path, mode)
CALL(int, fchmod, -1, (int file, mode_t mode), file, mode)
CALL(int, fdatasync, -1, (int file), file)
CALL(int, fflush, EOF, (FILE * file), file)
CALL(int, flock, -1, (int file, int how), file, how)
CALL(int, fsync, -1, (int file), file)
CALL(int, ftruncate64, -1, (int file, off64_t size), file, size)
CALL(int, link, -1, (const char *from, const char *to), from, to)
CALL(int, mkdir, -1, (const char *path, mode_t mode), path, mode)
CALL(int, pipe, -1, (int ends[2]), ends)
CALL(int, poll, -1, (struct pollfd * list, nfds_t count, int wait), list, count, wait)
CALL(int, rename, -1, (const char *from, const char *to), from, to)
CALL(int, socketpair, -1, (int domain, int type, int protocol, int ends[2]), domain, type, protocol,
     ends)
CALL(int, unlink, -1, (const char *path), path)
CALL(int, unlinkat, -1, (int folder, const char *path, int how), folder, path, how)
CALL(ssize_t, read, -1, (int file, void *to, size_t size), file, to, size)
CALL(ssize_t, write, -1, (int file, const void *from, size_t size), file, from, size)
CALL(ssize_t, pread64, -1, (int file, void *to, size_t size, off64_t at), file, to, size, at)
CALL(ssize_t, pwrite64, -1, (int file, const void *from, size_t size, off64_t at), file, from, size,
     at)
CALL(ssize_t, readlink, -1, (const char *path, char *to, size_t size), path, to, size)
CALL(ssize_t, send, -1, (int file, const void *from, size_t size, int how), file, from, size, how)
CALL(off_t, lseek, -1, (int file, off_t at, int from), file, at, from)
CALL(char *, realpath, NULL, (const char *path, char *to), path, to)
CALL(FILE *, fdopen, NULL, (int file, const char *mode), file, mode)
CALL(FILE *, fopen, NULL, (const char *path, const char *mode), path, mode)
CALL(DIR *, opendir, NULL, (const char *path), path)
CALL(int, stat, -1, (const char *path, struct stat *to), path, to)
CALL(int, lstat, -1, (const char *path, struct stat *to), path, to)
CALL(int, fstat, -1, (int file, struct stat *to), file, to)
CALL(int, stat64, -1, (const char *path, struct stat64 *to), path, to)
CALL(int, lstat64, -1, (const char *path, struct stat64 *to), path, to)
CALL(int, fstat64, -1, (int file, struct stat64 *to), file, to)

/* Wraps an open call; the mode argument exists only with O_CREAT. */
#define OPENING(name)                                                                              \
  int name(const char *path, int how, ...) {                                                       \
    static int (*system_s)(const char *, int, ...);                                                \
    va_list rest;                                                                                  \
    va_start(rest, how);                                                                           \
    const mode_t mode = how & O_CREAT ? va_arg(rest, mode_t) : 0;                                  \
    va_end(rest);                                                                                  \
    if (!system_s) *(void **)&system_s = dlsym(RTLD_NEXT, #name);                                  \
    if (!fails(SYSTEM)) return system_s(path, how, mode);                                          \
    errno = ESTALE;                                                                                \
    return -1;                                                                                     \
  }

OPENING(open)
OPENING(open64)

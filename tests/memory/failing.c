/* Memory that runs out on demand, for a program that it is loaded into (LD_PRELOAD). An attempt to
 * allocate 2^30 + 64 n bytes, which fails, makes those after the next n fail as well, a few in a
 * row, as Lua tries again once it has collected; 2^30 - 4096 bytes end that and write how many were
 * asked for in between to the file ARCHARD_COUNT. Nothing else here asks for so much.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);

static const size_t arm = (size_t)1 << 30, disarm = ((size_t)1 << 30) - 4096;
enum { IN_A_ROW = 8 };

static int armed;
static long asked, first;
static __thread int inside;

static void tell(void) {
  const char *path = getenv("ARCHARD_COUNT");
  char text[32];
  const int length = snprintf(text, sizeof text, "%ld", asked);
  const int file = path ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600) : -1;
  if (file < 0 || write(file, text, (size_t)length) != length) abort();
  close(file);
}

/* Whether this one fails. */
static int fails(size_t size) {
  if (inside) return 0;
  if (size < disarm) {
    if (!armed) return 0;
    const long n = asked++;
    return n >= first && n < first + IN_A_ROW;
  }
  inside = 1;
  if (size < arm && armed) tell();
  inside = 0;
  armed = size >= arm;
  first = armed ? (long)((size - arm) / 64) : 0;
  asked = 0;
  return 1;
}

static void *none(void) {
  errno = ENOMEM;
  return NULL;
}

void *malloc(size_t size) {
  return fails(size) ? none() : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
  return fails(count * size) ? none() : __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size) {
  return size > 0 && fails(size) ? none() : __libc_realloc(memory, size);
}

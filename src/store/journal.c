/* Checks the journal beside a run file. A journal that ends with a file name and SQLite's magic
 * number belongs to a change of several files. SQLite would apply this journal and then delete
 * the named file. Archard changes only one file at a time and never writes such a journal. */
#include "store/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Sizes [bytes] of the fields at the end of a journal that names another file: length of the
 * name, checksum of the name, magic number. */
enum { LENGTH = 4, SUM = 4, MAGIC = 8, TAIL = LENGTH + SUM + MAGIC };

static int names_a_file(int journal, off_t size) {
  static const unsigned char magic[MAGIC] = {0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7};
  unsigned char tail[TAIL];
  if (size < TAIL || pread(journal, tail, TAIL, size - TAIL) != TAIL) return 0;
  return memcmp(tail + LENGTH + SUM, magic, MAGIC) == 0 && memcmp(tail, "\0\0\0", LENGTH) != 0;
}

/* Returns true if the journal is safe. A journal that cannot be opened is safe, because SQLite
 * cannot open it either. A link is not safe. */
int arc_journal_is_sound(const char *journal) {
  const int file = open(journal, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  struct stat facts;
  if (file < 0) return errno != ELOOP;
  const int sound =
      fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && !names_a_file(file, facts.st_size);
  close(file);
  return sound;
}

int arc_journal_stands(const char *path) {
  char name[PATH_MAX + sizeof "-journal"];
  struct stat facts;
  snprintf(name, sizeof name, "%s-journal", path);
  return lstat(name, &facts) == 0;
}

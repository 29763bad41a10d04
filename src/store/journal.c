/* Checks the journal beside a run file, which SQLite would apply to the file. A journal that ends
 * with a file name and SQLite's magic number belongs to a change of several files; SQLite would
 * then delete the named file. Archard changes only one file at a time and never writes such a
 * journal. A journal that would enlarge the file by more than the journal contains is not its own
 * either, nor is one of a user who may not write the file. */
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

/* Positions [bytes] in the first record of a journal: magic number, number of pages of the file
 * before the change, size of a page. */
enum { PAGES = 16, PAGE = 24, HEADER = 28 };

long long arc_big_endian(const unsigned char *bytes) {
  return (long long)bytes[0] << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
}

/* Returns true if a journal can be one of the file: its owner may write the file, and the journal
 * is large enough to contain all pages by which the file was longer before the change. A journal
 * without a complete header changes nothing. */
static int fits(int journal, const struct stat *its, const char *name) {
  unsigned char header[HEADER];
  char path[PATH_MAX];
  struct stat file;
  const size_t length = strlen(name) - strlen("-journal");
  if (strlen(name) <= strlen("-journal") || length >= sizeof path) return 0;
  memcpy(path, name, length);
  path[length] = '\0';
  if (stat(path, &file) != 0) return 1;
  if (its->st_uid != file.st_uid && its->st_uid != 0 && !(file.st_mode & (S_IWGRP | S_IWOTH)))
    return 0;
  if (pread(journal, header, HEADER, 0) != HEADER) return 1;
  const double before =
      (double)arc_big_endian(header + PAGES) * (double)arc_big_endian(header + PAGE);
  return before <= (double)file.st_size + (double)its->st_size;
}

/* Returns true if the journal is safe. A journal that cannot be opened is safe, because SQLite
 * cannot open it either. A link is not safe. */
int arc_journal_is_sound(const char *journal) {
  const int file = open(journal, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  struct stat facts;
  if (file < 0) return errno != ELOOP;
  const int sound = fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) &&
                    !names_a_file(file, facts.st_size) && fits(file, &facts, journal);
  close(file);
  return sound;
}

int arc_journal_stands(const char *path) {
  char name[PATH_MAX + sizeof "-journal"];
  struct stat facts;
  snprintf(name, sizeof name, "%s-journal", path);
  return lstat(name, &facts) == 0;
}

/* Checks the rollback journal beside a run file. SQLite replays the journal when it opens the file.
 */
#ifndef STORE_JOURNAL_H
#define STORE_JOURNAL_H

/* Returns the number in four bytes of a file of SQLite, whose first byte is the highest. */
long long arc_big_endian(const unsigned char *bytes);

/* Returns true if SQLite may open this journal. The journal must be missing, or be a regular
 * file that does not name another file, which SQLite would delete, belongs to a user who may write
 * the run file, and contains all pages by which it would enlarge the run file. */
int arc_journal_is_sound(const char *journal);

/* Returns true if the file has a journal. The path must not contain symbolic links. */
int arc_journal_stands(const char *path);

#endif

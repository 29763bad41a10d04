/* Checks the rollback journal beside a run file. SQLite replays the journal when it opens the file.
 */
#ifndef STORE_JOURNAL_H
#define STORE_JOURNAL_H

/* Returns true if SQLite may open this journal. The journal must be missing, or be a regular
 * file that does not name another file, which SQLite would delete. */
int arc_journal_is_sound(const char *journal);

/* Returns true if the file has a journal. The path must not contain symbolic links. */
int arc_journal_stands(const char *path);

#endif

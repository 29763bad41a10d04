/* Checks the rollback journal beside a run file. SQLite replays the journal when it opens the file.
 */
#ifndef STORE_JOURNAL_H
#define STORE_JOURNAL_H

/* Returns true if SQLite may open this journal. The journal must be missing, or a regular file
 * without the name of another file, which SQLite would delete. */
int arc_journal_is_sound(const char *journal);

/* Returns true if the file has a journal. The path must not contain links. */
int arc_journal_stands(const char *path);

#endif

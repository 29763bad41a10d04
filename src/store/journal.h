/* The rollback journal beside a run file, which SQLite plays into the file as it opens it. */
#ifndef STORE_JOURNAL_H
#define STORE_JOURNAL_H

/* True if SQLite may open this journal: it is missing, or a regular file that names no other file,
 * which SQLite would delete. */
int arc_journal_is_sound(const char *journal);

/* True if the file at a path without links has a journal. */
int arc_journal_stands(const char *path);

#endif

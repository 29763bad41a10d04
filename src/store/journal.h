/* The rollback journal beside a run file, which SQLite plays into the file as it opens it. */
#ifndef STORE_JOURNAL_H
#define STORE_JOURNAL_H

/* Whether SQLite may open what stands at the path of a journal: nothing, or a plain file that names
 * no other. A journal that names a file would have SQLite delete it. */
int arc_journal_is_sound(const char *journal);

/* Whether a journal stands beside the file, or beside what a link of that name leads to. */
int arc_journal_stands(const char *path);

#endif

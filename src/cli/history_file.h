/* cli/history_file.h - the history of the prompt on disk.
 *
 * $XDG_STATE_HOME/archard/history, with ~/.local/state for the unset variable. The folder is the
 * user's alone, as is the file. An entry is a line "#TIME" followed by its lines, so that an entry
 * of several lines comes back as one. Entries are appended as they are made: several sessions may
 * write, and a killed one loses nothing. */
#ifndef CLI_HISTORY_FILE_H
#define CLI_HISTORY_FILE_H

typedef void (*history_entry_fn)(void *context, const char *entry);

/* Makes the folder and returns the file's path, from malloc; NULL where that is not possible. */
char *history_file_open(void);

void history_file_append(const char *path, const char *entry);

/* Calls `found` (may be NULL) for every entry, oldest first: each text once, at its latest place,
 * and no more than the last `limit`. A file that holds more than those is rewritten. */
void history_file_read(const char *path, int limit, history_entry_fn found, void *context);

#endif

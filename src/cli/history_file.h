/* cli/history_file.h - the history of the prompt on disk.
 *
 * $XDG_STATE_HOME/archard/history, with ~/.local/state if the variable is not set. Folder and file
 * are private to the user. An entry is a line "#TIME" followed by its lines. Entries are appended
 * at once: several sessions may write, and a killed one loses nothing. */
#ifndef CLI_HISTORY_FILE_H
#define CLI_HISTORY_FILE_H

typedef void (*history_entry_fn)(void *context, const char *entry);

/* Creates the folder and returns the path of the file, from malloc; NULL on failure. */
char *history_file_open(void);

void history_file_append(const char *path, const char *entry);

/* Calls `found` (may be NULL) for every entry, oldest first: each text once, at its latest
 * position, at most the last `limit`. A file with more entries is rewritten. */
void history_file_read(const char *path, int limit, history_entry_fn found, void *context);

#endif

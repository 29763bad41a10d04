/* cli/history_file.h - the history of the prompt in a file.
 *
 * The file is $XDG_STATE_HOME/archard/history; if the variable is not set, ~/.local/state
 * replaces $XDG_STATE_HOME. Only the user can read the folder and the file. An entry is a line
 * "#TIME" followed by the lines of its text. An entry is appended immediately, so that several
 * sessions may write and a killed session loses nothing. */
#ifndef CLI_HISTORY_FILE_H
#define CLI_HISTORY_FILE_H

typedef void (*history_entry_fn)(void *context, const char *entry);

/* Creates the folder and returns the path of the file, which the caller frees. Returns NULL on
 * failure. */
char *history_file_open(void);

void history_file_append(const char *path, const char *entry);

/* Calls `found` (may be NULL) for each of the last `limit` entries, oldest first. A repeated text
 * is reported once, at its latest position. All other entries are removed from the file. */
void history_file_read(const char *path, int limit, history_entry_fn found, void *context);

#endif

/* cli/edit.h - the line editor of the prompt, with history, completion, Ctrl-C, Ctrl-D and
 * Ctrl-Z.
 *
 * There is only one terminal and therefore one editor, whose state is in static variables. */
#ifndef CLI_EDIT_H
#define CLI_EDIT_H

#include <stddef.h>

typedef enum edit_result { EDIT_LINE, EDIT_INTERRUPTED, EDIT_END } edit_result;

/* Possible completions of the text before the cursor. */
typedef struct edit_proposal {
  char **words; /* `count` strings; malloc allocates the array and the strings, the editor frees
                   them */
  size_t count;
  int files;   /* true: file names are completed instead of words */
  char append; /* character appended if there is only one completion; '\0' for none */
} edit_proposal;

/* Function that adds completions to `proposal`, which is initially empty. Each word completes the
 * identifier or string at the end of the text before the cursor. */
typedef void (*edit_complete_fn)(void *context, const char *before, edit_proposal *proposal);

/* Initialises the editor and reads the history file. */
void edit_start(edit_complete_fn complete, void *context);

/* Removes duplicates from the history file. The latest copy of each entry remains. */
void edit_finish(void);

/* Reads one line without its newline. Pasted text may contain newlines. After EDIT_LINE the caller
 * frees *line. */
edit_result edit_read(const char *prompt, char **line);

/* Adds an entry of one or several lines to the history and its file. */
void edit_remember(const char *entry);

#endif

/* cli/edit.h - the line editor: editing, history, completion, Ctrl-C, Ctrl-D, Ctrl-Z.
 *
 * There is one terminal, so there is one editor; its state is file scope. */
#ifndef CLI_EDIT_H
#define CLI_EDIT_H

#include <stddef.h>

typedef enum edit_result { EDIT_LINE, EDIT_INTERRUPTED, EDIT_END } edit_result;

/* Completions of the text before the cursor. */
typedef struct edit_proposal {
  char **words; /* `count` strings, each from malloc, as is the array; the editor frees them */
  size_t count;
  int files;   /* non-zero: names of files instead of words */
  char append; /* appended to a single completion; '\0' for none */
} edit_proposal;

/* Fills `proposal` (all zero before) for the text before the cursor. The words complete the
 * identifier, or the string, that this text ends in. */
typedef void (*edit_complete_fn)(void *context, const char *before, edit_proposal *proposal);

/* Initialises the editor and reads the history file. */
void edit_start(edit_complete_fn complete, void *context);

/* Removes copies from the history file: every entry once, the latest last. */
void edit_finish(void);

/* Reads one line, without its newline; pasted text may contain newlines. With EDIT_LINE, the caller
 * frees *line. */
edit_result edit_read(const char *prompt, char **line);

/* Adds an entry of one or several lines to the history and its file. */
void edit_remember(const char *entry);

#endif

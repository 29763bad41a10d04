/* A text that grows, and the quoting of user texts for gnuplot commands. */
#ifndef PLOT_TEXT_H
#define PLOT_TEXT_H

#include <stddef.h>

/* A text that grows. It must be initialised with zeros. If memory is exhausted, `failed` is set,
 * and later additions have no effect. */
typedef struct arc_text {
  char *data; /* the text, terminated by a zero byte; NULL if empty */
  size_t length, capacity;
  int failed;
} arc_text;

/* --- text.c ----------------------------------------------------------------------------------- */

void arc_text_add(arc_text *text, const char *bytes, size_t count);
void arc_text_word(arc_text *text, const char *word);
void arc_text_format(arc_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a text quoted as by arc_plot_quote (archard/plot.h). */
void arc_text_quoted(arc_text *text, const char *words, int ascii);

/* Appends a quoted absolute path with its bytes unchanged, because file names may not be UTF-8. */
void arc_text_path(arc_text *text, const char *path);

/* Returns the number of characters (not bytes) of a UTF-8 text. For NULL returns 0. */
size_t arc_text_characters(const char *words);

/* Returns the number of bytes in the first line of a text that is wrapped at `columns` characters.
 * A line ends at a blank, preferably one after a comma, colon or semicolon. */
size_t arc_text_line(const char *words, double columns);

void arc_text_free(arc_text *text);

/* --- marks.c ---------------------------------------------------------------------------------- */

/* Returns true if a text has subscripts, superscripts or powers of ten. */
int arc_text_marked(const char *words);

/* Appends a text in which names such as \alpha are replaced by Greek letters. */
void arc_text_greek(arc_text *text, const char *words);

/* Appends a text in the syntax of gnuplot's enhanced text, without quotes. Subscripts and
 * superscripts (archard/plot.h) are converted. Other special characters are escaped. */
void arc_text_enhanced(arc_text *text, const char *words);

#endif

/* Text of a Gmsh file, which is read line by line and number by number. */
#ifndef MESH_GMSH_TEXT_H
#define MESH_GMSH_TEXT_H

#include "archard/base.h"

typedef struct msh_text {
  const char *path; /* name of the file in messages */
  char *data, *end; /* the whole file, zero-terminated */
  char *next;       /* start of the next line */
  char *at;         /* unread rest of the current line */
  long line;        /* number of the current line, counted from 1 */
} msh_text;

/* Reads the whole file into memory. Errors: ARC_IO, ARC_MEMORY, ARC_FORMAT (the file is too
 * large). */
arc_status arc_msh_open(msh_text *text, const char *path, arc_error *error);
/* Copies a text from memory. Messages contain `name` instead of a file name. Errors: ARC_MEMORY. */
arc_status arc_msh_copy(msh_text *text, const char *name, const char *from, size_t length,
                        arc_error *error);
void arc_msh_close(msh_text *text);

/* Moves to the next line that is not blank. Returns 0 at the end of the text. */
int arc_msh_line(msh_text *text);
/* Reads a finite number, which white space or the end of the line must follow. Returns 0 if
 * there is no such number. */
int arc_msh_real(msh_text *text, double *value);
int arc_msh_whole(msh_text *text, long long *value);

/* Sets an error with the file, the line and the formatted reason. Returns ARC_FORMAT. */
arc_status arc_msh_fail(const msh_text *text, arc_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Returns the first characters of a text in printable form, for a message. */
typedef struct msh_shown {
  char text[32];
} msh_shown;
msh_shown arc_msh_show(const char *text);

#endif

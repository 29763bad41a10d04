/* The text of a Gmsh file: lines and numbers. */
#ifndef MESH_GMSH_TEXT_H
#define MESH_GMSH_TEXT_H

#include "archard/base.h"

typedef struct msh_text {
  const char *path; /* what messages call it */
  char *data, *end; /* the whole file, and a zero behind it */
  char *next;       /* the line that follows */
  char *at;         /* what is left of the present line, without its end */
  long line;        /* its number, from 1 */
} msh_text;

/* Reads the whole file. ARC_IO, ARC_MEMORY, ARC_FORMAT (too large). */
arc_status arc_msh_open(msh_text *text, const char *path, arc_error *error);
/* Takes a copy of a text that is no file, under a name. ARC_MEMORY. */
arc_status arc_msh_copy(msh_text *text, const char *name, const char *from, size_t length,
                        arc_error *error);
void arc_msh_close(msh_text *text);

/* Goes to the next line that is not blank; 0: there is none. */
int arc_msh_line(msh_text *text);
/* Takes a number from the line: finite, with white space or the line's end behind it; else 0. */
int arc_msh_real(msh_text *text, double *value);
int arc_msh_whole(msh_text *text, long long *value);

/* ARC_FORMAT: file and line, and what is wrong there. */
arc_status arc_msh_fail(const msh_text *text, arc_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* What a message shows of a text: its beginning, printable. */
typedef struct msh_shown {
  char text[32];
} msh_shown;
msh_shown arc_msh_show(const char *text);

#endif

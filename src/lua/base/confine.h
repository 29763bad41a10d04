/* lua/confine.h - the folders and the disk space to which this program is confined (sandbox). */
#ifndef LUA_CONFINE_H
#define LUA_CONFINE_H

#include "archard/base.h"

/* Confines reading to the folders `read` and `write`, and writing to `write`. Symbolic links are
 * resolved before the check. Call once, before threads start. Error: ARC_IO if a folder does not
 * exist. */
arc_status confine_files(const char *read, const char *write, arc_error *error);

/* The folder of readable files, or NULL if not confined. */
const char *confine_folder(void);

/* Free bytes of the disk of the folder `write`; 0 if unknown. */
double confine_free(void);

/* From now on no file is written while the disk has fewer free bytes. */
void confine_disk(double least);
/* This number; 0: none. */
double confine_least(void);

#endif

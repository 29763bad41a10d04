/* lua/base/confine.h - the folders and the disk space to which the sandbox restricts this
 * program. */
#ifndef LUA_CONFINE_H
#define LUA_CONFINE_H

#include "archard/base.h"

/* Restricts reading to the folders `read` and `write`, and writing to `write`. Symbolic links
 * are resolved before the check. Must be called only once, before threads start. Errors: ARC_IO
 * if a folder does not exist. */
arc_status confine_files(const char *read, const char *write, arc_error *error);

/* Returns the folder to which reading is restricted, or NULL if there is no restriction. */
const char *confine_folder(void);

/* Returns the number of free bytes on the disk of the folder `write`; 0 if unknown. */
double confine_free(void);

/* Prevents writing of files while the disk has fewer than `least` free bytes. */
void confine_disk(double least);
/* Returns the number of bytes that must stay free on the disk; 0: no limit. */
double confine_least(void);

#endif

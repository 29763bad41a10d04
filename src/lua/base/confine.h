/* lua/base/confine.h - the folders and the disk space to which the sandbox restricts this
 * program. */
#ifndef LUA_CONFINE_H
#define LUA_CONFINE_H

#include "archard/base.h"

/* Restricts reading to files in the folders `read` and `write`, and writing to files in `write`.
 * Symbolic links are resolved before the check. Must be called only once, before threads start.
 * Errors: ARC_IO if a folder does not exist. */
arc_status confine_files(const char *read, const char *write, arc_error *error);

/* Returns the folder `read` of confine_files, or NULL if file access is not restricted. */
const char *confine_folder(void);

/* Returns the free space on the disk of the folder `write` [bytes]; 0 if unknown. */
double confine_free(void);

/* Refuses writing of files while the disk has fewer than `least` free bytes. */
void confine_disk(double least);
/* Returns the free space that must remain on the disk [bytes]; 0: no limit. */
double confine_least(void);

#endif

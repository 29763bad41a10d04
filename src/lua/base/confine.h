/* lua/confine.h - the folders to which file access of this program is confined (sandbox). */
#ifndef LUA_CONFINE_H
#define LUA_CONFINE_H

#include "archard/base.h"

/* Confines reading to the folders `read` and `write`, and writing to `write`. Symbolic links are
 * resolved before the check. Call once, before threads start. Error: ARC_IO if a folder does not
 * exist. */
arc_status confine_files(const char *read, const char *write, arc_error *error);

/* The folder of readable files, or NULL if not confined. */
const char *confine_folder(void);

#endif

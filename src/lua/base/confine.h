/* lua/confine.h - the folders that the files of this program are confined to. */
#ifndef LUA_CONFINE_H
#define LUA_CONFINE_H

#include "archard/base.h"

/* From here on files are read below `read` and `write` alone and written below `write` alone: what
 * a name means counts, behind its links, whatever it was made of. Once, before threads. ARC_IO: no
 * such folder. */
arc_status confine_files(const char *read, const char *write, arc_error *error);

/* The folder that reading is confined to, or NULL. */
const char *confine_folder(void);

#endif

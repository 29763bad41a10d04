/* Declares functions for names of open descriptors and for error messages about files. */
#ifndef CORE_BASE_RESOLVE_H
#define CORE_BASE_RESOLVE_H

#include "archard/base.h"

/* Returns the descriptor N if a path has the form "/proc/PID/fd/N" with the PID of this process; -1
 * for other paths. */
int arc_file_descriptor(const char *path);

/* Returns ARC_IO and writes the message "cannot read NAME: WHY" or "cannot write 'NAME': WHY". */
arc_status arc_file_refused(const char *name, arc_file_use use, const char *why, arc_error *error);
/* The same for the reason of an errno. */
arc_status arc_file_failed(const char *name, arc_file_use use, int code, arc_error *error);

#endif
